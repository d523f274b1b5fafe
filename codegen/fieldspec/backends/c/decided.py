"""Records whose selectors have a value: what their members are called in C."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from fieldspec.backends.c.choices import case_member
from fieldspec.backends.c.fields import count_member, members
from fieldspec.backends.c.naming import member
from fieldspec.classes import dataclass
from fieldspec.layout.record import FieldLayout, RecordLayout


@dataclass(frozen=True, slots=True)
class Decided:
    """A record without cases, and the struct of which it is one: where its members and their counts are."""

    record: RecordLayout
    struct: RecordLayout
    case: str

    def path(self, field: FieldLayout) -> str:
        """The member that holds a field's values."""
        name = member(field.name)
        return f"{name}.{self.case}" if self.case and field is self.record.fields[-1] else name

    def count(self, field: FieldLayout) -> str:
        """The member that holds how many they are."""
        return count_member(self.struct, field)


def every(record: RecordLayout) -> Iterator[tuple[Decided, dict[str, Any]]]:
    """Each form of a record, and the value of the selector that makes it so."""
    if record.selector is None:
        yield Decided(record, record, ""), {}
        return
    given = record.selector in members(record)
    for number in record.chosen:
        values = {record.selector.name: number}
        yield of_values(record, values), values if given else {}


def of_values(record: RecordLayout, values: Mapping[str, Any]) -> Decided:
    """The form of a record that holds some values."""
    if record.selector is None:
        return Decided(record, record, "")
    constant = record.selector.value.const if record.selector.value is not None else None
    number = values[record.selector.name] if constant is None else constant
    case = next(case for case in record.fields[-1].cases if number in case.numbers)
    return Decided(record.chosen[number], record, case_member(case))
