"""Quantities as percentages of their references."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Context, Decimal

from fieldspec.codec.explain import sentences
from fieldspec.codec.explain.row import ExplanationRow
from fieldspec.codec.explain.values import Meaning, decimal_text, in_unit
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.foundation.classes import replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Conversion, Value

_EXACT = Context(prec=200)


def with_percentages(device: Device, row: ExplanationRow, field: FieldLayout, number: Raw) -> ExplanationRow:
    """The row of a field that carries a signal, with the percentages that its conversions give."""
    if not field.field.signal or not isinstance(number, int):
        return row
    meanings = tuple(
        Meaning(conversion.name, conversion.label, percentage_text(device, conversion, number), "")
        for conversion in device.conversions.values()
        if field.field.signal in conversion.signals
    )
    return replace(row, meanings=(*row.meanings, *meanings)) if meanings else row


def percentage_text(device: Device, conversion: Conversion, number: int) -> str:
    """The percentage that a count stands for: `50 % of Pt317 (3000 rpm by default) or Pt386`."""
    from fractions import Fraction

    percent = conversion.quantity(number, Fraction(100))
    exact = _EXACT.divide(Decimal(percent.numerator), Decimal(percent.denominator))
    text = decimal_text(exact, Fraction(100, conversion.full_scale))
    return sentences.PERCENTAGE.format(percent=text, references=references_text(device, conversion))


def references_text(device: Device, conversion: Conversion) -> str:
    """The printed names of a conversion's references with their defaults: `Pt317 (3000 rpm by default) or Pt386`."""
    return " or ".join(_reference(device, path) for path in conversion.references) or "its reference"


def _reference(device: Device, path: str) -> str:
    fact, value = next(((fact, value) for fact, value in _values(device) if fact.place.path == path), (None, None))
    if fact is None or value is None:
        return path.rpartition("/")[2]
    default = in_unit(value, value.default) if value.default and isinstance(value.default, int) else ""
    return f"{fact.printed_name or fact.name} ({default} by default)" if default else fact.printed_name or fact.name


def _values(device: Device) -> Iterator[tuple[Fact, Value]]:
    """The facts that a conversion can refer to, with their values."""
    for words in device.parameters.values():
        yield from ((parameter, parameter.value) for parameter in words.parameters)
    yield from ((register, register.value) for register in device.registers())
    yield from ((signal, signal.value) for signal in device.signals.values())
