"""Requests that read and write registers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from fieldspec.codec.explain.occupants import Occupant, forbidden_text
from fieldspec.codec.layout.bits import packed_bits, unpacked_bits
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.encoding import is_array, is_truth
from fieldspec.language.model.record import RegisterAccess
from fieldspec.language.model.value import Value
from fieldspec.tools.simulator.refusal import Refusal

if TYPE_CHECKING:
    from typing import Any

    from fieldspec.tools.simulator.engine import Engine


def read_registers(engine: Engine, access: RegisterAccess, values: Mapping[str, Any]) -> list[int]:
    """The words that a request asks for. Raises Refusal."""
    space, addresses = _span(engine, access, values, _count(access, values), "read")
    memory = engine.memory
    words = []
    for address in addresses:
        triggers = [occupant for occupant in memory.at(space, address) if occupant.trigger]
        displayed = not triggers or any(_is_displayed(engine, occupant) for occupant in triggers)
        words.append(memory.words[space, address] if displayed else 0)
    for address in addresses:
        for occupant in memory.at(space, address):
            if occupant.address == address and occupant.clears_on_read:
                memory.write(space, occupant, 0)
    return words


def write_registers(engine: Engine, access: RegisterAccess, values: Mapping[str, Any]) -> None:
    """Writes the words of a request and lets the behaviour follow. Raises Refusal, and then nothing is written."""
    before, paths = place_words(engine, access, values)
    try:
        engine.follow_write(paths)
    except Refusal:
        engine.memory.words.update(before)
        raise


def place_words(
    engine: Engine, access: RegisterAccess, values: Mapping[str, Any]
) -> tuple[dict[tuple[str, int], int], list[str]]:
    """Puts the words of a request into the memory: what was there, and the paths of what has them.

    Raises Refusal, and then nothing is written.
    """
    content = values[access.values]
    words: Sequence[int] = content if isinstance(content, list | tuple) else [content]
    space, addresses = _span(engine, access, values, len(words), "write")
    memory = engine.memory
    places = [memory.write_place(space, address) for address in addresses]
    before = {(space, place): memory.words[space, place] for place in places}
    for place, word in zip(places, words, strict=True):
        memory.words[space, place] = word
    paths = []
    try:
        for occupant in _touched(engine, space, addresses):
            raw = memory.read(space, occupant)
            objection = _invalid(engine, occupant, raw)
            if objection:
                raise Refusal("value_invalid", f"{occupant.path} cannot be {spec_text(raw)}: {objection}")
            if not _is_whole(occupant, addresses) and occupant.atomic and not _accepts(engine, "partial_values"):
                raise Refusal("value_invalid", f"{occupant.path} is to be written in one request")
            paths.append(_path(occupant))
    except Refusal:
        memory.words.update(before)
        raise
    return before, paths


def accessed_words(
    engine: Engine, access: RegisterAccess, values: Mapping[str, Any], operation: str = "read"
) -> tuple[str, list[int]]:
    """The space of a request, and where the memory has the words that it states. Raises Refusal."""
    return _span(engine, access, values, _count(access, values), operation)


def read_bits(engine: Engine, access: RegisterAccess, values: Mapping[str, Any]) -> int | list[int]:
    """The content of a response for the requested bits: bytes, or a number. Raises Refusal."""
    bits = [int(word != 0) for word in read_registers(engine, access, values)]
    if access.set is None:
        return list(packed_bits(bits))
    return access.set if bits[0] else access.clear


def write_bits(engine: Engine, access: RegisterAccess, values: Mapping[str, Any]) -> None:
    """Writes the bits of a request and lets the behaviour follow. Raises Refusal, and then nothing is written."""
    content, count = values[access.values], _count(access, values)
    if access.set is not None:
        if content not in (access.set, access.clear):
            raise Refusal("value_invalid", f"{content} stands for no bit")
        bits = [int(content == access.set)]
    else:
        bits = list(unpacked_bits(bytes(content)))[:count]
    words = [int.from_bytes(bytes((bit, 0)), engine.memory.order) for bit in bits]
    write_registers(engine, access, {**values, access.values: words})


def _count(access: RegisterAccess, values: Mapping[str, Any]) -> int:
    return int(values[access.count]) if access.count else 1


def _span(
    engine: Engine, access: RegisterAccess, values: Mapping[str, Any], count: int, operation: str
) -> tuple[str, list[int]]:
    """The space of a request, and where the memory has its addresses. Raises Refusal."""
    first, space = int(values[access.start]), engine.layout.device.space_name(access.space)
    places = [engine.memory.place(space, address) for address in range(first, first + count)]
    for address, place in enumerate(places, first):
        _judge(engine, space, address, place, operation)
    return space, places


def _judge(engine: Engine, space: str, address: int, place: int, operation: str) -> None:
    """Refuses an address without a register, and registers that the operation may not touch."""
    present = engine.memory.at(space, place)
    if not present:
        raise Refusal("unknown_address", f"no register is at 0x{address:04X}")
    if all(map(engine.memory.is_absent, present)):
        raise Refusal("unknown_address", f"the device has not got {present[0].path}")
    for occupant in present:
        objection = forbidden_text(operation, occupant.access)
        if objection:
            raise Refusal(f"{operation}_forbidden", f"{occupant.path} at 0x{address:04X} {objection}")


def _touched(engine: Engine, space: str, addresses: Sequence[int]) -> Iterator[Occupant]:
    """The occupants that share words with a span, each once."""
    visited: set[tuple[str, int]] = set()
    for address in addresses:
        for occupant in engine.memory.at(space, address):
            if (occupant.path, occupant.address) not in visited:
                visited.add((occupant.path, occupant.address))
                yield occupant


def _is_whole(occupant: Occupant, addresses: Sequence[int]) -> bool:
    return all(address in addresses for address in range(occupant.address, occupant.address + occupant.words))


def _accepts(engine: Engine, subject: str) -> bool:
    return any(
        part.subject == subject and engine.holds(part.get("if") or {}) for part in engine.behaviour.of_kind("accept")
    )


def _path(occupant: Occupant) -> str:
    """The path of the operand of an occupant."""
    return occupant.outer.place.path if "[" in occupant.path and "." not in occupant.path else occupant.fact.place.path


def _is_displayed(engine: Engine, occupant: Occupant) -> bool:
    """Whether reading a register that starts something gives what the behaviour shows there."""
    path = _path(occupant)
    return any(cell.path == path for part in engine.behaviour.of_kind("show") for cell in engine.cells.of(part.subject))


def _invalid(engine: Engine, occupant: Occupant, raw: Any) -> str:
    if occupant.reserved and occupant.value.const is None:
        return ""
    return invalid(engine, occupant.value, raw)


def invalid(engine: Engine, value: Value, raw: Any) -> str:
    """Why a raw value cannot be written; empty where it can."""
    if is_array(value.encoding):
        return ""
    if value.const is not None and raw != value.const:
        return f"it is always {value.const}"
    if value.sentinel(raw) is not None:
        return ""
    if value.enum:
        enum = engine.layout.device.enums[value.enum]
        member = enum.member(raw)
        if not enum.open and (member is None or member.unavailable):
            return f"{value.enum} has no such member"
    ranges = value.writable_ranges
    if ranges is not None and raw not in ranges:
        return f"the range is {ranges.text()}"
    bit = engine.layout.device.flags[value.flags].refused_bit(raw) if value.flags else None
    if bit is not None and bit.ranges is not None:
        return f"the range of {bit.name} is {bit.ranges.text()}"
    if is_truth(value.encoding) and raw not in (0, 1):
        return "it is neither 0 nor 1"
    return ""
