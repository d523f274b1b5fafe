"""`fieldspec lsp` does what the help of a finding says: after the action, the finding is gone."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
import yaml
from lsprotocol import types

from command_line import CommandLine
from editing import Editor, applied, copied, editor, fresh, place_of
from fieldspec.command.editor.edits import with_item
from fieldspec.foundation.source import SourceFile
from fieldspec.language.reading.memory import FileRead
from fieldspec.language.reading.nodes import Mapping
from fieldspec.language.reading.yaml_reader import parsed

GIZMO = "gizmo/device.yaml"
ROW = "      - {at: 0, name: speed, type: i16, unit: rpm, access: ro, source: L10}\n"
SECOND = ROW.replace("at: 0", "at: 77").replace("speed", "other")


async def actions(session: Editor, name: str, text: str, start: int, end: int) -> dict[str, Any]:
    """What is offered for a part of a text, by title."""
    document = types.TextDocumentIdentifier(session.uri(name))
    range = types.Range(place_of(text, start), place_of(text, end))
    asked = types.CodeActionParams(document, range, types.CodeActionContext([]))
    answer = await session.client.text_document_code_action_async(asked) or []
    return {action.title: action for action in answer}


def after(session: Editor, action: Any, texts: dict[str, str]) -> dict[str, str]:
    """The documents after the edits of an action."""
    result = dict(texts)
    for uri, edits in action.edit.changes.items():
        name = uri.removeprefix(session.specs.as_uri() + "/")
        text = result.get(name) or session.text(name)
        result[name] = applied(text, [*edits])
    return result


SLIPS = {
    "an unknown key that is like one": (ROW.replace("unit:", "unti:"), "Write `unit`"),
    "a word of other tools for a key": (ROW.replace("type:", "data_type:"), "Write `type`"),
    "an unknown word": (ROW.replace("access: ro", "access: or"), "Write `ro`"),
    "an unknown word after Chinese texts": (ROW.replace("access: ro", "label: 速度𝄞, access: or"), "Write `ro`"),
    "an unknown type within quotation marks": (ROW.replace("type: i16", 'type: "i61"'), "Write `i16`"),
    "a number within quotation marks": (ROW.replace("at: 0", 'at: "0"'), "Write `0`"),
    "a comma within braces": (ROW.replace("source:", "doc: Slow, steady, source:"), "Quote the text"),
    "a sign that begins no text": (ROW.replace("source:", "doc: @home, source:"), "Quote the text"),
    "two rows at an address": (ROW + SECOND.replace("at: 77", "at: 0"), "Correct `at` to 0x0006"),
    "a decimal address of another one": (
        ROW.replace("at: 0", "at: 0, checked: {decimal: 7}"),
        "Correct `decimal` to 0",
    ),
    "a command that is not a trigger": (
        ROW.replace("access: ro", "access: wo, roles: [alarm_reset]"),
        "Add `trigger: true`",
    ),
}


@pytest.mark.proof(8)
@pytest.mark.parametrize("ends", ["\n", "\r\n"], ids=["LF", "CRLF"])
@pytest.mark.parametrize("case", SLIPS)
async def test_the_help_of_a_finding_is_done_where_it_is_mechanical(tmp_path: Path, case: str, ends: str) -> None:
    specs = copied(tmp_path, "gizmo")
    row, title = SLIPS[case]
    async with editor(specs) as session:
        await session.opened(GIZMO)
        text = session.text(GIZMO).replace(ROW, row).replace("\n", ends)
        before = fresh(specs, {GIZMO: text})
        await session.typed(GIZMO, text)
        finding = before[-1] if title.startswith("Add") else before[0]
        offered = await actions(session, GIZMO, text, finding.span.start, finding.span.start)
        assert title in offered, (finding, [*offered])
        texts = after(session, offered[title], {GIZMO: text})
    left = {diagnostic.code for diagnostic in fresh(specs, texts)}
    assert finding.code not in left, (texts[GIZMO], left)
    assert len(left) < len({diagnostic.code for diagnostic in before}) + 1


BLOCK = "      - at: 0\n        name: speed\n        type: i16\n        access: ro  # x\n"
ROWS = {
    "in braces": ROW,
    "after an anchor": ROW.replace("{at", "&row {at"),
    "of lines": BLOCK,
    "of lines that end with braces": f"{BLOCK}        inferred: {{type: So.}}\n",
    "of lines that end with brackets": f"{BLOCK}        restated: [{{source: L11, at: 0}}]\n",
}


@pytest.mark.proof(3)
@pytest.mark.parametrize("row", ROWS.values(), ids=ROWS)
async def test_what_is_allowed_asks_for_the_reason_and_is_no_finding_with_it(tmp_path: Path, row: str) -> None:
    specs = copied(tmp_path, "gizmo")
    other = row.replace("speed", "other")
    async with editor(specs) as session:
        await session.opened(GIZMO)
        text = session.text(GIZMO).replace(ROW, row + other)
        (finding,) = (
            diagnostic for diagnostic in fresh(specs, {GIZMO: text}) if diagnostic.code == "addresses_disjoint"
        )
        await session.typed(GIZMO, text)
        offered = await actions(session, GIZMO, text, finding.span.start, finding.span.end)
        (new,) = after(session, offered["Allow `addresses_disjoint` here with a reason"], {GIZMO: text}).values()
    asked = fresh(specs, {GIZMO: new})
    assert [
        (diagnostic.code, diagnostic.span.file.text[diagnostic.span.start : diagnostic.span.end])
        for diagnostic in asked
    ] == [("wrong_form", '""')]
    reasoned = new.replace('addresses_disjoint: ""', "addresses_disjoint: The manual prints both.")
    assert "addresses_disjoint" not in {diagnostic.code for diagnostic in fresh(specs, {GIZMO: reasoned})}


async def test_a_corrected_address_can_leave_an_erratum_with_the_print_that_proves_it(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo")
    async with editor(specs) as session:
        await session.opened(GIZMO)
        text = session.text(GIZMO).replace(ROW, ROW + SECOND.replace("at: 77", "at: 0"))
        await session.typed(GIZMO, text)
        (finding,) = fresh(specs, {GIZMO: text})
        offered = await actions(session, GIZMO, text, finding.span.start, finding.span.end)
        action = offered["Correct `at` to 0x0006, with an erratum"]
        (new,) = after(session, action, {GIZMO: text}).values()
    assert "printed: {at: 0}" in new
    assert "proof: addresses_disjoint" in new
    with_reason = new.replace('reason: ""', "reason: Both rows have one address.")
    assert {diagnostic.code for diagnostic in fresh(specs, {GIZMO: with_reason})} == {"addresses_ascending"}


@pytest.mark.parametrize("last", ["about: [a]", "reason: '[x]'", "fact: a/b"])
def test_an_item_is_added_behind_the_last_one_whatever_that_ends_with(last: str) -> None:
    file = SourceFile("device.yaml", f"errata:\n  - id: first\n    {last}\nlinks: []\n")
    tree, _ = parsed(file)
    assert isinstance(tree, Mapping)
    edit = with_item(FileRead(b"", file, [], [], tree), "errata", ["id: second", "fact: c/d"])
    text = file.text[: edit.span.start] + edit.text + file.text[edit.span.end :]
    assert [item["id"] for item in yaml.safe_load(text)["errata"]] == ["first", "second"]


METER, OVERLAY = "wattmeter/device.yaml", "wattmeter/versions/2.yaml"


async def test_a_value_that_has_been_changed_is_moved_to_a_version_and_the_other_keeps_what_is_saved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    specs = copied(tmp_path, "wattmeter")
    saved = (specs / METER).read_text("utf-8")
    row = re.search(r"\{at: [^\n]*range: (1..1000)", saved)
    assert row is not None
    changed = f"{saved[: row.start(1)]}1..2000{saved[row.end(1) :]}"
    name = re.search(r"name: (\w+)", row[0])
    assert name is not None
    async with editor(specs) as session:
        await session.opened(METER, changed)
        offered = await actions(session, METER, changed, row.start(1), row.start(1))
        moves = [title for title in offered if title.startswith("Move")]
        assert moves == ["Move this `range` to version 2"]  # version 1 has no file
        texts = after(session, offered[moves[0]], {METER: changed})
    assert texts[METER] == saved
    for document, text in texts.items():
        (specs / document).write_text(text.replace('reason: ""', "reason: The notes say so."), "utf-8")
    run = CommandLine(capsys, monkeypatch, specs)
    for version, most in (("1", "1000"), ("2", "2000")):
        text = run("show", f"wattmeter@{version}", f"registers/{name[1]}").out
        assert re.search(rf"range +1\.\.{most}\n", text), text


async def test_a_frame_is_explained_as_decode_does(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    specs = copied(tmp_path, "wattmeter")
    run = CommandLine(capsys, monkeypatch, specs)
    frame = "01 03 00 00 00 02 C4 0B"
    async with editor(specs) as session:
        text = session.text(METER) + f"# seen: {frame}\n"
        await session.opened(METER, text)
        start = text.index(frame)
        offered = await actions(session, METER, text, start + 4, start + 4)
        command = offered["Explain this frame"]
        asked = types.ExecuteCommandParams(command.command, arguments=command.arguments)
        answer = await session.client.workspace_execute_command_async(asked)
    assert answer == run("decode", "wattmeter", frame).out


async def test_a_frame_becomes_an_example_that_is_proven(tmp_path: Path) -> None:
    specs = copied(tmp_path, "wattmeter")
    frame = "01 03 00 00 00 02 C4 0B"
    async with editor(specs) as session:
        text = session.text(METER) + f"# seen: {frame}\n"
        await session.opened(METER, text)
        start = text.index(frame)
        offered = await actions(session, METER, text, start, start + len(frame))
        (title,) = (title for title in offered if title.startswith("Make an example"))
        (new,) = after(session, offered[title], {METER: text}).values()
    assert f"frame: {frame}" in new
    assert fresh(specs, {METER: new}) == []
    wrong = new.replace(f"frame: {frame}", "frame: 01 03 00 00 00 01 84 0A")
    assert {diagnostic.code for diagnostic in fresh(specs, {METER: wrong})} == {"meaning_matches_bytes"}


async def test_a_new_name_that_is_typed_becomes_the_name_in_a_version_and_the_others_keep_the_old_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    specs = copied(tmp_path, "wattmeter")
    saved = (specs / METER).read_text("utf-8")
    changed = saved.replace("name: ratio", "name: transformer_ratio")
    async with editor(specs) as session:
        await session.opened(METER, changed)
        start = changed.index("transformer_ratio")
        offered = await actions(session, METER, changed, start, start)
        texts = after(session, offered["Rename in version 2, which the others do not have"], {METER: changed})
    assert texts[METER] == saved
    for document, text in texts.items():
        (specs / document).write_text(text.replace('reason: ""', "reason: The notes say so."), "utf-8")
    assert fresh(specs, {}) == []
    run = CommandLine(capsys, monkeypatch, specs)
    assert run("show", "wattmeter@1", "registers/ratio").out.startswith("ratio\n")
    assert run("show", "wattmeter@2", "registers/transformer_ratio").out.startswith("transformer_ratio\n")
