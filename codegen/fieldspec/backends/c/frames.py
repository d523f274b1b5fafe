"""Frames of a link: how they are opened and closed, and the frames of each message."""

from __future__ import annotations

from fieldspec.backends.c.comments import told
from fieldspec.backends.c.elements import returning
from fieldspec.backends.c.enums import closed_test
from fieldspec.backends.c.fields import members
from fieldspec.backends.c.naming import Naming, argument, frame_member
from fieldspec.backends.c.text import comment, indented, integer
from fieldspec.backends.c.values import Wire, access_name, const_test, declaration, load, range_test, refused
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import FrameLayout, LinkLayout, PartLayout
from fieldspec.layout.record import RecordLayout

DIRECTIONS = ("request", "response")


def head_members(shape: FrameLayout) -> list[PartLayout]:
    """The parts before the body that users give: neither the length nor the code, nor a constant."""
    return [part for part in shape.head if part.is_argument]


def wrapped(link: LinkLayout) -> bool:
    """Whether a frame is more than its bytes: it has marks, or is written in characters."""
    return link.link.encoding == "hex_ascii" or bool(link.link.start or link.link.end)


def part_wire(part: PartLayout) -> Wire:
    """The value of a part that holds one."""
    assert part.value is not None
    return Wire(part.value, part.order, False)


def link_lines(naming: Naming, layout: DeviceLayout, link: LinkLayout) -> list[str]:
    """All of a link's functions."""
    lines = told(link.link, f"A frame is {_form(link)}.")
    if wrapped(link):
        lines += [*_parts(naming, link), ""]
    for direction in DIRECTIONS:
        lines += [*_frame_struct(naming, link, direction), "", *_open(naming, link, direction), ""]
        lines += [*_close(naming, layout, link, direction), ""]
    for message in link.messages.values():
        for direction in DIRECTIONS:
            code = message.message.code if link.frame(direction).role("code") is not None else None
            lines += [*_message(naming, link, direction, message.data(direction), f"{message.name}", code), ""]
    error = link.link.exception_response
    if error is not None:
        lines += [*_message(naming, link, "response", layout.records[error.record], "error", None, error.flag), ""]
    return lines[:-1]


def _form(link: LinkLayout) -> str:
    text = "bytes" if link.link.encoding == "binary" else "hexadecimal characters"
    marks = [f"from {link.link.start.hex(' ').upper()}"] if link.link.start else []
    marks += [f"to {link.link.end.hex(' ').upper()}"] if link.link.end else []
    return " ".join([text, *marks])


def _parts(naming: Naming, link: LinkLayout) -> list[str]:
    """The function that takes a frame's marks away, and turns characters into bytes."""
    start, end = link.link.start, link.link.end
    name = naming.function("link", link.name, "parts")
    lines = [
        *comment("Takes the marks away and writes the bytes between them. They may replace the frame itself."),
        f"static inline {naming.own('codec_status')} {name}"
        "(const uint8_t *frame, size_t size, uint8_t *out, size_t capacity, size_t *length)",
        "{",
    ]
    body = ["size_t at;"]
    marks = len(start) + len(end)
    body += refused(naming, f"size < {marks}u", "err_wrong_mark") if marks else []
    tests = [f"frame[{at}] != 0x{byte:02X}u" for at, byte in enumerate(start)]
    tests += [f"frame[size - {len(end) - at}u] != 0x{byte:02X}u" for at, byte in enumerate(end)]
    if tests:
        body += refused(naming, " || ".join(tests), "err_wrong_mark")
    body.append(f"*length = size - {marks}u;")
    if link.link.encoding == "binary":
        body += refused(naming, "capacity < *length", "err_capacity")
        body += ["for (at = 0; at < *length; at++) {", f"    out[at] = frame[{len(start)}u + at];", "}"]
    else:
        digit = naming.own("digit")
        body += ["for (at = 0; at < *length; at++) {"]
        body += indented(refused(naming, f"{digit}(frame[{len(start)}u + at]) > 15u", "err_not_hex"))
        body += ["}", *refused(naming, "*length % 2u != 0", "err_wrong_length"), "*length /= 2u;"]
        body += refused(naming, "capacity < *length", "err_capacity")
        first = f"frame[{len(start)}u + 2u * at]"
        second = f"frame[{len(start) + 1}u + 2u * at]"
        body += ["for (at = 0; at < *length; at++) {"]
        body += [f"    out[at] = (uint8_t)({digit}({first}) << 4 | {digit}({second}));", "}"]
    body.append(f"return {naming.own_macro('ok')};")
    return [*lines, *indented(body), "}"]


def _frame_struct(naming: Naming, link: LinkLayout, direction: str) -> list[str]:
    shape = link.frame(direction)
    name = naming.type("link", link.name, direction, "frame")
    lines = [*comment(f"An opened {direction}: what stands before the body, and where the body is.")]
    lines.append(f"typedef struct {name} {{")
    for part in head_members(shape):
        lines += indented([*told(part.part), declaration(part_wire(part), frame_member(part.name), None) + ";"])
    if shape.role("code") is not None:
        lines += indented(["/** The code, without the flag of an error reply. */", "uint32_t code;"])
    if direction == "response" and link.link.exception_response is not None:
        lines += indented(["/** The frame refuses a request; its body is an error record. */", "bool error;"])
    return [*lines, *indented(["const uint8_t *body;", "size_t body_length;"]), f"}} {name};"]


def _open(naming: Naming, link: LinkLayout, direction: str) -> list[str]:
    """The function that checks a frame and finds its body."""
    shape = link.frame(direction)
    buffer = ", uint8_t *buffer, size_t capacity" if wrapped(link) else ""
    kind = naming.type("link", link.name, direction, "frame")
    told_of = ["Checks a frame and finds its body."]
    if wrapped(link):
        told_of.append("The buffer receives the frame's bytes, and the body lies in it.")
    lines = [
        *comment(*told_of),
        f"static inline {naming.own('codec_status')} {naming.function('link', link.name, direction, 'open')}"
        f"(const uint8_t *frame, size_t size{buffer}, {kind} *out)",
        "{",
    ]
    body = []
    if wrapped(link):
        body += ["const uint8_t *in = buffer;", "size_t length = 0;", f"{naming.own('codec_status')} status;"]
        body += [f"status = {naming.function('link', link.name, 'parts')}(frame, size, buffer, capacity, &length);"]
        body += [f"if (status != {naming.own_macro('ok')}) {{", "    return status;", "}"]
    else:
        body += ["const uint8_t *in = frame;", "size_t length = size;"]
    least = shape.head_size + shape.tail_size
    if least:
        body += refused(naming, f"length < {least}u", "err_incomplete")
    length = shape.role("length")
    if length is not None:
        received = load(naming, part_wire(length), f"in + {length.offset}")
        body += refused(naming, _length_differs(shape, length, received, "length"), "err_wrong_length")
    check = shape.checksum
    if check is not None:
        held = f"{naming.own('load', access_name(check.size, check.order, False))}(in + {_at('length', check.offset)})"
        body += refused(naming, f"{_checksum(naming, check, 'in', 'length')} != {held}", "err_wrong_check")
    for part in shape.constants:
        body += const_test(naming, part_wire(part), f"in + {_at('length', part.offset)}")
    for part in head_members(shape):
        body.append(f"out->{frame_member(part.name)} = {load(naming, part_wire(part), f'in + {part.offset}')};")
    body += _code(naming, link, shape)
    body += [f"out->body = {_sum('in', shape.head_size)};", f"out->body_length = {_sum('length', -least)};"]
    body.append(f"return {naming.own_macro('ok')};")
    return [*lines, *indented(body), "}"]


def _code(naming: Naming, link: LinkLayout, shape: FrameLayout) -> list[str]:
    part = shape.role("code")
    if part is None:
        return []
    lines = [f"out->code = {load(naming, part_wire(part), f'in + {part.offset}')};"]
    error = link.link.exception_response
    guard = ""
    if error is not None and shape.direction == "response":
        lines.append(f"out->error = (out->code & {error.flag}u) != 0;")
        lines += ["if (out->error) {", f"    out->code &= ~(uint32_t){error.flag}u;", "}"]
        guard = "!out->error && "
    codes = sorted({m.message.code for m in link.messages.values() if m.message.code is not None})
    if codes:
        tests = " && ".join(f"out->code != {code}u" for code in codes)
        lines += refused(naming, f"{guard}{tests}", "err_unknown_code")
    return lines


def _arguments(shape: FrameLayout) -> list[str]:
    return [declaration(part_wire(part), argument(part.name), None) for part in head_members(shape)]


def _close(naming: Naming, layout: DeviceLayout, link: LinkLayout, direction: str) -> list[str]:
    """The function that puts everything around a body that lies in the buffer already."""
    shape = link.frame(direction)
    arguments = [*_arguments(shape)]
    if shape.role("code") is not None:
        arguments.append("uint32_t code")
    arguments += ["size_t body_length", "uint8_t *out", "size_t capacity", "size_t *length"]
    lines = [
        *comment(f"Completes a frame whose body lies at out + {shape.head_size}. Length receives the frame's size."),
        f"static inline {naming.own('codec_status')} {naming.function('link', link.name, direction, 'close')}"
        f"({', '.join(arguments)})",
        "{",
    ]
    marks = len(link.link.start) + len(link.link.end)
    width = 2 if link.link.encoding == "hex_ascii" else 1
    around = shape.head_size + shape.tail_size
    least = width * around + marks
    room = _sum("capacity", -least) if width == 1 else f"({_sum('capacity', -least)}) / {width}u"
    body = [f"const size_t total = {_sum('body_length', around)};"]
    if marks or width == 2:
        body.append("size_t at;")
    # No sum is compared: it would wrap around for lengths that no buffer has.
    tests = [f"capacity < {least}u"] if least else []
    body += refused(naming, " || ".join([*tests, f"body_length > {room}"]), "err_capacity")
    for part in shape.parts:
        if part.role != "checksum":
            body += _head(naming, layout, link, shape, part)
    if shape.checksum is not None:
        check = shape.checksum
        store = naming.own("store", access_name(check.size, check.order, False))
        body.append(f"{store}(out + {_at('total', check.offset)}, {_checksum(naming, check, 'out', 'total')});")
    if marks or width == 2:
        body += _wrap(naming, link)
    if not any("out" in line for line in body):
        body.append("(void)out;")
    size = "total" if width == 1 else f"total * {width}u"
    body += [f"*length = {_sum(size, marks)};", f"return {naming.own_macro('ok')};"]
    return [*lines, *indented(body), "}"]


def _sum(term: str, number: int) -> str:
    """A sum of sizes, or the term alone where there is nothing to add."""
    if number < 0:
        return f"{term} - {-number}u"
    return f"{term} + {number}u" if number else term


def _at(total: str, offset: int) -> str:
    """A place in a frame of `total` bytes: from its begin, or negative from its end."""
    return f"{offset}" if offset >= 0 else _sum(total, offset)


def _checksum(naming: Naming, check: PartLayout, source: str, total: str) -> str:
    """The check of the bytes that it covers, in a frame of `total` bytes that begins at `source`."""
    stop = total if check.stop is None else f"{check.stop}u" if check.stop >= 0 else _sum(total, check.stop)
    if check.start == 0:
        return f"{naming.own(check.algorithm)}({source}, {stop})"
    if check.start > 0:
        size = f"{check.stop - check.start}u" if check.stop is not None and check.stop > 0 else ""
        size = size or _sum(total, (check.stop or 0) - check.start)
        return f"{naming.own(check.algorithm)}({source} + {check.start}, {size})"
    return f"{naming.own(check.algorithm)}({source} + {_sum(total, check.start)}, {(check.stop or 0) - check.start}u)"


def _length_differs(shape: FrameLayout, part: PartLayout, received: str, total: str) -> str:
    """The condition under which a length part does not say that a frame has `total` bytes."""
    counted, tests = _counted(shape, part, total)
    return " || ".join([*tests, f"{received} != {counted}"])


def _counted(shape: FrameLayout, part: PartLayout, total: str) -> tuple[str, list[str]]:
    """What a length part holds in a frame of `total` bytes, and the conditions under which no number says it.

    Nothing in it wraps around where none of the conditions holds.
    """
    tests = [f"{total} < {part.base}u"] if part.base > shape.head_size + shape.tail_size else []
    counted = _sum(total, -part.base)
    if part.unit_size > 1:
        counted = f"({counted})" if part.base else total
        tests.append(f"{counted} % {part.unit_size}u != 0")
        counted = f"{counted} / {part.unit_size}u"
    return counted, tests


def _head(naming: Naming, layout: DeviceLayout, link: LinkLayout, shape: FrameLayout, part: PartLayout) -> list[str]:
    held = part_wire(part)
    store = naming.own("store", access_name(held.size, held.order, False))
    number = f"uint{8 * held.size}_t"
    at = f"out + {_at('total', part.offset)}"
    if part.role == "length":
        counted, tests = _counted(shape, part, "total")
        highest = held.value.type.high
        limit = refused(naming, f"{counted} > {highest}u", "err_wrong_length")
        if highest >= 0xFFFF:
            limit = [f"#if SIZE_MAX > {highest}u", *limit, "#endif"]
        before = refused(naming, " || ".join(tests), "err_wrong_length") if tests else []
        written = counted if counted == "total" else f"({counted})"
        return [*before, *limit, f"{store}({at}, ({number}){written});"]
    if part.role == "code":
        return [
            *refused(naming, f"code > {held.value.type.high}u", "err_unknown_code"),
            f"{store}({at}, ({number})code);",
        ]
    if part.constant is not None:
        return [f"{store}({at}, {integer(part.constant & (1 << 8 * held.size) - 1, held.size, False)});"]
    name = argument(part.name)
    lines = []
    closed = closed_test(naming, layout.device, held.value, name)
    if closed:
        lines += refused(naming, closed, "err_unknown_value")
    test = range_test(held.value, name)
    stations = link.link.unit_addresses
    if part.role == "unit_address" and stations is not None and stations.ranges is not None:
        tests = []
        for low, high in stations.ranges.intervals:
            bounds = [f"{name} >= {low}"] if low > held.value.type.low else []
            bounds += [f"{name} <= {high}"] if high < held.value.type.high else []
            tests.append("(" + (" && ".join(bounds) or "1") + ")")
        if stations.broadcast is not None and stations.broadcast not in stations.ranges:
            tests.append(f"({name} == {stations.broadcast})")
        test = f"!({' || '.join(tests)})"
    if test:
        lines += refused(naming, test, "err_out_of_range")
    return [*lines, f"{store}({at}, ({number}){name});"]


def _wrap(naming: Naming, link: LinkLayout) -> list[str]:
    """Statements that turn the bytes at `out` into a marked frame, the last byte first: they overwrite themselves."""
    start, end = link.link.start, link.link.end
    lines = ["for (at = total; at-- > 0;) {"]
    if link.link.encoding == "hex_ascii":
        digits = naming.own("hex_digit")
        lines += [
            "    const uint8_t byte = out[at];",
            f"    out[{len(start)}u + 2u * at] = {digits}((uint8_t)(byte >> 4));",
            f"    out[{len(start) + 1}u + 2u * at] = {digits}((uint8_t)(byte & 15u));",
        ]
        size = f"{len(start)}u + 2u * total"
    else:
        lines.append(f"    out[{len(start)}u + at] = out[at];")
        size = f"{len(start)}u + total"
    lines.append("}")
    lines += [f"out[{at}] = 0x{byte:02X};" for at, byte in enumerate(start)]
    return lines + [f"out[{size} + {at}u] = 0x{byte:02X};" for at, byte in enumerate(end)]


def _message(
    naming: Naming,
    link: LinkLayout,
    direction: str,
    data: RecordLayout,
    name: str,
    code: int | None,
    flag: int | None = None,
) -> list[str]:
    """The function that writes the whole frame of a message, or of an error reply."""
    shape = link.frame(direction)
    heads = [argument(part.name) for part in head_members(shape)]
    arguments = _arguments(shape)
    if flag is not None:
        arguments.append("uint32_t code")
    if members(data):
        arguments.append(f"const {naming.type('record', data.name)} *in")
    arguments += ["uint8_t *out", "size_t capacity", "size_t *length"]
    function = naming.function("link", link.name, "encode", name, *(() if flag is not None else (direction,)))
    codes = [f"code | {flag}u"] if flag is not None else [f"{code}u"] if code is not None else []
    close = naming.function("link", link.name, direction, "close")
    given = [*heads, *codes, "body_length" if data.fields else "0", "out", "capacity", "length"]
    closed = f"return {close}({', '.join(given)});"
    body = [*_body_written(naming, shape, data), closed] if data.fields else [closed]
    what = "an error reply to a code" if flag is not None else f"the {direction} {data.name}"
    return [
        *comment(f"Writes the whole frame of {what}."),
        f"static inline {naming.own('codec_status')} {function}({', '.join(arguments)})",
        "{",
        *indented(body),
        "}",
    ]


def _body_written(naming: Naming, shape: FrameLayout, data: RecordLayout) -> list[str]:
    """Statements that write the body of a frame to where it lies in it."""
    held = "in, " if members(data) else ""
    head, encode = shape.head_size, naming.function("record", data.name, "encode")
    room = f"out + {head}, capacity - {head}u" if head else "out, capacity"
    return [
        "size_t body_length = 0;",
        f"{naming.own('codec_status')} status;",
        *(refused(naming, f"capacity < {head}u", "err_capacity") if head else []),
        *returning(naming, f"{encode}({held}{room}, &body_length)"),
    ]
