"""Every fault in every verb that reads or writes parameters ends with values that the device has, or with an error."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.simulator.faults import KINDS
from layouts import TEST_SPECS

FOLDER = str(TEST_SPECS)
NUMBERS = {"target_position": 0, "target_speed": 2, "speed_limit": 4}
FIRST = {0: 7, 1: -8, 2: 100, 3: 0, 4: 1000, 8: 1}
WANTED = {0: 70, 2: 200, 4: 900}
DETAILS: dict[str, dict[str, Any]] = {
    "late_answer": {"seconds": 0.25},
    "exception": {"reason": "value_invalid"},
    "stuck_bit": {"signal": "parameters/axis/speed_limit", "value": 2},
    "out_of_range": {"signal": "parameters/axis/speed_limit", "value": 3000},
}
ERRORS = (
    *("not written", "may be written or not", "no answer", "closed", "disconnected", "Errno"),
    *("differ", "cannot be read back", "the device"),
)
"""What an error says: one of these."""


class Bench:
    """A simulated device, and what its memory says."""

    def __init__(self, device: SimulatedDevice, folder: Path) -> None:
        self.device, self.folder = device, folder
        self.engine = device.simulation.engine

    def begin(self) -> None:
        """A device without faults that has the first values, and keeps them without power."""
        self.device.command(clear=True)
        self.engine.memory.elements.update({("axis", number, 0): raw for number, raw in FIRST.items()})
        self.engine.saved_elements = dict(self.engine.memory.elements)

    def run(self, *arguments: str, timeout: str = "0.2") -> int:
        options = (
            "--with",
            "axis=0",
            "--port",
            self.device.place,
            "--timeout",
            timeout,
            "--pause",
            "0",
            "--specs",
            FOLDER,
        )
        return main(["live", "mover", *arguments, *options])

    def has(self, number: int, raw: int) -> bool:
        return bool(self.engine.memory.elements["axis", number, 0] == raw)

    def rows(self, name: str) -> list[dict[str, str]]:
        path = self.folder / name
        return list(csv.DictReader(path.read_text("utf-8").splitlines())) if path.exists() else []


def rows_are_right(bench: Bench, text: str) -> bool:
    decoder, at, rows = json.JSONDecoder(), 0, []
    while at < len(text.rstrip()):
        items, at = decoder.raw_decode(text, at)
        rows += items
        at += len(text[at:]) - len(text[at:].lstrip())
    return all(row["refused"] or bench.has(row["number"], row["value"]) for row in rows)


def dump_is_right(bench: Bench, text: str) -> bool:
    return all(bench.has(int(row["address"], 16), int(row["value"])) for row in bench.rows("dump.csv"))


def scan_is_right(bench: Bench, text: str) -> bool:
    spaces = json.loads(text)["spaces"] if text.strip() else []
    return all(bench.has(int(number, 16), raw) for space in spaces for number, raw in space["words"].items())


def backup_is_right(bench: Bench, text: str) -> bool:
    rows = [row for row in bench.rows("backup.csv") if row["Name"] in NUMBERS]
    return all(bench.has(NUMBERS[row["Name"]], int(row["Value"].lstrip("'"))) for row in rows)


def device_has_settings(bench: Bench, text: str) -> bool:
    return all(bench.has(number, raw) for number, raw in WANTED.items())


def nothing_else_differs(bench: Bench, text: str) -> bool:
    named = {row["name"]: row["device"] for row in json.loads(text or "[]")}
    right = all(cell.startswith("refused") or bench.has(NUMBERS[name], int(cell)) for name, cell in named.items())
    return right and all(name in named or bench.has(number, WANTED[number]) for name, number in NUMBERS.items())


VERBS: dict[str, tuple[list[str], Callable[[Bench, str], bool], bool]] = {
    "read": (["read", *NUMBERS, "--format", "json"], rows_are_right, False),
    "watch": (["watch", *NUMBERS, "--count", "2", "--every", "0", "--format", "json"], rows_are_right, False),
    "write": (["write", "target_speed=200", "--yes"], lambda bench, text: bench.has(2, 200), True),
    "dump": (["dump", "{dump.csv}"], dump_is_right, False),
    "scan": (["scan", "0..4", "--format", "json"], scan_is_right, False),
    "backup": (["backup", "{backup.csv}"], backup_is_right, False),
    "restore": (["restore", "{settings.csv}", "--yes"], device_has_settings, True),
    "compare": (["compare", "{settings.csv}", "--format", "json"], nothing_else_differs, False),
}
"""Of each verb: its arguments, whether its output is right, and whether it writes."""


@pytest.fixture(scope="module")
def device() -> Iterator[SimulatedDevice]:
    with simulation("mover", ports={"serial": "tcp://127.0.0.1:0"}, folder=FOLDER) as running:
        yield running


@pytest.mark.proof(12)
@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("request_number", [1, 2])
def test_a_fault_in_a_verb_for_parameters_gives_a_right_value_or_an_error(
    device: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    verb: str,
    kind: str,
    request_number: int,
) -> None:
    arguments, is_right, writes = VERBS[verb]
    settings = "".join(f"{name},{WANTED[number]}\n" for name, number in NUMBERS.items())
    (tmp_path / "settings.csv").write_text(f"Name,Value\n{settings}", "utf-8")
    bench = Bench(device, tmp_path)
    texts = [str(tmp_path / text[1:-1]) if text.startswith("{") else text for text in arguments]
    bench.begin()
    lasting = kind in ("stuck_bit", "out_of_range")
    asked = device.simulation.faults.requests + request_number
    device.fault(kind, **DETAILS.get(kind, {}), **({} if lasting else {"request": asked}))
    code = bench.run(*texts)
    output = capsys.readouterr()
    printed = f"{code} {output.out[:300]} {output.err[-300:]}"
    has_values = writes or output.out.strip() or any(tmp_path.glob("[db]*.csv"))
    if (writes and code) or not has_values:
        assert any(error in output.err + output.out for error in ERRORS), printed
    else:
        assert is_right(bench, output.out), printed
    device.command(clear=True)
    if verb == "restore":
        assert bench.run(*texts, timeout="10") == 0, printed
        assert is_right(bench, ""), printed
        assert not list(tmp_path.glob("*.journal")), printed


def test_a_request_that_lacks_a_value_says_how_to_add_it(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["live", "mover", "read", "target_speed", "--port", device.place, "--specs", FOLDER]) == 2
    assert "axis is not given; add it with --with NAME=VALUE" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("axis", "--with axis has no value; write it as NAME=VALUE"),
        ("axes=1", "there is no open field of requests on serial axes; did you mean axis?"),
        ("number=1", "there is no open field of requests on serial number; choose from axis"),
        ("axis=7", "axis=7: out_of_range"),
        ("axis=left", "axis=left: axis: `left` is not a number"),
    ],
)
def test_a_wrong_value_of_requests_is_refused(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str], text: str, expected: str
) -> None:
    assert main(["live", "mover", "read", "--with", text, "--port", device.place, "--specs", FOLDER]) == 2
    assert expected in capsys.readouterr().err


def test_a_scan_goes_on_where_a_device_is_silent_at_numbers_that_it_does_not_have(
    device: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    bench = Bench(device, tmp_path)
    bench.begin()
    assert bench.run("scan", "4..9", "--retries", "0", "--format", "json", timeout="0.2") == 0
    (space,) = json.loads(capsys.readouterr().out)["spaces"]
    assert space["words"] == {"0x0004": 1000, "0x0008": 1}


@pytest.mark.parametrize("verb", ["read", "write"])
def test_registers_take_no_values_of_requests(capsys: pytest.CaptureFixture[str], verb: str) -> None:
    arguments = ["live", "widget", verb, "limit=3", "--with", "start=1", "--port", "tcp://127.0.0.1:9"]
    assert main([*arguments, "--specs", FOLDER]) == 2
    assert "there is no open field of requests on rtu start; there are none" in capsys.readouterr().err
