"""The field that decides a choice comes before it in its record and is a single unsigned number with an enum; each
member of that enum is in at most one case. If `bits` decide, the number has at most four bytes, and its `flags` have an
enum in exactly these bits. A choice with several elements ends the data of a message or of an exception response, and
all fields before it have a fixed size; only bits of a byte decide it. A field that measures any other choice is the
first before it that counts its bytes, as a binary number of one or two bytes or as digits, without a `range`. A case of
`bytes` may have none, unless the choice has several elements or no other case. No choice contains a parameter, and no
table contains a choice.

Why: a decoder reads the deciding field first and then knows the layout of the rest. It rejects members
without a case, because the data that follow them are unknown. Only the end of the data ends the elements of a choice.

Example: `choice: {by: format, cases: [...]}` where two cases have `when: [unsigned16]`, or where the field
`format` comes after the values.

Fix: List the fields in the order of the wire, name a deciding field with an enum, or remove the member from
one of the cases.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import fields, layers, nested_fields
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.counts import COUNTING, choice_count
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Whole, is_count, is_octets, is_signed
from fieldspec.language.model.record import Case, Choice, Field, Record
from fieldspec.language.model.sizes import RecordSizes
from fieldspec.language.model.value import Value

_MOST_BYTES = 4


def choices_complete(device: Device) -> Findings:
    sizes = RecordSizes(device)
    part_names = {field.record for field in fields(device)}
    for layer in layers(device):
        is_part = device.records.get(layer.name) is layer and layer.name in part_names
        for field in layer.fields:
            if field.choice is not None:
                yield from _check_place(sizes, layer, field, is_part)
                yield from _decided(device, layer, field, field.choice)
                yield from _apart(field.choice)
                yield from _empty(field, field.choice)
    for table in device.tables.values():
        record = device.records.get(table.record)
        parts = nested_fields(device, record.fields) if record is not None else iter(())
        own = next((field for field in parts if field.choice is not None), None)
        if own is not None:
            text = f"{own.name} has a choice, so it cannot be part of {table.name}"
            help = "move the choice to the data of a message"
            yield finding(table.place, "record", text, help, label(own.place, "name", own.name))


def _check_place(sizes: RecordSizes, layer: Record, field: Field, is_part: bool) -> Findings:
    other_fields = [other for other in layer.fields if other is not field]
    varying = next((other for other in other_fields if not sizes.is_fixed(other)), None)
    has_bits = field.choice is not None and field.choice.bits is not None
    if field.count is not None:
        text = f"{field.name} has a choice and a `count`"
        yield finding(field.place, "count", text, "use `repeat` to the end of the data, or remove `count`")
    elif field.repeat is not None and has_bits and not _is_byte(layer, field):
        text = f"some bits decide the type of {field.name}, which has several elements, and are not in one byte"
        yield finding(field.place, "repeat", text, "state the choice in a record, and `repeat` that")
    elif field.repeat is not None and (is_part or varying is not None or field is not layer.fields[-1]):
        text = f"{field.name} has a choice and several elements, so only the end of the data determines where they end"
        help = "list it last in a message in which all else has a fixed size, or remove `repeat`"
        labels = [label(varying.place, "name", "has no fixed size")] if varying is not None else []
        yield finding(field.place, "repeat", text, help, *labels)
    has_widths = field.choice is not None and field.choice.has_widths
    is_moved = has_widths or (has_bits and not field.is_list)
    if field is layer.fields[-1] and not is_part and varying is None and not is_moved:
        return
    for other in other_fields:
        if other.measures is None or other.measures.field != field.name or choice_count(layer, field) is other:
            continue
        text = f"{other.name} measures {field.name}, whose size {field.choice.by if field.choice else ''} decides"
        text += f", and is not the first before it to count its bytes without a `range`, as {COUNTING}"
        yield finding(other.place, "measures", text, "state it so, or remove `measures`")
    for case in field.choice.cases if field.choice is not None else ():
        if case.value.parameter is not None:
            text = f"{case.name} carries a part of a parameter, and {field.name} does not end a message alone"
            yield finding(case.place, "parameter", text, "list it last, after fields of fixed size")


def _empty(field: Field, choice: Choice) -> Findings:
    """The finding of a case without data that is not one of `bytes`, or in a list or a choice of nothing else."""
    empty = [case for case in choice.cases if not case.value.size]
    for case in empty:
        if not is_octets(case.value.encoding):
            text = f"{case.name} is a {case.value.type.name} of no bytes"
            yield finding(case.place, "length", text, "state it as `type: bytes, length: 0`")
    if empty and field.repeat is not None:
        text = f"{field.name} has several elements, and none of them is seen where {empty[0].name} has no bytes"
        yield finding(empty[0].place, "length", text, "leave the case out, or state the choice in a record")
    elif empty and len(empty) == len(choice.cases):
        text = f"{field.name} never has a byte"
        yield finding(empty[0].place, "length", text, "leave the field out")


def _is_byte(layer: Record, field: Field) -> bool:
    """Whether the field that decides another one has one byte, or is not there."""
    selector = layer.named(field.choice.by) if field.choice is not None else None
    return selector is None or selector.value is None or selector.value.size == 1


def _decided(device: Device, layer: Record, field: Field, choice: Choice) -> Findings:
    names = [other.name for other in layer.fields]
    selector = layer.named(choice.by)
    if selector is None:
        return
    if names.index(selector.name) >= names.index(field.name):
        text = f"{selector.name} decides {field.name}, but does not come before it"
        help = "list the fields in the order of the wire"
        yield finding(field.place, "choice", text, help, label(selector.place, "name", selector.name))
    objection = _objection(device, selector, choice)
    if objection:
        text = f"{selector.name} cannot decide {field.name}: {objection}"
        help = "name one unsigned number that has an enum"
        if choice.bits is not None:
            help = "name one unsigned number whose `flags` have an enum in these bits"
        yield finding(field.place, "choice", text, help, label(selector.place, "name", selector.name))


def _objection(device: Device, selector: Field, choice: Choice) -> str:
    """The reason why a field cannot decide another one, or an empty text."""
    value = selector.value
    if value is None or selector.count is not None or selector.repeat is not None:
        return "it is not a single value"
    if not is_count(value.encoding) or is_signed(value.encoding):
        return f"it is {value.type.name}"
    if choice.bits is not None and (value.size > _MOST_BYTES or not isinstance(value.encoding, Whole)):
        return f"it is {value.type.name}"
    if not choice.enum_of(selector, device.flags):
        return "it has no enum" if choice.bits is None else f"{choice.subject} have no enum"
    return "its word order differs from its byte order" if _mixed(device, value) else ""


def _mixed(device: Device, value: Value) -> bool:
    words = device.word_order
    return value.size > 2 and bool(words) and words != (value.byte_order or device.byte_order)


def _apart(choice: Choice) -> Findings:
    first: dict[str, Case] = {}
    for case in choice.cases:
        for member in case.when:
            if member in first:
                other = first[member]
                text = f"`{member}` is in the case {case.name} and in {other.name}"
                related_label = label(other.place, "when", other.name)
                yield finding(case.place, "when", text, "remove it from one of them", related_label)
            first[member] = case
