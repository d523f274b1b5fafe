"""The example frames, byte by byte, misprints beside what is right."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import SequenceMatcher

from fieldspec.codec.explain.examples import Printed, explained_example, printed
from fieldspec.codec.explain.explanation import Explanation, Meaning
from fieldspec.codec.explain.row import DLC, IDENTIFIER
from fieldspec.codec.explain.row import ExplanationRow as ByteRow
from fieldspec.codec.layout.values import Raw
from fieldspec.language.model.link import Link
from fieldspec.language.model.record import Message
from fieldspec.language.model.texts import Erratum, Example
from fieldspec.targets.docs.context import Context, address, cited
from fieldspec.targets.docs.document import (
    Cell,
    DocumentTable,
    Facts,
    Line,
    Paragraph,
    Section,
    Strip,
    Strips,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    label,
    styled,
    table,
    text_piece,
)

BYTES = (
    TableColumn("Byte", "number", unbroken=True),
    TableColumn("Bytes", "bytes", unbroken=True),
    TableColumn("Characters", "bytes"),
    TableColumn("Field", unbroken=True),
    TableColumn("Raw", "number", unbroken=True),
    TableColumn("Value", "number"),
    TableColumn("Meaning", "wide"),
    TableColumn("Verdict"),
    TableColumn("Source", "source"),
)
REGISTERS = (
    TableColumn("Address", "number", unbroken=True),
    TableColumn("Words", "number", unbroken=True),
    TableColumn("Register", unbroken=True),
    TableColumn("Bytes", "bytes"),
    TableColumn("Raw", "number"),
    TableColumn("Value", "number"),
    TableColumn("Meaning", "wide"),
    TableColumn("Verdict"),
    TableColumn("Source", "source"),
)
REFUSALS = {
    "incomplete": "it is incomplete",
    "wrong_length": "its length is wrong",
    "wrong_mark": "a delimiter is wrong or missing",
    "not_hex": "a character is not a hexadecimal digit",
    "wrong_checksum": "its checksum is wrong",
    "unknown_code": "its code is unknown",
    "unknown_value": "a value is not a member of its enum",
    "wrong_const": "a constant has a different value",
    "wrong_measure": "a field that measures another one is wrong",
    "out_of_range": "a value is out of range",
}


def examples(context: Context) -> Section:
    """All example frames in the order of the manual."""
    inner = tuple(_example(context, example) for example in sorted(context.device.examples.values(), key=_line))
    return Section("examples", (text_piece("Example frames"),), (), inner)


def _line(example: Example) -> tuple[bool, int]:
    return not example.sources, example.sources[0].first() if example.sources else 0


def _example(context: Context, example: Example) -> Section:
    explanation = explained_example(context.layout, example)
    print_of = printed(context.device, example)
    link, message = context.device.links[example.link], context.device.messages.get(example.message)
    holds = context.holding.lines(example.place.path)
    facts = tuple(_facts(example, link, message, holds))
    return context.holding.section(
        example.place.path,
        (example, explanation, print_of, facts),
        lambda: _section(example, explanation, print_of, facts),
    )


def _section(
    example: Example, explanation: Explanation, print_of: Printed, facts: tuple[tuple[str, tuple[Line, ...]], ...]
) -> Section:
    blocks: list[Paragraph | Facts | Strips | DocumentTable] = []
    blocks += [Paragraph(_erratum_line(erratum), "erratum") for erratum in print_of.errata]
    blocks += [Paragraph((styled("Note: ", "strong"), text_piece(note))) for note in example.notes]
    blocks.append(Strips(tuple(_strips(example, print_of, explanation))))
    blocks.append(Facts(facts))
    rows = [_byte_row(row) for row in explanation.rows]
    blocks.append(table("The meaning of the bytes", BYTES, rows, heading=3))
    if explanation.registers:
        touched = [_register_row(row) for row in explanation.registers]
        blocks.append(table("Registers that the frame accesses", REGISTERS, touched, heading=2))
    title: list[Line] = [(code(example.id),)]
    if example.title:
        title.append((text_piece(example.title),))
    if print_of.verdict != "ok":
        title.append((styled(print_of.verdict, "badge"),))
    return Section(example.place.path, joined(title, " "), tuple(blocks))


def _erratum_line(erratum: Erratum) -> Line:
    return (
        styled("Erratum ", "strong"),
        text_piece(erratum.id, f"#errata/{erratum.id}"),
        text_piece(f": {erratum.reason}"),
    )


def _strips(example: Example, print_of: Printed, explanation: Explanation) -> Iterator[Strip]:
    """The right bytes, above them what is printed where it differs, and the characters where a byte is two."""
    right = _pairs(example.frame.hex())
    as_printed = _pairs(print_of.frame)
    if print_of.frame and as_printed != right:
        yield Strip("printed", _marked_differences(as_printed, right))
        yield Strip("right", _marked_differences(right, as_printed))
    else:
        yield Strip(
            "computed, not printed" if example.origin == "computed" else "frame", _marked_differences(right, right)
        )
    if any(row.characters and len(row.characters) == row.length for row in explanation.rows):
        characters = example.frame.decode("latin-1")
        if print_of.characters and print_of.characters != characters:
            yield Strip("characters as printed", (code(_characters(print_of.characters)),))
        yield Strip("characters", (code(_characters(characters)),))


def _pairs(text: str) -> list[str]:
    """Hexadecimal bytes, two digits each."""
    digits = "".join(text.split()).upper()
    return [digits[index : index + 2] for index in range(0, len(digits), 2)]


def _marked_differences(first: list[str], other: list[str]) -> Line:
    """Bytes, those marked that the other frame does not have."""
    if first == other:
        return tuple(styled(pair, "code") for pair in first)
    pieces = []
    for change, start, end, _, _ in SequenceMatcher(None, first, other, autojunk=False).get_opcodes():
        style = "code" if change == "equal" else "changed"
        pieces += [styled(pair, style) for pair in first[start:end]]
    return tuple(pieces)


def _characters(text: str) -> str:
    return text.replace("\r", "\\r").replace("\n", "\\n")


def _facts(
    example: Example, link: Link, message: Message | None, holds: tuple[Line, ...]
) -> Iterator[tuple[str, tuple[Line, ...]]]:
    text = f"{example.direction} on " if not example.exception_response else "refusal on "
    yield "Frame", ((text_piece(text), text_piece(link.title or link.name, f"#{link.place.path}")),)
    if message is not None:
        yield "Message", ((code(message.name, f"#{message.place.path}"),),)
    if example.refused:
        yield "Must be refused", ((text_piece(REFUSALS[example.refused]),),)
    if example.reply_to:
        yield "Answers", ((text_piece(example.reply_to, f"#examples/{example.reply_to}"),),)
    if example.elided:
        names = joined((code(name),) for name in example.elided)
        yield "Printed as dots", ((*names, text_piece("; these values are our own")),)
    if holds:
        yield "Versions", holds
    if example.sources:
        yield "Source", (cited(example.sources),)


def raw_text(number: Raw | None) -> str:
    """A raw value as text."""
    if number is None:
        return ""
    if isinstance(number, bytes):
        return number.hex(" ").upper()
    return {True: "1", False: "0"}[number] if isinstance(number, bool) else str(number)


def _byte_row(row: ByteRow) -> TableRow:
    is_named = row.can_place in (IDENTIFIER, DLC)
    place = row.at if row.length < 2 or is_named else f"{row.at}..{int(row.at) + row.length - 1}"
    name = code(row.path, f"#{row.fact}" if row.fact else "") if row.path else styled("left over", "wrong")
    return TableRow(
        (
            cell(code(place)),
            cell(code(row.raw.hex(" ").upper())),
            cell(code(_characters(row.sent))),
            cell(name, label(row.label)),
            *_value_cells(row),
        )
    )


def _register_row(row: ByteRow) -> TableRow:
    name = code(row.path, f"#{row.fact}") if row.path else text_piece(row.doc)
    bytes_text = row.raw.hex(" ").upper() if len(row.raw) <= 32 else f"{len(row.raw)} bytes"
    return TableRow(
        (
            cell(code(address(row.address or 0))),
            cell(str(row.words)),
            cell(name, label(row.label)),
            cell(code(bytes_text)),
            *_value_cells(row),
        )
    )


def _value_cells(row: ByteRow) -> tuple[Cell, ...]:
    return (
        cell(raw_text(row.number)),
        cell(row.value),
        cell(*(_meaning(meaning) for meaning in row.meanings)),
        cell(_verdict(row.verdict), *_errata(row)),
        cell(row.source),
    )


def _verdict(verdict: str) -> Line:
    return (styled(verdict, "right" if verdict == "right" else "wrong"),) if verdict else ()


def _errata(row: ByteRow) -> list[Line]:
    links = ((text_piece(erratum_id, f"#errata/{erratum_id}"),) for erratum_id in row.errata)
    return [(styled("Erratum: ", "quiet"), *joined(links))] if row.errata else []


def _meaning(meaning: Meaning) -> Line:
    parts: list[Line] = []
    if meaning.bits:
        parts.append((styled(f"bit {meaning.bits}" if meaning.bits.isdigit() else f"bits {meaning.bits}", "quiet"),))
    if meaning.name:
        parts.append((code(meaning.name),))
    if meaning.label:
        parts.append((label(meaning.label),))
    if meaning.text:
        parts.append((text_piece(meaning.text),))
    return joined(parts, " ")
