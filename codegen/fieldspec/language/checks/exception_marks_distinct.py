"""On links without codes, a constant in the data marks exception responses: a `field` of their record, at a fixed
offset. No other response on the link has the bytes of this number at that offset.

Why: otherwise a decoder reads an exception response as a normal response, or the reverse.

Example: `exception_response: {field: command, record: abort}` where `command` has the `const` 0x80, and a message whose
response can begin with any byte.

Fix: Give the field of the record a `const`. Give the fields of other responses at the same offset a different `const`,
an enum that is not open, or a range without this number. If responses carry a code, state `flag`, `code` or `part`
instead.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label, near
from fieldspec.language.model.device import Device
from fieldspec.language.model.digits import digits_bytes
from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.link import Link
from fieldspec.language.model.raw_numbers import orders_of
from fieldspec.language.model.record import Field, Message
from fieldspec.language.model.sizes import RecordSizes, messages_on
from fieldspec.language.model.subcodes import Place, constant_at
from fieldspec.language.model.value import Value


def exception_marks_distinct(device: Device) -> Findings:
    sizes = RecordSizes(device)
    for link in device.links.values():
        error = link.exception_response
        record = device.records.get(error.record) if error is not None else None
        if error is None or not error.field or record is None:
            continue
        if any(part.role == "code" for part in link.response):
            text = f"responses on {link.name} carry a code, so that no field of {error.record} marks exceptions"
            yield finding(link.place, "exception_response", text, "state `flag`, `code` or `part` instead")
            continue
        field = record.named(error.field)
        if field is None:
            text = f"{record.name} has no field {error.field}"
            help = near(error.field, [other.name for other in record.fields])
            yield finding(link.place, "exception_response", text, help, label(record.place, "name", record.name))
            continue
        offset = next((start for other, start in sizes.offsets(record) if other is field), None)
        constant = constant_at(field, offset, device.byte_order, device.word_order) if offset is not None else None
        if constant is None:
            text = f"{record.name}/{field.name} marks exception responses, but it is not a constant at a fixed place"
            help = "give it a whole number of up to eight bytes as `const`, with fields of fixed size before it"
            yield finding(field.place, "name", text, help, label(link.place, "exception_response", link.name))
            continue
        for message in messages_on(device, link):
            if message.is_answered_on(link.name):
                yield from _apart(device, sizes, link, message, *constant)


def _apart(device: Device, sizes: RecordSizes, link: Link, message: Message, place: Place, number: int) -> Findings:
    """Whether the bytes at an offset of the response of a message never equal a number."""
    offset, size, order = place
    mark = number.to_bytes(size, "little" if order == "little" else "big")
    first: Field | None = None
    for field, start in sizes.offsets(message.response):
        bounds = sizes.field(field)
        if bounds is not None and start + bounds[1] <= offset:
            continue
        if start >= offset + size or _is_another(device, field, start, offset, mark):
            break
        first = first or field
        if bounds is None or start + bounds[1] >= offset + size:
            text = (
                f"{message.name} may have {number:#x} in {first.name}, which marks exception responses on {link.name}"
            )
            help = "give the field another `const`, an enum that is not open, or a range without this number"
            related_label = label(link.place, "exception_response", "exception responses")
            yield finding(first.place, "name", text, help, related_label)
            break


def _is_another(device: Device, field: Field, start: int, offset: int, mark: bytes) -> bool:
    """Whether the bytes that a field at `start` shares with the mark never equal the mark's bytes."""
    value = field.value
    if value is None or not is_count(value.encoding) or value.width:
        return False
    if field.reserved or field.count is not None or field.repeat is not None:
        return False
    low, high = max(start, offset), min(start + value.size, offset + len(mark))
    marked_bytes = mark[low - offset : high - offset]
    if value.digits and any(byte not in _bytes_of_digits(value) for byte in marked_bytes):
        return True
    order, swapped = orders_of(value, device.byte_order, device.word_order)
    if value.is_as_sent:
        return False
    if swapped:
        # The words have their places exchanged, and the bytes in each keep theirs.
        places = [value.size - 2 - place + 2 * (place % 2) for place in range(low - start, high - start)]
        marked_bytes = bytes(byte for _, byte in sorted(zip(places, marked_bytes, strict=True)))
        low, high = start + min(places), start + max(places) + 1
        if high - low != len(marked_bytes):
            return False
    shift = start + value.size - high if order == "big" else low - start
    bits = int.from_bytes(marked_bytes, "big" if order == "big" else "little")
    return not any(
        _may_have(interval, value, 8 * shift, 8 * len(marked_bytes), bits) for interval in _numbers(device, value)
    )


def _bytes_of_digits(value: Value) -> bytes:
    """The bytes of which the digits of a value consist: decimal ones in two halves of a byte, or characters.

    A codec may have all bytes.
    """
    if value.codec:
        return bytes(range(256))
    if not value.has_characters:
        return bytes(16 * upper + lower for upper in range(10) for lower in range(10))
    letters = b"" if value.digits == "decimal" else b"abcdefABCDEF"
    signs = b"+-" if is_signed(value.encoding) and value.digits == "decimal" else b""
    return b"0123456789" + letters + signs + b"." * bool(value.places) + b" " * value.has_blanks


def _numbers(device: Device, value: Value) -> list[tuple[int, int]]:
    """The intervals of the numbers that a value may have in a response."""
    if value.const is not None:
        return [(value.const, value.const)]
    enum = device.enums.get(value.enum)
    if enum is not None and not enum.open:
        return [(member.value, member.value) for member in enum.members]
    return [
        *(value.ranges.intervals if value.ranges is not None else ((value.low, value.high),)),
        *value.special_intervals,
    ]


def _may_have(interval: tuple[int, int], value: Value, shift: int, width: int, bits: int) -> bool:
    """Whether a number of an interval has some bits, `width` of them above `shift`, on the wire."""
    low, high = interval
    if value.digits:
        return low != high or _bits(int.from_bytes(digits_bytes(value, low), "big"), shift, width) == bits
    if low < 0 <= high:
        return any(_may_have(part, value, shift, width, bits) for part in ((low, -1), (0, high)))
    lowest = low % (1 << 8 * value.size)
    highest = lowest + high - low
    above = lowest >> shift + width
    for upper in (above, above + 1):
        first = (upper << width | bits) << shift
        if max(first, lowest) <= min(first + (1 << shift) - 1, highest):
            return True
    return False


def _bits(number: int, shift: int, width: int) -> int:
    return number >> shift & (1 << width) - 1
