"""`fieldspec build --watch`: the time of the processor until findings are printed, and until outputs are written."""

from __future__ import annotations

import math
import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from statistics import median

from peers import registers
from processes import FIELDSPEC, limited, work_of
from rows import ROOT, Row, printed

GROUP = "build --watch"
DEVICES = ("tc100", "ck10", "esc11", "hiwin-e")
ROUNDS = 5
MOST_LOOKING = 50
"""The milliseconds in a second that looking at the files takes at most."""
DESCRIPTION = re.compile(r"(?<=doc: )(?=[A-Z])")
LIMITS = {1000: 300, 10_000: 1500}
"""By number of registers, the milliseconds that a save may take."""
VERSIONS, REGISTERS = 51, 200
OVERLAY = """\
overlay: {{id: "1.{number}", line: firmware, based_on: "1.{base}"}}
changes:
  - {{fact: registers/value_{number}, set: {{access: {{was: rw, is: ro}}}}, reason: It is read only.}}
"""


def rows() -> Iterator[Row]:
    """The rows of real devices, and those of made-up ones."""
    yield from _device_rows()
    for count, limit in LIMITS.items():
        took = _work(registers.spec(count), "devicea/device.yaml", f"label: Value number {count // 2} ")
        yield limited(GROUP, f"{count:,} registers: Python and C after a changed label", took, "ms", limit)
    took = _work(versions(), "devicea/device.yaml", f"label: Value number {REGISTERS // 2} ")
    yield limited(GROUP, f"{VERSIONS} versions of {REGISTERS} registers: after one line in the base", took, "ms", 1000)


def versions() -> dict[str, str]:
    """A made-up device whose versions are files, each of which changes the range of a register."""
    files = registers.spec(REGISTERS)
    base = files["devicea/device.yaml"]
    files["devicea/device.yaml"] = f'{base}versions: [{{line: firmware, builds: true, members: [{{id: "1.0"}}]}}]\n'
    for number in range(1, VERSIONS):
        files[f"devicea/versions/1.{number}.yaml"] = OVERLAY.format(number=number, base=number - 1)
    return files


def _work(files: Mapping[str, str], path: str, text: str) -> float:
    """Milliseconds of the processor that a save takes after a change of a text, to Python and C."""
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            Path(folder, "specs", name).parent.mkdir(parents=True, exist_ok=True)
            Path(folder, "specs", name).write_text(content, encoding="utf-8")
        build = (*FIELDSPEC, "build", "--watch", "--to", "python,c")
        command = (*build, "--specs", f"{folder}/specs", "--out", f"{folder}/out")
        environment = {**os.environ, "FIELDSPEC_CACHE": f"{folder}/cache"}
        process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)
        try:
            _wait(process)
            lines = [files[path].replace(text, f"{text}{turn} ", 1) for turn in range(ROUNDS)]
            took = [_saved(process, Path(folder, "specs", path), line) for line in lines]
        finally:
            process.kill()
            process.wait()
    return median(took)


def _device_rows() -> Iterator[Row]:
    """For each device, a description changes, or a key is wrong."""
    with tempfile.TemporaryDirectory() as folder:
        specs = Path(folder, "specs")
        shutil.copytree(ROOT / "specs", specs)
        command = (*FIELDSPEC, "build", "--watch", "--specs", str(specs), "--out", str(Path(folder, "out")))
        environment = {**os.environ, "FIELDSPEC_CACHE": str(Path(folder, "cache"))}
        process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)
        try:
            _wait(process)
            for device in DEVICES:
                path = specs / device / "device.yaml"
                text = path.read_text("utf-8")
                saved = [_saved(process, path, DESCRIPTION.sub(f"{turn}. ", text, 1)) for turn in range(ROUNDS)]
                broken = [_saved(process, path, f"{text}wrong{turn}: 1\n") for turn in range(ROUNDS)]
                _saved(process, path, text)
                yield limited(GROUP, f"{device}: findings after a save", median(broken), "ms", 300)
                yield limited(GROUP, f"{device}: all outputs after a changed line", median(saved), "ms", 500)
        finally:
            process.kill()
            process.wait()


def _saved(process: subprocess.Popen[str], path: Path, text: str) -> float:
    """Milliseconds of the processor from a save to the end of what it leads to."""
    before = _idle(process)
    beside = path.with_name(".beside")
    beside.write_text(text, encoding="utf-8")
    os.replace(beside, path)
    _wait(process)
    return work_of(process.pid) - before


def _idle(process: subprocess.Popen[str]) -> float:
    """Waits until a process does no more than look at files; the time of the processor that it has taken."""
    before, now = -math.inf, work_of(process.pid)
    while now - before > MOST_LOOKING:
        time.sleep(1)
        before, now = now, work_of(process.pid)
    return now


def _wait(process: subprocess.Popen[str]) -> None:
    assert process.stdout is not None
    while "waiting for a spec" not in process.stdout.readline():
        assert process.poll() is None, "it has ended"


if __name__ == "__main__":
    printed(rows())
