"""What people write for registers, as the words that a message carries: counts of words, quantities, names."""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.commands.usage import UsageError
from fieldspec.explain.registers import Occupant, occupant_at
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.values import raw_value
from fieldspec.model.record import RegisterAccess

_COUNTS = re.compile(r"[-+]?(?:0x[0-9A-Fa-f]+|[0-9]+)(?:[, ]+[-+]?(?:0x[0-9A-Fa-f]+|[0-9]+))*")


def register_words(layout: DeviceLayout, access: RegisterAccess, start: int, text: str) -> list[int] | None:
    """The words of `50.00 mm, 0x0001`: an item in a unit, or a name, is the whole value of the register there.

    None where there are counts of words alone. Raises UsageError for an item that no register at its address takes.
    """
    if _COUNTS.fullmatch(text.strip()):
        return None
    words: list[int] = []
    for item in (item.strip() for item in text.split(",")):
        words += _words(layout, access, start + len(words), item)
    return words


def _words(layout: DeviceLayout, access: RegisterAccess, address: int, item: str) -> Iterator[int]:
    if re.fullmatch(r"0x[0-9A-Fa-f]{1,4}|[0-9]{1,5}", item):
        yield int(item, 0)
        return
    occupant = occupant_at(layout, access.space, address)
    if occupant is None or occupant.value.size % 2:
        raise UsageError(f"no register or field of words begins at 0x{address:04X}, so that `{item}` has no meaning")
    data = _bytes(layout, occupant, item)
    big = layout.device.byte_order == "big"
    for at in range(0, len(data), 2):
        yield int.from_bytes(data[at : at + 2], "big" if big else "little")


def _bytes(layout: DeviceLayout, occupant: Occupant, item: str) -> bytes:
    """The bytes of a value as they lie in the registers."""
    from fieldspec.reference.records import encoded_value, value_construct

    raw = raw_value(layout.device, occupant.path, occupant.value, item)
    known = encoded_value(occupant.path, occupant.value, raw, layout.device)
    built: bytes = value_construct(occupant.value, occupant.order, occupant.swapped).build(known)
    return built
