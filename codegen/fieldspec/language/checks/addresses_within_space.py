"""Every register, array of registers and table is within the bounds of its address space.

Why: a frame carries an address in 16 bits, and an address space can have fewer addresses. An address outside the bounds
cannot be read. The address, the stride, the number of elements or the bounds are wrong.

Example: a table of 4096 elements with a stride of 0x10 that begins at 0x9000.

Fix: Correct the address, the stride, the number of elements or the `bounds` of the address space. Data with longer
addresses is stated as `parameters`, whose numbers have up to 32 bits.
"""

from __future__ import annotations

from fieldspec.language.checks.addresses import SPACE, table_words
from fieldspec.language.checks.finding import Findings, finding, hexadecimal, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.sizes import RecordSizes

_HELP = "correct the address, the stride or the number of elements"
_WIDE = "lower the bounds; state what has longer addresses as `parameters`, whose numbers have up to 32 bits"


def addresses_within_space(device: Device) -> Findings:
    for register in device.registers():
        yield from _of(device, register, register.space, "at", register.address, register.end - 1)
    for space in device.spaces.values():
        if space.bounds.low < 0 or space.bounds.high >= SPACE:
            text = f"{space.name} has bounds beyond 0..0xFFFF, the addresses that a space may have"
            yield finding(space.place, "bounds", text, _WIDE)
    sizes = RecordSizes(device)
    for table in device.tables.values():
        last = table.base + (table.count - 1) * table.stride + table_words(table, sizes) - 1
        yield from _of(device, table, table.space, "base", table.base, last)


def _of(device: Device, fact: Fact, name: str, key: str, first: int, last: int) -> Findings:
    space = device.space(name)
    if last >= SPACE:
        text = f"{fact.name} ends at {hexadecimal(last)}; the last address is 0xFFFF"
        yield finding(fact.place, key, text, _HELP)
    elif not any(low <= first and last <= high for low, high in space.bounds.intervals):
        bounds = ", ".join(f"{hexadecimal(low)}..{hexadecimal(high)}" for low, high in space.bounds.intervals)
        text = f"{fact.name} at {hexadecimal(first)}..{hexadecimal(last)} is not within {space.name}"
        related_label = label(space.place, "bounds", f"{space.name} has the addresses {bounds}")
        yield finding(fact.place, key, text, _HELP, related_label)
