"""Writes tables of frames and values as Parquet, CSV, JSON lines or Arrow."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any, BinaryIO, Protocol

import pyarrow as pa

from fieldspec.foundation.spreadsheet import clean, guarded
from fieldspec.tools.captures.tables import SCHEMAS, TEXT


class TableWriter(Protocol):
    """Writes the batches of one table into one file."""

    def write(self, batch: Any) -> None:
        """Adds a record batch."""

    def close(self) -> None:
        """Writes what is left. The file itself stays open."""


class ParquetTable(TableWriter):
    """Parquet with zstd. Numbers are packed by their differences, texts are dictionaries, so that filters are fast."""

    def __init__(self, file: BinaryIO, table: str) -> None:
        from pyarrow import parquet

        schema = SCHEMAS[table]
        differences = {field.name: "DELTA_BINARY_PACKED" for field in schema if _is_packed(field.type)}
        self.writer = parquet.ParquetWriter(
            file,
            schema,
            compression="zstd",
            compression_level=1,
            use_dictionary=[field.name for field in schema if field.type == TEXT],
            column_encoding=differences,
        )

    def write(self, batch: Any) -> None:
        """Adds a record batch as a row group."""
        if batch.num_rows:
            self.writer.write_batch(batch)

    def close(self) -> None:
        """Writes the index of the row groups."""
        self.writer.close()


def _is_packed(kind: Any) -> bool:
    return bool(pa.types.is_int64(kind) or pa.types.is_timestamp(kind))


class ArrowTable(TableWriter):
    """An Arrow file. Texts are written whole, because the dictionaries of a file cannot change."""

    def __init__(self, file: BinaryIO, table: str) -> None:
        self.schema = _without_dictionaries(SCHEMAS[table])
        self.writer = pa.ipc.new_file(file, self.schema)

    def write(self, batch: Any) -> None:
        self.writer.write_batch(batch.cast(self.schema))

    def close(self) -> None:
        """Writes the index of the batches."""
        self.writer.close()


class CsvTable(TableWriter):
    """CSV with a row of headings. Bytes are hexadecimal digits; what is unknown is empty."""

    def __init__(self, file: BinaryIO, table: str) -> None:
        from pyarrow import csv

        fields = [(field.name, field.type) for field in _without_dictionaries(SCHEMAS[table])]
        self.schema = pa.schema([(name, pa.string() if pa.types.is_binary(kind) else kind) for name, kind in fields])
        self.writer = csv.CSVWriter(file, self.schema)

    def write(self, batch: Any) -> None:
        columns = [_csv_column(column).cast(own.type) for column, own in zip(batch.columns, self.schema, strict=True)]
        self.writer.write_batch(pa.RecordBatch.from_arrays(columns, schema=self.schema))

    def close(self) -> None:
        """Writes the rest of the rows."""
        self.writer.close()


class JsonTable(TableWriter):
    """One JSON object in each line, without the keys of what is unknown. Times are ISO 8601, bytes hexadecimal."""

    def __init__(self, file: BinaryIO, table: str) -> None:
        self.file, self.names = file, [field.name for field in SCHEMAS[table]]

    def write(self, batch: Any) -> None:
        columns = []
        for column, field in zip(batch.columns, batch.schema, strict=True):
            if pa.types.is_binary(field.type):
                column = _hexadecimal(column)
            elif pa.types.is_timestamp(field.type):
                column = column.cast(pa.string())
            columns.append(column.to_pylist())
        lines = []
        for row in zip(*columns, strict=True):
            values = {
                name: _json_number(value) for name, value in zip(self.names, row, strict=True) if value is not None
            }
            lines.append(json.dumps(values, ensure_ascii=False))
        if lines:
            self.file.write(("\n".join(lines) + "\n").encode())

    def close(self) -> None:
        """Writes nothing: every line is complete."""


def _csv_column(column: Any) -> Any:
    """A column for CSV. Spreadsheets take none of its texts for a formula."""
    if pa.types.is_binary(column.type):
        return _hexadecimal(column)
    if column.type == TEXT:
        texts = [guarded(clean(text)) for text in column.dictionary.to_pylist()]
        return pa.DictionaryArray.from_arrays(column.indices, pa.array(texts, pa.string()))
    return column


def _json_number(value: object) -> object:
    """A value for JSON, which has no infinite numbers and no NaN: these are texts."""
    is_special = isinstance(value, float) and (value != value or value in (float("inf"), float("-inf")))
    return str(value) if is_special else value


def _without_dictionaries(schema: Any) -> Any:
    return pa.schema([(field.name, pa.string() if field.type == TEXT else field.type) for field in schema])


def _hexadecimal(column: Any) -> Any:
    return pa.array([None if data is None else data.hex() for data in column.to_pylist()], pa.string())


WRITERS: dict[str, Callable[[BinaryIO, str], TableWriter]] = {
    "parquet": ParquetTable,
    "csv": CsvTable,
    "jsonl": JsonTable,
    "arrow": ArrowTable,
}
"""The writers by the name of the format, which is also the ending of the files."""
