"""The code that writes a record: its conditions, the values of its slots, and its refusals."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.python.bit_counts import bit_count_refusal, fills
from fieldspec.targets.python.presences import fitting, presence_refusals, presences, wrong_end
from fieldspec.targets.python.reading import CASE, decided_values, local
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import literal
from fieldspec.targets.python.writing import conditions, fixed, measured, pairs, refusal, values, within

NO_CASES: Mapping[str, str] = {}


@dataclass(frozen=True, slots=True)
class Writing:
    """Lines that bind locals, the conditions of all fields, the values of the slots, and the refusals."""

    bind: list[str]
    tests: list[str]
    values: list[str]
    refusals: list[str]


def writing_lines(
    shaped: RecordShape, bound: frozenset[str], struct: str, cases: Mapping[str, str] = NO_CASES
) -> Writing:
    """The code that writes a record; the fields in `bound` get a local even where no test needs one.

    `cases` are the variables of the types of fields, by the names of these, where other fields may follow them.
    """
    expressions = {field.title: f"self.{field.slot}" for field in shaped.stored}
    bind: list[str] = []
    tests: dict[str, list[str]] = {}
    selector = shaped.selector
    with_locals = bound | {field.field.field.measures.field for field in shaped.fields if field.field.field.measures}
    with_locals |= {
        name for field in shaped.fields if field.field.bits_of for name in (field.title, field.field.bits_of)
    }
    with_locals |= {own.title for pair in presences(shaped) for own in pair}
    for field in shaped.stored:
        value_tests = conditions(field, local(field))
        if value_tests or field.title in with_locals or field.parted or field is selector:
            attribute = expressions[field.title]
            bind.append(f"{local(field)} = {f'_index({attribute})' if field.deferred else attribute}")
            expressions[field.title] = local(field)
        tests[field.title] = value_tests
    if selector is not None:
        bind.append(f"{CASE} = {struct}.case({expressions[selector.title]})")
    slot_values: list[str] = []
    size_tests: list[str] = []
    for field in shaped.fields:
        if field.field.bits_of:
            size_tests.append(fills(local(field), expressions[field.field.bits_of], "=="))
        if field.field.field.measures is not None:
            size = _size(shaped, field, expressions, f"{CASE}.size")
            if field.ranges is not None:
                size_tests.append(within(size, field.ranges))
            # In another order than its Struct, a number is not packed as it is.
            slot_values += values(field, f"({size})") if field.parted or field.foreign else [size]
        elif field.title in cases:
            number = _selector_number(shaped, field, expressions)
            slot_values.append(
                f"{cases[field.title]}.raw({literal(field.title)}, {number}, {expressions[field.title]})"
            )
        elif field.splits:
            slot_values.append(decided_values(field, expressions[field.title]))
        else:
            slot_values += values(field, expressions[field.title]) if field.stored else fixed(field)
    for field, decider in presences(shaped):
        size_tests.append(fitting(field, f"_index({expressions[decider.title]})", expressions[field.title]))
    ends = [wrong_end(field, expressions[field.title]) for field in shaped.stored]
    size_tests += [f"{end} is None" for end in ends if end]
    all_tests = [test for field_tests in tests.values() for test in field_tests] + size_tests
    return Writing(bind, all_tests, slot_values, _refusals(shaped, struct, cases))


def _size(shaped: RecordShape, field: Slots, expressions: dict[str, str], decided: str) -> str:
    """The value of a field that measures another one; `decided` is the size of an element with several types."""
    measure = field.field.measure
    assert measure is not None
    other = next(candidate for candidate in shaped.fields if candidate.title == measure.field)
    return measured(field, other, expressions[other.title], decided)


def _selector_number(shaped: RecordShape, field: Slots, expressions: Mapping[str, str]) -> str:
    """The expression of the number that decides the type of a field."""
    selector = shaped.selector_of(field)
    assert selector is not None
    return expressions[selector.title] if selector.stored else str(selector.constant)


def _refusals(shaped: RecordShape, struct: str, cases: Mapping[str, str]) -> list[str]:
    """The expressions of the refusals of all fields: first of the selector, which decides another type."""
    refusals = []
    selector = shaped.selector
    if selector is not None:
        refusals += [refusal(selector), f"{struct}.refused_by(self.{selector.name})"]
    expressions = {field.title: f"self.{field.name}" for field in shaped.stored}
    for field in shaped.stored:
        if field.title in cases:
            number = _selector_number(shaped, field, expressions)
            refusals.append(f"{cases[field.title]}.refused({literal(field.title)}, {number}, self.{field.name})")
        elif field.splits and selector is not None:
            function = "refused" if field.is_list else "refused_element"
            refusals.append(f"{struct}.{function}({literal(field.title)}, self.{selector.name}, self.{field.name})")
        elif field is not selector:
            refusals.append(refusal(field))
    for field in shaped.fields:
        if field.field.bits_of:
            refusals.append(bit_count_refusal(field, expressions))
        if field.field.field.measures is not None:
            decided = f"{struct}.cases[self.{selector.name}].size" if selector is not None else ""
            limits = [_size(shaped, field, expressions, decided), str(field.value.type.low), str(field.value.type.high)]
            limits += [pairs(field.ranges)] if field.ranges is not None else []
            refusals.append(f"_refused_number({literal(field.title)}, {', '.join(limits)})")
    return [*refusals, *presence_refusals(shaped)]
