"""The field that says by its bits whether another one is sent, or how many elements it has, comes before it in its
record. It is one unsigned binary number of at most four bytes that programs set: not a constant, reserved, optional,
computed or a parameter. It has the bits, or the enum with the members. At most 16 bits count a list with `repeat`, or
the bytes of a text with `varies`. The field with them has no `range`, scale, enum or special values. The number that
says whether another element follows is such a number, too; in a record, only fields of fixed size come before it.
Some numbers say so, and others not. Nothing else measures such fields. The data of exception responses, and of
messages that access registers, have none.

Why: a decoder reads the deciding number first, and then knows how many bytes follow.

Example: `present_if: {by: flags, bit: 9}` for a field `flags` of the type `u8`.

Fix: List the fields in the order of the wire, name a deciding field that has the bit or the enum, or state a message
for each case.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import replace
from fieldspec.language.checks.facts import layers, nested_fields
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import Whole, is_signed
from fieldspec.language.model.raw_numbers import orders_of
from fieldspec.language.model.record import Field, Measure, Presence, Record
from fieldspec.language.model.sizes import RecordSizes
from fieldspec.language.model.stated_bits import legal_numbers
from fieldspec.language.model.value import Value

_KEY, _MORE = "present_if", "more_if"
_MOST_BYTES = 4
_MOST_BITS = 16


def presences_complete(device: Device) -> Findings:
    refusing = {link.exception_response.record for link in device.links.values() if link.exception_response is not None}
    sizes = RecordSizes(device)
    for layer in layers(device):
        for field in layer.fields:
            if field.presence is not None and layer.name in refusing and device.records.get(layer.name) is layer:
                text = f"{layer.name} is the data of exceptions, and {field.name} is optional"
                yield finding(field.place, _KEY, text, "remove `present_if`, or leave the field out")
            if field.presence is not None:
                yield from _decided(device, layer, field, field.presence)
            if field.presence is not None or field.continuation is not None:
                yield from _measured(layer, field)
            if field.continuation is not None:
                is_refusing = layer.name in refusing and device.records.get(layer.name) is layer
                for problem, help in _end_problems(device, sizes, layer, field, field.continuation, is_refusing):
                    text = f"the elements of {field.name} say whether more follow, {problem}"
                    yield finding(field.place, _MORE, text, help)
            measured = layer.named(field.bit_measure.field) if field.bit_measure is not None else None
            if field.bit_measure is not None and measured is not None:
                is_refusing = layer.name in refusing and device.records.get(layer.name) is layer
                for problem, help in _count_problems(
                    device, sizes, layer, field, field.bit_measure, measured, is_refusing
                ):
                    text = f"some bits of {field.name} count {measured.name}, {problem}"
                    yield finding(field.place, "measures", text, help, label(measured.place, "name", measured.name))
    for message in device.messages.values():
        bodies = (message.request, message.response) if message.accesses else ()
        optional = next(
            (own for body in bodies for own in nested_fields(device, body.fields) if _stated_key(own)), None
        )
        if optional is not None:
            key = _stated_key(optional)
            text = f"{message.name} reads or writes registers, and {optional.name} {_PROBLEMS[key]}"
            help = "remove `accesses`, or state a message for each case"
            yield finding(message.place, "accesses", text, help, label(optional.place, key, optional.name))


_PROBLEMS = {_KEY: "is optional", _MORE: "ends where an element says so", "measures": "counts a list in its bits"}


def _stated_key(field: Field) -> str:
    """The key of a field by which bits decide on elements; empty where none do."""
    is_stated = {_KEY: field.presence, _MORE: field.continuation, "measures": field.bit_measure}
    return next((key for key, own in is_stated.items() if own is not None), "")


def _decided(device: Device, layer: Record, field: Field, presence: Presence) -> Findings:
    """The findings of the field that decides on another one."""
    names = [other.name for other in layer.fields]
    decider = layer.named(presence.by)
    if decider is None:
        return
    if names.index(decider.name) >= names.index(field.name):
        text = f"{decider.name} decides whether {field.name} is sent, but does not come before it"
        help = "list the fields in the order of the wire"
        yield finding(field.place, _KEY, text, help, label(decider.place, "name", decider.name))
    objection = _objection(device, decider, presence.bits)
    if objection:
        text = f"{decider.name} cannot decide whether {field.name} is sent: {objection}"
        help = "name one unsigned number with the bit or the enum"
        yield finding(field.place, _KEY, text, help, label(decider.place, "name", decider.name))


def _count_problems(
    device: Device, sizes: RecordSizes, layer: Record, field: Field, measure: Measure, measured: Field, refuses: bool
) -> Iterator[tuple[str, str]]:
    """The problems of a field that counts another one in its bits, each with a help."""
    assert measure.bits is not None
    low, high = measure.bits
    if layer.fields.index(field) >= layer.fields.index(measured):
        yield "but it does not come before it", "list the fields in the order of the wire"
    value = field.value
    objection = _objection(device, field, (measure.bits,))
    has_meaning = value is not None and (value.enum or value.scaled or value.sentinels or value.ranges)
    if objection or has_meaning:
        yield f"but {objection or 'it is a number with a meaning of its own'}", "name bits of one unsigned number"
    if high - low >= _MOST_BITS:
        yield f"in {high - low + 1} bits", f"a count has at most {_MOST_BITS} bits"
    is_text = measured.value is not None and measured.value.width > 0 and measure.of == "bytes"
    has_no_number = measured.repeat is None or measured.choice is not None or _stated_key(measured) in (_KEY, _MORE)
    if has_no_number and not is_text:
        varies = measured.value is not None and measured.value.width > 0
        help = "state the `repeat` of a list that is always sent, of one type"
        yield "which has no number of elements", f"count its `bytes: {measured.name}`" if varies else help
    is_packed = measured.value is not None and measured.value.packed_bits > 0
    if measure.of == "bytes" and not is_text and (is_packed or sizes.element(measured) is None):
        yield "whose elements have no bytes of one number", f"count the elements: `items: {measured.name}`"
    measures = [other.stated_measure for other in layer.fields if other.stated_measure is not None]
    if any(own is not measure and own.field == measured.name for own in measures):
        yield "which another field measures as well", "remove one of them"
    if refuses:
        yield f"and {layer.name} is the data of exceptions", "state a fixed `count`, or list the repeated field last"


def _end_problems(
    device: Device, sizes: RecordSizes, layer: Record, field: Field, continuation: Presence, refuses: bool
) -> Iterator[tuple[str, str]]:
    """The problems of a list whose elements say whether another one follows, each with a help."""
    element = device.records.get(field.record)
    decider = element.named(continuation.by) if element is not None else replace(field, repeat=None)
    if decider is None:
        return
    objection = _objection(device, decider, continuation.bits)
    if objection:
        yield f"but {decider.name} cannot: {objection}", "name one unsigned number with the bit or the enum"
    elif decider.value is not None and _always_says_the_same(device, decider.value, continuation):
        yield f"but {decider.name} always says the same", "name a bit that differs, or other members"
    before = element.fields[: element.fields.index(decider)] if element is not None else ()
    varying = next((own for own in before if not sizes.is_fixed(own)), None)
    if varying is not None:
        yield f"but {varying.name} before {decider.name} has no fixed size", "name a field before it"
    if refuses:
        yield f"and {layer.name} is the data of exceptions", "state a fixed `count`, or list the repeated field last"


def _always_says_the_same(device: Device, value: Value, continuation: Presence) -> bool:
    """Whether all numbers of a value say that another element follows, or none does."""
    enum = device.enums.get(value.enum)
    is_known = enum is None or all(enum.named(name) is not None for name in continuation.when)
    return is_known and None in legal_numbers(continuation, value, device.enums)


def _objection(device: Device, decider: Field, bits: tuple[tuple[int, int], ...]) -> str:
    """The reason why a field cannot decide another one, by bits or its enum; or an empty text."""
    value = decider.value
    if value is None or decider.is_list:
        return "it is not a single value"
    if value.digits:
        return "it is sent as digits, which have no bits"
    if not isinstance(value.encoding, Whole) or is_signed(value.encoding) or value.size > _MOST_BYTES:
        return f"it is {value.type.name}"
    if decider.reserved or value.const is not None or decider.measures is not None or value.parameter is not None:
        return "programs do not set it"
    highest = max((last for _, last in bits), default=0)
    if highest >= 8 * value.size:
        return f"it has no bit {highest}"
    if not bits and not value.enum:
        return "it has no enum"
    is_swapped = orders_of(value, device.byte_order, device.word_order)[1]
    return "its word order differs from its byte order" if is_swapped else ""


def _measured(layer: Record, field: Field) -> Findings:
    """The findings of fields that measure an optional one, or a list whose elements say which is the last."""
    key = _stated_key(field)
    for other in layer.fields:
        if other.measures is not None and other.measures.field == field.name:
            text = f"{other.name} measures {field.name}, which {_PROBLEMS[key]}"
            help = f"remove `measures`, or `{key}`: the number of bytes or elements says it already"
            yield finding(other.place, "measures", text, help)
