"""The word map with one row per value and bit, and the comment of each memory word."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from typing import TypeAlias

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.omissions import Omission
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import (
    Digits,
    Encoding,
    Octets,
    OfPrecision,
    Real,
    Text,
    Truth,
    Whole,
    has_magnitude,
    is_array,
)
from fieldspec.language.model.enums import Bit, Enum, Flags
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.targets.kv.areas import Area, PlacedValue, bits, bits_text, words
from fieldspec.targets.kv.dialect import WordDialect

COLUMNS = (
    "area",
    "device",
    "word",
    "words",
    "bits",
    "name",
    "type",
    "suffix",
    "in_memory",
    "elements",
    "stride",
    "scale",
    "offset",
    "unit",
    "min",
    "max",
    "ranges",
    "fixed",
    "default",
    "access",
    "values",
    "case",
    "address",
    "byte",
    "label",
    "source",
)

Cell: TypeAlias = int | str | None
Cells: TypeAlias = dict[str, Cell]


def head(layout: DeviceLayout, omissions: Iterable[Omission]) -> list[Sequence[Cell]]:
    """The heading, a row with the identity, and one for each fact that the map leaves out."""
    device = layout.device
    identity: Cells = {"area": "identity", "name": layout.identity, "label": f"{device.name}, version {device.version}"}
    absent: list[Cells] = [{"area": "left out", "name": own.title, "label": own.reason} for own in omissions]
    return [COLUMNS, *(list(map(cells.get, COLUMNS)) for cells in (identity, *absent))]


def rows(device: Device, base: int, area: Area, dialect: WordDialect) -> Iterator[list[Cell]]:
    """The rows of an area, whose first word has the number `base`."""
    for placed_value in area.values:
        for cells in _value(device, base, area, placed_value, dialect):
            yield list(map(cells.get, COLUMNS))


def meanings(device: Device, area: Area) -> list[Enum | Flags]:
    """The enums and the words of flags that give the values of an area their meanings."""
    meanings_of_values: list[Enum | Flags] = []
    for placed_value in area.values:
        value = placed_value.value
        if value is not None and value.enum in device.enums:
            meanings_of_values.append(device.enums[value.enum])
        if value is not None and value.flags in device.flags:
            flags = device.flags[value.flags]
            meanings_of_values += [flags, *(device.enums[bit.enum] for bit in flags.bits if bit.enum in device.enums)]
    return meanings_of_values


def _value(device: Device, base: int, area: Area, placed_value: PlacedValue, dialect: WordDialect) -> Iterator[Cells]:
    value = placed_value.value
    word = placed_value.start // area.unit
    number = value is None or not is_array(value.encoding)
    places = bits(placed_value.start, placed_value.size, placed_value.order, placed_value.swapped, area.unit)
    if placed_value.width:
        places = places[placed_value.shift :][: placed_value.width]
    place: Cells = {"area": area.name, "device": dialect.device(base + word), "word": word}
    if placed_value.elements > 1:
        place |= {"elements": placed_value.elements, "stride": placed_value.stride // area.unit}
    place_cells = _place_cells(area, placed_value)
    row = (
        place
        | place_cells
        | {"words": words(places) if placed_value.size else 0, "name": placed_value.title, "type": placed_value.type}
    )
    if number:
        text = bits_text(places, word)
        row["bits"] = text
    if number and not placed_value.width:
        row |= {
            "in_memory": _in_memory(text, placed_value, dialect),
            "suffix": _suffix(text, placed_value, dialect),
        }
    if value is not None:
        enum = device.enums.get(value.enum) if value.enum else None
        row |= {
            "scale": value.scale_text if value.scaled else None,
            "offset": f"{value.offset:f}" if value.offset else None,
            "unit": value.unit or None,
            **_ranges(value),
            "default": value.default,
            "values": "; ".join(_value_names(value, enum)) or None,
        }
    yield row | {
        "fixed": placed_value.fixed,
        "access": placed_value.access or None,
        "case": placed_value.case or None,
        "label": "reserved" if placed_value.reserved else placed_value.fact.label or None,
        "source": _source(placed_value.fact),
    }
    flags = device.flags.get(value.flags) if value is not None and value.flags else None
    for bit in flags.bits if flags is not None else ():
        enum = device.enums.get(bit.enum) if bit.enum else None
        yield place | {
            "words": 1,
            "bits": bits_text([places[place] for place in bit.places], word),
            "name": f"{placed_value.title}.{bit.name}",
            "type": "bit" if bit.width == 1 else f"i{bit.width}" if bit.signed else "bits",
            "scale": (bit.scale_text or "1") if bit.as_value.scaled else None,
            "offset": f"{bit.offset:f}" if bit.offset else None,
            "unit": bit.unit or None,
            **(_ranges(bit.as_value) if bit.ranges is not None else {}),
            "default": f"to be given: {reason}" if (reason := bit.reason_to_give(enum)) else bit.default,
            "values": _members(enum) if enum is not None else _senses(bit),
            "case": bit.when or None,
            "access": placed_value.access or None,
            "label": "reserved" if bit.reserved else bit.label or None,
            "source": _source(bit),
        }


def _place_cells(area: Area, placed_value: PlacedValue) -> Cells:
    """Where a value is on the wire: the address of its first register, or its first byte."""
    if area.address is None:
        return {"byte": placed_value.start}
    return {"address": f"0x{area.address + placed_value.start // 2:04X}"}


def _in_memory(text: str, placed_value: PlacedValue, dialect: WordDialect) -> str:
    """The steps before an instruction reads a number: its words are rearranged, and its bits converted."""
    rearranged = _rearrangement(text, placed_value, dialect)
    if placed_value.value is None or _has_instruction(placed_value.value.encoding):
        return rearranged
    return "convert" if rearranged == "direct" else f"{rearranged}, convert"


def _has_instruction(encoding: Encoding) -> bool:
    """Whether an instruction may read such a number, if it is not too wide."""
    match encoding:
        case Real():
            return _is_read(encoding.precision)
        case Whole():
            return not has_magnitude(encoding)
        case Truth() | Digits() | Text() | Octets():
            return True
        case _:
            assert_never(encoding)


_is_read = OfPrecision(half=False, single=True, double=True)


def _rearrangement(text: str, placed_value: PlacedValue, dialect: WordDialect) -> str:
    """The rearrangement of words before an instruction reads them as a number of that size."""
    if text in ("15..0", "7..0") or text == _native(dialect):
        return "direct"
    if text == "15..8":
        return "upper byte"
    if text == "7..0 15..8":
        return "swap bytes"
    if text in ("0:15..0 1:15..0", "1:15..0 0:15..0"):
        return "swap words"
    return "join words" if text.count(":15..0") * 2 == placed_value.size else "join bytes"


def _native(dialect: WordDialect) -> str:
    return "1:15..0 0:15..0" if dialect.low_word_first else "0:15..0 1:15..0"


def _suffix(text: str, placed_value: PlacedValue, dialect: WordDialect) -> str | None:
    return dialect.suffixes.get(placed_value.type) if _in_memory(text, placed_value, dialect) == "direct" else None


def _ranges(value: Value) -> Cells:
    """The bounds of what may be written, and all intervals where there are several, or others are read."""
    ranges = value.writable_ranges
    if ranges is None:
        return {}
    interval_text = ranges.text() if len(ranges.intervals) > 1 else None
    if value.write_ranges is not None:
        interval_text = f"{ranges.text()}; read: {value.ranges.text() if value.ranges is not None else 'any'}"
    return {"min": ranges.low, "max": ranges.high, "ranges": interval_text}


def _members(enum: Enum) -> str:
    return "; ".join(f"{member.value} {member.name}" for member in enum.members)


def _value_names(value: Value, enum: Enum | None) -> Iterator[str]:
    """The values that have names: members of the enum, and sentinels."""
    if enum is not None:
        yield _members(enum)
    yield from (f"{sentinel.text} {sentinel.name}" for sentinel in value.sentinels)


def _senses(bit: Bit) -> str | None:
    return "; ".join(f"{number} {text}" for number, text in enumerate((bit.zero, bit.one)) if text) or None


def _source(fact: Fact) -> str | None:
    return "; ".join(source.text() for source in fact.sources) or None


_LETTERS = re.compile("[A-Za-z]+")


def comment_rows(model: Device, base: int, area: Area, dialect: WordDialect) -> Iterator[tuple[str, str]]:
    """Memory devices and their comments, for an area of `model` whose first word has the number `base`."""
    texts: dict[int, dict[str, str]] = {}
    for placed_value in area.values:
        unit = _scaled(model, placed_value)
        for name, start in placed_value.names():
            first, last = start // area.unit, (start + max(placed_value.size, 1) - 1) // area.unit
            texts.setdefault(first, {}).setdefault(name, unit)
            for word in range(first + 1, last + 1):
                texts.setdefault(word, {}).setdefault(f"{name}+{word - first}", unit)
    for word, names in sorted(texts.items()):
        device = dialect.device(base + word)
        if device:
            yield device, _fitted(area.tag, names, dialect.width)


def _scaled(model: Device, placed_value: PlacedValue) -> str:
    """What one count is worth: `0.01mm`."""
    value = placed_value.value
    if value is None or not value.unit:
        return ""
    known = model.unit(value.quantity_unit)
    unit = known.ascii_symbol if known is not None else value.quantity_unit
    if value.scale_by:
        return f"10^{value.scale_by} {unit}".rstrip()
    return f"{value.scale_text}{unit}" if value.scaled else unit


def _fitted(tag: str, names: dict[str, str], width: int) -> str:
    """The names of what a word holds, and the unit of a single one if there is room.

    Words of letters are cut, all to the same length, until it fits.
    """
    text = tag + "/".join(names)
    (unit, *other_units) = names.values()
    if unit and not other_units and len(text) + len(unit) < width:
        return f"{text} {unit}"
    if len(text) <= width:
        return text
    lengths = [len(word) for word in _LETTERS.findall(text)]
    for letters in range(max(lengths, default=0) - 1, 0, -1):
        if len(text) - sum(length - letters for length in lengths if length > letters) <= width:
            return _longer(letters).sub(r"\1", text)
    return text[:width]


@cache
def _longer(letters: int) -> re.Pattern[str]:
    """Words of more letters; the group is what is kept of them."""
    return re.compile(f"([A-Za-z]{{{letters}}})[A-Za-z]+")
