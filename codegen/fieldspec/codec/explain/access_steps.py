"""The registers of messages that access them in several steps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from fieldspec.codec.explain.spans import Span, accessed
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.values import Raw
from fieldspec.language.model.record import Message, RegisterAccess


def step_spans(
    layout: DeviceLayout,
    message: Message,
    record: RecordLayout,
    body: tuple[int, bytes],
    values: Mapping[str, Raw],
    request_values: Mapping[str, Raw] | None,
) -> Iterator[tuple[RegisterAccess, Span]]:
    """The steps of a message with the words that they access; a response has those that read.

    `body` is where the data begin in the parts of a frame, and their bytes. `request_values` are the values of the
    request that a response answers, None for a request.
    """
    start, data = body
    for step in message.access_steps:
        if request_values is not None and step.operation == "write":
            continue
        field = record.named(step.values) if (step.operation == "read") == (request_values is not None) else None
        offset, carried = 0, b""
        if field is not None:
            offset = field.offset
            carried = data[offset:] if field.end is None else data[offset : field.end]
        size = layout.device.space(step.space).unit_size
        # The request of what a response answers may have fields of the same names as the response.
        span = accessed(step, values if request_values is None else request_values, {}, start + offset, carried, size)
        if span is not None:
            yield step, span
