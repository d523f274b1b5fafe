"""A message that starts a segmented transfer names another message of the same links, and the field with a segment in
that message. The segments can be reassembled: the number of bytes follows from `last`, `unused` or `size`.

Why: programs read or write the value by these keys. With a segment too many or a byte too few, the value would be
different.

Example: `segments: {message: upload_segment, when: [segments], data: data}` without `last` and without `size`.

Fix: State the keys that the manual prints: the bit of the last segment, the number of unused bytes, the size of the
whole value. Give a `const`, a `default` or a `range` to each other field of the request.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.finding import Findings, finding, near
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_octets, is_signed
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.record import Field, Message, Record, Segments, SegmentsAbort
from fieldspec.language.model.segments import number_places
from fieldspec.language.model.sizes import sent_on
from fieldspec.language.model.value import ParameterSizes


def segments_complete(device: Device) -> Findings:
    for message in device.messages.values():
        if message.segments is not None:
            yield from _of_message(device, message, message.segments)


def _of_message(device: Device, first: Message, stated: Segments) -> Findings:
    if _part(first.request, "number") is None:
        yield _finding(
            first, f"the request of {first.name} has no number of a parameter", "add the field with the number"
        )
    elif stated.reads:
        yield from _reading(device, first, stated)
    else:
        yield from _writing(device, first, stated)
    piece = device.messages.get(stated.message)
    if piece is None or piece is first or piece.segments is not None:
        text = f"{stated.message} cannot carry the segments of this message"
        candidates = [name for name, other in device.messages.items() if other is not first and other.segments is None]
        yield _finding(first, text, near(stated.message, candidates))
        return
    for link in device.links.values():
        is_answered = first.is_answered_on(link.name) and piece.is_answered_on(link.name)
        if sent_on(link, first) and not (sent_on(link, piece) and is_answered):
            text = f"{first.name} and {piece.name} are not both sent and answered on {link.name}"
            yield _finding(first, text, "state the same `links` for both, and leave `answered_on` out")
    yield from _of_piece(device, first, stated, piece)
    if stated.abort is not None:
        yield from _of_abort(device, first, stated.abort)


def _reading(device: Device, first: Message, stated: Segments) -> Findings:
    if _part(first.request, "value") is not None:
        yield _finding(first, f"{first.name} writes a value, but `when` says that it reads", "remove `when`")
        return
    sizes = _sizes(first.response)
    enum = _enum(device, first.response, sizes)
    if sizes is None or enum is None:
        text = f"the response of {first.name} has no value in `bytes` with `sizes` to announce segments"
        yield _finding(first, text, "give it a field of `bytes` with `parameter: {part: value, sizes: ..}`")
        return
    short = {name for case in sizes.cases for name in case.when}
    for name in stated.when:
        if enum.named(name) is None:
            yield _finding(first, f"{enum.name} has no member `{name}`", near(name, [own.name for own in enum.members]))
        elif name in short:
            text = f"{name} stands for bytes in the response itself"
            yield _finding(first, text, "leave it out of `when`, or out of the cases of `sizes`")
    for name in stated.unsized:
        if name not in stated.when:
            yield _finding(first, f"{name} is not under `when`", near(name, stated.when))
    if stated.size:
        yield from _size(first, first.response, stated.size)


def _writing(device: Device, first: Message, stated: Segments) -> Findings:
    if _part(first.request, "value") is not None:
        text = f"the request of {first.name} has the value itself"
        yield _finding(
            first, text, "use a separate message for segmented values, or add `when` to a message that reads"
        )
    if stated.size:
        yield from _size(first, first.request, stated.size)
    for field in _open_fields(device, first.request, {stated.size}):
        yield _finding(first, f"{field.name} of {first.name} has no value", "give it a `const` or a `default`")


def _size(first: Message, record: Record, name: str) -> Findings:
    field = record.named(name)
    value = field.value if field is not None else None
    whole = value is not None and is_count(value.encoding) and not is_signed(value.encoding)
    short = value is not None and is_octets(value.encoding) and value.size <= 8 and record is first.response
    if field is None:
        yield _finding(
            first, f"{first.name} has no field `{name}` there", near(name, [own.name for own in record.fields])
        )
    elif not (whole or short) or field.count is not None or field.repeat is not None or field.reserved:
        yield _finding(first, f"{name} is not a number of bytes", "name a field with an unsigned whole number")


def _of_piece(device: Device, first: Message, stated: Segments, piece: Message) -> Findings:
    carrier, other = (piece.response, piece.request) if stated.reads else (piece.request, piece.response)
    data = carrier.named(stated.data)
    if data is None or data.value is None:
        names = [own.name for own in carrier.fields]
        yield _finding(first, f"{piece.name} has no field `{stated.data}` there", near(stated.data, names))
    elif not is_octets(data.value.encoding) or data.count is not None or data.repeat is not None or data.reserved:
        yield _finding(
            first, f"{stated.data} of {piece.name} is not a field of bytes", "use `type: bytes` and its `length`"
        )
    places = {}
    for key, name, records in (
        ("counter", stated.counter, (carrier, other)),
        ("unused", stated.unused, (carrier,)),
        ("last", stated.last, (carrier,)),
    ):
        if not name:
            continue
        matches = [place for record in records for place in list(number_places(device.flags, record, name))[:1]]
        if not matches:
            text = f"{piece.name} has no field or bits `{name}` there, with an unsigned number"
            yield _finding(first, text, "name a whole number, or bits of the `flags` of one")
        places[key] = matches
    last, unused = places.get("last", []), places.get("unused", [])
    if any(place.width != 1 for place in last):
        yield _finding(first, f"{stated.last} of {piece.name} is more than one bit", "name a single bit")
    if any(place.high < 1 for place in places.get("counter", [])):
        yield _finding(first, f"{stated.counter} of {piece.name} cannot count", "name bits that change")
    size = data.value.size if data is not None and data.value is not None else 0
    if any(place.low > 0 or place.high < size - 1 for place in unused):
        text = f"{stated.unused} of {piece.name} cannot say how many of {size} bytes are unused"
        yield _finding(first, text, "name a field for 0 and more")
    always = bool(stated.size) and not stated.unsized
    if not always and not (stated.last and stated.unused):
        text = f"the number of value bytes in the segments of {first.name} is unknown"
        yield _finding(first, text, "state `size` for all, or `last` and `unused`")
    decided = {stated.data, *(place.field.name for own in places.values() for place in own)}
    for field in _open_fields(device, piece.request, decided):
        yield _finding(first, f"{field.name} of {piece.name} has no value", "give it a `const` or a `default`")


def _of_abort(device: Device, first: Message, abort: SegmentsAbort) -> Findings:
    """The message that ends a transfer: it has no response, and all its values are known."""
    message = device.messages.get(abort.message)
    if message is None:
        yield _finding(first, f"there is no message `{abort.message}`", near(abort.message, device.messages))
        return
    for link in device.links.values():
        if sent_on(link, first) and (not sent_on(link, message) or message.is_answered_on(link.name)):
            text = f"{message.name} is not sent on {link.name}, or it is answered there"
            yield _finding(
                first, text, "state the same `links` for both, and `answered_on: []` for what ends a transfer"
            )
    field = message.request.named(abort.reason)
    enum = device.enums.get(field.value.enum) if field is not None and field.value is not None else None
    if enum is None:
        text = f"{message.name} has no field `{abort.reason}` with an enum"
        candidates = [field.name for field in message.request.fields if field.value is not None and field.value.enum]
        yield _finding(first, text, near(abort.reason, candidates))
    else:
        for name in (abort.counter, abort.size):
            if enum.named(name) is None:
                help = near(name, [own.name for own in enum.members])
                yield _finding(first, f"{enum.name} has no member `{name}`", help)
    repeated = {own.name for own in first.request.fields}
    for own in _open_fields(device, message.request, {abort.reason, *repeated}):
        yield _finding(first, f"{own.name} of {message.name} has no value", "give it a `const` or a `default`")


def _open_fields(device: Device, record: Record, decided: set[str]) -> Iterator[Field]:
    """The fields of a request that have no number of their own."""
    for field in record.fields:
        value = field.value
        fixed = value is not None and (value.const is not None or value.default is not None)
        is_part = value is not None and value.parameter is not None and value.parameter.part in ("number", "subindex")
        if not (field.reserved or fixed or is_part or field.name in decided):
            yield field


def _part(record: Record, part: str) -> Field | None:
    for field in record.fields:
        own = field.value.parameter if field.value is not None else None
        if own is not None and own.part == part:
            return field
    return None


def _sizes(record: Record) -> ParameterSizes | None:
    field = _part(record, "value")
    part = field.value.parameter if field is not None and field.value is not None else None
    return part.sizes if part is not None else None


def _enum(device: Device, record: Record, sizes: ParameterSizes | None) -> Enum | None:
    selector = record.named(sizes.by) if sizes is not None else None
    return device.enums.get(selector.value.enum) if selector is not None and selector.value is not None else None


def _finding(first: Message, text: str, help: str) -> Diagnostic:
    return finding(first.place, "segments", text, help)
