"""The C headers that benchmarks measure, and what compilers make of them."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.reading.project import read
from fieldspec.targets.c.backend import files
from fieldspec.targets.c.fields import members

SPECS = Path(__file__).resolve().parent.parent / "specs"


@dataclass(frozen=True)
class Subject:
    """A record that is measured: its prefix in C, its bytes, and how many fields are read and written.

    A reserved field is written, as zeros, but not read.
    """

    name: str
    header: str
    prefix: str
    size: int
    reads: int
    writes: int


def newest() -> dict[str, DeviceLayout]:
    """The layouts of the newest versions of the real devices."""
    project = read({path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.rglob("*.yaml"))})
    return {name: device_layout(spec.at(spec.versions()[-1])[0]) for name, spec in project.devices.items()}


def write_headers(folder: Path, devices: dict[str, DeviceLayout]) -> dict[str, str]:
    """Writes the headers of devices into a folder; their names by device."""
    headers = {}
    for name, layout in devices.items():
        for path, text in files([layout]).items():
            (folder / path).write_text(text, encoding="utf-8", newline="\n")
            if path.endswith("_selftest.c"):
                headers[name] = path.replace("_selftest.c", ".h")
    return headers


def subjects(devices: dict[str, DeviceLayout], headers: dict[str, str]) -> list[Subject]:
    """The point record of one device, and both directions of a telegram of another."""
    point = devices["ck10"].records["point"]
    telegram = devices["hiwin-e"].messages["telegram_111"]
    all_subjects = []
    for device, record in (("ck10", point), ("hiwin-e", telegram.request), ("hiwin-e", telegram.response)):
        assert record.size is not None
        all_subjects.append(
            Subject(
                name=record.name.replace("_", " "),
                header=headers[device],
                prefix=f"{device.replace('-', '_')}_{record.name}",
                size=record.size,
                reads=len(members(record)),
                writes=sum(field.count or 1 for field in record.fields),
            )
        )
    return all_subjects


def needed(tool: str, package: str) -> str:
    """The path of a program, or the end of the benchmark with what to install."""
    path = shutil.which(tool)
    if path is None:
        sys.exit(f"{tool} is not installed; on Debian: apt-get install {package}")
    return path


def version(tool: str) -> str:
    """A compiler and its version: `gcc 12.2.0`."""
    output = subprocess.run([tool, "-dumpfullversion"], capture_output=True, text=True, check=True).stdout.strip()
    return f"{Path(tool).name} {output}"


def instructions(objdump: str, program: Path) -> tuple[Counter[str], Counter[str]]:
    """How many instructions each function has, and how many of them call memory functions of the library."""
    text = subprocess.run(
        [objdump, "-dr", "--no-show-raw-insn", str(program)], capture_output=True, text=True, check=True
    )
    total: Counter[str] = Counter()
    calls: Counter[str] = Counter()
    function = ""
    for line in text.stdout.splitlines():
        if match := re.match(r"[0-9a-f]+ <(\w+)>:", line):
            function = match[1]
        elif re.match(r"\s+[0-9a-f]+:\t[^.]", line):
            total[function] += 1
        elif re.match(r"\s+[0-9a-f]+: R_\w+\s+(__aeabi_)?mem\w+", line):
            calls[function] += 1
    return total, calls
