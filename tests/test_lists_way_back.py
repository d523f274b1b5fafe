"""The own export of every device comes back: the same registers, fields of tables and parameters."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any

import pytest

from command_line import SPECS, TEST_SPECS, CommandLine

OF_THE_FILE = ("section", "line", "unverified")
"""Columns about the place where a fact is printed, which is the list itself after it was imported."""

WITHOUT = {"weigher": "numbers that are sent as digits, whose form a list does not have"}
"""Devices of which rows are refused by name, with the reason."""


def devices() -> list[tuple[Path, str]]:
    """All devices that have a list."""
    return [
        (folder, path.parent.name)
        for folder in (SPECS, TEST_SPECS)
        for path in sorted(folder.glob("*/device.yaml"))
        if any(
            f"{section}:" in file.read_text("utf-8")
            for file in path.parent.glob("*.yaml")
            for section in ("registers", "parameters")
        )
    ]


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
            if key not in OF_THE_FILE
        }
        for row in rows
    }


@pytest.mark.parametrize(("folder", "device"), devices(), ids=[device for _, device in devices()])
@pytest.mark.parametrize("form", ["json", "csv", "xlsx"])
def test_an_export_comes_back_with_the_same_facts(
    form: str, folder: Path, device: str, run: CommandLine, tmp_path: Path
) -> None:
    own, run.folder = run.folder, folder
    path = tmp_path / f"list.{form}"
    assert run("export", device, "--to", form, "--out", str(path)).code == 0
    before = facts(run("export", device, "--to", "json").out)
    run.folder = own
    ran = run("import", str(path), "--to", str(own / "again" / "device.yaml"))
    assert ran.code == 0, ran.err
    after = facts(run("export", "again", "--to", "json").out)
    refused = ran.out.count("\nnot used: row ")
    assert bool(refused) is (device in WITHOUT)
    assert len(before) - len(after) == refused
    same = {key: row for key, row in before.items() if key in after} if refused else before
    assert after == same


def seconds_of(run: CommandLine, rows: list[str]) -> float:
    """The time of a processor that an import of some rows takes."""
    text = "\n".join(["Address,Name,Label,Type", *rows]).encode()
    start = time.process_time()
    assert run("import", "-", "--to", "-", stdin=text).code == 0
    return time.process_time() - start


def test_equal_names_cost_no_more_than_different_ones(run: CommandLine) -> None:
    tidy = seconds_of(run, [f"{2 * number},Speed {number},Label {number},U32" for number in range(2000)])
    alike = seconds_of(run, [f"{2 * number},Speed,Label,U32" for number in range(2000)])
    assert alike < 3 * tidy
