"""The generated queries as a judge: DuckDB and Polars decode the data of records, registers and parameters."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.names import Name
from fieldspec.reference import CodecError
from fieldspec.reference.records import decoded
from queries_output.engines import ENGINES
from queries_output.expected import is_equal, record_columns
from random_devices.queries import UNKNOWN, Answer, Query


class Queries:
    """The answers of an engine. It compares the columns itself: those that differ stand in the values of the answer."""

    def __init__(self, layout: DeviceLayout, engine: str) -> None:
        self.layout = layout
        self.engine = ENGINES[engine](layout)

    def answers(self, queries: list[Query]) -> list[Answer]:
        """The answer to each query; of queries that are about something else, none."""
        answers = [Answer(UNKNOWN) for _ in queries]
        groups: dict[str, list[int]] = {}
        for place, query in enumerate(queries):
            if query.kind == "record" and query.values is None:
                groups.setdefault(query.path[0], []).append(place)
        for name, places in groups.items():
            payloads = [queries[place].data for place in places]
            rows = self.engine.rows(Name.of(name).snake(), {"payload": payloads})
            for place, row in zip(places, rows, strict=True):
                answers[place] = self._answer(queries[place], row)
        return answers

    def _answer(self, query: Query, row: dict[str, Any]) -> Answer:
        if row["refusal"] is not None:
            return Answer(row["refusal"])
        record: RecordLayout = query.shape
        try:
            wanted = record_columns(self.layout.device, record, decoded(record, query.data, self.layout.device))
        except CodecError:
            return Answer("")
        wrong = [f"{name}: {row[name]!r}" for name, value in wanted.items() if not is_equal(value, row[name])]
        return Answer(values=", ".join(wrong) if wrong else UNKNOWN)


__all__ = ["Queries"]
