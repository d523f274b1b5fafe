"""The enum and the bit field of a register, as lines of a spec, from the meanings and the bits that a list has."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import is_count, is_truth
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.entries import Bit, Entry
from fieldspec.tools.lists.naming import fresh, snake
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.shapes import BIT
from fieldspec.tools.lists.yaml_text import quoted

Members: TypeAlias = tuple[tuple[int, str], ...]

_UNSIGNED = {1: "u16", 2: "u32", 4: "u64"}


@dataclass(frozen=True, slots=True)
class Meant:
    """The lines of an enum and of a bit field, the keys that name them, and the type that has them."""

    enum_line: str = ""
    flags_line: str = ""
    keys: tuple[str, ...] = ()
    type: str = ""
    doubts: tuple[str, ...] = ()


def meant(entry: Entry, name: str, enums: dict[object, str], used_names: set[str], only_states: bool) -> Meant:
    """What a register's numbers mean; beside a power of ten they are states.

    `enums` has the names of enums by their members, `used_names` all names.
    """
    meanings = entry.row.meanings
    bits = list(entry.bits) or [Bit(low, high, text, None) for low, high, text in meanings.bits]
    members = meanings.members
    text = entry.row.texts.get("values", "")
    doubt = (f"Values in the list: {text}.",) if text else ()
    own_type = entry.shape.type
    unsigned = own_type if entry.row.is_own and own_type.startswith("u") else _UNSIGNED.get(entry.shape.words, "")
    kind = PRIMITIVES[own_type]
    if bits:
        doubts = doubt if members or (meanings.bits and entry.bits) else ()
        if own_type == BIT or not unsigned or max(bit.high for bit in bits) >= PRIMITIVES[unsigned].size * 8:
            return Meant(doubts=doubt)
        flags_name = fresh(name.replace(".", "_"), "bits", used_names)
        line = (
            f"  - {{name: {quoted(flags_name)}, type: {unsigned}, bits: [{', '.join(_bits(bits))}], {_source(entry)}}}"
        )
        return Meant("", line, (f"flags: {quoted(flags_name)}",), unsigned, doubts)
    own_states: tuple[str, ...] = ()
    if entry.row.special:
        numbers = {number for number, _ in entry.row.special}
        members = tuple(member for member in members if str(member[0]) not in numbers)
        own_states = (f"sentinels: [{', '.join(_states(entry.row.special))}]",)
    if not members:
        return Meant(keys=own_states)
    if only_states:
        return Meant(keys=(f"sentinels: [{', '.join(_members(members))}]",))
    if is_truth(kind.encoding) and own_type != BIT and not entry.row.is_own:
        own_type, kind = unsigned, PRIMITIVES[unsigned]
    if not (is_count(kind.encoding) or entry.row.is_own) or not all(
        kind.low <= value <= kind.high for value, _ in members
    ):
        return Meant(doubts=doubt)
    members, special = _within(entry.row, members)
    states = (f"sentinels: [{', '.join(_members(special))}]",) if special else own_states
    if not members:
        return Meant(keys=states, type=own_type)
    known = enums.get(members)
    if known:
        return Meant(keys=(f"enum: {quoted(known)}", *states), type=own_type)
    enum_name = enums[members] = fresh(name.replace(".", "_"), "values", used_names)
    ordered = sorted(members)
    sparse = ", sparse: true" if ordered[-1][0] - ordered[0][0] >= len(ordered) else ""
    members_text = ", ".join(_members(ordered))
    line = f"  - {{name: {quoted(enum_name)}, open: true{sparse}, members: [{members_text}], {_source(entry)}}}"
    return Meant(line, "", (f"enum: {quoted(enum_name)}", *states), own_type)


def _within(row: ListRow, members: Members) -> tuple[Members, Members]:
    """The values within the bounds of a row, and those beyond them, which are states."""
    if row.low is None or row.high is None or row.in_unit or row.is_own:
        return members, ()
    members_within = tuple(member for member in members if row.low <= member[0] <= row.high)
    return members_within, tuple(member for member in members if member not in members_within)


def _source(entry: Entry) -> str:
    return f"source: 1 L{entry.row.row}, unverified: true"


def _members(members: Sequence[tuple[int, str]]) -> list[str]:
    names: set[str] = set()
    parts = []
    for value, text in members:
        number = str(value).replace("-", "minus_")
        name = fresh(snake(text) or f"value_{number}", number, names)
        parts.append(f"{{value: {value}, name: {quoted(name)}{_printed(text, name)}}}")
    return parts


def _states(special: Sequence[tuple[str, str]]) -> list[str]:
    """The states of an export; those of a float that is not a number by their bits."""
    return [
        f"{{bits: {number.removeprefix('NaN ')}, name: {name}}}"
        if number.startswith("NaN")
        else f"{{{'range' if '..' in number else 'value'}: {number}, name: {name}}}"
        for number, name in special
    ]


def _bits(bits: Sequence[Bit]) -> list[str]:
    names: set[str] = set()
    parts = []
    for bit in sorted(bits, key=lambda bit: bit.low):
        texts = [bit.name] if bit.row is None else list(bit.row.names)
        name = fresh(next(filter(None, map(snake, texts)), "") or f"bit_{bit.low}", str(bit.low), names)
        number = f"bit: {bit.low}" if bit.low == bit.high else f'bits: "{bit.low}..{bit.high}"'
        source = f", source: 1 L{bit.row.row}" if bit.row is not None else ""
        if bit.row is not None and bit.row.doubts:
            source += f", notes: [{', '.join(map(quoted, bit.row.doubts))}]"
        parts.append(f"{{{number}, name: {quoted(name)}{_printed(texts[0] if texts else '', name)}{source}}}")
    return parts


def _printed(text: str, name: str) -> str:
    return f", printed_name: {quoted(text)}" if text and text != name else ""
