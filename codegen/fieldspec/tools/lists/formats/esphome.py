"""Configurations of ESPHome as rows: a row for each entity that a controller reads or writes at an address.

A number is sent as value * multiply; a filter of a sensor computes the value from the count.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction

from fieldspec.foundation.classes import replace
from fieldspec.language.reading.nodes import Mapping, Node
from fieldspec.tools.lists import cells
from fieldspec.tools.lists.entries import SPACES
from fieldspec.tools.lists.formats.format_rows import FormatRows
from fieldspec.tools.lists.formats.yaml_items import cells_of, items, line_of, number_of, text_of, whole_of
from fieldspec.tools.lists.item import REGISTERS
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.quantities import exact_decimal
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.sheet import CellError, Sheet
from fieldspec.tools.lists.type_words import Typed, typed
from fieldspec.tools.lists.value_texts import Meanings, mask_bits

_ROLES = {
    "address": "address",
    "name": "name",
    "id": "printed_name",
    "register_type": "space",
    "value_type": "type",
    "register_count": "words",
    "response_size": "length",
    "offset": "address in a range",
    "bitmask": "bits",
    "filters": "scale",
    "multiply": "gain",
    "unit_of_measurement": "unit",
    "min_value": "min",
    "max_value": "max",
    "optionsmap": "values",
    "raw_encode": "encoding",
    "platform": "kind",
    "entity": "access",
}
_NOTES = ("lambda", "write_lambda")
_WRITING = ("number", "output", "select", "switch")
_ENTITIES = ("sensor", "binary_sensor", "text_sensor", *_WRITING)
_HOLDING_BY_DEFAULT = ("number", "output", "select")
_SERVER = "server_registers"
_SUBSTITUTIONS = re.compile(r"^substitutions:[ \t]*\n(?:[ \t#].*\n|\n)+", re.MULTILINE)
_SUBSTITUTION = re.compile(r"^[ \t]+(\w+):[ \t]*[\"']?([^\"'#\n]*[^\"'#\s])", re.MULTILINE)
_REFERENCE = re.compile(r"\$(?:\{(\w+)\}|(\w+))")


def substituted(text: str) -> str:
    """A text with its substitutions in place: `${device}`."""
    section = _SUBSTITUTIONS.search(text)
    values = dict(_SUBSTITUTION.findall(section[0])) if section else {}
    return _REFERENCE.sub(lambda match: values.get(match[1] or match[2], match[0]), text) if values else text


def is_configuration(node: Node) -> bool:
    """Whether a tree has an entity of a controller at an address."""
    return isinstance(node, Mapping) and next(_entities(node), None) is not None


def configuration(node: Node, lines: int) -> tuple[Sheet, Listing]:
    """The list of a configuration. Raises ListError."""
    assert isinstance(node, Mapping)
    rows = FormatRows("a configuration of ESPHome", _ROLES, _NOTES)
    earlier: dict[tuple[object, ...], int] = {}
    for entity, item in _entities(node):
        line, cells = line_of(item), {**cells_of(item), "entity": entity}
        try:
            row = _row(entity, item)
        except CellError as error:
            rows.refuse(line, cells, str(error), error.key)
            continue
        place = (row.space, row.address, row.bits, row.type)
        if place in earlier:
            first = rows.items[earlier[place]]
            assert first.row is not None
            if row.access != first.row.access:
                rows.items[earlier[place]] = replace(first, row=replace(first.row, access="rw"))
            rows.refuse(line, cells, f"is what the object in line {first.line} is; together they say the access")
            continue
        earlier[place] = len(rows.items)
        rows.add(line, cells, row)
    return rows.listing(lines)


def _entities(node: Mapping) -> Iterator[tuple[str, Mapping]]:
    """The entities with an address, each with its kind, in the order of the file."""
    for key, value in node.values.items():
        for item in items(value):
            if not isinstance(item, Mapping):
                continue
            is_entity = key in _ENTITIES and text_of(item.values.get("platform")).endswith("_controller")
            if is_entity and ("address" in item.values or "custom_command" in item.values):
                yield key, item
            for inner in items(item.values.get(_SERVER)):
                if isinstance(inner, Mapping) and "address" in inner.values:
                    yield _SERVER, inner


def _row(entity: str, item: Mapping) -> ListRow:
    """The row of an entity. Raises CellError."""
    values = item.values
    address = whole_of(values.get("address"))
    if address is None:
        raise CellError("is not an address", "address")
    space = _space(entity, text_of(values.get("register_type")))
    offset = whole_of(values.get("offset")) or 0
    in_bits = SPACES[space]
    if not in_bits and offset % 2:
        raise CellError("is half a register", "offset")
    own_type, words, order = _type(entity, values, space)
    doubts: list[str] = []
    scale, moved = _scale(entity, values, doubts)
    options = values.get("optionsmap")
    members = [
        (number, text)
        for text, inner in (options.values.items() if isinstance(options, Mapping) else ())
        if (number := whole_of(inner)) is not None
    ]
    texts = {
        "name": text_of(values.get("name")) or text_of(values.get("id")),
        "type": text_of(values.get("value_type")),
    }
    texts |= {role: text for key, role in _BOUNDS.items() if (text := text_of(values.get(key)))}
    writes = entity in _WRITING or "write_lambda" in values
    return ListRow(
        0,
        address + (offset if in_bits else offset // 2),
        words,
        names=tuple(filter(None, (text_of(values.get("name")), text_of(values.get("id"))))),
        type=own_type,
        access="wo" if entity == "output" else "rw" if writes else "ro",
        low=number_of(values.get("min_value")),
        high=number_of(values.get("max_value")),
        texts=texts,
        space=space,
        bits=_mask(values, space),
        scale=scale,
        offset=moved,
        unit=text_of(values.get("unit_of_measurement")),
        order=order,
        meanings=Meanings(tuple(dict(members).items())),
        in_unit=scale != 1 or bool(moved),
        doubts=tuple(doubts),
    )


_BOUNDS = {"min_value": "min", "max_value": "max", "unit_of_measurement": "unit"}


def _space(entity: str, text: str) -> str:
    if not text and (entity in _HOLDING_BY_DEFAULT or entity == _SERVER):
        return REGISTERS
    space_name = "input_registers" if text == "read" else cells.space(text)
    if not space_name:
        raise CellError("is not a kind of registers" if text else "is not stated", "register_type")
    return space_name


def _type(entity: str, values: dict[str, Node], space: str) -> tuple[Typed, int | None, str]:
    """The type, the number of registers where it is stated, and the order of words. Raises CellError."""
    if SPACES[space]:
        return Typed("bit"), None, ""
    count, size = whole_of(values.get("register_count")), whole_of(values.get("response_size"))
    if entity == "text_sensor":
        count = count or (size + 1) // 2 if size is not None else count
        if not count or count < 0:
            raise CellError("is not a number of registers", "register_count")
        is_text = text_of(values.get("raw_encode")) in ("", "NONE")
        return Typed("text" if is_text else "bytes", length=size or 0), count, ""
    text = text_of(values.get("value_type")) or "U_WORD"
    own_type = typed(text)
    if own_type is None or not own_type.name:
        raise CellError("has no size" if text == "RAW" else "is not a type", "value_type")
    order = (own_type.order or "ABCD") if own_type.size > 1 else ""
    return Typed(own_type.name), own_type.size, order


def _mask(values: dict[str, Node], space: str) -> tuple[int, int] | None:
    mask = whole_of(values.get("bitmask"))
    if mask is None or mask == 0xFFFFFFFF or SPACES[space]:
        return None
    bits = mask_bits(mask)
    if bits is None:
        raise CellError("has bits that are not adjacent", "bitmask")
    return bits


def _scale(entity: str, values: dict[str, Node], doubts: list[str]) -> tuple[Fraction | None, Decimal]:
    """The scale and the offset of a value: by the filters of a sensor, or by what a number is multiplied with."""
    scale, offset = Fraction(1), Fraction(0)
    for entry in items(values.get("filters")):
        for name, inner in entry.values.items() if isinstance(entry, Mapping) else ():
            number = number_of(inner)
            if name == "multiply" and number is not None and number > 0:
                scale, offset = scale * Fraction(number), offset * Fraction(number)
            elif name == "offset" and number is not None:
                offset += Fraction(number)
            else:
                doubts.append(f"Filter in the list: {name} {text_of(inner)}.".replace(" .", "."))
    multiplied = number_of(values.get("multiply"))
    if multiplied is not None and multiplied > 0:
        scale /= Fraction(multiplied)
    elif "multiply" in values:
        doubts.append(f"Multiply in the list: {text_of(values['multiply'])}.")
    moved = exact_decimal(offset)
    if moved is None:
        doubts.append(f"Offset in the list: {offset}.")
    return scale, moved or Decimal(0)
