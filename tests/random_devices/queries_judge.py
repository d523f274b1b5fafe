"""The generated queries as a judge: DuckDB and Polars decode the data of records, registers and parameters."""

from __future__ import annotations

from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError
from fieldspec.codec.reference.records import decoded, encoded
from fieldspec.foundation.names import Name
from fieldspec.language.diagnostics import has_errors
from fieldspec.targets.queries.backend import remaining
from fieldspec.targets.queries.plan import Names
from queries_output.engines import ENGINES
from queries_output.expected import is_equal, record_columns
from random_devices.queries import UNKNOWN, Answer, Query


def query_names(layout: DeviceLayout) -> dict[str | tuple[str, str], str]:
    """The names of the queries of records, and of messages with their directions, some of which are words of Python."""
    names = Names(layout.device.enums)
    result: dict[str | tuple[str, str], str] = {}
    for record in layout.records:
        own = Name.of(record).snake()
        result[record] = names.take(own, f"{own}_record")
    for message in layout.messages.values():
        for direction in message.message.directions:
            own = f"{Name.of(message.name).snake()}_{direction}"
            result[message.name, direction] = names.take(own, f"{own}_data")
    return result


class Queries:
    """The answers of an engine about records and messages. It compares the columns with the reference itself."""

    def __init__(self, layout: DeviceLayout, engine: str) -> None:
        self.layout = layout
        expressed_layout = remaining(layout)
        self.names = query_names(expressed_layout.layout)
        self.engine = None if has_errors(expressed_layout.findings) else ENGINES[engine](expressed_layout.layout)

    def answers(self, queries: list[Query]) -> list[Answer]:
        """The answer to each query; about registers and frames that are decoded, none."""
        answers = [Answer(UNKNOWN) for _ in queries]
        if self.engine is None:
            return answers
        groups: dict[str, list[tuple[int, bytes]]] = {}
        for place, query in enumerate(queries):
            if query.kind == "record" and query.values is None and query.path[0] in self.names:
                groups.setdefault(self.names[query.path[0]], []).append((place, query.data))
            elif query.kind == "frame" and query.values is not None and not query.error:
                data = self._body(query)
                if data is not None and (query.path[2], query.path[1]) in self.names:
                    groups.setdefault(self.names[query.path[2], query.path[1]], []).append((place, data))
        for name, places in groups.items():
            rows = self.engine.rows(name, {"payload": [data for _, data in places]})
            for (place, data), row in zip(places, rows, strict=True):
                wrong = self._differences(queries[place].shape, data, row)
                answers[place] = Answer(again=wrong) if wrong else Answer(UNKNOWN)
        return answers

    def _body(self, query: Query) -> bytes | None:
        """The data of a message; None where the reference refuses its values."""
        assert query.values is not None
        head = {part.name for part in self.layout.links[query.path[0]].frame(query.path[1]).header}
        values = {name: value for name, value in query.values.items() if name not in head}
        try:
            return encoded(query.shape, values, self.layout.device)
        except CodecError:
            return None

    def _differences(self, record: RecordLayout, data: bytes, row: dict[str, Any]) -> str:
        """The columns of a row that are wrong; empty where all are right."""
        try:
            values = decoded(record, data, self.layout.device)
        except CodecError as error:
            return "" if row["refusal"] == error.reason else f"refusal {row['refusal']} and not {error.reason}"
        if row["refusal"] is not None:
            return f"refusal {row['refusal']}"
        wanted = record_columns(self.layout.device, record, values)
        wrong = [name for name, value in wanted.items() if name not in row or not is_equal(value, row[name])]
        return ", ".join(f"{name} {row.get(name)!r} and not {wanted[name]!r}" for name in wrong)


__all__ = ["Queries"]
