"""The own export of every device comes back: the same registers, fields of tables and parameters."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any

import pytest

from command_line import SPECS, TEST_SPECS, CommandLine
from proofs import IS_WHOLE

DEVICES = [
    (folder, path.parent.name) for folder in (SPECS, TEST_SPECS) for path in sorted(folder.glob("*/device.yaml"))
]
WITHOUT = (
    *(
        "armband",
        "beacon",
        "broker",
        "coupler",
        "courier",
        "gateway",
        "grinder",
        "heatmeter",
        "herald",
        "pedal",
        "pressure",
        "scanner",
        "sealer",
        "seismograph",
        "sequencer",
        "sorter",
    ),
    *("stamper", "tariff", "thermostat", "tracker", "turret"),
)
"""Devices without registers and parameters."""


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    (tmp_path / "specs").mkdir()
    return CommandLine(capsys, monkeypatch, tmp_path / "specs")


def facts(text: str) -> dict[tuple[str, int, str], dict[str, Any]]:
    """The facts of a list by space, address and name. Values have no order, and cells have no ends of lines."""
    rows = json.loads(text)
    return {
        (row["space"], row["address"], row["name"]): {
            key: sorted(value.split("; "))
            if key == "values" and value
            else " ".join(value.split())
            if isinstance(value, str)
            else value
            for key, value in row.items()
        }
        for row in rows
    }


@pytest.mark.proof(13)
@pytest.mark.parametrize(("folder", "device"), DEVICES, ids=[device for _, device in DEVICES])
@pytest.mark.parametrize("form", ["json", "csv", "xlsx"])
def test_an_export_comes_back_with_the_same_facts(
    form: str, folder: Path, device: str, run: CommandLine, tmp_path: Path
) -> None:
    own, run.folder = run.folder, folder
    path = tmp_path / f"list.{form}"
    ran = run("export", device, "--to", form, "--out", str(path))
    if device in WITHOUT:
        assert (ran.code, ran.err) == (
            2,
            f"fieldspec: {device} has no registers and no parameters; --messages exports its messages\n",
        )
        return
    assert ran.code == 0
    before = facts(run("export", device, "--to", "json").out)
    run.folder = own
    ran = run("import", str(path), "--to", str(own / "again" / "device.yaml"))
    assert ran.code == 0, ran.err
    after = facts(run("export", "again", "--to", "json").out)
    assert "not used: " not in ran.out
    assert after == before


def test_what_nobody_has_compared_with_the_manual_comes_back_so(run: CommandLine, tmp_path: Path) -> None:
    device = run.folder / "first" / "device.yaml"
    run("import", "-", "--to", str(device), stdin=b"Address,Name,Values\n7,Speed,\n9,Mode,0 off; 1 on\n")
    lines = device.read_text("utf-8").splitlines()
    lines = [line.replace("L2, unverified: true", "3.4 L17").replace("lines: 3", "lines: 17") for line in lines]
    device.write_text("\n".join(lines), "utf-8")
    path = tmp_path / "list.csv"
    path.write_text(run("export", "first", "--to", "csv").out, "utf-8")
    run("import", str(path), "--to", str(run.folder / "again" / "device.yaml"))
    rows = json.loads(run("export", "again", "--to", "json").out)
    assert [(row["section"], row["line"], row["unverified"]) for row in rows] == [("3.4", 17, None), ("1", 3, "yes")]


def test_the_pages_of_a_manual_come_back_where_each_row_has_one(run: CommandLine, tmp_path: Path) -> None:
    device = run.folder / "first" / "device.yaml"
    run("import", "-", "--to", str(device), stdin=b"Address,Name,Values\n7,Speed,\n9,Mode,0 off; 1 on\n")
    text = device.read_text("utf-8").replace("L2, unverified: true", "3.4 P17").replace("lines: 3", "pages: 17")
    device.write_text(text.replace(" L1", " P1").replace(" L3", " P3"), "utf-8")
    exported = run("export", "first", "--to", "csv").out
    path = tmp_path / "list.csv"
    path.write_text(exported, "utf-8")
    run("import", str(path), "--to", str(run.folder / "again" / "device.yaml"))
    assert [row["line"] for row in json.loads(run("export", "first", "--to", "json").out)] == ["P17", "P3"]
    assert run("export", "again", "--to", "csv").out == exported
    path.write_text(exported.replace("P3", ""), "utf-8")
    run("import", str(path), "--to", str(run.folder / "other" / "device.yaml"))
    assert "Line in the list: P17." in (run.folder / "other" / "device.yaml").read_text("utf-8")


def test_a_row_of_an_export_without_a_place_in_the_manual_says_so(run: CommandLine, tmp_path: Path) -> None:
    own, run.folder = run.folder, SPECS
    lines = run("export", "tc100", "--to", "csv").out.splitlines()
    run.folder = own
    cells = lines[1].split(",")
    lines[1] = ",".join([*cells[:-3], "see above", "", ""])
    path = tmp_path / "list.csv"
    path.write_text("\n".join(lines), "utf-8")
    device = run.folder / "again" / "device.yaml"
    ran = run("import", str(path), "--to", str(device))
    assert "rows with cells that are only noted: 1" in ran.out
    line = next(line for line in device.read_text("utf-8").splitlines() if f"name: {cells[3]}," in line)
    assert line.endswith('notes: ["Section in the list: see above."], source: L2, unverified: true}')


def seconds_of(run: CommandLine, rows: list[str]) -> float:
    """The time of a processor that an import of some rows takes."""
    text = "\n".join(["Address,Name,Label,Type", *rows]).encode()
    start = time.process_time()
    assert run("import", "-", "--to", "-", stdin=text).code == 0
    return time.process_time() - start


@pytest.mark.proof
def test_many_rows_cost_no_more_where_names_repeat_or_number_them(run: CommandLine) -> None:
    numbers = range(10_000 if IS_WHOLE else 2_000)
    tidy = seconds_of(run, [f"{2 * number},{word_of(number)},About {word_of(number)},U32" for number in numbers])
    alike = seconds_of(run, [f"{2 * number},Speed,Label,U32" for number in numbers])
    numbered = seconds_of(run, [f"{2 * number},Speed {number},About {word_of(number)},U32" for number in numbers])
    rolled_up = seconds_of(run, [f"{2 * number},Speed {number},Label,U32" for number in numbers])
    assert max(alike, numbered, rolled_up) < 1.5 * tidy


def word_of(number: int) -> str:
    """A word of letters for each number."""
    return "".join(chr(ord("a") + int(digit)) for digit in str(number))
