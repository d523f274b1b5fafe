"""Where each byte of a frame lies, as tables."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.context import Context, many, names, sources
from fieldspec.backends.docs.document import Cell, Column, Item, Line, Row, Table, cell, code, plain, styled, table
from fieldspec.backends.docs.inferences import Inferences
from fieldspec.backends.docs.value_cells import VALUE_COLUMNS, meaning_cell, spoken, value_cells
from fieldspec.classes import dataclass
from fieldspec.layout.frame import LinkLayout, PartLayout
from fieldspec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.model.fact import Fact

CHECKS = {
    "crc16_modbus": "CRC-16 with polynomial 8005h, reflected, start value FFFFh, of all bytes",
    "lrc": "two's complement of the sum of all bytes",
    "sum8": "low byte of the sum of all bytes",
}
END_FIRST = {"big": "high", "little": "low"}

COLUMNS = (
    Column("Byte", "number", kept=True),
    Column("Field", kept=True),
    *VALUE_COLUMNS,
    Column("Meaning", "wide"),
    Column("Source", "source"),
)


@dataclass(frozen=True, slots=True)
class Position:
    """A place in a frame: `fixed` bytes and so many times the steps, as in `3 + 16k`."""

    fixed: int
    steps: tuple[tuple[int, str], ...] = ()

    def shifted(self, offset: int) -> Position:
        """The place `offset` bytes further."""
        return Position(self.fixed + offset, self.steps)

    def stepped(self, size: int, letter: str) -> Position:
        """The place of each of several elements."""
        return Position(self.fixed, (*self.steps, (size, letter)))

    def text(self, length: int, start: int = 0, width: int = 1) -> str:
        """`4`, `4..7`, `3 + 16k`: bytes, or characters where each byte is `width` of them behind `start`."""
        first = start + self.fixed * width
        last = first + length * width - 1
        steps = "".join(f" + {size * width if size * width > 1 else ''}{letter}" for size, letter in self.steps)
        if first == last:
            return f"{first}{steps}"
        return f"({first}..{last}){steps}" if steps else f"{first}..{last}"


class FrameTable:
    """A table of the bytes of one frame. Facts whose paths start with `anchored` get their anchors in it."""

    def __init__(self, context: Context, link: LinkLayout, direction: str, anchor: str, anchored: str) -> None:
        self.context, self.link, self.direction = context, link, direction
        self.shape = link.frame(direction)
        self.marks = Inferences(anchor)
        self.anchored = anchored
        characters = link.link.encoding == "hex_ascii"
        self.start, self.width = len(link.link.start), 2 if characters else 1
        self.unit = "Character" if characters else "Byte"

    def table(self, caption: str, record: RecordLayout | None, code: int | None = None) -> Table:
        """All parts of the frame in order, with the fields of a record where one is given."""
        start, end = self.link.link.start, self.link.link.end
        rows = [*self._mark("start", _span(0, len(start)), start)]
        rows += [self._part(part, Position(part.offset), record, code) for part in self.shape.head]
        rows += self._body(record)
        rows += self._tail(record)
        rows += self._mark("end", self._end(record), end)
        columns = (Column(self.unit, "number", kept=True), *COLUMNS[1:])
        return table(caption, columns, rows, self.marks.footnotes(), heading=1)

    def _mark(self, name: str, place: str, mark: bytes) -> Iterator[Row]:
        if mark:
            yield self._row(place, cell(name), cell((code(mark.hex(" ").upper()), plain(f", the {name} mark"))))

    def _end(self, record: RecordLayout | None) -> str:
        """The place of the end mark, counted from the end where the size of the body is open."""
        size = len(self.link.link.end)
        if record is None or record.size is None:
            return _from_end(size, size)
        return _span(self.start + (self.shape.head_size + record.size + self.shape.tail_size) * self.width, size)

    def _row(self, place: str, name: Cell, meaning: Cell) -> Row:
        return Row((cell(code(place)), name, Cell(), Cell(), Cell(), meaning, Cell()))

    def _part(self, part: PartLayout, position: Position, record: RecordLayout | None, code_held: int | None) -> Row:
        value = part.value
        inferred = part.part.inferred
        cells = value_cells(value, inferred, self.marks) if value else (_check_type(part), Cell(), Cell())
        return Row(
            (
                cell(code(position.text(part.size, self.start, self.width))),
                names(part.part, part.name, mark=self.marks.marks(inferred)),
                *cells,
                meaning_cell(self.context, part.part, value, *self._role(part, record, code_held)),
                sources(part.part),
            ),
            self._anchor(part.part),
        )

    def _role(self, part: PartLayout, record: RecordLayout | None, code_held: int | None) -> Iterator[Line]:
        """What a part holds by its role."""
        if part.role == "code" and code_held is not None:
            yield (code(f"0x{code_held:0{2 * part.size}X}"), plain(f" ({code_held})"))
        elif part.role == "code":
            yield (plain("the code of the message"),)
        elif part.role == "station" and not part.part.doc:
            yield (plain("the address of the device"),)
        elif part.role == "length":
            yield (plain(self._length(part, record)),)
        elif part.role == "check":
            order = f"; the {END_FIRST[part.order]} byte is sent first" if part.size > 1 else ""
            yield (plain(f"{CHECKS[part.algorithm]} {self._covered(part)}{order}"),)
        elif part.reserved:
            yield (styled("reserved", "badge"),)

    def _length(self, part: PartLayout, record: RecordLayout | None) -> str:
        around = self.shape.head_size + self.shape.tail_size
        if (part.unit_size, part.base) == (1, 0):
            return (
                "the length of the frame in bytes"
                if record is None
                else f"the length of the frame: {length_text(around, record)}"
            )
        unit = "words of two bytes" if part.unit_size > 1 else "bytes"
        more = part.part.plus
        added = f", {'plus' if more > 0 else 'minus'} {abs(more)}" if more else ""
        number = part.number(around + record.size) if record is not None and record.size is not None else None
        fixed = "" if number is None else f": {number}"
        return f"the number of {unit} {self._spanned(part)}{added}{fixed}"

    def _covered(self, part: PartLayout) -> str:
        """Over what a check is worked out."""
        return "before it" if (part.start, part.stop) == (0, part.offset) else self._spanned(part)

    def _spanned(self, part: PartLayout) -> str:
        """`from command to crc`: what a length counts or a check covers."""
        parts = self.link.link.parts(self.direction)
        first, last = self.link.link.span(self.direction, part.part) or (0, len(parts) - 1)
        return f"of {parts[first].name}" if first == last else f"from {parts[first].name} to {parts[last].name}"

    def _body(self, record: RecordLayout | None) -> Iterator[Row]:
        if record is not None:
            for field in record.fields:
                yield from field_rows(self, field, Position(self.shape.head_size), field.name, "k")
            return
        place = code(f"from {self.start + self.shape.head_size * self.width}")
        for part in self.link.link.parts(self.direction):
            if part.role == "body":
                meaning = meaning_cell(self.context, part, None, (plain("the data of the message"),))
                name = names(part, part.name)
                yield Row((cell(place), name, Cell(), Cell(), Cell(), meaning, sources(part)), self._anchor(part))

    def _tail(self, record: RecordLayout | None) -> Iterator[Row]:
        """The parts behind the body, counted from the end where the size of the body is open."""
        fixed = None if record is None or record.size is None else self.shape.head_size + record.size
        for part in self.shape.tail:
            row = self._part(part, Position(0), record, None)
            if fixed is None:
                behind = -part.offset * self.width + len(self.link.link.end)
                place = _from_end(behind, part.size * self.width)
            else:
                place = Position(fixed + self.shape.tail_size + part.offset).text(part.size, self.start, self.width)
            yield Row((cell(code(place)), *row.cells[1:]), row.anchor)

    def field_row(self, field: FieldLayout, position: Position, path: str, elements: str) -> Row:
        """The row of a field, or of each of its elements."""
        place = position.text(field.size, self.start, self.width)
        cells = field_cells(self.context, field, path, elements, self.marks)
        return Row((cell(code(place)), *cells), self._anchor(field.field))

    def _anchor(self, fact: Fact) -> str:
        return fact.place.path if self.anchored and fact.place.path.startswith(self.anchored) else ""


def _check_type(part: PartLayout) -> Cell:
    return cell((code(part.algorithm), plain(f" of {many(part.size, 'byte')}")))


def _span(first: int, length: int) -> str:
    return str(first) if length == 1 else f"{first}..{first + length - 1}"


def _from_end(behind: int, length: int) -> str:
    """The place of bytes that begin `behind` bytes before the end of a frame of n bytes."""
    return f"n - {behind}" if length == 1 else f"n - {behind} .. n - {behind - length + 1}"


def field_rows(holder: FrameTable, field: FieldLayout, start: Position, path: str, letter: str) -> Iterator[Row]:
    """The rows of a field: its own, or those of the record that it holds, once for all of its elements."""
    position = start.shifted(field.offset)
    elements = ""
    if field.listed:
        position = position.stepped(field.size, letter)
        path = f"{path}[{letter}]"
        elements = elements_text(field, letter)
    yield holder.field_row(field, position, path, elements)
    if field.record is not None:
        later = chr(ord(letter) + 1) if field.listed else letter
        for inner in field.record.fields:
            yield from field_rows(holder, inner, position, f"{path}.{inner.name}", later)


def field_cells(context: Context, field: FieldLayout, path: str, elements: str, marks: Inferences) -> tuple[Cell, ...]:
    """Name, type, unit, range, meaning and source of a field."""
    inferred = field.field.inferred
    more: list[Line] = [(styled(elements, "quiet"),)] if elements else []
    if field.field.reserved:
        more.append((styled("reserved", "badge"),))
    more += _relations(field)
    if field.cases:
        cells = (cell(items=[_case(field, case) for case in field.cases]), Cell(), Cell())
    elif field.record is not None:
        record = field.record.name
        cells = (cell((code(record, f"#records/{record}"), plain(f" of {many(field.size, 'byte')}"))), Cell(), Cell())
    else:
        assert field.value is not None
        cells = value_cells(field.value, inferred, marks)
    return (
        names(field.field, path, mark=marks.marks(inferred)),
        *cells,
        meaning_cell(context, field.field, field.value, *more),
        sources(field.field),
    )


def _case(field: FieldLayout, case: CaseLayout) -> Item:
    """The type in one case, and for which values of the other field it is so."""
    by = field.field.choice.by if field.field.choice else ""
    when = f" where {by} is {', '.join(case.case.when)}"
    return Item((code(case.value.type.name), plain(when)))


def _relations(field: FieldLayout) -> Iterator[Line]:
    """What a field has to do with other fields."""
    measures = field.field.measures
    if measures is not None:
        yield (plain(f"the number of {measures.of} of "), code(measures.field))
    if field.field.same_as:
        yield (plain("the same as "), code(field.field.same_as), plain(" of the request"))


def elements_text(field: FieldLayout, letter: str) -> str:
    """`k = 0..31`: the numbers of a field's elements."""
    repeat = field.field.repeat
    if repeat is not None:
        return f"{spoken(repeat.text())} elements, {letter} = 0, 1, .."
    return f"{field.count} elements, {letter} = 0 to {(field.count or 1) - 1}"


def length_text(around: int, record: RecordLayout) -> str:
    """`8 bytes`, or `5 + 2n bytes, n = 1 to 3`: the length of a frame with a record in its body."""
    if record.size is not None:
        return many(around + record.size, "byte")
    if record.chosen:
        most = f" to {around + record.most}" if record.most is not None else " or more"
        return f"{around + record.least}{most} bytes"
    last = record.fields[-1]
    step = f"{last.size}n" if last.size > 1 else "n"
    repeat = last.field.repeat
    assert repeat is not None
    return f"{around + last.offset} + {step} bytes, n = {spoken(repeat.text())}"
