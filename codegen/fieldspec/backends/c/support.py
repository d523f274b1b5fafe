"""What every header needs: the status, numbers byte by byte, characters, and check algorithms."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.c.machine import cleared, copied
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.text import comment
from fieldspec.backends.c.values import Wire, access_functions, signed_functions
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import Orders, RecordLayout
from fieldspec.model.value import Kind

STATUSES = (
    ("ok", "It is done."),
    ("err_incomplete", "There are too few bytes."),
    ("err_wrong_length", "The bytes, or elements, are not as many as they must be."),
    ("err_wrong_mark", "The frame does not start or end with its mark."),
    ("err_not_hex", "A character is no hexadecimal digit."),
    ("err_wrong_check", "The check does not fit the bytes."),
    ("err_unknown_code", "No message has this code."),
    ("err_unknown_value", "The value is none of those that there are."),
    ("err_wrong_const", "A constant has another value."),
    ("err_wrong_measure", "A field that holds a size does not fit what it measures."),
    ("err_out_of_range", "A value is out of its range."),
    ("err_capacity", "The buffer is too small."),
)


def status_lines(naming: Naming) -> list[str]:
    """The type that every function returns."""
    lines = [*comment("What a function has to say."), f"typedef enum {naming.own('codec_status')} {{"]
    for at, (name, text) in enumerate(STATUSES):
        comma = "," if at + 1 < len(STATUSES) else ""
        lines.append(f"    {naming.own_macro(name)} = {at}{comma} /**< {text} */")
    return [*lines, f"}} {naming.own('codec_status')};"]


def accesses(layout: DeviceLayout) -> list[tuple[int, str, bool]]:
    """The widths and orders in which numbers of the device lie."""
    found = {
        (wire.size, wire.order, wire.swapped) if wire.size > 1 else (1, "big", False)
        for wire in _wires(layout)
        if wire.kind not in (Kind.TEXT, Kind.BYTES)
    }
    for link in layout.links.values():
        for frame in (link.request, link.response):
            for part in (*frame.head, *frame.tail):
                found.add((part.size, part.order, False) if part.size > 1 else (1, "big", False))
    return sorted(found)


def _wires(layout: DeviceLayout) -> Iterator[Wire]:
    """The values of records, registers and parameters, as they lie in bytes."""
    device = layout.device
    orders = Orders(device.byte_order, device.word_order)
    for record in _records(layout):
        for field in record.fields:
            if field.value is not None:
                yield Wire(field.value, field.order, field.swapped)
            yield from (Wire(case.value, case.order, case.swapped) for case in field.cases)
    for register in layout.registers:
        yield Wire(register.register.value, register.order, register.swapped)
    for held in device.parameters.values():
        for parameter in held.parameters:
            for value in (parameter.value, *(inner.value for inner in parameter.subindices)):
                yield Wire(value, *orders.of(value))


def _records(layout: DeviceLayout) -> Iterator[RecordLayout]:
    yield from layout.records.values()
    for message in layout.messages.values():
        yield message.request
        yield message.response


def number_lines(naming: Naming, layout: DeviceLayout) -> list[list[str]]:
    """The functions for numbers, texts and characters that the device has."""
    blocks = [access_functions(naming, *access) for access in accesses(layout)]
    blocks.append(signed_functions(naming))
    kinds = {wire.kind for wire in _wires(layout)}
    if Kind.FLOAT in kinds:
        blocks.append(_floats(naming))
    if Kind.TEXT in kinds:
        blocks.append(_texts(naming))
    if any(link.link.encoding == "hex_ascii" for link in layout.links.values()):
        blocks.append(_digits(naming))
    return blocks


def _floats(naming: Naming) -> list[str]:
    inline = naming.own_macro("inline")
    return [
        f"{inline} float {naming.own('float_of')}(uint32_t bits)",
        "{",
        "    float value;",
        f"    {copied(naming, '&value', '&bits', 'sizeof value')}",
        "    return value;",
        "}",
        "",
        f"{inline} uint32_t {naming.own('bits_of')}(float value)",
        "{",
        "    uint32_t bits;",
        f"    {copied(naming, '&bits', '&value', 'sizeof bits')}",
        "    return bits;",
        "}",
    ]


def _texts(naming: Naming) -> list[str]:
    return [
        f"static inline bool {naming.own('is_ascii')}(const uint8_t *in, size_t size)",
        "{",
        "    size_t at;",
        "    for (at = 0; at < size; at++) {",
        "        if (in[at] > 127u) {",
        "            return false;",
        "        }",
        "    }",
        "    return true;",
        "}",
        "",
        *comment("Whether a text of at most size characters has no others than those of ASCII."),
        f"static inline bool {naming.own('is_text')}(const char *text, size_t size)",
        "{",
        "    size_t at;",
        "    for (at = 0; at < size && text[at] != '\\0'; at++) {",
        "        if ((uint8_t)text[at] > 127u) {",
        "            return false;",
        "        }",
        "    }",
        "    return true;",
        "}",
        "",
        *comment("Writes a text of at most size characters, filled up with zeros."),
        f"static inline void {naming.own('put_text')}(uint8_t *out, const char *text, size_t size)",
        "{",
        "    size_t at;",
        f"    {cleared(naming, 'out', 'size')}",
        "    for (at = 0; at < size && text[at] != '\\0'; at++) {",
        "        out[at] = (uint8_t)text[at];",
        "    }",
        "}",
    ]


def _digits(naming: Naming) -> list[str]:
    return [
        *comment("The value of a hexadecimal digit; more than 15 for any other character."),
        f"static inline uint8_t {naming.own('digit')}(uint8_t character)",
        "{",
        "    if (character >= 0x30u && character <= 0x39u) {",
        "        return (uint8_t)(character - 0x30u);",
        "    }",
        "    if (character >= 0x41u && character <= 0x46u) {",
        "        return (uint8_t)(character - 0x37u);",
        "    }",
        "    if (character >= 0x61u && character <= 0x66u) {",
        "        return (uint8_t)(character - 0x57u);",
        "    }",
        "    return 0xFFu;",
        "}",
        "",
        f"static inline uint8_t {naming.own('hex_digit')}(uint8_t value)",
        "{",
        "    return (uint8_t)(value < 10u ? value + 0x30u : value + 0x37u);",
        "}",
    ]


def check_lines(naming: Naming, algorithms: set[str]) -> list[list[str]]:
    """The functions of the check algorithms that the device's links use."""
    return [_CHECKS[name](naming) for name in sorted(algorithms)]


def _crc16(naming: Naming) -> list[str]:
    """CRC-16 with a table of 16 entries, or of 256 where speed counts more than 480 bytes."""
    small, large = _crc_rows(4), _crc_rows(8)
    wide = naming.own_macro("wide_crc_table")
    return [
        *comment(
            "CRC-16, polynomial 0xA001 reflected, start value 0xFFFF.", f"Define {wide} for a table of 512 bytes."
        ),
        f"static inline uint16_t {naming.own('crc16_modbus')}(const uint8_t *in, size_t size)",
        "{",
        f"#ifdef {wide}",
        "    static const uint16_t table[256] = {",
        *(f"        {row}," for row in large),
        "    };",
        "    uint16_t crc = 0xFFFFu;",
        "    size_t at;",
        "    for (at = 0; at < size; at++) {",
        "        crc = (uint16_t)(crc >> 8 ^ table[(crc ^ in[at]) & 0xFFu]);",
        "    }",
        "#else",
        "    static const uint16_t table[16] = {",
        *(f"        {row}," for row in small),
        "    };",
        "    uint16_t crc = 0xFFFFu;",
        "    size_t at;",
        "    for (at = 0; at < size; at++) {",
        "        crc = (uint16_t)(crc ^ in[at]);",
        "        crc = (uint16_t)(crc >> 4 ^ table[crc & 15u]);",
        "        crc = (uint16_t)(crc >> 4 ^ table[crc & 15u]);",
        "    }",
        "#endif",
        "    return crc;",
        "}",
    ]


def _crc_rows(bits: int) -> list[str]:
    """The entries of a table for so many bits, eight on a line."""
    entries = [f"0x{_crc_entry(at, bits):04X}u" for at in range(1 << bits)]
    return [", ".join(entries[at : at + 8]) for at in range(0, len(entries), 8)]


def _crc_entry(at: int, bits: int) -> int:
    for _ in range(bits):
        at = at >> 1 ^ (0xA001 if at & 1 else 0)
    return at


def _sum(naming: Naming, name: str, what: str, last: str) -> list[str]:
    return [
        *comment(what),
        f"static inline uint8_t {naming.own(name)}(const uint8_t *in, size_t size)",
        "{",
        "    uint32_t sum = 0;",
        "    size_t at;",
        "    for (at = 0; at < size; at++) {",
        "        sum += in[at];",
        "    }",
        f"    return (uint8_t)({last} & 0xFFu);",
        "}",
    ]


def _lrc(naming: Naming) -> list[str]:
    return _sum(naming, "lrc", "The two's complement of the sum of all bytes.", "(0u - sum)")


def _sum8(naming: Naming) -> list[str]:
    return _sum(naming, "sum8", "The low byte of the sum of all bytes.", "sum")


_CHECKS = {"crc16_modbus": _crc16, "lrc": _lrc, "sum8": _sum8}
