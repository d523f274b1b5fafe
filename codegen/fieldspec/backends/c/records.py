"""Records and the data of messages: structs, and the functions that encode and decode them."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.backends.c.naming import Naming, member
from fieldspec.backends.c.text import comment, indented
from fieldspec.backends.c.values import (
    Wire,
    access_name,
    const_test,
    declaration,
    decode_lines,
    encode_lines,
    fixed_lines,
    load,
)
from fieldspec.backends.c.words import closed_test, told
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.device import Device


def wire(field: FieldLayout) -> Wire:
    """The value of a field that holds one."""
    assert field.value is not None
    return Wire(field.value, field.order, field.swapped)


def given(field: FieldLayout) -> bool:
    """Whether users give the field: it is no constant, measures nothing, and has a meaning."""
    constant = field.value is not None and field.value.const is not None
    return not (constant or field.field.measures or field.field.reserved)


def members(record: RecordLayout) -> list[FieldLayout]:
    """The fields that are members of the struct."""
    return [field for field in record.fields if given(field)]


def most(field: FieldLayout) -> int:
    """How many elements a list can have."""
    repeat = field.field.repeat
    return repeat.high if repeat is not None else field.count or 1


def record_lines(naming: Naming, device: Device, record: RecordLayout, doc: list[str]) -> list[str]:
    """The struct of a record, if it has members, and its functions."""
    name = naming.type(record.name)
    held = members(record)
    size = f"{record.size} bytes" if record.size is not None else f"{record.least} to {record.most} bytes"
    lines = [f"#define {naming.macro(record.name, 'size')} {record.most}u"]
    if held:
        lines += [*doc, f"typedef struct {name} {{"]
        for field in held:
            lines += indented([*_field_comment(field), *_declared(naming, field)])
        lines += [f"}} {name};"]
    else:
        lines += comment("There is nothing to give: no struct is needed.")
    lines += ["", *comment(f"Writes {name}: {size}.", "Length receives how many bytes were written.")]
    lines += _encode(naming, device, record, name, bool(held))
    lines += ["", *comment(f"Reads {name} from exactly {size}.")]
    return [*lines, *_decode(naming, device, record, name, bool(held))]


def _field_comment(field: FieldLayout) -> list[str]:
    value = field.value
    facts = []
    if value is not None:
        if value.scaled or value.unit:
            offset = f", then {value.offset} added" if value.offset else ""
            facts.append(f"One count is {value.scale} {value.unit}{offset}.")
        if value.ranges is not None:
            facts.append(f"Range: {value.ranges.text()}.")
        if value.enum or value.flags:
            facts.append(f"See {value.enum or value.flags}.")
        facts += [f"{sentinel.value} is {sentinel.name}." for sentinel in value.sentinels]
    return told(field.field, " ".join(facts))


def _declared(naming: Naming, field: FieldLayout) -> list[str]:
    count = most(field) if field.listed else None
    if field.record is not None:
        times = f"[{count}]" if count is not None else ""
        lines = [f"{naming.type(field.record.name)} {member(field.name)}{times};"]
    else:
        lines = [declaration(wire(field), member(field.name), count) + ";"]
    if field.field.repeat is not None:
        lines.append(f"size_t {field.name}_count;")
    return lines


def _size(record: RecordLayout, holder: str) -> str:
    """An expression for the size of a record that is to be written."""
    if record.size is not None:
        return f"{record.size}u"
    last = record.fields[-1]
    return f"({last.offset}u + {holder}{last.name}_count * {last.size}u)"


def _encode(naming: Naming, device: Device, record: RecordLayout, name: str, held: bool) -> list[str]:
    argument = f"const {name} *in, " if held else ""
    lines = [
        f"static inline {naming.type('codec_status')} {naming.function(record.name, 'encode')}"
        f"({argument}uint8_t *out, size_t capacity, size_t *length)",
        "{",
    ]
    body: list[str] = []
    if not record.fields:
        lines += indented(["(void)out;", "(void)capacity;", "*length = 0;"])
        return [*lines, f"    return {naming.macro('ok')};", "}"]
    for field in record.fields:
        if field.field.repeat is not None:
            count = f"in->{field.name}_count"
            repeat = field.field.repeat
            tests = [f"{count} < {repeat.low}u"] if repeat.low else []
            tests.append(f"{count} > {repeat.high}u")
            body += [f"if ({' || '.join(tests)}) {{", f"    return {naming.macro('err_wrong_length')};", "}"]
    size = _size(record, "in->")
    body += [f"if (capacity < {size}) {{", f"    return {naming.macro('err_capacity')};", "}"]
    for field in record.fields:
        body += _each(naming, field, _encoder(naming, device, record, field), "in->")
    body += [f"*length = {size};", f"return {naming.macro('ok')};"]
    return [*lines, *indented([*_declarations(body), *body]), "}"]


def _decode(naming: Naming, device: Device, record: RecordLayout, name: str, held: bool) -> list[str]:
    argument = f", {name} *out" if held else ""
    lines = [
        f"static inline {naming.type('codec_status')} {naming.function(record.name, 'decode')}"
        f"(const uint8_t *in, size_t length{argument})",
        "{",
    ]
    body: list[str] = []
    if record.least:
        body += [f"if (length < {record.least}u) {{", f"    return {naming.macro('err_incomplete')};", "}"]
    last = record.fields[-1] if record.fields else None
    tests = [f"length > {record.most}u"]
    if last is not None and last.count is None and last.size > 1:
        tests.append(f"(length - {last.offset}u) % {last.size}u != 0")
    for test in tests:
        body += [f"if ({test}) {{", f"    return {naming.macro('err_wrong_length')};", "}"]
    if last is not None and last.count is None:
        body.append(f"out->{last.name}_count = (length - {last.offset}u) / {last.size}u;")
    for field in record.fields:
        body += _each(naming, field, _decoder(naming, device, record, field), "out->")
    if not any("in" in line.replace("int", "") for line in body):
        body.insert(0, "(void)in;")
    body.append(f"return {naming.macro('ok')};")
    return [*lines, *indented([*_declarations(body), *body]), "}"]


def _declarations(body: list[str]) -> list[str]:
    """The variables that the statements use."""
    text = "\n".join(body)
    lines = []
    if "at < " in text:
        lines.append("size_t at;")
    if "inner_length" in text:
        lines.append("size_t inner_length;")
    if "status = (int)" in text:
        lines.append("int status;")
    return lines


def _each(naming: Naming, field: FieldLayout, one: Callable[[str, str], list[str]], holder: str) -> list[str]:
    """The statements for a field: once, or in a loop. `one` takes a pointer offset and a member."""
    name = member(field.name)
    if not field.listed:
        return one(f"{field.offset}", f"{holder}{name}")
    count = f"{holder}{field.name}_count" if field.field.repeat is not None else f"{field.count}u"
    lines = one(f"{field.offset}u + at * {field.size}u", f"{holder}{name}[at]")
    return [f"for (at = 0; at < {count}; at++) {{", *indented(lines), "}"] if lines else []


def _encoder(
    naming: Naming, device: Device, record: RecordLayout, field: FieldLayout
) -> Callable[[str, str], list[str]]:
    def one(at: str, name: str) -> list[str]:
        target = f"out + {at}"
        if field.record is not None:
            argument = f"&{name}, " if members(field.record) else ""
            call = f"{naming.function(field.record.name, 'encode')}({argument}{target}, {field.size}u, &inner_length)"
            return _returning(naming, call)
        value = field.value
        assert value is not None
        if field.field.measures is not None:
            return _measured(naming, record, field, target)
        if not given(field):
            default = value.default if isinstance(value.default, int) else 0
            number = value.const if value.const is not None else default
            return fixed_lines(naming, wire(field), number, target)
        return encode_lines(naming, wire(field), name, target, closed_test(naming, device, value, name))

    return one


def _returning(naming: Naming, call: str) -> list[str]:
    kind = naming.type("codec_status")
    return [f"status = (int){call};", f"if (status != {naming.macro('ok')}) {{", f"    return ({kind})status;", "}"]


def _measure(record: RecordLayout, field: FieldLayout, holder: str) -> str:
    """An expression for the size, or the number of elements, of the field that another one measures."""
    measure = field.field.measures
    assert measure is not None
    other = record.named(measure.field)
    assert other is not None
    size = other.size if measure.of == "bytes" else 1
    if other.field.repeat is None:
        return f"{size * (other.count or 1)}u"
    return f"{holder}{other.name}_count * {size}u" if size != 1 else f"{holder}{other.name}_count"


def _measured(naming: Naming, record: RecordLayout, field: FieldLayout, target: str) -> list[str]:
    held = wire(field)
    number = f"uint{8 * held.size}_t"
    measure = _measure(record, field, "in->")
    highest = field.value.ranges.high if field.value and field.value.ranges else held.value.type.high
    lines = []
    if highest < 2**31:
        lines = [f"if ({measure} > {highest}u) {{", f"    return {naming.macro('err_out_of_range')};", "}"]
    store = naming.function("store", access_name(held.size, held.order, held.swapped))
    return [*lines, f"{store}({target}, ({number})({measure}));"]


def _decoder(
    naming: Naming, device: Device, record: RecordLayout, field: FieldLayout
) -> Callable[[str, str], list[str]]:
    def one(at: str, name: str) -> list[str]:
        source = f"in + {at}"
        if field.record is not None:
            argument = f", &{name}" if members(field.record) else ""
            return _returning(
                naming, f"{naming.function(field.record.name, 'decode')}({source}, {field.size}u{argument})"
            )
        value = field.value
        assert value is not None
        held = wire(field)
        if field.field.measures is not None:
            test = f"{load(naming, held, source)} != {_measure(record, field, 'out->')}"
            return [f"if ({test}) {{", f"    return {naming.macro('err_wrong_measure')};", "}"]
        if field.field.reserved:
            return []
        if value.const is not None:
            return const_test(naming, held, source)
        return decode_lines(naming, held, source, name, closed_test(naming, device, value, name))

    return one
