"""Links: frames, stations, serial settings, and where each byte of a frame lies."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.foundation.classes import replace
from fieldspec.foundation.line_text import plural
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.link import Link, Part
from fieldspec.targets.docs.checksums import DIGITS, checksum_text
from fieldspec.targets.docs.context import Context, names, sources
from fieldspec.targets.docs.document import (
    Cell,
    DocumentTable,
    Facts,
    Item,
    Line,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    styled,
    table,
    text_piece,
)
from fieldspec.targets.docs.link_settings import link_facts
from fieldspec.targets.docs.positions import Position, placed_fields
from fieldspec.targets.docs.sources import Inferences
from fieldspec.targets.docs.value_cells import VALUE_COLUMNS, case_lines, meaning_cell, spoken, value_cells

END_FIRST = {"big": "high", "little": "low"}

COLUMNS = (
    TableColumn("Byte", "number", unbroken=True),
    TableColumn("Field", unbroken=True),
    *VALUE_COLUMNS,
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)


def _place(part: PartLayout, place: str) -> str:
    """`bits 7..10` of a CAN identifier, `2, bits 0..4` of bytes that parts share; the place for others."""
    if part.part.bits is None:
        return place
    first, last = part.part.bits
    bits = f"bit {first}" if first == last else f"bits {first}..{last}"
    return f"{place}, {bits}" if part.width else bits


class FrameTable:
    """A table of the bytes of one frame. Facts whose paths start with `anchored` get their anchors in it."""

    def __init__(self, context: Context, link: LinkLayout, direction: str, anchor: str, anchored: str) -> None:
        self.context, self.link, self.direction = context, link, direction
        self.shape = link.frame(direction)
        self.marks = Inferences(anchor)
        self.anchored = anchored
        characters = link.link.transmission == "hex_ascii"
        self.start, self.width = len(self.shape.further) + len(self.shape.start), 2 if characters else 1
        if link.link.escape is not None and link.link.is_can:
            self.start = -link.link.escape.fields_size  # places are those in the data, after the identifier
        self.unit = "Character" if characters else "Byte"

    def table(self, caption: str, record: RecordLayout | None, code: int | None = None) -> DocumentTable:
        """All parts of the frame in order, with the fields of a record where one is given."""
        preamble, (start, end) = self.shape.preamble, self.link.link.marks(self.direction)
        size = self.start - len(start)
        rows: list[TableRow] = []
        if preamble is not None:
            rows.append(self._frame_row(_span(0, size), cell("preamble"), cell((text_piece(preamble.text()),))))
        rows += self._mark("start", _span(max(size, 0), len(start)), start)
        rows += [self._part(part, Position(part.offset), record, code) for part in self.shape.header]
        rows += self._body(record)
        rows += self._tail(record)
        rows += self._mark("end", self._end(record), end)
        columns = (TableColumn(self.unit, "number", unbroken=True), *COLUMNS[1:])
        return replace(table(caption, columns, rows, self.marks.footnotes(), heading=1), style="frame")

    def _mark(self, name: str, place: str, mark: bytes) -> Iterator[TableRow]:
        if mark:
            delimiter = code(mark.hex(" ").upper()), text_piece(f", the {name} delimiter")
            yield self._frame_row(place, cell(name), cell(delimiter))

    def _end(self, record: RecordLayout | None) -> str:
        """The place of the end mark, counted from the end where the size of the body is open."""
        size = len(self.shape.end)
        if record is None or record.size is None:
            return _from_end(size, size)
        return _span(self.start + (self.shape.header_size + record.size + self.shape.trailer_size) * self.width, size)

    def _frame_row(self, place: str, name: Cell, meaning: Cell) -> TableRow:
        return TableRow((cell(code(place)), name, Cell(), Cell(), Cell(), meaning, Cell()))

    def _part(
        self, part: PartLayout, position: Position, record: RecordLayout | None, message_code: int | None
    ) -> TableRow:
        parts = self.context.device.links[self.link.name].parts(self.direction)
        value = next(stated.value for stated in parts if stated.name == part.name)
        inferred = part.part.inferred
        cells = value_cells(value, inferred, self.marks) if value else (_check_type(part), Cell(), Cell())
        return TableRow(
            (
                cell(code(_place(part, position.text(part.size, self.start, self.width)))),
                names(part.part, part.name, mark=self.marks.marks(inferred)),
                *cells,
                meaning_cell(self.context, part.part, value, *self._role(part, record, message_code)),
                sources(part.part),
            ),
            self._anchor(part.part),
        )

    def _role(self, part: PartLayout, record: RecordLayout | None, message_code: int | None) -> Iterator[Line]:
        """The description of a frame part's content, by its role."""
        if part.role == "code" and message_code is not None:
            in_decimal = () if part.form == "decimal" else (text_piece(f" ({message_code})"),)
            yield (code(part.number_text(message_code)), *in_decimal)
        elif part.role == "code":
            yield (text_piece("the code of the message"),)
        elif part.role == "unit_address" and not part.part.doc:
            yield (text_piece("the address of the device"),)
        elif part.role == "length":
            yield (text_piece(self._length(part, record)),)
        elif part.role == "checksum":
            order = f"; the {END_FIRST[part.order]} byte is sent first" if part.size > 1 else ""
            order = f"; {DIGITS[part.digits]}" if part.digits else order
            yield (text_piece(f"{checksum_text(part)} {self._covered(part)}{order}"),)
        elif part.reserved:
            yield (styled("reserved", "badge"),)
        elif part.part.same_as:
            yield (text_piece("the same as "), code(part.part.same_as), text_piece(" of the request"))

    def _length(self, part: PartLayout, record: RecordLayout | None) -> str:
        parts_size = self.shape.header_size + self.shape.trailer_size
        if (part.unit_size, part.base) == (1, 0):
            return (
                "the length of the frame in bytes"
                if record is None
                else f"the length of the frame: {length_text(parts_size, record)}"
            )
        unit = "words of two bytes" if part.unit_size > 1 else "bytes"
        plus = part.part.plus
        added = f", {'plus' if plus > 0 else 'minus'} {abs(plus)}" if plus else ""
        number = part.number(parts_size + record.size) if record is not None and record.size is not None else None
        fixed = "" if number is None else f": {number}"
        return f"the number of {unit} {self._span_text(part)}{added}{fixed}"

    def _covered(self, part: PartLayout) -> str:
        """The parts over which a checksum is computed, in words."""
        return "before it" if (part.start, part.stop) == (0, part.offset) else self._span_text(part)

    def _span_text(self, part: PartLayout) -> str:
        """`from command to crc`: what a length counts or a check covers."""
        parts = self.link.link.parts(self.direction)
        first, last = self.link.link.span(self.direction, part.part) or (0, len(parts) - 1)
        return f"of {parts[first].name}" if first == last else f"from {parts[first].name} to {parts[last].name}"

    def _body(self, record: RecordLayout | None) -> Iterator[TableRow]:
        if record is not None:
            for field, start in placed_fields(record):
                yield from field_rows(self, field, start.shifted(self.shape.header_size), field.name, "k")
            return
        place = code(f"from {self.start + self.shape.header_size * self.width}")
        for part in self.link.link.parts(self.direction):
            if part.role == "body":
                meaning = meaning_cell(self.context, part, None, (text_piece("the data of the message"),))
                name = names(part, part.name)
                yield TableRow((cell(place), name, Cell(), Cell(), Cell(), meaning, sources(part)), self._anchor(part))

    def _tail(self, record: RecordLayout | None) -> Iterator[TableRow]:
        """The parts after the body, counted from the end where the size of the body is open."""
        fixed = None if record is None or record.size is None else self.shape.header_size + record.size
        for part in self.shape.trailer:
            row = self._part(part, Position(0), record, None)
            if fixed is None:
                distance = -part.offset * self.width + len(self.shape.end)
                place = _from_end(distance, part.size * self.width)
            else:
                place = Position(fixed + self.shape.trailer_size + part.offset).text(part.size, self.start, self.width)
            yield TableRow((cell(code(place)), *row.cells[1:]), row.anchor)

    def field_row(self, field: FieldLayout, position: Position, path: str, elements: str) -> TableRow:
        """The row of a field, or of each of its elements."""
        place = position.text(field.size, self.start, self.width)
        if differs_in_size(field) or (field.value is not None and field.value.width):
            place = f"from {position.text(1, self.start, self.width)}"
        cells = field_cells(self.context, field, path, elements, self.marks)
        return TableRow((cell(code(place)), *cells), self._anchor(field.field))

    def _anchor(self, fact: Fact) -> str:
        return fact.place.path if self.anchored and fact.place.path.startswith(self.anchored) else ""


def _check_type(part: PartLayout) -> Cell:
    return cell((code(part.algorithm), text_piece(f" of {plural(part.size, 'byte')}")))


def _span(first: int, length: int) -> str:
    return str(first) if length == 1 else f"{first}..{first + length - 1}"


def _from_end(distance: int, length: int) -> str:
    """The place of bytes that begin `distance` bytes before the end of a frame of n bytes."""
    return f"n - {distance}" if length == 1 else f"n - {distance} .. n - {distance - length + 1}"


def field_rows(holder: FrameTable, field: FieldLayout, start: Position, path: str, letter: str) -> Iterator[TableRow]:
    """The row of a field; of a field that is a record, the rows of the record, once for all elements."""
    position = start
    elements = ""
    if field.is_list:
        position = element_position(field, start, letter)
        path = f"{path}[{letter}]"
        elements = elements_text(field, letter)
    yield holder.field_row(field, position, path, elements)
    if field.record is not None:
        later = chr(ord(letter) + 1) if field.is_list else letter
        for inner, place in placed_fields(field.record):
            inner_start = Position(position.fixed + place.fixed, (*position.steps, *place.steps))
            yield from field_rows(holder, inner, inner_start, f"{path}.{inner.name}", later)


def element_position(field: FieldLayout, start: Position, letter: str) -> Position:
    """Where each element of a list begins."""
    return start.stepped(*((1, f"bytes of earlier {field.name}") if differs_in_size(field) else (field.size, letter)))


def field_cells(context: Context, field: FieldLayout, path: str, elements: str, marks: Inferences) -> tuple[Cell, ...]:
    """Name, type, unit, range, meaning and source of a field."""
    inferred = field.field.inferred
    lines: list[Line] = [(styled(elements, "quiet"),)] if elements else []
    if field.field.reserved:
        lines.append((styled("reserved", "badge"),))
    lines += _relations(field)
    if field.cases:
        cells = (cell(items=[_case(context, field, case) for case in field.cases]), Cell(), Cell())
    elif field.record is not None:
        record = field.record.name
        cells = (
            cell((code(record, f"#records/{record}"), text_piece(f" of {_bytes_of(field.record)}"))),
            Cell(),
            Cell(),
        )
    else:
        assert field.value is not None
        cells = value_cells(field.value, inferred, marks)
    return (
        names(field.field, path, mark=marks.marks(inferred)),
        *cells,
        meaning_cell(context, field.field, field.value, *lines),
        sources(field.field),
    )


def separator(record: RecordLayout) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """What stands between the fields of a record, where it says so once."""
    if record.record.separator:
        yield "Separator", ((code(record.record.separator.hex(" ").upper()), text_piece(" between each two fields")),)


def differs_in_size(field: FieldLayout) -> bool:
    """Whether the elements of a list are records that differ in size, or numbers that share bytes."""
    return field.packing is not None or (field.record is not None and field.record.size is None)


def _bytes_of(record: RecordLayout) -> str:
    return plural(record.size, "byte") if record.size is not None else f"{record.least} to {record.most} bytes"


def _case(context: Context, field: FieldLayout, case: CaseLayout) -> Item:
    """The type of one case of a choice with the members of the deciding field for which it holds, and its meaning."""
    selector = field.field.choice.subject if field.field.choice is not None else ""
    condition = f" where {selector} is {', '.join(case.case.when)}"
    kind, *lines = case_lines(context, case.case, case.value)
    meaning = (piece for line in lines for piece in (text_piece("; "), *line))
    return Item((*kind, text_piece(condition), *meaning))


def _relations(field: FieldLayout) -> Iterator[Line]:
    """The relations of a field to others: what it measures, what says that it is sent, and what it repeats."""
    measures = field.field.stated_measure
    if measures is not None:
        adjustment = (text_piece(f" {'plus' if measures.plus > 0 else 'less'} {abs(measures.plus)}"),) * bool(
            measures.plus
        )
        bits = f"in bits {measures.bits[0]}..{measures.bits[1]}: " if measures.bits is not None else ""
        yield (text_piece(f"{bits}the number of {measures.of} of "), code(measures.field), *adjustment)
    if field.field.presence is not None:
        yield (text_piece(f"sent if {field.field.presence.condition}"),)
    if field.field.continuation is not None:
        yield (text_piece(f"after an element, another one follows if {field.field.continuation.condition}"),)
    if field.field.same_as:
        yield (text_piece("the same as "), code(field.field.same_as), text_piece(" of the request"))


def elements_text(field: FieldLayout, letter: str) -> str:
    """`k = 0..31`: the numbers of a field's elements."""
    repeat = field.field.repeat
    if field.field.is_optional:
        return "at most one element"
    if repeat is not None:
        return f"{spoken(repeat.text())} elements, {letter} = 0, 1, .."
    return f"{field.count} elements, {letter} = 0 to {(field.count or 1) - 1}"


def length_text(framing_size: int, record: RecordLayout) -> str:
    """`8 bytes`, or `5 + 2n bytes, n = 1 to 3`: the length of a frame with a record in its body."""
    if record.least == record.most:
        return plural(framing_size + record.least, "byte")
    if record.chosen:
        upper_end = f" to {framing_size + record.most}" if record.most is not None else " or more"
        return f"{framing_size + record.least}{upper_end} bytes"
    if record.spans or not record.has_single_list:
        return f"{framing_size + record.least} to {framing_size + (record.most or 0)} bytes"
    last = record.fields[-1]
    step = f"{last.size}n" if last.size > 1 else "n"
    repeat = last.field.repeat
    assert repeat is not None
    return f"{framing_size + last.offset} + {step} bytes, n = {spoken(repeat.text())}"


def links(context: Context) -> Section:
    """The section of all links: their frames, settings and times."""
    inner = tuple(_link(context, link_layout) for link_layout in context.layout.links.values())
    return Section("links", (text_piece("Links"),), (), inner)


def _link(context: Context, link_layout: LinkLayout) -> Section:
    link = link_layout.link
    blocks = context.opening(link)
    blocks.append(Facts(tuple(link_facts(link))))
    if _has_equal_parts(link):
        frame = FrameTable(context, link_layout, "request", f"{link.place.path}/frame", "links/")
        blocks.append(frame.table("Requests and responses", None))
    else:
        for direction, title in (("request", "Requests"), ("response", "Responses")):
            anchor = f"{link.place.path}/{direction}-frame"
            blocks.append(FrameTable(context, link_layout, direction, anchor, "links/").table(title, None))
    if link.exception_response is not None:
        anchor = f"{link.place.path}/refusal-frame"
        body = context.layout.records[link.exception_response.record]
        frame = FrameTable(context, link_layout, "response", anchor, "")
        blocks.append(frame.table("Exception responses", body))
    return Section(link.place.path, context.section_title(link.title or link.name, link), tuple(blocks))


def _has_equal_parts(link: Link) -> bool:
    """Whether requests and responses have the same parts."""

    def facts_of(part: Part) -> tuple[object, ...]:
        return (
            (
                part.name,
                part.role,
                part.value,
                part.algorithm,
                part.byte_order,
                part.reserved,
                part.same_as,
                part.digits,
            ),
            (part.span, part.unit_size, part.plus),
            (part.doc, part.label, part.notes, part.sources),
        )

    return [facts_of(part) for part in link.request] == [facts_of(part) for part in link.response]
