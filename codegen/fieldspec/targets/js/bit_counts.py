"""The number of bits that a request writes, compared with the bytes into which they are packed."""

from __future__ import annotations

from fieldspec.codec.layout.record import FieldLayout
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.members import slot_of
from fieldspec.targets.js.values import throw_wrong_number


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
