"""Properties of a record in the units of its fields, and its sentinels as constants."""

from __future__ import annotations

from fieldspec.backends.python.naming import MESSAGE, Scope
from fieldspec.backends.python.slots import Slots
from fieldspec.backends.python.text import docstring, sentence
from fieldspec.backends.python.units import in_unit, ratio, unit_word
from fieldspec.backends.python.writing import pairs, within
from fieldspec.classes import dataclass
from fieldspec.model.primitive import Kind
from fieldspec.model.ranges import Ranges
from fieldspec.model.value import Value
from fieldspec.names import Name


@dataclass(frozen=True, slots=True)
class ScaledView:
    """A property in the unit: the expressions that read and set it, and its docstring.

    `type` is that of what is read, `accepted` that of what it may be set to.
    """

    name: str
    type: str
    accepted: str
    read: str
    write: str
    field: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class ConstantView:
    """A constant of a class."""

    name: str
    value: str
    doc: list[str]


def sentinel_views(stored: list[Slots]) -> list[ConstantView]:
    """The sentinels of all fields."""
    scope = Scope(MESSAGE)
    return [
        ConstantView(
            scope.take((Name.of(field.title) + Name.of(sentinel.name)).upper()),
            'float("nan")' if sentinel.is_nan else str(sentinel.value),
            docstring([sentence(f"`{field.title}`: {sentinel.doc or Name.of(sentinel.name).title()}")], 4),
        )
        for field in stored
        if field.field.value is not None
        for sentinel in field.value.sentinels
    ]


def _of_float(field: Slots, scope: Scope) -> ScaledView:
    """The property of a floating-point number, which counts in its unit, but may be absent."""
    name = scope.take(f"{field.title}_{unit_word(field.value.unit) if field.value.unit else 'value'}")
    raw = "item" if field.listed else f"self.{field.name}"
    tests = [f"{raw} == {number}" for number in field.sentinels] + [f"{raw} != {raw}"] * field.value.absent_nan
    read = f"None if {' or '.join(tests)} else {raw}"
    unit = f" in {field.value.unit}" if field.value.unit else ""
    return ScaledView(
        name,
        "list[float | None]" if field.listed else "float | None",
        "list[float]" if field.listed else "float",
        f"[{read} for item in self.{field.name}]" if field.listed else read,
        "value",
        field.name,
        docstring([f"`{field.name}`{unit}. It is None where the number stands for an absent value."], 8),
    )


def quantities(value: Value) -> list[tuple[int, int]]:
    """The counts that are quantities: those in range that stand for nothing else."""
    found = list(value.ranges.intervals) if value.ranges is not None else [(value.type.low, value.type.high)]
    for sentinel in value.sentinels:
        found = [
            part
            for low, high in found
            for part in ((low, min(high, sentinel.value - 1)), (max(low, sentinel.value + 1), high))
            if part[0] <= part[1]
        ]
    return found


def scaled_views(stored: list[Slots], scope: Scope) -> list[ScaledView]:
    """The properties of those fields that count in parts of a unit."""
    found = []
    for field in stored:
        if field.kind is Kind.FLOAT and field.value.sentinels:
            found.append(_of_float(field, scope))
        if not field.whole or not field.value.scaled or field.value.enum or field.value.flags:
            continue
        held = ratio(field.value)
        name = scope.take(f"{field.title}_{unit_word(field.value.unit)}")
        limits = pairs(Ranges(tuple(quantities(field.value))))
        write = f'_counts("{field.title}", {"item" if field.listed else "value"}, {held}, {limits})'
        raw = "item" if field.listed else f"self.{field.name}"
        read = in_unit(raw, held)
        kind = "float"
        if field.sentinels:
            absent = within(raw, Ranges(tuple((count, count) for count in field.sentinels)))
            read, kind = f"None if {absent} else {read}", "float | None"
        unit = f" in {field.value.unit}" if field.value.unit else ""
        ends = "It is None where the count stands for an absent value. " if field.sentinels else ""
        ends += "Setting it takes the nearest count, of two the even one, and refuses what is out of range."
        found.append(
            ScaledView(
                name,
                f"list[{kind}]" if field.listed else kind,
                "list[float]" if field.listed else "float",
                f"[{read} for item in self.{field.name}]" if field.listed else read,
                f"[{write} for item in value]" if field.listed else write,
                field.name,
                docstring([f"`{field.name}`{unit}. {ends}"], 8),
            )
        )
    return found
