"""Frames of a link: how they are opened and closed, and the frames of each message."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.targets.c.checksums import compute_checksum, is_wrong, store_checksum
from fieldspec.targets.c.declarations import BLANK, Comment, Declaration, Function, Struct, comment, describe_fact
from fieldspec.targets.c.delimiters import declare_unwrap, is_wrapped, unwrap_function, wrap_frame
from fieldspec.targets.c.escapes import escape_bytes, keeps_size
from fieldspec.targets.c.exceptions import mark_in_data, read_mark
from fieldspec.targets.c.expressions import (
    CAPACITY,
    IN,
    INPUT_BYTES,
    LENGTH,
    OUT,
    OUTPUT_BYTES,
    SIZE_TYPE,
    Call,
    Expression,
    Identifier,
    Type,
    all_of,
    any_of,
)
from fieldspec.targets.c.fields import return_error
from fieldspec.targets.c.literals import ZERO, unsigned
from fieldspec.targets.c.naming import Naming, argument, frame_member
from fieldspec.targets.c.parts import (
    TOTAL,
    check_digits,
    code_type,
    length_number,
    load_part,
    part_pointer,
    part_value,
    write_part,
    write_shared_bytes,
)
from fieldspec.targets.c.statements import Body, Return, Statement, Variable, assign, discard
from fieldspec.targets.c.subcodes import read_subcode, shared_codes, subcode_type
from fieldspec.targets.c.values import check_constant, declare_value, refuse, return_ok, status_type

DIRECTIONS = ("request", "response")
_SIZE_POINTER = Type("size_t", pointer=True)
_BODY_LENGTH = Identifier("body_length")


def header_parts(frame: FrameLayout) -> list[PartLayout]:
    """The parts before the body that users set: neither the length nor the code, nor a constant."""
    return [part for part in frame.header if part.is_argument]


def declare_link(naming: Naming, layout: DeviceLayout, link: LinkLayout) -> list[Declaration]:
    """The structs of opened frames, and the functions that open and close frames."""
    declarations: list[Declaration] = [describe_fact(link.link, f"Frames are {_describe_form(link)}.")]
    if is_wrapped(link):
        for direction in DIRECTIONS[:1] if link.link.has_common_delimiters else DIRECTIONS:
            declarations += [*declare_unwrap(naming, link, direction), BLANK]
    for direction in DIRECTIONS:
        declarations += [*_declare_struct(naming, link, direction), BLANK]
        declarations += [*_declare_open(naming, link, direction), BLANK]
        declarations += [*_declare_close(naming, layout, link, direction), BLANK]
    return declarations[:-1]


def _describe_form(link: LinkLayout) -> str:
    text = "binary" if link.link.transmission == "binary" else "hexadecimal characters"
    escaped = ", escaped" if link.link.escape is not None else ""
    if link.link.has_common_delimiters:
        delimiters = _describe_delimiters(link.request)
        return (f"{text}; they {delimiters}" if delimiters else text) + escaped
    descriptions = (
        f"{direction}s {_describe_delimiters(link.frame(direction)) or 'have no delimiters'}"
        for direction in DIRECTIONS
    )
    return f"{text}; {', '.join(descriptions)}{escaped}"


def _describe_delimiters(frame: FrameLayout) -> str:
    """`begin with 3A and end with 0D 0A`"""
    mark = frame.start[frame.preamble.least :] if frame.preamble is not None else frame.start
    preamble = [f"begin with a preamble, {frame.preamble.text()}"] if frame.preamble is not None else []
    start = [f"begin with {mark.hex(' ').upper()}"] if mark else []
    end = [f"end with {frame.end.hex(' ').upper()}"] if frame.end else []
    return " and ".join([*preamble, *start, *end])


def _declare_struct(naming: Naming, link: LinkLayout, direction: str) -> list[Declaration]:
    """The struct of an opened frame."""
    frame = link.frame(direction)
    struct_members: list[Comment | Variable] = []
    for part in header_parts(frame):
        struct_members += [describe_fact(part.part), declare_value(part_value(part), frame_member(part))]
    if frame.role("code") is not None:
        description = comment("The code, without the flag of an exception response.")
        struct_members += [description, Variable(code_type(frame), "code")]
    if shared := shared_codes(link, direction):
        description = comment(
            "What tells messages with this code apart; 0 for other codes and for exception responses."
        )
        struct_members += [description, Variable(subcode_type(shared.values()), "subcode")]
    if direction == "response" and link.link.exception_response is not None:
        description = comment("The frame is an exception response; its body is the record of the exception.")
        struct_members += [description, Variable(Type("bool"), "error")]
    struct_members += [Variable(INPUT_BYTES, "body"), Variable(SIZE_TYPE, "body_length")]
    return [
        comment(f"An opened {direction}: its header, and where its body is."),
        Struct(naming.type("link", link.name, direction, "frame"), tuple(struct_members)),
    ]


# Opening


def _declare_open(naming: Naming, link: LinkLayout, direction: str) -> list[Declaration]:
    """The function that checks a frame and finds its body.

    `codec_status rtu_request_open(const uint8_t *frame, size_t size, rtu_request_frame *out)`
    """
    frame = link.frame(direction)
    paragraphs = ["Checks a frame and finds its body."]
    parameters = [Variable(INPUT_BYTES, "frame"), Variable(SIZE_TYPE, "size")]
    body: list[Statement] = []
    if is_wrapped(link):
        paragraphs.append("`buffer` receives the bytes of the frame, and the body points into it.")
        parameters += [Variable(OUTPUT_BYTES, "buffer"), Variable(SIZE_TYPE, "capacity")]
        received = Identifier("frame"), Identifier("size"), Identifier("buffer"), CAPACITY, LENGTH.address()
        body += [
            Variable(INPUT_BYTES, "in", value=Identifier("buffer")),
            Variable(SIZE_TYPE, "length", value=ZERO),
            Variable(status_type(naming), "status"),
            *return_error(naming, Call(unwrap_function(naming, link, direction), received)),
        ]
    else:
        body += [
            Variable(INPUT_BYTES, "in", value=Identifier("frame")),
            Variable(SIZE_TYPE, "length", value=Identifier("size")),
        ]
    parameters.append(Variable(Type(naming.type("link", link.name, direction, "frame"), pointer=True), "out"))
    parts_size = frame.header_size + frame.trailer_size
    if parts_size:
        body += refuse(naming, LENGTH.less(unsigned(parts_size)), "err_incomplete")
    if frame.escape is not None:
        body += _check_frame(naming, frame, False)
        body += escape_bytes(naming, link, frame, Identifier("buffer"), LENGTH)
    if parts_size and not keeps_size(frame):
        body += refuse(naming, LENGTH.less(unsigned(parts_size)), "err_incomplete")
    body += _check_frame(naming, frame, True)
    for part in header_parts(frame):
        body.append(assign(OUT.arrow(frame_member(part)), load_part(naming, part)))
    body += _read_code(naming, link, frame)
    # Where no message is answered, every code is refused and there is no body to return.
    if not isinstance(body[-1], Return):
        body += [
            assign(OUT.arrow("body"), IN.plus(frame.header_size)),
            assign(OUT.arrow("body_length"), LENGTH.plus(-parts_size)),
            return_ok(naming),
        ]
    name = naming.function("link", link.name, direction, "open")
    return [comment(*paragraphs), Function(status_type(naming), name, tuple(parameters), tuple(body))]


def _is_sent(frame: FrameLayout, part: PartLayout) -> bool:
    """Whether a length or a checksum is that of the bytes which are sent, not of those before they are escaped."""
    return frame.escape is not None and not part.before_escape


def _check_frame(naming: Naming, frame: FrameLayout, is_original: bool) -> Body:
    """Refuses a wrong length, a wrong checksum and wrong constants, in this order.

    Before bytes are turned into the original ones, only the lengths and checksums of what is sent are compared.
    """
    early = tuple(length for length in frame.lengths if _is_sent(frame, length) and length.form)
    body = check_digits(naming, frame.digits if is_original else early)
    for length in frame.lengths:
        if _is_sent(frame, length) == is_original:
            continue
        received = load_part(naming, length)
        number, unrepresentable = length_number(frame, length, LENGTH)
        body += refuse(naming, any_of([*unrepresentable, received.differs(number)]), "err_wrong_length")
    for checksum in frame.checksums:
        if _is_sent(frame, checksum) == is_original:
            continue
        computed = compute_checksum(naming, checksum, IN, LENGTH)
        test = is_wrong(naming, checksum, computed, part_pointer(IN, checksum, LENGTH))
        body += refuse(naming, test, "err_wrong_checksum")
    for part in frame.constants if is_original else ():
        body += check_constant(naming, part_value(part), load_part(naming, part))
    return body


def _read_code(naming: Naming, link: LinkLayout, frame: FrameLayout) -> Body:
    """Reads the code, takes the flag of an exception response off it, and refuses a code that no message has."""
    part = frame.role("code")
    code, error = OUT.arrow("code"), OUT.arrow("error")
    if part is None:
        exception = link.link.exception_response
        if exception is None or frame.direction == "request":
            return ()
        if link.mark is not None:
            return (assign(error, mark_in_data(link.mark, frame)),)
        return read_mark(exception, frame, code, error)
    body: Body = (assign(code, load_part(naming, part)),)
    guard: list[Expression] = []
    if link.link.exception_response is not None and frame.direction == "response":
        body += read_mark(link.link.exception_response, frame, code, error)
        guard.append(error.negated())
    codes = link.codes(frame.direction)
    if codes or (link.messages and not link.carried(frame.direction)):
        tests = [*guard, *(code.differs(unsigned(known)) for known in codes)]
        body += (
            refuse(naming, all_of(tests), "err_unknown_code") if tests else (Return(naming.status("err_unknown_code")),)
        )
    shared = shared_codes(link, frame.direction)
    if shared:
        body += (assign(OUT.arrow("subcode"), ZERO),)
        body += tuple(read_subcode(naming, frame, number, subcode, guard) for number, subcode in shared.items())
    return body


# Closing


def header_parameters(frame: FrameLayout) -> list[Variable]:
    """The parameters for the parts before the body that users set."""
    return [declare_value(part_value(part), argument(part)) for part in header_parts(frame)]


def _declare_close(naming: Naming, layout: DeviceLayout, link: LinkLayout, direction: str) -> list[Declaration]:
    """The function that completes a frame around its body.

    `codec_status rtu_request_close(uint8_t unit_address, uint32_t code, size_t body_length, uint8_t *out, ...)`
    """
    frame = link.frame(direction)
    parameters = header_parameters(frame)
    if frame.role("code") is not None:
        parameters.append(Variable(code_type(frame), "code"))
    parameters += [Variable(SIZE_TYPE, "body_length"), *OUTPUT_PARAMETERS]
    width = 2 if link.link.transmission == "hex_ascii" else 1
    delimiters = len(frame.further) + len(frame.start) + len(frame.end)
    parts_size = frame.header_size + frame.trailer_size
    body: list[Statement] = [
        Variable(SIZE_TYPE, "total", value=_BODY_LENGTH.plus(parts_size), storage="const" if keeps_size(frame) else ""),
    ]
    if not keeps_size(frame):
        body.append(Variable(status_type(naming), "status"))
    if is_wrapped(link):
        body.append(Variable(SIZE_TYPE, "at"))
    body += _check_capacity(naming, width, parts_size, delimiters)
    sent_lengths = [part for part in frame.lengths if _is_sent(frame, part)]
    early = [part for part in frame.parts if part.role != "checksum" and part not in sent_lengths]
    body += write_shared_bytes(naming, frame)
    body += _write_parts(naming, layout, link, frame, early)
    body += _store_checksums(naming, [part for part in frame.checksums if not _is_sent(frame, part)])
    if frame.escape is not None:
        body += escape_bytes(naming, link, frame, OUT, TOTAL, CAPACITY.plus(-delimiters))
        body += _write_parts(naming, layout, link, frame, sent_lengths)
        body += _store_checksums(naming, [part for part in frame.checksums if _is_sent(frame, part)])
    if is_wrapped(link):
        body += wrap_frame(naming, link, direction)
    if not frame.parts and not is_wrapped(link):
        body.append(discard("out"))
    size = TOTAL if width == 1 else TOTAL * unsigned(width)
    body += [assign(LENGTH.dereferenced(), size.plus(delimiters)), return_ok(naming)]
    name = naming.function("link", link.name, direction, "close")
    return [
        comment(
            f"Completes a frame whose body is at out + {frame.header_size}. `length` receives the size of the frame."
        ),
        Function(status_type(naming), name, tuple(parameters), tuple(body)),
    ]


def _write_parts(
    naming: Naming, layout: DeviceLayout, link: LinkLayout, frame: FrameLayout, parts: list[PartLayout]
) -> Body:
    """Checks parts other than checksums and writes them; where a length is written twice, it is checked once."""
    body: Body = ()
    for part in parts:
        body += tuple(statement for statement in write_part(naming, layout, link, frame, part) if statement not in body)
    return body


def _store_checksums(naming: Naming, checksums: list[PartLayout]) -> Iterator[Statement]:
    """Writes checksums, each after those that it covers."""
    for checksum in checksums:
        computed = compute_checksum(naming, checksum, OUT, TOTAL)
        yield store_checksum(naming, checksum, computed, part_pointer(OUT, checksum, TOTAL))


OUTPUT_PARAMETERS = (Variable(OUTPUT_BYTES, "out"), Variable(SIZE_TYPE, "capacity"), Variable(_SIZE_POINTER, "length"))
"""The parameters for what is written."""


def _check_capacity(naming: Naming, width: int, parts_size: int, delimiters: int) -> Body:
    """`if (capacity < 9u || body_length > (capacity - 9u) / 2u) { return ERR_CAPACITY; }`

    No sum is compared: it would wrap around for lengths that no buffer has.
    """
    minimum = width * parts_size + delimiters
    room = CAPACITY.plus(-minimum)
    if width > 1:
        room = room / unsigned(width)
    tests: list[Expression] = [CAPACITY.less(unsigned(minimum))] if minimum else []
    return refuse(naming, any_of([*tests, _BODY_LENGTH.greater(room)]), "err_capacity")
