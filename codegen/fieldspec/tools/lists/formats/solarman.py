"""Definitions of inverters for Solarman as rows: a row for each item with registers.

The first register of an item has the lowest word. A quantity is (count - offset) * scale / divide.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction
from functools import partial
from itertools import pairwise

from fieldspec.foundation.classes import dataclass
from fieldspec.language.reading.nodes import Mapping, Node, Scalar
from fieldspec.tools.lists.assumption import Assumption
from fieldspec.tools.lists.cells import functions
from fieldspec.tools.lists.formats.format_rows import FormatRows
from fieldspec.tools.lists.formats.yaml_items import cells_of, items, line_of, number_of, numbers_of, text_of, whole_of
from fieldspec.tools.lists.item import REGISTERS
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.quantities import exact_decimal
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.sheet import CellError, Sheet
from fieldspec.tools.lists.type_words import Typed
from fieldspec.tools.lists.value_texts import Meanings, NamedBits, mask_bits

_ROLES = {
    "registers": "address",
    "name": "name",
    "rule": "type",
    "scale": "scale",
    "divide": "divisor",
    "offset": "value_offset",
    "uom": "unit",
    "lookup": "values",
    "mask": "bits",
    "bit": "bit",
    "range": "range",
    "validation": "bounds",
    "code": "function",
}
_NOTES = ("description",)
_SIGNED = {1: False, 2: True, 3: False, 4: True}
_WIDTHS = {1: 16, 2: 32, 3: 48, 4: 64}
_TEXT = 5
_BIT_FIELD = 6
_OTHERS = {7: "a version in nibbles", 8: "a date", 9: "a time", 10: "raw bytes"}


@dataclass(frozen=True, slots=True)
class _Request:
    first: int
    last: int
    space: str


def is_definition(node: Node) -> bool:
    """Whether a tree is such a definition: groups of parameters with items."""
    groups = items(node.values.get("parameters")) if isinstance(node, Mapping) else []
    return any(isinstance(group, Mapping) and "items" in group.values for group in groups)


def definition(node: Node, lines: int) -> tuple[Sheet, Listing]:
    """The list of a definition. Raises ListError."""
    assert isinstance(node, Mapping)
    rows = FormatRows("a definition of an inverter for Solarman", _ROLES, _NOTES)
    rows.assumptions.append(
        Assumption("order of words", "the first register has the lowest word", "what reads these files has it so")
    )
    requests = list(_requests(node))
    default = node.values.get("default")
    usual = default.values.get("code") if isinstance(default, Mapping) else None
    for group in items(node.values.get("parameters")):
        inner = group.values.get("items") if isinstance(group, Mapping) else None
        for item in items(inner):
            if isinstance(item, Mapping):
                rows.take(line_of(item), cells_of(item), partial(_row, item, requests, usual))
            else:
                rows.refuse(line_of(item), {"name": text_of(item)}, "is not an item")
    return rows.listing(lines)


def _requests(node: Mapping) -> Iterator[_Request]:
    """The areas that are read, each with its address space."""
    for request in items(node.values.get("requests")):
        if isinstance(request, Mapping):
            first, last = whole_of(request.values.get("start")), whole_of(request.values.get("end"))
            code = text_of(request.values.get("mb_functioncode") or request.values.get("code"))
            read = functions(code) if code else None
            if first is not None and last is not None and read is not None:
                yield _Request(first, last, read.space)


def _row(item: Mapping, requests: list[_Request], usual: Node | None) -> ListRow:
    """The row of an item, read by the `usual` code where it has none. Raises CellError."""
    values = item.values
    registers = numbers_of(values.get("registers"))
    if "registers" not in values or not registers:
        raise CellError("has no registers: it is computed from other items", "registers")
    rule = whole_of(values.get("rule"))
    own_type, order = _type(rule, registers)
    texts: dict[str, str] = {"type": text_of(values.get("rule")), "name": text_of(values.get("name"))}
    doubts: list[str] = []
    bits = _mask(values, doubts)
    scale, offset = _scale(values, doubts)
    low, high = _bounds(values, doubts)
    meanings = _lookup(values.get("lookup"), rule == _BIT_FIELD, doubts)
    unit = text_of(values.get("uom"))
    texts |= {"unit": unit} if unit else {}
    space, access = _space(values.get("code", usual), min(registers), requests)
    return ListRow(
        0,
        min(registers),
        len(registers),
        names=tuple(filter(None, (text_of(values.get("name")),))),
        type=own_type,
        access=access,
        low=low,
        high=high,
        texts=texts,
        space=space,
        bits=bits,
        scale=scale,
        offset=offset,
        unit=unit,
        order=order,
        meanings=meanings,
        in_unit=scale != 1 or bool(offset),
        doubts=tuple(doubts),
    )


def _type(rule: int | None, registers: list[int]) -> tuple[Typed, str]:
    """The type and the order of words. Raises CellError."""
    ascending = all(b - a == 1 for a, b in pairwise(registers))
    descending = all(a - b == 1 for a, b in pairwise(registers))
    if not (ascending or descending):
        raise CellError("has registers that are not consecutive", "registers")
    if rule == _TEXT and ascending:
        return Typed("text", length=len(registers) * 2), ""
    width = _WIDTHS.get(len(registers))
    if rule == _BIT_FIELD and width in (16, 32, 64):
        return Typed(f"u{width}"), "ABCD"
    if rule not in _SIGNED:
        raise CellError(f"is {_OTHERS.get(rule or 0, 'a rule')}, which a register does not have as a type", "rule")
    if width is None:
        raise CellError("are more than a number has", "registers")
    order = "" if len(registers) == 1 else "ABCD" if descending else "CDAB"
    return Typed(f"{'i' if _SIGNED[rule] else 'u'}{width}"), order


def _mask(values: dict[str, Node], doubts: list[str]) -> tuple[int, int] | None:
    """The bits of a mask that has neighbours only, or of a number of a bit."""
    bit, mask = whole_of(values.get("bit")), whole_of(values.get("mask"))
    if bit is not None and 0 <= bit < 64:
        return bit, bit
    own_bits = mask_bits(mask) if mask is not None else None
    if mask is not None and own_bits is None:
        doubts.append(f"Mask in the list: {mask:#x}.")
    return own_bits


def _scale(values: dict[str, Node], doubts: list[str]) -> tuple[Fraction | None, Decimal]:
    """The scale, and the offset in the unit: counts are less by the offset of the item before they are scaled."""
    scale, divisor = Fraction(1), Fraction(1)
    for key in ("scale", "divide"):
        if key in values:
            number = number_of(values[key])
            if number is None or number <= 0:
                doubts.append(f"{key.capitalize()} in the list: {_own_text(values[key])}.")
            elif key == "scale":
                scale = Fraction(number)
            else:
                divisor = Fraction(number)
    offset = number_of(values.get("offset")) or Decimal(0)
    total = scale / divisor
    moved = -Fraction(offset) * total
    exact = exact_decimal(moved)
    if exact is None:
        doubts.append(f"Offset in the list: {offset}.")
    return total, exact or Decimal(0)


def _own_text(node: Node) -> str:
    return text_of(node) if isinstance(node, Scalar) else "several"


def _bounds(values: dict[str, Node], doubts: list[str]) -> tuple[Decimal | None, Decimal | None]:
    """The bounds in the unit, of a range or of a validation; one without the other is a doubt."""
    for key in ("range", "validation"):
        node = values.get(key)
        if isinstance(node, Mapping):
            low, high = number_of(node.values.get("min")), number_of(node.values.get("max"))
            if low is not None and high is not None:
                return low, high
            text = ", ".join(f"{name} {text_of(inner)}" for name, inner in node.values.items())
            doubts.append(f"{key.capitalize()} in the list: {text}.")
    return None, None


def _lookup(node: Node | None, of_bits: bool, doubts: list[str]) -> Meanings:
    """The texts of values, or of bits."""
    members: list[tuple[int, str]] = []
    bits: list[NamedBits] = []
    for entry in items(node):
        values = entry.values if isinstance(entry, Mapping) else {}
        text, number = text_of(values.get("value")), whole_of(values.get("key"))
        bit = whole_of(values.get("bit"))
        numbers = [number] if number is not None else numbers_of(values.get("key")) or []
        if text and bit is not None and 0 <= bit < 64:
            bits.append(NamedBits(bit, bit, text))
        elif text and numbers and not of_bits:
            members += [(number, text) for number in numbers]
        elif text and of_bits and len(numbers) == 1 and numbers[0] > 0 and numbers[0] & (numbers[0] - 1) == 0:
            position = numbers[0].bit_length() - 1
            bits.append(NamedBits(position, position, text))
        else:
            doubts.append(f"Lookup in the list: {text_of(values.get('key')) or 'several'} {text}.")
    if len({number for number, _ in members}) < len(members):
        doubts.append("The list has one of its values twice.")
        members = list(dict(members).items())
    return Meanings(tuple(members), tuple(bits))


def _space(code: Node | None, address: int, requests: list[_Request]) -> tuple[str, str]:
    """The address space and the access: by the codes of functions of the item, or of what is read at its address."""
    read = code.values.get("read") if isinstance(code, Mapping) else code
    writes = isinstance(code, Mapping) and "write" in code.values
    stated = functions(text_of(read)) if text_of(read) else None
    if stated is not None:
        return stated.space, "rw" if writes else "ro"
    area = next((request.space for request in requests if request.first <= address <= request.last), REGISTERS)
    return area, "rw" if writes else "ro"
