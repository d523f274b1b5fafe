"""`fieldspec lsp` shows what `check` finds, in documents that are not saved, at the carets of the terminal."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from editing import copied, editor, editor_of_the_verb, expected_places, fresh
from proofs import IS_WHOLE

GIZMO, WIDGET = "gizmo/device.yaml", "widget/device.yaml"
ROW = "      - {at: 0, name: speed, type: i16, unit: rpm, access: ro, source: L10}\n"
ANCHORED = """      - &speed {at: 0, name: speed, type: i16, unit: rpm, access: ro, source: L10}
      - *speed
"""
EDITS = {
    "an unknown key": ROW.replace("unit:", "unti:"),
    "Chinese texts and a sign of two units before it": ROW.replace("unit:", "label: 速度𝄞𝄞, unti:"),
    "a range that the type cannot hold": ROW.replace("unit: rpm", 'label: "速度𝄞", range: 0..99999'),
    "an alias": ANCHORED,
    "a tab for a space": ROW.replace("      - {", "\t- {"),
    "tabs between words": ROW.replace(", unit", ",\t\tunti"),
    "a separator of lines that is none in an editor": ROW.replace("unit:", 'label: "a\u2028b", unti:'),
    "no YAML": ROW.replace("{at", "{{at"),
    "two rows with a name": ROW + ROW.replace("at: 0", "at: 77"),
}


@pytest.mark.parametrize("ends", ["\n", "\r\n"], ids=["LF", "CRLF"])
async def test_what_is_typed_has_the_findings_of_a_check_where_the_terminal_marks_them(
    tmp_path: Path, ends: str
) -> None:
    specs = copied(tmp_path, "gizmo")
    async with editor(specs) as session:
        assert await session.opened(GIZMO) == []
        sound = session.text(GIZMO)
        for case, row in EDITS.items():
            text = sound.replace(ROW, row).replace("\n", ends)
            await session.typed(GIZMO, text)
            expected = expected_places(fresh(specs, {GIZMO: text}))
            assert expected, case
            assert expected <= session.places(), case
        assert await session.typed(GIZMO, sound) == []
    assert (specs / GIZMO).read_text("utf-8") == sound  # nothing was written


async def test_a_finding_has_its_rule_its_help_and_the_other_places(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo")
    async with editor_of_the_verb(specs) as session:
        await session.opened(GIZMO)
        text = session.text(GIZMO).replace(ROW, ROW + ROW.replace("at: 0", "at: 77"))
        diagnostics = await session.typed(GIZMO, text)
    expected = {
        (finding.code, f"{finding.message}\nhelp: {finding.help}", len(finding.labels))
        for finding in fresh(specs, {GIZMO: text})
    }
    assert {
        (str(diagnostic.code), diagnostic.message, len(diagnostic.related_information or ()))
        for diagnostic in diagnostics
    } == expected


async def test_findings_of_one_document_depend_on_another_one_that_is_not_saved(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo")
    whole = (specs / GIZMO).read_text("utf-8")
    before, mark, registers = whole.partition("registers:\n")
    more = "gizmo/more.yaml"
    (specs / GIZMO).write_text(before, "utf-8")
    async with editor(specs) as session:
        await session.opened(GIZMO)
        await session.opened(more, mark + registers)  # a file that is not on the disk
        assert session.places() == set()
        await session.typed(more, mark + registers.replace(ROW, EDITS["an unknown key"]))
        assert {name for name, *_ in session.places()} == {more}
        await session.typed(GIZMO, before.replace("name: gizmo", "nam: gizmo").replace("vendor:", "vendro:"))
        assert {name for name, *_ in session.places()} == {more, GIZMO}


async def test_a_broken_document_keeps_the_findings_of_the_rest(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo", "widget")
    async with editor(specs) as session:
        await session.opened(WIDGET)
        await session.opened(GIZMO)
        wrong = session.text(GIZMO).replace(ROW, ROW + ROW.replace("at: 0", "at: 77"))
        await session.typed(GIZMO, wrong)
        places = session.places()
        broken = wrong + "enums: [{\n"
        await session.typed(GIZMO, broken)
        only_broken = expected_places(fresh(specs, {GIZMO: broken}))
        assert session.places() == places | only_broken
        unreadable = session.text(WIDGET) + "links: [\n"
        await session.typed(WIDGET, unreadable)
        assert session.places() == places | expected_places(fresh(specs, {GIZMO: broken, WIDGET: unreadable}))


async def test_a_file_that_is_new_and_not_sound_yet_keeps_the_findings_of_the_rest(tmp_path: Path) -> None:
    specs = copied(tmp_path, "wattmeter")
    name, device, new = "wattmeter/device.yaml", "wattmeter/more.yaml", "wattmeter/versions/3.yaml"
    async with editor(specs) as session:
        await session.opened(name)
        await session.typed(name, session.text(name).replace("range: 1..1000", "range: 1000..1"))
        places = session.places()
        assert {place[0] for place in places} == {name}
        for path, text in (
            (new, ""),
            (new, "overlay: {id: '3', li"),
            (new, "overlay:\n  id: '3'\n"),
            (device, "enums: [{"),
        ):
            await session.opened(path, text) if path not in session.open_names else await session.typed(path, text)
            assert places < session.places(), text
            assert path in {place[0] for place in session.places()}, text


async def test_a_file_that_changes_on_the_disk_is_judged_when_the_editor_says_so(tmp_path: Path) -> None:
    from lsprotocol import types

    specs = copied(tmp_path, "gizmo", "widget")
    async with editor(specs) as session:
        await session.opened(WIDGET)
        text = session.text(GIZMO).replace(ROW, EDITS["an unknown key"])
        (specs / GIZMO).write_text(text, "utf-8")
        event = types.FileEvent(session.uri(GIZMO), types.FileChangeType.Changed)
        session.client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams([event]))
        await session.findings(GIZMO)
        assert session.places() == expected_places(fresh(specs, {}))


@pytest.mark.proof
async def test_positions_stay_those_of_a_fresh_check_over_random_edits(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo", "widget")
    chance = random.Random(37)
    async with editor(specs) as session:
        texts = {name: session.text(name) for name in (GIZMO, WIDGET)}
        sound = dict(texts)
        for name in texts:
            await session.opened(name)
        for _ in range(60 if IS_WHOLE else 25):
            name = chance.choice([*texts])
            text = texts[name] if chance.random() < 0.8 else sound[name]
            start = chance.randrange(len(text))
            put = chance.choice(["", "", "长𝄞", "\t", "\r\n", "# ", ": ", "- ", "x", "7", "'"])
            texts[name] = text[:start] + put + text[start + chance.choice([0, 1, 1, 30]) :]
            await session.typed(name, texts[name])
            assert expected_places(fresh(specs, texts)) <= session.places()


async def test_a_document_that_is_no_spec_is_left_alone(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo")
    (specs.parent / "compose.yaml").write_text("services: {", "utf-8")
    async with editor_of_the_verb(specs) as session:
        await session.opened(GIZMO)
        session.version += 1
        from lsprotocol import types

        uri = (specs.parent / "compose.yaml").as_uri()
        item = types.TextDocumentItem(uri, "yaml", 1, "services: {")
        session.client.text_document_did_open(types.DidOpenTextDocumentParams(item))
        await session.typed(GIZMO, session.text(GIZMO))
        assert session.client.diagnostics.keys() == {session.uri(GIZMO)}
