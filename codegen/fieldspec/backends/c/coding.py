"""The functions that encode and decode a record."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable

from fieldspec.backends.c.choices import (
    case_decoded,
    case_encoded,
    case_member,
    chosen_lines,
    selector_given,
    selector_read,
    sized_lines,
)
from fieldspec.backends.c.enums import closed_test
from fieldspec.backends.c.fields import count_member, given, members, wire
from fieldspec.backends.c.naming import Naming, member
from fieldspec.backends.c.text import indented
from fieldspec.backends.c.values import access_name, const_test, decode_lines, encode_lines, fixed_lines, load
from fieldspec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.model.device import Device

# The statements for one element, from its offset in the bytes and its member of the struct.
_One = Callable[[str, str], list[str]]


def encode_function(naming: Naming, device: Device, record: RecordLayout) -> list[str]:
    """The function that writes a record."""
    argument = f"const {naming.type('record', record.name)} *in, " if members(record) else ""
    lines = [
        f"static inline {naming.own('codec_status')} {naming.function('record', record.name, 'encode')}"
        f"({argument}uint8_t *out, size_t capacity, size_t *length)",
        "{",
    ]
    if not record.fields:
        lines += indented(["(void)out;", "(void)capacity;", "*length = 0;"])
        return [*lines, f"    return {naming.own_macro('ok')};", "}"]
    body: list[str] = []
    selector = selector_given(record.selector) if record.selector is not None else ""
    if selector:
        body += sized_lines(naming, record, selector)
    for field in record.fields:
        repeat = field.field.repeat
        if repeat is not None:
            count = f"in->{count_member(record, field)}"
            tests = [f"{count} < {repeat.low}u"] if repeat.low else []
            tests.append(f"{count} > {repeat.high}u")
            body += _refused(naming, " || ".join(tests), "err_wrong_length")
    size = _size(record)
    body += _refused(naming, f"capacity < {size}", "err_capacity")
    for field in _measuring_last(record):
        if field.cases:
            body += chosen_lines(naming, record, selector, _case_writer(naming, device, record, field))
        else:
            body += _each(record, field, _writer(naming, device, record, field), "in->")
    body += [f"*length = {size};", f"return {naming.own_macro('ok')};"]
    return [*lines, *indented([*_declarations(body), *body]), "}"]


def decode_function(naming: Naming, device: Device, record: RecordLayout) -> list[str]:
    """The function that reads a record."""
    argument = f", {naming.type('record', record.name)} *out" if members(record) else ""
    lines = [
        f"static inline {naming.own('codec_status')} {naming.function('record', record.name, 'decode')}"
        f"(const uint8_t *in, size_t length{argument})",
        "{",
    ]
    body: list[str] = []
    if record.least:
        body += _refused(naming, f"length < {record.least}u", "err_incomplete")
    body += _refused(naming, f"length > {record.most}u", "err_wrong_length")
    selector = selector_read(naming, record.selector) if record.selector is not None else ""
    if selector:
        body += sized_lines(naming, record, selector)
    body += _measured_length(naming, record)
    for field in _measuring_last(record):
        if field.cases:
            body += chosen_lines(naming, record, selector, _case_reader(naming, device, record, field))
        else:
            body += _each(record, field, _reader(naming, device, record, field), "out->")
    if not any(re.search(r"\bin\b", line) for line in body):
        body.insert(0, "(void)in;")
    body.append(f"return {naming.own_macro('ok')};")
    return [*lines, *indented([*_declarations(body), *body]), "}"]


def _refused(naming: Naming, test: str, error: str) -> list[str]:
    return [f"if ({test}) {{", f"    return {naming.own_macro(error)};", "}"]


def _measuring_last(record: RecordLayout) -> list[FieldLayout]:
    """The fields, those behind all others that say how long these are: other errors come first."""
    return sorted(record.fields, key=lambda field: field.field.measures is not None)


def _element(record: RecordLayout, field: FieldLayout) -> str:
    """The size of one element; where it differs from case to case, the variable that holds it."""
    return "element" if field.cases and record.size is None else f"{field.size}u"


def _size(record: RecordLayout) -> str:
    """An expression for the size of a record that is to be written."""
    if record.size is not None:
        return f"{record.size}u"
    last = record.fields[-1]
    if last.field.repeat is not None:
        return f"({last.offset}u + in->{count_member(record, last)} * {_element(record, last)})"
    return f"({last.offset}u + {last.count or 1}u * {_element(record, last)})"


def _measured_length(naming: Naming, record: RecordLayout) -> list[str]:
    """Statements that refuse a length that is not one of whole elements, and set the count of them."""
    if record.size is not None:
        return []
    last = record.fields[-1]
    element, repeat, lines = _element(record, last), last.field.repeat, []
    low, high = (repeat.low, repeat.high) if repeat is not None else (last.count or 1, last.count or 1)
    if last.cases:
        if low:
            lines += _refused(naming, f"length < {last.offset}u + {low}u * {element}", "err_incomplete")
        lines += _refused(naming, f"length > {last.offset}u + {high}u * {element}", "err_wrong_length")
    if repeat is None:
        return lines
    if last.cases or last.size > 1:
        lines += _refused(naming, f"(length - {last.offset}u) % {element} != 0", "err_wrong_length")
    return [*lines, f"out->{count_member(record, last)} = (length - {last.offset}u) / {element};"]


def _declarations(body: Iterable[str]) -> list[str]:
    """The variables that the statements use."""
    text = "\n".join(body)
    lines = ["size_t element;"] if "element = " in text else []
    if "at < " in text:
        lines.append("size_t at;")
    if "inner_length" in text:
        lines.append("size_t inner_length;")
    if "status = (int)" in text:
        lines.append("int status;")
    return lines


def _each(record: RecordLayout, field: FieldLayout, one: _One, holder: str) -> list[str]:
    """The statements for a field: once, or in a loop."""
    return _looped(record, field, field.size, one, holder, member(field.name))


def _looped(record: RecordLayout, field: FieldLayout, size: int, one: _One, holder: str, name: str) -> list[str]:
    if not field.listed:
        return one(f"{field.offset}", f"{holder}{name}")
    repeated = field.field.repeat is not None
    count = f"{holder}{count_member(record, field)}" if repeated else f"{field.count}u"
    lines = one(f"{field.offset}u + at * {size}u", f"{holder}{name}[at]")
    return [f"for (at = 0; at < {count}; at++) {{", *indented(lines), "}"] if lines else []


def _case_writer(
    naming: Naming, device: Device, record: RecordLayout, field: FieldLayout
) -> Callable[[CaseLayout], list[str]]:
    def lines(case: CaseLayout) -> list[str]:
        def one(at: str, name: str) -> list[str]:
            return case_encoded(naming, device, case, name, f"out + {at}")

        return _looped(record, field, case.value.size, one, "in->", f"{member(field.name)}.{case_member(case)}")

    return lines


def _case_reader(
    naming: Naming, device: Device, record: RecordLayout, field: FieldLayout
) -> Callable[[CaseLayout], list[str]]:
    def lines(case: CaseLayout) -> list[str]:
        def one(at: str, name: str) -> list[str]:
            return case_decoded(naming, device, case, name, f"in + {at}")

        return _looped(record, field, case.value.size, one, "out->", f"{member(field.name)}.{case_member(case)}")

    return lines


def _writer(naming: Naming, device: Device, record: RecordLayout, field: FieldLayout) -> _One:
    def one(at: str, name: str) -> list[str]:
        target = f"out + {at}"
        if field.record is not None:
            argument = f"&{name}, " if members(field.record) else ""
            encode = naming.function("record", field.record.name, "encode")
            return _returning(naming, f"{encode}({argument}{target}, {field.size}u, &inner_length)")
        value = field.value
        assert value is not None
        if field.field.measures is not None:
            return _measure_written(naming, record, field, target)
        if not given(field):
            default = value.default if isinstance(value.default, int) else 0
            number = value.const if value.const is not None else default
            return fixed_lines(naming, wire(field), number, target)
        return encode_lines(naming, wire(field), name, target, closed_test(naming, device, value, name))

    return one


def _returning(naming: Naming, call: str) -> list[str]:
    kind = naming.own("codec_status")
    return [f"status = (int){call};", *_refused_by(naming, kind)]


def _refused_by(naming: Naming, kind: str) -> list[str]:
    return [f"if (status != {naming.own_macro('ok')}) {{", f"    return ({kind})status;", "}"]


def _measure(record: RecordLayout, field: FieldLayout, holder: str) -> str:
    """An expression for the size, or the number of elements, of the field that another one measures."""
    measure = field.field.measures
    assert measure is not None
    other = record.named(measure.field)
    assert other is not None
    repeated = other.field.repeat is not None
    count = f"{holder}{count_member(record, other)}" if repeated else f"{other.count or 1}u"
    size = _element(record, other) if measure.of == "bytes" else "1u"
    return count if size == "1u" else f"{count} * {size}"


def _measure_written(naming: Naming, record: RecordLayout, field: FieldLayout, target: str) -> list[str]:
    held = wire(field)
    number = f"uint{8 * held.size}_t"
    measure = _measure(record, field, "in->")
    highest = held.value.ranges.high if held.value.ranges else held.value.type.high
    lines = _refused(naming, f"{measure} > {highest}u", "err_out_of_range") if highest < 2**31 else []
    store = naming.own("store", access_name(held.size, held.order, held.swapped))
    return [*lines, f"{store}({target}, ({number})({measure}));"]


def _reader(naming: Naming, device: Device, record: RecordLayout, field: FieldLayout) -> _One:
    def one(at: str, name: str) -> list[str]:
        source = f"in + {at}"
        if field.record is not None:
            argument = f", &{name}" if members(field.record) else ""
            decode = naming.function("record", field.record.name, "decode")
            return _returning(naming, f"{decode}({source}, {field.size}u{argument})")
        value = field.value
        assert value is not None
        held = wire(field)
        if field.field.measures is not None:
            test = f"{load(naming, held, source)} != {_measure(record, field, 'out->')}"
            return _refused(naming, test, "err_wrong_measure")
        if field.field.reserved:
            return []
        if value.const is not None:
            return const_test(naming, held, source)
        return decode_lines(naming, held, source, name, closed_test(naming, device, value, name))

    return one
