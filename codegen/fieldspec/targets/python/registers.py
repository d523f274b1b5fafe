"""Registers and tables as constants, and the expressions of their values."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from fieldspec.codec.layout.accepted import stated_numbers
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.record import RegisterLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.foundation.names import Name
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.digits import digits_text
from fieldspec.language.model.encoding import Digits, Octets, Real, Text, Truth, Whole, bounds_of, struct_letter
from fieldspec.language.model.primitives import Primitive
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.registers import Table
from fieldspec.language.model.text_form import text_form_title
from fieldspec.language.model.value import Value
from fieldspec.targets.fact_texts import described
from fieldspec.targets.pieces import facts_of, piece, register_runs
from fieldspec.targets.python.naming import Scope
from fieldspec.targets.python.scaling import quantity, ratio
from fieldspec.targets.python.slots import Words
from fieldspec.targets.python.text import docstring, literal
from fieldspec.targets.python.writing import (
    bounded_bits,
    digits_letters,
    interval_text,
    pairs,
    real_word,
    text_letters,
    tuple_of,
)


def register_value(value: Value, order: str, swapped: bool, words: Words, trigger: bool) -> str:
    """The `Value` of a register or a parameter: every answer of the device is read.

    Only writing is limited to a constant, or, where it starts an action, to the members of a closed enum.
    """
    answer = value.as_answer(trigger)
    is_default = value.write_ranges is None and value.const is None and not trigger
    stated = "" if is_default else f"stated={tuple_of(stated_arguments(words, answer, trigger))}"
    return _value(value, order, swapped, words, answer != value, stated)


def value_expression(value: Value, order: str, swapped: bool, words: Words) -> str:
    """The `Value` of a value in a frame."""
    return _value(value, order, swapped, words, False)


def stated_arguments(words: Words, value: Value, trigger: bool = False) -> list[str]:
    """The intervals of what is read, and the fields of bits with a range, as `state_of` takes them."""
    numbers = stated_numbers(words.device, value, trigger)
    if numbers is None:
        return []
    intervals = tuple_of(f"({low}, {high})" for low, high in numbers.intervals)
    return [intervals, *bounded_bits(numbers.bits)]


def _value(value: Value, order: str, swapped: bool, words: Words, any_answer: bool, stated: str = "") -> str:
    encoding = value.encoding
    letters = (">" if (order == "big") != swapped else "<") + number_letter(value.type)
    arguments = ["swapped=True"] if swapped else []
    match encoding:
        case Text():
            if value.text_form is not None:
                return f'_FormedText("{value.size}s", {value.size}, {literal(text_letters(value, order))})'
            return f'_Text("{value.size}s", {value.size})'
        case Octets():
            return f'{"_MarkedBytes" if value.is_marked else "_Bytes"}("{value.image_size}s", {value.size})'
        case Truth():
            return _call("_Boolean", literal(letters), arguments)
        case Real():
            arguments += [f"ranges={pairs(value.ranges)}"] if value.ranges is not None else []
            arguments += [stated] if stated and value.ranges is not None else []
            arguments += [f"absent={absent_states(value)}"] if value.sentinels else []
            arguments += (
                [f"unit={literal(value.unit)}"] if value.unit and (value.sentinels or value.ranges is not None) else []
            )
            return _call(f"_{real_word(encoding.precision).title()}", literal(letters), arguments)
        case Whole():
            return _count(value, literal(letters), arguments, words, any_answer, stated)
        case Digits():
            return _count(value, literal(digits_letters(value, order, swapped)), arguments, words, any_answer, stated)
        case _:
            assert_never(encoding)


def number_letter(type: Primitive) -> str:
    """The letter of `struct` for a number, or the name of its type where it has none."""
    return "H" if type.name == BIT else struct_letter(type.encoding) or type.name


def _count(value: Value, letters: str, arguments: list[str], words: Words, any_answer: bool, stated: str) -> str:
    """The `Value` of a whole number."""
    if value.const is not None:
        if not any_answer:
            return _call("_Constant", letters, [str(value.const), *arguments])
        further = [stated] if stated not in ("", _NOTHING_STATED) else []
        return _call("_Setting", letters, [str(value.const), *arguments, *further])
    ranges = _ranges(value)
    if ranges is not None and value.flags:
        special = [interval for interval in value.special_intervals if not ranges.includes(*interval)]
        ranges = Ranges((*ranges.intervals, *special))
    if ranges is not None:
        arguments.append(f"ranges={pairs(ranges)}")
    has_limits = ranges is not None or bool(words.bounded(value.flags))
    is_trigger = any_answer and bool(value.enum) and not words.enums[value.enum].open
    arguments += [stated] if stated and not is_trigger and (has_limits or stated != _NOTHING_STATED) else []
    if value.flags:
        arguments += [f"absent={absent_states(value)}"] if value.sentinels else []
        arguments += [f"bits={bits}" for bits in bounded_bits(words.bounded(value.flags))]
        return _call("_Word", letters, [words.flags[value.flags], *arguments])
    if value.sentinels:
        arguments.append(f"absent={absent_states(value)}")
    if value.enum:
        enum = words.enums[value.enum]
        if is_trigger:
            return _call("_Trigger", letters, [literal(enum.title), enum.table, *arguments])
        if not enum.open and value.sentinels:
            arguments.append("closed=True")
        return _call(
            "_Open" if enum.open or value.sentinels else "_Closed",
            letters,
            [literal(enum.title), enum.table, *arguments],
        )
    if value.quantity_unit:
        arguments.append(f"unit={literal(value.quantity_unit)}")
    if value.scaled:
        arguments.append(f"ratio={ratio(value)}")
    return _call("_Number", letters, arguments)


def absent_states(value: Value) -> str:
    """The sentinels as a tuple of names and numbers: `(("error", range(65024, 65280)), ("not_measured", 65535))`"""
    nan = f"float({literal('nan')})"
    return tuple_of(
        f"({literal(sentinel.name)}, {nan if sentinel.is_nan else interval_text(sentinel.interval)})"
        for sentinel in value.sentinels
    )


def _call(name: str, letters: str, arguments: list[str]) -> str:
    return f"{name}({', '.join([letters, *arguments])})"


def _ranges(value: Value) -> Ranges | None:
    ranges = value.writable_ranges
    return None if ranges is None or ranges.intervals == (bounds_of(value.encoding),) else ranges


def value_facts(value: Value) -> list[str]:
    """The facts of a value in a docstring: scale and unit, ranges, special values, initial value."""
    facts = [digits_text(value)] if value.digits else []
    facts += [text_form_title(value)] if value.text_form is not None else []
    facts += [f"at most {value.width} bytes"] if value.width and not value.digits else []
    facts += [quantity(value)] if quantity(value) else []
    if value.ranges is not None:
        facts.append(value.ranges.text())
    if value.write_ranges is not None:
        facts.append(f"{value.write_ranges.text()} when it is written")
    facts += [f"the {value.write_order_text}"] if value.write_word_order else []
    facts += [f"{sentinel.text} = {Name.of(sentinel.name).title().lower()}" for sentinel in value.sentinels]
    if value.default is not None:
        facts.append(f"initially {value.default}")
    return facts


_NOTHING_STATED = "stated=()"
"""The argument of a value of which nothing is stated that is read."""

ACCESS = {"ro": "read only", "rw": "read and write", "wo": "write only"}


@dataclass(frozen=True, slots=True)
class RegisterView:
    """A register, or an array of them: its constant, the call that creates it, and its docstring."""

    name: str
    call: str
    doc: list[str]


@dataclass(frozen=True, slots=True)
class TableView:
    """A table: its variable, its class, and the arguments of the class."""

    name: str
    type: str
    record: str
    arguments: str
    doc: list[str]


def register_views(
    layout: DeviceLayout, words: Words, scope: Scope, space: Callable[[str], str]
) -> tuple[list[RegisterView], list[RegisterView]]:
    """The views of all registers in the order of the spec, and in the order in which a module can state them.

    A register refers to the one with its exponent, which must therefore be stated before. `space` gives the name of the
    space of a register.
    """
    names = {row.name: scope.take(Name.of(row.name).upper()) for row in layout.registers}
    views = {
        view_name: view
        for run, facts in register_runs(layout)
        for view_name, view in _run_views(layout, run, facts, words, names, space)
    }
    exponents = {row.register.value.scale_by for row in layout.registers}
    stated = sorted(views, key=lambda name: name not in exponents)
    return list(views.values()), [views[name] for name in stated]


def _run_views(
    layout: DeviceLayout,
    run: Sequence[RegisterLayout],
    facts: tuple[object, ...],
    words: Words,
    names: Mapping[str, str],
    space: Callable[[str], str],
) -> tuple[tuple[str, RegisterView], ...]:
    """The views of a few registers by their names, and all that the views refer to."""
    values = [row.register.value for row in run]
    facts = (*facts, *[words.enums.get(value.enum) for value in values])
    referred = [(names.get(value.scale_by), words.flags.get(value.flags)) for value in values]
    own = [(names[row.name], space(row.register.space)) for row in run]

    def make() -> tuple[tuple[str, RegisterView], ...]:
        return tuple(
            [(row.name, _remembered_view(layout, row, words, names, space(row.register.space))) for row in run]
        )

    return piece("python registers", facts, (layout.device.byte_order, *referred, *own), make)


def _remembered_view(
    layout: DeviceLayout, row: RegisterLayout, words: Words, names: Mapping[str, str], space: str
) -> RegisterView:
    value, order = row.register.value, layout.device.byte_order
    facts = (row.register, *facts_of(layout.device, value), words.enums.get(value.enum))
    referred = names[row.name], names.get(value.scale_by), words.flags.get(value.flags)
    make = partial(register_view, row, words, order, names, space)
    return piece("python register", facts, (*row.numbers, order, space, *referred), make)


def register_view(
    layout: RegisterLayout, words: Words, order: str, names: Mapping[str, str], space: str = ""
) -> RegisterView:
    """The view of a register, or of an array of registers.

    `order` is the byte order of the device, `names` the constants of all registers by name, `space` the address space
    where the device has several.
    """
    register = layout.register
    name = names[layout.name]
    is_bit = register.value.type.name == BIT
    value = register_value(register.value, layout.order, layout.swapped, words, register.trigger)
    if layout.size > register.value.size and not is_bit:
        value = f"_Filled({value})"
    arguments = [literal(layout.name), f"0x{layout.address:04X}", str(layout.words), value, literal(register.access)]
    if layout.count > 1:
        arguments += [f"count={layout.count}", f"first={register.index_from}", f"stride={layout.stride}"]
    arguments += [
        f"{key}=True" for key, is_set in (("atomic", register.atomic), ("trigger", register.trigger)) if is_set
    ]
    arguments += [f"number={register.number}"] if register.number is not None else []
    arguments += [f"copy_of={literal(register.copy_of)}"] if register.copy_of else []
    if register.unit_size == 1:
        arguments.append("unit_size=1")
    if register.value.write_word_order:
        arguments.append("turns_writes=True")
    if register.value.scale_by:
        arguments.append(f"scale_by={names[register.value.scale_by]}")
    if order == "little":
        arguments.append('order="<"')
    if space:
        arguments.append(f"space={literal(space)}")
    unit = "word" if register.unit_size > 1 else "byte"
    facts = [
        f"0x{layout.address:04X}",
        *([f"in {space}"] if space else []),
        "1 bit" if is_bit else f"{layout.words} {unit}{'s' if layout.words > 1 else ''}",
    ]
    if register.access:
        facts.append(ACCESS[register.access])
    facts += [] if is_bit else [register.value.type.name]
    facts += value_facts(register.value)
    if register.restart:
        facts.append("takes effect after a restart")
    if register.atomic:
        facts.append(f"all {unit}s in one request")
    if register.trigger:
        facts.append("writing starts an action")
    if register.number is not None:
        facts.append(f"number {register.number}")
    if register.copy_of:
        facts.append(f"a copy of {Name.of(register.copy_of).upper()}")
    if register.same_as:
        facts.append(f"the same as {Name.of(register.same_as).upper()}")
    if layout.count > 1:
        last = register.index_from + layout.count - 1
        facts.append(f"{layout.count} of them, {register.index_from} to {last}")
    doc = docstring(described(Name.of(layout.name).title(), register, f"{', '.join(facts)}."))
    kind = "_Register" if layout.count == 1 else "_BitArray" if is_bit and layout.stride == 1 else "_RegisterArray"
    return RegisterView(name, f"{kind}({', '.join(arguments)})", doc)


def table_view(
    layout: TableLayout, words: Words, order: str, scope: Scope, names: Mapping[str, str], space: str = ""
) -> TableView:
    """The view of a table of records. `names` are the constants of all registers by name."""
    table = layout.table
    record = words.records[table.record]
    arguments = [
        literal(layout.name),
        record,
        f"base=0x{table.base:04X}",
        f"words={layout.words}",
        f"stride={table.stride}",
        f"count={table.count}",
        f"first={table.index_from}",
    ]
    access = table.access if layout.writable else "ro"
    if access:
        arguments.append(f"access={literal(access)}")
    if order == "little":
        arguments.append('order="<"')
    if space:
        arguments.append(f"space={literal(space)}")
    if table.count_by:
        arguments.append(f"count_by={names[table.count_by]}")
    if table.base_by:
        arguments.append(f"base_by={names[table.base_by]}")
    last = table.index_from + table.count - 1
    count_text = f"up to {table.count}, as {names[table.count_by]} says," if table.count_by else str(table.count)
    facts = [
        f"{count_text} records of {layout.words} words, {table.index_from} to {last}",
        f"the first {_base_text(table, names)}, each {table.stride} words after the one before",
    ]
    if space:
        facts.append(f"in {space}")
    if table.access:
        facts.append(ACCESS[table.access])
    if layout.read_only:
        facts.append(f"none as a whole, as these fields are read only: {', '.join(layout.read_only)}")
    doc = docstring(described(table.title or Name.of(table.name).title(), table, f"{', '.join(facts)}."), 4)
    name = scope.take(layout.name)
    return TableView(name, scope.take(f"{Name.of(layout.name).pascal()}Table"), record, ", ".join(arguments), doc)


def _base_text(table: Table, names: Mapping[str, str]) -> str:
    """The address of the first element, or the register that has it."""
    base = f"where {names[table.base_by]} says, usually " if table.base_by else ""
    return f"{base}at 0x{table.base:04X}"
