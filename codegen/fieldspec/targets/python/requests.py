"""The messages that read and write registers, as code that builds and parses them."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.carrying import carries_words
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import RegisterAccess
from fieldspec.targets.python.links import Exchange
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import literal
from fieldspec.targets.python.writing import tuple_of


@dataclass(frozen=True, slots=True)
class AccessView:
    """A message that reads or writes `most` words or bits: its classes, and the expressions of requests and of words.

    `words` has the words of all `responses`, and `checked_words` the same where they must be of this class. A bit is a
    word with 0 or 1.
    """

    request: str
    response: str
    most: int
    make: str
    words: str
    checked_words: str


@dataclass(frozen=True, slots=True)
class SpaceAccess:
    """The messages that read and write the registers of an address space; empty name: the device has only one space.

    `links` are those that carry them; empty where links do not differ.
    """

    space: str
    read: AccessView | None
    single: AccessView | None
    block: AccessView | None
    links: tuple[str, ...] = ()

    @property
    def condition(self) -> str:
        """The expression that says whether a register on a link is accessed so; empty: it always is."""
        names = [literal(name) for name in self.links]
        tests = [f"link == {names[0]}" if len(names) == 1 else f"link in {tuple_of(names)}"] * bool(names)
        tests += [f"register.space == {literal(self.space)}"] * bool(self.space)
        return " and ".join(tests)

    def has(self, other: SpaceAccess) -> bool:
        """Whether these are the messages of another one, as far as it has any."""
        writers = (self.single, self.block), (other.single, other.block)
        return other.read in (None, self.read) and (writers[1] == (None, None) or writers[0] == writers[1])


def register_accesses(device: Device, links: Sequence[LinkLayout], exchanges: list[Exchange]) -> list[SpaceAccess]:
    """The messages that access each space, in the order of the spec; for each link where links differ.

    The link of the factory settings comes first.
    """
    shared = _space_accesses(device, exchanges)
    by_link = {
        link.name: _space_accesses(
            device, [exchange for exchange in exchanges if carries_words(link, exchange.message)]
        )
        for link in sorted(links, key=lambda link: link.name != device.default_link)
    }
    if all(own.has(other) for rows in by_link.values() for own, other in zip(shared, rows, strict=True)):
        return shared
    different: dict[SpaceAccess, list[str]] = {}
    for name, rows in by_link.items():
        for row in rows:
            if row.read or row.single or row.block:
                different.setdefault(row, []).append(name)
    return [replace(row, links=tuple(names)) for row, names in different.items()]


def _space_accesses(device: Device, exchanges: list[Exchange]) -> list[SpaceAccess]:
    """The messages that access each space, in the order of the spec."""
    names = list(device.spaces) if device.several_spaces else [""]
    accesses = []
    for name in names:
        own = [
            exchange
            for exchange in exchanges
            if (access := exchange.message.message.single_access) is not None
            and (not name or device.space_name(access.space) == name)
        ]
        bits = device.space(name).unit == BIT
        accesses.append(SpaceAccess(name, read_access(own, bits), *write_accesses(own, bits)))
    return accesses


def _field(shaped: RecordShape, title: str) -> Slots | None:
    return next((field for field in shaped.fields if field.title == title), None)


def _greatest_count(bits: bool, *fields: Slots | None) -> int:
    """The most words, or packed bits, that some fields allow."""
    bounds = []
    for field in fields:
        if field is not None and field.repeated and field.field.field.repeat is not None:
            bounds.append(field.field.field.repeat.high * (8 if bits else 1))
        elif field is not None and field.ranges is not None:
            bounds.append(field.ranges.high)
    return min(bounds, default=1)


def read_access(exchanges: list[Exchange], bits: bool = False) -> AccessView | None:
    """The first message that reads registers, in a space of words or of `bits`."""
    for exchange in exchanges:
        access = exchange.message.message.single_access
        if access is None or access.operation != "read":
            continue
        start, count = _field(exchange.request, access.start), _field(exchange.request, access.count)
        values = _field(exchange.response, access.values)
        if start is None or values is None or not _settable(exchange.request, {access.start, access.count}):
            continue
        count_argument = f", {count.name}=count" if count is not None and count.stored else ""
        limit = _greatest_count(bits, values, count) if values.is_list else 1
        return AccessView(
            request=exchange.request_name,
            response=exchange.response_name,
            most=limit,
            make=f"{exchange.request_name}({start.name}=start{count_argument})",
            words=_words(values, access, bits, limit, "responses"),
            checked_words=_words(
                values, access, bits, limit, f"_replies(register, responses, {exchange.response_name})"
            ),
        )
    return None


def _words(values: Slots, access: RegisterAccess, bits: bool, limit: int, responses: str) -> str:
    """The expression of the words of some responses."""
    loop = f"for response in {responses}"
    if bits and values.is_list:
        return f"_unpacked_bits(register, {limit}, [response.{values.name} {loop}])"
    if bits:
        return f"[_single_bit(register.name, response.{values.name}, {_pair(access)}) {loop}]"
    word = f"response.{values.name}" if values.is_list else f"[response.{values.name}]"
    return f"[word {loop} for word in {word}]"


def _pair(access: RegisterAccess) -> str:
    """The numbers of a bit that is 1 and of one that is 0."""
    return f"0x{access.set or 0:02X}, 0x{access.clear:02X}"


def write_accesses(exchanges: list[Exchange], bits: bool = False) -> tuple[AccessView | None, AccessView | None]:
    """The first message that writes one register, and the first one that writes several, of words or of `bits`."""
    single: AccessView | None = None
    block: AccessView | None = None
    for exchange in exchanges:
        access = exchange.message.message.single_access
        if access is None or access.operation != "write":
            continue
        start, count = _field(exchange.request, access.start), _field(exchange.request, access.count)
        values = _field(exchange.request, access.values)
        if start is None or values is None:
            continue
        if not _settable(exchange.request, {access.start, access.count, access.values}):
            continue
        count_argument = f", {count.name}=count" if count is not None and count.stored else ""
        if values.is_list:
            words = "_packed_bits(words[at : at + count])" if bits else "words[at : at + count]"
            make = f"{exchange.request_name}({start.name}=start{count_argument}, {values.name}={words})"
            limit = _greatest_count(bits, values, count)
            block = block or AccessView(exchange.request_name, exchange.response_name, limit, make, "", "")
        else:
            word = f"0x{access.set or 0:02X} if words[at] else 0x{access.clear:02X}" if bits else "words[at]"
            make = f"{exchange.request_name}({start.name}=start, {values.name}={word})"
            single = single or AccessView(exchange.request_name, exchange.response_name, 1, make, "", "")
    return single, block


def _settable(shaped: RecordShape, titles: set[str]) -> bool:
    """Whether a request needs no other fields than these."""
    return all(field.title in titles for field in shaped.stored)
