"""A fuzz target for a header: everything that decodes gets any bytes, and what it takes is encoded again."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import has_single_bytes
from fieldspec.targets.c.conversions import count_type
from fieldspec.targets.c.declarations import Function, escape_comment
from fieldspec.targets.c.delimiters import is_wrapped
from fieldspec.targets.c.expressions import (
    INPUT_BYTES,
    SIZE_TYPE,
    Call,
    Conditional,
    Expression,
    Group,
    Identifier,
    Literal,
    SizeOf,
    Type,
    all_of,
)
from fieldspec.targets.c.fields import members
from fieldspec.targets.c.frames import header_parts
from fieldspec.targets.c.literals import NULL, ZERO, decimal, unsigned
from fieldspec.targets.c.lone_values import lone_pieces
from fieldspec.targets.c.naming import Naming, Noun, frame_member
from fieldspec.targets.c.packing import is_packed
from fieldspec.targets.c.printer import Printer
from fieldspec.targets.c.quantities import keeps_counts, scaled_values
from fieldspec.targets.c.runtime_files import all_records, copy_runtime, runtime_parts
from fieldspec.targets.c.statements import (
    Break,
    Constant,
    Evaluation,
    If,
    Return,
    Statement,
    Switch,
    Variable,
    assign,
    call,
)
from fieldspec.targets.c.values import WireValue, accessed_type, declare_value, status_type, type_name
from fieldspec.targets.templates import fill

_BYTE = Type("uint8_t")
_DATA, _SIZE, _OUT, _BUFFER, _OPENED, _LENGTH, _STATUS, _HEADER_SIZE = (
    Identifier(name) for name in ("data", "size", "out", "buffer", "opened", "length", "status", "GIVEN")
)
_LONGEST_LINE = 200
"""Calls that close a frame stay on one line."""

_YES, _NO = decimal(1), decimal(0)


def write_fuzz_target(layout: DeviceLayout, naming: Naming, header: str) -> str:
    """The C source of the fuzz target of a device."""
    directions = [(link, direction) for link in layout.links.values() for direction in ("request", "response")]
    frames = [Call(f"frame_{number}", (_DATA, _SIZE)) for number in range(2 * len(directions))]
    macros = [
        *_record_macros(layout, naming),
        *_value_macros(layout, naming),
        *_address_and_conversion_macros(layout, naming),
    ]
    choices = [*frames, *macros]
    used = {macro.function for macro in macros}
    functions = [
        function
        for number, (link, direction) in enumerate(directions)
        for function in (
            _open_any_bytes(naming, link, direction, 2 * number),
            _close_any_body(naming, link, direction, 2 * number + 1),
        )
    ]
    printer = Printer(longest_line=_LONGEST_LINE)
    branches = tuple([((decimal(index),), (Evaluation(choice),)) for index, choice in enumerate(choices)])
    return fill(
        "c/fuzz.c.j2",
        header=header,
        source=header.replace(".h", "_fuzz.c"),
        title=escape_comment(f"{layout.device.name}, version {layout.device.version}"),
        identity=layout.identity,
        macros=[
            f"\n{copy_runtime(naming, 'fuzz_macros.h', name).text.rstrip()}\n"
            for name in runtime_parts("fuzz_macros.h")
            if name in used
        ],
        functions=["\n".join(["", *printer.print_declarations([function]), ""]) for function in functions],
        choices="\n".join(printer.print_statements([Switch(Identifier("choice"), branches, (Break(),))], "    ")),
        number_of_choices=str(len(choices)),
    )


# Calls of the macros in runtime/fuzz_macros.h


def _is_exact(record: RecordLayout) -> bool:
    """Whether every byte of a record comes back: no reserved ones, and no value that other bytes are too."""
    encodings = [field.value.encoding for field in record.fields if field.value is not None]
    encodings += [case.value.encoding for field in record.fields for case in field.cases]
    inner = [_is_exact(field.record) for field in record.fields if field.record is not None]
    reserved = any(field.field.reserved for field in record.fields)
    return not reserved and not record.spans and all(map(has_single_bytes, encodings)) and all(inner)


def _flag(holds: bool) -> Literal:
    return _YES if holds else _NO


def _names(*names: str) -> tuple[Identifier, ...]:
    return tuple([Identifier(name) for name in names])


def _record_macros(layout: DeviceLayout, naming: Naming) -> Iterator[Call]:
    for record in all_records(layout):
        decode, encode = (naming.function("record", record.name, verb) for verb in ("decode", "encode"))
        size = naming.macro("record", record.name, "size")
        exact = _flag(_is_exact(record))
        if not members(record):
            yield Call("FIXED", (*_names(decode, encode, size), exact))
            continue
        struct = naming.type("record", record.name)
        yield Call("RECORD", (*_names(struct, decode, encode, size), exact))
        if is_packed(record):
            unpack, pack = (naming.function("record", record.name, verb) for verb in ("unpack", "pack"))
            yield Call("PACKED", _names(struct, unpack, pack, size))


def _value_macros(layout: DeviceLayout, naming: Naming) -> Iterator[Call]:
    return lone_pieces("c macro", layout, naming, lambda lone: (_value_macro(naming, layout.device, *lone),))


def _value_macro(
    naming: Naming, device: Device, noun: Noun, names: tuple[str, ...], wire: WireValue, size: int, trigger: bool
) -> Call:
    """A device may return any number for a trigger, even if its enum is closed."""
    answer = wire.value.as_answer(trigger)
    kind = Identifier(accessed_type(naming, device, answer))
    functions = _names(*(naming.function(noun, *names, verb) for verb in ("decode", "encode")))
    if wire.value.const is not None:
        return Call("CONSTANT", (kind, *functions, unsigned(size)))
    if wire.is_array:
        exact = _flag(has_single_bytes(wire.encoding) and wire.size == size)
        declared = Identifier(Printer().print_variable(declare_value(wire, "value")))
        return Call("ARRAY", (declared, *functions, exact, unsigned(size)))
    sizes = unsigned(wire.size), unsigned(size)
    argument = Identifier(accessed_type(naming, device, wire.value))
    if wire.value.write_word_order:
        return Call("TURNED", (kind, argument, *functions, unsigned(size)))
    if not has_single_bytes(wire.encoding):
        return Call("SEVERAL_FORMS", (kind, argument, *functions, unsigned(size)))
    if answer == wire.value:
        return Call("VALUE", (kind, *functions, *sizes))
    return Call("TRIGGER", (kind, argument, *functions, *sizes))


def _address_and_conversion_macros(layout: DeviceLayout, naming: Naming) -> Iterator[Call]:
    for table in layout.tables.values():
        if table.table.base_by:
            yield Call("MOVING_ADDRESS", _names("uint16_t", naming.function("table", table.name, "at")))
            continue
        yield Call("ADDRESS", _names("uint16_t", naming.function("table", table.name, "at")))
    for conversion in layout.device.conversions.values():
        functions = [naming.function("conversion", conversion.name, end) for end in ("from_raw", "to_raw")]
        exact = _flag(keeps_counts(conversion.type.encoding))
        yield Call("CONVERSION", (*_names(count_type(conversion), *functions), exact))
    for scaled in scaled_values(layout):
        functions = [scaled.function(naming, end) for end in ("from_raw", "to_raw")]
        types = type_name(scaled.value), type_name(scaled.exponent.value)
        yield Call("QUANTITY", (*_names(*types, *functions), _flag(keeps_counts(scaled.value.encoding))))


# Functions for frames


def _hold(test: Expression) -> Evaluation:
    """`hold(test);`"""
    return call("hold", test)


def _declare_variables(naming: Naming, link: LinkLayout, direction: str) -> list[Statement]:
    """The buffers, the opened frame and the length that both functions have."""
    largest = Identifier("LARGEST")
    buffer = Variable(_BYTE, "buffer", (decimal(2) * largest,), storage="static")
    return [
        *([buffer] if is_wrapped(link) else []),
        Variable(_BYTE, "out", (decimal(4) * largest,), storage="static"),
        Variable(Type(naming.type("link", link.name, direction, "frame")), "opened"),
        Variable(SIZE_TYPE, "length", value=ZERO),
    ]


def _clear_opened() -> Evaluation:
    return call("memset", _OPENED.address(), ZERO, SizeOf(_OPENED))


def _open_call(naming: Naming, link: LinkLayout, direction: str, data: Expression, size: Expression) -> Call:
    buffer = (_BUFFER, SizeOf(_BUFFER)) if is_wrapped(link) else ()
    function = naming.function("link", link.name, direction, "open")
    return Call(function, (data, size, *buffer, _OPENED.address()))


def _flag_of(link: LinkLayout, direction: str) -> int:
    """The flag that an exception response has in its code, 0 for requests and for links without one."""
    return (
        link.link.exception_response.flag if link.link.exception_response is not None and direction == "response" else 0
    )


def _frame_function(number: int, body: list[Statement]) -> Function:
    parameters = Variable(INPUT_BYTES, "data"), Variable(SIZE_TYPE, "size")
    return Function(Type("void"), f"frame_{number}", parameters, tuple(body), storage="static")


def _open_any_bytes(naming: Naming, link: LinkLayout, direction: str, number: int) -> Function:
    """Opens any bytes, and makes a frame of what it finds."""
    frame = link.frame(direction)
    ok, body_member = naming.status("ok"), _OPENED.member("body")
    body_length = _OPENED.member("body_length")
    arguments: list[Expression] = [_OPENED.member(frame_member(part)) for part in header_parts(frame)]
    flag = _flag_of(link, direction)
    if frame.role("code") is not None:
        code: Expression = _OPENED.member("code")
        if flag:
            error = Group(Conditional(_OPENED.member("error"), unsigned(flag), unsigned(0)))
            code = code | error
        arguments.append(code)
    start, end = (_BUFFER, SizeOf(_BUFFER)) if is_wrapped(link) else (_DATA, _SIZE)
    is_within_buffer = all_of([body_member.at_least(start), (body_member + body_length).at_most(start + end)])
    tests: list[Expression] = [_LENGTH.equals(_SIZE)]
    if link.link.transmission != "hex_ascii":
        # Characters have two ways to write a digit; bytes have one.
        tests.append(Call("memcmp", (_OUT, _DATA, _SIZE)).equals(ZERO))
    closed = Call(
        naming.function("link", link.name, direction, "close"),
        (*arguments, body_length, _OUT, SizeOf(_OUT), _LENGTH.address()),
    )
    return _frame_function(
        number,
        [
            *_declare_variables(naming, link, direction),
            _clear_opened(),
            If(_open_call(naming, link, direction, _DATA, _SIZE).differs(ok), (Return(),)),
            _hold(is_within_buffer),
            call("memcpy", _OUT + decimal(frame.header_size), body_member, body_length),
            If(closed.equals(ok), (_hold(all_of(tests)),)),
        ],
    )


def _close_any_body(naming: Naming, link: LinkLayout, direction: str, number: int) -> Function:
    """Closes a frame around any bytes, and opens it again; the first bytes are the parts before the body."""
    frame = link.frame(direction)
    ok = naming.status("ok")
    names = [frame_member(part) for part in header_parts(frame)]
    has_code = frame.role("code") is not None
    flag = _flag_of(link, direction)
    header = [_DATA.element(decimal(index)) for index in range(len(names) + has_code)]
    tests: list[Expression] = [_OPENED.member(name).equals(header[index]) for index, name in enumerate(names)]
    if has_code:
        code: Expression = header[-1]
        if flag:
            code = Group(code & unsigned(255 & ~flag))
        tests.append(_OPENED.member("code").equals(code))
    size = _SIZE - _HEADER_SIZE
    body, opened_body = _DATA + _HEADER_SIZE, _OPENED.member("body")
    tests.append(_OPENED.member("body_length").equals(size))
    tests.append(all_of([opened_body.differs(NULL), Call("memcmp", (opened_body, body, size)).equals(ZERO)]))
    closed = Call(
        naming.function("link", link.name, direction, "close"),
        (*header, size, _OUT, SizeOf(_OUT), _LENGTH.address()),
    )
    unknown_code = _STATUS.equals(naming.status("err_unknown_code"))
    return _frame_function(
        number,
        [
            Constant("GIVEN", decimal(len(header))),
            *_declare_variables(naming, link, direction),
            Variable(status_type(naming), "status"),
            _clear_opened(),
            *([If(_SIZE.less(_HEADER_SIZE), (Return(),))] if header else []),
            call("memcpy", _OUT + decimal(frame.header_size), body, size),
            If(closed.differs(ok), (Return(),)),
            assign(_STATUS, _open_call(naming, link, direction, _OUT, _LENGTH)),
            *([If(unknown_code, (Return(),))] if has_code else []),
            _hold(_STATUS.equals(ok)),
            *(_hold(test) for test in tests),
        ],
    )
