"""A folder with installed packages and specs, in which the command line runs."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import fieldspec
from fieldspec.command.packages.codec_loading import judged_codec
from fieldspec.command.packages.plugins import CODECS, Plugin
from fieldspec.language.model.codecs import InstalledCodec

HERE = Path(__file__).resolve().parent
EXAMPLE = HERE / "example_package"
DEVICE = """
device:
  id: pump
  name: Pump
  vendor: Acme
  manual: {title: Manual, file: pump.txt, sha256: "%s", lines: 99}
uses:
  - {protocol: acme_bus}
enums:
  - {name: acme_state, source: 1 L1}
registers:
  - group: motion
    section: "2"
    defaults: {type: u16, checked: {words: 1}}
    rows:
      - {at: 0x2000, name: state, enum: acme_state, access: ro, source: L2}
      - {at: 0x2001, name: speed, access: rw, range: 1..100, source: L3}
""" % ("0" * 64)


class RunResult(NamedTuple):
    """What a run has left."""

    code: int
    out: str
    err: str


class Site:
    """A folder with installed packages, specs beside it, and a cache of its own."""

    def __init__(self, folder: Path, packages: Path) -> None:
        self.folder, self.packages = folder, packages

    @property
    def python_path(self) -> str:
        """Where processes find the packages, and the compiler under test, which may be a copy."""
        return os.pathsep.join((str(self.packages), str(Path(fieldspec.__file__).resolve().parent.parent)))

    def write(self, path: str, text: str) -> Path:
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8", newline="\n")
        return file

    def run(self, *arguments: str) -> RunResult:
        environment = {
            **os.environ,
            "PYTHONPATH": self.python_path,
            "FIELDSPEC_CACHE": str(self.folder / "cache"),
            "PYTHONDONTWRITEBYTECODE": "1",
            "COLUMNS": "500",
        }
        command = [sys.executable, "-m", "fieldspec", *arguments]
        ran = subprocess.run(command, cwd=self.folder, env=environment, capture_output=True, encoding="utf-8")
        return RunResult(ran.returncode, ran.stdout, ran.stderr)

    def manifest(self) -> dict[str, dict[str, str]]:
        data: dict[str, dict[str, str]] = json.loads((self.folder / "generated/manifest.json").read_text("utf-8"))
        return data


def example_codecs() -> dict[str, InstalledCodec]:
    """The codecs of the example package, as though it were installed."""
    sys.path.append(str(EXAMPLE / "src"))
    names = {"acme_float": "FLOAT", "acme_gray": "GRAY", "acme_rolling": "ROLLING"}
    return {
        name: judged_codec(Plugin(CODECS, name, f"acme_fieldspec.codecs:{attribute}", "acme-fieldspec", "1.0"))
        for name, attribute in names.items()
    }


def declare(folder: Path, package: str, group: str, name: str, value: str, code: str = "") -> None:
    """Installs a package by hand: what pip leaves of it."""
    info = folder / f"{package}-1.0.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {package}\nVersion: 1.0\n", encoding="utf-8")
    (info / "entry_points.txt").write_text(f"[fieldspec.{group}]\n{name} = {value}\n", encoding="utf-8")
    (folder / "bad.py").write_text(code, encoding="utf-8")
