"""What self-tests expect of the example frames."""

from __future__ import annotations

from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.escapes import EscapeError
from fieldspec.codec.layout.frame import LinkLayout, original_parts
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.values import body_of, raw_values
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Example
from fieldspec.targets.c.assertions import (
    LENGTH,
    clear_variable,
    expect,
    expect_bytes,
    expect_equal,
    expect_members,
    same_array,
    set_members,
)
from fieldspec.targets.c.delimiters import is_wrapped
from fieldspec.targets.c.expressions import SIZE_TYPE, Call, Expression, Identifier, SizeOf, Type
from fieldspec.targets.c.fields import members
from fieldspec.targets.c.frames import header_parts
from fieldspec.targets.c.literals import FALSE, TRUE, ZERO, byte_initializer, decimal, unsigned
from fieldspec.targets.c.machine import literal
from fieldspec.targets.c.naming import Naming, frame_member
from fieldspec.targets.c.parts import part_value
from fieldspec.targets.c.sample_values import form_of_values, record_value
from fieldspec.targets.c.statements import If, Statement, Variable, Variables, assign, call
from fieldspec.targets.c.values import status_type

_BYTE = Type("uint8_t")
_FRAME, _RECEIVED, _BUFFER, _OPENED = (Identifier(name) for name in ("frame", "received", "buffer", "opened"))
_IN, _OUT, _AGAIN, _STATUS = (Identifier(name) for name in ("in", "out", "again", "status"))

_SIZE_OF_FRAME = SizeOf(_FRAME)
_OPEN_ARGUMENTS = _RECEIVED, SizeOf(_RECEIVED)
_BUFFER_ARGUMENTS = _BUFFER, SizeOf(_BUFFER)
_RECEIVE = call("copy", _RECEIVED, _FRAME, _SIZE_OF_FRAME), clear_variable(_OPENED.address())
_BODY = _OPENED.member("body"), _OPENED.member("body_length")
_IN_POINTER, _OUT_POINTER = _IN.address(), _OUT.address()
_SAME_FRAME = same_array(_AGAIN, _FRAME)
_RECEIVED_VARIABLE, _BUFFER_VARIABLE = (Variable(_BYTE, name, (_SIZE_OF_FRAME,)) for name in ("received", "buffer"))
_LENGTH_VARIABLE = Variable(SIZE_TYPE, "length", value=ZERO)
_CLEAR_STRUCTS = clear_variable(_IN_POINTER), clear_variable(_OUT_POINTER)
_ENCODE_ARGUMENTS = _AGAIN, SizeOf(_AGAIN), LENGTH.address()


def test_example(layout: DeviceLayout, naming: Naming, example: Example) -> list[Statement]:
    """Opens a frame, decodes its body, compares every member, and writes the frame again."""
    link = layout.links[example.link]
    description = f"example {example.id}"
    body: list[Statement] = [
        Variable(_BYTE, "frame", (None,), byte_initializer(example.frame), "static const"),
        _RECEIVED_VARIABLE,
    ]
    buffer: tuple[Expression, ...] = ()
    if is_wrapped(link):
        body.append(_BUFFER_VARIABLE)
        buffer = _BUFFER_ARGUMENTS
    body.append(Variable(Type(naming.type("link", link.name, example.direction, "frame")), "opened"))
    open_frame = naming.function("link", link.name, example.direction, "open")
    opened = Call(open_frame, (*_OPEN_ARGUMENTS, *buffer, _OPENED.address()))
    if example.refused:
        return [*body, *_expect_refusal(layout, naming, example, opened)]
    record = body_of(layout, link.name, example.direction, example.message, example.exception_response)
    values = raw_values(layout, example)
    form = form_of_values(record, values)
    struct_values: dict[str, Any] = {name: value for name, value in values.items() if record.named(name) is not None}
    has_struct = bool(members(record))
    if has_struct:
        body.append(Variables(Type(naming.type("record", record.name)), ("in", "out")))
    shape = link.frame(example.direction)
    room = _SIZE_OF_FRAME + decimal(len(shape.further) + len(shape.start) + len(shape.end))
    body += [Variable(_BYTE, "again", (room,)), _LENGTH_VARIABLE]
    if has_struct:
        body += _CLEAR_STRUCTS
    body += [*_RECEIVE, expect_equal(f"{description} opens", opened, naming.status("ok"))]
    body += _expect_header(link, example, values, description)
    struct = (_OUT_POINTER,) if has_struct else ()
    decoded = Call(naming.function("record", record.name, "decode"), (*_BODY, *struct))
    body.append(expect_equal(f"{description} decodes", decoded, naming.status("ok")))
    body += expect_members(naming, form, struct_values, _OUT, description)
    body += set_members(naming, form, _complete(layout.device, form.record, struct_values), _IN)
    encoded = Call(*_encode_frame(layout, naming, example, values, record))
    body.append(expect_equal(f"{description} encodes", encoded, naming.status("ok")))
    sent_frame = shape.as_sent(example.frame)
    if sent_frame == example.frame:
        return [*body, expect(_SAME_FRAME, f"{description} bytes")]
    same_size = expect_equal(f"{description} size", LENGTH, unsigned(len(sent_frame)))
    return [*body, same_size, expect_bytes(f"{description} bytes", _AGAIN, sent_frame)]


def _complete(device: Device, record: RecordLayout, values: dict[str, Any]) -> dict[str, Any]:
    """Values for all members of a record: low ones for those that have none."""
    return (
        values if all(field.name in values for field in members(record)) else {**record_value(device, record), **values}
    )


def _expect_header(link: LinkLayout, example: Example, values: dict[str, Any], description: str) -> list[Statement]:
    """Compares the parts before the body."""
    frame = link.frame(example.direction)
    body: list[Statement] = []
    for part in header_parts(frame):
        number = _header_number(part, int(values[part.name]))
        body.append(expect_equal(f"{description}: {part.name}", _OPENED.member(frame_member(part)), number))
    if frame.role("code") is not None:
        body.append(expect_equal(f"{description}: code", _OPENED.member("code"), _code(link, example)))
    if example.direction == "response" and link.link.exception_response is not None:
        body.append(
            expect_equal(
                f"{description}: error", _OPENED.member("error"), TRUE if example.exception_response else FALSE
            )
        )
    return body


def _code(link: LinkLayout, example: Example) -> Expression:
    code, _ = _frame_code(link, example)
    assert code is not None
    return unsigned(code)


def _header_number(part: PartLayout, number: int) -> Expression:
    """The number of a part before the body, as a constant."""
    value = part_value(part).value
    return literal(value.encoding, number)


def _frame_code(link: LinkLayout, example: Example) -> tuple[int | None, bool]:
    """The code in a frame without the flag of an error reply, and whether that is set; None where there is none."""
    shape = link.frame(example.direction)
    start, end = shape.surplus(example.frame) + len(shape.start), len(example.frame) - len(shape.end)
    data, part = example.frame[start:end], shape.role("code")
    if link.link.transmission == "hex_ascii":
        pairs = [data[offset : offset + 2] for offset in range(0, len(data), 2)]
        data = bytes(int(pair, 16) for pair in pairs if all(digit in b"0123456789ABCDEFabcdef" for digit in pair))
    shape = link.frame(example.direction)
    if shape.escape is not None:
        try:
            data = original_parts(shape, data)
        except EscapeError:
            return None, False
    if part is None or len(data) < part.offset + part.size:
        return None, False
    number = part.read(data[part.offset : part.offset + part.size])
    if number is None:
        return None, False
    error = link.link.exception_response
    if error is None or example.direction == "request" or not number & error.flag:
        return number, False
    return number & ~error.flag, True


def _refused_body(layout: DeviceLayout, example: Example) -> RecordLayout | None:
    """The record in the body of a frame that may be wrong, None where nothing says which it is."""
    link = layout.links[example.link]
    unanswered = example.message in link.messages and example.message not in link.carried(example.direction)
    if unanswered and not example.exception_response:
        return None
    if example.message:
        return body_of(layout, link.name, example.direction, example.message, example.exception_response)
    code, is_error = _frame_code(link, example)
    if is_error and link.link.exception_response is not None:
        return layout.records[link.link.exception_response.record]
    message = link.message_with_code(code, example.direction) if code is not None else None
    return message.data(example.direction) if message is not None else None


def _expect_refusal(layout: DeviceLayout, naming: Naming, example: Example, opened: Call) -> list[Statement]:
    """The frame, or the body in it, is refused for the reason of the example."""
    error = naming.status(f"err_{example.refused}")
    description = f"example {example.id}"
    record = _refused_body(layout, example)
    if record is None:
        return [*_RECEIVE, expect_equal(description, opened, error)]
    has_struct = bool(members(record))
    struct = (_OUT_POINTER,) if has_struct else ()
    decoded = Call(naming.function("record", record.name, "decode"), (*_BODY, *struct))
    return [
        *([Variable(Type(naming.type("record", record.name)), "out")] if has_struct else []),
        Variable(status_type(naming), "status"),
        *_RECEIVE,
        *([clear_variable(_OUT_POINTER)] if has_struct else []),
        assign(_STATUS, opened),
        If(_STATUS.equals(naming.status("ok")), (assign(_STATUS, decoded),)),
        expect_equal(description, _STATUS, error),
    ]


def _encode_frame(
    layout: DeviceLayout, naming: Naming, example: Example, values: dict[str, Any], record: RecordLayout
) -> tuple[str, tuple[Expression, ...]]:
    """The function that writes the whole frame, and its arguments."""
    link = layout.links[example.link]
    frame = link.frame(example.direction)
    arguments: list[Expression] = [_header_number(part, int(values[part.name])) for part in header_parts(frame)]
    if example.exception_response and frame.role("code") is not None:
        arguments.append(_code(link, example))
    if members(record):
        arguments.append(_IN_POINTER)
    name = "exception_response" if example.exception_response else example.message
    direction = () if example.exception_response else (example.direction,)
    function = naming.function("link", link.name, "encode", name, *direction)
    return function, (*arguments, *_ENCODE_ARGUMENTS)
