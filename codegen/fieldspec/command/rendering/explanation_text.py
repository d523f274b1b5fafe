"""The explanation of a frame as text for people, and as data for JSON."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from itertools import groupby

from fieldspec.codec.explain.errata import citations, concerns_link
from fieldspec.codec.explain.examples import examples_of_bytes, printed
from fieldspec.codec.explain.explanation import Explanation, ExplanationRow, Meaning
from fieldspec.codec.explain.readings import ChosenReading
from fieldspec.codec.explain.recognition import Reading
from fieldspec.codec.explain.row import IDENTIFIER
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.rendering.blocks import Block, Line, Table, narrowed
from fieldspec.foundation.classes import replace
from fieldspec.language.model.address_space import BYTE, WORD
from fieldspec.language.model.texts import Example

_BYTES_A_LINE = 8
_NUMBERS_A_LINE = 8
_LIST = 3
_EXAMPLES = 3
_JUDGED = ("meaning", "check", "manual")


def title(layout: DeviceLayout, explanation: Explanation, sure: bool) -> str:
    """`write_register request, rtu, Gadget 2.0: Write one register`; without the message where that is not `sure`."""
    device = layout.device
    kind = (
        "exception response"
        if explanation.error
        else device.links[explanation.link].direction_name(explanation.direction)
    )
    name = f"{explanation.message or 'unknown'} {kind}" if sure else kind
    text = f"{name}, {explanation.link}, {device.name} {device.version}"
    message = layout.messages.get(explanation.message)
    message_title = message.message.title or message.message.label if message else ""
    return f"{text}: {message_title}" if message_title and sure else text


def accessed(layout: DeviceLayout, explanation: Explanation) -> str:
    """`reads 0x1000..0x1001`"""
    message = layout.messages[explanation.message].message
    accesses = message.single_access
    if message.access_steps:
        done = [step.operation for step in message.access_steps]
        done = [verb for verb in done if verb == "read" or explanation.direction == "request"]
        return f"{' and '.join(f'{verb}s' for verb in dict.fromkeys(done))} registers"
    first, last = explanation.accessed or (0, 0)
    span = f"0x{first:04X}" if first == last else f"0x{first:04X}..0x{last:04X}"
    return f"{accesses.operation}s {span}" if accesses else span


def faults(explanation: Explanation) -> Iterator[str]:
    """A line for each wrong or doubtful value."""
    for row in (*explanation.rows, *explanation.registers):
        if row.verdict.startswith("wrong"):
            preposition = "in" if row.can_place == IDENTIFIER else "at"
            place = f"{row.path} {preposition} {row.byte_text}" if row.path else row.byte_text
            doubtful = row.kind == "register" or row.reason == "out_of_range"
            yield f"{'doubtful' if doubtful else 'wrong'}: {place}: {row.verdict.removeprefix('wrong: ')}"


def frame_table(layout: DeviceLayout, explanation: Explanation) -> Table:
    """Every byte of the frame in order; neighbouring elements of a list share a row where they are only numbers."""
    shape = layout.links[explanation.link].frame(explanation.direction)
    checksums = {part.name for part in shape.checksums}
    code = shape.role("code")
    message = layout.messages.get(explanation.message)
    addresses = {code.name if code else "", *_in_digits(layout, explanation)}
    headings = ("at", "sent", "bytes", "field", "label", "raw", "value", *_JUDGED)
    lines: list[tuple[tuple[str, ...], bool]] = []
    for _, group in groupby(explanation.rows, key=_run):
        rows = list(group)
        if len(rows) >= _LIST:
            lines += _element_lines(rows)
            continue
        for row in rows:
            raw = "" if row.path in checksums else raw_text(row, row.path in addresses)
            number = row.number
            if code is not None and (code.form or row.can_place) and row.path == code.name and isinstance(number, int):
                raw = code.number_text(number)
            if code is not None and row.path == code.name and message is not None and not explanation.error:
                row = replace(row, meanings=(Meaning(message.name, message.message.label, "", ""),))
            first = (row.at, row.sent, _hex(row.raw), row.path, _label(row), raw, row.value)
            lines += _lines(row, first, 2, 5)
    return _table(headings, lines)


def _in_digits(layout: DeviceLayout, explanation: Explanation) -> Iterator[str]:
    """The fields that are best read in hexadecimal: addresses, words of bits, and numbers that the manual writes so.

    Numbers that are sent as characters are best read as these.
    """
    message = layout.messages.get(explanation.message)
    access = message.message.single_access if message else None
    for field in message.data(explanation.direction).fields if message and not explanation.error else ():
        value, number = field.value, explanation.values.get(field.name)
        if value is None or value.has_characters:
            continue
        if value.flags or (access is not None and field.name == access.start):
            yield field.name
        if value.parameter is not None and isinstance(number, int):
            match = layout.device.parameter_at(value.parameter.set, number)
            if value.parameter.part == "number" and (match is None or match[0].printed_as or match[0].base):
                yield field.name


def register_table(explanation: Explanation) -> Table:
    """The registers that the frame reads or writes."""
    counts = next((_count_name(row) for row in explanation.registers if row.unit), "words")
    headings = ("address", counts, "bytes", "register", "label", "access", "raw", "value", *_JUDGED)
    lines: list[tuple[tuple[str, ...], bool]] = []
    for row in explanation.registers:
        name = row.path or row.doc
        first = (f"0x{row.address:04X}", str(row.words), _hex(row.raw), name, _label(row), row.access)
        lines += _lines(row, (*first, raw_text(row, False), row.value), 2, 6)
    return _table(headings, lines)


def head_blocks(
    layout: DeviceLayout, reading: ChosenReading, remarks: Iterable[str], before: str = ""
) -> Iterator[Block]:
    """The interpretation of a frame, after a text `before`, and remarks."""
    explanation = reading.explanation
    own = explanation.link, explanation.direction
    sure = all((link, direction) != own for link, direction, _, _ in reading.alternatives)
    yield Line(before + title(layout, explanation, sure), "bold")
    yield from (Line(remark, "red" if reading.wrong else "yellow") for remark in remarks)


def body_blocks(layout: DeviceLayout, explanation: Explanation) -> Iterator[Block]:
    """The bytes of a frame with their meanings, its registers, faults, and examples."""
    yield frame_table(layout, explanation)
    if explanation.registers:
        yield Line(accessed(layout, explanation), "bold")
        yield register_table(explanation)
    yield from (Line(fault, "red") for fault in faults(explanation))
    yield from (Line(example, "dim") for example in examples(layout, explanation))


def whole_blocks(layout: DeviceLayout, reading: ChosenReading, remarks: Iterable[str]) -> Iterator[Block]:
    """All that is said of one frame by itself."""
    yield from head_blocks(layout, reading, remarks)
    yield from body_blocks(layout, reading.explanation)
    yield from map(Line, footnotes(layout, reading.explanation, all_errata=False))


def footnotes(layout: DeviceLayout, explanation: Explanation, all_errata: bool) -> Iterator[str]:
    """The notes and errata about the frame, each once: errata that concern a field on this link, or `all_errata`."""
    rows = (*explanation.rows, *explanation.registers)
    visited = set()
    for row in rows:
        for note in row.notes:
            if note not in visited:
                visited.add(note)
                yield f"note on {row.path or 'the frame'}: {note}"
    of_fields = {number for row in rows for number in row.errata}
    if not of_fields and not explanation.errata:
        return
    touching = [
        erratum for erratum in layout.device.errata if erratum.id in of_fields or erratum.id in explanation.errata
    ]
    link = layout.device.links[explanation.link]
    printed_ids = {
        erratum.id for erratum in touching if erratum.id in of_fields and concerns_link(layout.device, erratum, link)
    }
    if not all_errata and len(printed_ids) < len(touching):
        count = len(touching) - len(printed_ids)
        errata = "erratum" if count == 1 else "errata"
        yield f"{count} more {errata} about this message or other links; print them with --errata"
    for erratum in touching:
        if all_errata or erratum.id in printed_ids:
            pairs = erratum.printed.items()
            keys = ", ".join(f"{key} {'absent' if value is None else value}" for key, value in pairs)
            yield f"erratum {erratum.id}: " + (f"printed {keys}. " if keys else "") + erratum.reason


def examples(layout: DeviceLayout, explanation: Explanation) -> Iterator[str]:
    """The examples of the manual with this frame, and those that it misprints as this frame."""
    device = layout.device
    own = [example for example in examples_of_bytes(device, explanation.frame) if _is_alike(example, explanation)]
    same = [example for example in own if example.frame == explanation.frame]
    for example in same[:_EXAMPLES]:
        text = ", ".join(part for part in (f"example {example.id}", citations(example.sources)) if part)
        yield f"{text}: {example.title}" if example.title else text
    if len(same) > _EXAMPLES:
        yield f"{len(same) - _EXAMPLES} more examples have this frame"
    for example in own:
        print_ = printed(device, example)
        if example.frame != explanation.frame and print_.frame == explanation.frame.hex().upper():
            for erratum in print_.errata:
                yield f"erratum {erratum.id}: the manual prints this for {_hex(example.frame)}. {erratum.reason}"


def _is_alike(example: Example, explanation: Explanation) -> bool:
    """Whether an example has the link, direction and message of a frame."""
    example_key = (example.link, example.direction, example.message or explanation.message)
    return example_key == (explanation.link, explanation.direction, explanation.message)


def raw_text(row: ExplanationRow, hexadecimal: bool) -> str:
    """The raw value; words of bits and addresses in hexadecimal digits."""
    number = row.number
    if isinstance(number, bool):
        return "true" if number else "false"
    if number is None:
        return ""
    if isinstance(number, bytes):
        return _hex(number)
    if isinstance(number, int) and (hexadecimal or any(meaning.bits for meaning in row.meanings)):
        return f"0x{number & (1 << 8 * len(row.raw)) - 1:0{2 * len(row.raw)}X}"
    return str(number)


def meaning_text(meaning: Meaning) -> str:
    """`bit 3 ready 准备: switched on`, or `state: running 运行 (S3)`"""
    text = "" if meaning.text.replace(" ", "_") == meaning.name else meaning.text
    words = " ".join(word for word in (meaning.name, meaning.label) if word)
    if meaning.kind:
        printed_as = text.removeprefix(meaning.kind).strip()
        return f"{meaning.kind}: {words}" + (f" ({printed_as})" if printed_as else "")
    bits = f"bit {meaning.bits}" if meaning.bits.isdigit() else f"bits {meaning.bits}" if meaning.bits else ""
    head = " ".join(word for word in (bits, words) if word)
    return f"{head}: {text}" if head and text else head or text


def _run(row: ExplanationRow) -> object:
    """A key that is equal for neighbours that share a row: elements of one list without remarks."""
    name, bracket, _ = row.path.rpartition("[")
    is_number = row.path.endswith("]") and isinstance(row.number, int) and not isinstance(row.number, bool)
    remarks = row.value or row.meanings or row.verdict or row.notes
    return name if bracket and is_number and not remarks else id(row)


def _element_lines(rows: Sequence[ExplanationRow]) -> Iterator[tuple[tuple[str, ...], bool]]:
    """The lines of neighbouring elements of a list, some numbers a line."""
    for start in range(0, len(rows), _NUMBERS_A_LINE):
        part = rows[start : start + _NUMBERS_A_LINE]
        first, last = part[0], part[-1]
        name, _, index = first.path.rpartition("[")
        path = first.path if first is last else f"{name}[{index[:-1]}..{last.path.rpartition('[')[2]}"
        sent_text = " ".join(row.sent for row in part).strip()
        data = " ".join(row.raw.hex().upper() for row in part)
        numbers = " ".join(str(row.number) for row in part)
        source = "" if start else first.source
        yield (first.at, sent_text, data, path, "" if start else _label(first), numbers, "", "", "", source), False


def _lines(row: ExplanationRow, first: tuple[str, ...], data: int, raw: int) -> Iterator[tuple[tuple[str, ...], bool]]:
    """The lines of a row: several where the bytes in cell `data`, or in cell `raw`, or its meanings, are many."""
    meanings = [meaning_text(meaning) for meaning in row.meanings]
    chunks = _chunks(first[data])
    raw_chunks = _chunks(first[raw]) if isinstance(row.number, bytes) else [first[raw]]
    wrong = row.verdict.startswith("wrong")
    for number in range(max(1, len(meanings), len(chunks), len(raw_chunks))):
        cells = list(first) if number == 0 else [""] * len(first)
        cells[data] = chunks[number] if number < len(chunks) else ""
        cells[raw] = raw_chunks[number] if number < len(raw_chunks) else ""
        meaning = meanings[number] if number < len(meanings) else ""
        yield (*cells, meaning, *((row.verdict, row.source) if number == 0 else ("", ""))), wrong


def _table(headings: tuple[str, ...], lines: Sequence[tuple[tuple[str, ...], bool]]) -> Table:
    rows = tuple(cells for cells, _ in lines)
    return narrowed(Table(headings, rows, tuple("red" if wrong else "" for _, wrong in lines)))


def _label(row: ExplanationRow) -> str:
    return " ".join(text for text in (row.printed_name, row.label) if text)


def _hex(data: bytes) -> str:
    return data.hex(" ").upper()


def _chunks(text: str) -> list[str]:
    """The digits of bytes, cut into lines."""
    size = 3 * _BYTES_A_LINE
    return [text[start : start + size].strip() for start in range(0, len(text), size)]


# In JSON, bytes are a text of hexadecimal digits, and null is what does not apply.


def as_data(
    layout: DeviceLayout,
    explanation: Explanation,
    readings: Sequence[Reading],
    chosen: str,
    remarks: Sequence[str],
    wrong: bool,
) -> dict[str, object]:
    """An explanation as data: with the readings that fit, how one of them was chosen, and remarks on the input."""
    errata = {number for row in (*explanation.rows, *explanation.registers) for number in row.errata} | set(
        explanation.errata
    )
    return {
        "device": layout.device.id,
        "version": layout.device.version,
        "frame": _hex_text(explanation.frame),
        "link": explanation.link,
        "direction": explanation.direction,
        "direction_name": layout.device.links[explanation.link].direction_name(explanation.direction),
        "message": explanation.message or None,
        "error": explanation.error,
        "wrong": wrong,
        "reasons": list(explanation.reasons),
        "chosen": chosen,
        "readings": [_reading(reading) for reading in readings],
        "remarks": list(remarks),
        "values": _json_value(explanation.values),
        "rows": [_row_data(row) for row in explanation.rows],
        "registers": [_row_data(row) for row in explanation.registers],
        "errata": [
            {"id": erratum.id, "fact": erratum.fact, "printed": _printed(erratum.printed), "reason": erratum.reason}
            for erratum in layout.device.errata
            if erratum.id in errata
        ],
    }


def _reading(reading: Reading) -> dict[str, object]:
    link, direction, message, error = reading
    return {"link": link, "direction": direction, "message": message or None, "error": error}


def _count_name(row: ExplanationRow) -> str:
    """The name of the number of addresses of a register, which must not look like a number of bytes."""
    return "size" if row.unit == BYTE else f"{row.unit or WORD}s"


def _row_data(row: ExplanationRow) -> dict[str, object]:
    return {
        "kind": row.kind,
        "offset": row.offset,
        "can_place": row.can_place or None,
        "length": row.length,
        "raw": _hex_text(row.raw),
        "characters": row.characters or None,
        "path": row.path or None,
        "fact": row.fact or None,
        "printed_name": row.printed_name or None,
        "label": row.label or None,
        "doc": row.doc or None,
        "number": _json_value(row.number),
        "value": row.value or None,
        "meanings": [
            {
                "name": meaning.name or None,
                "label": meaning.label or None,
                "text": meaning.text or None,
                "bits": meaning.bits or None,
            }
            for meaning in row.meanings
        ],
        "verdict": row.verdict or None,
        "reason": row.reason or None,
        "source": row.source or None,
        "notes": list(row.notes),
        "errata": list(row.errata),
        "address": row.address,
        _count_name(row): row.words or None,
        "access": row.access or None,
    }


def _hex_text(data: bytes) -> str:
    return data.hex().upper()


def _json_value(value: object) -> object:
    """A raw value for JSON: bytes, and numbers that JSON does not have, as text."""
    if isinstance(value, bytes):
        return _hex_text(value)
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, list):
        return [_json_value(item) for item in value]
    if isinstance(value, dict):
        return {key: _json_value(item) for key, item in value.items()}
    return value


def _printed(printed: Mapping[str, object]) -> dict[str, object]:
    """The printed values, key by key; decimal numbers as text."""
    return {key: str(value) if isinstance(value, Decimal) else value for key, value in printed.items()}
