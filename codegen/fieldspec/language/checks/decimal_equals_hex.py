"""If the manual also prints an address in decimal, both numbers are equal.

Why: manuals convert one column to the other by hand. If they differ, one of them leads the user to the wrong
register.

Example: 0x2011 with the decimal address 8208.

Fix: Use the neighbouring rows to decide which number is correct, and write an erratum for the other.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, hexadecimal, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact


def decimal_equals_hex(device: Device) -> Findings:
    for register in device.registers():
        yield from _compare_addresses(device, register, register.space, "at", register.address, register.decimal)
    for table in device.tables.values():
        yield from _compare_addresses(device, table, table.space, "base", table.base, table.decimal)


def _compare_addresses(device: Device, fact: Fact, space: str, key: str, address: int, decimal: int | None) -> Findings:
    name, place, first = fact.name, fact.place, device.space(space).first_number
    if decimal is None or decimal == first + address:
        return
    if first:
        yield finding(
            place,
            "decimal",
            f"{decimal} is the number of {hexadecimal(decimal - first)}, but {name} is at {hexadecimal(address)}",
            f"numbers of {device.space(space).name} begin at {first}: {hexadecimal(address)} is {first + address}",
            label(place, key, "the address"),
        )
    else:
        yield finding(
            place,
            "decimal",
            f"{decimal} is {hexadecimal(decimal)}, but {name} is at {hexadecimal(address)}",
            f"{hexadecimal(address)} is {address}; correct one of them",
            label(place, key, "the address"),
        )
