"""Parameters in a frame."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.errata import citations, errata_at, errata_of_words
from fieldspec.codec.explain.read_again import read_again
from fieldspec.codec.explain.row import ExplanationRow
from fieldspec.codec.explain.values import Meaning, decode_answer, decode_value
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_text
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Message
from fieldspec.language.model.registers import Parameter, ParameterSet, Subindex
from fieldspec.language.model.value import ParameterPart


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
    def citations(self) -> str:
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
        parameter_set = device.sets(part.set)[0]
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
        element_number = int(first) + index if isinstance(first, int) else None
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
    has_elements = parameter is not None and (parameter.elements is not None or len(parameter.subindices) > 0)
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
    own_value = fact.value.for_writing() if is_request else fact.value
    reread = None if row.reason else read_again(device, own_value, field, row.raw, row.number, size)
    if reread is None:
        row = replace(row, meanings=(element.meaning, *row.meanings), notes=(*row.notes, *fact.notes))
        if row.reason or not field.carries_bytes or element.parameter.reserved or fact.reserved:
            return row
        stated = fact.value.size
        if is_text(fact.value.encoding) and size < stated:
            return row  # without the zeros that fill it up
        text = sentences.SHOULD_BE.format(expected=sentences.byte_count(stated))
        return replace(row, verdict=text, reason="out_of_range")
    if is_request:
        read = decode_value(device, *reread, fact.reserved)
    else:
        read = decode_answer(device, *reread, fact.reserved, element.parameter.trigger)
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
        source=element.citations or row.source,
        notes=(*row.notes, *fact.notes, *read.notes),
        errata=tuple(dict.fromkeys((*errata, *errata_of_words(device, read.facts)))),
    )
