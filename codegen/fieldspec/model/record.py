"""Fields in a fixed order."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Fact
from fieldspec.model.handling import Handling
from fieldspec.model.ranges import Ranges
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True)
class Measure:
    """That a field holds the size of another one: its `bytes`, or its number of `items`."""

    of: str
    field: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Case(Fact):
    """What lies in a field for some members of the enum of another one."""

    when: tuple[str, ...]
    value: Value


@dataclass(frozen=True, slots=True)
class Choice:
    """That the type of a field depends on the value of an earlier field of its record, which has an enum."""

    by: str
    cases: tuple[Case, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Field(Fact):
    """A value or a record at one place, once, `count` times, or repeated to the end of the data.

    Exactly one of `value`, `record` (a name, else empty) and `choice` is given. `signal` names the signal that it
    places, else empty. `at`, `words`, `span` in bytes and `word_span` are what the manual prints.
    """

    value: Value | None
    record: str
    choice: Choice | None
    signal: str
    count: int | None
    repeat: Ranges | None
    measures: Measure | None
    reserved: bool
    at: int | None
    words: int | None
    span: tuple[int, int] | None
    word_span: tuple[int, int] | None
    access: str
    restart: bool | None
    atomic: bool
    handling: Handling
    same_as: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Record(Fact):
    """Fields in the order of the wire. `size` in bytes and `words` are what the manual prints.

    `same_as` names the record that this one is laid out like, else it is empty.
    """

    size: int | None
    words: int | None
    fields: tuple[Field, ...]
    same_as: str = ""

    def named(self, name: str) -> Field | None:
        """The field with a name."""
        return next((field for field in self.fields if field.name == name), None)
