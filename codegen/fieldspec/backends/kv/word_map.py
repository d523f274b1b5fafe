"""The word map: one row a value, one row a bit with a meaning."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeAlias

from fieldspec.backends.kv.areas import Area
from fieldspec.backends.kv.bits import bits, words, written
from fieldspec.backends.kv.dialect import WordDialect
from fieldspec.backends.kv.held import Held
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.model.enum import Enum
from fieldspec.model.fact import Fact
from fieldspec.model.flags import Bit, Flags
from fieldspec.model.value import Value

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


def head(layout: DeviceLayout) -> list[Sequence[Cell]]:
    """The heading, and a row with the identity."""
    device = layout.device
    about: Cells = {"area": "identity", "name": layout.identity, "label": f"{device.name}, version {device.version}"}
    return [COLUMNS, list(map(about.get, COLUMNS))]


def rows(device: Device, base: int, area: Area, dialect: WordDialect) -> Iterator[list[Cell]]:
    """The rows of an area, whose first word has the number `base`."""
    for held in area.held:
        for cells in _value(device, base, area, held, dialect):
            yield list(map(cells.get, COLUMNS))


def meanings(device: Device, area: Area) -> list[Enum | Flags]:
    """What the rows of an area tell beside what is in the area."""
    found: list[Enum | Flags] = []
    for held in area.held:
        value = held.value
        if value is not None and value.enum in device.enums:
            found.append(device.enums[value.enum])
        if value is not None and value.flags in device.flags:
            flags = device.flags[value.flags]
            found += [flags, *(device.enums[bit.enum] for bit in flags.bits if bit.enum in device.enums)]
    return found


def _value(device: Device, base: int, area: Area, held: Held, dialect: WordDialect) -> Iterator[Cells]:
    value = held.value
    word = held.start // area.unit
    number = value is None or value.type.letter != "s"
    places = bits(held.start, held.size, held.order, held.swapped, area.unit)
    place: Cells = {"area": area.name, "device": dialect.device(base + word), "word": word}
    if held.elements > 1:
        place |= {"elements": held.elements, "stride": held.stride // area.unit}
    where = _where(area, held)
    row = place | where | {"words": words(places) if held.size else 0, "name": held.title, "type": held.type}
    if number:
        text = written(places, word)
        row |= {"bits": text, "in_memory": _in_memory(text, held, dialect), "suffix": _suffix(text, held, dialect)}
    if value is not None:
        enum = device.enums.get(value.enum) if value.enum else None
        row |= {
            "scale": value.scale_text if value.scaled else None,
            "offset": f"{value.offset:f}" if value.offset else None,
            "unit": value.unit or None,
            **_ranges(value),
            "default": value.default,
            "values": "; ".join(_named(value, enum)) or None,
        }
    yield row | {
        "fixed": held.fixed,
        "access": held.access or None,
        "case": held.case or None,
        "label": "reserved" if held.reserved else held.fact.label or None,
        "source": _source(held.fact),
    }
    flags = device.flags.get(value.flags) if value is not None and value.flags else None
    for bit in flags.bits if flags is not None else ():
        enum = device.enums.get(bit.enum) if bit.enum else None
        yield place | {
            "words": 1,
            "bits": written(places[bit.first : bit.last + 1], word),
            "name": f"{held.title}.{bit.name}",
            "type": "bit" if bit.width == 1 else "bits",
            "values": _members(enum) if enum is not None else _senses(bit),
            "case": bit.when or None,
            "access": held.access or None,
            "label": "reserved" if bit.reserved else bit.label or None,
            "source": _source(bit),
        }


def _where(area: Area, held: Held) -> Cells:
    """Where a value is on the wire: the address of its first register, or its first byte."""
    if area.address is None:
        return {"byte": held.start}
    return {"address": f"0x{area.address + held.start // 2:04X}"}


def _in_memory(text: str, held: Held, dialect: WordDialect) -> str:
    """What must be done with the words before an instruction reads them as a number of that size."""
    if text in ("15..0", "7..0") or text == _native(dialect):
        return "direct"
    if text == "15..8":
        return "upper byte"
    if text == "7..0 15..8":
        return "swap bytes"
    if text in ("0:15..0 1:15..0", "1:15..0 0:15..0"):
        return "swap words"
    return "join words" if text.count(":15..0") * 2 == held.size else "join bytes"


def _native(dialect: WordDialect) -> str:
    return "1:15..0 0:15..0" if dialect.low_word_first else "0:15..0 1:15..0"


def _suffix(text: str, held: Held, dialect: WordDialect) -> str | None:
    return dialect.suffixes.get(held.type) if _in_memory(text, held, dialect) == "direct" else None


def _ranges(value: Value) -> Cells:
    """The bounds of what may be written, and all intervals where there are several, or others are read."""
    ranges = value.written_ranges
    if ranges is None:
        return {}
    several = ranges.text() if len(ranges.intervals) > 1 else None
    if value.write_ranges is not None:
        several = f"{ranges.text()}; read: {value.ranges.text() if value.ranges is not None else 'any'}"
    return {"min": ranges.low, "max": ranges.high, "ranges": several}


def _members(enum: Enum) -> str:
    return "; ".join(f"{member.value} {member.name}" for member in enum.members)


def _named(value: Value, enum: Enum | None) -> Iterator[str]:
    """The values that have names: members of the enum, and sentinels."""
    if enum is not None:
        yield _members(enum)
    yield from (f"{sentinel.text} {sentinel.name}" for sentinel in value.sentinels)


def _senses(bit: Bit) -> str | None:
    return "; ".join(f"{number} {text}" for number, text in enumerate((bit.zero, bit.one)) if text) or None


def _source(fact: Fact) -> str | None:
    return "; ".join(source.text() for source in fact.sources) or None
