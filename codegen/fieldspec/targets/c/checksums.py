"""Checksums in C: a function for each algorithm, and how a frame is compared with it and filled in."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.classes import replace
from fieldspec.foundation.runtime._checksums import reflected
from fieldspec.language.model.checksums import DIGITS, SIMPLE, Checksum, algorithm_name, checksum_named
from fieldspec.language.model.codecs import checksum_codec
from fieldspec.targets.c.declarations import Declaration, Source
from fieldspec.targets.c.expressions import Call, Expression, Identifier
from fieldspec.targets.c.literals import decimal, hexadecimal, unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.number_access import access_name
from fieldspec.targets.c.runtime_files import copy_runtime, package_text
from fieldspec.targets.c.statements import Evaluation, Statement
from fieldspec.targets.c.values import store

_FORMS = "checksum_forms.h"
_SIZES = (1, 2, 4, 8)
_BYTE_OR_SUFFIX = "(offset < size ? in[offset] : suffix[offset - size])"


def checksum_parts(layout: DeviceLayout) -> list[PartLayout]:
    """The checksums of all frames of a device."""
    frames = (frame for link in layout.links.values() for frame in (link.request, link.response))
    return [part for frame in frames for part in frame.checksums]


def declare_checksums(naming: Naming, layout: DeviceLayout) -> list[list[Declaration]]:
    """The functions of the checksums that the device's links use."""
    parts = {_function_name(part): part for part in checksum_parts(layout)}
    computed = {_computed_name(part): part for part in parts.values()}
    kinds = [checksum_named(part.algorithm) for part in parts.values()]
    shared: list[list[Declaration]] = []
    if any(kind.reflect_in != kind.reflect_out for kind in kinds):
        shared.append([copy_runtime(naming, _FORMS, "reverse")])
    if any(kind.method == "crc" and kind.unit_size > 1 for kind in kinds):
        shared.append([copy_runtime(naming, _FORMS, "swapped")])
    functions: list[list[Declaration]] = [
        [_function(naming, name, part) if name not in SIMPLE else copy_runtime(naming, "checksums.h", name)]
        for name, part in sorted(computed.items())
    ]
    avoiding = {name: part for name, part in sorted(parts.items()) if name not in computed}
    functions += [[_avoiding(naming, name, part)] for name, part in avoiding.items()]
    if not all(map(_is_number, checksum_parts(layout))):
        functions.append([copy_runtime(naming, _FORMS, "characters")])
    return [*shared, *functions]


def _function_name(part: PartLayout) -> str:
    """The name of the function of a checksum; one that adds numbers of several bytes depends on their order."""
    return _ordered_name(part.algorithm, part.order)


def _computed_name(part: PartLayout) -> str:
    """The name of the function that computes a checksum before bytes of it are replaced."""
    kind = replace(checksum_named(part.algorithm), avoided=b"", replacements=b"")
    return _ordered_name(algorithm_name(kind), part.order)


def _ordered_name(algorithm: str, order: str) -> str:
    kind = checksum_named(algorithm)
    has_order = kind.method != "crc" and kind.unit_size > 1
    name = f"{kind.codec}_checksum" if kind.codec else algorithm
    return f"{name}_{'le' if order == 'little' else 'be'}" if has_order else name


def _is_number(part: PartLayout) -> bool:
    """Whether a checksum is a number that a function loads and stores."""
    return not part.digits and part.size in _SIZES


def _bits(width: int) -> int:
    return next(8 * size for size in _SIZES if 8 * size >= width)


def _function(naming: Naming, name: str, part: PartLayout) -> Source:
    kind = checksum_named(part.algorithm)
    if kind.codec:
        return package_text(naming, checksum_codec(kind.codec))
    result, order = _bits(kind.width), kind.unit_order or part.order
    if kind.method == "crc":
        form, words = _crc_words(kind, result)
    elif kind.method == "fletcher":
        form, words = "fletcher", _fletcher_words(kind, order)
    else:
        form, words = "total", _total_words(kind, order)
    words |= {"ALGORITHM": name, "RESULT": f"uint{result}_t", **_suffix_words(kind)}
    return copy_runtime(naming, _FORMS, form, words)


def _avoiding(naming: Naming, name: str, part: PartLayout) -> Source:
    """The function of a checksum with other bytes in place of those that must not occur."""
    kind = checksum_named(part.algorithm)
    words = {
        "ALGORITHM": name,
        "COMPUTED": _computed_name(part),
        "RESULT": f"uint{_bits(kind.width)}_t",
        "COUNT": f"{len(kind.avoided)}u",
        "AVOIDED": _array(kind.avoided),
        "REPLACEMENTS": _array(kind.replacements),
        "BITS": f"{8 * kind.size}u",
    }
    return copy_runtime(naming, _FORMS, "avoiding", words)


def _array(data: bytes) -> str:
    return f"{{{', '.join(f'0x{byte:02X}u' for byte in data)}}}"


def _suffix_words(kind: Checksum) -> dict[str, str]:
    """How a loop takes the bytes that a checksum covers, and those after them."""
    words = {"INDEX": "size_t offset;", "SIZE": "size", "BYTE": "in[offset]"}
    if kind.suffix:
        index = f"static const uint8_t suffix[{len(kind.suffix)}] = {_array(kind.suffix)};\n    size_t offset;"
        words = {"INDEX": index, "SIZE": f"size + {len(kind.suffix)}u", "BYTE": _BYTE_OR_SUFFIX}
    if kind.method == "crc" and kind.unit_size > 1:
        unit, total = f"{kind.unit_size}u", words["SIZE"]
        place = f"device_swapped(offset, {unit})"
        byte = words["BYTE"].replace("offset - size", f"{place} - size").replace("offset < size", f"{place} < size")
        byte = byte.replace("in[offset]", f"in[{place}]")
        words["SIZE"] = f"({total} + {kind.unit_size - 1}u) / {unit} * {unit}"
        words["BYTE"] = f"({place} < {total} ? {byte} : 0u)"
    return words


def _hexadecimal_number(number: int, bits: int) -> str:
    """`0x1021u`, or `((uint64_t)0x42F0E1EBu << 32 | 0xA9EA3693u)`: C++98 has no literals of 64 bits."""
    if not number >> 32:
        return f"0x{number:0{min(bits, 32) // 4}X}u"
    low = f" | 0x{number & 0xFFFFFFFF:08X}u" if number & 0xFFFFFFFF else ""
    return f"((uint64_t)0x{number >> 32:08X}u << 32{low})"


def _crc_words(kind: Checksum, bits: int) -> tuple[str, dict[str, str]]:
    """The form of a CRC, and the words in it. The register of one that is not reflected begins at its highest bit."""
    mask, up = (1 << bits) - 1, bits - kind.width
    terms = []
    for digit in range(16):
        register = digit if kind.reflect_in else digit << bits - 4
        for _ in range(4):
            if kind.reflect_in:
                register = register >> 1 ^ (reflected(kind.polynomial, kind.width) if register & 1 else 0)
            else:
                register = (register << 1 & mask) ^ (kind.polynomial << up if register >> bits - 1 else 0)
        terms.append(_hexadecimal_number(register, bits))
    row_length = {8: 8, 16: 8, 32: 4, 64: 2}[bits]
    rows = [f"        {', '.join(terms[index : index + row_length])}," for index in range(0, 16, row_length)]
    crc = "crc" if kind.reflect_in or not up else f"(crc >> {up})"
    if kind.reflect_in != kind.reflect_out:
        crc = f"device_reversed({crc}, {kind.width}u)"
    final = f" ^ {_hexadecimal_number(kind.final_xor, bits)}" if kind.final_xor else ""
    start = reflected(kind.initial, kind.width) if kind.reflect_in else kind.initial << up
    order = ", reflected" if kind.reflect_in else ""
    description = f"CRC-{kind.width}, polynomial 0x{kind.polynomial:X}{order}, start value 0x{kind.initial:X}"
    description += f", final xor 0x{kind.final_xor:X}." if kind.final_xor else "."
    return ("reflected" if kind.reflect_in else "forward"), {
        "ABOUT": description,
        "REGISTER": f"uint{bits}_t",
        "TABLE": "\n".join(rows),
        "START": _hexadecimal_number(start, bits),
        "FINISH": f"return (uint{bits}_t)({crc}{final});" if final or crc != "crc" else "return crc;",
        "BYTE_SHIFT": str(bits - 8),
        "DIGIT_SHIFT": str(bits - 4),
    }


def _fletcher_words(kind: Checksum, order: str) -> dict[str, str]:
    """The words in the form of a Fletcher checksum. A sum and a number that is added to it fit a register."""
    half = kind.width // 2
    bits = 64 if half > 16 else 32
    result = _bits(kind.width)
    size, total = kind.unit_size, f"size + {len(kind.suffix)}u" if kind.suffix else "size"
    operands = f"numbers of {size} bytes" if size > 1 else "all bytes"
    modulo = f"& {_hexadecimal_number(kind.modulus - 1, bits)}" if kind.modulus == 1 << half else f"% {kind.modulus}u"
    step, complete = f"upper = (upper + lower) {modulo};", f"offset % {size}u == {size - 1}u || offset + 1u == {total}"
    return {
        "ABOUT": f"The Fletcher checksum of {operands}, {kind.width} bits, modulo {kind.modulus}.",
        "REGISTER": f"uint{bits}_t",
        "UPPER_START": _hexadecimal_number(kind.initial >> half, bits),
        "LOWER_START": _hexadecimal_number(kind.initial & (1 << half) - 1, bits),
        "TERM": _term(kind, order, f"uint{bits}_t"),
        "MODULO": modulo,
        "STEP": f"if ({complete}) {{\n            {step}\n        }}" if size > 1 else step,
        "FINISH": f"return (uint{result}_t)(upper << {half} | lower);",
    }


def _term(kind: Checksum, order: str, register: str) -> str:
    """The number that a byte adds to a sum: the byte, or the part of a number of several bytes that it is."""
    byte = _BYTE_OR_SUFFIX if kind.suffix else "in[offset]"
    if kind.unit_size == 1:
        return byte
    place = f"offset % {kind.unit_size}u"
    shift = f"8u * ({place})" if order == "little" else f"8u * ({kind.unit_size - 1}u - {place})"
    return f"(({register}){byte} << ({shift}))"


def _total_words(kind: Checksum, order: str) -> dict[str, str]:
    """The words in the form of a sum or an xor."""
    bits = 64 if max(kind.width, 8 * kind.unit_size) > 32 else 32
    register = f"uint{bits}_t"
    number = {"": "number", "ones": "~number", "twos": "0u - number"}[kind.complement]
    operands = f"numbers of {kind.unit_size} bytes" if kind.unit_size > 1 else "all bytes"
    operation = "sum" if kind.method == "sum" else "exclusive or"
    complement = f"The {kind.complement[:-1]}'s complement of the" if kind.complement else "The"
    return {
        "ABOUT": f"{complement} {operation} of {operands}, {kind.width} bits.",
        "REGISTER": register,
        "START": _hexadecimal_number(kind.initial, bits),
        "OPERATOR": "+" if kind.method == "sum" else "^",
        "TERM": _term(kind, order, register),
        "FINISH": f"return (uint{_bits(kind.width)}_t)(({number}) & {_hexadecimal_number(kind.mask, bits)});",
    }


def compute_checksum(naming: Naming, checksum: PartLayout, source: Expression, total: Expression) -> Call:
    """`crc16_modbus(in + 1, length - 3u)`: the checksum of the bytes that it covers in a frame of `total` bytes."""
    start, stop = checksum.start, checksum.stop or 0
    first = source
    if start:
        first = source + (decimal(start) if start > 0 else total.plus(start))
    # A start and a stop that are counted from the same end bound a constant size.
    size = unsigned(stop - start) if start < 0 or stop > 0 else total.plus(stop - start)
    return Call(naming.own(_function_name(checksum)), (first, size))


def is_wrong(naming: Naming, checksum: PartLayout, computed: Expression, place: Expression) -> Expression:
    """The test whether a received checksum is another one: `crc16_modbus(in, length - 2u) != load_u16_le(...)`"""
    if _is_number(checksum):
        return computed.differs(Call(naming.own(f"load_{_access(checksum)}"), (place,)))
    return Call(naming.own("is_checksum"), (place, *_characters(checksum, computed))).negated()


def store_checksum(naming: Naming, checksum: PartLayout, computed: Expression, place: Expression) -> Statement:
    """Writes a checksum into its frame."""
    if _is_number(checksum):
        return store(naming, _access(checksum), place, computed)
    return Evaluation(Call(naming.own("store_checksum"), (place, *_characters(checksum, computed))))


def _access(checksum: PartLayout) -> str:
    return access_name(checksum.size, checksum.order, False)


def _characters(checksum: PartLayout, computed: Expression) -> Iterable[Expression]:
    """The arguments that say how a checksum is sent: size, number, base, letter, whether it begins with the lowest."""
    letter = hexadecimal(0x61 if checksum.digits == "lower_hex" else 0x41, 1)
    little = not checksum.digits and checksum.order == "little"
    base = unsigned(DIGITS[checksum.digits] if checksum.digits else 256)
    return unsigned(checksum.size), computed, base, letter, Identifier("true" if little else "false")
