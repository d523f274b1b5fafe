"""How long versions take: `python benchmarks/versions.py [REGISTERS...]`. The time per register must not grow.

First, two versions of each real device are resolved and compared. Then a made-up device is read whose registers lie in
several spaces, as parameters do, with twenty versions that are files; each is compared with the one before.
"""

from __future__ import annotations

import gc
import resource
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from fieldspec.language.changes.table import changes
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read

SPECS = Path(__file__).parent.parent / "specs"
VERSIONS = 20
MOST = 50_000
"""Registers of one set: their numbers have 16 bits."""

DEVICE = """
device: {{id: large, name: Large, vendor: Nobody, manual: {{title: M, file: m.txt, sha256: "{zeros}", lines: 9}}}}
versions: [{{line: firmware, builds: true, members: [{{id: "1.0"}}]}}]
"""
SET = "parameters:\n  - {{name: set_{at}, source: 1 L1, rows: [\n"
ROW = "{{number: {at}, name: value_{at}, type: u16, access: rw, range: 0..{most}, scale: 0.01, unit: mm}},\n"
OVERLAY = """
overlay: {{id: "{version}", line: firmware, based_on: "{base}"}}
changes:
{changes}
adds:
  - {{in: parameters/set_0, item: {{number: {free}, name: new_{number}, type: u16, access: rw}}, reason: New.}}
removes: [{{fact: parameters/set_0/value_{gone}, reason: Gone.}}]
renames: [{{fact: parameters/set_0/value_{old}, to: other_{number}, reason: So it is called now.}}]
"""
CHANGE = "  - {{fact: parameters/set_0/value_{at}, set: {{range: {{was: 0..{most}, is: 0..{new}}}}}, reason: Wider.}}\n"


def files(count: int) -> dict[str, bytes]:
    """The spec of a device with so many registers, in files of a size that is read, and its versions."""
    contents = {"large/device.yaml": DEVICE.format(zeros="0" * 64)}
    for start in range(0, count, MOST):
        rows = "".join(ROW.format(at=at - start, most=at % 100 + 1) for at in range(start, min(start + MOST, count)))
        contents[f"large/set-{start}.yaml"] = SET.format(at=start // MOST) + rows + "]}\n"
    for number in range(1, VERSIONS + 1):
        at = number * 10
        some = range(at, at + 5)
        contents[f"large/versions/1.{number}.yaml"] = OVERLAY.format(
            version=f"1.{number}",
            base=f"1.{number - 1}",
            changes="".join(CHANGE.format(at=number, most=number % 100 + 1, new=number % 100 + 500) for number in some),
            number=number,
            free=60_000 + number,
            gone=at + 6,
            old=at + 7,
        )
    return {path: text.encode() for path, text in contents.items()}


@contextmanager
def timed(what: str, each: int = 0) -> Iterator[None]:
    """Prints how long something takes."""
    start = time.perf_counter()
    yield
    took = time.perf_counter() - start
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    print(f"{what}: {took:.2f} s" + (f", {took / each * 1e6:.0f} us a register" if each else "") + f", {memory} MiB")


def compared(spec: DeviceSpec, versions: list[str], each: int = 0) -> None:
    """Resolves versions, and compares each with the one before it."""
    count = 0
    with timed(f"{spec.id}: {len(versions)} versions resolved and compared", each):
        old = spec.at(versions[0])[0]
        for version in versions[1:]:
            new = spec.at(version)[0]
            count += len(changes(old, new))
            old = new
    print(f"  {count} changes")


def main(counts: list[int]) -> None:
    """Runs all of it."""
    gc.disable()
    for path in sorted(SPECS.glob("*/device.yaml")):
        name = path.parent.name
        contents = {file.relative_to(SPECS).as_posix(): file.read_bytes() for file in SPECS.rglob("*.yaml")}
        with timed(f"{name}: read"):
            spec = read(contents, frozenset([name])).devices[name]
        versions = spec.versions()
        compared(spec, [versions[0], versions[-1]])
    for count in counts:
        with timed(f"{count} registers, {VERSIONS} versions in files: read", count):
            project = read(files(count))
        for finding in project.findings[:3]:
            print(finding.code, finding.message)
        spec = project.devices["large"]
        compared(spec, spec.versions(), count)


if __name__ == "__main__":
    main([int(text) for text in sys.argv[1:]] or [10_000, 100_000])
