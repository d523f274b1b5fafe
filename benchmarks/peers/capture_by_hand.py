"""A capture of Modbus TCP as the two tables of `fieldspec decode`, with numpy by hand.

It knows the device and the packets: each request has 12 bytes and each answer 29, nothing is lost. The registers are
ten numbers, or five states and five words of 16 bits. `capture_by_hand.py CAPTURE FOLDER states|numbers`
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pyarrow as pa
from pyarrow import parquet

TEXT = pa.dictionary(pa.int32(), pa.string())
PAIR, FIRST, FRAMES = 181, 24, 46_000
REQUEST, ANSWER = slice(70, 82), slice(152, 181)


def text(places: np.ndarray, words: list[str], mask: np.ndarray | None = None) -> pa.Array:
    return pa.DictionaryArray.from_arrays(pa.array(places.astype(np.int32), mask=mask), pa.array(words))


def same(word: str, rows: int) -> pa.Array:
    return text(np.zeros(rows, np.int32), [word])


def nothing(kind: pa.DataType, rows: int) -> pa.Array:
    return pa.nulls(rows, kind)


def packed(data: np.ndarray, sizes: np.ndarray, present: np.ndarray | None = None) -> pa.Array:
    offsets = np.zeros(len(sizes) + 1, np.int32)
    np.cumsum(sizes, out=offsets[1:])
    valid = None if present is None else pa.array(present).buffers()[1]
    return pa.Array.from_buffers(pa.binary(), len(sizes), [valid, pa.py_buffer(offsets), pa.py_buffer(data)])


def bit_names(word: int) -> list[str]:
    halves = [
        ["+".join(f"w{word}_flag_{bit + first}" for bit in range(8) if number >> bit & 1) for number in range(256)]
        for first in (0, 8)
    ]
    return ["+".join(filter(None, (low, high))) for high in halves[1] for low in halves[0]]


STATES = [f"s{state}_{number}" for state in range(5) for number in range(20)]
NAMES = np.array([*STATES, *(name for word in range(5) for name in bit_names(word))], object)


def meanings(words: np.ndarray) -> pa.Array:
    """The names of states and bits, of those that occur."""
    places = words.astype(np.int32)
    places[:, :5] = np.minimum(places[:, :5], 19) + 20 * np.arange(5)
    places[:, 5:] += len(STATES) + 65536 * np.arange(5)
    used = np.zeros(len(NAMES), np.bool_)
    used[places.ravel()] = True
    return text((np.cumsum(used) - 1)[places.ravel()], NAMES[used].tolist())


def tables(pairs: np.ndarray, first: int, source: str, is_states: bool) -> Iterator[tuple[str, pa.Table]]:
    rows = 2 * len(pairs)
    number = np.arange(first + 1, first + 1 + rows)
    heads = np.concatenate([pairs[:, :8].copy().view("<u4"), pairs[:, 82:90].copy().view("<u4")], axis=1)
    heads = heads.reshape(rows, 2).astype(np.int64)
    time = heads[:, 0] * 1_000_000_000 + heads[:, 1] * 1000
    is_answer = np.tile([False, True], len(pairs))
    words = np.ascontiguousarray(pairs[:, 161:181]).view(">u2").astype(np.int64)
    delay = np.zeros(rows, np.int64)
    delay[1::2] = time[1::2] - time[::2]
    ones = np.ones(rows, np.int64)
    frame_bytes = np.concatenate([pairs[:, REQUEST], pairs[:, ANSWER]], axis=1).ravel()
    yield (
        "frames",
        pa.table(
            {
                "source": same(source, rows),
                "frame": number,
                "packet": number,
                "time": pa.array(time).cast(pa.timestamp("ns", "UTC")),
                "stream": same("tcp 10.0.0.1:49152 10.0.0.2:502", rows),
                "device": same("device", rows),
                "link": same("tcp", rows),
                "direction": text(is_answer, ["request", "response"]),
                "message": same("read_input_registers", rows),
                "exception": nothing(TEXT, rows),
                "unit_address": ones,
                "space": same("input_registers", rows),
                "address": np.zeros(rows, np.int64),
                "count": 10 * ones,
                "request": pa.array(number - 1, mask=~is_answer),
                "delay": pa.array(delay, mask=~is_answer),
                "verdict": same("ok", rows),
                "bytes": packed(frame_bytes, np.tile([12, 29], len(pairs))),
                "data": packed(np.ascontiguousarray(pairs[:, 161:181]).ravel(), np.where(is_answer, 20, 0), is_answer),
            }
        ),
    )
    count = words.size
    is_known = np.ones((len(pairs), 10), np.bool_)
    if is_states:
        is_known[:, :5] = words[:, :5] < 20
    raw, register = words.ravel(), np.tile(np.arange(10), len(pairs))
    yield (
        "values",
        pa.table(
            {
                "source": same(source, count),
                "frame": np.repeat(number[1::2], 10),
                "time": pa.array(np.repeat(time[1::2], 10)).cast(pa.timestamp("ns", "UTC")),
                "device": same("device", count),
                "unit_address": np.ones(count, np.int64),
                "operation": same("read", count),
                "space": same("input_registers", count),
                "address": register,
                "register": text(register, [f"r{place}" for place in range(10)]),
                "raw": raw,
                "value": nothing(pa.float64(), count) if is_states else raw.astype(np.float64),
                "text": meanings(words) if is_states else nothing(TEXT, count),
                "unit": nothing(TEXT, count),
                "verdict": text(~is_known.ravel(), ["ok", "unlisted_member"]),
            }
        ),
    )


def main(source: str, folder: str, kind: str) -> None:
    data = np.fromfile(source, np.uint8)[FIRST:]
    pairs = data[: len(data) // PAIR * PAIR].reshape(-1, PAIR)
    Path(folder).mkdir(parents=True, exist_ok=True)
    writers: dict[str, parquet.ParquetWriter] = {}
    for start in range(0, len(pairs), FRAMES):
        for name, table in tables(pairs[start : start + FRAMES], 2 * start, Path(source).name, kind == "states"):
            if name not in writers:
                packed_columns = {own.name: "DELTA_BINARY_PACKED" for own in table.schema if is_packed(own.type)}
                writers[name] = parquet.ParquetWriter(
                    f"{folder}/{name}.parquet",
                    table.schema,
                    compression="zstd",
                    compression_level=1,
                    use_dictionary=[own.name for own in table.schema if own.type == TEXT],
                    column_encoding=packed_columns,
                )
            writers[name].write_table(table)
    for writer in writers.values():
        writer.close()


def is_packed(kind: pa.DataType) -> bool:
    return pa.types.is_int64(kind) or pa.types.is_timestamp(kind)


if __name__ == "__main__":
    main(*sys.argv[1:])
