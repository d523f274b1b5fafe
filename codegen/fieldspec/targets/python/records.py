"""Records, and the data of messages, as classes."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.continuation import Continuation
from fieldspec.codec.layout.decision import Decision
from fieldspec.codec.layout.inner_lists import InnerList, InnerLists
from fieldspec.codec.layout.packing import Packing
from fieldspec.codec.layout.presence import PresenceLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.widths import Span
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.digits import has_sign
from fieldspec.targets.python.bit_counts import bit_count_test
from fieldspec.targets.python.constructors import ConstructorView, constructor_view
from fieldspec.targets.python.naming import MESSAGE, TYPES, Scope
from fieldspec.targets.python.presences import presence_tests
from fieldspec.targets.python.quantities import (
    ConstantView,
    ScaledView,
    StateView,
    power_views,
    scaled_views,
    sentinel_views,
    state_views,
)
from fieldspec.targets.python.reading import (
    CASE,
    ListPlace,
    cases_lines,
    choice_lines,
    decided_read,
    deferred_value_lines,
    indexed,
    local,
    reading,
    targets,
)
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.record_writing import writing_lines
from fieldspec.targets.python.slots import Slots
from fieldspec.targets.python.text import chained, docstring, filled, literal, unpacked
from fieldspec.targets.python.writing import measured, tuple_of


@dataclass(frozen=True, slots=True)
class FieldView:
    """An attribute: its name, its type, the type that it accepts, and the slot that is filled from the wire.

    `get` are the lines of its getter, empty where the slot is the attribute itself.
    """

    name: str
    type: str
    accepted: str
    slot: str
    get: list[str]


@dataclass(frozen=True, slots=True)
class RecordView:
    """A class with all lines of its methods. `declared` defines its Struct, `_Repeated` or `_Choice`."""

    name: str
    declared: list[str]
    title: str
    doc: list[str]
    fields: list[FieldView]
    constants: list[ConstantView]
    scaled: list[ScaledView]
    states: list[StateView]
    read: list[str]
    make: list[str]
    bind: list[str]
    tests: list[str]
    pack: list[str]
    refusals: list[str]
    slots: list[str]
    match_args: list[str]
    constructor: ConstructorView
    size: int | None
    image: str = ""
    image_counts: bool = False
    columns: tuple[str, ...] = ()


def record_view(shaped: RecordShape, name: str, doc: list[str]) -> RecordView:
    """The view of a record's class."""
    record, stored = shaped.record, shaped.in_sent_order
    upper = "_" + "".join(f"_{char}" if char.isupper() else char for char in name).strip("_").upper()
    cases = {field.title: _cases(upper, field) for field in shaped.fields if field.field.forms}
    binding = writing_lines(shaped, frozenset(), f"{upper}_STRUCT", cases)
    names = [field.name for field in stored]
    scope = Scope(MESSAGE, TYPES, frozenset(names))
    scaled = scaled_views(stored, scope)
    constants = Scope(MESSAGE)
    sentinels = sentinel_views(stored, constants)
    units, powers = power_views(record, stored, scope, constants, name)
    read, assignments = _read(shaped, upper)
    assignments = [*assignments, *_sent_elements(shaped, upper)]
    return RecordView(
        name=name,
        declared=_declared(shaped, upper),
        title=record.name,
        doc=docstring(doc, 4),
        fields=[
            FieldView(field.name, field.type, field.accepted, field.slot, deferred_value_lines(field))
            for field in stored
        ],
        constants=[*sentinels, *units],
        scaled=[*scaled, *powers],
        states=state_views(stored, scope, shaped),
        read=read,
        make=[*assignments, *construction_lines(shaped, "record", 0, upper=upper)],
        bind=binding.bind,
        tests=condition(binding.tests),
        pack=filled(f"return {_pack(shaped, upper)}(", binding.values, ")", 16 if binding.tests else 12),
        refusals=chained("return ", binding.refusals, "or", "None", 8),
        slots=_quoted("__slots__", [field.slot for field in stored]),
        match_args=_quoted("__match_args__", names),
        constructor=constructor_view(stored, scaled),
        size=record.size,
        image=f"{upper}_WIDTHS" if record.spans else f"{upper}_STRUCT" if record.inner_lists is not None else "",
        image_counts=record.inner_lists is not None,
    )


def _declared(shaped: RecordShape, upper: str) -> list[str]:
    letters = shaped.sign + shaped.letters
    if shaped.selector is not None:
        return choice_lines(f"{upper}_STRUCT", shaped.record, shaped.fields, letters, shaped.order)
    inner = shaped.record.inner_lists
    if inner is not None:
        cases = [
            line for field in shaped.fields if field.field.forms for line in cases_lines(_cases(upper, field), field)
        ]
        return [*cases, *inner_lists_lines(f"{upper}_STRUCT", shaped.record.name, shaped.lists, inner, letters)]
    if shaped.tail is not None:
        return [f"{upper}_STRUCT = _Repeated({literal(letters)}, {literal(shaped.tail.letters)})"]
    packing = filled(f"{upper}_PACK, {upper}_UNPACK = _packing(", [literal(letters)], ")", 0)
    return [*packing, *_widths(shaped.record, upper)]


def _cases(upper: str, field: Slots) -> str:
    """The variable of the types of a field that another one decides."""
    return f"{upper}_{field.name.upper()}_CASES"


def _widths(record: RecordLayout, upper: str) -> list[str]:
    """The definition of the fields of a record whose values vary in width; nothing for others."""
    if not record.spans:
        return []
    fields = [f"({literal(span.name)}, {_width(span)})" for span in record.spans]
    counts = [
        f'{number}: ({span.count}, {record.spans[span.count].size}, "{span.order}", {span.plus})'
        for number, span in enumerate(record.spans)
        if span.count is not None
    ]
    options = [f"counts={{{', '.join(counts)}}}"] if counts else []
    return filled(f"{upper}_WIDTHS = _Widths(", [literal(record.name), *fields, *options], ")", 0)


def _width(span: Span) -> str:
    """The bytes of a field, or what the runtime knows of a value that varies in width."""
    value = span.value
    if value is None:
        return str(span.size)
    end = "-" if span.end is None else str(span.end)
    return literal(f"{value.digits or 'text'} {value.width} {value.places} {'+' if has_sign(value) else '-'} {end}")


def _pack(shaped: RecordShape, upper: str) -> str:
    """The `pack` for the number of elements."""
    last = shaped.fields[-1] if shaped.fields else None
    number = f"len({local(last)})" if last is not None and last.is_list else "1"
    if shaped.selector is not None:
        return f"{CASE}.structs[{number}].pack"
    if shaped.record.inner_lists is not None:
        numbers = ", ".join(f"len({local(field)})" if field.is_list else "1" for field in shaped.lists)
        return f"{upper}_STRUCT[{numbers}{',' * (len(shaped.lists) == 1)}].pack"
    return f"{upper}_STRUCT[{number}].pack" if shaped.tail is not None else f"{upper}_PACK"


def _read(shaped: RecordShape, upper: str) -> tuple[list[str], list[str]]:
    """Lines that create an empty `record` and unpack the bytes, and lines that take the raw values from a tuple."""
    record, tail, struct = shaped.record.image, shaped.tail, f"{upper}_STRUCT"
    new_record, bounds = "record = _new(cls)", f"{record.least}, {record.most}"
    wrong = f"    raise _wrong_length({literal(record.name)}, len(data), {bounds}"
    if shaped.selector is not None:
        lines, assignments = unpacking_lines(shaped, "record", f"{struct}.unpack(data)", 8)
        return [new_record, *lines], assignments
    if shaped.record.inner_lists is not None:
        lines, assignments = unpacking_lines(shaped, "record", f"{struct}[counts].unpack(data)", 8)
        return [new_record, *lines], assignments
    if tail is None:
        lines, assignments = unpacking_lines(shaped, "record", f"{upper}_UNPACK(data)", 12)
        tried = [f"    {line}" for line in lines]
        return [new_record, "try:", *tried, "except _StructError:", f"{wrong}) from None"], assignments
    fixed_size, unit = sum(field.field.size * field.count for field in shaped.fields), tail.field.size
    lines, assignments = unpacking_lines(shaped, "record", _unpacked(struct, fixed_size, unit), 8)
    test = f"if {_length_test(record, fixed_size, unit)}:"
    return [test, f"{wrong}, {fixed_size}, {unit})", new_record, *lines], assignments


def _sent_elements(shaped: RecordShape, upper: str) -> list[str]:
    """Lines that take what is sent of the records that differ in size, of which the image has all bytes."""
    lines = []
    for number, inner in enumerate(shaped.record.inner_lists.lists if shaped.record.inner_lists is not None else ()):
        field = next(field for field in shaped.lists if field.title == inner.name)
        if inner.parts is not None and field.field.record is not None and field.field.record.size is None:
            raws = local(field) if field.is_list else f"({local(field)},)"
            lines.append(f"{raws} = {upper}_STRUCT.elements({number}, {raws})")
    return lines


def _quoted(variable: str, names: list[str]) -> list[str]:
    if len(names) == 1:
        return [f'{variable} = ("{names[0]}",)']
    return filled(f"{variable} = (", [f'"{name}"' for name in names], ")", 4)


def condition(tests: list[str]) -> list[str]:
    """The head of an `if` whose conditions must all hold; nothing where there are none."""
    if not tests:
        return []
    *lines, last = chained("if ", tests, "and", "", 12)
    return [*lines, f"{last}:"]


def _length_test(record: RecordLayout, fixed_size: int, unit: int) -> str:
    test = f"not {record.least} <= len(data) <= {record.most}"
    return f"{test} or (len(data) - {fixed_size}) % {unit}" if unit > 1 else test


def _unpacked(struct: str, fixed_size: int, unit: int) -> str:
    length = f"len(data) - {fixed_size}" if fixed_size else "len(data)"
    number = f"({length}) // {unit}" if unit > 1 else length
    return f"{struct}[{number}].unpack(data)"


def unpacking_lines(shaped: RecordShape, owner: str, source: str, indent: int) -> tuple[list[str], list[str]]:
    """The statement that unpacks all fields, and the lines that take the raw values where it returns one tuple."""
    case = f"{CASE}, " if shaped.selector is not None else ""
    if sum((field.is_list or field.splits) and not field.skipped for field in shaped.fields) < 2:
        names = [target for field in shaped.fields for target in targets(field, owner)]
        if case:
            return [f"{case}raws = {source}", *unpacked(names, "raws", indent)], []
        return unpacked(names, source, indent), []
    lines: list[str] = []
    place = ListPlace(0, 0, len(shaped.lists))
    for field in shaped.fields:
        lines += indexed(field, owner, place)
        place = place.behind(field)
    return [f"{case}raws = {source}"], lines


def construction_lines(shaped: RecordShape, owner: str, offset: int, bound: bool = False, upper: str = "") -> list[str]:
    """Lines that convert the raw values of all fields.

    `bound` says that all raw values are in locals, and that the constants among them have been compared. The names of
    what the module has for the record begin with `upper`.
    """
    lines: list[str] = []
    for field in shaped.fields:
        if bound and field.constant is not None:
            continue
        place = offset + field.field.offset
        selector = shaped.selector_of(field)
        if field.splits:
            lines += decided_read(field, owner, place)
        elif selector is not None:
            arguments = f"{literal(field.title)}, {local(selector)}, {local(field)}, {place}"
            lines.append(f"{owner}.{field.name} = {_cases(upper, field)}.decoded({arguments})")
        else:
            lines += reading(field, owner, place, bound)
    for field in shaped.fields:
        lines += _measure_test(shaped, field, owner, offset)
    return [*lines, *presence_tests(shaped, owner, offset)]


def constant_tests(shaped: RecordShape) -> list[str]:
    """The conditions under which a constant, whose raw value is in a local, is another number."""
    return [f"{local(field)} != {field.constant}" for field in shaped.fields if field.constant is not None]


def _measure_test(shaped: RecordShape, field: Slots, owner: str, offset: int) -> list[str]:
    if field.field.bits_of:
        packed = next(other for other in shaped.fields if other.title == field.field.bits_of)
        return bit_count_test(field, f"{owner}.{field.name}", f"{owner}.{packed.name}", offset + field.field.offset)
    measure = field.field.measure
    if measure is None:
        return []
    other = next(candidate for candidate in shaped.fields if candidate.title == measure.field)
    size = measured(field, other, f"{owner}.{other.name}", f"{CASE}.size")
    return [
        f"if {local(field)} != {size}:",
        f'    raise _wrong_measure("{field.title}", {local(field)}, {size}, {offset + field.field.offset})',
    ]


def inner_lists_lines(variable: str, name: str, lists: Sequence[Slots], inner: InnerLists, letters: str) -> list[str]:
    """The definition of the lists of a record, in the order of the wire; `letters` are the letters of
    all other fields.
    """
    by_name = {field.title: field for field in lists}
    rows = [_inner_list_row(own, by_name[own.name].letters) for own in inner.lists]
    return filled(f"{variable} = _InnerLists(", [literal(name), literal(letters), *rows], ")", 0)


def _inner_list_row(inner: InnerList, letters: str = "") -> str:
    """`_InnerList("H", 2, (0, 4), 2, 7)`: see the class."""
    bounds = (inner.least // inner.element, inner.most // inner.element)
    order = literal(inner.count_order)
    count = f", ({inner.count_at}, {inner.count_size}, {order}, {inner.unit}, {inner.plus})" if inner.count else ""
    parts = f", parts={_parts(inner.parts)}" if inner.parts is not None else ""
    decision = f", decision={_decision(inner.decision)}" if inner.decision is not None else ""
    packing = f", packing={_packing(inner.packing)}" if inner.packing is not None else ""
    presence = f", presence={_presence(inner.presence)}" if inner.presence is not None else ""
    sent_plus = f", sent_plus={inner.sent_plus}" if inner.sent_plus is not None else ""
    continuation = f", continuation={_more(inner.continuation)}" if inner.continuation is not None else ""
    places = f"{inner.first}, {inner.room}{count}"
    options = f"{parts}{decision}{packing}{presence}{sent_plus}{continuation}"
    return f"_InnerList({literal(letters)}, {inner.element}, {bounds}, {places}{options})"


def _more(continuation: Continuation) -> str:
    """`_More(0, 1, "big", 128, (128,))`: what an element says of the next one."""
    presence = continuation.presence
    place = f"{continuation.offset}, {continuation.size}, {literal(continuation.order)}"
    return f"_More({place}, {presence.mask}, {tuple_of(presence.numbers)})"


def _presence(presence: PresenceLayout) -> str:
    """`(8, (8,))`: the bits of a number that say whether the only element is sent, and with which numbers it is; none
    if the bits have the count.
    """
    return f"({presence.mask}, {tuple_of(presence.numbers)})"


def _packing(packing: Packing) -> str:
    """`_Packing(12, 2, "big")`: how the numbers of a list follow each other in bits."""
    signed = ", signed=True" if packing.number.sign.is_signed else ""
    return f"_Packing({packing.number.bits}, {packing.size}, {literal(packing.order)}{signed})"


def _decision(decision: Decision) -> str:
    """`_Decision("kind", 0, 1, "big", {1: 2})`: what decides the size of the only element."""
    place = f"{decision.offset}, {decision.size}, {literal(decision.order)}"
    mask = f", {decision.mask}" if decision.mask is not None else ""
    marked = f", marked={tuple_of(map(str, sorted(decision.marked)))}" if decision.marked else ""
    return f"_Decision({literal(decision.name)}, {place}, {dict(decision.sizes)}{mask}{marked})"


def _parts(parts: InnerLists) -> str:
    """`_Parts(3, _InnerList(...))`: what tells the size of an element."""
    return f"_Parts({', '.join([str(parts.fixed), *map(_inner_list_row, parts.lists)])})"
