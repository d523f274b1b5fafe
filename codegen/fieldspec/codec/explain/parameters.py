"""Parameters in a frame, and the raw value nearest to a quantity that a user enters."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.row import ExplanationRow, citations, errata_at, errata_of_words
from fieldspec.codec.explain.values import Meaning, decode_answer, decode_value, in_unit
from fieldspec.codec.layout.record import FieldLayout, Orders
from fieldspec.codec.layout.values import Raw
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_exact, is_octets, is_real, is_text
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.raw_numbers import bytes_of_number
from fieldspec.language.model.record import Message
from fieldspec.language.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.language.model.value import ParameterPart, Value


@dataclass(frozen=True, slots=True)
class _Element:
    """A parameter of a set, or one of its elements. `parameter` is None for a number that the spec does not list."""

    parameter_set: ParameterSet
    number: int
    parameter: Parameter | None
    index: int | None
    subindex: Subindex | None

    @property
    def meaning(self) -> Meaning:
        """Its name, or that of the set if the spec does not list the number, with the number as printed."""
        index = "" if self.index is None else f"[{self.index}]"
        text = sentences.PARAMETER.format(number=self.parameter_set.number_text(self.number) + index)
        fact = self.fact
        if fact is None:
            return Meaning(self.parameter_set.name, "", text, "")
        names = dict.fromkeys(fact.name for fact in (self.parameter, self.subindex) if fact is not None and fact.name)
        return Meaning(".".join(names), fact.label, text, "")

    @property
    def fact(self) -> Parameter | Subindex | None:
        """The subindex or the parameter that describes the element."""
        return self.subindex or self.parameter

    @property
    def sources(self) -> str:
        """The places where the manual prints it, as text."""
        fact, parameter = self.fact, self.parameter
        own = fact.sources if fact is not None else ()
        return citations(own or (parameter.sources if parameter is not None else ()))


def with_parameter(
    device: Device,
    row: ExplanationRow,
    field: FieldLayout,
    index: int,
    known: Mapping[str, Raw],
    outer: Fact,
    is_request: bool,
) -> ExplanationRow:
    """The row of element `index` of a field, with the name and the meaning that its parameter gives it.

    `known` are the values of the frame so far and of the request that it answers. `outer` is the message.
    """
    part = field.value.parameter if field.value else None
    if part is None:
        return row
    if part.part == "values":
        (parameter_set,) = device.sets(part.set)
        placed = parameter_set.at_place(index)
        if placed is None:
            return row
        parameter, number = placed
        element = _Element(parameter_set, number, parameter, None, None)
        return _read_as(device, row, field, element, is_request, field.size)
    parameter_number = row.number if part.part == "number" else known.get(part.number)
    match = device.parameter_at(part.set, parameter_number) if isinstance(parameter_number, int) else None
    if match is None:
        return row
    parameter_set, number = match
    known_parameter = parameter_set.numbered(number)
    if part.part == "number":
        element_number = None
    elif part.part == "subindex":
        element_number = row.number
    else:
        first = known.get(index_field(outer, part), 0)
        element_number = first + index if isinstance(first, int) else None
    element = _element(parameter_set, number, known_parameter, element_number)
    if part.part == "value":
        size = field.size
        if part.sizes is not None:
            stated = known.get(part.sizes.by)
            if isinstance(stated, int) and stated not in field.sizes:
                return replace(row, meanings=(element.meaning, *row.meanings))  # its bytes are not a value
            size = field.sizes.get(stated, 0) if isinstance(stated, int) else 0
        return _read_as(device, row, field, element, is_request, size)
    if part.part == "subindex" and element.index is None:
        return row
    return replace(row, meanings=(*row.meanings, element.meaning))


def number_of_text(parameter_set: ParameterSet, text: str) -> int | None:
    """The number of a set that the manual prints as `text`, whether or not the spec lists it; None if there is none."""
    if parameter_set.numbers is None or not parameter_set.printed_as:
        return None
    for low, high in parameter_set.numbers.intervals:
        for number in range(low, high + 1):
            if parameter_set.number_text(number).lower() == text.lower():
                return number
    return None


def index_field(outer: Fact, part: ParameterPart) -> str:
    """The name of the field with the index of the first element that a message carries; empty if it has none."""
    if not isinstance(outer, Message):
        return ""
    for field in (*outer.request.fields, *outer.response.fields):
        parameter_part = field.value.parameter if field.value else None
        if parameter_part is not None and (parameter_part.part, parameter_part.number) == ("subindex", part.number):
            return field.name
    return ""


def _element(parameter_set: ParameterSet, number: int, parameter: Parameter | None, element_number: object) -> _Element:
    """The element of a parameter that has several, else the whole parameter."""
    has_elements = parameter is not None and (parameter.elements is not None or parameter.subindices)
    if parameter is None or not has_elements or not isinstance(element_number, int):
        return _Element(parameter_set, number, parameter, None, None)
    return _Element(parameter_set, number, parameter, element_number, parameter.element(element_number))


def _read_as(
    device: Device, row: ExplanationRow, field: FieldLayout, element: _Element, is_request: bool, size: int
) -> ExplanationRow:
    """The row with its first `size` bytes read as the value of a parameter.

    No codec refuses a frame for what is wrong with that.
    """
    fact = element.fact
    if fact is None or element.parameter is None:
        return replace(row, meanings=(element.meaning, *row.meanings))
    decode_arguments = None if row.reason else _decode_arguments(device, fact.value, field, row, size)
    if decode_arguments is None:
        row = replace(row, meanings=(element.meaning, *row.meanings), notes=(*row.notes, *fact.notes))
        if row.reason or not field.carries_bytes or element.parameter.reserved or fact.reserved:
            return row
        stated = fact.value.size
        if is_text(fact.value.encoding) and size < stated:
            return row  # without the zeros that fill it up
        text = sentences.SHOULD_BE.format(expected=sentences.byte_count(stated))
        return replace(row, verdict=text, reason="out_of_range")
    value = fact.value.for_writing() if is_request else fact.value
    if is_request:
        read = decode_value(device, value, *decode_arguments, fact.reserved)
    else:
        read = decode_answer(device, value, *decode_arguments, fact.reserved, element.parameter.trigger)
    errata = (*row.errata, *errata_at(device, element.parameter.place.path))
    return replace(
        row,
        fact=fact.place.path,
        doc=fact.doc or row.doc,
        number=read.number,
        value=read.text,
        meanings=(element.meaning, *read.meanings),
        verdict=read.verdict,
        reason="out_of_range" if read.reason else "",
        source=element.sources or row.source,
        notes=(*row.notes, *fact.notes, *read.notes),
        errata=tuple(dict.fromkeys((*errata, *errata_of_words(device, read.facts)))),
    )


def _decode_arguments(
    device: Device, value: Value, field: FieldLayout, row: ExplanationRow, size: int
) -> tuple[bytes, str, bool] | None:
    """The bytes of a row as bytes of another value, with their order; None if they cannot be read as it."""
    own = field.primitive
    if field.carries_bytes:
        return (row.raw[:size], *Orders(field.order, device.word_order).of(value)) if size == value.size else None
    encodings = own.encoding, value.encoding
    alike = any(all(map(question, encodings)) for question in (is_exact, is_real, is_text, is_octets))
    is_binary = field.value is not None and not field.value.digits
    if is_binary and value.size == field.size and (alike or not any(map(is_real, encodings))):
        return row.raw, field.order, field.swapped
    if alike and isinstance(row.number, int) and value.type.low <= row.number <= value.type.high:
        return bytes_of_number(value, int(row.number)), "big", False
    return None


_PLACES = 4


@dataclass(frozen=True, slots=True)
class Count:
    """The raw value nearest to a quantity. `exact` is the quantity in counts, `text` that of `raw`."""

    raw: int
    exact: str
    text: str
    is_whole: bool


def nearest(device: Device, value: Value, text: str) -> Count | None:
    """The raw value nearest to `50 %`, the even one of two; None if the text is not a quantity in the unit."""
    number = device.entered_quantity(value, text.strip())
    if number is None:
        return None
    counts = (number - Fraction(value.offset)) / Fraction(value.scale)
    raw = round(counts)
    exact = f"{Decimal(round(counts * 10**_PLACES)).scaleb(-_PLACES).normalize():f}"
    return Count(raw, exact, in_unit(value, raw), counts == raw)


def rounded(device: Device, name: str, value: Value, text: str) -> tuple[int, str] | None:
    """The nearest count for a quantity between two counts, as the generated code rounds, and a remark; else None."""
    count = nearest(device, value, text)
    if count is None or count.is_whole:
        return None
    count_text = "" if count.text.replace(" ", "") == text.replace(" ", "") else f", which is {count.text}"
    return count.raw, f"{name}: {text} is {count.exact} counts; {count.raw} is sent{count_text}"


def parameter_number(device: Device, name: str, text: str) -> int | None:
    """The number on the wire of a parameter in a set or in a space of sets; None if there is none.

    `text` is its name, its printed name, or its number as the manual prints it.
    """
    for parameter_set in device.sets(name):
        for parameter in parameter_set.parameters:
            if text.lower() in (parameter.name, parameter.printed_name.lower()):
                return parameter_set.base + parameter.number
        number = number_of_text(parameter_set, text)
        if number is not None:
            return parameter_set.base + number
    return None
