"""The frames of messages: functions that encode the body to where it lies in a frame, then close the frame."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.c.declarations import BLANK, Declaration, Function, comment
from fieldspec.targets.c.exceptions import check_mark
from fieldspec.targets.c.expressions import CAPACITY, IN, LENGTH, OUT, SIZE_TYPE, Call, Expression, Identifier, Type
from fieldspec.targets.c.fields import members, return_error
from fieldspec.targets.c.frames import DIRECTIONS, OUTPUT_PARAMETERS, header_parameters
from fieldspec.targets.c.literals import ZERO, decimal, unsigned
from fieldspec.targets.c.naming import Naming, argument
from fieldspec.targets.c.parts import address_literal, code_type
from fieldspec.targets.c.statements import Body, Return, Variable
from fieldspec.targets.c.values import refuse, status_type

_CODE, _BODY_LENGTH = Identifier("code"), Identifier("body_length")


def declare_messages(naming: Naming, layout: DeviceLayout, link: LinkLayout) -> list[Declaration]:
    """The functions for all messages of a link, and the one for its exception response."""
    declarations: list[Declaration] = []
    for message in link.messages.values():
        for direction in DIRECTIONS:
            if message.name not in link.carried(direction):
                continue
            code = message.message.code_of(direction) if link.frame(direction).role("code") is not None else None
            data = message.data(direction)
            barred = link.barred_address(message) if direction == "request" else None
            declarations += [BLANK, *_declare_message(naming, link, direction, data, message.name, code, barred)]
    if link.link.exception_response is not None:
        declarations += [BLANK, *_declare_exception_response(naming, layout, link)]
    return declarations


def _declare_message(
    naming: Naming,
    link: LinkLayout,
    direction: str,
    data: RecordLayout,
    name: str,
    code: int | None,
    barred: int | None,
) -> list[Declaration]:
    """The function that writes the whole frame of a message; `barred` is the broadcast address that it refuses.

    `codec_status rtu_encode_move_request(uint8_t unit_address, const move_request *in, uint8_t *out, ...)`
    """
    function = naming.function("link", link.name, "encode", name, direction)
    codes = [unsigned(code)] if code is not None else []
    description = comment(f"Writes the whole frame of the {direction} {data.name}.")
    return [description, _encode_frame(naming, link, direction, data, function, [], codes, barred=barred)]


def _declare_exception_response(naming: Naming, layout: DeviceLayout, link: LinkLayout) -> list[Declaration]:
    """The function that writes an exception response to a code: `code | 128u`"""
    error = link.link.exception_response
    assert error is not None
    function = naming.function("link", link.name, "encode", "exception_response")
    record = layout.records[error.record]
    if link.has_uncoded_exceptions:
        description = comment("Writes the whole frame of an exception response.")
        return [description, _encode_frame(naming, link, "response", record, function, [], (), True)]
    code: list[Expression] = [_CODE | unsigned(error.flag) if error.flag else _CODE]
    parameters = [Variable(code_type(link.response), "code")]
    description = comment("Writes the whole frame of an exception response to a code.")
    if error.code is None and link.has_response_codes:
        description = comment("Writes the whole frame of an exception response, by the code of the usual response.")
    return [description, _encode_frame(naming, link, "response", record, function, parameters, code, True)]


def _encode_frame(
    naming: Naming,
    link: LinkLayout,
    direction: str,
    data: RecordLayout,
    function: str,
    code_parameters: list[Variable],
    code: Sequence[Expression],
    is_exception: bool = False,
    barred: int | None = None,
) -> Function:
    """The function that encodes the body to where it lies in the frame, then closes the frame."""
    frame = link.frame(direction)
    header = header_parameters(frame)
    parameters = [*header, *code_parameters]
    if members(data):
        parameters.append(Variable(Type(naming.type("record", data.name), const=True, pointer=True), "in"))
    close = naming.function("link", link.name, direction, "close")
    body_length = _BODY_LENGTH if data.fields else ZERO
    arguments = [*(Identifier(parameter.name) for parameter in header), *code, body_length, OUT, CAPACITY, LENGTH]
    body: Body = (
        *(_write_body(naming, frame, data) if data.fields else ()),
        *(_refuse_broadcast(naming, frame, barred) if barred is not None else ()),
        *check_mark(naming, link, frame, is_exception),
        Return(Call(close, tuple(arguments))),
    )
    return Function(status_type(naming), function, (*parameters, *OUTPUT_PARAMETERS), body)


def _refuse_broadcast(naming: Naming, frame: FrameLayout, address: int) -> Body:
    """`if (unit_address == 0) { return ERR_OUT_OF_RANGE; }`"""
    part = frame.role("unit_address")
    assert part is not None
    return refuse(naming, Identifier(argument(part)).equals(address_literal(address)), "err_out_of_range")


def _write_body(naming: Naming, frame: FrameLayout, data: RecordLayout) -> Body:
    """Encodes the body of a frame to where it lies in it."""
    struct = (IN,) if members(data) else ()
    size = frame.header_size
    room: tuple[Expression, ...] = (OUT, CAPACITY)
    checks: Body = ()
    if size:
        room = OUT + decimal(size), CAPACITY.plus(-size)
        checks = refuse(naming, CAPACITY.less(unsigned(size)), "err_capacity")
    encode = naming.function("record", data.name, "encode")
    return (
        Variable(SIZE_TYPE, "body_length", value=ZERO),
        Variable(status_type(naming), "status"),
        *checks,
        *return_error(naming, Call(encode, (*struct, *room, _BODY_LENGTH.address()))),
    )
