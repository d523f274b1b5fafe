"""The enum and the bit field of a register, as lines of a spec, from the meanings and the bits that a list has."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import TypeAlias

from fieldspec.foundation.classes import dataclass
from fieldspec.language.checks.finding import longest_ascent
from fieldspec.language.model.encoding import is_count, is_truth
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.entries import Bit, Entry
from fieldspec.tools.lists.naming import fresh, snake
from fieldspec.tools.lists.quantities import known_unit
from fieldspec.tools.lists.row_reading import SIGNAL, STATES, ListRow
from fieldspec.tools.lists.shapes import BIT
from fieldspec.tools.lists.type_words import UNSIGNED
from fieldspec.tools.lists.yaml_text import exact, quoted

Members: TypeAlias = tuple[tuple[int, str], ...]


@dataclass(frozen=True, slots=True)
class Meant:
    """The lines of enums and of a bit field, the keys that name them, and the type that has them."""

    enum_lines: tuple[str, ...] = ()
    flags_line: str = ""
    keys: tuple[str, ...] = ()
    type: str = ""
    doubts: tuple[str, ...] = ()


def meant(entry: Entry, name: str, enums: dict[object, str], used_names: dict[str, int], only_states: bool) -> Meant:
    """The meanings of a register's numbers; with a scale they are states.

    `enums` has the names of enums by their members, `used_names` all names.
    """
    meanings = entry.row.meanings
    bits = list(entry.bits) or [Bit(own.low, own.high, own.name, None, own.pieces) for own in meanings.bits]
    members = meanings.members
    texts = entry.row.texts
    text = texts.get("values") or "; ".join(f"{n} {texts[role]}" for n, role in enumerate(STATES) if role in texts)
    doubt = (f"Values in the list: {text}.",) if text else ()
    own_type = entry.shape.type
    is_stated = (entry.row.is_own or entry.kind == SIGNAL) and own_type.startswith("u")
    unsigned = own_type if is_stated else UNSIGNED.get(entry.shape.words, "")
    kind = PRIMITIVES[own_type]
    if bits:
        doubts = doubt if members or (meanings.bits and entry.bits) else ()
        if own_type == BIT or not unsigned or max(bit.high for bit in bits) >= PRIMITIVES[unsigned].size * 8:
            return Meant(doubts=doubt)
        flags_name = fresh(name.replace(".", "_"), "bits", used_names)
        bit_texts, enum_lines = bit_lines(bits, enums, used_names)
        source = ", ".join(entry.row.source())
        line = f"  - {{name: {quoted(flags_name)}, type: {unsigned}, bits: [{', '.join(bit_texts)}], {source}}}"
        return Meant(enum_lines, line, (f"flags: {quoted(flags_name)}",), unsigned, doubts)
    own_states: tuple[str, ...] = ()
    if entry.row.special:
        numbers = {number for number, _ in entry.row.special}
        members = tuple(member for member in members if str(member[0]) not in numbers)
        own_states = (f"sentinels: [{', '.join(_states(entry.row.special))}]",)
    if not members:
        return Meant(keys=own_states)
    if only_states or entry.row.scale not in (None, 1) or entry.row.offset:
        return Meant(keys=(f"sentinels: [{', '.join(_members(members, True))}]",))
    if is_truth(kind.encoding) and own_type != BIT and not entry.row.is_own:
        own_type, kind = unsigned, PRIMITIVES[unsigned]
    if not (is_count(kind.encoding) or own_type == BIT or entry.row.is_own) or not all(
        kind.low <= value <= kind.high for value, _ in members
    ):
        return Meant(doubts=doubt)
    members, special = _within(entry.row, members)
    states = (f"sentinels: [{', '.join(_members(special, True))}]",) if special else own_states
    if not members:
        return Meant(keys=states, type=own_type)
    enum_name, line = enum_of(members, name.replace(".", "_"), entry.row, enums, used_names)
    return Meant((line,) if line else (), "", (f"enum: {quoted(enum_name)}", *states), own_type)


def enum_of(
    members: Members, name: str, row: ListRow, enums: dict[object, str], used_names: dict[str, int]
) -> tuple[str, str]:
    """The name of the enum with some members, and its line, which is empty where another value has the same one."""
    known_name = enums.get(members)
    if known_name:
        return known_name, ""
    enum_name = enums[members] = fresh(name, "values", used_names)
    ordered = sorted(members)
    sparse = ", sparse: true" if ordered[-1][0] - ordered[0][0] >= len(ordered) else ""
    texts = ", ".join(_members(ordered))
    source = ", ".join(row.source())
    return enum_name, f"  - {{name: {quoted(enum_name)}, open: true{sparse}, members: [{texts}], {source}}}"


def _within(row: ListRow, members: Members) -> tuple[Members, Members]:
    """The values within the bounds of a row, and those beyond them, which are states."""
    if row.low is None or row.high is None or row.in_unit or row.is_own:
        return members, ()
    members_within = tuple(member for member in members if row.low <= member[0] <= row.high)
    return members_within, tuple(member for member in members if member not in members_within)


def _members(members: Sequence[tuple[int, str]], are_states: bool = False) -> list[str]:
    """The members of an enum, or states, which have no printed names."""
    names: dict[str, int] = {}
    printed: set[str] = set()
    parts = []
    for value, text in members:
        number = str(value).replace("-", "minus_")
        name = fresh(snake(text) or f"value_{number}", number, names)
        printed_name = "" if are_states else _printed(text, name, printed)
        parts.append(f"{{value: {value}, name: {quoted(name)}{printed_name}}}")
    return parts


def _states(special: Sequence[tuple[str, str]]) -> list[str]:
    """The states of an export; states of a float that are not a number are given by their bits."""
    return [
        f"{{bits: {number.removeprefix('NaN ')}, name: {name}}}"
        if number.startswith("NaN")
        else f"{{{'range' if '..' in number else 'value'}: {number}, name: {name}}}"
        for number, name in special
    ]


def bit_lines(
    bits: Sequence[Bit], enums: dict[object, str], used_names: dict[str, int]
) -> tuple[list[str], tuple[str, ...]]:
    """The bits of a bit field as mappings, and the lines of the enums that they name."""
    names: dict[str, int] = {}
    printed: set[str] = set()
    parts: list[str] = []
    lines: list[str] = []
    ordered = sorted(bits, key=lambda bit: bit.low)
    ascending = longest_ascent([bit.row.row if bit.row is not None else 0 for bit in ordered])
    for place, bit in enumerate(ordered):
        texts = [bit.name] if bit.row is None else list(bit.row.names)
        name = fresh(next(filter(None, map(snake, texts)), "") or f"bit_{bit.low}", str(bit.low), names)
        number = f"bit: {bit.low}" if bit.low == bit.high else f'bits: "{bit.pieces or f"{bit.low}..{bit.high}"}"'
        facts = ""
        if bit.row is not None:
            doubts = list(bit.row.doubts)
            if bit.low == bit.high:
                facts = "".join(_switch(bit.row, doubts))
            else:
                facts = "".join(_number(bit, bit.row, doubts))
                members = _named_members(bit)
                is_quantity = bit.row.scale not in (None, 1) or bit.row.offset or bit.row.unit or _is_signed(bit.row)
                if members and is_quantity:  # the language has no states of such bits
                    doubts.append(f"Values in the list: {'; '.join(f'{n} {text}' for n, text in members)}.")
                elif members:
                    enum_name, line = enum_of(members, name, bit.row, enums, used_names)
                    lines += [line] if line else []
                    facts += f", enum: {quoted(enum_name)}"
            facts += f", source: 1 L{bit.row.row}"
            facts += "" if place in ascending else ", allow: {sources_ascending: The list has it so.}"
            if doubts:
                facts += f", notes: [{', '.join(map(quoted, doubts))}]"
        parts.append(f"{{{number}, name: {quoted(name)}{_printed(texts[0] if texts else '', name, printed)}{facts}}}")
    return parts, tuple(lines)


def _named_members(bit: Bit) -> Members:
    """The values of several bits that have names."""
    assert bit.row is not None
    width = bit.high - bit.low + 1
    low, high = (-(1 << (width - 1)), (1 << (width - 1)) - 1) if _is_signed(bit.row) else (0, (1 << width) - 1)
    return tuple(member for member in bit.row.meanings.members if low <= member[0] <= high)


def _is_signed(row: ListRow) -> bool:
    return row.type is not None and (row.type.name.startswith("i") or (not row.type.name and bool(row.type.signed)))


def _switch(row: ListRow, doubts: list[str]) -> Iterator[str]:
    """The meaning of a single bit when it is 0 or 1; it has no quantity."""
    for value, key in ((0, "zero"), (1, "one")):
        if text := dict(row.meanings.members).get(value):
            yield f", {key}: {quoted(text)}"
    if row.scale not in (None, 1):
        doubts.append(f"Scale in the list: {exact(row.scale or Fraction(1))}.")


def _number(bit: Bit, row: ListRow, doubts: list[str]) -> Iterator[str]:
    """The facts of several bits that are a number."""
    width = bit.high - bit.low + 1
    signed = _is_signed(row)
    if signed:
        yield ", signed: true"
    if row.scale not in (None, 1):
        yield f", scale: {exact(row.scale or Fraction(1))}"
    if row.offset:
        yield f", offset: {row.offset:f}"
    if unit := known_unit(row.unit) or row.unit:
        yield f", unit: {quoted(unit)}"
    lowest, highest = (-(1 << (width - 1)), (1 << (width - 1)) - 1) if signed else (0, (1 << width) - 1)
    counts = [count_of(bound, row) for bound in (row.low, row.high)]
    low, high = counts
    if low is not None and high is not None and lowest <= low <= high <= highest:
        if (low, high) != (lowest, highest):
            yield f', range: "{low}..{high}"'
    elif row.low is not None and row.high is not None:
        doubts.append(f"Range in the list: {row.low:f}..{row.high:f}.")


def count_of(number: Decimal | None, row: ListRow) -> int | None:
    """A bound as a whole count; None if it is not whole."""
    if number is None:
        return None
    count = (Fraction(number) - Fraction(row.offset)) / (row.scale or 1) if row.in_unit else Fraction(number)
    return int(count) if count.denominator == 1 else None


def _printed(text: str, name: str, earlier: set[str]) -> str:
    """The key of a printed name, but for one that is printed twice, and for words that are joined in part: the name
    says them."""
    is_whole = "_" not in text or len(text.split()) == 1
    if not text or text == name or text in earlier or not is_whole:
        return ""
    earlier.add(text)
    return f", printed_name: {quoted(text)}"
