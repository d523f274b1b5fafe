"""The generated queries as a judge: DuckDB and Polars decode the data of records, registers and parameters."""

from __future__ import annotations

from typing import Any

from fieldspec.backends import OUTPUTS
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.names import Name
from fieldspec.reference import CodecError
from fieldspec.reference.records import decoded, encoded
from queries_output.engines import ENGINES
from queries_output.expected import is_equal, record_columns
from random_devices.queries import UNKNOWN, Answer, Query


class Queries:
    """The answers of an engine about records and messages. It compares the columns with the reference itself."""

    def __init__(self, layout: DeviceLayout, engine: str) -> None:
        self.layout = layout
        self.engine = None if OUTPUTS["queries"].refusals([layout]) else ENGINES[engine](layout)

    def answers(self, queries: list[Query]) -> list[Answer]:
        """The answer to each query; about registers and frames that are decoded, none."""
        answers = [Answer(UNKNOWN) for _ in queries]
        if self.engine is None:
            return answers
        groups: dict[str, list[tuple[int, bytes]]] = {}
        for place, query in enumerate(queries):
            if query.kind == "record" and query.values is None:
                groups.setdefault(Name.of(query.path[0]).snake(), []).append((place, query.data))
            elif query.kind == "frame" and query.values is not None and not query.error:
                data = self._body(query)
                if data is not None:
                    name = f"{Name.of(query.path[2]).snake()}_{query.path[1]}"
                    groups.setdefault(name, []).append((place, data))
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
