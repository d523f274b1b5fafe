"""Every fault in every verb of `fieldspec live` ends with values that the device has, or with an error that says so."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.live.parameter_access import ParameterAccess
from fieldspec.tools.live.register_access import RegisterAccess
from fieldspec.tools.simulator.faults import KINDS
from layouts import TEST_SPECS

FOLDER = str(TEST_SPECS)
NAMES = ["limit", "points[1].speed", "points[2].speed"]
DETAILS: dict[str, dict[str, Any]] = {
    "late_answer": {"seconds": 0.25},
    "exception": {"reason": "value_invalid"},
    "stuck_bit": {"signal": "registers/limit", "value": 2},
    "out_of_range": {"signal": "registers/limit", "value": 9},
}
ERRORS = (
    *("is not written", "may be written or not", "the device holds", "was not accepted", "no answer", "exception"),
    *("was not read back", "cannot be read back", "differ again", "refused", "closed", "disconnected", "Errno"),
)
"""What an error says: one of these."""

OUTPUTS = ("dump.csv", "saved.csv", "backup.csv")


class Bench:
    """A simulated device, and what its memory says."""

    def __init__(self, device: SimulatedDevice, folder: Path) -> None:
        self.device, self.folder = device, folder
        self.engine = device.simulation.engine
        self.access = RegisterAccess(self.engine.layout)
        self.parameters = ParameterAccess(self.engine.layout, self.engine.layout.links["rtu"])
        self.first = {"words": dict(self.engine.memory.words), "elements": dict(self.engine.memory.elements)}

    def begin(self, values: dict[str, int]) -> None:
        """A device without faults that has the values at delivery but for some, and keeps them without power."""
        self.device.command(clear=True)
        self.engine.memory.words.update(self.first["words"])
        for path, raw in values.items():
            space, occupant = self.access.named(path)[0]
            self.engine.memory.write(space, occupant, raw)
        self.engine.saved = dict(self.engine.memory.words)

    def run(self, *arguments: str, timeout: str = "0.2") -> int:
        options = ("--port", self.device.place, "--timeout", timeout, "--pause", "0", "--specs", FOLDER)
        return main(["live", "widget", *arguments, *options])

    def words(self, path: str) -> list[int]:
        """The words that the device has of a value."""
        space, occupant = self.access.named(path)[0]
        return [self.engine.memory.words[space, occupant.address + at] for at in range(occupant.words)]

    def file(self, name: str) -> str:
        return str(self.folder / name)

    def means(self, path: str, text: str) -> bool:
        """Whether a cell of a file means what the device has."""
        for signal in self.parameters.named(path):
            numbered = signal.numbered
            assert numbered is not None
            key = numbered.parameter_set.name, numbered.parameter.number, signal.index or 0
            return bool(self.parameters.assignment(signal, text).raw == self.engine.memory.elements[key])
        return list(self.access.assignment(self.access.named(path)[0], text).words) == self.words(path)


def rows_are_right(bench: Bench, text: str) -> bool:
    """Whether all values that were printed as JSON are those of the device."""
    rows: list[dict[str, Any]] = []
    decoder, at = json.JSONDecoder(), 0
    while at < len(text.rstrip()):
        items, at = decoder.raw_decode(text, at)
        rows += items
        at += len(text[at:]) - len(text[at:].lstrip())
    return all(row["refused"] or row["words"] == bench.words(row["name"]) for row in rows)


def dump_is_right(bench: Bench, text: str) -> bool:
    path = Path(bench.file("dump.csv"))
    rows = list(csv.DictReader(io.StringIO(path.read_text("utf-8")))) if path.exists() else []
    first = bench.engine.layout.device.space_name("")
    own = {(row.get("space") or first, int(row["address"], 16)): int(row["value"]) for row in rows}
    elements = {(name, number): raw for (name, number, _), raw in bench.engine.memory.elements.items()}
    return all({**bench.engine.memory.words, **elements}[place] == word for place, word in own.items())


def scan_is_right(bench: Bench, text: str) -> bool:
    spaces = json.loads(text)["spaces"] if text.strip() else []
    own = {(part["space"], int(address, 16)): word for part in spaces for address, word in part["words"].items()}
    return all(bench.engine.memory.words[place] == word for place, word in own.items())


def list_is_right(name: str) -> Callable[[Bench, str], bool]:
    def is_right(bench: Bench, text: str) -> bool:
        path = Path(bench.file(name))
        rows = list(csv.DictReader(io.StringIO(path.read_text("utf-8")))) if path.exists() else []
        cells: dict[str, str] = {}
        for row in rows:
            if "Name" in row:
                cells[row["Name"]] = row["Value"]
            else:
                fields = [field for field in row if field[0].islower()]
                cells |= {f"{row['Table']}[{row['Index']}].{field}": row[field] for field in fields}
        return all(bench.means(path, cell.removeprefix("'")) for path, cell in cells.items() if cell)

    return is_right


def has_value(path: str, text: str) -> Callable[[Bench, str], bool]:
    return lambda bench, output: bench.means(path, text)


def nothing_differs(bench: Bench, text: str) -> bool:
    """Whether a comparison says of each value what the device has; what it does not name is as in the file."""
    named = {row["name"]: row["device"] for row in json.loads(text or "[]")}
    right = all(bench.means(path, cell) for path, cell in named.items() if not cell.startswith("refused"))
    wanted = {"limit": 3, "points[1].speed": 20, "points[2].speed": 30}
    return right and all(path in named or bench.words(path) == [raw] for path, raw in wanted.items())


VERBS: dict[str, tuple[list[str], Callable[[Bench, str], bool], bool]] = {
    "read": (["read", *NAMES, "--format", "json"], rows_are_right, False),
    "watch": (["watch", *NAMES, "--count", "2", "--every", "0", "--format", "json"], rows_are_right, False),
    "write": (["write", "limit=3", "--yes"], has_value("limit", "3"), True),
    "dump": (["dump", "{dump.csv}"], dump_is_right, False),
    "scan": (["scan", "0x1020..0x1029", "--format", "json"], scan_is_right, False),
    "points download": (["points", "download", "{saved.csv}", "--table", "points"], list_is_right("saved.csv"), False),
    "points upload": (["points", "upload", "{points.csv}", "--yes"], list_is_right("points.csv"), True),
    "backup": (["backup", "{backup.csv}"], list_is_right("backup.csv"), False),
    "restore": (["restore", "{settings.csv}", "--yes"], list_is_right("settings.csv"), True),
    "compare": (["compare", "{settings.csv}", "--format", "json"], nothing_differs, False),
}
"""Of each verb: its arguments, whether its output is right, and whether it writes."""


@pytest.fixture(scope="module")
def device() -> Iterator[SimulatedDevice]:
    with simulation("widget", ports={"rtu": "tcp://127.0.0.1:0"}, folder=FOLDER) as running:
        yield running


@pytest.mark.proof(17)
@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("request_number", [1, 3])
def test_a_fault_in_a_verb_gives_a_right_value_or_an_error(
    device: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    verb: str,
    kind: str,
    request_number: int,
) -> None:
    arguments, is_right, writes = VERBS[verb]
    (tmp_path / "points.csv").write_text("Table,Index,speed\npoints,1,20\npoints,2,30\n", "utf-8")
    settings = "Name,Value\nlimit,3\npoints[1].speed,20\npoints[2].speed,30\n"
    (tmp_path / "settings.csv").write_text(settings, "utf-8")
    bench = Bench(device, tmp_path)
    texts = [bench.file(text[1:-1]) if text.startswith("{") else text for text in arguments]
    bench.begin({"limit": 1, "points[1].speed": 5, "points[2].speed": 6})
    details = DETAILS.get(kind, {})
    lasting = kind in ("stuck_bit", "out_of_range")
    asked = device.simulation.faults.requests + request_number
    device.fault(kind, **details, **({} if lasting else {"request": asked}))
    code = bench.run(*texts)
    output = capsys.readouterr()
    printed = f"{code} {output.out[:300]} {output.err[-300:]}"
    failed = any(error in output.err + output.out for error in ERRORS)
    has_values = writes or output.out.strip() or any(Path(bench.file(name)).exists() for name in OUTPUTS)
    if (writes and code) or not has_values:
        assert failed, printed
    else:
        assert is_right(bench, output.out), printed
    device.command(clear=True)
    if writes and verb != "write":
        assert bench.run(*texts, timeout="10") == 0, printed
        assert is_right(bench, ""), printed
        assert not list(tmp_path.glob("*.journal")), printed
