"""Within a group, the address of every register is higher than that of the register before it.

Why: manuals list registers by address. A row that breaks the order is nearly always a misprint or a typing
error.

Example: rows at 0x0709, 0x080A and 0x070B: the middle one is out of order.

Fix: Correct the address, and write an erratum if the manual prints it that way. If the manual lists the
group in another order, set `order: as_listed` on the group.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, hexadecimal, label, longest_ascent
from fieldspec.language.model.device import Device


def addresses_ascending(device: Device) -> Findings:
    for group in device.groups:
        if not group.ascending:
            continue
        rows = group.registers
        in_order = longest_ascent([row.address for row in rows])
        for number, row in enumerate(rows):
            if number not in in_order:
                other = rows[number - 1] if number else rows[1]
                relation = "after" if number else "before"
                yield finding(
                    row.place,
                    "at",
                    f"{row.name} at {hexadecimal(row.address)} breaks the order of {group.name}",
                    "correct the address, or set `order: as_listed` on the group",
                    label(
                        other.place,
                        "at",
                        f"it is listed {relation} {other.name} at {hexadecimal(other.address)}",
                    ),
                )
