"""A list that only the end delimiter of a frame ends has a range without that delimiter.

Why: if an element is the end delimiter, receivers end the frame there: the rest of the list is lost.

Example: `{name: data, type: u8, repeat: 1..16}` as the last field, on a link with `end: "0D"`, without a length, a
checksum or an `escape`.

Fix: State the `range` of the elements, such as `range: 0x20..0x7E` for printable characters, or
`range: "0..12, 14..255"`. If the frame has a length, a checksum or an escape, add it to the link. If the device really
sends such frames, set `allow: {end_marks_apart: <reason>}` at the list.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.checks.numbers import Legal
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.link import Link
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.sizes import messages_sent


def end_marks_apart(device: Device) -> Findings:
    legal = Legal(device)
    for link in device.links.values():
        for direction in ("request", "response"):
            _, end = link.delimiters(direction)
            if not _only_end_ends(link, direction):
                continue
            for message in messages_sent(device, link, direction):
                tail = _open_list(message.request if direction == "request" else message.response)
                value = tail.value if tail is not None else None
                if tail is None or value is None or value.size > 1 or value.digits or not is_count(value.encoding):
                    continue
                if any(legal.objection(value, byte, writes=True) for byte in end):
                    continue
                mark = end.hex(" ").upper()
                text = f"{tail.name} can contain {mark}, which ends the frames of {link.name}"
                help = f"state a `range` of its elements without {mark}"
                yield finding(tail.place, "range", text, help, label(link.place, "end", "the end delimiter"))


def _only_end_ends(link: Link, direction: str) -> bool:
    """Whether only the end delimiter shows where frames of varying size end."""
    _, end = link.delimiters(direction)
    roles = {part.role for part in link.parts(direction)}
    return bool(end) and link.transmission == "binary" and link.escape is None and not roles & {"length", "checksum"}


def _open_list(record: Record) -> Field | None:
    """The last field of a message, if it is a list whose size no other field states."""
    tail = record.fields[-1] if record.fields else None
    if tail is None or tail.repeat is None or tail.repeat.low == tail.repeat.high or tail.continuation is not None:
        return None
    if any(field.measures is not None and field.measures.field == tail.name for field in record.fields):
        return None
    return tail
