"""Numbered parameters in a frame, and the count nearest to a quantity that a user enters."""

from __future__ import annotations

import re
from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction

from fieldspec.classes import dataclass, replace
from fieldspec.explain.row import ExplanationRow, citations, errata_at, errata_of_words
from fieldspec.explain.values import Meaning, decode_value, in_unit
from fieldspec.layout.record import FieldLayout
from fieldspec.layout.values import Raw
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.record import Message
from fieldspec.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.model.value import Kind, ParameterPart, Value

_COUNTS = (Kind.INTEGER, Kind.BOOLEAN)


@dataclass(frozen=True, slots=True)
class _Element:
    """An element of a parameter, or the whole of it: what is said of it, and as what its value is read."""

    words: ParameterSet
    number: int
    parameter: Parameter | None
    index: int | None
    subindex: Subindex | None

    @property
    def meaning(self) -> Meaning:
        """Its name; of a number without a row, the set's, and the number as the manual writes it."""
        index = "" if self.index is None else f"[{self.index}]"
        text = f"parameter {self.words.number_text(self.number)}{index}"
        fact = self.fact
        if fact is None:
            return Meaning(self.words.name, "", text, "")
        names = dict.fromkeys(one.name for one in (self.parameter, self.subindex) if one is not None and one.name)
        return Meaning(".".join(names), fact.label, text, "")

    @property
    def fact(self) -> Parameter | Subindex | None:
        """The row of the spec that it has."""
        return self.subindex or self.parameter

    @property
    def sources(self) -> str:
        """Where the manual prints it."""
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
    written: bool,
) -> ExplanationRow:
    """A row of element `index` of a field with what the parameter adds; `known` are the values of the frame so far,
    and those of the request that it answers. `outer` is the message; `written` says that it is a request.
    """
    part = field.value.parameter if field.value else None
    if part is None:
        return row
    if part.part == "values":
        (words,) = device.sets(part.set)
        if index >= len(words.parameters):
            return row
        held = words.parameters[index]
        return _read_as(device, row, field, _Element(words, held.number, held, None, None), written)
    asked = row.number if part.part == "number" else known.get(part.number)
    found = device.parameter_at(part.set, asked) if isinstance(asked, int) else None
    if found is None:
        return row
    words, number = found
    parameter = words.numbered(number)
    if part.part == "number":
        at = None
    elif part.part == "subindex":
        at = row.number
    else:
        first = known.get(_index_field(outer, part), 0)
        at = first + index if isinstance(first, int) else None
    element = _element(words, number, parameter, at)
    if part.part == "value":
        return _read_as(device, row, field, element, written)
    if part.part == "subindex" and element.index is None:
        return row
    return replace(row, meanings=(*row.meanings, element.meaning))


def number_of_text(words: ParameterSet, text: str) -> int | None:
    """The number of a set, with a row or without one, that a text is as the manual writes it."""
    if words.numbers is None or not words.printed_as:
        return None
    for low, high in words.numbers.intervals:
        for number in range(low, high + 1):
            if words.number_text(number).lower() == text.lower():
                return number
    return None


def _index_field(outer: Fact, part: ParameterPart) -> str:
    """The field of a message that holds the index of the first element whose values it has."""
    if not isinstance(outer, Message):
        return ""
    for field in (*outer.request.fields, *outer.response.fields):
        held = field.value.parameter if field.value else None
        if held is not None and (held.part, held.number) == ("subindex", part.number):
            return field.name
    return ""


def _element(words: ParameterSet, number: int, parameter: Parameter | None, at: object) -> _Element:
    """An element of a parameter that has several; else the whole parameter."""
    several = parameter is not None and (parameter.elements is not None or parameter.subindices)
    if parameter is None or not several or not isinstance(at, int):
        return _Element(words, number, parameter, None, None)
    subindex = next((inner for inner in parameter.subindices if at in inner.indices), None)
    return _Element(words, number, parameter, at, subindex)


def _read_as(
    device: Device, row: ExplanationRow, field: FieldLayout, element: _Element, written: bool
) -> ExplanationRow:
    """A row whose bytes are read as a parameter: its unit, members and notes. No codec refuses it for these."""
    fact = element.fact
    if fact is None or element.parameter is None:
        return replace(row, meanings=(element.meaning, *row.meanings))
    again = None if row.reason else _again(fact.value, field, row)
    if again is None:
        return replace(row, meanings=(element.meaning, *row.meanings), notes=(*row.notes, *fact.notes))
    read = decode_value(device, fact.value.for_writing() if written else fact.value, *again, reserved=fact.reserved)
    if element.parameter.trigger and not written:
        read = replace(read, verdict="", reason="")  # what starts something does not answer what was written
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


def _again(value: Value, field: FieldLayout, row: ExplanationRow) -> tuple[bytes, str, bool] | None:
    """The bytes of a row as those of a value, and their order; None where they cannot be it."""
    own = field.primitive
    alike = own.kind is value.type.kind or (own.kind in _COUNTS and value.type.kind in _COUNTS)
    if value.size == field.size and (alike or Kind.FLOAT not in (own.kind, value.type.kind)):
        return row.raw, field.order, field.swapped
    if alike and isinstance(row.number, int) and value.type.low <= row.number <= value.type.high:
        return int(row.number).to_bytes(value.size, "big", signed=value.type.signed), "big", False
    return None


_QUANTITY = re.compile(r"([-+]?[0-9]{1,30}(?:\.[0-9]{1,30})?) ?(\S.*)")
_MOST_NAMES = 4


@dataclass(frozen=True, slots=True)
class Count:
    """The count next to a quantity: `exact` is the quantity in counts, `text` is what `raw` stands for."""

    raw: int
    exact: str
    text: str
    is_whole: bool


def nearest(value: Value, text: str) -> Count | None:
    """The count next to `50 %`; of two the even one. None where the text is no quantity in the value's unit."""
    match = _QUANTITY.fullmatch(text.strip())
    if match is None or match[2] != value.unit:
        return None
    counts = (Fraction(match[1]) - Fraction(value.offset)) / Fraction(value.scale)
    raw = round(counts)
    exact = f"{Decimal(round(counts * 10**_MOST_NAMES)).scaleb(-_MOST_NAMES).normalize():f}"
    return Count(raw, exact, in_unit(value, raw), counts == raw)


def parameter_number(device: Device, name: str, text: str) -> int | None:
    """The number on the wire of a parameter of a set, or of a space of sets, that a name of ours or of print means."""
    for words in device.sets(name):
        for parameter in words.parameters:
            if text.lower() in (parameter.name, parameter.printed_name.lower()):
                return words.base + parameter.number
        number = number_of_text(words, text)
        if number is not None:
            return words.base + number
    return None
