"""Where the manual prints an address in decimal too, both are the same number.

Why: the decimal column is written by hand from the hexadecimal one, or the other way round; where they
differ, one of them sends the user to another register.

Example: 0x2011 beside 8208.

Cure: Find out which one is right from the rows around, and write an erratum for the other one.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, hexadecimal, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact


def decimal_equals_hex(device: Device) -> Iterator[Diagnostic]:
    for register in device.registers():
        yield from _compared(device, register, register.space, "at", register.address, register.decimal)
    for table in device.tables.values():
        yield from _compared(device, table, table.space, "base", table.base, table.decimal)


def _compared(
    device: Device, fact: Fact, space: str, key: str, address: int, decimal: int | None
) -> Iterator[Diagnostic]:
    name, place, first = fact.name, fact.place, device.space(space).first_number
    if decimal is None or decimal == first + address:
        return
    if first:
        yield finding(
            "decimal_equals_hex",
            place,
            "decimal",
            f"{decimal} is the number of {hexadecimal(decimal - first)}, but {name} is at {hexadecimal(address)}",
            f"numbers of {device.space(space).name} begin at {first}: {hexadecimal(address)} is {first + address}",
            label(place, key, "the address"),
        )
    else:
        yield finding(
            "decimal_equals_hex",
            place,
            "decimal",
            f"{decimal} is {hexadecimal(decimal)}, but {name} is at {hexadecimal(address)}",
            f"{hexadecimal(address)} is {address}; put one of them right",
            label(place, key, "the address"),
        )
