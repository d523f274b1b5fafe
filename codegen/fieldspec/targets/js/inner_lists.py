"""Records with fields behind lists: their table, and the functions that write them through an image."""

from __future__ import annotations

import json

from fieldspec.codec.layout.inner_lists import inner_lists_data
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.members import members_of
from fieldspec.targets.js.text import literal


def list_length(key: str, highest_count: int) -> str:
    """The elements of a list whose bytes are counted before it is checked: `listLength(value, "values", 59)`"""
    return f"listLength(value, {literal(key)}, {highest_count})"


def list_table(record: RecordLayout, name: str) -> list[str]:
    """Where the lists of a record with fields behind them are; nothing for others."""
    if record.inner_lists is None:
        return []
    data = inner_lists_data(record.inner_lists)
    rows = (", ".join(f"{key}: {json.dumps(value)}" for key, value in row.items()) for row in data["lists"])
    return [
        f"const inner{name} = {{",
        f"  fixed: {record.inner_lists.fixed},",
        *("  lists: [", *(f"    {{ {row} }}," for row in rows), "  ],"),
        "};",
    ]


def write_lists(record: RecordLayout, name: str, names: Names) -> list[str]:
    """The functions that write a value and count its bytes."""
    assert record.inner_lists is not None
    lengths, sizes = [], []
    for member in members_of(record):
        field, repeat = member.field, member.field.field.repeat
        if repeat is None:
            continue
        length = list_length(member.key, repeat.high)
        lengths.append(length if field.size == 1 else f"{length} * {field.size}")
        differs = field.record is not None and field.record.size is None
        inner = names.records[field.record.record.name] if field.record is not None else ""
        sizes.append(f"({length} && elementsLength(value.{member.key}, {inner}))" if differs else lengths[-1])
    last = record.inner_lists.last
    return [
        f"function size{name}(value) {{",
        f"  return {' + '.join([str(record.inner_lists.fixed), *sizes])};",
        "}",
        f"function write{name}(value, b, o) {{",
        f"  const image = new Uint8Array({last.room + last.most});",
        f"  writeImage{name}(value, image, 0);",
        f"  b.set(sentOfImage(inner{name}, image, {lengths[-1]}), o);",
        "}",
    ]
