"""Of what a value is a share: the references of its conversions."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Context, Decimal

from fieldspec.classes import replace
from fieldspec.layout.explaining.row import Row
from fieldspec.layout.explaining.worded import Meaning, decimal_text, in_unit
from fieldspec.layout.meaning import Raw
from fieldspec.layout.record import FieldLayout
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.model.signal import Conversion
from fieldspec.model.value import Value

_EXACT = Context(prec=200)


def with_share(device: Device, row: Row, field: FieldLayout, number: Raw) -> Row:
    """A row of a field that places a signal, with the quantities of which the signal is a share."""
    if not field.field.signal or not isinstance(number, int):
        return row
    shares = tuple(
        Meaning(conversion.name, conversion.label, share_text(device, conversion, number), "")
        for conversion in device.conversions.values()
        if field.field.signal in conversion.signals
    )
    return replace(row, meanings=(*row.meanings, *shares)) if shares else row


def share_text(device: Device, conversion: Conversion, number: int) -> str:
    """`50 % of Pt317 (3000 rpm by default) or Pt386`"""
    from fractions import Fraction

    percent = conversion.quantity(number, Fraction(100))
    share = _EXACT.divide(Decimal(percent.numerator), Decimal(percent.denominator))
    return f"{decimal_text(share)} % of {references_text(device, conversion)}"


def references_text(device: Device, conversion: Conversion) -> str:
    """The references of a conversion by their printed names, with their defaults."""
    return " or ".join(_reference(device, path) for path in conversion.references) or "its reference"


def _reference(device: Device, path: str) -> str:
    fact, value = next(((fact, value) for fact, value in _values(device) if fact.place.path == path), (None, None))
    if fact is None or value is None:
        return path.rpartition("/")[2]
    default = in_unit(value, value.default) if value.default and isinstance(value.default, int) else ""
    return f"{fact.printed_name or fact.name} ({default} by default)" if default else fact.printed_name or fact.name


def _values(device: Device) -> Iterator[tuple[Fact, Value]]:
    """Everything that may hold a reference."""
    for words in device.parameters.values():
        yield from ((parameter, parameter.value) for parameter in words.parameters)
    yield from ((register, register.value) for register in device.registers())
    yield from ((signal, signal.value) for signal in device.signals.values())
