"""What self-tests expect of the example frames."""

from __future__ import annotations

from typing import Any

from fieldspec.backends.c.assertions import assigned, compared, same
from fieldspec.backends.c.decided import of_values
from fieldspec.backends.c.expected import record_value
from fieldspec.backends.c.fields import members
from fieldspec.backends.c.frames import head_members, part_wire, wrapped
from fieldspec.backends.c.naming import Naming, frame_member
from fieldspec.backends.c.text import array, integer, string
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import LinkLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.layout.values import body_of, raw_values
from fieldspec.model.texts import Example

_REFUSALS = {
    "unknown_code": "err_unknown_code",
    "wrong_check": "err_wrong_check",
    "wrong_length": "err_wrong_length",
    "out_of_range": "err_out_of_range",
    "incomplete": "err_incomplete",
}


def example_lines(layout: DeviceLayout, naming: Naming, example: Example) -> list[str]:
    """Opens a frame, decodes its body, compares every member, and writes the frame again."""
    link = layout.links[example.link]
    shape = link.frame(example.direction)
    buffer = "buffer, sizeof buffer, " if wrapped(link) else ""
    open_ = naming.function("link", link.name, example.direction, "open")
    opened = f"{open_}(received, sizeof received, {buffer}&opened)"
    what = f"example {example.id}"
    lines = [f"static const uint8_t frame[] = {{{array(example.frame)}}};"]
    lines.append("uint8_t received[sizeof frame];")
    if wrapped(link):
        lines.append("uint8_t buffer[sizeof frame];")
    lines.append(f"{naming.type('link', link.name, example.direction, 'frame')} opened;")
    started = ["copy(received, frame, sizeof frame);", "clear(&opened, sizeof opened);"]
    if example.refused:
        return [*lines, *_refused(layout, naming, example, opened, started)]
    body = body_of(layout, link.name, example.direction, example.message, example.exception_response)
    values = raw_values(layout, example)
    form = of_values(body, values)
    held: dict[str, Any] = {name: value for name, value in values.items() if body.named(name) is not None}
    full = {**record_value(layout.device, form.record), **held}
    if members(body):
        lines += [f"{naming.type('record', body.name)} in, out;"]
    lines += [f"uint8_t again[sizeof frame + {len(link.link.start) + len(link.link.end)}];", "size_t length = 0;"]
    if members(body):
        lines += ["clear(&in, sizeof in);", "clear(&out, sizeof out);"]
    lines += [*started, same(f"{what} opens", opened, naming.own_macro("ok"))]
    for part in head_members(shape):
        number: Any = values[part.name]
        lines.append(
            same(
                f"{what}: {part.name}",
                f"opened.{frame_member(part.name)}",
                integer(number, part.size, part_wire(part).value.type.signed),
            )
        )
    code = shape.role("code")
    if code is not None:
        lines.append(same(f"{what}: code", "opened.code", f"{_code(link, example)[0]}u"))
    if example.direction == "response" and link.link.exception_response is not None:
        lines.append(same(f"{what}: error", "opened.error", "true" if example.exception_response else "false"))
    out = ", &out" if members(body) else ""
    decode = f"{naming.function('record', body.name, 'decode')}(opened.body, opened.body_length{out})"
    lines.append(same(f"{what} decodes", decode, naming.own_macro("ok")))
    lines += compared(naming, form, held, "out.", what)
    lines += assigned(naming, form, full, "in.")
    return [*lines, *_written(layout, naming, example, values, body, what)]


def _code(link: LinkLayout, example: Example) -> tuple[int | None, bool]:
    """The code in a frame without the flag of an error reply, and whether that is set; None where there is none."""
    start, end = len(link.link.start), len(example.frame) - len(link.link.end)
    data, part = example.frame[start:end], link.frame(example.direction).role("code")
    if link.link.encoding == "hex_ascii":
        pairs = [data[at : at + 2] for at in range(0, len(data), 2)]
        data = bytes(int(pair, 16) for pair in pairs if all(digit in b"0123456789ABCDEFabcdef" for digit in pair))
    if part is None or len(data) < part.offset + part.size:
        return None, False
    number = int.from_bytes(data[part.offset : part.offset + part.size], "big" if part.order == "big" else "little")
    error = link.link.exception_response
    if error is None or example.direction == "request" or not number & error.flag:
        return number, False
    return number & ~error.flag, True


def _body(layout: DeviceLayout, example: Example) -> RecordLayout | None:
    """The record in the body of a frame that may be wrong, None where nothing says which it is."""
    link = layout.links[example.link]
    if example.message:
        return body_of(layout, link.name, example.direction, example.message, example.exception_response)
    code, error = _code(link, example)
    if error and link.link.exception_response is not None:
        return layout.records[link.link.exception_response.record]
    message = link.message_with_code(code) if code is not None else None
    return message.data(example.direction) if message is not None else None


def _refused(layout: DeviceLayout, naming: Naming, example: Example, opened: str, started: list[str]) -> list[str]:
    """The frame, or the body in it, is refused for the reason that the example gives."""
    refusal, ok = naming.own_macro(_REFUSALS[example.refused]), naming.own_macro("ok")
    what = f"example {example.id}"
    body = _body(layout, example)
    if body is None:
        return [*started, same(what, opened, refusal)]
    held = members(body)
    lines = [f"{naming.type('record', body.name)} out;"] if held else []
    lines.append(f"{naming.own('codec_status')} status;")
    lines += [*started, *(["clear(&out, sizeof out);"] if held else [])]
    decode = naming.function("record", body.name, "decode")
    return [
        *lines,
        f"status = {opened};",
        f"if (status == {ok}) {{",
        f"    status = {decode}(opened.body, opened.body_length{', &out' if held else ''});",
        "}",
        same(what, "status", refusal),
    ]


def _written(
    layout: DeviceLayout, naming: Naming, example: Example, values: dict[str, Any], body: RecordLayout, what: str
) -> list[str]:
    link = layout.links[example.link]
    shape = link.frame(example.direction)
    arguments = [
        integer(int(values[part.name]), part.size, part_wire(part).value.type.signed) for part in head_members(shape)
    ]
    code = shape.role("code")
    if example.exception_response and code is not None:
        arguments.append(f"{_code(link, example)[0]}u")
    arguments += ["&in"] if members(body) else []
    name = "error" if example.exception_response else example.message
    ending = () if example.exception_response else (example.direction,)
    function = naming.function("link", link.name, "encode", name, *ending)
    call = f"{function}({', '.join([*arguments, 'again', 'sizeof again', '&length'])})"
    return [
        same(f"{what} encodes", call, naming.own_macro("ok")),
        f"expect(length == sizeof frame && same_bytes(again, frame, length), {string(what + ' bytes')});",
    ]
