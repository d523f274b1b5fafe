"""`packed_bits` applies to lists with a `count` or `repeat` of whole numbers, without a sign or in two's complement,
whose type has more bits, and at most 32. They are neither constants, reserved, bit fields, digits nor parameters. A
field that measures the list counts its `items`. Numbers of less than 8 bits have a `count`, or fields after them.
Records of tables have no such list.

Why: the zeros after the last number could be a number, and a table consists of registers.

Example: `{name: samples, type: u8, packed_bits: 12, count: 8}`, as no number of 12 bits fits a `u8`.

Fix: Use the next wider type, count the elements, or remove `packed_bits`.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import layers, nested_fields
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Whole
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.value import Value

_KEY = "packed_bits"
_MOST_BITS = 32


def packed_lists_complete(device: Device) -> Findings:
    for layer in layers(device):
        for field in layer.fields:
            if _KEY not in field.place:
                continue
            problem = _problem(field) if field.value is not None else "has several types, of which none is a list"
            if problem:
                help = f"remove `{_KEY}`, or correct the type"
                yield finding(field.place, _KEY, f"{field.name} {problem}", help)
            elif field.value is not None:
                yield from _of_end(layer, field, field.value)
    for table in device.tables.values():
        record = device.records.get(table.record)
        for field in nested_fields(device, record.fields if record is not None else ()):
            if field.value is not None and field.value.packed_bits:
                text = f"{field.name} has packed numbers, but {table.name} is a table of registers"
                related_label = label(table.place, "record", "the table")
                yield finding(field.place, _KEY, text, "state them as registers with bits", related_label)


def _problem(field: Field) -> str:
    """Why the numbers of a field are not packed; empty where they may be."""
    value = field.value
    assert value is not None
    encoding = value.encoding
    if not field.is_list:
        return "is a single value, whose bits are not packed"
    if not isinstance(encoding, Whole) or encoding.sign.has_two_zeros or encoding.bits > _MOST_BITS:
        return f"is {value.type.name}, and not a whole number of at most {_MOST_BITS} bits"
    if encoding.bits <= value.packed_bits:
        return f"has {value.packed_bits} bits, and {value.type.name} has no more"
    use = _use(field, value)
    return f"{use}, which is not packed" if use else ""


def _use(field: Field, value: Value) -> str:
    """What keeps the numbers of a list from being packed."""
    uses = {
        "is a constant": value.const is not None,
        "is reserved": field.reserved,
        "has bits with names": bool(value.flags),
        "is a parameter": value.parameter is not None,
        "measures another field": field.measures is not None,
    }
    return next((use for use, applies in uses.items() if applies), "")


def _of_end(layer: Record, field: Field, value: Value) -> Findings:
    """The findings of the end of a list."""
    for other in layer.fields:
        if other.measures is not None and other.measures.field == field.name and other.measures.of == "bytes":
            text = f"{other.name} counts the bytes of {field.name}, whose numbers have {value.packed_bits} bits"
            help = f"count the elements: `measures: {{items: {field.name}}}`"
            yield finding(other.place, "measures", text, help)
    if field.repeat is not None and field is layer.fields[-1] and value.packed_bits < 8:
        text = f"the zeros after the last of {field.name} can be a number of {value.packed_bits} bits"
        yield finding(field.place, "repeat", text, "state its `count`")
