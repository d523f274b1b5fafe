"""The generated queries, run by DuckDB and by Polars."""

from __future__ import annotations

import importlib.util
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import duckdb
import polars

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import stem
from fieldspec.targets.queries.polars_text import polars_text
from fieldspec.targets.queries.sql_text import sql_text

Rows = list[dict[str, Any]]


class DuckDb:
    """Runs the macros of a device."""

    def __init__(self, layout: DeviceLayout) -> None:
        self.schema = stem(layout.device.id, layout.device.version)
        self.connection = duckdb.connect()
        self.connection.execute("SET threads = 1")
        self.connection.execute(sql_text(layout))

    def rows(self, query: str, arguments: Mapping[str, Sequence[Any]]) -> Rows:
        """The rows of a query for columns of arguments, in their order, each with the `place` of its payload."""
        source = _frame(arguments)
        self.connection.register("source_rows", source.to_arrow())
        columns = ", ".join(arguments)
        text = f'FROM "{self.schema}"."{query}"(source_rows, {columns}) ORDER BY place'
        result = self.connection.execute(text)
        assert result.description is not None
        names = [column[0] for column in result.description]
        return [dict(zip(names, row, strict=True)) for row in result.fetchall()]


class PolarsEngine:
    """Runs the expressions of a device."""

    def __init__(self, layout: DeviceLayout) -> None:
        self.module = module_of(polars_text(layout))

    def rows(self, query: str, arguments: Mapping[str, Sequence[Any]]) -> Rows:
        """The rows of a query for columns of arguments, in their order, each with the `place` of its payload."""
        expressions = getattr(self.module, query)(*(polars.col(name) for name in arguments))
        frame = _frame(arguments).lazy()
        if query.endswith("_findings"):
            rows = (
                frame.with_columns(finding=expressions).explode("finding").filter(polars.col("finding").is_not_null())
            )
            return rows.unnest("finding").collect().to_dicts()
        return frame.with_columns(expressions).collect().to_dicts()


def _frame(arguments: Mapping[str, Sequence[Any]]) -> polars.DataFrame:
    count = len(next(iter(arguments.values())))
    columns = {"place": range(count), **arguments}
    schema = {name: polars.Binary if name == "payload" else polars.Int64 for name in columns}
    return polars.DataFrame(columns, schema=schema)


def module_of(text: str) -> ModuleType:
    """A generated module of expressions."""
    with tempfile.TemporaryDirectory(prefix="fieldspec-queries-") as folder:
        path = Path(folder) / "expressions.py"
        path.write_text(text, "utf-8")
        spec = importlib.util.spec_from_file_location("expressions", path)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module


ENGINES = {"duckdb": DuckDb, "polars": PolarsEngine}


_ENGINES: dict[tuple[str, int], DuckDb | PolarsEngine] = {}


def engine_of(name: str, layout: DeviceLayout) -> DuckDb | PolarsEngine:
    """An engine with the queries of a device, made once. Layouts are compared by identity."""
    key = name, id(layout)
    if key not in _ENGINES:
        _ENGINES[key] = ENGINES[name](layout)
    return _ENGINES[key]
