"""Writes registers by their names: the values are checked first, and read back afterwards."""

from __future__ import annotations

from fieldspec.codec.explain.hazards import roles_of, write_hazards
from fieldspec.codec.explain.occupants import Occupant, forbidden_text
from fieldspec.codec.layout.bits import packed_bits
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.values import MeaningError, raw_value
from fieldspec.codec.reference.records import CodecError, encoded_value
from fieldspec.codec.reference.structs import value_construct
from fieldspec.foundation.classes import dataclass
from fieldspec.tools.live.client import Client, RefusedError
from fieldspec.tools.live.reading import Reading, is_bit, message_for, read_words, reading


class WriteError(ValueError):
    """A value that must not be written. The message says why."""


@dataclass(frozen=True, slots=True)
class Assignment:
    """A value for what is at an address: its words, and what a person should know before it is written.

    A value that has only a part of its words has the bits of `mask` in them. It is written once `request` has the words
    of all values that it shares words with, the first of them `before` its own first one.
    """

    space: str
    occupant: Occupant
    words: tuple[int, ...]
    hazards: tuple[str, ...]
    mask: tuple[int, ...] = ()
    request: tuple[int, ...] = ()
    before: int = 0

    @property
    def path(self) -> str:
        """The path of the value."""
        return self.occupant.path

    @property
    def sent(self) -> tuple[str, int, tuple[int, ...]]:
        """The space, the address and the words of the request, which is one for values that share words."""
        return self.space, self.occupant.address - self.before, self.request or self.words


def assignment(layout: DeviceLayout, space: str, occupant: Occupant, text: str) -> Assignment:
    """The assignment of a value as people write it: a count, a quantity, a member. Raises WriteError."""
    objection = forbidden_text("write", occupant.access)
    if objection:
        raise WriteError(f"{occupant.path} {objection}")
    if occupant.reserved:
        raise WriteError(f"{occupant.path} is reserved")
    size = layout.device.space(space).unit_size
    value = occupant.value.for_writing()
    try:
        raw = raw_value(layout.device, occupant.path, value, text)
        known = encoded_value(occupant.path, value, raw, layout.device)
        data = bytes(value_construct(value, occupant.order, occupant.is_swapped("write")).build(known))
    except (MeaningError, CodecError) as error:
        raise WriteError(str(error)) from None
    if is_bit(occupant) or not is_partial(occupant, size):
        return Assignment(space, occupant, words_of(layout, data, size), tuple(_hazards(layout, occupant)))
    padding = occupant.words * size - occupant.skip - len(data)
    placed, ones = (bytes(occupant.skip) + own + bytes(padding) for own in (data, b"\xff" * len(data)))
    words, mask = words_of(layout, placed, size), words_of(layout, ones, size)
    return Assignment(space, occupant, words, tuple(_hazards(layout, occupant)), mask)


def is_partial(occupant: Occupant, unit_size: int) -> bool:
    """Whether a value fills only a part of its words."""
    return bool(occupant.skip or occupant.value.size % unit_size)


def words_of(layout: DeviceLayout, data: bytes, size: int) -> tuple[int, ...]:
    """The words of `size` bytes into which bytes are divided."""
    big = layout.device.byte_order == "big"
    return tuple(
        int.from_bytes(data[offset : offset + size], "big" if big else "little") for offset in range(0, len(data), size)
    )


def _hazards(layout: DeviceLayout, occupant: Occupant) -> list[str]:
    """Warnings before a value is written."""
    hazards = write_hazards(
        trigger=occupant.trigger,
        access=occupant.access,
        restart=occupant.restart,
        handlings=occupant.handlings,
        roles=roles_of(layout.device, occupant.fact, occupant.value),
    )
    return list(hazards)


def request_frame(client: Client, chosen: Assignment) -> tuple[str, dict[str, object], bytes]:
    """The message that writes a value, its fields, and its frame. Raises WriteError."""
    space, address, words = chosen.sent
    message = message_for(client.layout.device, client.frames.link, "write", space, len(words))
    access = message.single_access if message is not None else None
    if message is None or access is None:
        raise WriteError(f"no message of the device writes {chosen.occupant.path}")
    values: dict[str, object] = {access.start: address}
    if client.layout.device.bit_access(message) is None:
        is_list = (field := message.request.named(access.values)) is not None and field.repeat is not None
        values[access.values] = list(words) if is_list else words[0]
        count_field = message.request.named(access.count) if access.count else None
        if count_field is not None and count_field.measures is None:
            values[access.count] = len(words)
    elif access.set is None:
        values |= {access.count: len(words), access.values: list(packed_bits(words))}
    else:
        values[access.values] = access.set if words[0] else access.clear
    try:
        return message.name, values, client.request(message.name, values)
    except CodecError as error:
        raise WriteError(f"{chosen.occupant.path}: {error}") from None


def write(client: Client, chosen: Assignment) -> None:
    """Writes a value, once: a request that is sent again could start something twice.

    Raises WriteError, NoAnswerError, RefusedError and CarrierError. After NoAnswerError, or if the message has no
    response, it is unknown whether it was written.
    """
    name, values, _ = request_frame(client, chosen)
    if client.is_answered(name):
        client.ask(name, values, retries=0)
    else:
        client.send(name, values)


def read_back(client: Client, chosen: Assignment) -> Reading | None:
    """The value of the device after a write; None for what cannot be read, or does not give back what was written.

    Raises NoAnswerError and CarrierError.
    """
    occupant = chosen.occupant
    if occupant.trigger or occupant.access in ("wo", ""):
        return None
    try:
        words = read_words(client, chosen.space, occupant.address, occupant.words)
        return reading(client.layout, chosen.space, occupant, words)
    except RefusedError as error:
        return Reading(occupant, (), None, str(error))


def means(name: str, occupant: Occupant) -> bool:
    """Whether a name is that of a register, of the array, table or record that it is in, its role or its address."""
    path = occupant.path
    if name == path or path.startswith((f"{name}[", f"{name}.")) or name in occupant.fact.roles:
        return True
    try:
        return int(name, 0) == occupant.address
    except ValueError:
        return False
