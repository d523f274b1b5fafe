"""Lists as people have them: what must come out of each is written in `register_lists`, from the list alone."""

from __future__ import annotations

import io
import json
import re
from decimal import Decimal
from pathlib import Path
from typing import Any

import openpyxl
import pytest
import yaml
from openpyxl.comments import Comment

from command_line import CommandLine
from fieldspec.tools.lists.assumption import STATED_NOTHING
from fieldspec.tools.lists.heading_words import NOTE
from fieldspec.tools.lists.imported import imported
from fieldspec.tools.lists.list_file import file_list

FOLDER = Path(__file__).parent / "register_lists"
Loader = yaml.CSafeLoader if yaml.__with_libyaml__ else yaml.SafeLoader
CASES = {
    f"{path.stem}: {case['name']}": case
    for path in sorted(FOLDER.glob("*.yaml"))
    for case in yaml.load(path.read_text("utf-8"), Loader)
}


def content(case: dict[str, Any]) -> bytes:
    """The file of a case: a text in its encoding, or a workbook."""
    if "list" in case:
        return bytes(case["list"].encode(case.get("encoding", "utf-8")))
    book = openpyxl.Workbook()
    book.remove(book.worksheets[0])
    for title, rows in case["sheets"].items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
        for area in case.get("merged", ()):
            sheet.merge_cells(area)
        for place in case.get("hidden", ()):
            dimensions = sheet.row_dimensions if isinstance(place, int) else sheet.column_dimensions
            dimensions[place].hidden = True
        for place, text in case.get("comments", {}).items():
            sheet[place].comment = Comment(text, "Ann")
    buffer = io.BytesIO()
    book.save(buffer)
    return buffer.getvalue()


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    (tmp_path / "specs").mkdir()
    return CommandLine(capsys, monkeypatch, tmp_path / "specs")


def cell(value: object) -> object:
    """A cell of an exported list, numbers as they are and not as they are written."""
    return Decimal(str(value)).normalize() if isinstance(value, int | float) else value


def place(row: dict[str, Any]) -> str:
    number = str(row["address"]) if row["subindex"] is None else f"{row['address']}.{row['subindex']}"
    return number if row["space"] == "registers" else f"{row['space']}:{number}"


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_a_list_gives_what_it_says_and_names_the_rest(case: dict[str, Any], run: CommandLine) -> None:
    path = run.folder / "dut" / "device.yaml"
    ran = run("import", "-", "--to", str(path), *case.get("options", ()), stdin=content(case))
    if "refusal" in case:
        assert ran.code == 2
        assert case["refusal"] in ran.err
        return
    assert (ran.code, ran.err) == (0, "")
    # An export refuses a spec in which `check` has an error.
    exported = run("export", "dut", "--to", "json")
    assert exported.code == 0
    rows = {place(row): row for row in json.loads(exported.out)}
    wanted = {str(key): facts for key, facts in case["rows"].items()}
    got = {key: {fact: cell(rows[key][fact]) for fact in facts} for key, facts in wanted.items() if key in rows}
    assert got == {key: {fact: cell(value) for fact, value in facts.items()} for key, facts in wanted.items()}
    assert [*rows.keys() - wanted.keys()] == []
    refused = dict(re.findall(r"^not used: row (\d+)(.*)", ran.out, re.MULTILINE))
    assert {int(number) for number in refused} == case.get("refused", {}).keys()
    for number, reason in case.get("refused", {}).items():
        assert reason in refused[str(number)]
    unused = re.search(r"^columns not used: (.*)", ran.out, re.MULTILINE)
    assert (unused[1].split(", ") if unused else []) == case.get("unused", [])
    assert re.search(case.get("message", ""), ran.out)
    text = path.read_text("utf-8")
    assert [part for part in case.get("spec", ()) if part not in text] == []


def test_every_name_of_a_case_is_told_apart() -> None:
    texts = [path.read_text("utf-8") for path in FOLDER.glob("*.yaml")]
    assert len(CASES) == sum(len(re.findall("^- name: ", text, re.MULTILINE)) for text in texts)


def test_most_rows_and_columns_of_the_lists_are_used() -> None:
    # That what is used is right, each list of these shows above; here nothing is counted that only became a note.
    columns_used = columns_all = rows_used = rows_all = 0
    for case in CASES.values():
        if "refusal" in case or "options" in case:
            continue
        sheet, read = file_list(content(case), "", "", {}, STATED_NOTHING)
        result = imported(read, sheet, 0)
        noted = len(read.columns.more.get(NOTE, ())) + (NOTE in read.columns.places)
        used = {*read.columns.places.values(), *(n for columns in read.columns.more.values() for n in columns)}
        columns_used += len(used) - noted
        columns_all += len(used) + len(read.columns.unused())
        rows_used += len(result.used_rows())
        rows_all += len(result.used_rows() | {refusal.row for refusal in result.refused} | {*result.skipped})
    assert columns_all > 250
    assert rows_all > 250
    assert columns_used >= 0.8 * columns_all
    assert rows_used >= 0.95 * rows_all
