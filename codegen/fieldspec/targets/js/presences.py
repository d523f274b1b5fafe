"""Checks of numbers in an array of bytes that say whether and how often fields are sent."""

from __future__ import annotations

from fieldspec.codec.layout.presence import PresenceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.members import slot_of
from fieldspec.targets.js.number_bytes import place
from fieldspec.targets.js.text import literal, plus
from fieldspec.targets.js.values import throw_wrong_number


def bits_of(presence: PresenceLayout, number: str) -> str:
    """The number in the bits that count a list, as an expression: `(b[o] & 240) >>> 4`"""
    return f"(({number} & {presence.mask}) >>> {presence.shift})"


def is_present(presence: PresenceLayout, number: str) -> str:
    """The condition that a number, an expression, says that a field is sent: `((b[o] & 8) >>> 0) === 8`"""
    bits = f"(({number} & {presence.mask}) >>> 0)"
    if presence.is_any:
        return f"{bits} > 0"
    if len(presence.numbers) == 1:
        return f"{bits} === {presence.numbers[0]}"
    return f"[{', '.join(map(str, presence.numbers))}].includes({bits})"


def presence_check(record: RecordLayout, field: FieldLayout, names: Names, count: str, position: str) -> list[str]:
    """The statement that refuses a field whose number of elements is not as the bytes `b` say.

    `count` and `position`, the place of the deciding number or null, are expressions. Other fields have none.
    """
    decider = record.named(field.presence.by) if field.presence is not None else None
    if field.presence is None or decider is None:
        return []
    number = slot_of(decider, names).number("o", decider.offset)
    detail = f"`but there are ${{{count}}} of {field.name}`"
    wrong = throw_wrong_number("wrong_measure", decider.name, number, detail, position)
    if field.has_count_in_bits:
        units = f"{count} * {field.presence.unit}" if field.presence.unit > 1 else count
        return [f"if ({bits_of(field.presence, number)} !== {plus(units, field.presence.plus)}) {wrong}"]
    return [f"if (({is_present(field.presence, number)}) !== ({count} > 0)) {wrong}"]


def end_check(field: FieldLayout, names: Names, items: str) -> list[str]:
    """The statements that refuse elements that are wrong about whether another one follows, in the bytes `b`.

    `items` are the elements, an expression. Other fields have none.
    """
    continuation = field.continuation
    decider = field if field.record is None or continuation is None else field.record.named(continuation.presence.by)
    if continuation is None or decider is None:
        return []
    number = slot_of(decider, names).number("at", continuation.offset)
    detail = literal(f"which is wrong about whether another one of {field.name} follows")
    wrong = throw_wrong_number("wrong_measure", decider.name, number, detail, "null")
    start = place("o", field.offset)
    return [
        f"for (let at = {start}, index = 1; index <= {items}.length; index++, at += {field.size}) {{",
        f"  if (({is_present(continuation.presence, number)}) !== (index < {items}.length)) {wrong}",
        "}",
    ]


def bit_count_check(field: FieldLayout, names: Names, size: str, position: str) -> list[str]:
    """The statement that refuses a number of bits in the bytes `b` which takes other than `size` bytes.

    `size` and `position`, the place of the number or null, are expressions. Other fields have none.
    """
    if not field.bits_of:
        return []
    number = slot_of(field, names).number("o", field.offset)
    takes = f"Math.ceil({number} / 8)"
    detail = f"`which takes ${{{takes}}} bytes, but {field.bits_of} has ${{{size}}}`"
    wrong = throw_wrong_number("wrong_measure", field.name, number, detail, position)
    return [f"if ({takes} !== {size}) {wrong}"]
