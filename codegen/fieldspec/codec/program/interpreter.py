"""Runs programs over bytes, and says which bytes gave what."""

from __future__ import annotations

from fieldspec.codec.layout.accepted import Condition, passes
from fieldspec.codec.layout.values import Raw
from fieldspec.codec.layout.widths import widened
from fieldspec.codec.program.operations import Each, Inner, Load, LoadVarying, Program, Remark, Require, Variable
from fieldspec.foundation import classes
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole
from fieldspec.language.model.raw_numbers import number_in
from fieldspec.language.model.text_form import decoded_text
from fieldspec.language.model.value import Value

Content = int | float | str | bytes


@dataclass(slots=True)
class Row:
    """What some bytes gave: `raw` from `offset` on are the content of a variable, number `index` of its field.

    The content is None where they are none of its digits or characters. Of a variable that varies in width `is_formed`
    says whether they are one at all. `beside` are the rows of the same record by the names of their fields. `failed` is
    the first condition that the content does not meet.
    """

    path: str
    index: int
    variable: Variable
    offset: int
    raw: bytes
    content: Content | None
    beside: dict[str, Row] = classes.field(repr=False)
    is_formed: bool = True
    failed: Condition | None = None

    @property
    def number(self) -> Raw:
        """What a reader gets: a truth value as such, and the bytes of what has no content."""
        if self.content is None:
            return self.raw
        encoding = self.variable.value.encoding
        match encoding:
            case Truth():
                return bool(self.content) if not self.variable.is_reserved and self.content in (0, 1) else self.content
            case Text():
                return self.raw if self.variable.is_reserved else self.content
            case Whole() | Real() | Digits() | Octets():
                return self.content
            case _:
                assert_never(encoding)


@dataclass(frozen=True, slots=True)
class Place:
    """The bytes of `data` from `start` to `stop`: element `index` of a field, whose name is between path and suffix."""

    data: bytes
    start: int
    stop: int
    path: str = ""
    suffix: str = ""
    index: int = 0


def read_value(program: Program, data: bytes) -> Row:
    """What all bytes of a value gave."""
    rows: list[Row] = []
    run(program, Place(data, 0, len(data)), rows, {})
    return rows[0]


def run(program: Program, place: Place, rows: list[Row], beside: dict[str, Row]) -> dict[str, Raw]:
    """The contents that a program gives, by name. Adds what gave them to `rows`, and to those of the same record."""
    values: dict[str, Raw] = {}
    for operation in program:
        match operation:
            case Load():
                own = place.data[place.start : place.start + len(operation.places)]
                content = content_of(operation.variable.value, bytes(own[byte] for byte in operation.places))
                values[operation.variable.name] = _noted(operation.variable, place, own, content, rows, beside)
            case LoadVarying():
                own = place.data[place.start : place.stop]
                image = widened(operation.variable.value, own)
                content = None if image is None else content_of(operation.variable.value, image)
                values[operation.variable.name] = _noted(operation.variable, place, own, content, rows, beside)
                rows[-1].is_formed = image is not None
            case Require() | Remark():
                if rows[-1].failed is None and not passes(operation.condition.test, rows[-1].content):
                    rows[-1].failed = operation.condition
            case Inner():
                path = f"{place.path}{operation.name}{place.suffix}."
                inner = Place(place.data, place.start, place.stop, path)
                values[operation.name] = run(operation.program, inner, rows, {})
            case Each():
                values[operation.name] = _elements(operation, place, rows, beside)
            case _:
                assert_never(operation)
    return values


def _elements(each: Each, place: Place, rows: list[Row], beside: dict[str, Row]) -> Raw:
    """What the elements of a field gave: a list, or of a field that is none the content itself."""
    first, size = place.start + each.offset, each.size
    elements: list[Raw] = []
    for index in range((place.stop - first) // size if each.count is None else each.count):
        start = first + index * size
        stop, suffix = (start + size, f"[{index}]") if each.is_list else (place.stop, "")
        element = Place(place.data, start, stop, place.path, suffix, index)
        elements.append(run(each.element, element, rows, beside)[each.name])
    return elements if each.is_list else elements[0]


def _noted(
    variable: Variable, place: Place, own: bytes, content: Content | None, rows: list[Row], beside: dict[str, Row]
) -> Raw:
    """Adds a row, and gives what a reader gets."""
    path = f"{place.path}{variable.name}{place.suffix}"
    row = beside[variable.name] = Row(path, place.index, variable, place.start, own, content, beside)
    rows.append(row)
    return row.number


def content_of(value: Value, data: bytes) -> Content | None:
    """What all bytes of a value are, in the order of places; None for digits, or characters, that are none of its."""
    encoding = value.encoding
    match encoding:
        case Whole() | Real() | Truth() | Digits():
            return number_in(value, data, "big", False)
        case Text():
            return decoded_text(value, "big", data)
        case Octets():
            return data
        case _:
            assert_never(encoding)
