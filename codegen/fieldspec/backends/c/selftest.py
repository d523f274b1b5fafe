"""A program that proves a header: masks, addresses, the place of every field, and every example frame."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from fieldspec.backends.c.expected import field_value, high_value, legal, raw_bytes, record_bytes, record_value
from fieldspec.backends.c.frames import head_members
from fieldspec.backends.c.naming import Naming, frame_member, member
from fieldspec.backends.c.records import members
from fieldspec.backends.c.text import array, hexadecimal, indented, integer, plain, string
from fieldspec.backends.templates import fill
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.meaning import body_of, raw_values
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.model.example import Example
from fieldspec.model.primitive import Kind

_REFUSALS = {
    "unknown_code": "err_unknown_code",
    "wrong_check": "err_wrong_check",
    "wrong_length": "err_wrong_length",
    "out_of_range": "err_out_of_range",
    "incomplete": "err_incomplete",
}


def program(layout: DeviceLayout, naming: Naming, header: str) -> str:
    """The text of the program. It prints each failure, then a count, and exits with 0 where all is well."""
    tests = [*_constants(layout, naming), *_fields(layout, naming), *_registers(layout, naming)]
    tests += [_example(layout, naming, example) for example in layout.device.examples.values()]
    return fill(
        "c/selftest.c.j2",
        header=header,
        title=plain(f"{layout.device.name}, version {layout.device.version}"),
        identity=layout.identity,
        texts_macro=naming.macro("with_texts"),
        tests=[(f"test_{at}", "\n".join(lines)) for at, lines in enumerate(tests)],
    )


def _same(what: str, left: str, right: str) -> str:
    return f"expect({left} == {right}, {string(what)});"


def _constants(layout: DeviceLayout, naming: Naming) -> Iterator[list[str]]:
    """Masks and addresses, as decimal numbers of the generator's own."""
    lines = []
    for word in layout.device.flags.values():
        for bit in word.bits:
            if not bit.reserved:
                ones = sum(1 << number for number in range(bit.first, bit.last + 1))
                name = naming.macro(word.name, bit.name, "mask")
                lines.append(_same(name, name, hexadecimal(ones, word.type.size)))
                get = naming.function(word.name, bit.name)
                lines.append(_same(get, f"{get}({hexadecimal(ones, word.type.size)})", f"{(1 << bit.width) - 1}u"))
    for register in layout.registers:
        name = naming.macro("reg", register.name, "address")
        lines.append(_same(name, name, f"{register.address}u"))
    for table in layout.tables.values():
        last = table.table.indexes[-1]
        call = naming.function("table", table.name, "at")
        ok, refused = naming.macro("ok"), naming.macro("err_out_of_range")
        lines += ["{", "    uint16_t address = 0;"]
        lines += indented([_same(f"{call} last", f"{call}({last}u, &address)", ok)])
        lines += indented([_same(f"{call} last address", "address", f"{table.table.address(last)}u")])
        lines += indented([_same(f"{call} beyond", f"{call}({last + 1}u, &address)", refused), "(void)address;"])
        lines.append("}")
    if lines:
        yield lines


def _records(layout: DeviceLayout) -> Iterator[RecordLayout]:
    yield from layout.records.values()
    for message in layout.messages.values():
        yield from (message.request, message.response)


def _fields(layout: DeviceLayout, naming: Naming) -> Iterator[list[str]]:
    """Each member of each record at its highest while all others are low: the bytes show where it lies."""
    for record in _records(layout):
        for field in members(record):
            values = record_value(layout.device, record)
            values[field.name] = field_value(layout.device, field, high_value)
            yield _round(naming, record, values, record_bytes(record, values), f"{record.name}.{field.name}")


def _round(naming: Naming, record: RecordLayout, values: dict[str, Any], data: bytes, what: str) -> list[str]:
    """Encodes values and compares bytes, decodes the bytes and encodes again."""
    kind = naming.type(record.name)
    encode, decode = naming.function(record.name, "encode"), naming.function(record.name, "decode")
    ok = naming.macro("ok")
    return [
        f"static const uint8_t wanted[] = {{{array(data)}}};",
        f"uint8_t bytes[{naming.macro(record.name, 'size')}];",
        f"{kind} in, out;",
        "size_t length = 0;",
        "memset(&in, 0, sizeof in);",
        "memset(&out, 0, sizeof out);",
        *_assigned(record, values, "in."),
        _same(f"{what} encodes", f"{encode}(&in, bytes, sizeof bytes, &length)", ok),
        f"expect(length == sizeof wanted && memcmp(bytes, wanted, length) == 0, {string(what + ' bytes')});",
        _same(f"{what} decodes", f"{decode}(wanted, sizeof wanted, &out)", ok),
        *_compared(record, values, "out.", what),
        _same(f"{what} short", f"{encode}(&in, bytes, sizeof wanted - 1, &length)", naming.macro("err_capacity")),
    ]


def _assigned(record: RecordLayout, values: dict[str, Any], holder: str) -> list[str]:
    """Statements that give the members their values."""
    lines = []
    for field in members(record):
        name = f"{holder}{member(field.name)}"
        held = values[field.name]
        if field.field.repeat is not None:
            lines.append(f"{holder}{field.name}_count = {len(held)}u;")
        items = [(f"{name}[{at}]", item) for at, item in enumerate(held)] if field.listed else [(name, held)]
        for target, item in items:
            if field.record is not None:
                lines += _assigned(field.record, item, f"{target}.")
            else:
                lines.append(_assign(field, target, item))
    return lines


def _assign(field: FieldLayout, target: str, held: Any) -> str:
    assert field.value is not None
    kind = field.value.type.kind
    if kind in (Kind.TEXT, Kind.BYTES):
        data = held.encode("ascii") if isinstance(held, str) else bytes(held)
        return f"memcpy({target}, {_bytes_literal(data)}, {len(data)}u);" if data else ";"
    return f"{target} = {_literal(field, held)};"


def _bytes_literal(data: bytes) -> str:
    return '"' + "".join(f"\\{byte:03o}" for byte in data) + '"'


def _literal(field: FieldLayout, held: Any) -> str:
    assert field.value is not None
    kind = field.value.type
    if kind.kind is Kind.FLOAT:
        return f"{float(held)!r}f"
    if kind.kind is Kind.BOOLEAN:
        return "true" if held else "false"
    return integer(int(held), kind.size, kind.signed)


def _compared(record: RecordLayout, values: dict[str, Any], holder: str, what: str) -> list[str]:
    """Statements that compare members with values."""
    lines = []
    for field in members(record):
        if field.name not in values:
            continue
        name = f"{holder}{member(field.name)}"
        held = values[field.name]
        if field.field.repeat is not None:
            lines.append(_same(f"{what}: {field.name} count", f"{holder}{field.name}_count", f"{len(held)}u"))
        items = [(f"{name}[{at}]", item) for at, item in enumerate(held)] if field.listed else [(name, held)]
        for target, item in items:
            if field.record is not None:
                lines += _compared(field.record, item, f"{target}.", what)
            else:
                lines.append(_compare(field, target, item, f"{what}: {field.name}"))
    return lines


def _compare(field: FieldLayout, target: str, held: Any, what: str) -> str:
    assert field.value is not None
    kind = field.value.type.kind
    if kind in (Kind.TEXT, Kind.BYTES):
        data = held.encode("ascii") if isinstance(held, str) else bytes(held)
        if not data:
            return ";"
        return f"expect(memcmp({target}, {_bytes_literal(data)}, {len(data)}u) == 0, {string(what)});"
    if kind is Kind.FLOAT:
        literal = _literal(field, held)
        return f"expect(!({target} < {literal}) && !({target} > {literal}), {string(what)});"
    return _same(what, target, _literal(field, held))


def _registers(layout: DeviceLayout, naming: Naming) -> Iterator[list[str]]:
    """Each register's value at its bounds."""
    for laid in layout.registers:
        value = laid.register.value
        if value.type.kind is not Kind.INTEGER or value.const is not None:
            continue
        encode, decode = naming.function("reg", laid.name, "encode"), naming.function("reg", laid.name, "decode")
        size = value.size + value.size % 2
        kind = f"{'' if value.type.signed else 'u'}int{8 * value.size}_t"
        lines = [f"uint8_t bytes[{size}];", f"{kind} out = 0;"]
        for number in sorted(set(legal(layout.device, value))):
            data = raw_bytes(value, laid.order, laid.swapped, number).ljust(size, b"\0")
            literal = integer(number, value.size, value.type.signed)
            what = f"{laid.name} {number}"
            lines += [
                _same(what, f"{encode}({literal}, bytes)", naming.macro("ok")),
                f"expect(memcmp(bytes, {_bytes_literal(data)}, {size}u) == 0, {string(what + ' bytes')});",
                _same(what, f"{decode}(bytes, &out)", naming.macro("ok")),
                _same(what, "out", literal),
            ]
        yield lines


def _example(layout: DeviceLayout, naming: Naming, example: Example) -> list[str]:
    """Opens a frame, decodes its body, compares every member, and writes the frame again."""
    link = layout.links[example.link]
    shape = link.frame(example.direction)
    wrapped = link.link.encoding == "hex_ascii" or link.link.start or link.link.end
    buffer = "buffer, sizeof buffer, " if wrapped else ""
    opened = f"{naming.function(link.name, example.direction, 'open')}(frame, sizeof frame, {buffer}&opened)"
    what = f"example {example.id}"
    lines = [f"static const uint8_t frame[] = {{{array(example.frame)}}};"]
    if wrapped:
        lines.append("uint8_t buffer[sizeof frame];")
    lines.append(f"{naming.type(link.name, example.direction, 'frame')} opened;")
    if example.refused:
        return [*lines, "memset(&opened, 0, sizeof opened);", *_refused(layout, naming, example, opened)]
    body = body_of(layout, link.name, example.direction, example.message, example.error)
    values = raw_values(layout, example)
    held: dict[str, Any] = {name: value for name, value in values.items() if body.named(name) is not None}
    full = {**record_value(layout.device, body), **held}
    if members(body):
        lines += [f"{naming.type(body.name)} in, out;"]
    lines += [f"uint8_t again[sizeof frame + {len(link.link.start) + len(link.link.end)}];", "size_t length = 0;"]
    if members(body):
        lines += ["memset(&in, 0, sizeof in);", "memset(&out, 0, sizeof out);"]
    lines += ["memset(&opened, 0, sizeof opened);", _same(f"{what} opens", opened, naming.macro("ok"))]
    for part in head_members(shape):
        number: Any = values[part.name]
        lines.append(
            _same(f"{what}: {part.name}", f"opened.{frame_member(part.name)}", integer(number, part.size, False))
        )
    code = shape.role("code")
    if code is not None:
        message = layout.messages.get(example.message)
        number = message.message.code if message else values[code.name]
        lines.append(_same(f"{what}: code", "opened.code", f"{number}u"))
    if example.direction == "response" and link.link.error is not None:
        lines.append(_same(f"{what}: error", "opened.error", "true" if example.error else "false"))
    out = ", &out" if members(body) else ""
    decode = f"{naming.function(body.name, 'decode')}(opened.body, opened.body_length{out})"
    lines.append(_same(f"{what} decodes", decode, naming.macro("ok")))
    lines += _compared(body, held, "out.", what)
    return [*lines, *_assigned(body, full, "in."), *_written(layout, naming, example, values, body, what)]


def _refused(layout: DeviceLayout, naming: Naming, example: Example, opened: str) -> list[str]:
    """The frame, or the body in it, is refused for the reason that the example gives."""
    refusal, ok = naming.macro(_REFUSALS[example.refused]), naming.macro("ok")
    what = f"example {example.id}"
    if not example.message:
        return [_same(what, opened, refusal)]
    body = body_of(layout, example.link, example.direction, example.message, example.error)
    held = f"{naming.type(body.name)} out;" if members(body) else ""
    argument = ", &out" if members(body) else ""
    decode = f"{naming.function(body.name, 'decode')}(opened.body, opened.body_length{argument})"
    lines = [held, f"{naming.type('codec_status')} status;", "memset(&out, 0, sizeof out);"]
    return [
        *(lines if held else lines[1:2]),
        f"status = {opened};",
        f"if (status == {ok}) {{",
        f"    status = {decode};",
        "}",
        _same(what, "status", refusal),
    ]


def _written(
    layout: DeviceLayout, naming: Naming, example: Example, values: dict[str, Any], body: RecordLayout, what: str
) -> list[str]:
    link = layout.links[example.link]
    shape = link.frame(example.direction)
    arguments = [integer(int(values[part.name]), part.size, False) for part in head_members(shape)]
    code = shape.role("code")
    if example.error and code is not None:
        message = layout.messages.get(example.message)
        arguments.append(f"{message.message.code if message else values[code.name]}u")
    arguments += ["&in"] if members(body) else []
    name = "error" if example.error else example.message
    ending = () if example.error else (example.direction,)
    function = naming.function(link.name, "encode", name, *ending)
    call = f"{function}({', '.join([*arguments, 'again', 'sizeof again', '&length'])})"
    return [
        _same(f"{what} encodes", call, naming.macro("ok")),
        f"expect(length == sizeof frame && memcmp(again, frame, length) == 0, {string(what + ' bytes')});",
    ]
