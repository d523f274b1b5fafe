"""What is at which address or number: used, reserved, left out, and held twice, block by block."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, pairwise

from fieldspec.audit.occupants import Occupant, element_runs, of_message, of_parameter, of_register
from fieldspec.classes import dataclass, replace
from fieldspec.layout.device import DeviceLayout, TableLayout
from fieldspec.model.device import Device
from fieldspec.model.fact import Place
from fieldspec.model.link import Link
from fieldspec.model.registers import ParameterSet, Register, RegisterGroup

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
    OVERLAP: "held twice",
    DECLARED: "declared gap",
    UNDECLARED: "undeclared gap",
    UNLISTED: "not listed",
}
"""How an address may stand, with the words for it."""


HOLES_MEANT = 4
"""Where at least one of so many steps in a set of parameters skips numbers, it lists some of them only."""


@dataclass(frozen=True, slots=True)
class Run:
    """Neighbouring addresses, `first` to `last`, that stand alike and have the same holders.

    `reason` is why they are left out, or why they may be held twice. One that is not `own` belongs to another block.
    """

    first: int
    last: int
    state: str
    holders: tuple[Occupant, ...] = ()
    reason: str = ""
    is_device_specific: bool = True

    @property
    def size(self) -> int:
        """How many addresses it has."""
        return self.last - self.first + 1


@dataclass(frozen=True, slots=True)
class Block:
    """Addresses that the manual lists together, run by run without a hole.

    A table's block has the runs of its first element, which stands `repeats` times, `stride` addresses apart.
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
        return max(run.last for run in self.runs if run.holders or self.repeats == 1) + (self.repeats - 1) * self.stride

    def count(self, state: str) -> int:
        """How many of its own addresses stand so."""
        own = sum(run.size for run in self.runs if run.state == state and run.is_device_specific)
        if self.repeats > 1 and state == DECLARED:  # nothing is left out behind the last element
            return own * (self.repeats - 1)
        return own * self.repeats


@dataclass(frozen=True, slots=True)
class Alias:
    """A value that stands at two addresses, by name and address."""

    holder: Occupant
    address: int
    of: Occupant
    of_address: int
    copied: bool


@dataclass(frozen=True, slots=True)
class Space:
    """All addresses, numbers or codes of one kind: what they are called, and their number of hexadecimal digits."""

    name: str
    title: str
    what: str
    digits: int
    blocks: tuple[Block, ...]
    aliases: tuple[Alias, ...] = ()

    def count(self, state: str) -> int:
        """How many addresses stand so."""
        return sum(block.count(state) for block in self.blocks)

    def number_text(self, number: int) -> str:
        """A number as reports show it."""
        return f"{number:0{self.digits}X}h"


def spaces_of(layout: DeviceLayout) -> tuple[Space, ...]:
    """The spaces of registers and of parameters, and the codes and numbers of messages, as far as there are such."""
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
    """A space of registers; an empty name means the only one."""
    device = layout.device

    def own(space: str) -> bool:
        return not name or device.space_name(space) == name

    groups = [group for group in device.groups if own(group.space)]
    tables = [table for table in layout.tables.values() if own(table.table.space)]
    extents = [
        (first, last, holder, group.place.path)
        for group in groups
        for register in group.registers
        for first, last, holder in of_register(register)
    ]
    for table in tables:
        last = table.table.address(table.table.indexes[-1]) + max(table.words, 1) - 1
        extents.append((table.table.base, last, Occupant.of(table.table, "table"), table.table.place.path))
    blocks = [_group(group, extents) for group in groups if group.registers]
    blocks += [_table(table, extents) for table in tables]
    ordered = tuple(sorted(blocks, key=lambda block: block.first))
    aliases = tuple(alias for register, alias in _aliases(device) if own(register.space))
    if not name:
        return Space("registers", "Registers", "words", 4, ordered, aliases)
    return Space(name, device.space(name).title or name, "words", 4, ordered, aliases)


Extent = tuple[int, int, Occupant, str]


def _group(group: RegisterGroup, extents: Sequence[Extent]) -> Block:
    ends = [(first, last) for first, last, _, path in extents if path == group.place.path]
    low, high = min(first for first, _ in ends), max(last for _, last in ends)
    gaps = [(*pair, gap.reason) for gap in group.gaps for pair in gap.addresses.intervals]
    runs = tuple(_runs(low, high, extents, gaps, group.place.path))
    return Block(group.name, group.title or group.name, group.place.path, group.place, runs)


def _table(table_layout: TableLayout, extents: Sequence[Extent]) -> Block:
    table = table_layout.table
    runs = [
        Run(first, last, RESERVED if occupant.reserved else USED, (occupant,))
        for first, last, occupant in element_runs(table_layout)
    ]
    end = runs[-1].last + 1 if runs else table.base
    behind = table.base + table.stride - 1
    if end <= behind and table.count > 1:
        reason = f"an element has {end - table.base} words, the next one begins {table.stride} words behind it"
        runs += _runs(
            end, behind, [extent for extent in extents if extent[3] != table.place.path], [(end, behind, reason)], ""
        )
    return Block(
        table.name, table.title or table.name, table.place.path, table.place, tuple(runs), table.count, table.stride
    )


def _runs(
    low: int, high: int, extents: Iterable[Extent], gaps: Iterable[tuple[int, int, str]], own: str
) -> Iterator[Run]:
    """The runs of some addresses: what holds each, or why nothing does. `own` is the path of the block."""
    inside = [extent for extent in extents if extent[0] <= high and extent[1] >= low]
    cut = {low, high + 1}
    for first, last in (*((extent[0], extent[1]) for extent in inside), *((extent[0], extent[1]) for extent in gaps)):
        cut |= {max(first, low), min(last, high) + 1}
    bounds = sorted(bound for bound in cut if low <= bound <= high + 1)
    starting = sorted(enumerate(inside), key=lambda pair: pair[1][0], reverse=True)
    current: list[tuple[int, Extent]] = []
    pieces = []
    for first, behind in pairwise(bounds):
        # Bounds are cut wherever something begins or ends, so what reaches into a piece holds all of it.
        while starting and starting[-1][1][0] <= first:
            current.append(starting.pop())
        current = [pair for pair in current if pair[1][1] >= first]
        here = [extent for _, extent in sorted(current, key=lambda pair: pair[0])]
        pieces.append(_piece(first, behind - 1, here, gaps, own))
    for _, alike in groupby(pieces, key=lambda run: (run.state, run.holders, run.reason, run.is_device_specific)):
        some = list(alike)
        yield replace(some[0], last=some[-1].last)


def _piece(first: int, last: int, extents: Iterable[Extent], gaps: Iterable[tuple[int, int, str]], own: str) -> Run:
    here = [(holder, path) for a, b, holder, path in extents if a <= first and last <= b]
    holders = tuple(holder for holder, _ in here)
    if not holders:
        reason = next((text for a, b, text in gaps if a <= first and last <= b), None)
        return Run(first, last, UNDECLARED if reason is None else DECLARED, (), reason or "")
    mine = not own or any(path == own for _, path in here)
    if len(holders) > 1:
        reasons = [reason for holder in holders if (reason := holder.allowed.get("addresses_disjoint"))]
        return Run(first, last, OVERLAP, holders, "; ".join(dict.fromkeys(reasons)), mine)
    return Run(first, last, RESERVED if holders[0].reserved else USED, holders, "", mine)


def _aliases(device: Device) -> Iterator[tuple[Register, Alias]]:
    """The registers that hold the same value as another one, and those of blocks that stand twice."""
    named = {register.name: register for register in device.registers()}
    for register in device.registers():
        for name, copied in ((register.same_as, False), (register.copy_of, True)):
            other = named.get(name)
            if other is not None:
                own, two = Occupant.of(register, ""), Occupant.of(other, "")
                yield register, Alias(own, register.address, two, other.address, copied)


def _parameters(name: str, sets: Sequence[ParameterSet]) -> Space:
    blocks = sorted(
        (_set(parameter_set) for parameter_set in sets if parameter_set.parameters), key=lambda block: block.first
    )
    highest = max((block.last for block in blocks), default=0)
    title = sets[0].title if len(sets) == 1 and sets[0].title else f"Parameters: {name.replace('_', ' ')}"
    return Space(name, title, "numbers", 4 if highest > 0xFF else 2, tuple(blocks))


def _set(parameter_set: ParameterSet) -> Block:
    rows = [
        (first + parameter_set.base, last + parameter_set.base, holder, parameter_set.place.path)
        for parameter in parameter_set.parameters
        for first, last, holder in of_parameter(parameter)
    ]
    gaps = []
    ordered = sorted(parameter_set.parameters, key=lambda parameter: parameter.number)
    for before, after in pairwise(ordered):
        reason = before.allowed.get("parameter_numbers_ascending") or after.allowed.get("parameter_numbers_ascending")
        if reason:
            gaps.append(
                (parameter_set.base + before.number + before.count, parameter_set.base + after.number - 1, reason)
            )
    low, high = min(first for first, *_ in rows), max(last for _, last, *_ in rows)
    whole = parameter_set.numbers.intervals if parameter_set.numbers is not None else ()
    low, high = (
        min((low, *(parameter_set.base + a for a, _ in whole))),
        max((high, *(parameter_set.base + b for _, b in whole))),
    )
    runs = tuple(_runs(low, high, rows, gaps, parameter_set.place.path))
    skips = sum(1 for before, after in pairwise(ordered) if after.number > before.number + before.count)
    if parameter_set.numbers is not None:
        runs = tuple(replace(run, state=UNDESCRIBED) if not run.holders else run for run in runs)
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
    """The codes of messages, or the numbers of those without a code, link by link where they differ."""
    seen: set[tuple[str, ...]] = set()
    for link in device.links.values():
        sent = [message for message in device.messages.values() if not message.links or link.name in message.links]
        for coded in (True, False):
            numbered = [
                (number, number, of_message(message), "")
                for message in sent
                if (number := message.code if coded else message.number) is not None
                and coded == (message.code is not None)
            ]
            names = tuple(holder.name for *_, holder, _ in numbered)
            if numbered and names not in seen:
                seen.add(names)
                yield _codes(link, coded, sorted(numbered, key=lambda extent: extent[:2]))


def _codes(link: Link, coded: bool, extents: Sequence[Extent]) -> Space:
    part = next((header_part.name for header_part in link.request if header_part.role == "code"), link.message_name)
    word = (part if coded else link.message_name).replace("_", " ")
    what = f"{word} codes" if coded else f"{word} numbers"
    low, high = extents[0][0], extents[-1][1]
    runs = _runs(low, high, extents, [], "")
    all_runs = tuple(run if run.holders else replace(run, state=UNLISTED) for run in runs)
    block = Block(word, what, link.place.path, link.place, all_runs)
    title = what[:1].upper() + what[1:]
    return Space(f"{link.name}_{what}".replace(" ", "_"), title, what, 2 if high <= 0xFF else 4, (block,))
