"""The occupants of all addresses and numbers, block by block: what is used, reserved, a gap, or occupied twice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, pairwise
from typing import NamedTuple

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Place
from fieldspec.language.model.link import Link
from fieldspec.language.model.registers import ParameterSet, Register, RegisterGroup
from fieldspec.tools.audit.occupants import Occupant, element_runs, of_message, of_parameter, of_register

USED, RESERVED, UNDESCRIBED, OVERLAP, DECLARED, UNDECLARED, UNLISTED = (
    "used",
    "reserved",
    "undescribed",
    "overlap",
    "declared_gap",
    "undeclared_gap",
    "unlisted",
)
STATES = {
    USED: "used",
    RESERVED: "reserved",
    UNDESCRIBED: "there, described elsewhere",
    OVERLAP: "occupied twice",
    DECLARED: "declared gap",
    UNDECLARED: "undeclared gap",
    UNLISTED: "not listed",
}
"""The states of an address, with the words for them."""

HOLES_MEANT = 4
"""Where at least one step in this many skips numbers, a set of parameters lists only some of its numbers."""


@dataclass(frozen=True, slots=True)
class Run:
    """Neighbouring addresses, `first` to `last`, in the same state and with the same occupants.

    `reason` is why the manual leaves them out, or why they may have several occupants. A run is not `is_own` where its
    addresses belong to another block.
    """

    first: int
    last: int
    state: str
    occupants: tuple[Occupant, ...] = ()
    reason: str = ""
    is_own: bool = True

    @property
    def size(self) -> int:
        """The number of addresses."""
        return self.last - self.first + 1


@dataclass(frozen=True, slots=True)
class Block:
    """Addresses that the manual lists together, as runs without a hole between them.

    The block of a record table has the runs of the first element, which repeats every `stride` addresses.
    """

    name: str
    title: str
    path: str
    place: Place
    runs: tuple[Run, ...]
    repeats: int = 1
    stride: int = 0

    @property
    def first(self) -> int:
        """The first address."""
        return self.runs[0].first

    @property
    def last(self) -> int:
        """The last address, of the last element."""
        return (
            max(run.last for run in self.runs if run.occupants or self.repeats == 1) + (self.repeats - 1) * self.stride
        )

    def count(self, state: str) -> int:
        """The number of its own addresses in a state."""
        own = sum(run.size for run in self.runs if run.state == state and run.is_own)
        if self.repeats > 1 and state == DECLARED:  # there is no gap after the last element
            return own * (self.repeats - 1)
        return own * self.repeats


@dataclass(frozen=True, slots=True)
class Alias:
    """A value with two addresses: `occupant` at `address` is the same as, or a copy of, `of` at `of_address`."""

    occupant: Occupant
    address: int
    of: Occupant
    of_address: int
    copied: bool


@dataclass(frozen=True, slots=True)
class Space:
    """All addresses, numbers or codes of one kind. `what` is their plural, `digits` the width of a printed number."""

    name: str
    title: str
    what: str
    digits: int
    blocks: tuple[Block, ...]
    aliases: tuple[Alias, ...] = ()

    def count(self, state: str) -> int:
        """The number of addresses in a state."""
        return sum(block.count(state) for block in self.blocks)

    def number_text(self, number: int) -> str:
        """A number as reports print it."""
        return f"0x{number:0{self.digits}X}"


class Extent(NamedTuple):
    """The first and the last address of an occupant, and the path of its block."""

    first: int
    last: int
    occupant: Occupant
    block: str


class GapExtent(NamedTuple):
    """The first and the last address that the manual leaves out, and why."""

    first: int
    last: int
    reason: str


def spaces_of(layout: DeviceLayout) -> tuple[Space, ...]:
    """The spaces of registers and parameters, and of the codes and numbers of messages; no empty spaces."""
    device = layout.device
    own = list(device.spaces) if device.several_spaces else [""]
    spaces = [_registers(layout, name) for name in own] if device.groups or device.tables else []
    names = dict.fromkeys(parameter_set.space for parameter_set in device.parameters.values())
    spaces += [
        _parameters(
            name, [parameter_set for parameter_set in device.parameters.values() if parameter_set.space == name]
        )
        for name in names
    ]
    spaces += _messages(device)
    return tuple(space for space in spaces if space.blocks)


def _registers(layout: DeviceLayout, name: str) -> Space:
    """A space of registers; the name is empty where a device has only one."""
    device = layout.device

    def own(space: str) -> bool:
        return not name or device.space_name(space) == name

    groups = [group for group in device.groups if own(group.space)]
    tables = [table for table in layout.tables.values() if own(table.table.space)]
    extents = [
        Extent(first, last, occupant, group.place.path)
        for group in groups
        for register in group.registers
        for first, last, occupant in of_register(register)
    ]
    for table in tables:
        last = table.table.address(table.table.indexes[-1]) + max(table.words, 1) - 1
        extents.append(Extent(table.table.base, last, Occupant.of(table.table, "table"), table.table.place.path))
    blocks = [_group(group, extents) for group in groups if group.registers]
    blocks += [_table(table, extents) for table in tables]
    ordered = tuple(sorted(blocks, key=lambda block: block.first))
    aliases = tuple(alias for register, alias in _aliases(device) if own(register.space))
    if not name:
        return Space("registers", "Registers", "words", 4, ordered, aliases)
    return Space(name, device.space(name).title or name, f"{device.space(name).unit}s", 4, ordered, aliases)


def _group(group: RegisterGroup, extents: Sequence[Extent]) -> Block:
    own = [extent for extent in extents if extent.block == group.place.path]
    low, high = min(extent.first for extent in own), max(extent.last for extent in own)
    gaps = [GapExtent(*interval, gap.reason) for gap in group.gaps for interval in gap.addresses.intervals]
    runs = tuple(_runs(low, high, extents, gaps, group.place.path))
    return Block(group.name, group.title or group.name, group.place.path, group.place, runs)


def _table(table_layout: TableLayout, extents: Sequence[Extent]) -> Block:
    table = table_layout.table
    runs = [
        Run(first, last, RESERVED if occupant.reserved else USED, (occupant,))
        for first, last, occupant in element_runs(table_layout)
    ]
    end = runs[-1].last + 1 if runs else table.base
    last_word = table.base + table.stride - 1
    if end <= last_word and table.count > 1:
        reason = f"an element has {end - table.base} words, the next one begins {table.stride} words after it"
        other_extents = [extent for extent in extents if extent.block != table.place.path]
        runs += _runs(end, last_word, other_extents, [GapExtent(end, last_word, reason)], "")
    return Block(
        table.name, table.title or table.name, table.place.path, table.place, tuple(runs), table.count, table.stride
    )


def _runs(low: int, high: int, extents: Iterable[Extent], gaps: Sequence[GapExtent], own: str) -> Iterator[Run]:
    """The runs from `low` to `high`: occupants, or the reason of a gap. `own` is the path of the block."""
    touching = [extent for extent in extents if extent.first <= high and extent.last >= low]
    cuts = {low, high + 1}
    parts: tuple[Extent | GapExtent, ...] = (*touching, *gaps)
    for part in parts:
        cuts |= {max(part.first, low), min(part.last, high) + 1}
    bounds = sorted(cut for cut in cuts if low <= cut <= high + 1)
    starting = sorted(enumerate(touching), key=lambda pair: pair[1].first, reverse=True)
    current: list[tuple[int, Extent]] = []
    pieces = []
    for first, end in pairwise(bounds):
        # There is a bound wherever an extent begins or ends, so one that reaches into a piece covers all of it.
        while starting and starting[-1][1].first <= first:
            current.append(starting.pop())
        current = [pair for pair in current if pair[1].last >= first]
        covering = [extent for _, extent in sorted(current, key=lambda pair: pair[0])]
        pieces.append(_piece(first, end - 1, covering, gaps, own))
    for _, equal in groupby(pieces, key=lambda run: (run.state, run.occupants, run.reason, run.is_own)):
        runs = list(equal)
        yield replace(runs[0], last=runs[-1].last)


def _piece(first: int, last: int, extents: Iterable[Extent], gaps: Iterable[GapExtent], own: str) -> Run:
    covering = [extent for extent in extents if extent.first <= first and last <= extent.last]
    occupants = tuple(extent.occupant for extent in covering)
    if not occupants:
        reason = next((gap.reason for gap in gaps if gap.first <= first and last <= gap.last), None)
        return Run(first, last, UNDECLARED if reason is None else DECLARED, (), reason or "")
    is_own = not own or any(extent.block == own for extent in covering)
    if len(occupants) > 1:
        reasons = [reason for occupant in occupants if (reason := occupant.allowed.get("addresses_disjoint"))]
        return Run(first, last, OVERLAP, occupants, "; ".join(dict.fromkeys(reasons)), is_own)
    return Run(first, last, RESERVED if occupants[0].reserved else USED, occupants, "", is_own)


def _aliases(device: Device) -> Iterator[tuple[Register, Alias]]:
    """The registers with the value of another one, and the copies of registers."""
    registers = {register.name: register for register in device.registers()}
    for register in device.registers():
        for name, copied in ((register.same_as, False), (register.copy_of, True)):
            other = registers.get(name)
            if other is not None:
                occupant, original = Occupant.of(register, ""), Occupant.of(other, "")
                yield register, Alias(occupant, register.address, original, other.address, copied)


def _parameters(name: str, sets: Sequence[ParameterSet]) -> Space:
    blocks = sorted(
        (_parameter_block(parameter_set) for parameter_set in sets if parameter_set.parameters),
        key=lambda block: block.first,
    )
    highest = max((block.last for block in blocks), default=0)
    title = sets[0].title if len(sets) == 1 and sets[0].title else f"Parameters: {name.replace('_', ' ')}"
    return Space(name, title, "numbers", 4 if highest > 0xFF else 2, tuple(blocks))


def _parameter_block(parameter_set: ParameterSet) -> Block:
    base = parameter_set.base
    extents = [
        Extent(first + base, last + base, occupant, parameter_set.place.path)
        for parameter in parameter_set.parameters
        for first, last, occupant in of_parameter(parameter)
    ]
    gaps = []
    ordered = sorted(parameter_set.parameters, key=lambda parameter: parameter.number)
    for before, after in pairwise(ordered):
        reason = before.allowed.get("parameter_numbers_ascending") or after.allowed.get("parameter_numbers_ascending")
        if reason:
            gaps.append(GapExtent(base + before.number + before.count, base + after.number - 1, reason))
    numbers = parameter_set.numbers.intervals if parameter_set.numbers is not None else ()
    low = min((*(extent.first for extent in extents), *(base + first for first, _ in numbers)))
    high = max((*(extent.last for extent in extents), *(base + last for _, last in numbers)))
    runs = tuple(_runs(low, high, extents, gaps, parameter_set.place.path))
    skips = sum(1 for before, after in pairwise(ordered) if after.number > before.number + before.count)
    if parameter_set.numbers is not None:
        runs = tuple(replace(run, state=UNDESCRIBED) if not run.occupants else run for run in runs)
    elif skips * HOLES_MEANT > len(ordered) - 1:
        runs = tuple(replace(run, state=UNLISTED) if run.state == UNDECLARED else run for run in runs)
    return Block(
        parameter_set.name,
        parameter_set.title or parameter_set.name,
        parameter_set.place.path,
        parameter_set.place,
        runs,
    )


def _messages(device: Device) -> Iterator[Space]:
    """The codes of messages, and the numbers of messages without a code, by link where links differ."""
    visited: set[tuple[str, ...]] = set()
    for link in device.links.values():
        link_messages = [
            message for message in device.messages.values() if not message.links or link.name in message.links
        ]
        for coded in (True, False):
            numbered = [
                Extent(number, number, of_message(message), "")
                for message in link_messages
                if (number := message.code if coded else message.number) is not None
                and coded == (message.code is not None)
            ]
            names = tuple(extent.occupant.name for extent in numbered)
            if numbered and names not in visited:
                visited.add(names)
                yield _codes(link, coded, sorted(numbered, key=lambda extent: extent[:2]))


def _codes(link: Link, coded: bool, extents: Sequence[Extent]) -> Space:
    part = next((header_part.name for header_part in link.request if header_part.role == "code"), link.message_name)
    word = (part if coded else link.message_name).replace("_", " ")
    unit_text = f"{word} codes" if coded else f"{word} numbers"
    low, high = extents[0][0], extents[-1][1]
    runs = _runs(low, high, extents, [], "")
    all_runs = tuple(run if run.occupants else replace(run, state=UNLISTED) for run in runs)
    block = Block(word, unit_text, link.place.path, link.place, all_runs)
    title = unit_text[:1].upper() + unit_text[1:]
    return Space(f"{link.name}_{unit_text}".replace(" ", "_"), title, unit_text, 2 if high <= 0xFF else 4, (block,))
