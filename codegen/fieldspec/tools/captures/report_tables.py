"""Parquet tables: tables of a report are written, tables of frames and values are read."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, BinaryIO

ROWS = 1 << 18
"""The rows of a table that are read at once."""


def parquet_bytes(columns: Sequence[str], rows: Sequence[Mapping[str, Any]]) -> bytes:
    """Rows as a Parquet file: a column of numbers where all its cells are numbers, else a column of texts."""
    import pyarrow as pa
    from pyarrow import parquet

    arrays = {}
    for name in columns:
        cells = [row[name] for row in rows]
        is_number = any(isinstance(cell, int) for cell in cells) and all(
            cell is None or isinstance(cell, int) for cell in cells
        )
        texts = [None if cell is None else str(cell) for cell in cells]
        arrays[name] = pa.array(cells, pa.int64()) if is_number else pa.array(texts, pa.string())
    output = io.BytesIO()
    parquet.write_table(pa.table(arrays), output)
    return output.getvalue()


def parquet_batches(file: BinaryIO) -> Iterator[Any]:
    """The record batches of a Parquet file. Raises OSError for other files."""
    import pyarrow as pa
    from pyarrow import parquet

    try:
        yield from parquet.ParquetFile(file).iter_batches(batch_size=ROWS)
    except pa.ArrowInvalid as error:
        raise OSError(0, str(error)) from None
