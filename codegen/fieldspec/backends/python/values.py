"""The expressions that make the `Value` of a register or a parameter."""

from __future__ import annotations

from fieldspec.backends.python.slots import Words
from fieldspec.backends.python.text import literal
from fieldspec.backends.python.units import quantity, ratio
from fieldspec.backends.python.writing import pairs, tuple_of
from fieldspec.model.primitive import Kind
from fieldspec.model.ranges import Ranges
from fieldspec.model.value import Value
from fieldspec.names import Name


def register_value(value: Value, size: int, order: str, swapped: bool, words: Words, trigger: bool) -> str:
    """The `Value` of a register or a parameter, in `size` bytes: what the device answers is read, whatever it is.

    Only what is written is bound to a constant, and, where it starts something, to a closed enum.
    """
    return _value(value, size, order, swapped, words, value.as_answer(trigger) != value)


def value_expression(value: Value, size: int, order: str, swapped: bool, words: Words) -> str:
    """The `Value` of a value in a frame that lies in `size` bytes, which may be more than its own."""
    return _value(value, size, order, swapped, words, False)


def _value(value: Value, size: int, order: str, swapped: bool, words: Words, any_answer: bool) -> str:
    if value.type.kind in (Kind.TEXT, Kind.BYTES):
        kind = "_Text" if value.type.kind is Kind.TEXT else "_Bytes"
        return f'{kind}("{size}s", {value.size})'
    letter, narrow = value.type.letter, value.size < size
    if narrow:
        letter = "h" if value.type.signed else "H"
    letters = literal((">" if (order == "big") != swapped else "<") + letter)
    more = ["swapped=True"] if swapped else []
    if value.type.kind is Kind.BOOLEAN:
        return _call("_Boolean", letters, more)
    if value.type.kind is Kind.FLOAT:
        more += [f"ranges={pairs(value.ranges)}"] if value.ranges is not None else []
        others = [repr(float("nan")) if one.is_nan else str(one.value) for one in value.sentinels]
        others = ['float("nan")' if one == "nan" else one for one in others]
        more += [f"others={tuple_of(others)}"] if others else []
        more += [f"unit={literal(value.unit)}"] if value.unit and (others or value.ranges is not None) else []
        return _call("_Float", letters, more)
    if value.const is not None:
        if not any_answer:
            return _call("_Constant", letters, [str(value.const), *more])
        more += [f'limits="{value.type.letter}"'] if narrow else []
        return _call("_Setting", letters, [str(value.const), *more])
    ranges = _ranges(value)
    if ranges is not None:
        more.append(f"ranges={pairs(ranges)}")
    if value.flags:
        return _call("_Word", letters, [words.flags[value.flags], *more])
    if value.sentinels:
        more.append(f"others={tuple_of(sentinel.value for sentinel in value.sentinels)}")
    if value.enum:
        enum = words.enums[value.enum]
        if any_answer:
            return _call("_Trigger", letters, [literal(enum.title), enum.table, *more])
        if not enum.open and value.sentinels:
            more.append("closed=True")
        return _call(
            "_Open" if enum.open or value.sentinels else "_Closed", letters, [literal(enum.title), enum.table, *more]
        )
    if value.unit:
        more.append(f"unit={literal(value.unit)}")
    if value.scaled:
        more.append(f"ratio={ratio(value)}")
    if narrow:
        more.append(f'limits="{value.type.letter}"')
    return _call("_Number", letters, more)


def _call(name: str, letters: str, more: list[str]) -> str:
    return f"{name}({', '.join([letters, *more])})"


def _ranges(value: Value) -> Ranges | None:
    ranges = value.written_ranges
    return None if ranges is None or ranges.intervals == ((value.type.low, value.type.high),) else ranges


def value_facts(value: Value) -> list[str]:
    """What a docstring says of a value: how it counts, its range, its sentinels, its initial value."""
    facts = [quantity(value)] if quantity(value) else []
    if value.ranges is not None:
        facts.append(value.ranges.text())
    if value.write_ranges is not None:
        facts.append(f"{value.write_ranges.text()} when it is written")
    facts += [f"{sentinel.text} = {Name.of(sentinel.name).title().lower()}" for sentinel in value.sentinels]
    if value.default is not None:
        facts.append(f"initially {value.default}")
    return facts
