"""The `Choice` of a record whose last field another one decides."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.backends.python.reading import local
from fieldspec.backends.python.slots import Slots
from fieldspec.backends.python.text import literal
from fieldspec.backends.python.values import value_expression
from fieldspec.backends.python.writing import tuple_of
from fieldspec.layout.record import CaseLayout, RecordLayout

CASE = "case"
"""The variable that holds the case of the selector."""


def choice_lines(variable: str, record: RecordLayout, fields: Sequence[Slots], letters: str, order: str) -> list[str]:
    """The statement that makes the `Choice` of a record; `letters` are those of the fields before the decided one."""
    by, decided = record.selector, fields[-1]
    assert by is not None
    repeat = decided.field.field.repeat
    least, most = (repeat.low, repeat.high) if repeat else (decided.count, decided.count)
    arguments = [literal(record.name), literal(letters), literal(by.name), str(by.offset), str(by.size)]
    cases = [_case(case, order, decided) for case in decided.field.cases]
    bounds = [f"least={least}", f"most={most}"] + (['order="little"'] if by.order == "little" else [])
    return [
        f"{variable} = _Choice(",
        f"    {', '.join(arguments)},",
        *(f"    {case}," for case in cases),
        f"    {', '.join(bounds)},",
        ")",
    ]


def _case(case: CaseLayout, order: str, decided: Slots) -> str:
    native = case.value.size == 1 or (case.order == order and not case.swapped)
    letters = case.value.type.letter if native and case.value.type.letter != "s" else f"{case.value.size}s"
    value = value_expression(case.value, case.value.size, case.order, case.swapped, decided.words)
    return f"({tuple_of(sorted(case.numbers))}, {literal(letters)}, {value})"


def decided_read(decided: Slots, owner: str, at: int) -> list[str]:
    """Lines that make the value of the decided field."""
    first = "" if decided.listed else "[0]"
    held = f"{CASE}.values({literal(decided.title)}, {local(decided)}, {at}){first}"
    return [f"{owner}.{decided.name} = {held}"]


def decided_values(decided: Slots, held: str) -> str:
    """What fills the slots of the decided field."""
    values = held if decided.listed else f"({held},)"
    return f"*{CASE}.raws({literal(decided.title)}, {values})"
