"""Places in the memories of controllers: areas before numbers, `D100`, and places that no bus has, `%IX0.3`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from string import hexdigits

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists.addresses import DECIMAL, HEXADECIMAL, Place
from fieldspec.tools.lists.assumption import Assumption, Refusal
from fieldspec.tools.lists.sheet import ListError, SheetRow

PlacedRows = Sequence[tuple[SheetRow, Place]]

_MEMORIES = tuple(
    (re.compile(sign, re.IGNORECASE), re.compile(cell, re.IGNORECASE), f"is {reason}")
    for sign, cell, reason in (
        (
            r"%(?:[iqm]|[iq]x)[0-9]+\.[0-7]",
            "%",
            "a place in a memory that counts bytes, and not an address on a bus",
        ),
        (r"%[iq]", r"%[iq][xbwdl]?[0-9]", "an input or output of a controller, and not an address on a bus"),
        (
            "%m",
            r"%m(?:[bdflx]|wx)?[0-9]",
            "not an address on a bus: controllers count bits, bytes and double words of their memories differently",
        ),
        (r"n[0-9]+:[0-9]", r"[bcfilnorst][0-9]*:[0-9]", "an element of a file of a controller, and not on a bus"),
    )
)
"""The memories of controllers: a place in one that shows it, the beginnings of places in it, and why they are no
addresses."""


def of_memories(texts: Sequence[str]) -> dict[str, str]:
    """The texts that are places in the memory of a controller, such as `%I0.7`, with the reasons against them."""
    stripped = [text.strip() for text in texts]
    faults = [(cell, reason) for sign, cell, reason in _MEMORIES if any(map(sign.match, stripped))]
    return {text: reason for cell, reason in reversed(faults) for text in texts if cell.match(text.strip())}


def with_areas(rows: PlacedRows, base: str, heading: str) -> Iterator[tuple[SheetRow, Place]]:
    """The places, with `C3` as the coil 3 where the user reads numbers as decimal, and beside `HR100`.

    Raises ListError where other digits show that `C3` may as well be a hexadecimal number.
    """
    firsts = [row_place.first for _, row_place in rows]
    is_named = any(first.area and not first.mark for first in firsts) and base != HEXADECIMAL
    lettered = next((first.digits for first in firsts if first.prefixed), "")
    if is_named and not base and lettered and any(f.lettered and not (f.prefixed or f.area) for f in firsts):
        raise undecided(lettered, heading)
    for row, row_place in rows:
        first, last = row_place.first, row_place.last
        if (first.prefixed or (first.area and first.mark)) and (is_named or (base == DECIMAL and not first.mark)):
            last = last.behind_area() if last is not None and last.prefixed else last
            row_place = replace(row_place, first=first.behind_area(), last=last)
        yield row, row_place


def undecided(digits: str, heading: str) -> ListError:
    """The error for an address whose letter may be a hexadecimal digit, or the name of an area."""
    return ListError(
        f"has the address `{digits}` under {heading}, which is hexadecimal, or decimal after the name of a memory "
        "area: choose with --base hex or --base decimal"
    )


def assumed_areas(rows: PlacedRows) -> Iterator[Assumption]:
    """The assumption about letters that may be hexadecimal digits in a list with names of areas."""
    firsts = [row_place.first for _, row_place in rows if row_place.first.area and not row_place.first.mark]
    if len({first.area.casefold() for first in firsts}) == 1 and not firsts[0].space:
        evidence = f"`{firsts[0].area}{firsts[0].digits}`, and no other area of a memory"
        yield Assumption("addresses", f"the numbers after `{firsts[0].area}`", evidence, "--offset")
    digit = next((first for first in firsts if first.area in hexdigits), None)
    other = next((first for first in firsts if first.area not in hexdigits), None)
    if digit is not None and other is not None:
        evidence = f"`{digit.area}{digit.digits}` beside `{other.area}{other.digits}`"
        yield Assumption("addresses", "names of areas before decimal numbers", evidence, "--base hex")


def unknown_areas(rows: PlacedRows, spaces: Mapping[int, str], heading: str) -> Iterator[Refusal]:
    """The rows with the name of an area beside others, where neither it nor `spaces` says which address space it is."""
    firsts = [row_place.first for _, row_place in rows]
    areas = {first.area.casefold() for first in firsts if first.area and not first.mark}
    bare = [first for first in firsts if not (first.mark or first.area)]
    has_bare = bool(bare) and not any(first.lettered for first in bare)
    for row, row_place in rows if has_bare else ():
        if row_place.first.area and row_place.first.mark:
            reason = "is hexadecimal, or stands for more than a number, beside numbers without the letter; write `0x`"
            yield Refusal(row.number, heading, f"{row_place.first.area}{row_place.first.digits}", reason)
    for row, row_place in rows if len(areas) > 1 else ():
        first = row_place.first
        if first.area and not (first.mark or first.space or spaces.get(row.number)):
            reason = (
                f"names the area `{first.area}`; give the address on the bus, or say its address space in a column, "
                "and name that with --space"
            )
            yield Refusal(row.number, heading, f"{first.area}{first.digits}", reason)
