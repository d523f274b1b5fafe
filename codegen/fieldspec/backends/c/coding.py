"""The functions that encode and decode a record."""

from __future__ import annotations

import re
from collections.abc import Callable

from fieldspec.backends.c.choices import (
    case_decoded,
    case_encoded,
    case_member,
    chosen_lines,
    selector_given,
    selector_read,
    sized_lines,
)
from fieldspec.backends.c.elements import One, each, element, looped, measure, member_argument, returning, variables
from fieldspec.backends.c.enums import closed_test
from fieldspec.backends.c.fields import count_member, given, members, wire
from fieldspec.backends.c.naming import Naming, member
from fieldspec.backends.c.packing import check_lines, found_lines, packed
from fieldspec.backends.c.text import indented
from fieldspec.backends.c.values import access_name, decode_lines, encode_lines, fixed_lines, load, refused
from fieldspec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.model.device import Device


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
            body += refused(naming, " || ".join(tests), "err_wrong_length")
    size = _size(record)
    body += refused(naming, f"capacity < {size}", "err_capacity")
    body += _written(naming, device, record, selector)
    body += [f"*length = {size};", f"return {naming.own_macro('ok')};"]
    return [*lines, *indented([*variables(naming, body), *body]), "}"]


def decode_function(naming: Naming, device: Device, record: RecordLayout) -> list[str]:
    """The function that reads a record."""
    argument = f", {naming.type('record', record.name)} *out" if members(record) else ""
    lines = [
        f"static inline {naming.own('codec_status')} {naming.function('record', record.name, 'decode')}"
        f"(const uint8_t *in, size_t length{argument})",
        "{",
    ]
    body = _length_tests(naming, record)
    selector = selector_read(naming, record.selector) if record.selector is not None else ""
    if selector:
        body += sized_lines(naming, record, selector)
    body += _measured_length(naming, record)
    body += _read(naming, device, record, selector)
    if not any(re.search(r"\bin\b", line) for line in body):
        body.insert(0, "(void)in;")
    body.append(f"return {naming.own_macro('ok')};")
    return [*lines, *indented([*variables(naming, body), *body]), "}"]


def _written(naming: Naming, device: Device, record: RecordLayout, selector: str) -> list[str]:
    """Statements that check the values of a record and write them."""
    lines = []
    if packed(record):
        if check_lines(naming, device, record):
            lines += returning(naming, f"{naming.function('record', record.name, 'check')}(in)")
        return [*lines, f"{naming.function('record', record.name, 'pack')}(in, out);"]
    for field in _measuring_last(record):
        if field.cases:
            lines += chosen_lines(naming, record, selector, _case_writer(naming, device, record, field))
        else:
            lines += each(record, field, _writer(naming, device, record, field), "in->")
    return lines


def _read(naming: Naming, device: Device, record: RecordLayout, selector: str) -> list[str]:
    """Statements that read the values of a record and check them."""
    if packed(record):
        unpack = f"{naming.function('record', record.name, 'unpack')}(in, out);"
        return [unpack, *found_lines(naming, device, record)]
    lines = []
    for field in _measuring_last(record):
        if field.cases:
            lines += chosen_lines(naming, record, selector, _case_reader(naming, device, record, field))
        else:
            lines += each(record, field, _reader(naming, device, record, field), "out->")
    return lines


def _length_tests(naming: Naming, record: RecordLayout) -> list[str]:
    """Statements that refuse a length that the record cannot have."""
    incomplete, wrong = naming.own_macro("err_incomplete"), naming.own_macro("err_wrong_length")
    if record.least and record.least == record.most:
        # One comparison where all is well.
        shorter = f"length < {record.least}u ? {incomplete} : {wrong}"
        return [f"if (length != {record.least}u) {{", f"    return {shorter};", "}"]
    lines = refused(naming, f"length < {record.least}u", "err_incomplete") if record.least else []
    return [*lines, *refused(naming, f"length > {record.most}u", "err_wrong_length")]


def _measuring_last(record: RecordLayout) -> list[FieldLayout]:
    """The fields, those behind all others that say how long these are: other errors come first."""
    return sorted(record.fields, key=lambda field: field.field.measures is not None)


def _size(record: RecordLayout) -> str:
    """An expression for the size of a record that is to be written."""
    if record.size is not None:
        return f"{record.size}u"
    last = record.fields[-1]
    if last.field.repeat is not None:
        return f"({last.offset}u + in->{count_member(record, last)} * {element(record, last)})"
    return f"({last.offset}u + {last.count or 1}u * {element(record, last)})"


def _measured_length(naming: Naming, record: RecordLayout) -> list[str]:
    """Statements that refuse a length that is not one of whole elements, and set the count of them."""
    if record.size is not None:
        return []
    last = record.fields[-1]
    size, repeat, lines = element(record, last), last.field.repeat, []
    low, high = (repeat.low, repeat.high) if repeat is not None else (last.count or 1, last.count or 1)
    if last.cases:
        if low:
            lines += refused(naming, f"length < {last.offset}u + {low}u * {size}", "err_incomplete")
        lines += refused(naming, f"length > {last.offset}u + {high}u * {size}", "err_wrong_length")
    if repeat is None:
        return lines
    if last.cases or last.size > 1:
        lines += refused(naming, f"(length - {last.offset}u) % {size} != 0", "err_wrong_length")
    return [*lines, f"out->{count_member(record, last)} = (length - {last.offset}u) / {size};"]


def _case_writer(
    naming: Naming, device: Device, record: RecordLayout, field: FieldLayout
) -> Callable[[CaseLayout], list[str]]:
    def lines(case: CaseLayout) -> list[str]:
        def one(at: str, name: str) -> list[str]:
            return case_encoded(naming, device, case, name, f"out + {at}")

        return looped(record, field, case.value.size, one, "in->", f"{member(field.name)}.{case_member(case)}")

    return lines


def _case_reader(
    naming: Naming, device: Device, record: RecordLayout, field: FieldLayout
) -> Callable[[CaseLayout], list[str]]:
    def lines(case: CaseLayout) -> list[str]:
        def one(at: str, name: str) -> list[str]:
            return case_decoded(naming, device, case, name, f"in + {at}")

        return looped(record, field, case.value.size, one, "out->", f"{member(field.name)}.{case_member(case)}")

    return lines


def _writer(naming: Naming, device: Device, record: RecordLayout, field: FieldLayout) -> One:
    def one(at: str, name: str) -> list[str]:
        target = f"out + {at}"
        if field.record is not None:
            return _inner_writer(naming, device, field.record, name, target)
        held = wire(field)
        if field.field.measures is not None:
            return _measure_written(naming, record, field, target)
        if not given(field):
            default = held.value.default if isinstance(held.value.default, int) else 0
            return fixed_lines(naming, held, default if held.value.const is None else held.value.const, target)
        return encode_lines(naming, held, name, target, closed_test(naming, device, held.value, name))

    return one


def _inner_writer(naming: Naming, device: Device, record: RecordLayout, name: str, target: str) -> list[str]:
    """Statements that check and write a record within another."""
    if not packed(record):
        encode, argument = naming.function("record", record.name, "encode"), member_argument(record, name)
        return returning(naming, f"{encode}({argument}{target}, {record.size}u, &inner_length)")
    check, pack = (naming.function("record", record.name, end) for end in ("check", "pack"))
    lines = returning(naming, f"{check}(&{name})") if check_lines(naming, device, record) else []
    return [*lines, f"{pack}(&{name}, {target});"]


def _inner_reader(naming: Naming, device: Device, record: RecordLayout, name: str, source: str) -> list[str]:
    """Statements that read and check a record within another."""
    if packed(record) and not found_lines(naming, device, record):
        return [f"{naming.function('record', record.name, 'unpack')}({source}, &{name});"]
    argument = f", &{name}" if members(record) else ""
    return returning(naming, f"{naming.function('record', record.name, 'decode')}({source}, {record.size}u{argument})")


def _measure_written(naming: Naming, record: RecordLayout, field: FieldLayout, target: str) -> list[str]:
    held = wire(field)
    number = f"uint{8 * held.size}_t"
    measured = measure(record, field, "in->")
    highest = held.value.ranges.high if held.value.ranges else held.value.type.high
    most = _most_measured(record, field)
    fits = most is not None and most <= highest
    lines = [] if fits or highest >= 2**31 else refused(naming, f"{measured} > {highest}u", "err_out_of_range")
    store = naming.own("store", access_name(held.size, held.order, held.swapped))
    return [*lines, f"{store}({target}, ({number})({measured}));"]


def _most_measured(record: RecordLayout, field: FieldLayout) -> int | None:
    """The most that a field can have to say of another, None where that differs from case to case."""
    held = field.field.measures
    assert held is not None
    other = record.named(held.field)
    assert other is not None
    if other.cases:
        return None
    repeat = other.field.repeat
    count = repeat.high if repeat is not None else other.count or 1
    return count * other.size if held.of == "bytes" else count


def _reader(naming: Naming, device: Device, record: RecordLayout, field: FieldLayout) -> One:
    def one(at: str, name: str) -> list[str]:
        source = f"in + {at}"
        if field.record is not None:
            return _inner_reader(naming, device, field.record, name, source)
        held = wire(field)
        if field.field.measures is not None:
            test = f"{load(naming, held, source)} != {measure(record, field, 'out->')}"
            return refused(naming, test, "err_wrong_measure")
        if field.field.reserved:
            return []
        return decode_lines(naming, held, source, name, closed_test(naming, device, held.value, name))

    return one
