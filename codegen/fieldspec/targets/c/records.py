"""Records and the data of messages: their structs, and the functions that encode and decode them."""

from __future__ import annotations

from fieldspec.codec.layout.record import CaseLayout, FieldLayout, RecordLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import bounds_of
from fieldspec.targets.c.declarations import BLANK, Comment, Declaration, Define, Function, Struct, comment
from fieldspec.targets.c.expressions import (
    CAPACITY,
    IN,
    INPUT_BYTES,
    LENGTH,
    OUT,
    OUTPUT_BYTES,
    SIZE_TYPE,
    Call,
    Conditional,
    Expression,
    Group,
    Type,
    any_of,
)
from fieldspec.targets.c.fields import (
    INNER_LENGTH,
    ElementBody,
    check_selector,
    count_member,
    declare_member,
    decoded_selector,
    element_size,
    encoded_selector,
    function_locals,
    is_set_by_user,
    measured_size,
    members,
    return_error,
    struct_argument,
    switch_cases,
    walk_elements,
)
from fieldspec.targets.c.inner_lists import decided_sizes, decode_inner_lists, encode_inner_lists
from fieldspec.targets.c.literals import ZERO, unsigned
from fieldspec.targets.c.naming import Naming, member
from fieldspec.targets.c.packing import check_measures, check_members, check_unpacked, declare_packing, is_packed
from fieldspec.targets.c.presences import check_presences, counts_in_image, following, present_sizes
from fieldspec.targets.c.statements import (
    Assignment,
    Body,
    Statement,
    Variable,
    assign,
    call,
    contains,
    discard,
    return_if,
)
from fieldspec.targets.c.values import (
    check_loaded,
    decode_value,
    encode_value,
    field_value,
    fixed_number,
    load,
    refuse,
    return_ok,
    status_type,
    store_constant,
    store_whole,
)
from fieldspec.targets.c.widths import decode_widths, encode_widths


def declare_record(naming: Naming, device: Device, record: RecordLayout, description: Comment) -> list[Declaration]:
    """The struct of a record, if it has members, and its functions."""
    name = naming.type("record", record.name)
    fields = members(record)
    plural = "s" * (record.size != 1)
    size = f"{record.size} byte{plural}" if record.size is not None else f"{record.least} to {record.most} bytes"
    assert record.most is not None
    declarations: list[Declaration] = [Define(naming.macro("record", record.name, "size"), unsigned(record.most))]
    if fields:
        struct_members = [part for field in fields for part in declare_member(naming, record, field)]
        declarations += [description, Struct(name, tuple(struct_members))]
    else:
        declarations.append(comment("It has no values, so it needs no struct."))
    checks: Body = ()
    varying, record = record, record.image
    if is_packed(record):
        checks = check_members(naming, device, record)
        declarations += [BLANK, *declare_packing(naming, record, checks, is_image=varying is not record)]
    writing = comment(f"Writes {name}: {size}.", "`length` receives the number of bytes written.")
    reading = comment(f"Reads {name} from exactly {size}.")
    inner = varying.inner_lists
    if varying.spans or inner is not None:
        last = "the list comes last" if inner is None or len(inner.lists) == 1 else "all lists come last"
        about_image = f"in which {last if inner is not None else 'each value has all the bytes that it may have'}"
        encode = encode_widths(naming, varying) if inner is None else encode_inner_lists(naming, varying, inner)
        decode = decode_widths(naming, varying) if inner is None else decode_inner_lists(naming, varying, inner)
        return [
            *declarations,
            *decided_sizes(naming, record),
            *present_sizes(naming, record),
            *following(naming, record),
            *(BLANK, comment(f"Writes the image of {name}, {about_image}.")),
            _encode_function(naming, device, record, bool(checks), "encode_image"),
            *(BLANK, writing, encode),
            *(BLANK, comment(f"Reads the image of {name}, {about_image}.")),
            _decode_function(naming, device, record, "decode_image"),
            *(BLANK, reading, decode),
        ]
    return [
        *declarations,
        *(BLANK, writing, _encode_function(naming, device, record, bool(checks))),
        *(BLANK, reading, _decode_function(naming, device, record)),
    ]


def _encode_function(
    naming: Naming, device: Device, record: RecordLayout, checked: bool, verb: str = "encode"
) -> Function:
    """`codec_status point_encode(const point *in, uint8_t *out, size_t capacity, size_t *length)`"""
    parameters = [
        Variable(OUTPUT_BYTES, "out"),
        Variable(SIZE_TYPE, "capacity"),
        Variable(Type("size_t", pointer=True), "length"),
    ]
    if members(record):
        struct = Type(naming.type("record", record.name), const=True, pointer=True)
        parameters.insert(0, Variable(struct, "in"))
    body: list[Statement] = []
    if record.fields:
        selector = encoded_selector(record.selector) if record.selector is not None else None
        if selector is not None:
            body.append(check_selector(naming, record, selector))
        for field in record.fields:
            body += _check_count(naming, record, field)
        size = _encoded_size(record)
        body += refuse(naming, CAPACITY.less(size), "err_capacity")
        body += _write_fields(naming, device, record, checked)
        body.append(assign(LENGTH.dereferenced(), size))
    else:
        body += [discard("out"), discard("capacity"), assign(LENGTH.dereferenced(), ZERO)]
    body.append(return_ok(naming))
    name = naming.function("record", record.name, verb)
    return Function(status_type(naming), name, tuple(parameters), tuple(body), function_locals(naming))


def _decode_function(naming: Naming, device: Device, record: RecordLayout, verb: str = "decode") -> Function:
    """`codec_status point_decode(const uint8_t *in, size_t length, point *out)`"""
    parameters = [Variable(INPUT_BYTES, "in"), Variable(SIZE_TYPE, "length")]
    if members(record):
        parameters.append(Variable(Type(naming.type("record", record.name), pointer=True), "out"))
    body: list[Statement] = [*_check_length(naming, record)]
    selector = decoded_selector(naming, record.selector) if record.selector is not None else None
    if selector is not None:
        body.append(check_selector(naming, record, selector))
    body += _check_repeated_length(naming, record)
    body += _read_fields(naming, device, record)
    if not contains(tuple(body), IN):
        body.insert(0, discard("in"))
    body.append(return_ok(naming))
    name = naming.function("record", record.name, verb)
    return Function(status_type(naming), name, tuple(parameters), tuple(body), function_locals(naming))


# Encoding


def _check_count(naming: Naming, record: RecordLayout, field: FieldLayout) -> Body:
    """`if (in->points_count < 1u || in->points_count > 8u) { return ERR_WRONG_LENGTH; }`"""
    repeat = field.field.repeat
    if repeat is None:
        return ()
    count = IN.arrow(count_member(record, field))
    tests: list[Expression] = [count.less(unsigned(repeat.low))] if repeat.low else []
    return refuse(naming, any_of([*tests, count.greater(unsigned(repeat.high))]), "err_wrong_length")


def _encoded_size(record: RecordLayout) -> Expression:
    """`28u`, or `(2u + in->points_count * 4u)`: the size of a record that is to be written."""
    if record.size is not None:
        return unsigned(record.size)
    last = record.fields[-1]
    repeated = last.field.repeat is not None
    count = IN.arrow(count_member(record, last)) if repeated else unsigned(last.count or 1)
    return Group(unsigned(last.offset) + (count * element_size(record, last)))


def _write_fields(naming: Naming, device: Device, record: RecordLayout, checked: bool) -> Body:
    """Checks the values of a record and writes them. `checked` says that a packed one has a function for checks."""
    if is_packed(record):
        check, pack = (naming.function("record", record.name, verb) for verb in ("check", "pack"))
        checks = return_error(naming, Call(check, (IN,))) if checked else ()
        return (*checks, call(pack, IN, OUT))
    body: Body = ()
    # Those that measure others come last: refusals of the others come first.
    for field in sorted(record.fields, key=lambda field: field.field.measures is not None):
        decider = field.selector or record.selector
        if field.cases and decider is not None:

            def write_case(case: CaseLayout, field: FieldLayout = field) -> Body:
                if not case.value.size:
                    return ()

                def write(target: Expression, value: Expression) -> Body:
                    wire = field_value(case)
                    if case.value.const is not None:
                        return store_constant(naming, wire, case.value.const, target)
                    return encode_value(naming, device, wire, value, target)

                return walk_elements(record, field, write, IN, OUT, case)

            number = encoded_selector(decider)
            body = (*body, switch_cases(naming, field, decider, number, write_case))
        else:
            body += walk_elements(record, field, _field_writer(naming, device, record, field), IN, OUT)
    return (*body, *check_bit_count(naming, record, IN), *check_presences(naming, record, IN))


def _field_writer(naming: Naming, device: Device, record: RecordLayout, field: FieldLayout) -> ElementBody:
    """Checks one element of a field and writes it."""

    def write(target: Expression, value: Expression) -> Body:
        if field.record is not None:
            return _write_record(naming, device, field.record, value, target)
        wire = field_value(field)
        if field.field.measures is not None:
            return _write_measure(naming, record, field, target)
        if not is_set_by_user(field):
            return store_constant(naming, wire, fixed_number(wire.value), target)
        return encode_value(naming, device, wire, value, target)

    return write


def _write_record(naming: Naming, device: Device, record: RecordLayout, value: Expression, target: Expression) -> Body:
    """Checks and writes a record within another."""
    if not is_packed(record):
        encode = naming.function("record", record.name, "encode")
        sizes = unsigned(record.most or 0), INNER_LENGTH.address()
        return return_error(naming, Call(encode, (*struct_argument(record, value), target, *sizes)))
    check, pack = (naming.function("record", record.name, verb) for verb in ("check", "pack"))
    struct = value.address()
    checks = return_error(naming, Call(check, (struct,))) if check_members(naming, device, record) else ()
    return (*checks, call(pack, struct, target))


def _write_measure(naming: Naming, record: RecordLayout, field: FieldLayout, target: Expression) -> Body:
    """`store_u8(out + 2, (uint8_t)(in->points_count * 4u));`, refused where the field cannot be that large."""
    wire = field_value(field)
    measured = measured_size(record, field, IN)
    highest = wire.value.ranges.high if wire.value.ranges else bounds_of(wire.encoding)[1]
    greatest = _greatest_measure(record, field)
    fits = (greatest is not None and greatest <= highest) or highest >= 2**31
    checks = () if fits else refuse(naming, measured.greater(unsigned(highest)), "err_out_of_range")
    return (*checks, store_whole(naming, wire, Group(measured), target))


def _greatest_measure(record: RecordLayout, field: FieldLayout) -> int | None:
    """The greatest size or count that a field can have to hold, None where that differs from case to case."""
    measure = field.measure
    assert measure is not None
    other = record.named(measure.field)
    assert other is not None
    if other.cases:
        return None
    repeat = other.field.repeat
    count = repeat.high if repeat is not None else other.count or 1
    return measure.number(count, other.size)


# Decoding


def _check_length(naming: Naming, record: RecordLayout) -> Body:
    """`if (length != 28u) { return length < 28u ? ERR_INCOMPLETE : ERR_WRONG_LENGTH; }`"""
    minimum, maximum = unsigned(record.least), unsigned(record.most or 0)
    if record.least and record.least == record.most:
        # One comparison where all is well.
        incomplete, wrong = naming.status("err_incomplete"), naming.status("err_wrong_length")
        return (return_if(LENGTH.differs(minimum), Conditional(LENGTH.less(minimum), incomplete, wrong)),)
    shorter = refuse(naming, LENGTH.less(minimum), "err_incomplete") if record.least else ()
    return (*shorter, *refuse(naming, LENGTH.greater(maximum), "err_wrong_length"))


def _check_repeated_length(naming: Naming, record: RecordLayout) -> Body:
    """Refuses a length that is not one of whole elements, and sets the number of them.

    `if ((length - 2u) % 4u != 0) { return ERR_WRONG_LENGTH; } out->points_count = (length - 2u) / 4u;`
    """
    if record.size is not None:
        return ()
    last = record.fields[-1]
    size, repeat = element_size(record, last), last.field.repeat
    low, high = (repeat.low, repeat.high) if repeat is not None else (last.count or 1, last.count or 1)
    body: Body = ()
    if last.splits_record:
        minimum, maximum = (unsigned(last.offset) + (unsigned(bound) * size) for bound in (low, high))
        if low:
            body += refuse(naming, LENGTH.less(minimum), "err_incomplete")
        body += refuse(naming, LENGTH.greater(maximum), "err_wrong_length")
    if repeat is None:
        return (*body, *counts_in_image(naming, record))
    # Where the list begins with the record, `- 0u` stays, so that all records read alike.
    rest = LENGTH - unsigned(last.offset)
    if last.splits_record or (last.size > 1 and low < high):
        body += refuse(naming, (rest % size).differs(ZERO), "err_wrong_length")
    count = OUT.arrow(count_member(record, last))
    return (*body, *counts_in_image(naming, record), Assignment(count, rest / size))


def _read_fields(naming: Naming, device: Device, record: RecordLayout) -> Body:
    """Reads the values of a record and checks them."""
    if is_packed(record):
        unpack = call(naming.function("record", record.name, "unpack"), IN, OUT)
        return (unpack, *check_unpacked(naming, device, record))
    body: Body = ()
    for field in record.fields:
        decider = field.selector or record.selector
        if field.cases and decider is not None:

            def read_case(case: CaseLayout, field: FieldLayout = field) -> Body:
                if not case.value.size:
                    return ()

                def read(source: Expression, value: Expression) -> Body:
                    return decode_value(naming, device, field_value(case), source, value)

                return walk_elements(record, field, read, OUT, IN, case)

            number = decoded_selector(naming, decider)
            body = (*body, switch_cases(naming, field, decider, number, read_case))
        else:
            body += walk_elements(record, field, _field_reader(naming, device, record, field), OUT, IN)
    checks = check_measures(naming, record)
    return (*body, *checks, *check_bit_count(naming, record, OUT), *check_presences(naming, record, OUT))


def _field_reader(naming: Naming, device: Device, record: RecordLayout, field: FieldLayout) -> ElementBody:
    """Reads one element of a field and checks it."""

    def read(source: Expression, value: Expression) -> Body:
        if field.record is not None:
            return _read_record(naming, device, field.record, value, source)
        wire = field_value(field)
        if field.field.measures is not None:
            return check_loaded(naming, device, wire, source, load(naming, wire, source))
        if field.field.reserved:
            return ()
        return decode_value(naming, device, wire, source, value)

    return read


def _read_record(naming: Naming, device: Device, record: RecordLayout, value: Expression, source: Expression) -> Body:
    """Reads and checks a record within another."""
    if is_packed(record) and not check_unpacked(naming, device, record):
        return (call(naming.function("record", record.name, "unpack"), source, value.address()),)
    decode = naming.function("record", record.name, "decode")
    size = unsigned(record.size) if record.size is not None else _sent_size(naming, record, source)
    arguments = source, size, *struct_argument(record, value)
    return return_error(naming, Call(decode, arguments))


def _sent_size(naming: Naming, record: RecordLayout, source: Expression) -> Expression:
    """`tag_sent_size(in + 3, 8u)`: the size of a record that tells it; it has been judged."""
    return Call(naming.function("record", record.name, "sent_size"), (source, unsigned(record.most or 0)))


def check_bit_count(naming: Naming, record: RecordLayout, struct: Expression) -> Body:
    """Refuses a number of bits that takes another number of bytes than there are.

    `if (in->count / 8u + (in->count % 8u + 7u) / 8u != in->bits_count) { return ERR_WRONG_MEASURE; }`
    """
    body: Body = ()
    for field in record.fields:
        packed = record.named(field.bits_of) if field.bits_of else None
        if packed is not None:
            number = struct.arrow(member(field.name))
            rest = Group((number % unsigned(8)) + unsigned(7))
            size = (number / unsigned(8)) + (rest / unsigned(8))
            actual_size = struct.arrow(count_member(record, packed))
            body = (*body, *refuse(naming, size.differs(actual_size), "err_wrong_measure"))
    return body
