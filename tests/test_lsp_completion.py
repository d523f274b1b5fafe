"""`fieldspec lsp` completes words by meaning: whatever stands in a spec is among what it offers there."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from lsprotocol import types

from editing import Editor, copied, editor, fresh, place_of
from fieldspec.command.editor.completion import suggestions
from fieldspec.command.editor.projects import EditedProject
from fieldspec.command.editor.typed_word import typed_word
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, children
from fieldspec.language.reading.references import unquoted
from fieldspec.language.reading.yaml_reader import key_spans

ROOT = Path(__file__).parent.parent
DEVICES = (*(("specs", name) for name in ("ck10", "esc11", "hiwin-e", "tc100")), ("tests/specs", "wattmeter"))
FREE = frozenset(("allow", "standard", "expected", "inferred", "was", "is"))
"""Keys whose own keys, or values, are texts of the spec."""
MEANT = frozenset(
    (
        *("enum", "flags", "record", "unit", "roles", "message", "messages", "link", "links", "since", "until", "only"),
        *("algorithm", "type", "access", "fact", "about", "proof", "protocol", "based_on", "reply_to", "copy_of"),
        *("space", "signal", "role", "task", "byte_order", "word_order", "confidence", "effect", "memory", "saved_by"),
    )
)
"""Keys whose values are names, paths, or words of the language."""

Spot = tuple[str, Span]
"""A word and its place."""


def spots(node: Node, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Spot]]:
    """The words of a file that can be completed, with the keys that lead to them."""
    if isinstance(node, Mapping) and FREE.isdisjoint(path):
        for key, span in key_spans(node):
            yield (*path, key, "key"), (key, span)
    for name, child in children(node):
        inner = (*path, name) if isinstance(name, str) else path
        if isinstance(child, Scalar) and {*inner[-1:]} <= MEANT and "printed" not in path and FREE.isdisjoint(path):
            yield (*inner, "value"), (child.text, unquoted(child))
        elif not isinstance(child, Scalar):
            yield from spots(child, inner)


@cache
def project(folder: str) -> EditedProject:
    result = EditedProject(ROOT / folder)
    result.read({})
    return result


@pytest.mark.proof(1)
@pytest.mark.parametrize(("folder", "device"), DEVICES, ids=lambda part: part)
def test_what_stands_in_a_spec_is_offered_there_also_where_the_text_ends_with_it(folder: str, device: str) -> None:
    # The judge is the author of the spec: one word of each kind of place.
    edited = project(folder)
    words: dict[tuple[str, ...], Spot] = {}
    for path, file in edited.memory.files.items():
        if path.startswith(f"{device}/") and file.tree is not None:
            for kind, spot in spots(file.tree, ()):
                words.setdefault(kind, spot)
    missed = []
    for kind, (word, span) in words.items():
        text = span.file.text
        step = word.partition("/")[0]  # a path is completed step by step
        for rest in (text[span.end :], ""):
            place = typed_word(edited, SourceFile(span.file.path, text[: span.start] + rest), span.start)
            offered = [suggestion.text.removesuffix(": ") for suggestion in suggestions(place)] if place else []
            if {word, step}.isdisjoint(offered):
                missed.append((kind, word, bool(rest)))
    assert missed == []
    assert len(words) > 25


# A word of a real device, what of it is typed, and words that stand there: by hand, one of each kind.
OFFERED = {
    "a role in a step": ("esc11/tasks.yaml", "send: homing_start", "send: |", {"homing_start", "messages"}),
    "a bit on a path": (
        "tc100/tasks.yaml",
        "registers/output_states/output_1",
        "registers/output_states/|",
        {"registers/output_states/output_1"},
    ),
    "a member in a condition": (
        "tc100/behaviour.yaml",
        "servo_enable: servo_on",
        "servo_enable: |",
        {"servo_on", "servo_off"},
    ),
    "a member that a rule sets": ("tc100/behaviour.yaml", "to: motion_command_while_moving", "to: |", {"no_fault"}),
    "a state machine": ("tc100/behaviour.yaml", "enter: servo,", "enter: |,", {"servo", "alarm"}),
    "a state that is entered": ("tc100/behaviour.yaml", "state: released}", "state: |}", {"released", "energized"}),
    "a state in a condition": (
        "tc100/behaviour.yaml",
        "state/servo: released",
        "state/servo: |",
        {"released", "energized"},
    ),
    "a bit of the cyclic message": (
        "hiwin-e/behaviour.yaml",
        "message/response/status_word_1/no_off2",
        "message/response/status_word_1/|",
        {"message/response/status_word_1/no_off2"},
    ),
    "a bit in an example": (
        "esc11/examples-move.yaml",
        "[executing, out_of_position]",
        "[executing, |]",
        {"out_of_position"},
    ),
    "a record with the same layout": ("esc11/points.yaml", "same_as: point", "same_as: |", {"point"}),
    "an address of the first row": (
        "tc100/registers-motion.yaml",
        "- at: 0x2000\n",
        "- {at: |, name: neu}\n      - at: 0x2000\n",
        {"0x2004"},
    ),
}
OVERLAY = """overlay: {id: "3.0", line: LINE, based_on: "2.0"}
adds: [{in: registers/motion, item: {at: ADDRESS, name: neu}}]
"""


@pytest.mark.parametrize("kind", OFFERED)
def test_names_in_tasks_behaviour_and_examples_are_offered(kind: str) -> None:
    path, sound, typed, expected = OFFERED[kind]
    edited = project("specs")
    text = edited.memory.files[path].file.text.replace(sound, typed, 1)
    word = typed_word(edited, SourceFile(path, text.replace("|", "")), text.index("|"))
    assert word is not None
    assert expected <= {suggestion.text for suggestion in suggestions(word)}


@pytest.mark.parametrize(("place", "expected"), [("LINE", {"firmware", "hardware"}), ("ADDRESS", {"0x204F"})])
def test_the_file_of_a_new_version_is_offered_its_line_and_addresses(place: str, expected: set[str]) -> None:
    edited = EditedProject(ROOT / "specs")
    path = "tc100/versions/3.0.yaml"  # it cannot be read yet
    edited.read({ROOT / "specs" / path: OVERLAY})
    word = typed_word(edited, SourceFile(path, OVERLAY.replace(place, "")), OVERLAY.index(place))
    assert word is not None
    assert expected <= {suggestion.text for suggestion in suggestions(word)}


GIZMO = "gizmo/device.yaml"
ROW = "      - {at: 0, name: speed, type: i16, unit: rpm, access: ro, source: L10}\n"


async def offered(session: Editor, name: str, text: str, mark: str = "|") -> dict[str, types.CompletionItem]:
    """What is offered where a text has a mark, by label."""
    offset = text.index(mark)
    text = text.replace(mark, "")
    await session.typed(name, text)
    document = types.TextDocumentIdentifier(session.uri(name))
    answer = await session.client.text_document_completion_async(
        types.CompletionParams(document, place_of(text, offset))
    )
    assert isinstance(answer, types.CompletionList)
    return {item.label: item for item in answer.items}


TYPED = {
    "a key within braces that are open": ("      - {at: 0, name: speed, |", "access"),
    "a key after Chinese texts": ("      - {at: 0, label: 速度𝄞, acc|", "access"),
    "a key on a line of its own": ("      - at: 0\n        name: speed\n        acc|\n", "access"),
    "a value that is empty": ("      - {at: 0, name: speed, access: |, type: i16}\n", "wo"),
    "a value within quotation marks": ('      - {at: 0, name: speed, access: "|", type: i16}\n', "wo"),
    "a value after an anchor": ("      - &row {at: 0, name: speed, type: |}\n      - *row\n", "u16"),
    "a value after tabs": ("      - {at: 0,\t\tname: speed,\ttype: |}\n", "u16"),
    "a unit": ("      - {at: 0, name: speed, unit: m|}\n", "mm/s"),
    "a rule that may be broken": ("      - {at: 0, name: speed, allow: {addr|}}\n", "addresses_disjoint"),
    "a role": ("      - {at: 0, name: speed, roles: [act|]}\n", "actual_speed"),
}


@pytest.mark.parametrize("ends", ["\n", "\r\n"], ids=["LF", "CRLF"])
async def test_a_word_is_completed_where_it_is_typed(tmp_path: Path, ends: str) -> None:
    specs = copied(tmp_path, "gizmo")
    async with editor(specs) as session:
        await session.opened(GIZMO)
        sound = session.text(GIZMO)
        for case, (row, word) in TYPED.items():
            text = sound.replace(ROW, row).replace("\n", ends)
            items = await offered(session, GIZMO, text)
            assert word in items, case
            edit = items[word].text_edit
            assert isinstance(edit, types.TextEdit)
            before = text.partition("|")[0].replace("\r\n", "\n")
            end = place_of(before, len(before))
            typed = len(before) - max(before.rfind(sign) for sign in ' [{"\t') - 1
            assert (edit.range.start, edit.range.end) == (types.Position(end.line, end.character - typed), end), case


async def test_addresses_that_are_offered_are_free_and_the_next_one_is_the_first(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo")
    async with editor(specs) as session:
        await session.opened(GIZMO)
        new = "      - {at: |, name: other, type: u16, access: ro, source: L10}\n"
        text = session.text(GIZMO).replace(ROW, ROW + new)
        addresses = [*await offered(session, GIZMO, text)]
    assert addresses
    for address in addresses:
        codes = {finding.code for finding in fresh(specs, {GIZMO: text.replace("|", address)})}
        assert "addresses_disjoint" not in codes, address
        taken = fresh(specs, {GIZMO: text.replace("|", hex(int(address, 0) - 1))})
        assert "addresses_disjoint" in {finding.code for finding in taken}, address


async def test_a_key_is_described_as_the_manual_of_the_language_has_it(tmp_path: Path) -> None:
    specs = copied(tmp_path, "gizmo")
    async with editor(specs) as session:
        await session.opened(GIZMO)
        items = await offered(session, GIZMO, session.text(GIZMO).replace(ROW, ROW.replace("access: ro", "|")))
        document = types.TextDocumentIdentifier(session.uri(GIZMO))
        await session.typed(GIZMO, session.text(GIZMO))
        position = place_of(session.text(GIZMO), session.text(GIZMO).index("access: ro"))
        hover = await session.client.text_document_hover_async(types.HoverParams(document, position))
    assert hover is not None
    assert items["access"].documentation == hover.contents
    assert "at" not in items  # it is there already


async def test_steps_and_examples_are_offered_members_and_special_values(tmp_path: Path) -> None:
    edited = project("tests/specs")
    file = edited.memory.files["widget/examples.yaml"].file
    start = file.text.index("color: ") + len("color: ")
    word = typed_word(edited, SourceFile(file.path, file.text[:start]), start)
    assert word is not None
    members = {"red", "green"}
    assert members <= {suggestion.text for suggestion in suggestions(word)}
