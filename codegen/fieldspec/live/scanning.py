"""Finds out which addresses of a device answer. It only reads, and leaves out what a read changes."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.read_plan import read_plan
from fieldspec.live.client import Client, RefusedError
from fieldspec.live.reading import all_occupants, read_words
from fieldspec.model.registers import Register

_PAGE = 0x100


@dataclass(frozen=True, slots=True)
class Scan:
    """The addresses that were asked for, those that answer with their words, and those that were left out."""

    space: str
    asked: frozenset[int]
    words: dict[int, int]
    left_out: frozenset[int]


@dataclass(frozen=True, slots=True)
class ScanComparison:
    """A scan compared with a version: intervals that answer and are unknown, and names of values that do not answer."""

    version: str
    unknown: tuple[tuple[int, int], ...]
    silent: tuple[str, ...]

    @property
    def differences(self) -> int:
        """How many words and values differ."""
        return sum(last - first + 1 for first, last in self.unknown) + len(self.silent)


def usual_ranges(layout: DeviceLayout, space: str) -> list[range]:
    """The pages of 256 addresses that have registers."""
    pages = sorted({occupant.address // _PAGE for own, occupant in all_occupants(layout) if own == space})
    return [range(page * _PAGE, (page + 1) * _PAGE) for page in pages]


def scan(client: Client, space: str, ranges: list[range], done: Callable[[int], None] | None = None) -> Scan:
    """Reads all addresses of some ranges, in large requests where the device answers them.

    What is cleared by reading, or starts something, is left out. Raises NoAnswerError and CarrierError.
    """
    layout = client.layout
    spared = {
        address
        for own, occupant in all_occupants(layout)
        if own == space and isinstance(occupant.fact, Register) and occupant.fact.handling.clears_on_read
        for address in range(occupant.address, occupant.address + occupant.words)
    }
    plan = read_plan(layout)
    limit = plan.limit(space) or plan.limit("")
    most = limit.words if limit is not None and limit.words is not None else 1
    words: dict[int, int] = {}
    asked: set[int] = set()
    for addresses in ranges:
        for run in _runs(addresses, spared):
            for start in range(run.start, run.stop, most):
                part = range(start, min(start + most, run.stop))
                asked.update(part)
                _scan_part(client, space, part, words)
                if done is not None:
                    done(len(part))
    return Scan(space, frozenset(asked), words, frozenset(spared))


def _runs(addresses: range, spared: set[int]) -> Iterator[range]:
    """The parts of a range without the addresses that are left out."""
    start = addresses.start
    for address in sorted(address for address in spared if address in addresses):
        if address > start:
            yield range(start, address)
        start = address + 1
    if start < addresses.stop:
        yield range(start, addresses.stop)


def _scan_part(client: Client, space: str, part: range, words: dict[int, int]) -> None:
    """Reads a part, and divides it where the device refuses it."""
    try:
        words.update(zip(part, read_words(client, space, part.start, len(part)), strict=True))
    except RefusedError:
        if len(part) > 1:
            middle = part.start + len(part) // 2
            _scan_part(client, space, range(part.start, middle), words)
            _scan_part(client, space, range(middle, part.stop), words)


def compared(layout: DeviceLayout, result: Scan) -> ScanComparison:
    """A scan compared with the spec of a version."""
    known: set[int] = set()
    silent = []
    for space, occupant in all_occupants(layout):
        if space != result.space:
            continue
        own = range(occupant.address, occupant.address + occupant.words)
        known.update(own)
        readable = occupant.access != "wo" and not occupant.reserved
        if readable and result.asked.issuperset(own) and not all(address in result.words for address in own):
            silent.append(occupant.path)
    unknown: list[tuple[int, int]] = []
    for address in sorted(address for address in result.words if address not in known):
        if unknown and unknown[-1][1] == address - 1:
            unknown[-1] = (unknown[-1][0], address)
        else:
            unknown.append((address, address))
    return ScanComparison(layout.device.version, tuple(unknown), tuple(silent))
