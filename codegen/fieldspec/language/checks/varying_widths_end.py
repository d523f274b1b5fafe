"""A value that varies in width is a text, or a number of decimal or hexadecimal digits. It is a field of a message, and
ends with the message or before a constant of one byte that it cannot have. One field before a text can contain the
text's number of bytes: an unsigned whole number of one or two bytes, or of a fixed number of digits, whose range
includes every length of the text, or some bits. A message with a value that no field measures has no list of free
length, no record of varying size, no choice, and no number of bytes in some bits. Measured texts can also be fields of
a record within messages and other records, and counted texts and `bytes` cases of a choice.

Why: the constant after such a value marks its end. If the value could contain that constant, the next value would be
read as a part of it.

Example: `{name: weight, type: u32, digits: decimal, length: 8, varies: true}` before a `u16`.

Fix: State the separator as a constant, `{name: comma, type: u8, const: 0x2C}`, or once as the `separator` of all
fields; `{name: end, type: u8, const: 0}` for a zero after a text; or its number of bytes before it, `{name: length,
type: u8, measures: {bytes: label}}`. Remove `varies` if the manual prints a fixed number of characters.
"""

from __future__ import annotations

import string

from fieldspec.language.checks.facts import layers, values
from fieldspec.language.checks.finding import Findings, finding, label, range_key
from fieldspec.language.model.counts import COUNTING, can_count, choice_count, text_count
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_letters, digits_text, has_sign
from fieldspec.language.model.encoding import is_array, is_signed, is_text
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import merged
from fieldspec.language.model.record import Case, Field, Message, Record
from fieldspec.language.model.sizes import RecordSizes
from fieldspec.language.model.text_form import PACKED_ASCII, UTF_16
from fieldspec.language.model.value import Value


def varying_widths_end(device: Device) -> Findings:
    messages = {id(field) for message in device.messages.values() for body in _bodies(message) for field in body.fields}
    sizes = RecordSizes(device)
    refusing = {link.exception_response.record for link in device.links.values() if link.exception_response is not None}
    counting = [record for name, record in device.records.items() if sizes.tells_size(name) and name not in refusing]
    parts = {id(field) for record in counting for field in record.fields}
    cases = {
        id(case)
        for layer in layers(device)
        for field in layer.fields
        if field.choice is not None and choice_count(layer, field) is not None
        for case in field.choice.cases
        if is_array(case.value.encoding)
    }
    unfit_sizes = {
        id(layer.named(field.measures.field))
        for layer in layers(device)
        for field in layer.fields
        if field.measures is not None and field.value is not None and not can_count(field.value)
    }
    for fact, value in values(device):
        if not value.width:
            continue
        unused = [key for key in ("padding", "align") if key in fact.place and is_text(value.encoding)]
        for key in unused:
            yield finding(fact.place, key, f"`{key}` has no effect in a text that varies", f"remove `{key}`")
        if unused:
            continue
        is_in_place = id(fact) in messages or id(fact) in parts or id(fact) in cases
        is_case = id(fact) in cases
        problem = "" if is_case and value.is_marked else _form(value) or ("" if is_case else _place(fact, is_in_place))
        if problem:
            cure = _other_sizes(fact) if id(fact) in unfit_sizes else _cure(fact, value, is_in_place)
            yield finding(fact.place, "varies", f"{fact.name} {problem}", cure)
    for message in device.messages.values():
        for body in _bodies(message):
            yield from _of_message(sizes, message, body)
    for record in counting:
        yield from _of_record(record)


def _bodies(message: Message) -> tuple[Record, Record]:
    return message.request, message.response


def _form(value: Value) -> str:
    """The reason why a value cannot vary in width; empty where it can."""
    if is_text(value.encoding):
        form = value.text_form
        if form is not None and (
            form.encoding in (UTF_16, PACKED_ASCII)
            or form.is_right
            or form.padding
            or form.terminator is not None
            or form.is_turned
        ):
            return "varies in width, and has no UTF-16, packed ASCII, byte order, padding or terminator of its own"
        return ""
    if not value.has_characters:
        return "varies in width, which only characters and counted `bytes` of a choice do"
    if is_signed(value.encoding) and not has_sign(value):
        return "is a signed hexadecimal number, whose sign is in its first digit"
    return ""


def _cure(fact: Fact, value: Value, is_in_place: bool) -> str:
    """What to write for a value of one width; `is_in_place` says that it could vary where it stands."""
    form = value.text_form
    if (is_text(value.encoding) and not is_in_place) or (isinstance(fact, Case) and value.is_marked):
        return "remove it; or put a `u8` or `u16` before it that `measures` its bytes, and the record in a message"
    if not is_text(value.encoding) and not value.has_characters:
        is_list = is_array(value.encoding) and isinstance(fact, Field)
        return f"state a list of them: `type: u8, repeat: 0..{value.size}`" if is_list else "remove it"
    if is_signed(value.encoding) and not has_sign(value):
        unsigned = f"use `u{8 * value.type.size}`, a number that the program converts"
        return f"{unsigned}; or remove it, and state the usual length"
    if not is_in_place and not is_text(value.encoding) and isinstance(fact, Field):
        return f"remove it, and state the usual length; or state its characters: `type: u8, repeat: 1..{value.size}`"
    if form is None or form.terminator is None or form.encoding == UTF_16 or form.is_right or form.padding:
        return "remove it, and state the usual length"
    end = f"{{name: end, type: u8, const: 0x{form.terminator:02X}}}"
    return f"remove `terminator`, and state it as the next field: `{end}`; or remove `varies`"


def _place(fact: Fact, is_in_message: bool) -> str:
    """Why a fact has one width because of where it stands; empty for a field of a message."""
    if not isinstance(fact, Field) or not is_in_message:
        return "is neither a field of a message nor a text that an earlier field counts"
    if fact.count is not None or fact.repeat is not None:
        return "is a list, whose elements have the same width"
    return "is reserved, and has the same width everywhere" if fact.reserved else ""


def _of_message(sizes: RecordSizes, message: Message, body: Record) -> Findings:
    """The findings of the fields around those that vary in width."""
    varying = [field for field in body.fields if field.value is not None and field.value.width]
    if not varying:
        return
    endless = next((field for field in varying if text_count(body, field) is None), None)
    for field in body.fields:
        measure = field.stated_measure
        other = body.named(measure.field) if measure is not None else None
        key, objection = _beside(sizes, field) if endless is not None else ("", "")
        if objection and endless is not None:
            text = f"{field.name} has {objection}, and {endless.name} varies in width"
            yield finding(field.place, key, text, "state one of them in a message of its own")
        elif field.measures is not None and other in varying and other is not None:
            yield from _of_count(body, field, other)
    if message.accesses:
        text = f"{message.name} reads or writes registers, and {varying[0].name} varies in width"
        yield finding(varying[0].place, "varies", text, "remove it, and state the usual length")
    for field in varying:
        yield from _end(body, field)


def _beside(sizes: RecordSizes, field: Field) -> tuple[str, str]:
    """Why a field has no place beside a value whose end only the bytes after it show, after the key that says so."""
    if field.repeat is not None:
        return "repeat", "a list of free length"
    if field.value is not None and field.value.packed_bits:
        return "packed_bits", "packed numbers"
    if field.choice is not None:
        return "choice", "several types"
    if field.record and not sizes.is_fixed(field):
        return "record", "no fixed size"
    return ("measures", "a number of bytes in its bits") if field.bit_measure is not None else ("", "")


def _of_record(record: Record) -> Findings:
    """The findings of a record whose texts are counted; none for others."""
    texts = [field for field in record.fields if field.value is not None and field.value.width]
    for text in texts:
        for field in record.fields:
            if field.measures is not None and field.measures.field == text.name:
                yield from _of_count(record, field, text)


def _of_count(body: Record, field: Field, text: Field) -> Findings:
    """The finding of a field that measures a value that varies in width, unless it may count the bytes of that text."""
    count, value, measure = text_count(body, text), field.value, field.measures
    assert measure is not None
    if value is not None and value.digits and not can_count(value):
        message = f"{field.name} is {digits_text(value)}, which do not say where {text.name} ends"
        yield finding(field.place, "measures", message, _other_sizes(text))
        return
    if text.value is None or not is_text(text.value.encoding):
        message = f"{field.name} measures {text.name}, which varies in width and is not a text"
        yield finding(field.place, "measures", message, "let a `length` in the frame count the message")
        return
    if count is not field or value is None:
        message = f"{field.name} cannot count the bytes of {text.name}, which varies in width"
        if count is not None and count is not field:
            yield finding(field.place, "measures", message, f"remove it: {count.name} counts them")
            return
        form = f"{{name: {field.name}, type: u8, measures: {{bytes: {text.name}}}}}"
        help = f"state one field before the text, a whole number without a meaning of its own: `{form}`"
        yield finding(field.place, "measures", message, help)
        return
    low, high = measure.plus, text.value.width + measure.plus
    related_label = label(text.place, "length", "the most bytes of the text")
    if value.ranges is not None and merged(value.ranges.intervals) != [(low, high)]:
        message = f"{field.name} has the range {value.ranges.text()}, but {text.name} makes it {low}..{high}"
        help = "remove the range, or correct the `length` of the text"
        yield finding(field.place, range_key(field.place), message, help, related_label)


def _other_sizes(fact: Fact) -> str:
    """What to write for a text whose size is a number that is not read before its end is known."""
    size = fact.value.size if isinstance(fact, Field) and fact.value is not None else 0
    list_form = f"`type: u8, repeat: 0..{size}`"
    size_help = f"let the size be {COUNTING}, if that is how it is sent"
    return f"state its characters as the last field of a message, {list_form}; or {size_help}"


def _end(body: Record, field: Field) -> Findings:
    """The finding of a value without a visible end."""
    index = body.fields.index(field)
    if index + 1 == len(body.fields) or text_count(body, field) is not None:
        return
    following, value = body.fields[index + 1], field.value
    end = following.value
    assert value is not None
    if end is None or end.const is None or end.type.name != "u8" or end.digits or following.count is not None:
        text = f"{field.name} varies in width, and {following.name} is not a constant of one byte"
        help = "state what separates them: `{name: comma, type: u8, const: 0x2C}`"
        yield finding(field.place, "varies", text, help)
    elif end.const in _own_bytes(value):
        text = f"{field.name} may have the byte 0x{end.const:02X}, which would end it"
        yield finding(following.place, "const", text, "correct the separator")


def _own_bytes(value: Value) -> bytes:
    """The bytes that a value may have, and that cannot end it: for a text letters, digits and what is not ASCII.

    No text has a zero in it, so that one may end it.
    """
    if not value.digits:
        return bytes(range(0x80, 0x100)) + (string.ascii_letters + string.digits).encode()
    return digits_letters(value) + (b"+-" if has_sign(value) else b"") + (b"." if value.places else b"")
