"""Tables of a report as Parquet."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence
from typing import Any


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
