"""The numbers that a value may take, and those that examples write."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.language.checks.finding import type_text
from fieldspec.language.model.access import readable
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_exact, is_real
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.quantity import count_of
from fieldspec.language.model.record import Case, Choice, Field
from fieldspec.language.model.registers import Register
from fieldspec.language.model.texts import Example
from fieldspec.language.model.value import Value


class Legal:
    """The numbers that the values of a device may take."""

    def __init__(self, device: Device) -> None:
        self._words = device.flags
        self._closed = {
            enum.name: frozenset(member.value for member in enum.members)
            for enum in device.enums.values()
            if not enum.open
        }

    def objection(self, value: Value, number: float, writes: bool = False) -> str:
        """Why the value cannot be this number of counts, or an empty text. Sentinels may be anything.

        `writes` says that the number is written, for which a value may have a range of its own.
        """
        if writes:
            value = value.for_writing()
        if is_real(value.encoding) and value.ranges is not None and value.sentinel(number) is None:
            return "" if number in value.ranges else f"is outside {value.ranges.text()}"
        if not is_exact(value.encoding) or isinstance(number, float):
            return ""
        if not value.low <= number <= value.high:
            return f"does not fit {type_text(value)}"
        if value.sentinel(number) is not None:
            return ""
        if value.ranges is not None and number not in value.ranges:
            return f"is outside {value.ranges.text()}"
        bit = self._words[value.flags].refused_bit(number) if value.flags in self._words else None
        if bit is not None and bit.ranges is not None:
            return f"has {bit.number_in(number)} in {bit.name}, outside {bit.ranges.text()}"
        if value.enum in self._closed and number not in self._closed[value.enum]:
            return f"is not a member of {value.enum}"
        return ""


def body(device: Device, example: Example) -> tuple[Field, ...]:
    """The fields of an example's body; none where a reference of the example dangles."""
    link = device.links.get(example.link)
    if example.exception_response:
        record = (
            device.records.get(link.exception_response.record)
            if link is not None and link.exception_response is not None
            else None
        )
        return record.fields if record is not None else ()
    message = device.messages.get(example.message)
    if message is None:
        return ()
    return message.request.fields if example.direction == "request" else message.response.fields


def numbers(device: Device, example: Example) -> Iterator[tuple[str, Fact, Value, int]]:
    """The path, the fact, its value and the count of every number in an example."""
    link = device.links.get(example.link)
    heads = {part.name: part for part in link.parts(example.direction)} if link is not None else {}
    for name, text in example.values.items():
        part = heads.get(name)
        if part is not None and part.value is not None:
            count = in_counts(device, part.value, text)
            if count is not None:
                yield name, part, part.value, count
    yield from _of_fields(device, body(device, example), "", example.values)


def _of_fields(
    device: Device, fields: tuple[Field, ...], path: str, texts: Mapping[str, object]
) -> Iterator[tuple[str, Fact, Value, int]]:
    for field in fields:
        value = texts.get(field.name)
        fact: Field | Case | None = field if field.choice is None else _decided(device, fields, field.choice, texts)
        for item in value if isinstance(value, list) else [value]:
            record = device.records.get(field.record)
            if record is not None and isinstance(item, dict):
                yield from _of_fields(device, record.fields, f"{path}{field.name}.", item)
            elif fact is not None and fact.value is not None:
                count = in_counts(device, fact.value, item)
                if count is not None:
                    yield f"{path}{field.name}", fact, fact.value, count


def _decided(device: Device, fields: tuple[Field, ...], choice: Choice, texts: Mapping[str, object]) -> Case | None:
    """The case that the written value of the deciding field chooses."""
    selector = next((field for field in fields if field.name == choice.by), None)
    enum = device.enums.get(choice.enum_of(selector, device.flags))
    text = texts.get(choice.by)
    if enum is None or selector is None or selector.value is None:
        return None
    count = in_counts(device, selector.value, text)
    if choice.bits is not None and count is not None:
        count = count >> choice.bits[0] & (2 << choice.bits[1] - choice.bits[0]) - 1
    member = enum.member(count) if count is not None else enum.named(str(text))
    return next((case for case in choice.cases if member is not None and member.name in case.when), None)


def in_counts(device: Device, value: Value, text: object) -> int | None:
    """The count that an example writes, or None where that is a name, a text or a list, or cannot be understood."""
    if isinstance(text, int):
        return None if isinstance(text, bool) else text
    count = count_of(text) if isinstance(text, str) else None
    if count is not None:
        return count
    number = device.entered_quantity(value, text)
    return value.from_unit(number) if number is not None else None


def number_objection(register: Register, meaning: str) -> str:
    """Why a register has no whole number that can be read, such as an address; empty where it has."""
    value = register.value
    if not is_count(value.encoding) or value.scaled or value.scale_by or value.enum or value.flags:
        return "it is not a whole number without a scale and without names"
    if register.count > 1:
        return f"it stands for {register.count} registers"
    if register.reserved or register.trigger or not readable(register.access):
        return "the spec does not say that it can be read"
    if value.const is not None:
        return f"it is always {value.const}"
    if value.sentinels:
        return f"its special value is not a valid {meaning}"
    return "its `write_range` differs from what it may be" if value.write_ranges is not None else ""
