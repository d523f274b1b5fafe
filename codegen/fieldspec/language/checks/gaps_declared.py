"""Within a group, every address without a register is in a declared gap, and no gap contains a register.

Why: address plus words is the next address, unless the manual skips addresses. An undeclared hole hides a
wrong number of words, a wrong address or a row that was not transcribed.

Example: a register of one word at 0x010B, the next register at 0x010D, and no gap that contains 0x010C.

Fix: Correct the words or the address, transcribe the missing row, or declare the addresses with a reason under `gaps`
of the group. If the register exists only in other versions, set `allow: {gaps_declared: <reason>}` on the row after it.
"""

from __future__ import annotations

from fieldspec.language.checks.addresses import extents
from fieldspec.language.checks.finding import Findings, addresses, finding, label, longest_ascent
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.ranges import merged, uncovered
from fieldspec.language.model.registers import Register, RegisterGroup


def gaps_declared(device: Device) -> Findings:
    extent = list(extents(device))
    for group in device.groups:
        own = device.space_name(group.space)
        occupied = merged((first, last) for space, first, last in extent if space == own)
        if group.ascending and group.registers:
            yield from _undeclared(group, occupied)
        yield from _wrong(group, occupied)


def _undeclared(group: RegisterGroup, occupied: list[tuple[int, int]]) -> Findings:
    # A row that breaks the order is addresses_ascending's; it would make one more hole.
    ascent = longest_ascent([row.address for row in group.registers])
    rows = [row for number, row in enumerate(group.registers) if number in ascent]
    declared = (pair for gap in group.gaps for pair in gap.addresses.intervals)
    known = merged([*occupied, *declared])
    ends = rows[0]
    for row in rows[1:]:
        if row.address > ends.end:
            for low, high in uncovered(ends.end, row.address - 1, known):
                yield _hole(group, ends, row, low, high)
        ends = max(ends, row, key=lambda register: register.end)


def _hole(group: RegisterGroup, before: Register, following: Register, low: int, high: int) -> Diagnostic:
    return finding(
        following.place,
        "at",
        f"no register and no gap of {group.name} contains {addresses(low, high)}",
        "correct an address or a number of words, or declare the addresses under `gaps` with a reason",
        label(before.place, "at", f"{before.name} ends at {addresses(before.end - 1, before.end - 1)}"),
    )


def _wrong(group: RegisterGroup, occupied: list[tuple[int, int]]) -> Findings:
    help = "a gap contains only unused addresses between the rows of its group"
    if not group.registers:
        return
    first = min(row.address for row in group.registers)
    last = max(row.end for row in group.registers) - 1
    for gap in group.gaps:
        for low, high in gap.addresses.intervals:
            if low < first or high > last:
                text = f"the gap {addresses(low, high)} goes beyond the group at {addresses(first, last)}"
                yield finding(gap.place, "at", text, help)
            elif uncovered(low, high, occupied) != [(low, high)]:
                text = f"the gap {addresses(low, high)} contains a register or table"
                yield finding(gap.place, "at", text, help)
