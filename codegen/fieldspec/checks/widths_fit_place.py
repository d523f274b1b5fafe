"""A number has a width that its place can hold. Registers hold whole words of 16 bits. The parts of a frame,
numbered parameters and the counts of conversions have 8, 16, 32 or 64 bits.

Why: an output would have to invent bytes that the manual does not print, or could not compute with the number.

Example: a register of type `u24`, or a part of a frame of type `i40`.

Cure: For a register, state the whole words as `u32` or `u48` with a `range`. Elsewhere, use the next wider type if
the wire has these bytes, or several values.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import values
from fieldspec.checks.finding import finding, plural
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.link import Part
from fieldspec.model.registers import Parameter, Register, Subindex

_CODE = "widths_fit_place"


def widths_fit_place(device: Device) -> Iterator[Diagnostic]:
    for fact, value in values(device):
        type_name = value.type.name
        if isinstance(fact, Register) and value.digits and value.size % 2:
            text = f"the register {fact.name} has {plural(value.size, 'byte')} of digits, which are no whole words"
            yield finding(_CODE, fact.place, "length", text, "state the digits of whole words of two bytes")
        elif isinstance(fact, Register) and value.type.is_number and value.size % 2 and value.size > 1:
            text = f"the register {fact.name} is {type_name}, which has no whole number of words"
            help = "state the words as u32 or u48, with a range if it is known"
            if device.space(fact.space).unit_size == 1:
                text = f"the register {fact.name} is {type_name}; registers of bytes have 1, 2, 4, 6 or 8 of them"
                help = "state its bytes as several registers, such as a u16 and a u8"
            yield finding(_CODE, fact.place, "type", text, help)
        elif isinstance(fact, Parameter | Subindex) and value.type.is_odd:
            text = f"the parameter {fact.name} is {type_name}; parameters have 8, 16, 32 or 64 bits"
            yield finding(_CODE, fact.place, "type", text, "use the next wider type, with a range")
        elif isinstance(fact, Part) and value.type.is_odd:
            text = f"the part {fact.name} of the frame is {type_name}; parts have 8, 16, 32 or 64 bits"
            help = "use one of these types, several parts, or a field of the body"
            yield finding(_CODE, fact.place, "type", text, help)
    for conversion in device.conversions.values():
        if conversion.type.is_odd:
            text = f"the count of {conversion.name} is {conversion.type.name}; conversions take 8, 16, 32 or 64 bits"
            yield finding(_CODE, conversion.place, "type", text, "set `type` to the next wider type")
