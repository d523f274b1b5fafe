"""Every register, array of registers and table ends at address 0xFFFF or before.

Why: a frame carries an address in 16 bits. What lies behind cannot be read, so an address, a stride or a
number of elements is wrong.

Example: a table of 4096 elements with a stride of 0x10 that begins at 0x9000.

Cure: Put the address, the stride or the number of elements right.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, hexadecimal
from fieldspec.checks.occupied import SPACE, table_words
from fieldspec.checks.sizes import Sizes
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device

_HELP = "put the address, the stride or the number of elements right"


def addresses_within_space(device: Device) -> Iterator[Diagnostic]:
    for register in device.registers():
        if register.end > SPACE:
            text = f"{register.name} ends at {hexadecimal(register.end - 1)}; the last address is 0xFFFF"
            yield finding("addresses_within_space", register.place, "at", text, _HELP)
    sizes = Sizes(device)
    for table in device.tables.values():
        last = table.base + (table.count - 1) * table.stride + table_words(table, sizes) - 1
        if last >= SPACE:
            text = f"{table.name} ends at {hexadecimal(last)}; the last address is 0xFFFF"
            yield finding("addresses_within_space", table.place, "base", text, _HELP)
