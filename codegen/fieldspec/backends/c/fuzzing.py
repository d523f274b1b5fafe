"""A fuzz target for a header: everything that decodes gets any bytes, and what it takes is encoded again."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from fieldspec.backends.c.fields import members
from fieldspec.backends.c.frames import head_members, wrapped
from fieldspec.backends.c.naming import Naming, Noun, frame_member
from fieldspec.backends.c.packing import packed
from fieldspec.backends.c.text import indented, plain
from fieldspec.backends.c.values import Wire, declaration
from fieldspec.backends.forms import filled
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import LinkLayout
from fieldspec.layout.record import Orders, RecordLayout
from fieldspec.model.value import Kind, Value

_MACROS = {
    "RECORD": """
/* Decodes, encodes, and does both again; then encodes into exactly enough room, and into one byte less. */
#define RECORD(type, decode, encode, most, exact)
do {
    type value, second;
    uint8_t out[most], again[most];
    uint8_t *room;
    size_t length = 0, beyond = 0;
    memset(&value, 0, sizeof value);
    memset(&second, 0, sizeof second);
    if (decode(data, size, &value) != OK) {
        break;
    }
    if (encode(&value, out, sizeof out, &length) == ERR_OUT_OF_RANGE) {
        break;
    }
    hold(encode(&value, out, sizeof out, &length) == OK && length == size);
    hold(!(exact) || memcmp(out, data, size) == 0);
    hold(decode(out, length, &second) == OK);
    hold(encode(&second, again, sizeof again, &length) == OK && length == size);
    hold(memcmp(out, again, size) == 0);
    room = (uint8_t *)malloc(size);
    if (room != NULL && size > 0) {
        hold(encode(&value, room, size, &length) == OK && memcmp(room, out, size) == 0);
        hold(encode(&value, room, size - 1, &beyond) == ERR_CAPACITY);
    }
    free(room);
} while (0)""",
    "PACKED": """
/* Reads any bytes as a record and writes it, twice: the second time changes nothing. */
#define PACKED(type, unpack, pack, length)
do {
    type value;
    uint8_t out[length], again[length];
    if (size < (length)) {
        break;
    }
    memset(&value, 0, sizeof value);
    unpack(data, &value);
    pack(&value, out);
    unpack(out, &value);
    pack(&value, again);
    hold(memcmp(out, again, sizeof out) == 0);
} while (0)""",
    "FIXED": """
/* A record that nobody gives anything: there is one form of it. */
#define FIXED(decode, encode, most, exact)
do {
    uint8_t out[(most) + 1u];
    size_t length = 0;
    if (decode(data, size) != OK) {
        break;
    }
    hold(encode(out, sizeof out, &length) == OK && length == size);
    hold(!(exact) || memcmp(out, data, size) == 0);
} while (0)""",
    "VALUE": """
/* The value of a register or a parameter. */
#define VALUE(type, decode, encode, held, length)
do {
    type value;
    uint8_t out[length];
    if (size < (length) || decode(data, &value) != OK || encode(value, out) == ERR_OUT_OF_RANGE) {
        break;
    }
    hold(encode(value, out) == OK && memcmp(out, data, held) == 0);
} while (0)""",
    "ARRAY": """
/* The text or the bytes of a register or a parameter. A text ends at its first zero. */
#define ARRAY(declared, decode, encode, exact, length)
do {
    declared, second[sizeof value];
    uint8_t out[length], again[length];
    if (size < (length) || decode(data, value) != OK) {
        break;
    }
    hold(encode(value, out) == OK && (!(exact) || memcmp(out, data, sizeof out) == 0));
    hold(decode(out, second) == OK && encode(second, again) == OK && memcmp(out, again, sizeof out) == 0);
} while (0)""",
    "CONSTANT": """
/* A constant: what is written can be read, and so can what else the device answers. */
#define CONSTANT(type, decode, encode, length)
do {
    type value;
    uint8_t out[length];
    hold(encode(out) == OK && decode(out, &value) == OK);
    hold(size < (length) || decode(data, &value) != ERR_WRONG_CONST);
} while (0)""",
    "TRIGGER": """
/* What starts an action: the device answers anything, and what may be written is read as it was. */
#define TRIGGER(type, decode, encode, held, length)
do {
    type value;
    uint8_t out[length];
    if (size < (length)) {
        break;
    }
    hold(decode(data, &value) == OK);
    hold(encode(value, out) != OK || memcmp(out, data, held) == 0);
} while (0)""",
    "ADDRESS": """
/* An address or a number that is worked out from another: of those that are taken no two have the same. */
#define ADDRESS(type, at)
do {
    type one = 0, other = 0;
    uint32_t first, second;
    if (size < 8) {
        break;
    }
    first = data[0] | (uint32_t)data[1] << 8 | (uint32_t)data[2] << 16 | (uint32_t)data[3] << 24;
    second = data[4] | (uint32_t)data[5] << 8 | (uint32_t)data[6] << 16 | (uint32_t)data[7] << 24;
    if (at(first, &one) == OK && at(second, &other) == OK) {
        hold((first == second) == (one == other));
    }
} while (0)""",
    "CONVERSION": """
/* Any quantity is refused or becomes a count, and a count becomes itself again where the reference is a usual one. */
#define CONVERSION(type, from_raw, to_raw, exact)
do {
    type raw = 0, again = 0;
    double quantity, reference;
    if (size < 2 * sizeof quantity) {
        break;
    }
    memcpy(&quantity, data, sizeof quantity);
    memcpy(&reference, data + sizeof quantity, sizeof reference);
    if (to_raw(quantity, reference, &raw) == OK && (exact) && reference > 1e-9 && reference < 1e9) {
        hold(to_raw(from_raw(raw, reference), reference, &again) == OK && again == raw);
    }
} while (0)""",
}


def target(layout: DeviceLayout, naming: Naming, header: str) -> str:
    """The text of the target."""
    shapes = [(link, direction) for link in layout.links.values() for direction in ("request", "response")]
    calls = [f"frame_{number}(data, size);" for number in range(2 * len(shapes))]
    macros = [*_records(layout, naming), *_values(layout, naming), *_others(layout, naming)]
    choices = [*calls, *(f"{name}({', '.join(arguments)});" for name, *arguments in macros)]
    used = {name for name, *_ in macros}
    functions = [
        lines
        for number, (link, direction) in enumerate(shapes)
        for lines in _frame(naming, link, direction, 2 * number)
    ]
    return filled(
        "backends/c/fuzz.c.in",
        header=header,
        source=header.replace(".h", "_fuzz.c"),
        title=plain(f"{layout.device.name}, version {layout.device.version}"),
        identity=layout.identity,
        macros=[f"\n{_macro(naming, text)}\n" for name, text in _MACROS.items() if name in used],
        functions=["\n".join(["", *lines, ""]) for lines in functions],
        choices=[f"    case {at}:\n        {choice}\n        break;\n" for at, choice in enumerate(choices)],
        number_of_choices=str(len(choices)),
    )


def _macro(naming: Naming, text: str) -> str:
    """The definition of a macro, whose lines are joined and whose statuses are those of the device."""
    about, *lines = text.strip().splitlines()
    for status in ("ERR_OUT_OF_RANGE", "ERR_CAPACITY", "ERR_WRONG_CONST", "OK"):
        own = naming.own_macro(status.lower())
        lines = [line.replace(f" {status})", f" {own})").replace(f" {status} ", f" {own} ") for line in lines]
    return "\n".join([about, f"{lines[0]} \\", *(f"    {line} \\" for line in lines[1:-1]), f"    {lines[-1]}"])


def _exact(record: RecordLayout) -> str:
    """Whether every byte of a record comes back: no reserved ones, and none behind the end of a text."""
    kinds = [field.value.type.kind for field in record.fields if field.value is not None]
    kinds += [case.value.type.kind for field in record.fields for case in field.cases]
    inner = [_exact(field.record) for field in record.fields if field.record is not None]
    reserved = any(field.field.reserved for field in record.fields)
    return "0" if reserved or Kind.TEXT in kinds or "0" in inner else "1"


def _records(layout: DeviceLayout, naming: Naming) -> Iterator[tuple[str, ...]]:
    messages = ((message.request, message.response) for message in layout.messages.values())
    for record in chain(layout.records.values(), *messages):
        decode, encode = (naming.function("record", record.name, end) for end in ("decode", "encode"))
        most = naming.macro("record", record.name, "size")
        if not members(record):
            yield "FIXED", decode, encode, most, _exact(record)
            continue
        kind = naming.type("record", record.name)
        yield "RECORD", kind, decode, encode, most, _exact(record)
        if packed(record):
            unpack, pack = (naming.function("record", record.name, end) for end in ("unpack", "pack"))
            yield "PACKED", kind, unpack, pack, most


def _values(layout: DeviceLayout, naming: Naming) -> Iterator[tuple[str, ...]]:
    device = layout.device
    for laid in layout.registers:
        value = laid.register.value
        wire = Wire(value, laid.order, laid.swapped)
        trigger = value.const is None and laid.register.answer != value
        yield _value(naming, "register", (laid.name,), wire, value.size + value.size % 2, trigger)
    orders = Orders(device.byte_order, device.word_order)
    for held in device.parameters.values():
        for parameter in held.parameters:
            if parameter.reserved:
                continue
            inner = [((held.name, parameter.name, i.name), i.value) for i in parameter.subindices if not i.reserved]
            named: list[tuple[tuple[str, ...], Value]] = [((held.name, parameter.name), parameter.value), *inner]
            for names, value in named:
                trigger = value.const is None and value.as_answer(parameter.trigger) != value
                yield _value(naming, "parameter", names, Wire(value, *orders.of(value)), value.size, trigger)


def _value(naming: Naming, noun: Noun, names: tuple[str, ...], wire: Wire, size: int, trigger: bool) -> tuple[str, ...]:
    """What is fuzzed of a value in `size` bytes; of a `trigger` the device may answer anything."""
    decode, encode = (naming.function(noun, *names, end) for end in ("decode", "encode"))
    kind = declaration(wire, "", None).strip()
    if wire.value.const is not None:
        return "CONSTANT", kind, decode, encode, f"{size}u"
    if wire.kind in (Kind.TEXT, Kind.BYTES):
        exact = "1" if wire.kind is Kind.BYTES and wire.size == size else "0"
        return "ARRAY", declaration(wire, "value", None), decode, encode, exact, f"{size}u"
    return "TRIGGER" if trigger else "VALUE", kind, decode, encode, f"{wire.size}u", f"{size}u"


def _others(layout: DeviceLayout, naming: Naming) -> Iterator[tuple[str, ...]]:
    for table in layout.tables.values():
        yield "ADDRESS", "uint16_t", naming.function("table", table.name, "at")
    for conversion in layout.device.conversions.values():
        size = conversion.type.size
        kind = f"{'' if conversion.type.signed else 'u'}int{8 * size}_t"
        ends = (naming.function("conversion", conversion.name, end) for end in ("from_raw", "to_raw"))
        yield "CONVERSION", kind, *ends, "1" if size < 8 else "0"


def _frame(naming: Naming, link: LinkLayout, direction: str, number: int) -> Iterator[list[str]]:
    """Two functions: one opens any bytes and makes a frame of what it finds, one opens a frame around any bytes."""
    shape = link.frame(direction)
    kind, open_, close = (naming.function("link", link.name, direction, end) for end in ("frame", "open", "close"))
    ok, heads = naming.own_macro("ok"), [frame_member(part.name) for part in head_members(shape)]
    flag = (
        link.link.exception_response.flag if link.link.exception_response is not None and direction == "response" else 0
    )
    code = shape.role("code") is not None
    buffer = "buffer, sizeof buffer, " if wrapped(link) else ""
    declared = ["static uint8_t buffer[2 * LARGEST];"] if buffer else []
    room = ["static uint8_t out[4 * LARGEST];", f"{kind} opened;", "size_t length = 0;"]
    told = f"opened.code | (opened.error ? {flag}u : 0u)" if flag else "opened.code"
    again = ", ".join([*(f"opened.{head}" for head in heads), *([told] if code else []), "opened.body_length"])
    inside = "buffer && opened.body + opened.body_length <= buffer + sizeof buffer"
    if not buffer:
        inside = "data && opened.body + opened.body_length <= data + size"
    # Characters have two ways to write a digit; bytes have one.
    same = "" if link.link.encoding == "hex_ascii" else " && memcmp(out, data, size) == 0"
    yield [
        f"static void frame_{number}(const uint8_t *data, size_t size)",
        "{",
        *indented([*declared, *room, "memset(&opened, 0, sizeof opened);"]),
        f"    if ({open_}(data, size, {buffer}&opened) != {ok}) {{",
        "        return;",
        "    }",
        f"    hold(opened.body >= {inside});",
        f"    memcpy(out + {shape.head_size}, opened.body, opened.body_length);",
        f"    if ({close}({again}, out, sizeof out, &length) == {ok}) {{",
        f"        hold(length == size{same});",
        "    }",
        "}",
    ]
    given = [f"data[{at}]" for at in range(len(heads) + code)]
    compared = [f"opened.{head} == data[{at}]" for at, head in enumerate(heads)]
    if code:
        told = f"(data[{len(heads)}] & {255 & ~flag}u)" if flag else f"data[{len(heads)}]"
        compared.append(f"opened.code == {told}")
    compared += ["opened.body_length == size - GIVEN", "memcmp(opened.body, data + GIVEN, size - GIVEN) == 0"]
    refused = f"{naming.own_macro('err_unknown_code')}"
    yield [
        f"static void frame_{number + 1}(const uint8_t *data, size_t size)",
        "{",
        *indented([f"enum {{ GIVEN = {len(given)} }};", *declared, *room, f"{naming.own('codec_status')} status;"]),
        "    memset(&opened, 0, sizeof opened);",
        "    if (size < GIVEN) {",
        "        return;",
        "    }",
        f"    memcpy(out + {shape.head_size}, data + GIVEN, size - GIVEN);",
        f"    if ({close}({', '.join([*given, 'size - GIVEN', 'out', 'sizeof out', '&length'])}) != {ok}) {{",
        "        return;",
        "    }",
        f"    status = {open_}(out, length, {buffer}&opened);",
        *([f"    if (status == {refused}) {{", "        return;", "    }"] if code else []),
        f"    hold(status == {ok});",
        *(f"    hold({test});" for test in compared),
        "}",
    ]
