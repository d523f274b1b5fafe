"""The wheel and the sdist: the same bytes from any checkout, nothing that is not needed, and a wheel that works."""

from __future__ import annotations

import importlib.metadata
import os
import shutil
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PARTS = ("codegen", "specs", "generated/python", "pyproject.toml", "README.md", "LICENSE", ".gitignore")
FREE = ("MIT", "BSD", "Apache", "PSF", "Python Software Foundation", "MPL-2.0")
"""Terms for licences under which a program of any licence may use an unmodified library."""


def packed(folder: Path, mask: int, zone: str, stamp: int) -> dict[str, bytes]:
    """The distributions of a copy of the project, by name."""
    copy = folder / "copy"
    for part in PARTS:
        (copy / part).parent.mkdir(parents=True, exist_ok=True)
        if (ROOT / part).is_dir():
            shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copyfile(ROOT / part, copy / part)
    for path in copy.rglob("*"):
        os.utime(path, (stamp, stamp))
    environment = {name: value for name, value in os.environ.items() if name != "SOURCE_DATE_EPOCH"}
    command = [sys.executable, "-m", "hatchling", "build", "-d", str(folder / "dist")]
    subprocess.run(command, cwd=copy, env={**environment, "TZ": zone}, umask=mask, check=True, capture_output=True)
    return {path.name: path.read_bytes() for path in sorted((folder / "dist").iterdir())}


@pytest.fixture(scope="module")
def distributions(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    return packed(tmp_path_factory.mktemp("first"), 0o022, "UTC", 1_000_000_000)


def test_distributions_are_the_same_bytes(distributions: dict[str, bytes], tmp_path: Path) -> None:
    assert len(distributions) == 2
    assert packed(tmp_path, 0o077, "Pacific/Kiritimati", 1_700_000_000) == distributions


def wheel(distributions: dict[str, bytes], folder: Path) -> Path:
    (name,) = (name for name in distributions if name.endswith(".whl"))
    (folder / name).write_bytes(distributions[name])
    return folder / name


def test_a_wheel_holds_the_compiler_the_specs_and_their_package_alone(
    distributions: dict[str, bytes], tmp_path: Path
) -> None:
    with zipfile.ZipFile(wheel(distributions, tmp_path)) as file:
        names = file.namelist()
    assert {name.partition("/")[0].partition("-")[0] for name in names} == {"fieldspec", "fieldspec_devices"}
    assert {Path(name).suffix for name in names if "fieldspec_devices" in name} <= {".py", ".typed"}
    specs = ROOT / "specs"
    assert {name.removeprefix("fieldspec/_specs/") for name in names if name.startswith("fieldspec/_specs/")} == {
        path.relative_to(specs).as_posix() for path in specs.rglob("*") if path.is_file()
    }
    assert not any("__pycache__" in name or name.endswith((".pyc", ".whl")) for name in names)
    package = ROOT / "codegen" / "fieldspec"
    sources = {f"fieldspec/{path.relative_to(package).as_posix()}" for path in package.rglob("*.st")}
    assert sources
    assert sources <= set(names)


def test_an_installed_wheel_works_in_an_empty_folder(distributions: dict[str, bytes], tmp_path: Path) -> None:
    """The libraries come from this environment, so that nothing is downloaded; fieldspec comes from the wheel."""
    home, here = tmp_path / "venv", tmp_path / "here"
    here.mkdir()
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(home)], check=True)
    python = home / "bin" / "python"
    # Python compiles the modules that it loads; pip would compile those of all devices.
    install = ["install", "--quiet", "--no-compile", "--no-deps", "--no-index", str(wheel(distributions, tmp_path))]
    subprocess.run([sys.executable, "-m", "pip", "--python", str(python), *install], check=True)
    (site,) = home.glob("lib/python*/site-packages")
    (site / "libraries.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    before = sorted(path for path in site.rglob("*") if "__pycache__" not in path.parts)

    def run(*arguments: str) -> subprocess.CompletedProcess[str]:
        environment = {"PATH": os.environ["PATH"], "HOME": str(tmp_path), "FIELDSPEC_CACHE": str(tmp_path / "cache")}
        command = [str(home / "bin" / "fieldspec"), *arguments]
        return subprocess.run(command, cwd=here, env=environment, capture_output=True, text=True, check=False)

    assert "tc100" in run("devices").stdout
    assert run("decode", "tc100", "01 06 20 1e 00 03 a2 0d").returncode == 0
    refused = run("audit", "tc100", "--sign", "all", "--by", "me")
    assert (refused.returncode, "are not changed" in refused.stderr) == (2, True)
    protocols = sorted(path.stem for path in (ROOT / "specs/protocols").glob("*.yaml"))
    for number, protocol in enumerate(["packet", *protocols]):
        created = run("new", "device", f"pump{number}", "--protocol", protocol)
        assert (created.returncode, created.stderr) == (0, "")
        assert f"specs/pump{number}/device.yaml" in created.stdout
    checked = run("check")
    assert (checked.returncode, checked.stdout) == (0, checked.stdout.strip() + "\n")
    on_can = next(number for number, protocol in enumerate(["packet", *protocols]) if protocol == "canopen")
    others = [f"pump{number}" for number in range(len(protocols) + 1) if number != on_can]
    assert run("build", *others).returncode == 0
    assert run("build", f"pump{on_can}", "--to", "c,docs,js,python").returncode == 0
    assert (here / "generated/c/pump0.h").is_file()
    assert sorted(path for path in site.rglob("*") if "__pycache__" not in path.parts) == before


def present(name: str) -> bool:
    """Whether a distribution is installed; some are needed by other versions of Python only."""
    try:
        importlib.metadata.distribution(name)
    except importlib.metadata.PackageNotFoundError:
        return False
    return True


def licence(name: str) -> str:
    """The licence that a distribution states."""
    data = importlib.metadata.metadata(name)
    classifiers = [text for text in data.get_all("Classifier") or () if text.startswith("License ::")]
    return " ".join([data.get("License-Expression") or "", (data.get("License") or "")[:100], *classifiers])


def test_dependencies_may_be_used_by_programs_of_any_licence() -> None:
    waiting, seen = ["fieldspec"], set[str]()
    for name in waiting:
        for text in importlib.metadata.requires(name) or ():
            wanted = text.partition(";")
            needed = "".join(letter if letter.isalnum() or letter in "-_." else " " for letter in wanted[0]).split()[0]
            if "extra" not in wanted[2] and needed not in seen:
                seen.add(needed)
                waiting.append(needed)
    installed = {name for name in seen if present(name)}
    assert {"construct", "jinja2", "openpyxl", "xlsxwriter", "pyyaml", "rich"} <= {name.lower() for name in installed}
    assert {name: licence(name) for name in installed if not any(word in licence(name) for word in FREE)} == {}
