"""Records, and the data of messages, as classes."""

from __future__ import annotations

from dataclasses import dataclass

from fieldspec.backends.python.lines import chained, filled, listed, shown, unpacked
from fieldspec.backends.python.naming import MESSAGE, TYPES, Scope
from fieldspec.backends.python.reading import indexed, local, reading, targets
from fieldspec.backends.python.slots import Slots, Words, native_order, slots
from fieldspec.backends.python.text import described, docstring, printed, sentence
from fieldspec.backends.python.units import in_unit, quantity, ratio, unit_word
from fieldspec.backends.python.writing import conditions, fixed, measured, pairs, refusal, values, within
from fieldspec.layout.record import RecordLayout
from fieldspec.names import Name


@dataclass(frozen=True, slots=True)
class FieldView:
    """An attribute: its name and type."""

    name: str
    type: str


@dataclass(frozen=True, slots=True)
class ScaledView:
    """A property in the unit: the expressions that read and set it, and its docstring."""

    name: str
    type: str
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


@dataclass(frozen=True, slots=True)
class RecordShape:
    """A record's fields in a Struct of one byte order, before any name of the module is given."""

    record: RecordLayout
    order: str
    fields: tuple[Slots, ...]

    @property
    def sign(self) -> str:
        """The first letter of its Struct."""
        return ">" if self.order == "big" else "<"

    @property
    def tail(self) -> Slots | None:
        """The field that is repeated to the end."""
        return self.fields[-1] if self.fields and self.fields[-1].repeated else None

    @property
    def letters(self) -> str:
        """The letters of all fields but the repeated one."""
        return "".join(field.letters * field.count for field in self.fields)

    @property
    def stored(self) -> list[Slots]:
        """The fields that are attributes."""
        return [field for field in self.fields if field.stored]


@dataclass(frozen=True, slots=True)
class RecordView:
    """A class: all lines of its methods are computed. `size` is empty where it varies."""

    name: str
    struct: str
    format: str
    element: str
    title: str
    size: str
    length_test: str
    wrong_length: str
    doc: list[str]
    fields: list[FieldView]
    constants: list[ConstantView]
    scaled: list[ScaledView]
    unpack: list[str]
    make: list[str]
    bind: list[str]
    tests: list[str]
    pack: list[str]
    refusals: list[str]
    slots: list[str]
    match_args: list[str]
    init: list[str]
    equal: list[str]
    shown: list[str]


def shape(record: RecordLayout, words: Words, reserved: frozenset[str]) -> RecordShape:
    """The shape of a record; its attributes stay clear of some names."""
    scope = Scope(reserved, TYPES)
    order = native_order(record.fields)
    return RecordShape(
        record, order, tuple(slots(field, scope.take(field.name), words, order) for field in record.fields)
    )


def record_view(shaped: RecordShape, name: str, doc: list[str]) -> RecordView:
    """The view of a record's class."""
    record, stored = shaped.record, shaped.stored
    upper = "_" + "".join(f"_{char}" if char.isupper() else char for char in name).strip("_").upper()
    tail, struct = shaped.tail, f"{upper}_STRUCT"
    fixed_size = sum(field.field.size * field.count for field in shaped.fields)
    unit = tail.field.size if tail else 1
    binding = writing_lines(shaped, frozenset())
    names = [field.name for field in stored]
    unpack, taken = unpacking_lines(shaped, "record", _unpacked(shaped, struct, fixed_size, unit), 8 if tail else 12)
    bounds = f"{record.least}, {record.most}" + (f", {fixed_size}, {unit}" if tail else "")
    return RecordView(
        name=name,
        struct=struct,
        format=shaped.sign + shaped.letters,
        element=tail.letters if tail else "",
        title=record.name,
        size="" if tail else str(record.size),
        length_test=_length_test(record, fixed_size, unit) if tail else "",
        wrong_length=f'_wrong_length("{record.name}", len(data), {bounds})',
        doc=docstring(doc, 4),
        fields=[FieldView(field.name, field.type) for field in stored],
        constants=_sentinels(stored),
        scaled=_scaled(stored, Scope(MESSAGE, TYPES, frozenset(field.name for field in stored))),
        unpack=unpack,
        make=[*taken, *making_lines(shaped, "record", 0)],
        bind=binding.bind,
        tests=condition(binding.tests),
        pack=filled(
            f"return {struct}{f'[len({local(tail)})]' if tail else ''}.pack(",
            binding.values,
            ")",
            16 if binding.tests else 12,
        ),
        refusals=chained("return ", binding.refusals, "or", "None", 8),
        slots=_quoted("__slots__", names),
        match_args=_quoted("__match_args__", names),
        init=listed("def __init__(", ["self", *(f"{field.name}: {field.type}" for field in stored)], ") -> None:", 4),
        equal=chained("return ", [f"self.{name} == other.{name}" for name in names], "and", "True", 8),
        shown=shown(name, names, 8),
    )


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


def _unpacked(shaped: RecordShape, struct: str, fixed_size: int, unit: int) -> str:
    if shaped.tail is None:
        return f"{struct}.unpack(data)"
    length = f"len(data) - {fixed_size}" if fixed_size else "len(data)"
    number = f"({length}) // {unit}" if unit > 1 else length
    return f"{struct}[{number}].unpack(data)"


def unpacking_lines(shaped: RecordShape, owner: str, source: str, indent: int) -> tuple[list[str], list[str]]:
    """The statement that unpacks all fields, and the lines that take the raw values where it gives one tuple."""
    if sum(field.listed and not field.skipped for field in shaped.fields) < 2:
        return unpacked([target for field in shaped.fields for target in targets(field, owner)], source, indent), []
    lines: list[str] = []
    place = 0
    for field in shaped.fields:
        lines += indexed(field, owner, place)
        place += 0 if field.skipped else field.parted or field.count
    return [f"raws = {source}"], lines


def making_lines(shaped: RecordShape, owner: str, at: int, bound: bool = False) -> list[str]:
    """Lines that make the values of all fields. `bound` says that all raw values are in locals."""
    lines: list[str] = []
    for field in shaped.fields:
        lines += reading(field, owner, at + field.field.offset, bound)
    for field in shaped.fields:
        lines += _measure_test(shaped, field, owner, at)
    return lines


def _measure_test(shaped: RecordShape, field: Slots, owner: str, at: int) -> list[str]:
    measure = field.field.field.measures
    if measure is None:
        return []
    other = next(one for one in shaped.fields if one.title == measure.field)
    size = measured(field, other.field, f"{owner}.{other.name}")
    return [
        f"if {local(field)} != {size}:",
        f'    raise _wrong_measure("{field.title}", {local(field)}, {size}, {at + field.field.offset})',
    ]


@dataclass(frozen=True, slots=True)
class Writing:
    """Lines that bind locals, the conditions of all fields, what fills the slots, and what says what is wrong."""

    bind: list[str]
    tests: list[str]
    values: list[str]
    refusals: list[str]


def writing_lines(shaped: RecordShape, bound: frozenset[str]) -> Writing:
    """How a record is written; the fields in `bound` get a local whether or not the tests need one."""
    held = {field.title: f"self.{field.name}" for field in shaped.stored}
    bind: list[str] = []
    tests: dict[str, list[str]] = {}
    for field in shaped.stored:
        wanted = conditions(field, local(field))
        uses = wanted or field.title in bound or field.parted or _measures(shaped, field)
        if uses:
            bind.append(f"{local(field)} = {held[field.title]}")
            held[field.title] = local(field)
        tests[field.title] = wanted
    written: list[str] = []
    more: list[str] = []
    refusals = [refusal(field) for field in shaped.stored]
    for field in shaped.fields:
        if field.field.field.measures is not None:
            size = _size(shaped, field, held)
            if field.ranges is not None:
                more.append(within(size, field.ranges))
            refusals.append(_measure_refusal(shaped, field))
            written.append(size)
        elif field.stored:
            written += values(field, held[field.title])
        else:
            written += fixed(field)
    return Writing(bind, [test for found in tests.values() for test in found] + more, written, refusals)


def _measures(shaped: RecordShape, field: Slots) -> bool:
    measured_fields = [f.field.field.measures.field for f in shaped.fields if f.field.field.measures]
    return field.title in measured_fields


def _size(shaped: RecordShape, field: Slots, held: dict[str, str]) -> str:
    measure = field.field.field.measures
    assert measure is not None
    other = next(one for one in shaped.fields if one.title == measure.field)
    return measured(field, other.field, held[other.title])


def _measure_refusal(shaped: RecordShape, field: Slots) -> str:
    size = _size(shaped, field, {one.title: f"self.{one.name}" for one in shaped.stored})
    low, high = field.value.type.low, field.value.type.high
    ranges = pairs(field.ranges)
    return f'_refused_number("{field.title}", {size}, {low}, {high}{f", {ranges}" if ranges else ""})'


def _sentinels(stored: list[Slots]) -> list[ConstantView]:
    scope = Scope(MESSAGE)
    return [
        ConstantView(
            scope.take((Name.of(field.title) + Name.of(sentinel.name)).upper()),
            str(sentinel.value),
            docstring([sentence(f"`{field.title}`: {sentinel.doc or Name.of(sentinel.name).title()}")], 4),
        )
        for field in stored
        if field.field.value is not None
        for sentinel in field.value.sentinels
    ]


def _scaled(stored: list[Slots], scope: Scope) -> list[ScaledView]:
    found = []
    for field in stored:
        if not field.whole or not field.value.scaled or field.value.enum or field.value.flags:
            continue
        held = ratio(field.value)
        name = scope.take(f"{field.title}_{unit_word(field.value.unit)}")
        limits = pairs(field.ranges) or f"(({field.value.type.low}, {field.value.type.high}),)"
        write = f'_counts("{field.title}", {"item" if field.listed else "value"}, {held}, {limits})'
        read = in_unit("item" if field.listed else f"self.{field.name}", held)
        unit = f" in {field.value.unit}" if field.value.unit else ""
        ends = "Setting it takes the nearest count, of two the even one, and refuses what is out of range."
        found.append(
            ScaledView(
                name,
                "list[float]" if field.listed else "float",
                f"[{read} for item in self.{field.name}]" if field.listed else read,
                f"[{write} for item in value]" if field.listed else write,
                field.name,
                docstring([f"`{field.name}`{unit}. {ends}"], 8),
            )
        )
    return found


def record_doc(shaped: RecordShape, head: str, *more: str) -> list[str]:
    """The paragraphs of a class's docstring: what it is, how long, and each of its fields."""
    record = shaped.record
    if record.size is not None:
        size = f"{record.size} byte{'' if record.size == 1 else 's'}."
    else:
        size = f"{record.least} to {record.most} bytes."
    first, *rest = described(head, record.record, *more)
    return [f"{first} {size}".strip(), *rest[:-1], *map(_field_doc, shaped.stored), rest[-1]]


def _field_doc(field: Slots) -> str:
    fact = field.field.field
    facts = [_type_doc(field)]
    if field.field.value is not None:
        if quantity(field.value):
            facts.append(quantity(field.value))
        if field.value.ranges is not None:
            facts.append(f"{field.value.ranges.text()}")
        facts += [f"{sentinel.value} = {Name.of(sentinel.name).title().lower()}" for sentinel in field.value.sentinels]
        if field.value.default is not None:
            facts.append(f"initially {field.value.default}")
    if fact.restart:
        facts.append("takes effect after a restart")
    notes = " ".join(f"Note: {sentence(note)}" for note in fact.notes)
    manual = f" {printed(fact)}" if printed(fact) else ""
    return f" {field.name}{manual}: {', '.join(facts)}. {sentence(fact.doc)} {notes}".rstrip()


def _type_doc(field: Slots) -> str:
    named = field.field.record is not None or field.value.enum or field.value.flags
    one = field.element_type if named else field.value.type.name
    if field.repeated and field.field.field.repeat is not None:
        return f"{field.field.field.repeat.text()} times {one}"
    return f"{field.count} times {one}" if field.listed else one
