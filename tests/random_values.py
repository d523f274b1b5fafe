"""Random raw values and random bytes for records: mostly valid ones, and some just outside every limit."""

from __future__ import annotations

from typing import Any, Literal

from hypothesis import strategies as st

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.language.model.encoding import is_array, is_octets, is_real, is_text, is_truth
from fieldspec.language.model.value import Value

_VALUES: dict[tuple[int, int], st.SearchStrategy[dict[str, Any]]] = {}


def values_of(layout: DeviceLayout, record: RecordLayout) -> st.SearchStrategy[dict[str, Any]]:
    """Values of all fields except constants, counting fields and reserved ones."""
    # Compared by identity: layouts are computed once, and comparing them takes longer than a test.
    key = id(layout), id(record)
    if key not in _VALUES:
        _VALUES[key] = _values_of(layout, record)
    return _VALUES[key]


def _values_of(layout: DeviceLayout, record: RecordLayout) -> st.SearchStrategy[dict[str, Any]]:
    if record.selector is not None:
        return _choosing(layout, record, record.selector)
    fields = [
        field
        for field in record.fields
        if not (field.field.reserved or field.field.measures or (field.value and field.value.const is not None))
    ]
    strategy = st.fixed_dictionaries({field.name: _field(layout, field) for field in fields if field.selector is None})
    choices = [field for field in fields if field.selector is not None]
    return strategy.flatmap(lambda values: _with_choices(layout, choices, values)) if choices else strategy


def _with_choices(
    layout: DeviceLayout, choices: list[FieldLayout], values: dict[str, Any]
) -> st.SearchStrategy[dict[str, Any]]:
    """Some values, and those of fields whose types they decide; of the first type where they decide none."""
    decided = {}
    for field in choices:
        assert field.selector is not None
        number = values.get(field.selector.name, field.selector.value.const if field.selector.value else None)
        decided[field.name] = _field(layout, field.form_of(number) or field.forms[min(field.forms)])
    return st.fixed_dictionaries({**{name: st.just(value) for name, value in values.items()}, **decided})


def _choosing(layout: DeviceLayout, record: RecordLayout, selector: FieldLayout) -> st.SearchStrategy[dict[str, Any]]:
    """Values of the type that the selector says; now and then, where all types are numbers, with another selector."""
    shapes = {id(shape): shape for shape in record.chosen.values()}
    numeric = all(not is_array(case.value.encoding) for case in record.fields[-1].cases)
    each = []
    for shape in shapes.values():
        numbers = sorted(number for number, chosen in record.chosen.items() if chosen is shape)
        right = st.sampled_from(numbers)
        by = st.one_of(right, right, right, _field(layout, selector)) if numeric else right
        each.append(st.builds(lambda values, by: {**values, selector.name: by}, values_of(layout, shape), by))
    return st.one_of(*each)


def _field(layout: DeviceLayout, field: FieldLayout) -> st.SearchStrategy[Any]:
    nested = values_of(layout, field.record) if field.record else _value(layout, field.value)
    if not field.is_list:
        return nested
    repeat = field.field.repeat
    least, most = (repeat.low, repeat.high) if repeat else (field.count or 0, field.count or 0)
    right = st.lists(nested, min_size=least, max_size=min(most, least + 6))
    if most > 60:
        return right
    return st.one_of(right, right, right, st.lists(nested, min_size=max(least - 1, 0), max_size=most + 1))


def _value(layout: DeviceLayout, value: Value | None) -> st.SearchStrategy[Any]:
    assert value is not None
    encoding = value.encoding
    if is_text(encoding):
        fitting = st.text(st.characters(min_codepoint=1, max_codepoint=0x7E), max_size=value.size)
        return st.one_of(fitting, fitting, st.text(max_size=value.size + 1))
    if is_octets(encoding):
        fitting_bytes = st.binary(min_size=value.least_size, max_size=value.size)
        return st.one_of(fitting_bytes, fitting_bytes, fitting_bytes, st.binary(max_size=value.size + 1))
    if is_real(encoding):
        fitting_floats = [st.floats(a, b, width=32) for a, b in value.ranges.intervals] if value.ranges else []
        absent = [float("nan") if sentinel.is_nan else float(sentinel.value) for sentinel in value.sentinels]
        sentinels = [st.sampled_from(absent)] if absent else []
        return st.one_of(*fitting_floats * 4, *sentinels, st.floats(width=32))
    if is_truth(encoding):
        return st.one_of(st.booleans(), st.booleans(), st.booleans(), st.integers(-1, 2))
    low, high = value.type.low, value.type.high
    options: list[st.SearchStrategy[int]] = []
    if value.enum:
        options += [st.sampled_from([member.value for member in layout.device.enums[value.enum].members])] * 6
    elif value.ranges is not None:
        options += [st.integers(a, b) for a, b in value.ranges.intervals] * 6
        options.append(st.sampled_from([n + by for a, b in value.ranges.intervals for n, by in ((a, -1), (b, 1))]))
    elif value.flags:
        options += [st.integers(low, high).map(layout.device.flags[value.flags].nearest)] * 6
    else:
        options += [st.integers(low, high)] * 6
    options += [st.integers(*interval) for interval in value.special_intervals]
    options.append(st.sampled_from([low - 1, low, high, high + 1]))
    return st.one_of(*options)


def bytes_of(record: RecordLayout) -> st.SearchStrategy[bytes]:
    """Bytes of a right length, or of one beside it; often small ones, which more often have a meaning.

    Mostly with a right selector, and a right number of elements in the byte that counts them.
    """
    return _random_bytes(record) if record.selector is None else _choosing_bytes(record, record.selector)


def _choosing_bytes(record: RecordLayout, selector: FieldLayout) -> st.SearchStrategy[bytes]:
    measures = [field for field in record.fields if field.field.measures and field.size == 1]

    def mended(data: bytes, number: int, mend: bool) -> bytes:
        chosen = record.chosen[number]
        decided = chosen.fields[-1]
        length = len(data) - (len(data) - decided.offset) % decided.size
        if not mend or len(data) < record.least or length < decided.offset:
            return data
        mended_bytes = bytearray(data[:length])
        order: Literal["big", "little"] = "big" if selector.order == "big" else "little"
        mended_bytes[selector.offset : selector.offset + selector.size] = number.to_bytes(selector.size, order)
        for field in measures:
            mended_bytes[field.offset] = (length - decided.offset) // decided.size
        return bytes(mended_bytes)

    return st.builds(mended, _random_bytes(record), st.sampled_from(sorted(record.chosen)), st.booleans())


def _random_bytes(record: RecordLayout) -> st.SearchStrategy[bytes]:
    most = record.most if record.most is not None else record.least + 40
    right = st.binary(min_size=record.least, max_size=min(most, record.least + 60))
    drawn = st.one_of(right, right, right, st.binary(max_size=record.least + 3))
    return st.builds(lambda data, mask: bytes(byte & mask for byte in data), drawn, st.sampled_from([0xFF, 0x03, 0x01]))
