"""Finds out which addresses of a device answer. It only reads, and leaves out what a read changes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

from fieldspec.codec.explain.occupants import Occupant, count_of_occupant, element_number
from fieldspec.codec.layout.bases import at_bases, moving_tables
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.read_plan import read_limit
from fieldspec.codec.layout.record import FieldLayout, Orders
from fieldspec.codec.layout.segments import SegmentsLayout, segments_of
from fieldspec.codec.reference.parameters import stated_bytes, value_of_bytes, value_of_data
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, field
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.registers import ParameterSet
from fieldspec.tools.live.bases import known_bases
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError, UnfitAnswerError
from fieldspec.tools.live.messages import parameter_message
from fieldspec.tools.live.reading import all_occupants, message_for, read_words, reading
from fieldspec.tools.live.segments import read_pieces
from fieldspec.tools.simulator.memory import element_value
from fieldspec.tools.simulator.parameters import count_field, part_of

if TYPE_CHECKING:
    from typing import Any

_PAGE = 0x100


@dataclass(frozen=True, slots=True)
class ScannedItem:
    """A value that a version has at some addresses. `spared` values are not read by a scan.

    `occupant` is what is there; None for a parameter.
    """

    path: str
    addresses: range
    readable: bool
    spared: bool
    occupant: Occupant | None = None


@dataclass(frozen=True, slots=True)
class ScanSpace:
    """Addresses that a scan can read: the addresses of a space of registers, or the numbers of `parameters`. `end` is
    after the last one, and one request reads `most` of them."""

    name: str
    end: int
    most: int
    parameters: ParameterSet | None = None


@dataclass(frozen=True, slots=True)
class Scan:
    """The requested addresses, the responding addresses with their counts, and the addresses that were left out.

    `bases` are the addresses of the tables of which the device says where they begin, by their names.
    """

    space: ScanSpace
    asked: frozenset[int]
    words: Mapping[int, tuple[int, ...]]
    left_out: frozenset[int]
    bases: Mapping[str, int] = field(default_factory=dict)

    @property
    def refused(self) -> list[int]:
        """The addresses that do not answer."""
        return sorted(self.asked - self.words.keys())


@dataclass(frozen=True, slots=True)
class ScanComparison:
    """A scan compared with a version: intervals that answer and are unknown, and names of values that do not answer."""

    unknown: tuple[tuple[int, int], ...]
    silent: tuple[str, ...]

    @property
    def differences(self) -> int:
        """The number of addresses and values that differ."""
        return sum(last - first + 1 for first, last in self.unknown) + len(self.silent)


def scan_spaces(layout: DeviceLayout, link: LinkLayout) -> list[ScanSpace]:
    """Everything that messages of a link can read by an address or a number."""
    device = layout.device
    result = []
    for name in dict.fromkeys([*device.spaces, device.space_name("")]):
        message = message_for(device, link, "read", name, 2) or message_for(device, link, "read", name, 1)
        if message is not None:
            result.append(ScanSpace(name, 0x10000, read_limit(device, message).words or 1))
    spaces: dict[str, ParameterSet] = {}
    for parameter_set in device.parameters.values():
        message_layout = parameter_message(link, parameter_set, "read")
        number = part_of(message_layout.request, "number") if message_layout is not None else None
        if number is not None and number.value is not None and parameter_set.space not in spaces:
            spaces[parameter_set.space] = parameter_set
            maximum = number.value.ranges.high if number.value.ranges is not None else number.value.type.high
            result.append(ScanSpace(parameter_set.space, int(maximum) + 1, 1, parameter_set))
    return result


def scanned_items(layout: DeviceLayout, space: ScanSpace) -> Iterator[ScannedItem]:
    """The items that a version of the device has in a space."""
    if space.parameters is None:
        for name, occupant in all_occupants(layout):
            if name == space.name:
                addresses = range(occupant.address, occupant.address + occupant.words)
                readable = occupant.access != "wo" and not occupant.reserved
                yield ScannedItem(occupant.path, addresses, readable, occupant.clears_on_read, occupant)
        return
    for parameter_set in layout.device.sets(space.name):
        for row in parameter_set.parameters:
            first = parameter_set.base + row.number
            readable = row.access != "wo" and not row.reserved
            yield ScannedItem(row.name, range(first, first + row.count), readable, row.handling.clears_on_read)


def usual_ranges(layout: DeviceLayout, space: ScanSpace) -> list[range]:
    """The pages of 256 addresses that have something."""
    pages = sorted({address // _PAGE for item in scanned_items(layout, space) for address in item.addresses})
    return [range(page * _PAGE, min((page + 1) * _PAGE, space.end)) for page in pages]


def scan(client: Client, space: ScanSpace, ranges: Sequence[range], done: Callable[[int], None] | None = None) -> Scan:
    """Reads all addresses of some ranges, in large requests where the device answers them.

    Values that reading clears are left out. A device may be silent at an address that it does not have, as long as it
    still answers one that it has. Raises NoAnswerError and CarrierError.
    """
    bases = known_bases(client, client.layout)
    items = list(scanned_items(at_bases(client.layout, bases), space))
    spared = {address for item in items if item.spared for address in item.addresses}
    probe = _Probe(client, space, [item for item in items if item.readable and not item.spared])
    scanned: set[int] = set()
    for addresses in ranges:
        for run in _runs(addresses, spared):
            for start in range(run.start, run.stop, space.most):
                part = range(start, min(start + space.most, run.stop))
                scanned.update(part)
                probe.read(part)
                if done is not None:
                    done(len(part))
    probe.repeat()
    return Scan(space, frozenset(scanned), probe.words, frozenset(spared), bases)


def _runs(addresses: range, spared: set[int]) -> Iterator[range]:
    """The parts of a range without the addresses that are left out."""
    start = addresses.start
    for address in sorted(address for address in spared if address in addresses):
        if address > start:
            yield range(start, address)
        start = address + 1
    if start < addresses.stop:
        yield range(start, addresses.stop)


class _Probe:
    """Reads parts of a space, and divides those that the device refuses, or is silent at but answers another address.

    At a device that is silent, each address that the spec lacks is a part, and is asked once as long as the line loses
    no frames: whether it does, the device shows at the addresses at which it answers.
    """

    def __init__(self, client: Client, space: ScanSpace, items: Sequence[ScannedItem]) -> None:
        self.client, self.space = client, space
        self.words: dict[int, tuple[int, ...]] = {}
        self._first = [item.addresses.start for item in items][:2]
        self._known = {address for item in items for address in item.addresses}
        self._is_silent = self._loses_frames = False
        self._asked_once: list[range] = []

    def read(self, part: range) -> None:
        """Reads a part. Raises NoAnswerError and CarrierError."""
        is_unknown = self._is_silent and not self._loses_frames and self._known.isdisjoint(part)
        try:
            self.words.update(_counts(self.client, self.space, part, 0 if is_unknown else None))
            return
        except RefusedError:
            pass
        except NoAnswerError:
            if not self._is_answering():
                raise
            self._is_silent = True
            if is_unknown and len(part) == 1:
                self._asked_once.append(part)
        for smaller in self._divided(part) if len(part) > 1 else ():
            self.read(smaller)

    def repeat(self) -> None:
        """Asks again at what was asked once, where the line has lost a frame. Raises NoAnswerError and CarrierError."""
        for part in self._asked_once if self._loses_frames else ():
            self.read(part)

    def _divided(self, part: range) -> list[range]:
        """The addresses that the spec has in runs, and each other one, at a device that is silent; else two halves."""
        middle = part.start + len(part) // 2
        if not self._is_silent or self._known.issuperset(part):
            return [range(part.start, middle), range(middle, part.stop)]
        parts: list[range] = []
        for address in part:
            if parts and address in self._known and address - 1 in self._known:
                parts[-1] = range(parts[-1].start, address + 1)
            else:
                parts.append(range(address, address + 1))
        return parts

    def _is_answering(self) -> bool:
        """Whether the device answers at an address, be it with a refusal. Raises CarrierError."""
        for address in [next(reversed(self.words))] if self.words else self._first:
            for retries in (0, None):
                try:
                    _counts(self.client, self.space, range(address, address + 1), retries)
                except NoAnswerError:
                    self._loses_frames |= bool(self.words)
                    continue
                except RefusedError:
                    pass
                return True
        return False


def _counts(client: Client, space: ScanSpace, part: range, retries: int | None) -> dict[int, tuple[int, ...]]:
    """The counts by address. Raises RefusedError, NoAnswerError and CarrierError."""
    if space.parameters is not None:
        return {part.start: _parameter_counts(client, space.parameters, part.start, retries)}
    counts = read_words(client, space.name, part.start, len(part), retries)
    return {address: (count,) for address, count in zip(part, counts, strict=True)}


def _parameter_counts(client: Client, parameter_set: ParameterSet, number: int, retries: int | None) -> tuple[int, ...]:
    """The counts of the parameter with a number. Raises RefusedError, NoAnswerError and CarrierError."""
    message = parameter_message(client.frames.link, parameter_set, "read")
    assert message is not None
    numbered, indexed = part_of(message.request, "number"), part_of(message.request, "subindex")
    assert numbered is not None
    values = {numbered.name: number}
    if indexed is not None:
        values[indexed.name] = 0
        amount = count_field(message.request)
        if amount is not None:
            values[amount.name] = 0
    carried = part_of(message.response, "value")
    assert carried is not None
    answer = client.ask(message.name, values, retries).values
    pieces = segments_of(client.layout, message)
    if pieces is not None and pieces.follows(answer):
        return _count_in_pieces(client, pieces, parameter_set, values, number, answer)
    if carried.carries_bytes:
        return (_count_of_bytes(client, carried, parameter_set, number, answer),)
    content = answer[carried.name]
    own = content if isinstance(content, list) else [content]
    return tuple(int(count) for count in own if isinstance(count, int))


def _count_in_pieces(
    client: Client,
    pieces: SegmentsLayout,
    parameter_set: ParameterSet,
    first: Mapping[str, Any],
    number: int,
    values: Mapping[str, Any],
) -> tuple[int, ...]:
    """The count of a value that follows in pieces; none for what is not a number, and where the spec has none of it."""
    parameter = parameter_set.numbered(number - parameter_set.base)
    value = element_value(parameter, 0) if parameter is not None else None
    if value is None or not is_count(value.encoding):
        return ()
    try:
        data = read_pieces(client, pieces, first, values, value.size)
        raw = value_of_data(value, data, *Orders(pieces.data.order, client.layout.device.word_order).of(value))
    except (UnfitAnswerError, CodecError):
        return ()
    return (int(raw),) if isinstance(raw, int) else ()


def _count_of_bytes(
    client: Client, carried: FieldLayout, parameter_set: ParameterSet, number: int, values: Mapping[str, Any]
) -> int:
    """The count in a field of bytes: that of the parameter, or the bytes as a number where the spec has none of it."""
    data = stated_bytes(carried, values)
    parameter = parameter_set.numbered(number - parameter_set.base)
    value = element_value(parameter, 0) if parameter is not None else None
    if value is not None and value.size == len(data):
        raw = value_of_bytes(client.layout.device, carried, value, values)
        if isinstance(raw, int):
            return int(raw)
    return int.from_bytes(data, "big" if carried.order == "big" else "little")


def compared(layout: DeviceLayout, result: Scan) -> ScanComparison:
    """A scan compared with the spec of a version."""
    moving = moving_tables(layout)
    layout = at_bases(layout, {name: base for name, base in result.bases.items() if name in moving})
    known: set[int] = set()
    silent = []
    for item in scanned_items(layout, result.space):
        known.update(item.addresses)
        lacking = any(address not in result.words for address in item.addresses)
        if (
            item.readable
            and result.asked.issuperset(item.addresses)
            and lacking
            and not _is_absent(layout, result, item)
        ):
            silent.append(item.path)
    unknown: list[tuple[int, int]] = []
    for address in sorted(address for address in result.words if address not in known):
        if unknown and unknown[-1][1] == address - 1:
            unknown[-1] = (unknown[-1][0], address)
        else:
            unknown.append((address, address))
    return ScanComparison(tuple(unknown), tuple(silent))


def _is_absent(layout: DeviceLayout, result: Scan, item: ScannedItem) -> bool:
    """Whether an item is in an element of a table that the device has not got, as the count says that it answered."""
    count = count_of_occupant(layout, item.occupant) if item.occupant is not None else None
    if item.occupant is None or count is None:
        return False
    addresses = range(count.address, count.address + count.words)
    words = [word for address in addresses for word in result.words.get(address, ())]
    decoded = reading(layout, result.space.name, count, words).decoded if len(words) == count.words else None
    number = decoded.number if decoded is not None else None
    return isinstance(number, int) and element_number(item.occupant) >= number
