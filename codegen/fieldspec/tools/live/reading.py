"""Reads registers by their names, in as few requests as the device permits."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from fieldspec.codec.explain.occupants import Occupant, occupants
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.explain.values import DecodedValue, decode_value
from fieldspec.codec.layout.bits import unpacked_bits
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.read_plan import ReadBlock, read_limit, read_plan
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Message, RegisterAccess
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError

if TYPE_CHECKING:
    from typing import Literal

_LAST = 0x10000


@dataclass(frozen=True, slots=True)
class Reading:
    """A value that was read, or the reason why the device refused it. `words` are those on the wire.

    One that `is_absent` was not asked for: it is in an element of a table that the device says it has not got.
    """

    occupant: Occupant
    words: tuple[int, ...]
    decoded: DecodedValue | None
    refusal: str = ""
    is_absent: bool = False

    @property
    def path(self) -> str:
        """The path of the value."""
        return self.occupant.path


@dataclass(frozen=True, slots=True)
class Block:
    """Words that one request reads, and the values in them."""

    space: str
    start: int
    words: int
    occupants: tuple[Occupant, ...]


def all_occupants(layout: DeviceLayout) -> Iterator[tuple[str, Occupant]]:
    """The occupants of all addresses, each with its space."""
    device = layout.device
    for space in dict.fromkeys([*device.spaces, device.space_name("")]):
        for occupant in occupants(layout, Span(space, 0, _LAST, 0, b"")):
            yield space, occupant


def blocks(layout: DeviceLayout, chosen: Sequence[tuple[str, Occupant]]) -> list[Block]:
    """The requests that read some values: parts of the read plan, so that none touches what must not be read.

    A value that no block of the plan has is read alone: somebody has named it. Several that share a word are read
    together, as the device may clear the word.
    """
    result: list[Block] = []
    rest = list(chosen)
    for block in read_plan(layout).blocks:
        own = [pair for pair in rest if _within(layout, block, *pair)]
        if own:
            read_here = set(map(id, own))
            rest = [pair for pair in rest if id(pair) not in read_here]
            first = min(occupant.address for _, occupant in own)
            last = max(occupant.address + occupant.words for _, occupant in own)
            result.append(Block(own[0][0], first, last - first, tuple(occupant for _, occupant in own)))
    return sorted([*result, *_overlapping(rest)], key=lambda block: (block.space, block.start))


def _overlapping(rest: Sequence[tuple[str, Occupant]]) -> Iterator[Block]:
    """Blocks of values that no block of the plan has: one for those that share words, directly or through others."""
    run: list[Occupant] = []
    own, end = "", 0
    for space, occupant in sorted(rest, key=lambda pair: (pair[0], pair[1].address)):
        if run and (space != own or occupant.address >= end):
            yield Block(own, run[0].address, end - run[0].address, tuple(run))
            run = []
        own, end = space, max(end, occupant.address + occupant.words) if run else occupant.address + occupant.words
        run.append(occupant)
    if run:
        yield Block(own, run[0].address, end - run[0].address, tuple(run))


def _within(layout: DeviceLayout, block: ReadBlock, space: str, occupant: Occupant) -> bool:
    own = block.space or layout.device.space_name("")
    return own == space and block.start <= occupant.address and occupant.address + occupant.words <= block.end


def message_for(device: Device, link: LinkLayout, operation: str, space: str, words: int) -> Message | None:
    """The message of a link that reads or writes some words or bits of a space; one without a count where it is for
    one alone.
    """
    known = []
    for carried in link.carried("response" if operation == "read" else "request").values():
        message = carried.message
        access = device.register_access(message) or device.bit_access(message)
        if access is not None and access.operation == operation and device.space_name(access.space) == space:
            known.append((not _is_list(message, access), message))
    alone = next((message for single, message in known if single and words == 1), None)
    return alone or next((message for single, message in known if not single), None)


def _is_list(message: Message, access: RegisterAccess) -> bool:
    """Whether a message carries several words, bytes or bits."""
    layer = message.response if access.operation == "read" else message.request
    field = layer.named(access.values)
    return bool(access.count) or (field is not None and field.repeat is not None)


def is_bit(occupant: Occupant) -> bool:
    """Whether a value is a register of one bit."""
    return occupant.value.type.name == "bit"


def read(client: Client, plan: Iterable[Block], done: Callable[[int], None] | None = None) -> Iterator[Reading]:
    """Reads blocks. A block that the device refuses is divided, so that one refusal costs no other value.

    Raises NoAnswerError and CarrierError. `done` is called with the words of each request.
    """
    for block in plan:
        yield from _read_block(client, block)
        if done is not None:
            done(block.words)


def _read_block(client: Client, block: Block) -> Iterator[Reading]:
    try:
        words = read_words(client, block.space, block.start, block.words)
    except RefusedError as error:
        if len(block.occupants) == 1:
            yield Reading(block.occupants[0], (), None, str(error))
            return
        middle = len(block.occupants) // 2
        for part in (block.occupants[:middle], block.occupants[middle:]):
            start = min(occupant.address for occupant in part)
            end = max(occupant.address + occupant.words for occupant in part)
            yield from _read_block(client, Block(block.space, start, end - start, part))
        return
    for occupant in block.occupants:
        offset = occupant.address - block.start
        yield reading(client.layout, block.space, occupant, words[offset : offset + occupant.words])


def read_words(client: Client, space: str, start: int, count: int, retries: int | None = None) -> list[int]:
    """The words, or the bits as 0 and 1, from an address on. Raises NoAnswerError, RefusedError and CarrierError.

    `retries` says how often a request is repeated where no answer comes; None stands for the number of the client.
    """
    device, link = client.layout.device, client.frames.link
    message = message_for(device, link, "read", space, count) or message_for(device, link, "read", space, 1)
    access = message.single_access if message is not None else None
    if message is None or access is None:
        raise RefusedError(0, f"no message of {link.name} reads registers")
    limit = read_limit(client.layout.device, message).words
    if limit is not None and 0 < limit < count:
        # The plan divides no value, so that this is one with more words than a request reads.
        starts = range(start, start + count, limit)
        return [
            word
            for address in starts
            for word in read_words(client, space, address, min(limit, start + count - address), retries)
        ]
    values = {access.start: start, **({access.count: count} if access.count else {})}
    content = client.ask(message.name, values, retries).values[access.values]
    if client.layout.device.bit_access(message) is not None:
        bits = [int(content == access.set)] if access.set is not None else list(unpacked_bits(bytes(content)))
        if len(bits) < count:
            raise NoAnswerError(f"the answer has {len(bits)} bits instead of {count}")
        return bits[:count]
    words = list(content) if isinstance(content, list) else [content]
    if len(words) != count:
        raise NoAnswerError(f"the answer has {len(words)} words instead of {count}")
    return words


def reading(layout: DeviceLayout, space: str, occupant: Occupant, words: Sequence[int]) -> Reading:
    """The meaning of the words or bytes of a value, or of the 0 or 1 of a bit."""
    order: Literal["big", "little"] = "big" if layout.device.byte_order == "big" else "little"
    width = 1 if is_bit(occupant) else layout.device.space(space).unit_size
    data = b"".join(word.to_bytes(width, order) for word in words)
    data = data[occupant.skip : occupant.skip + occupant.value.size]
    value = occupant.value.as_answer(occupant.trigger)
    decoded = decode_value(layout.device, value, data, occupant.order, occupant.swapped, occupant.reserved)
    return Reading(occupant, tuple(words), decoded)
