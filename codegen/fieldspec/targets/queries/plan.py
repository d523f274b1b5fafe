"""The queries of a device: one for each record, message, group of registers, table and set of parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.nested_fields import nested_fields
from fieldspec.codec.layout.record import Orders, RecordLayout, RegisterLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import Name
from fieldspec.foundation.reserved import PYTHON
from fieldspec.language.model.address_space import BIT, WORD
from fieldspec.language.model.registers import Parameter, ParameterSet, RegisterGroup, Subindex
from fieldspec.targets.fact_texts import sentence
from fieldspec.targets.queries.content import Content, size_refusals, tail_of
from fieldspec.targets.queries.dialect import Dialect
from fieldspec.targets.queries.values import ValueQuery

DATA = "data"
"""The intermediate result with the bytes of a record."""


@dataclass(frozen=True, slots=True)
class Query:
    """A query: its name, what it decodes, and how. `arguments` are the columns that it reads.

    `elements` are the numbers of the elements of a table, which has one row for each that the payload has. A query is
    `judged` where a codec may refuse the payload.
    """

    name: str
    title: str
    arguments: tuple[str, ...]
    content: Content
    elements: range | None = None
    judged: bool = True


_USED = """
annotations bool dict float identity int isinstance list next payload_of range reversed str tuple
"""
"""The names that the modules of expressions and the files of macros use themselves."""


class Names:
    """The names of the queries of a device and of its enums, the same in all languages."""

    def __init__(self, enums: Iterable[str]) -> None:
        self._taken = {*PYTHON, *_USED.split()}
        self.enums = {
            enum: self.take(f"{Name.of(enum).snake()}_name", f"{Name.of(enum).snake()}_member") for enum in enums
        }

    def take(self, name: str, other: str) -> str:
        """The first free name of both; where none is free, the second one with underscores."""
        if name in self._taken:
            name = other
        while name in self._taken or f"{name}_findings" in self._taken:
            name += "_"
        self._taken |= {name, f"{name}_findings"}
        return name


def queries(
    layout: DeviceLayout, names: Names, enums: dict[str, str], dialect_for: Callable[[Sequence[int]], Dialect]
) -> Iterator[Query]:
    """All queries of a device. `dialect_for` makes the dialect for a record with the result of `cuts_of`."""
    for record in layout.records.values():
        name = names.take(Name.of(record.name).snake(), f"{Name.of(record.name).snake()}_record")
        title = sentence(record.record.label) or f"The record {record.name}."
        yield _record_query(layout, name, title, record, enums, dialect_for)
    for message in layout.messages.values():
        for direction, record in (("request", message.request), ("response", message.response)):
            if direction not in message.message.directions:
                continue
            own = f"{Name.of(message.name).snake()}_{direction}"
            title = f"{message.message.title or Name.of(message.name).title()}: the data of the {direction}."
            yield _record_query(layout, names.take(own, f"{own}_data"), title, record, enums, dialect_for)
    for group in layout.device.groups:
        name = names.take(Name.of(group.name).snake(), f"{Name.of(group.name).snake()}_registers")
        yield _group_query(layout, name, group, Content(layout.device, dialect_for(()), enums))
    for table in layout.tables.values():
        name = names.take(Name.of(table.name).snake(), f"{Name.of(table.name).snake()}_table")
        yield _table_query(layout, name, table, Content(layout.device, dialect_for(()), enums))
    for parameters in layout.device.parameters.values():
        name = names.take(Name.of(parameters.name).snake(), f"{Name.of(parameters.name).snake()}_parameters")
        yield _parameter_query(layout, name, parameters, Content(layout.device, dialect_for(()), enums))


def cuts_of(record: RecordLayout) -> tuple[int, ...]:
    """The places where the fields of a record begin, and its size; none for a record whose size varies."""
    if record.size is None or record.selector is not None:
        return ()
    return (*sorted({0, *(own.offset for own in record.fields)}), record.size)


def _record_query(
    layout: DeviceLayout,
    name: str,
    title: str,
    record: RecordLayout,
    enums: dict[str, str],
    dialect_for: Callable[[Sequence[int]], Dialect],
) -> Query:
    content = Content(layout.device, dialect_for(cuts_of(record)), enums)
    dialect = content.dialect
    data = dialect.step(DATA)
    content.levels.append({data: dialect.sized("payload", record.least, record.most, *tail_of(record))})
    content.refusals.extend(size_refusals(dialect, record, "payload"))
    content.add_record(record, data)
    return Query(name, title, ("payload",), content)


def _group_query(layout: DeviceLayout, name: str, group: RegisterGroup, content: Content) -> Query:
    registers = {register.name: register for register in layout.registers}
    level: dict[str, str] = {}
    content.levels.append(level)
    is_bits = layout.device.space(group.space).unit == BIT
    for register in group.registers:
        own = registers[register.name]
        for number in range(own.count):
            suffix = f"_{number + register.index_from}" if own.count > 1 else ""
            address = own.address + number * own.stride
            column = f"{Name.of(own.name).snake()}{suffix}"
            if is_bits:
                if not register.reserved:
                    content.add_column(column, content.dialect.single_bit(address))
                continue
            exponent = registers.get(register.value.scale_by)
            _add_register(content, own, column, address, level, exponent)
    unit = layout.device.space(group.space).unit
    kind = "registers" if unit == WORD else f"{unit}s"
    title = f"{group.title or Name.of(group.name).title()}: {kind} in a payload from the address `start` on."
    return Query(name, title, ("start", "payload"), content, judged=False)


def _add_register(
    content: Content,
    own: RegisterLayout,
    column: str,
    address: int,
    level: dict[str, str],
    exponent: RegisterLayout | None,
) -> None:
    query, data = _register_query(content, own, address, level)
    if exponent is not None and exponent.register.value.ranges is not None:
        power, words = _register_query(content, exponent, exponent.address, level)
        number = power.number(words, 0)
        query = replace(query, exponent=lambda _, __: number, exponents=exponent.register.value.ranges.intervals)
    content.add_value(column, query, data, 0, reserved=own.register.reserved)


def _register_query(
    content: Content, own: RegisterLayout, address: int, level: dict[str, str]
) -> tuple[ValueQuery, str]:
    """The query of the value of a register at an address, and the name of its bytes, which become a step."""
    value = own.register.answer
    words = content.dialect.words(str(address), value.size, own.register.unit_size)
    data = next((name for name, known in level.items() if known == words), "")
    if not data:
        data = content.dialect.step(f"{DATA}_{len(level)}")
        level[data] = words
    own_query = ValueQuery(content.device, content.dialect, content.enums, value, own.order, own.swapped)
    return replace(own_query, trigger=own.register.trigger), data


def _table_query(layout: DeviceLayout, name: str, table: TableLayout, content: Content) -> Query:
    dialect, own = content.dialect, table.table
    data = dialect.step(DATA)
    number = dialect.argument(dialect.step("element") if dialect.step("element") != "element" else "element")
    address = f"(({number} - {own.index_from}) * {own.stride} + {own.base})"
    level = {data: dialect.words(address, table.record.size or 0)}
    content.levels.append(level)
    values = (nested.field.value for nested in nested_fields(table.record))
    names = {value.scale_by for value in values if value is not None}
    for register in layout.registers:
        if register.name in names:
            power, words = _register_query(content, register, register.address, level)
            content.exponents[register.name] = power.number(words, 0)
    content.add_record(table.record, data)
    title = f"{own.title or Name.of(own.name).title()}: the elements in a payload from the address `start` on."
    return Query(name, title, ("start", "payload"), content, range(own.index_from, own.index_from + own.count))


def _parameter_query(layout: DeviceLayout, name: str, parameters: ParameterSet, content: Content) -> Query:
    level: dict[str, str] = {}
    content.levels.append(level)
    for parameter in parameters.parameters:
        own = Name.of(parameter.name).snake() if parameter.name else f"parameter_{parameter.number}"
        first = parameters.base + parameter.number
        is_parameter = content.dialect.is_in(content.dialect.argument("number"), [(first, first + parameter.count - 1)])
        covered = [interval for inner in parameter.subindices for interval in inner.indices.intervals]
        subindex = content.dialect.argument("subindex")
        if covered:
            elsewhere = content.dialect.negated(content.dialect.is_in(subindex, covered))
            own_condition = content.dialect.both(is_parameter, elsewhere)
        else:
            own_condition = is_parameter
        if not parameter.reserved:
            _add_parameter(layout, content, own, parameter, parameter.trigger, own_condition, level)
        for inner in parameter.subindices:
            is_subindex = content.dialect.is_in(subindex, list(inner.indices.intervals))
            if not inner.reserved and not parameter.reserved:
                name_of_inner = f"{own}_{Name.of(inner.name).snake() or inner.indices.low}"
                own_condition = content.dialect.both(is_parameter, is_subindex)
                _add_parameter(layout, content, name_of_inner, inner, parameter.trigger, own_condition, level)
    title = f"{parameters.title or Name.of(parameters.name).title()}: the value of the parameter with a `number`."
    arguments = ("number", "subindex", "payload")
    return Query(name, title, arguments, content, judged=False)


def _add_parameter(
    layout: DeviceLayout,
    content: Content,
    column: str,
    fact: Parameter | Subindex,
    trigger: bool,
    condition: str,
    level: dict[str, str],
) -> None:
    dialect, value = content.dialect, fact.value
    data = dialect.step(f"{DATA}_{len(level)}")
    is_whole = dialect.compared(dialect.size("payload"), "=", str(value.size))
    level[data] = dialect.chosen("payload", dialect.both(condition, is_whole))
    orders = Orders(layout.device.byte_order, layout.device.word_order)
    answer = value.as_answer(trigger)
    query = ValueQuery(content.device, dialect, content.enums, answer, *orders.of(value), trigger=trigger)
    content.add_value(column, query, data, 0)
