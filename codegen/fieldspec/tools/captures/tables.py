"""The tables of frames and values as Arrow record batches. See docs/captures.md for the columns."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyarrow as pa

from fieldspec.tools.captures.columns import NO_TIME, Numbers, Texts
from fieldspec.tools.captures.decoding import Batch
from fieldspec.tools.captures.pairing import NONE
from fieldspec.tools.captures.verdicts import VERDICTS

TEXT = pa.dictionary(pa.int32(), pa.string())
TIME = pa.timestamp("ns", "UTC")

FRAMES = pa.schema(
    [
        ("source", TEXT),
        ("frame", pa.int64()),
        ("packet", pa.int64()),
        ("time", TIME),
        ("stream", TEXT),
        ("device", TEXT),
        ("link", TEXT),
        ("direction", TEXT),
        ("message", TEXT),
        ("exception", TEXT),
        ("unit_address", pa.int64()),
        ("space", TEXT),
        ("address", pa.int64()),
        ("count", pa.int64()),
        ("request", pa.int64()),
        ("delay", pa.int64()),
        ("verdict", TEXT),
        ("bytes", pa.binary()),
        ("data", pa.binary()),
    ]
)

VALUES = pa.schema(
    [
        ("source", TEXT),
        ("frame", pa.int64()),
        ("time", TIME),
        ("device", TEXT),
        ("unit_address", pa.int64()),
        ("operation", TEXT),
        ("space", TEXT),
        ("address", pa.int64()),
        ("register", TEXT),
        ("raw", pa.int64()),
        ("value", pa.float64()),
        ("text", TEXT),
        ("unit", TEXT),
        ("verdict", TEXT),
    ]
)

SCHEMAS = {"frames": FRAMES, "values": VALUES}
VERDICT_TEXTS = pa.array(VERDICTS)


def record_batches(batch: Batch, texts: list[str], source: str, device: str) -> dict[str, Any]:
    """A batch as record batches, by the name of the table. `texts` are the texts of the text columns."""
    words = pa.array(texts, pa.string())
    frames, values = batch.frames, batch.values
    rows, value_rows = len(frames.number), len(values.frame)
    frame_columns = [
        _same(source, rows),
        pa.array(frames.number),
        pa.array(frames.packet),
        _times(frames.time),
        _texts(frames.stream, words),
        _same(device, rows),
        _texts(frames.link, words),
        _texts(frames.direction, words),
        _texts(frames.message, words),
        _texts(frames.exception, words),
        _numbers(frames.unit_address),
        _texts(frames.space, words),
        _numbers(frames.address),
        _numbers(frames.count),
        _numbers(frames.request),
        _numbers(frames.delay),
        pa.DictionaryArray.from_arrays(pa.array(frames.verdict.astype(np.int32)), VERDICT_TEXTS),
        _binary(*frames.bytes),
        _binary(*frames.data, frames.has_data),
    ]
    own = values.values
    value_columns = [
        _same(source, value_rows),
        pa.array(frames.number[values.frame]),
        _times(frames.time[values.frame]),
        _same(device, value_rows),
        _numbers(frames.unit_address[values.frame]),
        _texts(values.operation, words),
        _texts(values.space, words),
        _numbers(values.address),
        _texts(values.register, words),
        pa.array(own.raw, mask=_mask(~own.has_raw)),
        pa.array(own.quantity, mask=_mask(~own.has_quantity)),
        _texts(own.text, words),
        _texts(values.unit, words),
        pa.DictionaryArray.from_arrays(pa.array(own.verdict.astype(np.int32)), VERDICT_TEXTS),
    ]
    return {
        "frames": pa.RecordBatch.from_arrays(frame_columns, schema=FRAMES),
        "values": pa.RecordBatch.from_arrays(value_columns, schema=VALUES),
    }


def _mask(mask: Any) -> Any:
    return mask if mask.any() else None


def _same(text: str, rows: int) -> Any:
    return pa.DictionaryArray.from_arrays(pa.array(np.zeros(rows, np.int32)), pa.array([text]))


def _times(times: Numbers) -> Any:
    return pa.array(times, mask=_mask(times == NO_TIME)).cast(TIME)


def _numbers(numbers: Numbers) -> Any:
    return pa.array(numbers, mask=_mask(numbers == NONE))


NEIGHBOURS = 4096
"""The texts between the first and the last one of a column that are written without a look at which of them it has."""


def _texts(places: Texts, words: Any) -> Any:
    """A column of texts with a dictionary of its own: writers write the whole dictionary of each column."""
    highest = int(places.max(initial=-1))
    if highest < 0:
        return pa.nulls(len(places), TEXT)
    is_absent = places < 0 if int(places.min()) < 0 else None
    lowest = int(places.min() if is_absent is None else places[~is_absent].min())
    if highest - lowest < NEIGHBOURS:
        own = pa.array((places - lowest).astype(np.int32, copy=False), mask=is_absent)
        return pa.DictionaryArray.from_arrays(own, words.slice(lowest, highest - lowest + 1))
    is_used = np.zeros(highest + 2, np.bool_)
    is_used[places] = True  # -1 is the place after the last text
    used = np.flatnonzero(is_used[:-1])
    new_places = np.cumsum(is_used, dtype=np.int32)
    own = pa.array(new_places[places] - 1, mask=is_absent)
    return pa.DictionaryArray.from_arrays(own, words.take(pa.array(used)))


def _binary(data: Any, offsets: Numbers, present: Any = None) -> Any:
    """A column of bytes over one buffer."""
    rows = len(offsets) - 1
    places = pa.py_buffer(np.ascontiguousarray(offsets.astype(np.int32)))
    valid = None if present is None else pa.array(present).buffers()[1]
    return pa.Array.from_buffers(pa.binary(), rows, [valid, places, pa.py_buffer(np.ascontiguousarray(data))])
