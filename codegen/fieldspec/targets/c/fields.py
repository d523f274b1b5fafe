"""Fields of records in C: members of structs, statements for one element or for all, and fields with cases."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.targets.c.declarations import Comment, Union, describe_fact, describe_value
from fieldspec.targets.c.expressions import IN, INDEX, SIZE_TYPE, Expression, Group, Local, Operation, Type
from fieldspec.targets.c.literals import decimal, unsigned
from fieldspec.targets.c.machine import literal
from fieldspec.targets.c.naming import Naming, member
from fieldspec.targets.c.statements import Assignment, Body, CountUp, If, Return, Statement, Switch, Variable
from fieldspec.targets.c.values import declare_value, field_value, load

ELEMENT_SIZE = Local("element", SIZE_TYPE)
INNER_LENGTH = Local("inner_length", SIZE_TYPE)

# The statements for one element, from a pointer to its first byte and from its member of the struct.
ElementBody = Callable[[Expression, Expression], Body]


def is_set_by_user(field: FieldLayout) -> bool:
    """Whether users set the field: it is not a constant, measures no other field, and has a meaning.

    In a record without values to set, they set the number of repetitions.
    """
    if field.record is not None and not members(field.record):
        return field.field.repeat is not None
    constant = field.value is not None and field.value.const is not None
    return not (constant or field.field.measures or field.field.reserved)


def words_around_images(naming: Naming, record: RecordLayout) -> dict[str, str]:
    """The names in the functions of a record that call the functions of its image, where each field has
    its own offset.
    """
    struct = naming.type("record", record.name) if members(record) else ""
    verbs = ("encode", "decode", "encode_image", "decode_image")
    return {
        **{verb: naming.function("record", record.name, verb) for verb in verbs},
        "ok": naming.status("ok").name,
        "status": naming.own("codec_status"),
        "argument": f"const {struct} *in, " if struct else "",
        "passed": "in, " if struct else "",
        "result": f", {struct} *out" if struct else "",
        "returned": ", out" if struct else "",
    }


def members(record: RecordLayout) -> list[FieldLayout]:
    """The fields that are members of the struct."""
    return [field for field in record.fields if is_set_by_user(field)]


def greatest_count(field: FieldLayout) -> int:
    """How many elements a list can have."""
    repeat = field.field.repeat
    return repeat.high if repeat is not None else field.count or 1


def count_member(record: RecordLayout, field: FieldLayout) -> str:
    """The member that has the number of elements of a list; a field that is called so keeps the name for itself."""
    name = f"{field.name}_count"
    return f"{name}_" if name in {member(other.name) for other in members(record)} else name


def function_locals(naming: Naming) -> tuple[Local, ...]:
    """The variables that functions of records may have, in the order in which they are declared."""
    return ELEMENT_SIZE, INDEX, INNER_LENGTH, naming.status_variable()


def declare_member(naming: Naming, record: RecordLayout, field: FieldLayout) -> Iterator[Comment | Variable | Union]:
    """The member of a struct for a field, and the one for the number of its elements where that varies."""
    presence, measure = field.field.presence, field.field.bit_measure
    relations = [f"Sent if {presence.condition}."] if presence is not None else []
    relations += [f"Contains {measure.text}."] if measure is not None else []
    if (continuation := field.field.continuation) is not None:
        relations.append(f"After an element, another one follows if {continuation.condition}.")
    yield describe_fact(field.field, describe_value(field.value), *relations)
    count = greatest_count(field) if field.is_list else None
    if field.cases:
        yield from _declare_union(field, count)
    elif field.record is not None:
        dimensions = (decimal(count),) if count is not None else ()
        if members(field.record):
            yield Variable(Type(naming.type("record", field.record.name)), member(field.name), dimensions)
    else:
        yield declare_value(field_value(field), member(field.name), count)
    if field.field.repeat is not None:
        yield Variable(SIZE_TYPE, count_member(record, field))


def walk_elements(
    record: RecordLayout,
    field: FieldLayout,
    element_body: ElementBody,
    struct: Expression,
    data: Expression,
    case: CaseLayout | None = None,
) -> Body:
    """The statements for a field, once or in a loop: `for (at = 0; at < in->points_count; at++) { ... }`

    `struct` is a pointer to the struct of the record, `data` one to its first byte.
    """
    target: Expression = struct.arrow(member(field.name))
    size = field.size
    if case is not None:
        target, size = target.member(case_member(case)), case.value.size
    if not field.is_list:
        return element_body(data + decimal(field.offset), target)
    repeated = field.field.repeat is not None
    limit = struct.arrow(count_member(record, field)) if repeated else unsigned(field.count or 0)
    pointer = Operation("+", (data, unsigned(field.offset), INDEX * unsigned(size)))
    body = element_body(pointer, target.element(INDEX))
    return (CountUp(INDEX, limit, body),) if body else ()


def return_error(naming: Naming, call: Expression) -> Body:
    """`status = call; if (status != OK) { return status; }`"""
    variable = naming.status_variable()
    return Assignment(variable, call), If(variable.differs(naming.status("ok")), (Return(variable),))


def struct_argument(record: RecordLayout, struct: Expression) -> tuple[Expression, ...]:
    """`&struct` as the argument of a function; a record without members has no struct."""
    return (struct.address(),) if members(record) else ()


def element_size(record: RecordLayout, field: FieldLayout) -> Expression:
    """The size of an element; where it differs from case to case, the variable that has it."""
    return ELEMENT_SIZE if field.splits_record and record.size is None else unsigned(field.size)


def measured_size(record: RecordLayout, field: FieldLayout, struct: Expression) -> Expression:
    """`in->points_count * 4u`: the size, or the number of elements, of the field that another one measures."""
    measure = field.measure or field.field.bit_measure
    assert measure is not None
    other = record.named(measure.field)
    assert other is not None
    repeated = other.field.repeat is not None
    count = struct.arrow(count_member(record, other)) if repeated else unsigned(other.count or 1)
    size = element_size(record, other) if measure.of == "bytes" else unsigned(1)
    units = count if size == unsigned(1) else count * size
    return Group(units.plus(measure.plus)) if measure.plus else units


# Fields whose type follows from an earlier field, the selector: unions in structs, and switches in functions.


def case_member(case: CaseLayout) -> str:
    """The member of the union that has a case's values, empty where they are a constant or there are none."""
    return "" if case.value.const is not None or not case.value.size else member(case.name)


def _declare_union(field: FieldLayout, count: int | None) -> Iterator[Union]:
    """The member of a struct that has a member for each case."""
    inner: list[Comment | Variable] = []
    for case in field.cases:
        if name := case_member(case):
            subject = field.field.choice.subject if field.field.choice is not None else ""
            condition = f"While {subject} is {' or '.join(case.case.when)}."
            inner.append(describe_fact(case.case, condition, describe_value(case.value)))
            inner.append(declare_value(field_value(case), name, count))
    if inner:
        yield Union(tuple(inner), member(field.name))


def encoded_selector(selector: FieldLayout) -> Expression:
    """`in->kind`: the value of the selector in a struct that is encoded, or its constant."""
    value = selector.value
    assert value is not None
    if value.const is not None:
        return literal(value.encoding, value.const)
    return IN.arrow(member(selector.name))


def decoded_selector(naming: Naming, selector: FieldLayout) -> Expression:
    """`load_u8(in + 0)`: the value of the selector in bytes that are decoded."""
    return load(naming, field_value(selector), IN + decimal(selector.offset))


def check_selector(naming: Naming, record: RecordLayout, selector: Expression) -> Statement:
    """Refuses a selector that chooses nothing; sets `element` where the size differs from case to case."""
    cases = record.fields[-1].cases
    assert record.selector is not None
    if record.size is not None:
        return select(record.selector, selector, [(list(cases), ())], _unknown_value(naming))
    sizes: dict[int, list[CaseLayout]] = {}
    for case in cases:
        sizes.setdefault(case.value.size, []).append(case)
    branches = [(chosen, (Assignment(ELEMENT_SIZE, unsigned(size)),)) for size, chosen in sizes.items()]
    return select(record.selector, selector, branches, _unknown_value(naming))


def switch_cases(
    naming: Naming,
    field: FieldLayout,
    selector: FieldLayout,
    number: Expression,
    case_body: Callable[[CaseLayout], Body],
) -> Statement:
    """Statements that differ from case to case of a field; `number` is that of its selector."""
    branches = [([case], case_body(case)) for case in field.cases]
    return select(selector, deciding(field, number), branches, _unknown_value(naming))


def deciding(field: FieldLayout, number: Expression) -> Expression:
    """`load_u8(in + 0) & 15u`: the bits of the number of a selector that decide the type of a field."""
    bits = field.deciding_bits
    return number if bits is None else number & unsigned(bits)


def _unknown_value(naming: Naming) -> Body:
    return (Return(naming.status("err_unknown_value")),)


def select(
    selector: FieldLayout, number: Expression, branches: Iterable[tuple[list[CaseLayout], Body]], unknown: Body
) -> Switch:
    """Statements by the number of a selector, and those for a number that decides nothing."""
    value = selector.value
    assert value is not None
    labels = []
    for cases, body in branches:
        numbers = sorted(number for case in cases for number in case.numbers)
        labels.append((tuple([literal(value.encoding, own) for own in numbers]), body))
    return Switch(number, tuple(labels), unknown)
