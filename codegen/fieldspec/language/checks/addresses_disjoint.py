"""No two registers, arrays of registers or tables occupy the same address in one address space.

Why: two names for one word are nearly always a mistake, and writing one changes the other.

Example: a register of two words at 0x2000 and another register at 0x2001.

Fix: Correct the address or the number of words, and write an erratum if the manual prints it that way. If
the overlap is intended, set `allow: {addresses_disjoint: <reason>}` on one of the two.
"""

from __future__ import annotations

from operator import attrgetter

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.addresses import Block, blocks
from fieldspec.language.checks.finding import Findings, addresses, finding, label
from fieldspec.language.model.device import Device


def addresses_disjoint(device: Device) -> Findings:
    yield from _elements_overlap(device)
    furthest: Block | None = None
    reported = set()
    for block in sorted(blocks(device), key=attrgetter("space", "first", "last")):
        if furthest is not None and furthest.space != block.space:
            furthest = None
        if furthest is not None and block.first <= furthest.last and furthest.fact is not block.fact:
            pair = id(furthest.fact), id(block.fact)
            if pair not in reported:
                reported.add(pair)
                yield finding(
                    block.fact.place,
                    block.key,
                    f"{block.name} at {addresses(block.first, block.last)} overlaps {furthest.name}",
                    "correct one of the addresses or sizes, or allow the overlap with a reason",
                    label(
                        furthest.fact.place,
                        furthest.key,
                        f"{furthest.name} occupies {addresses(furthest.first, furthest.last)}",
                    ),
                )
        if furthest is None or block.last > furthest.last:
            furthest = block


def _elements_overlap(device: Device) -> Findings:
    for register in device.registers():
        if register.count > 1 and register.stride < register.width:
            yield finding(
                register.place,
                "stride",
                f"elements of {register.name} have {plural(register.width, device.space(register.space).unit)}"
                f", but the stride is {register.stride}",
                "correct the stride or the type",
            )
