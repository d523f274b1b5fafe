"""Runs programs over bytes, and says which bytes gave what."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.accepted import Condition, passes
from fieldspec.codec.layout.inner_lists import InnerLists
from fieldspec.codec.layout.list_extents import ListExtent
from fieldspec.codec.layout.presence import masked
from fieldspec.codec.layout.values import Raw
from fieldspec.codec.layout.widths import widened
from fieldspec.codec.program.operations import (
    Decided,
    Each,
    Inner,
    Load,
    LoadPacked,
    LoadVarying,
    Program,
    Remark,
    Require,
    Variable,
)
from fieldspec.foundation import classes
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole
from fieldspec.language.model.raw_numbers import number_in
from fieldspec.language.model.text_form import decoded_text
from fieldspec.language.model.value import Value

Content = int | float | str | bytes


@dataclass(slots=True)
class Row:
    """What some bytes gave: `raw` from `offset` on are the content of a variable, number `index` of its field.

    The content is None if the bytes are not valid digits or characters. `image` are the bytes of a value in the image
    of its record; None for invalid digits. `rows_beside` are the rows of the same record by the names of their fields.
    `failed` is the first condition that the content does not meet.
    """

    path: str
    index: int
    variable: Variable
    offset: int
    raw: bytes
    image: bytes | None
    content: Content | None
    rows_beside: dict[str, Row] = classes.field(repr=False)
    failed: Condition | None = None

    @property
    def number(self) -> Raw:
        """The result for a reader: a truth value as such, and the bytes of values without content."""
        if self.content is None:
            return self.raw if self.image is None else self.image
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


def run(
    program: Program, place: Place, rows: list[Row], rows_beside: dict[str, Row], lists: InnerLists | None = None
) -> dict[str, Raw]:
    """The contents that a program gives, by name. Adds their origins to `rows`, and to the rows of the same record.

    `lists` are the lists of a record that differs in size, whose size has been judged.
    """
    values: dict[str, Raw] = {}
    extents: dict[str, ListExtent] = {}
    if lists is not None:
        own, _ = lists.extents_in(place.data[place.start : place.stop])
        extents = {inner.name: extent for inner, extent in zip(lists.lists, own, strict=True)}
    start = place.start
    for part in program:
        operation = _decided(part, rows_beside) if isinstance(part, Decided) else part
        match operation:
            case Load() | LoadPacked() | LoadVarying():
                row = rows_beside[operation.variable.name] = _loaded(operation, place, rows_beside)
                rows.append(row)
                values[operation.variable.name] = row.number
            case Require() | Remark():
                if rows[-1].failed is None and not passes(operation.condition.test, rows[-1].content):
                    rows[-1].failed = operation.condition
            case Inner():
                inner = Place(place.data, place.start, place.stop, f"{place.path}{operation.name}{place.suffix}.")
                values[operation.name] = run(operation.program, inner, rows, {}, operation.lists)
            case Each():
                is_open = operation.count is None or (lists is None and not operation.is_list)
                extent = ListExtent(place.stop - start if is_open else operation.size * (operation.count or 0))
                extent = extents.get(operation.name, extent)
                count = extent.size // operation.size if operation.count is None else operation.count
                count = extent.numbers if operation.packing is not None and operation.name in extents else count
                sizes = extent.elements or ([operation.size] * count if operation.is_list else [extent.size])
                contents = run_each(operation, replace(place, start=start), sizes, rows, rows_beside)
                values[operation.name] = contents if operation.is_list else contents[0]
                start += operation.size if is_open and not operation.is_list else extent.size
            case _:
                assert_never(operation)
    return values


def _decided(part: Decided, rows_beside: dict[str, Row]) -> Each:
    """The program that the number of another field decides."""
    number = rows_beside[part.by].number
    assert isinstance(number, int)
    return part.forms[masked(number, part.mask)]


def run_each(
    operation: Each, place: Place, sizes: Sequence[int], rows: list[Row], rows_beside: dict[str, Row]
) -> list[Raw]:
    """The contents of the elements of a field, which follow each other and have some sizes. Adds rows as `run` does."""
    contents: list[Raw] = []
    start, packing = place.start, operation.packing
    for index, size in enumerate(sizes):
        suffix = f"[{index}]" if operation.is_list else ""
        first, stop = start, start + size
        if packing is not None:
            first, stop = (place.start + offset for offset in packing.place(index))
        element = Place(place.data, first, stop, place.path, suffix, index)
        contents.append(run(operation.element, element, rows, rows_beside)[operation.name])
        start += size
    return contents


def _loaded(operation: Load | LoadPacked | LoadVarying, place: Place, rows_beside: dict[str, Row]) -> Row:
    variable = operation.variable
    image: bytes | None
    match operation:
        case Load():
            raw = image = place.data[place.start : place.start + len(operation.places)]
            in_order: bytes | None = bytes(raw[byte] for byte in operation.places)
        case LoadPacked():
            raw = place.data[place.start : place.stop]
            number, size = operation.packing.number_in(raw, place.index), operation.packing.size
            image = in_order = number.to_bytes(size, "big", signed=number < 0)
            shared = operation.packing.shared_bytes(place.index)  # of the row of the number before it
            raw, place = raw[shared:], replace(place, start=place.start + shared)
        case LoadVarying():
            raw = place.data[place.start : place.stop]
            image = in_order = widened(variable.value, raw)
        case _:
            assert_never(operation)
    content = None if in_order is None else content_of(variable.value, in_order)
    path = f"{place.path}{variable.name}{place.suffix}"
    return Row(path, place.index, variable, place.start, raw, image, content, rows_beside)


def content_of(value: Value, data: bytes) -> Content | None:
    """What all bytes of a value are, in the order of places; None for invalid digits or characters."""
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
