"""The registers that frames carry, decoded as columns: every register in every frame is one row."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from fieldspec.codec.explain.occupants import Occupant, occupants
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.language.model.value import Value
from fieldspec.tools.captures.columns import Bytes, Mask, Numbers, numbers, runs, spread
from fieldspec.tools.captures.decoders import Decoders, ValueColumns
from fieldspec.tools.captures.verdicts import PARTIAL, UNLISTED

ADDRESSES = 1 << 16
"""The addresses that a frame can have."""


def _bare(type_name: str) -> Value:
    """A value of a type without any meaning."""
    from decimal import Decimal

    kind = PRIMITIVES[type_name]
    return Value(kind, kind.size, None, "", Decimal(1), "", Decimal(0), "", None, None, None, "", "", None, ())


@dataclass(frozen=True, slots=True)
class Accesses:
    """What frames access of one space. `count` words or bits from `address` on, whose bytes begin at `data`.

    `available` are the bytes of the data in the frame. `frame` is the row of the frame, `is_write` whether it writes.
    """

    frame: Numbers
    address: Numbers
    count: Numbers
    data: Numbers
    available: Numbers
    is_write: Mask


@dataclass(frozen=True, slots=True)
class RegisterRows:
    """The registers in some frames. `register` is a place in the paths of the map, `frame` the row of the frame."""

    frame: Numbers
    register: Numbers
    address: Numbers
    is_write: Mask
    values: ValueColumns


class RegisterMap:
    """The registers, the fields of tables and the unlisted addresses of one space, by address.

    `paths` and `units` have the name and the unit of each; unlisted addresses are their own names.
    """

    def __init__(self, layout: DeviceLayout, space: str, decoders: Decoders) -> None:
        self.decoders = decoders
        self._known: dict[tuple[object, ...], int] = {}
        self.is_bits = layout.device.space(space).unit == BIT
        self.unit_size = layout.device.space(space).unit_size
        present = sorted(occupants(layout, Span(space, 0, ADDRESSES, 0, b"")), key=lambda occupant: occupant.address)
        own = [occupant for occupant in present if 0 <= occupant.address < ADDRESSES]
        covered = np.zeros(ADDRESSES, np.bool_)
        for occupant in own:
            covered[occupant.address : occupant.address + occupant.words] = True
        free = np.flatnonzero(~covered)
        bare = decoders.place(_bare("bit" if self.is_bits else f"u{8 * self.unit_size}"), "big", False)
        addresses = np.concatenate([numbers([occupant.address for occupant in own]), free])
        order = np.argsort(addresses, kind="stable")
        self.names = [occupant.path for occupant in own]
        self.places = order
        self.own_count = len(own)
        self.address = addresses[order]
        self.words = self._column(own, [occupant.words for occupant in own], free, 1, order)
        size = 1 if self.is_bits else self.unit_size
        self.size = self._column(own, [occupant.value.size for occupant in own], free, size, order)
        self.skip = self._column(own, [occupant.skip for occupant in own], free, 0, order)
        self.widest = int(self.words.max())
        reads = [self._decoder(occupant, False) for occupant in own]
        writes = [self._decoder(occupant, True) for occupant in own]
        self.decoder = np.stack(
            [self._column(own, reads, free, bare, order), self._column(own, writes, free, bare, order)]
        )
        self.units = [occupant.value.unit for occupant in own]
        self.occupants = own

    @staticmethod
    def _column(own: list[Occupant], values: Iterable[int], free: Numbers, other: int, order: Numbers) -> Numbers:
        column = np.full(len(own) + len(free), other, np.int64)
        column[: len(own)] = list(values)
        return column[order]

    def _decoder(self, occupant: Occupant, is_write: bool) -> int:
        """The place of the decoder of a register, computed once for all elements that share a value."""
        swapped = occupant.is_swapped("write" if is_write else "read")
        key = id(occupant.value), is_write, occupant.order, swapped, occupant.reserved, occupant.trigger
        if key not in self._known:
            value = occupant.value.for_writing() if is_write else occupant.value.as_answer(False)
            is_lenient = occupant.trigger and not is_write
            self._known[key] = self.decoders.place(value, occupant.order, swapped, occupant.reserved, is_lenient)
        return self._known[key]

    def name(self, place: int) -> str:
        """The path of a register, or an address that no register has."""
        own = int(self.places[place])
        return self.names[own] if own < self.own_count else f"0x{int(self.address[place]):04X}"

    def unit(self, place: int) -> str:
        """The unit of the values of a register; empty where they have none."""
        own = int(self.places[place])
        return self.units[own] if own < self.own_count else ""

    def rows(self, buffer: Bytes, accesses: Accesses) -> RegisterRows:
        """All registers that the accessed words touch. One of which the frame has only a part is `partial`."""
        start = accesses.address
        available = accesses.available * 8 if self.is_bits else accesses.available // self.unit_size
        end = start + np.minimum(accesses.count, available)
        first = np.searchsorted(self.address, start - self.widest + 1, "left")
        last = np.searchsorted(self.address, end, "left")
        frame, number = spread(np.maximum(last - first, 0))
        place = first[frame] + number
        if self.widest > 1:
            touched = self.address[place] + self.words[place] > start[frame]
            if not touched.all():
                frame, place = frame[touched], place[touched]
        address, is_write = self.address[place], accesses.is_write[frame]
        relative = address - start[frame]
        values = ValueColumns.empty(len(place))
        decoder = self.decoder[is_write.astype(np.int8), place]
        if self.is_bits:
            offsets = accesses.data[frame] + relative // 8
            whole = np.ones(len(place), np.bool_)
        else:
            offsets = accesses.data[frame] + self.unit_size * relative + self.skip[place]
            whole = (relative >= 0) & (address + self.words[place] <= end[frame])
        for key, rows in runs(np.where(whole, decoder, -1).astype(np.int16)):
            if key < 0:
                values.verdict[rows] = PARTIAL
            elif self.is_bits:
                bits = buffer[offsets[rows]].astype(np.int64) >> (relative[rows] % 8) & 1
                values.put(rows, self.decoders.items[key].of_bits(bits))
            else:
                values.put(rows, self.decoders.items[key].decode(buffer, offsets[rows]))
        unlisted = self.places[place] >= self.own_count
        values.verdict[unlisted] = UNLISTED
        return RegisterRows(accesses.frame[frame], place, address, is_write, values)


def spaces_of(layout: DeviceLayout) -> list[str]:
    """The names of the spaces that messages of a device access; the first one may be empty."""
    device = layout.device
    accesses = (message.message.single_access for message in layout.messages.values())
    names = (device.space_name(access.space) for access in accesses if access is not None)
    return list(dict.fromkeys(names))
