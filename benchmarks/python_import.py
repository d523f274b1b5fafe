"""What it takes to import generated modules, as whole processes: one of 100 records, and one of 10,000 registers."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path
from statistics import median

from peers import records, registers
from processes import PYTHON, Took, in_turns, limited, run
from rows import Row, printed

from fieldspec.command.pipeline import layouts, load, outputs

GROUP = "Python, import"
RECORDS = 100
FIELDS = {f"value_{at}": "H" if at % 3 else "i" for at in range(21)}
TYPES = {"H": "u16", "i": "i32"}
ROUNDS = 81
HEAD = f"""
device: {{id: large, name: Large, vendor: Nobody, manual: {{title: M, file: m.txt, sha256: "{"0" * 64}", lines: 9}}}}
records:
"""


def spec() -> bytes:
    """A device with 100 records of 21 fields."""
    fields = ", ".join(f"{{name: {name}, type: {TYPES[letter]}, source: 1 L1}}" for name, letter in FIELDS.items())
    rows = [f"  - {{name: record_{record}, source: 1 L1, fields: [{fields}]}}" for record in range(RECORDS)]
    return (HEAD + "\n".join(rows) + "\n").encode()


def write_generated(folder: Path, specs: dict[str, bytes]) -> str:
    """Writes the package of the only device of some specs, and gives the name of its module."""
    project = load(specs)
    assert not project.findings, project.findings[0].message
    (device,) = project.devices
    for path, text in outputs([layouts(project.devices[device])], ["python"]).items():
        place = folder / Path(path).relative_to("python")
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(text.encode() if isinstance(text, str) else text)
    module = next(path.stem for path in (folder / "fieldspec_devices" / device).iterdir() if path.stem[0] != "_")
    return f"fieldspec_devices.{device}.{module}"


def added(took: list[Took], nothing: list[Took]) -> float:
    """Milliseconds of the processor beyond those of a process that does nothing."""
    middle: float = median(measured.work - other.work for measured, other in zip(took, nothing, strict=True))
    return round(middle, 2)


def rows() -> Iterator[Row]:
    """The rows: what the import adds to a process that does nothing."""
    with tempfile.TemporaryDirectory() as folder:
        module = write_generated(Path(folder), {"large/device.yaml": spec()})
        Path(folder, "by_hand.py").write_text(records.module(RECORDS, FIELDS), "utf-8")
        commands = {
            "nothing": (*PYTHON, "-c", "pass"),
            "ours": (*PYTHON, "-c", f"import {module}"),
            "by hand": (*PYTHON, "-c", "import by_hand"),
        }
        took = in_turns(commands, ROUNDS, PYTHONPATH=folder, PYTHONDONTWRITEBYTECODE="")
    ours, by_hand = (added(took[name], took["nothing"]) for name in ("ours", "by hand"))
    name = f"{RECORDS} records of {len(FIELDS)} fields, added to python -c pass"
    yield Row(GROUP, name, "the goal of 4 ms", ours, 4, "ms", round(ours / 4, 3), at_most=1)
    hand = "one file by hand"
    yield Row(GROUP, name, hand, ours, by_hand, "ms", round(ours / by_hand, 3))
    yield from _of_many_registers()


def _of_many_registers() -> Iterator[Row]:
    """The rows of a device with many registers: the first import, which compiles them, and the next ones."""
    name = f"{registers.MOST // 5:,} registers"
    with tempfile.TemporaryDirectory() as folder:
        specs = registers.spec(registers.MOST // 5)
        module = write_generated(Path(folder), {path: text.encode() for path, text in specs.items()})
        command = (*PYTHON, "-c", f"import {module}")
        first, *later = [run(command, PYTHONPATH=folder, PYTHONDONTWRITEBYTECODE="") for _ in range(6)]
    yield limited(GROUP, f"{name}, first import, memory", first.memory / 1e6, "MB", 120)
    yield limited(GROUP, f"{name}, from bytecode", median(measured.work for measured in later), "ms", 600)


if __name__ == "__main__":
    printed(rows())
