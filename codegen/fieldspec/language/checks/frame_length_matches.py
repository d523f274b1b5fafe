"""The printed length of a frame is the sum of its parts and data.

Why: the manual prints the length next to the data that it counts. If they differ, a field is missing or has
the wrong width, or the length belongs to another frame.

Example: `frame_length: {request: 6}` for a packet with a header of three bytes, three bytes of data and a
trailer of one byte.

Fix: Correct a field or the length, and write an erratum. Omit the length if the size of the data is not
fixed.
"""

from __future__ import annotations

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.finding import Findings, finding, interval, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import Message, Record
from fieldspec.language.model.sizes import RecordSizes, Shape, sent_on, shapes


def frame_length_matches(device: Device) -> Findings:
    sizes = RecordSizes(device)
    links = {direction: shapes(device, direction) for direction in ("request", "response")}
    for message in device.messages.values():
        for direction, printed, data in (
            ("request", message.request_length, message.request),
            ("response", message.response_length, message.response),
        ):
            if printed is not None:
                own = [shape for shape in links[direction] if sent_on(shape.link, message)]
                yield from _compare_lengths(message, direction, printed, data, own, sizes)


def _compare_lengths(
    message: Message, direction: str, printed: int, data: Record, links: list[Shape], sizes: RecordSizes
) -> Findings:
    bounds = sizes.bounds(data)
    if bounds is None or not links:
        return
    lengths = [(link.length(bounds[0]), link.length(bounds[1])) for link in links]
    if bounds[0] == bounds[1] and any(printed == minimum for minimum, _ in lengths):
        return
    actual = " or ".join(sorted({interval(*pair) for pair in lengths}))
    yield finding(
        message.place,
        "frame_length",
        f"the {direction} of {message.name} is printed with {plural(printed, 'byte')}, but it has {actual}",
        "correct a field or the length; omit the length if the size is not fixed",
        label(message.place, direction, "the data"),
    )
