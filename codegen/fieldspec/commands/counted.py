"""What people write for a value, as the count that comes next to it."""

from __future__ import annotations

import re
from decimal import Decimal
from fractions import Fraction

from fieldspec.classes import dataclass
from fieldspec.layout.explaining.numbered import number_written
from fieldspec.layout.explaining.worded import in_unit
from fieldspec.model.device import Device
from fieldspec.model.value import Value

_QUANTITY = re.compile(r"([-+]?[0-9]{1,30}(?:\.[0-9]{1,30})?) ?(\S.*)")
_SHOWN = 4


@dataclass(frozen=True, slots=True)
class Count:
    """The count next to a quantity: `exact` is the quantity in counts, `text` is what `raw` stands for."""

    raw: int
    exact: str
    text: str
    is_whole: bool


def nearest(value: Value, text: str) -> Count | None:
    """The count next to `50 %`; of two the even one. None where the text is no quantity in the value's unit."""
    match = _QUANTITY.fullmatch(text.strip())
    if match is None or match[2] != value.unit:
        return None
    counts = (Fraction(match[1]) - Fraction(value.offset)) / Fraction(value.scale)
    raw = round(counts)
    exact = f"{Decimal(round(counts * 10**_SHOWN)).scaleb(-_SHOWN).normalize():f}"
    return Count(raw, exact, in_unit(value, raw), counts == raw)


def parameter_number(device: Device, name: str, text: str) -> int | None:
    """The number on the wire of a parameter of a set, or of a space of sets, that a name of ours or of print means."""
    for words in device.sets(name):
        for parameter in words.parameters:
            if text.lower() in (parameter.name, parameter.printed_name.lower()):
                return words.base + parameter.number
        number = number_written(words, text)
        if number is not None:
            return words.base + number
    return None
