"""The description of a checksum."""

from __future__ import annotations

from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.checksums import algorithm_name, checksum_named

_TEXTS = {
    "crc16_modbus": "CRC-16 with polynomial 8005h, reflected, start value FFFFh, of all bytes",
    "lrc": "two's complement of the sum of all bytes",
    "sum8": "low byte of the sum of all bytes",
}
DIGITS = {
    "decimal": "sent as decimal digits",
    "upper_hex": "sent as hexadecimal digits in capitals",
    "lower_hex": "sent as hexadecimal digits in small letters",
}


def checksum_text(part: PartLayout) -> str:
    """`CRC-16 with polynomial 8005h, reflected, start value FFFFh, of all bytes`"""
    prefix, suffix = (code.hex(" ").upper() for code in (part.part.prefix, part.part.suffix))
    text = _algorithm_text(part.part.stated_algorithm)
    if prefix:
        text = f"{text.removesuffix('all bytes')}the bytes {prefix} and all bytes"
    text = f"{text} and the bytes {suffix}" if suffix else text
    kind = checksum_named(part.part.stated_algorithm)
    avoided, replacements = (code.hex(" ").upper() for code in (kind.avoided, kind.replacements))
    return f"{text}, with {replacements} in place of its bytes {avoided}" if avoided else text


def _algorithm_text(algorithm: str) -> str:
    kind = checksum_named(algorithm)
    computed = algorithm_name(replace(kind, avoided=b"", replacements=b""))
    if computed in _TEXTS:
        return _TEXTS[computed]
    if kind.method == "crc":
        orders = {
            (True, True): ", reflected",
            (True, False): ", with reflected bytes",
            (False, True): ", reflected result",
        }
        reflected = orders.get((kind.reflect_in, kind.reflect_out), "")
        final = f", final xor 0x{kind.final_xor:X}" if kind.final_xor else ""
        units = f", in numbers of {kind.unit_size} bytes with the last one first" if kind.unit_size > 1 else ""
        start = f", start value 0x{kind.initial:X}{final}{units}, of all bytes"
        return f"CRC-{kind.width} with polynomial 0x{kind.polynomial:X}{reflected}{start}"
    start = f", start value 0x{kind.initial:X}" if kind.initial else ""
    order = f" with the {'low' if kind.unit_order == 'little' else 'high'} byte first" if kind.unit_order else ""
    operands = "all bytes" if kind.unit_size == 1 else f"all numbers of {kind.unit_size} bytes{order}"
    if kind.method == "fletcher":
        return f"Fletcher checksum of {kind.width} bits, modulo {kind.modulus}{start}, of {operands}"
    complement = {"ones": "one's complement of the ", "twos": "two's complement of the ", "": ""}[kind.complement]
    operation = "sum" if kind.method == "sum" else "exclusive or"
    return f"low {kind.width} bits of the {complement}{operation}{start}, of {operands}"
