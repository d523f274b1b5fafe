"""Frames decoded in bulk as rows of Python, and the same rows from the explainer, which reads one frame at a time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from fieldspec.codec.explain.explanation import Explanation
from fieldspec.codec.explain.row import ExplanationRow
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.tools.captures.decoding import Batch, Choices, DeviceDecoder, SourceDecoder
from fieldspec.tools.captures.payloads import DIRECTION_CODES, Names, payloads_of
from fieldspec.tools.captures.verdicts import VERDICTS


class Value(NamedTuple):
    """A row of the table of values, without what the frame has."""

    frame: int
    register: str
    operation: str
    address: int | None
    raw: int | None
    quantity: float | None
    text: str | None
    verdict: str


class Sent(NamedTuple):
    """A frame on a line: its direction, empty where nothing tells it."""

    stream: int
    direction: str
    data: bytes


def decoded(
    layout: DeviceLayout, frames: Sequence[Sent], choices: Choices, is_datagram: bool = True
) -> list[tuple[DeviceDecoder, Batch]]:
    """The batches of some payloads."""
    device = DeviceDecoder(layout, choices)
    source = SourceDecoder(device, Names([f"line {stream}" for stream in range(1 + max(f.stream for f in frames))]))
    rows = [
        (sent.data, 1000 * number, number + 1, sent.stream, DIRECTION_CODES[sent.direction])
        for number, sent in enumerate(frames)
    ]
    return [(device, batch) for batch in [*source.decode(payloads_of(rows, is_datagram)), *source.rest()]]


def verdicts(batches: Sequence[tuple[DeviceDecoder, Batch]]) -> list[str]:
    """The verdict on each frame."""
    return [VERDICTS[number] for _, batch in batches for number in batch.frames.verdict.tolist()]


def values(batches: Sequence[tuple[DeviceDecoder, Batch]]) -> list[Value]:
    """All values of batches."""
    return [
        _value(device.texts.texts, batch, row) for device, batch in batches for row in range(len(batch.values.frame))
    ]


def _value(texts: Sequence[str], batch: Batch, row: int) -> Value:
    table, own = batch.values, batch.values.values
    return Value(
        int(batch.frames.number[table.frame[row]]),
        texts[table.register[row]],
        texts[table.operation[row]] if table.operation[row] >= 0 else "",
        int(table.address[row]) if table.address[row] >= 0 else None,
        int(own.raw[row]) if own.has_raw[row] else None,
        float(own.quantity[row]) if own.has_quantity[row] else None,
        texts[own.text[row]] if own.text[row] >= 0 else None,
        VERDICTS[own.verdict[row]],
    )


def expected(explanation: Explanation, layout: DeviceLayout) -> list[tuple[str, int | None, str]]:
    """The path, the raw value and the reason of each value of a frame, as the explainer has them."""
    message = layout.messages.get(explanation.message)
    access = message.message.single_access if message else None
    if access is not None and not explanation.error:
        is_echo = access.operation == "write" and explanation.direction == "response"
        rows = () if is_echo else tuple(row for row in explanation.registers if row.raw)
        return [item for row in rows for item in _register(row)]
    own = "exception" if explanation.error else explanation.message
    return [
        (f"{own}.{row.path}", _raw(_codec_value(explanation.values, row.path)), row.reason)
        for row in explanation.rows
        if row.kind == "field" and row.number is not None
    ]


def _register(row: ExplanationRow) -> list[tuple[str, int | None, str]]:
    if row.fact:
        return [(row.path, _raw(row.number), row.reason)]
    if row.unit == "bit":
        return []
    words = np.frombuffer(row.raw, ">u2").tolist()
    assert row.address is not None
    return [(f"0x{row.address + number:04X}", word, "") for number, word in enumerate(words)]


def _codec_value(values: object, path: str) -> object:
    """The value in a frame at a path, such as `items[0].size`, as codecs have it."""
    for name in path.replace("[", ".[").split("."):
        if name.startswith("["):
            assert isinstance(values, list)
            values = values[int(name[1:-1])]
        else:
            assert isinstance(values, dict)
            values = values[name]
    return values


def _raw(number: object) -> int | None:
    if isinstance(number, bool):
        return int(number)
    return number if isinstance(number, int) and -(2**63) <= number < 2**63 else None
