"""What outputs refuse that do not convert digits to numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.fact import Fact
from fieldspec.model.value import Value


def digits_refusals(versions: Sequence[DeviceLayout], reader: str, for_controllers: bool = False) -> list[Diagnostic]:
    """A finding for each value that is sent as digits; `reader` is what does not convert them."""
    facts = {
        fact.place.path: fact
        for layout in versions
        for fact, value in _values(layout)
        if value is not None and value.digits
    }
    return [
        Diagnostic(
            "plc_numbers_binary" if for_controllers else "output_numbers_binary",
            f"{fact.name} is sent as digits, which {reader} does not convert",
            fact.place["digits"],
            help=LEAVE_OUT,
        )
        for fact in facts.values()
    ]


def _values(layout: DeviceLayout) -> Iterator[tuple[Fact, Value | None]]:
    """The registers and fields of a version with their values."""
    for register in layout.registers:
        yield register.register, register.register.value
    bodies = (body for message in layout.messages.values() for body in message.bodies)
    for record in (*layout.records.values(), *bodies):
        for field in record.fields:
            yield field.field, field.value
