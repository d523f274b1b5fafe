"""What is at which address or number: used, reserved, left out, and held twice, block by block."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby, pairwise

from fieldspec.audit.holders import Holder, element_runs, of_message, of_parameter, of_register
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
    holders: tuple[Holder, ...] = ()
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

    holder: Holder
    address: int
    of: Holder
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


def spaces(layout: DeviceLayout) -> tuple[Space, ...]:
    """The spaces of registers and of parameters, and the codes and numbers of messages, as far as there are such."""
    device = layout.device
    own = list(device.spaces) if device.several_spaces else [""]
    found = [_registers(layout, name) for name in own] if device.groups or device.tables else []
    names = dict.fromkeys(held.space for held in device.parameters.values())
    found += [_parameters(name, [one for one in device.parameters.values() if one.space == name]) for name in names]
    found += _messages(device)
    return tuple(space for space in found if space.blocks)


def _registers(layout: DeviceLayout, name: str) -> Space:
    """A space of registers; an empty name means the only one."""
    device = layout.device

    def own(space: str) -> bool:
        return not name or device.space_name(space) == name

    groups = [group for group in device.groups if own(group.space)]
    tables = [laid for laid in layout.tables.values() if own(laid.table.space)]
    held = [
        (first, last, holder, group.place.path)
        for group in groups
        for register in group.registers
        for first, last, holder in of_register(register)
    ]
    for laid in tables:
        last = laid.table.address(laid.table.indexes[-1]) + max(laid.words, 1) - 1
        held.append((laid.table.base, last, Holder.of(laid.table, "table"), laid.table.place.path))
    blocks = [_group(group, held) for group in groups if group.registers]
    blocks += [_table(laid, held) for laid in tables]
    ordered = tuple(sorted(blocks, key=lambda block: block.first))
    aliases = tuple(alias for register, alias in _aliases(device) if own(register.space))
    if not name:
        return Space("registers", "Registers", "words", 4, ordered, aliases)
    return Space(name, device.space(name).title or name, "words", 4, ordered, aliases)


Occupant = tuple[int, int, Holder, str]


def _group(group: RegisterGroup, held: Sequence[Occupant]) -> Block:
    ends = [(first, last) for first, last, _, path in held if path == group.place.path]
    low, high = min(first for first, _ in ends), max(last for _, last in ends)
    gaps = [(*pair, gap.reason) for gap in group.gaps for pair in gap.addresses.intervals]
    runs = tuple(_runs(low, high, held, gaps, group.place.path))
    return Block(group.name, group.title or group.name, group.place.path, group.place, runs)


def _table(laid: TableLayout, held: Sequence[Occupant]) -> Block:
    table = laid.table
    runs = [Run(first, last, RESERVED if one.reserved else USED, (one,)) for first, last, one in element_runs(laid)]
    end = runs[-1].last + 1 if runs else table.base
    behind = table.base + table.stride - 1
    if end <= behind and table.count > 1:
        reason = f"an element has {end - table.base} words, the next one begins {table.stride} words behind it"
        runs += _runs(end, behind, [one for one in held if one[3] != table.place.path], [(end, behind, reason)], "")
    return Block(
        table.name, table.title or table.name, table.place.path, table.place, tuple(runs), table.count, table.stride
    )


def _runs(
    low: int, high: int, held: Iterable[Occupant], gaps: Iterable[tuple[int, int, str]], own: str
) -> Iterator[Run]:
    """The runs of some addresses: what holds each, or why nothing does. `own` is the path of the block."""
    inside = [one for one in held if one[0] <= high and one[1] >= low]
    cut = {low, high + 1}
    for first, last in (*((one[0], one[1]) for one in inside), *((one[0], one[1]) for one in gaps)):
        cut |= {max(first, low), min(last, high) + 1}
    bounds = sorted(bound for bound in cut if low <= bound <= high + 1)
    starting = sorted(enumerate(inside), key=lambda pair: pair[1][0], reverse=True)
    current: list[tuple[int, Occupant]] = []
    pieces = []
    for first, behind in pairwise(bounds):
        # Bounds are cut wherever something begins or ends, so what reaches into a piece holds all of it.
        while starting and starting[-1][1][0] <= first:
            current.append(starting.pop())
        current = [pair for pair in current if pair[1][1] >= first]
        here = [one for _, one in sorted(current, key=lambda pair: pair[0])]
        pieces.append(_piece(first, behind - 1, here, gaps, own))
    for _, alike in groupby(pieces, key=lambda run: (run.state, run.holders, run.reason, run.is_device_specific)):
        some = list(alike)
        yield replace(some[0], last=some[-1].last)


def _piece(first: int, last: int, held: Iterable[Occupant], gaps: Iterable[tuple[int, int, str]], own: str) -> Run:
    here = [(holder, path) for a, b, holder, path in held if a <= first and last <= b]
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
                one, two = Holder.of(register, ""), Holder.of(other, "")
                yield register, Alias(one, register.address, two, other.address, copied)


def _parameters(name: str, sets: Sequence[ParameterSet]) -> Space:
    blocks = sorted((_set(held) for held in sets if held.parameters), key=lambda block: block.first)
    highest = max((block.last for block in blocks), default=0)
    title = sets[0].title if len(sets) == 1 and sets[0].title else f"Parameters: {name.replace('_', ' ')}"
    return Space(name, title, "numbers", 4 if highest > 0xFF else 2, tuple(blocks))


def _set(held: ParameterSet) -> Block:
    rows = [
        (first + held.base, last + held.base, holder, held.place.path)
        for parameter in held.parameters
        for first, last, holder in of_parameter(parameter)
    ]
    gaps = []
    ordered = sorted(held.parameters, key=lambda one: one.number)
    for one, after in pairwise(ordered):
        reason = one.allowed.get("parameter_numbers_ascending") or after.allowed.get("parameter_numbers_ascending")
        if reason:
            gaps.append((held.base + one.number + one.count, held.base + after.number - 1, reason))
    low, high = min(first for first, *_ in rows), max(last for _, last, *_ in rows)
    whole = held.numbers.intervals if held.numbers is not None else ()
    low, high = min((low, *(held.base + a for a, _ in whole))), max((high, *(held.base + b for _, b in whole)))
    runs = tuple(_runs(low, high, rows, gaps, held.place.path))
    skips = sum(1 for one, after in pairwise(ordered) if after.number > one.number + one.count)
    if held.numbers is not None:
        runs = tuple(replace(run, state=UNDESCRIBED) if not run.holders else run for run in runs)
    elif skips * HOLES_MEANT > len(ordered) - 1:
        runs = tuple(replace(run, state=UNLISTED) if run.state == UNDECLARED else run for run in runs)
    return Block(held.name, held.title or held.name, held.place.path, held.place, runs)


def _messages(device: Device) -> Iterator[Space]:
    """The codes of messages, or the numbers of those without a code, link by link where they differ."""
    seen: set[tuple[str, ...]] = set()
    for link in device.links.values():
        sent = [one for one in device.messages.values() if not one.links or link.name in one.links]
        for coded in (True, False):
            numbered = [
                (number, number, of_message(one), "")
                for one in sent
                if (number := one.code if coded else one.number) is not None and coded == (one.code is not None)
            ]
            names = tuple(holder.name for *_, holder, _ in numbered)
            if numbered and names not in seen:
                seen.add(names)
                yield _codes(link, coded, sorted(numbered, key=lambda one: one[:2]))


def _codes(link: Link, coded: bool, held: Sequence[Occupant]) -> Space:
    part = next((one.name for one in link.request if one.role == "code"), link.message_name)
    word = (part if coded else link.message_name).replace("_", " ")
    what = f"{word} codes" if coded else f"{word} numbers"
    low, high = held[0][0], held[-1][1]
    runs = _runs(low, high, held, [], "")
    listed = tuple(run if run.holders else replace(run, state=UNLISTED) for run in runs)
    block = Block(word, what, link.place.path, link.place, listed)
    title = what[:1].upper() + what[1:]
    return Space(f"{link.name}_{what}".replace(" ", "_"), title, what, 2 if high <= 0xFF else 4, (block,))


__all__ = ["STATES", "Alias", "Block", "Run", "Space", "spaces"]
