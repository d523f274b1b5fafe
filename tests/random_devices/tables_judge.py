"""What is at the addresses of tables as a judge: the values of records, however deep, are those of the reference."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from typing import Any

from fieldspec.codec.explain.occupants import Occupant, occupants
from fieldspec.codec.explain.spans import Span
from fieldspec.codec.explain.values import number_of
from fieldspec.codec.layout.bases import at_usual_bases
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.reference import CodecError
from fieldspec.codec.reference.records import decoded, encoded
from fieldspec.tools.simulator.memory import Memory
from random_devices.inputs import record_values
from random_devices.queries import Answer, Query, to_encode


class Tables:
    """Says nothing about queries; raises AssertionError where a value of an element is missing or another one."""

    def __init__(self, layout: DeviceLayout) -> None:
        self.layout = at_usual_bases(layout)
        self.memory = Memory(layout)

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        dice = random.Random(len(queries))
        for table in self.layout.tables.values():
            self._assert_table(table, dice)
        return [Answer(reason=None)] * len(queries)

    def _assert_table(self, table: TableLayout, dice: random.Random) -> None:
        index = dice.choice(table.table.indexes)
        first, space = table.table.address(index), self.layout.device.space_name(table.table.space)
        span = Span(space, first, table.words, 0, b"")
        own = {each.path: each for each in occupants(self.layout, span) if each.outer is table.table}
        try:
            values = record_values(self.layout, table.record, dice)
            data = encoded(table.record, to_encode(table.record, values), self.layout.device)
        except CodecError:
            return
        wanted = dict(_values(table.record, decoded(table.record, data, self.layout.device), f"{table.name}[{index}]."))
        have = {path: _number(each, data, first) for path, each in own.items()}
        assert list(have) == list(wanted), f"{table.name} has {list(have)} instead of {list(wanted)}"
        for path, number in wanted.items():
            if isinstance(number, int | float) and number == number:
                assert have[path] == number, f"{path} is {have[path]} instead of {number} in {data.hex(' ')}"
        for address in range(first, first + table.words):
            assert self.memory.at(space, address), f"a simulated device has nothing at 0x{address:04X}"


def _number(occupant: Occupant, data: bytes, first: int) -> Any:
    at = 2 * (occupant.address - first) + occupant.skip
    return number_of(occupant.value, data[at : at + occupant.value.size], occupant.order, occupant.swapped)


def _values(record: RecordLayout, values: Mapping[str, Any], before: str) -> Iterator[tuple[str, Any]]:
    """The values of a record by their paths."""
    for field in record.fields:
        value, path = values.get(field.name), f"{before}{field.name}"
        elements = [(f"{path}[{number}]", item) for number, item in enumerate(value)] if field.is_list else []  # type: ignore[arg-type]
        for name, element in elements or [(path, value)]:
            if field.record is not None:
                yield from _values(field.record, element, f"{name}.")
            else:
                yield name, element


__all__ = ["Tables"]
