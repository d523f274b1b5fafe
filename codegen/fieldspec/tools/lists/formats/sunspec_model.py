"""Models of SunSpec in JSON as rows: a row for each point, and a field of a table for each in a group that repeats.

Their JSON is read as it is: pysunspec2 reads it in the same way, and needs serial ports for it; tests compare with it.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from fractions import Fraction
from functools import partial
from typing import Any

from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.tools.lists.assumption import Assumption
from fieldspec.tools.lists.exponents import USUAL
from fieldspec.tools.lists.formats.format_rows import FormatRows, decimal
from fieldspec.tools.lists.item import REGISTERS
from fieldspec.tools.lists.json_text import json_data
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.naming import fresh, named
from fieldspec.tools.lists.row_reading import FIELD, REGISTER, ListRow
from fieldspec.tools.lists.sheet import CellError, ListError, Sheet
from fieldspec.tools.lists.type_words import Typed
from fieldspec.tools.lists.value_texts import Meanings, NamedBits

SIGNS = re.compile(r"\A\s*\{(?=.*\"group\"\s*:)(?=.*\"points\"\s*:)", re.DOTALL)
"""What such a file has."""

_TYPES = {
    "int16": ("i16", "-32768"),
    "int32": ("i32", "-2147483648"),
    "int64": ("i64", "-9223372036854775808"),
    "raw16": ("u16", ""),
    "uint16": ("u16", "65535"),
    "uint32": ("u32", "4294967295"),
    "uint64": ("u64", "18446744073709551615"),
    "acc16": ("u16", "0"),
    "acc32": ("u32", "0"),
    "acc64": ("u64", "0"),
    "count": ("u16", ""),
    "pad": ("i16", "-32768"),
    "sunssf": ("i16", "-32768"),
    "enum16": ("u16", "65535"),
    "enum32": ("u32", "4294967295"),
    "bitfield16": ("u16", ""),
    "bitfield32": ("u32", ""),
    "bitfield64": ("u64", ""),
    "float32": ("f32", "NaN 0x7FC00000"),
    "float64": ("f64", "NaN 0x7FF8000000000000"),
    "string": ("text", ""),
    "ipaddr": ("bytes", ""),
    "ipv6addr": ("bytes", ""),
    "eui48": ("bytes", ""),
}
"""The types of the language, and the number for a point that is not implemented, by the types of SunSpec."""

_EXPONENT = "sunssf"
_UNITS = {"C": "°C", "Pct": "%"}
"""Symbols that stand for something else elsewhere."""

_ROLES = {
    "address": "address",
    "name": "name",
    "label": "label",
    "type": "type",
    "size": "words",
    "sf": "scale",
    "units": "unit",
    "access": "access",
    "value": "const",
    "symbols": "values",
    "count": "count",
}
_NOTES = ("desc", "detail")
_MOST_ELEMENTS = 1 << 16


@dataclass(slots=True)
class _Model:
    """The content of a model: its rows, the next address, and the variable group after which addresses are open."""

    rows: FormatRows
    following: int = 0
    open: str = ""
    names: dict[str, int] = field(default_factory=dict)


def sunspec_model(text: str, node: str = "") -> tuple[Sheet, Listing] | None:
    """The list of a model, counted from its first register; None for other JSON. Raises ListError."""
    data = json_data(text)
    group = data.get("group") if isinstance(data, dict) else None
    if not isinstance(group, dict) or not isinstance(group.get("points"), list):
        return None
    if node:
        raise ListError("has no nodes, so --node has no effect; leave it out")
    rows = FormatRows("a model of SunSpec", _ROLES, _NOTES)
    reading = "counted from the first register of the model"
    rows.assumptions.append(Assumption("addresses", reading, "a model does not say where a device has it", "--offset"))
    model = _Model(rows)
    _points(model, group, (), 1)
    for inner in _groups(group):
        _group(model, inner, ())
    return rows.listing(len(rows.items) + 1)


def _groups(group: dict[str, Any]) -> Iterator[dict[str, Any]]:
    groups = group.get("groups", [])
    yield from (inner for inner in (groups if isinstance(groups, list) else []) if isinstance(inner, dict))


def _group(model: _Model, group: dict[str, Any], names: tuple[str, ...]) -> None:
    """Adds the points of a group and of those in it: registers, or fields of a table where it repeats."""
    count = group.get("count", 1)
    name = fresh(named([str(group.get("name", ""))], model.following, "group"), "group", model.names)
    if not names and count == 1:
        _points(model, group, (), 1)
        for inner in _groups(group):
            _group(model, inner, ())
        return
    is_fixed = isinstance(count, int) and 0 < count < _MOST_ELEMENTS
    number = count if is_fixed and not names else 1
    start, first = model.following, len(model.rows.items)
    _points(model, group, (*names, name), number)
    for inner in _groups(group):
        _group(model, inner, (*names, name))
    width = model.following - start
    if not is_fixed:
        condition = (
            f"as often as {count} says" if isinstance(count, str) else "as often as the length of the model says"
        )
        assumption = Assumption("repeats", f"{name} once", f"the model has it {condition}")
        model.rows.assumptions.append(assumption)
        model.open = model.open or name
    elif names and number < count:
        model.rows.assumptions.append(Assumption("repeats", f"{name} once", f"the model has it {count} times"))
        model.open = model.open or name
    if not names:
        for place in range(first, len(model.rows.items)):
            item = model.rows.items[place]
            if item.row is not None:
                model.rows.items[place] = replace(item, row=replace(item.row, stride=width))
        model.following = start + width * number


def _points(model: _Model, group: dict[str, Any], names: tuple[str, ...], count: int) -> None:
    points = group.get("points", [])
    for point in points if isinstance(points, list) else []:
        if not isinstance(point, dict):
            raise ListError("has a point that is not an object")
        cells = {key: value if isinstance(value, str) else json.dumps(value) for key, value in point.items()}
        cells |= {"address": str(model.following)}
        line = len(model.rows.items) + 1
        size = point.get("size")
        if not isinstance(size, int) or not 0 < size < _MOST_ELEMENTS:
            raise ListError(f"has a point {str(point.get('name'))[:60]} whose size is not a number of registers")
        model.rows.take(line, cells, partial(_row, model, point, names, count, size))
        model.following += size


def _row(model: _Model, point: dict[str, Any], names: tuple[str, ...], count: int, size: int) -> ListRow:
    """The row of a point. Raises CellError."""
    if model.open:
        raise CellError(f"follows {model.open}, which repeats as often as the device has it")
    kind = str(point.get("type", ""))
    if kind not in _TYPES:
        raise CellError(f"has the type {kind[:60]}, which is not a SunSpec type")
    type_name, absent = _TYPES[kind]
    own_name = str(point.get("name", ""))
    doubts: list[str] = []
    members, bits = _symbols(point.get("symbols"), kind.startswith("bitfield"), doubts)
    scale, factor = point.get("sf"), None
    texts = {"type": kind, "bytes": str(size * 2) if type_name in ("text", "bytes") else ""}
    if isinstance(scale, int) and abs(scale) <= 30:
        factor = Fraction(10) ** scale
    elif scale is not None:
        texts["scale"] = str(scale)
        doubts.append(f"Scale in the list: {scale}.")
    constant = decimal(str(point["value"])) if isinstance(point.get("value"), int) else None
    texts |= {"const": str(point["value"])} if constant is not None else {}
    texts |= {"label": str(point["label"])} if isinstance(point.get("label"), str) else {}
    if names:
        name = ".".join((*names, named([own_name], model.following)))
        texts |= {"name": name, "printed_name": own_name}
    unit = str(point.get("units") or "").strip()
    states = ((absent, "not_implemented"),) if absent and constant is None and not members else ()
    bounds = USUAL if kind == _EXPONENT else (None, None)
    return ListRow(
        0,
        model.following,
        size,
        names=(own_name,),
        type=Typed(type_name),
        access="rw" if point.get("access") == "RW" else "ro",
        low=bounds[0],
        high=bounds[1],
        const=constant,
        count=count,
        texts=texts,
        kind=FIELD if names else REGISTER,
        space=REGISTERS,
        scale=factor,
        unit=_UNITS.get(unit, unit),
        meanings=Meanings(members, bits),
        special=states,
        doubts=tuple(doubts),
    )


def _symbols(
    symbols: object, of_bits: bool, doubts: list[str]
) -> tuple[tuple[tuple[int, str], ...], tuple[NamedBits, ...]]:
    """The values or the bits that have names. Any other statement about them is a doubt."""
    members: dict[int, str] = {}
    for symbol in symbols if isinstance(symbols, list) else []:
        value = symbol.get("value") if isinstance(symbol, dict) else None
        if isinstance(value, int) and 0 <= value < (64 if of_bits else 1 << 64):
            members[value] = str(symbol.get("name", ""))
            texts = dict.fromkeys(str(symbol[key]) for key in ("label", "desc", "detail") if symbol.get(key))
            doubts += [
                f"{members[value]} in the list: {text[:200].rstrip('.')}." for text in texts if text != members[value]
            ]
        else:
            doubts.append(f"Symbol in the list: {str(symbol)[:200]}.")
    if of_bits:
        return (), tuple(NamedBits(value, value, name) for value, name in members.items())
    return tuple(members.items()), ()
