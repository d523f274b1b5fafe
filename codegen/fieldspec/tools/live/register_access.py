"""Registers of a device as values by name."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

from fieldspec.codec.explain.hazards import roles_of
from fieldspec.codec.explain.occupants import (
    absent_text,
    base_of_table,
    count_of_occupant,
    element_number,
    exponent_of_occupant,
)
from fieldspec.codec.explain.values import exponent_applied
from fieldspec.codec.layout.bases import at_bases, at_usual_bases, moving_tables
from fieldspec.foundation.classes import replace
from fieldspec.language.model.access import readable, writable
from fieldspec.language.model.registers import Table
from fieldspec.tools.live import writing
from fieldspec.tools.live.access import Access, DumpRow, role_masks
from fieldspec.tools.live.bases import read_bases
from fieldspec.tools.live.reading import Reading, all_occupants, blocks, read, reading
from fieldspec.tools.live.shared_words import SharedWords, merged
from fieldspec.tools.live.value_lists import COMMANDS
from fieldspec.tools.live.writing import Assignment, request_frame

if TYPE_CHECKING:
    from typing import TypeAlias

    from fieldspec.codec.explain.occupants import Occupant
    from fieldspec.codec.layout.device import DeviceLayout
    from fieldspec.language.model.address_space import AddressSpace
    from fieldspec.language.model.value import Value
    from fieldspec.tools.live.client import Client

    Placed: TypeAlias = tuple[str, Occupant]


class RegisterAccess(Access):
    """The registers of a device. An item is what is at an address, with its space."""

    what, rows_text = "register", "words"

    def __init__(self, layout: DeviceLayout) -> None:
        self.layout = layout
        self._moving = moving_tables(layout)
        self._usual = self._located = at_usual_bases(layout)
        self._items = list(all_occupants(self._usual))
        self._shared = SharedWords(layout, self._items)

    def heading(self, value: Reading) -> str:
        return "address"

    def number(self, value: Reading) -> int:
        return value.occupant.address

    def number_text(self, value: Reading) -> str:
        return f"0x{value.occupant.address:04X}"

    def dump_rows(self, items: Sequence[Placed], values: Sequence[Reading]) -> list[DumpRow]:
        """A row for each word of values that were read, in the order of their addresses."""
        words = {
            (space, value.occupant.address + offset): word
            for (space, _), value in zip(items, values, strict=True)
            for offset, word in enumerate(value.words)
        }
        return [DumpRow(space, address, str(words[space, address])) for space, address in sorted(words)]

    def items(self) -> Sequence[Placed]:
        return self._items

    def path(self, item: Placed) -> str:
        return item[1].path

    def value(self, item: Placed) -> Value:
        return item[1].value

    def named(self, name: str) -> list[Placed]:
        """The register with a name, the elements of an array, the fields of a record, a role, an address."""
        if self._space_of_doubt(name) is None:
            pairs = [pair for pair in self._items if writing.means(name, pair[1])]
            if pairs:
                return pairs
        return [pair for pair in self._items if self._has_printed_number(pair, name)]

    def _has_printed_number(self, pair: Placed, text: str) -> bool:
        """Whether a text is the number that the manual prints for the address of an item, such as 40003."""
        space, occupant = pair
        return text.isdecimal() and self.layout.device.space(space).address_of(int(text)) == occupant.address

    def _space_of_doubt(self, text: str) -> AddressSpace | None:
        """The space in which a decimal number may be an address, or the manual prints it for another one."""
        if not text.isdecimal():
            return None
        number = int(text)
        spaces = (self.layout.device.space(name) for name in dict.fromkeys(name for name, _ in self._items))
        doubtful = (space for space in spaces if space.first_number and not space.has_numbers_apart)
        return next((own for own in doubtful if number in own.bounds or number - own.first_number in own.bounds), None)

    def harmless(self) -> list[Placed]:
        """The items of the read plan that are read without an effect."""
        placed_items = [pair for pair in self._items if not pair[1].reserved]
        planned = [block for block in blocks(self._usual, placed_items) if all(map(_is_harmless, block.occupants))]
        return [(block.space, occupant) for block in planned for occupant in block.occupants]

    def reason_unread(self, name: str) -> str:
        """Why an element is beyond its table, or a decimal number is not a name.

        Manuals print numbers that are addresses of other registers.
        """
        element = re.match(r"(\w+)\[(\d{1,9})\]", name)
        table = self.layout.tables.get(element[1]) if element else None
        if element and table is not None and int(element[2]) not in table.table.indexes:
            numbers = table.table.indexes
            return f"there is no {element[0]}; {element[1]} has the elements {numbers[0]} to {numbers[-1]}"
        space = self._space_of_doubt(name)
        if space is None:
            return ""
        number, first = int(name), space.first_number
        printed = f" or the number that the manual prints for 0x{number - first:04X}" if number >= first else ""
        return f"{name} may be the address 0x{number:04X}{printed}; write the name, or the address as 0x..."

    def remarks(self, names: Sequence[str]) -> list[str]:
        """No remarks: every register is read."""
        return []

    def objection(self, item: Placed) -> str:
        return _objection(self.layout, item[1]) or self._shared.objection(item, partial(_objection, self.layout))

    def assignment(self, item: Placed, text: str) -> Assignment:
        return writing.assignment(self.layout, *item, text)

    def together(self, chosen: Sequence[Assignment]) -> tuple[list[Assignment], dict[str, str]]:
        """Assignments with the words of all values that share a word, and by path why some are not written."""
        return self._shared.together(chosen)

    def intended(self, chosen: Assignment) -> Reading:
        return reading(self.layout, chosen.space, chosen.occupant, chosen.words)

    def size(self, items: Iterable[Placed]) -> int:
        """The number of words in all requests."""
        return sum(block.words for block in blocks(self._usual, self._with_exponents(items)))

    def read(
        self, client: Client, items: Sequence[Placed], done: Callable[[int], None] | None = None
    ) -> Iterator[Reading]:
        """Reads items in as few requests as the device permits. Raises NoAnswerError and CarrierError."""
        bases = self._bases(client, items)
        items = [self._moved(item, bases) for item in items]
        by_path = self._counts(client, items)
        rest = [item for item in self._with_exponents(items) if self.path(item) not in by_path]
        for item in rest:
            absence, base = self._absence(item, by_path), bases.get(item[1].outer.name)
            if isinstance(base, str):
                by_path[self.path(item)] = Reading(item[1], (), None, base)
            elif absence:
                by_path[self.path(item)] = Reading(item[1], (), None, absence, is_absent=True)
        present = [item for item in rest if self.path(item) not in by_path]
        by_path |= {value.path: value for value in read(client, blocks(self._located, present), done)}
        return (self._scaled(item, by_path) for item in items)

    def _bases(self, client: Client, items: Sequence[Placed]) -> dict[str, int | str]:
        """Where the tables begin in which items are, as far as the device says it; the read plan is that of these
        addresses."""
        names = dict.fromkeys(
            occupant.outer.name
            for _, occupant in items
            if isinstance(occupant.outer, Table) and occupant.outer.name in self._moving
        )
        bases = read_bases(client, self.layout, names)
        known = {name: base for name, base in bases.items() if isinstance(base, int)}
        if any(self._located.tables[name].table.base != base for name, base in known.items()):
            self._located = at_bases(self._usual, known)
        return bases

    def _moved(self, item: Placed, bases: Mapping[str, int | str]) -> Placed:
        """An item at the address that the device says."""
        space, occupant = item
        table, base = occupant.outer, bases.get(occupant.outer.name)
        if not isinstance(table, Table) or not isinstance(base, int):
            return item
        outer = replace(table, base=base)
        return space, replace(occupant, address=occupant.address + base - table.base, outer=outer)

    def _placed(self, client: Client, chosen: Assignment) -> Assignment:
        """An assignment at the address that the device says. Raises WriteError."""
        item = self.item(chosen)
        bases = self._bases(client, [item])
        unknown = next((base for base in bases.values() if isinstance(base, str)), "")
        if unknown:
            raise writing.WriteError(unknown)
        return replace(chosen, occupant=self._moved(item, bases)[1]) if bases else chosen

    def _counts(self, client: Client, items: Sequence[Placed]) -> dict[str, Reading]:
        """The numbers of elements of the tables in which items are, as far as the device has them in registers."""
        counts: dict[str, Placed] = {}
        for space, occupant in items:
            count = count_of_occupant(self.layout, occupant)
            if count is not None:
                counts.setdefault(count.path, (space, count))
        return {value.path: value for value in read(client, blocks(self.layout, list(counts.values())))}

    def _absence(self, item: Placed, counts: Mapping[str, Reading]) -> str:
        """Why an item is not read: the device says that it has not got the element; empty where it may have it."""
        count = count_of_occupant(self.layout, item[1])
        decoded = counts[count.path].decoded if count is not None else None
        if count is None or decoded is None or not isinstance(decoded.number, int):
            return ""
        return absent_text(count, decoded.number) if element_number(item[1]) >= decoded.number else ""

    def _with_exponents(self, items: Iterable[Placed]) -> list[Placed]:
        """Items and what has the exponents of their scales, each once."""
        items_by_path = {self.path(item): item for item in items}
        for space, occupant in list(items_by_path.values()):
            exponent = exponent_of_occupant(self.layout, occupant)
            if exponent is not None:
                items_by_path.setdefault(exponent.path, (space, exponent))
        return list(items_by_path.values())

    def _scaled(self, item: Placed, by_path: Mapping[str, Reading]) -> Reading:
        """The value that was read of an item, as a quantity where the exponent of its scale was read, too."""
        own, (space, occupant) = by_path[self.path(item)], item
        place = exponent_of_occupant(self.layout, occupant)
        exponent = by_path.get(place.path) if place is not None else None
        if exponent is None or exponent.decoded is None or own.decoded is None:
            return own
        value = exponent_applied(occupant.value, exponent.occupant.value, exponent.decoded.number)
        if value is occupant.value:
            return own
        return replace(reading(self.layout, space, replace(occupant, value=value), own.words), occupant=occupant)

    def frame(self, client: Client, chosen: Assignment) -> bytes:
        return request_frame(client, chosen)[2]

    def address_register(self, chosen: Assignment) -> str:
        table = chosen.occupant.outer
        is_moving = isinstance(table, Table) and table.name in self._moving
        return base_of_table(self.layout, table.name).path if is_moving else ""

    def write(self, client: Client, chosen: Assignment) -> None:
        writing.write(client, self._placed(client, chosen))

    def read_back(self, client: Client, chosen: Assignment) -> Reading | None:
        try:
            placed = self._placed(client, chosen)
        except writing.WriteError as error:
            return Reading(chosen.occupant, (), None, str(error))
        return writing.read_back(client, placed)

    def signals(self, item: Placed, roles: Sequence[str]) -> Iterator[tuple[str, int]]:
        occupant = item[1]
        if readable(occupant.access):
            yield from role_masks(self.layout.device, occupant.fact, occupant.value, roles)

    def item(self, chosen: Assignment) -> Placed:
        return chosen.space, chosen.occupant

    def words_of(self, value: Reading, text: str) -> tuple[int, ...]:
        own = writing.assignment(self.layout, "", value.occupant, text)
        return merged(value.words, own.words, own.mask) if own.mask else own.words


def _is_harmless(occupant: Occupant) -> bool:
    return occupant.access in ("ro", "rw") and not occupant.clears_on_read


def _objection(layout: DeviceLayout, occupant: Occupant) -> str:
    """Why a value is in no list that is written to a device, for its own sake; empty where it may be."""
    if occupant.reserved or getattr(occupant.fact, "reserved", False):
        return "is reserved"
    if occupant.trigger or COMMANDS.intersection(roles_of(layout.device, occupant.fact, occupant.value)):
        return "commands the device; write it by its name, with the verb write"
    if not writable(occupant.access):
        return "can only be read" if occupant.access else "is not stated to be writable"
    if not readable(occupant.access) or occupant.clears_on_read:
        return "cannot be read back, so that nothing could be verified; write it by its name, with the verb write"
    return ""
