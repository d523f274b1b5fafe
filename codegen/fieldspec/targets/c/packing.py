"""Records of one size: functions that only move their values, and one that checks what is to be written."""

from __future__ import annotations

from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.language.model.device import Device
from fieldspec.targets.c.declarations import BLANK, Declaration, Function, comment
from fieldspec.targets.c.expressions import IN, INPUT_BYTES, OUT, OUTPUT_BYTES, Call, Expression, Type
from fieldspec.targets.c.fields import (
    function_locals,
    is_set_by_user,
    measured_size,
    members,
    return_error,
    struct_argument,
    walk_elements,
)
from fieldspec.targets.c.literals import unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.statements import Body, Variable, call
from fieldspec.targets.c.values import (
    check_loaded,
    check_stored,
    field_value,
    fixed_number,
    load,
    load_value,
    refuse,
    return_ok,
    status_type,
    store_constant,
    store_value,
)


def is_packed(record: RecordLayout) -> bool:
    """Whether a record has functions that pack it: its size and its fields are fixed, and users set some of them."""
    inner = [field.record for field in record.fields if field.record is not None]
    return record.size is not None and record.selector is None and bool(members(record)) and all(map(is_packed, inner))


def declare_packing(naming: Naming, record: RecordLayout, checks: Body, *, is_image: bool = False) -> list[Declaration]:
    """The functions that move a record between its struct and bytes, and the one with the checks, if there are some.

    The bytes of an image are not what is sent: whatever varies in size has its full size in them.
    """
    full = ", in which all that varies has its full size, so they are not what is sent" if is_image else ""
    struct, size = naming.type("record", record.name), f"{record.size} byte{'s' * (record.size != 1)}"
    local_variables = function_locals(naming)
    source = Variable(Type(struct, const=True, pointer=True), "in")
    target = Variable(Type(struct, pointer=True), "out")
    declarations: list[Declaration] = []
    if checks:
        declarations = [
            comment(f"Whether the values of {struct} may be written."),
            Function(
                status_type(naming),
                naming.function("record", record.name, "check"),
                (source,),
                (*checks, return_ok(naming)),
                local_variables,
            ),
            BLANK,
        ]
    stored = tuple([part for field in record.fields for part in _store_field(naming, record, field)])
    loaded = tuple([part for field in members(record) for part in _load_field(naming, record, field)])
    pack, unpack = naming.function("record", record.name, "pack"), naming.function("record", record.name, "unpack")
    return [
        *declarations,
        comment(f"Writes {struct} to {size} without checks{full}."),
        Function(Type("void"), pack, (source, Variable(OUTPUT_BYTES, "out")), stored, local_variables),
        BLANK,
        comment(f"Reads {struct} from {size} without checks{full}."),
        Function(Type("void"), unpack, (Variable(INPUT_BYTES, "in"), target), loaded, local_variables),
    ]


def check_members(naming: Naming, device: Device, record: RecordLayout) -> Body:
    """Refuses values of a struct that are to be written."""
    body: Body = ()
    for field in members(record):

        def check(_: Expression, value: Expression, field: FieldLayout = field) -> Body:
            if field.record is None:
                return check_stored(naming, device, field_value(field), value)
            if not check_members(naming, device, field.record):
                return ()
            function = naming.function("record", field.record.name, "check")
            return return_error(naming, Call(function, (value.address(),)))

        body += walk_elements(record, field, check, IN, OUT)
    return body


def check_unpacked(naming: Naming, device: Device, record: RecordLayout) -> Body:
    """Refuses values that have been read; fields that measure others come last."""
    body: Body = ()
    for field in record.fields:

        def check(source: Expression, value: Expression, field: FieldLayout = field) -> Body:
            if field.record is not None:
                if not check_unpacked(naming, device, field.record):
                    return ()
                decode = naming.function("record", field.record.name, "decode")
                return return_error(naming, Call(decode, (source, unsigned(field.size), value.address())))
            if field.field.reserved:
                return ()
            wire = field_value(field)
            number = load(naming, wire, source) if field.field.measures is not None else value
            return check_loaded(naming, device, wire, source, number)

        body += walk_elements(record, field, check, OUT, IN)
    return (*body, *check_measures(naming, record))


def check_measures(naming: Naming, record: RecordLayout) -> Body:
    """Refuses numbers that have been read and do not measure what was read: errors of other fields come first."""
    body: Body = ()
    for field in record.fields:
        if field.field.measures is None:
            continue

        def compare(source: Expression, value: Expression, field: FieldLayout = field) -> Body:
            wrong = load(naming, field_value(field), source).differs(measured_size(record, field, OUT))
            return refuse(naming, wrong, "err_wrong_measure")

        body += walk_elements(record, field, compare, OUT, IN)
    return body


def _store_field(naming: Naming, record: RecordLayout, field: FieldLayout) -> Body:
    def store(target: Expression, value: Expression) -> Body:
        if field.record is not None:
            pack = naming.function("record", field.record.name, "pack")
            return (call(pack, *struct_argument(field.record, value), target),)
        wire = field_value(field)
        if field.field.measures is not None:
            return store_value(naming, wire, measured_size(record, field, IN), target)
        if not is_set_by_user(field):
            return store_constant(naming, wire, fixed_number(wire.value), target)
        return store_value(naming, wire, value, target)

    return walk_elements(record, field, store, IN, OUT)


def _load_field(naming: Naming, record: RecordLayout, field: FieldLayout) -> Body:
    def load_element(source: Expression, target: Expression) -> Body:
        if field.record is not None:
            unpack = naming.function("record", field.record.name, "unpack")
            return (call(unpack, source, target.address()),)
        return load_value(naming, field_value(field), source, target)

    return walk_elements(record, field, load_element, OUT, IN)
