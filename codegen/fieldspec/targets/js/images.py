"""Records that are written through an image: those with fields after lists, and those whose values vary in width."""

from __future__ import annotations

import json

from fieldspec.codec.layout.inner_list_data import inner_lists_data
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.widths import span_data
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.members import members_of
from fieldspec.targets.js.text import function, literal, object_of


def list_length(key: str, highest_count: int) -> str:
    """The elements of a list whose bytes are counted before it is checked: `listLength(value, "values", 59)`"""
    return f"listLength(value, {literal(key)}, {highest_count})"


def list_table(record: RecordLayout, name: str) -> list[str]:
    """Where the lists of a record with fields after them are; nothing for others."""
    if record.inner_lists is None:
        return []
    data = inner_lists_data(record.inner_lists)
    rows = (object_of({key: json.dumps(value) for key, value in row.items()}) for row in data["lists"])
    lists = ["  lists: [", *(f"    {row}," for row in rows), "  ],"]
    return [f"const inner{name} = {{", f"  fixed: {record.inner_lists.fixed},", *lists, "};"]


def _decided_size(record: RecordLayout, field: FieldLayout, selector: FieldLayout) -> str:
    """The bytes of a field whose type a selector decides: the bytes of the longest type if it decides none."""
    key = next(member.key for member in members_of(record) if member.field.name == selector.name)
    if not key:
        assert selector.value is not None
        form = field.form_of(selector.value.const)
        return str(field.size if form is None else form.size)
    rows = ", ".join(f"{number}: {form.size}" for number, form in sorted(field.forms.items()))
    number = f"value.{key}" if field.deciding_bits is None else f"(value.{key} & {field.deciding_bits}) >>> 0"
    return f"({{ __proto__: null, {rows} }}[{number}] ?? {field.size})"


def write_lists(record: RecordLayout, name: str, names: Names) -> list[str]:
    """The functions that write a value with fields after lists and count its bytes."""
    assert record.inner_lists is not None
    lengths, sizes = [], []
    for member in members_of(record):
        field, repeat = member.field, member.field.field.repeat
        if not field.varies:
            continue
        items = list_length(member.key, repeat.high) if repeat is not None else str(field.count)
        lengths.append(items if field.size == 1 else f"{items} * {field.size}")
        if field.selector is not None:
            sizes.append(_decided_size(record, field, field.selector))
            continue
        if field.packing is not None:
            bits = field.packing.number.bits
            sizes.append(f"Math.ceil({items} * {bits} / 8)" if repeat is not None else str(field.sent_bounds[0]))
            continue
        if field.record is None or field.record.size is not None:
            sizes.append(lengths[-1])
            continue
        elements = f"value.{member.key}" if field.is_list else f"[value.{member.key}]"
        size = f"elementsLength({elements}, {names.records[field.record.record.name]})"
        sizes.append(f"({items} && {size})" if repeat is not None else size)
    last = record.inner_lists.last
    size = " + ".join([str(record.inner_lists.fixed), *sizes])
    if any(own.in_room or any(form.varies for form in own.forms.values()) for own in record.fields):
        size = f"sent{name}(value).length"
    sent_bytes = f"sentOfImage(inner{name}, image, {lengths[-1]})"
    return _image_writer(name, last.room + last.most, sent_bytes, size)


def width_table(record: RecordLayout, name: str) -> list[str]:
    """The fields of a record whose values vary in width; nothing for others."""
    rows = (
        f"  {object_of({key: json.dumps(value) for key, value in span_data(span).items()})}," for span in record.spans
    )
    return [f"const widths{name} = [", *rows, "];"] if record.spans else []


def write_widths(record: RecordLayout, name: str) -> list[str]:
    """The functions that write a value of varying width and count its bytes."""
    sent_bytes = f"narrowedImage(widths{name}, image)"
    return _image_writer(name, sum(span.size for span in record.spans), sent_bytes, f"sent{name}(value).length")


def _image_writer(name: str, image_size: int, sent_bytes: str, size: str) -> list[str]:
    """The functions that write a value by the bytes `sent_bytes` of its image, and count them."""
    image = [f"const image = new Uint8Array({image_size});", f"writeImage{name}(value, image, 0);"]
    return [
        *function(f"sent{name}", "value", [*image, f"return {sent_bytes};"]),
        *function(f"size{name}", "value", [f"return {size};"]),
        *function(f"write{name}", "value, b, o", [f"b.set(sent{name}(value), o);"]),
    ]
