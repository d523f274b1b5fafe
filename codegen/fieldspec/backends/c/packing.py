"""Records of one size: functions that only move their values, and one that checks what is to be written."""

from __future__ import annotations

from fieldspec.backends.c.elements import each, measure, member_argument, returning, variables
from fieldspec.backends.c.enums import closed_test
from fieldspec.backends.c.fields import given, members, wire
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import comment, indented
from fieldspec.backends.c.values import fixed_lines, found_tests, given_tests, load, load_lines, refused, store_lines
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.device import Device


def packed(record: RecordLayout) -> bool:
    """Whether a record has such functions: it is of one size, always has the same fields, and users give some."""
    inner = [field.record for field in record.fields if field.record is not None]
    return record.size is not None and record.selector is None and bool(members(record)) and all(map(packed, inner))


def pack_functions(naming: Naming, device: Device, record: RecordLayout) -> list[str]:
    """The functions that move a record between its struct and bytes, and the one that checks its values if any is."""
    kind, size = naming.type("record", record.name), f"{record.size} bytes"
    check = check_lines(naming, device, record)
    lines = []
    if check:
        lines = [
            *comment(f"Whether the values of {kind} are such as may be written."),
            f"static inline {naming.own('codec_status')} {naming.function('record', record.name, 'check')}"
            f"(const {kind} *in)",
            *_body(naming, [*check, f"return {naming.own_macro('ok')};"]),
            "",
        ]
    store = [line for field in record.fields for line in _stored(naming, record, field)]
    load = [line for field in members(record) for line in _loaded(naming, record, field)]
    return [
        *lines,
        *comment(f"Writes {kind} to {size} without any check."),
        f"static inline void {naming.function('record', record.name, 'pack')}(const {kind} *in, uint8_t *out)",
        *_body(naming, store),
        "",
        *comment(f"Reads {kind} from {size} without any check."),
        f"static inline void {naming.function('record', record.name, 'unpack')}(const uint8_t *in, {kind} *out)",
        *_body(naming, load),
    ]


def _body(naming: Naming, lines: list[str]) -> list[str]:
    return ["{", *indented([*variables(naming, lines), *lines]), "}"]


def check_lines(naming: Naming, device: Device, record: RecordLayout) -> list[str]:
    """Statements that return where a value is refused that is to be written."""
    lines = []
    for field in members(record):

        def one(_: str, name: str, field: FieldLayout = field) -> list[str]:
            if field.record is not None:
                if not check_lines(naming, device, field.record):
                    return []
                return returning(naming, f"{naming.function('record', field.record.name, 'check')}(&{name})")
            held = wire(field)
            return given_tests(naming, held, name, closed_test(naming, device, held.value, name))

        lines += each(record, field, one, "in->")
    return lines


def found_lines(naming: Naming, device: Device, record: RecordLayout) -> list[str]:
    """Statements that return where a value is refused that has been read; those that measure others come last."""
    lines = []
    for field in sorted(record.fields, key=lambda field: field.field.measures is not None):

        def one(at: str, name: str, field: FieldLayout = field) -> list[str]:
            source = f"in + {at}"
            if field.record is not None:
                if not found_lines(naming, device, field.record):
                    return []
                decode = naming.function("record", field.record.name, "decode")
                return returning(naming, f"{decode}({source}, {field.size}u, &{name})")
            held = wire(field)
            if field.field.measures is not None:
                test = f"{load(naming, held, source)} != {measure(record, field, 'out->')}"
                return refused(naming, test, "err_wrong_measure")
            if field.field.reserved:
                return []
            return found_tests(naming, held, source, closed_test(naming, device, held.value, name))

        lines += each(record, field, one, "out->")
    return lines


def _stored(naming: Naming, record: RecordLayout, field: FieldLayout) -> list[str]:
    def one(at: str, name: str) -> list[str]:
        target = f"out + {at}"
        if field.record is not None:
            argument = member_argument(field.record, name)
            return [f"{naming.function('record', field.record.name, 'pack')}({argument}{target});"]
        held = wire(field)
        if field.field.measures is not None:
            return store_lines(naming, held, measure(record, field, "in->"), target)
        if not given(field):
            default = held.value.default if isinstance(held.value.default, int) else 0
            return fixed_lines(naming, held, default if held.value.const is None else held.value.const, target)
        return store_lines(naming, held, name, target)

    return each(record, field, one, "in->")


def _loaded(naming: Naming, record: RecordLayout, field: FieldLayout) -> list[str]:
    def one(at: str, name: str) -> list[str]:
        source = f"in + {at}"
        if field.record is not None:
            return [f"{naming.function('record', field.record.name, 'unpack')}({source}, &{name});"]
        return load_lines(naming, wire(field), source, name)

    return each(record, field, one, "out->")
