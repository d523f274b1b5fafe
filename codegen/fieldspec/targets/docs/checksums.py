"""What a checksum is, in words."""

from __future__ import annotations

from fieldspec.codec.layout.part import PartLayout
from fieldspec.language.model.checksums import checksum_named

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
    return f"{text} and the bytes {suffix}" if suffix else text


def _algorithm_text(algorithm: str) -> str:
    if algorithm in _TEXTS:
        return _TEXTS[algorithm]
    kind = checksum_named(algorithm)
    if kind.method == "crc":
        order = {
            (True, True): ", reflected",
            (True, False): ", with reflected bytes",
            (False, True): ", reflected result",
        }
        reflected = order.get((kind.reflect_in, kind.reflect_out), "")
        final = f", final xor 0x{kind.final_xor:X}" if kind.final_xor else ""
        start = f", start value 0x{kind.initial:X}{final}, of all bytes"
        return f"CRC-{kind.width} with polynomial 0x{kind.polynomial:X}{reflected}{start}"
    start = f", start value 0x{kind.initial:X}" if kind.initial else ""
    operands = "all bytes" if kind.unit_size == 1 else f"all numbers of {kind.unit_size} bytes"
    if kind.method == "fletcher":
        return f"Fletcher checksum of {kind.width} bits, modulo {kind.modulus}{start}, of {operands}"
    complement = {"ones": "one's complement of the ", "twos": "two's complement of the ", "": ""}[kind.complement]
    operation = "sum" if kind.method == "sum" else "exclusive or"
    return f"low {kind.width} bits of the {complement}{operation}{start}, of {operands}"
