"""C that is the same in all headers but for the prefix of its names: the files of `runtime/`, and their parts.

The names in these files begin with `device_` and `DEVICE_`. A file has parts where a line such as
`/* ---- u16_be ---- */` begins each.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache, partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.package_codecs import number_codecs
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import Orders, RecordLayout, RegisterLayout
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.codecs import Codec, NumberCodec
from fieldspec.language.model.digits import NIBBLES
from fieldspec.language.model.encoding import MACHINE_BITS, Sign, Whole, is_odd, is_text
from fieldspec.language.model.value import Value
from fieldspec.targets.c.declarations import Source
from fieldspec.targets.c.digits import digits_parts
from fieldspec.targets.c.literals import hexadecimal
from fieldspec.targets.c.machine import machine, machine_bits
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.number_access import access_functions, access_name
from fieldspec.targets.c.subcodes import all_subcodes
from fieldspec.targets.c.values import WireValue
from fieldspec.targets.pieces import piece
from fieldspec.targets.templates import text

_FOLDER = "targets/c/runtime"
_PART = re.compile(r"^/\* ---- (\w+) ---- \*/\n\n", re.MULTILINE)
_PREFIXED = re.compile(r"\b(?:device|DEVICE)_(\w+)")
_CONDITIONAL = re.compile(r"^(.*?) +/\* if (\w+) \*/\n", re.MULTILINE)
_STATUS = re.compile(r"^    DEVICE_(\w+) = ", re.MULTILINE)


def copy_runtime(naming: Naming, file: str, part: str = "", words: Mapping[str, str] | None = None) -> Source:
    """A file, or a part of it, with the names of a device. `words` replace the words of a form."""
    replaced = tuple(words.items()) if words else ()
    return piece("c runtime", (), (file, part, replaced), lambda: _copied(naming, file, part, words), naming)


def _copied(naming: Naming, file: str, part: str, words: Mapping[str, str] | None) -> Source:
    return _named(naming, runtime_text(file, part, words))


def runtime_text(file: str, part: str = "", words: Mapping[str, str] | None = None) -> str:
    """A file, or a part of it, with the names of no device. `words` replace the words of a form.

    A line that ends with `/* if WORD */` is left out where this word is empty.
    """
    content = _parts(file)[part] if part else text(f"{_FOLDER}/{file}")
    if not words:
        return content
    content = _CONDITIONAL.sub(lambda m: f"{m[1]}\n" if words[m[2]] else "", content)
    return re.sub(r"\b(device_)?(" + "|".join(words) + r")\b", lambda m: (m[1] or "") + words[m[2]], content)


def _named(naming: Naming, content: str) -> Source:
    """C of this folder or of a package, with the names of a device."""
    return Source(_PREFIXED.sub(lambda match: _device_name(naming, match), content))


def _copy_accesses(naming: Naming, used: set[str], is_odd: bool) -> list[list[Source]]:
    """The functions that load and store numbers of the sizes that C has, or of the others."""
    return [
        [piece("c accesses", (), (name,), partial(_named, naming, functions), naming)]
        for name, functions in access_functions(is_odd).items()
        if name in used
    ]


def _device_name(naming: Naming, match: re.Match[str]) -> str:
    name = match[1]
    return naming.own_macro(name.lower()) if match[0][0] == "D" else naming.own(name)


@cache
def _parts(file: str) -> dict[str, str]:
    """The parts of a file by their names."""
    _, *pieces = _PART.split(text(f"{_FOLDER}/{file}"))
    return dict(zip(pieces[::2], pieces[1::2], strict=True))


def runtime_parts(file: str) -> list[str]:
    """The names of a file's parts."""
    return list(_parts(file))


def status_names() -> list[str]:
    """The constants of the status in the order of their numbers: `ok`, `err_incomplete`, ..."""
    return [name.lower() for name in _STATUS.findall(text(f"{_FOLDER}/status.h"))]


def runtime_macros() -> list[str]:
    """The macros that every header defines."""
    files = (text(f"{_FOLDER}/{name}") for name in ("enum_size.h", "machine.h"))
    defined = [macro for content in files for macro in re.findall(r"#define DEVICE_(\w+)", content)]
    return [*dict.fromkeys(name.lower() for name in defined), *status_names()]


def copy_numbers(naming: Naming, layout: DeviceLayout) -> list[list[Source]]:
    """The functions for the numbers, texts and characters that the device has."""
    wires = list(_wire_values(layout))
    encodings = {wire.encoding for wire in wires} | {value.encoding for value in _part_values(layout)}
    # The functions for absent values take those of signals that no record places, too.
    encodings |= {signal.value.encoding for signal in layout.device.signals.values() if signal.value.sentinels}
    functions = {machine(encoding).from_bits for encoding in encodings}
    usual_texts = any(is_text(wire.encoding) and wire.value.text_form is None for wire in wires)
    characters = any(link.link.transmission == "hex_ascii" for link in layout.links.values())
    parts = [
        *(["bits"] if has_bits(layout) else []),
        "signed",
        *(["float"] if functions & {"float_of", "float_of_half"} else []),
        *(["double"] if "double_of" in functions else []),
        *(["text"] if usual_texts else []),
        *(["hexadecimal"] if characters else []),
    ]
    odd = _copy_accesses(naming, _odd_accesses(layout, wires), is_odd=True)
    odd += [
        [copy_runtime(naming, "number_forms.h", "signed", signed_words(bits))]
        for bits in range(8, 65, 8)
        if bits not in MACHINE_BITS and f"signed_{bits}" in functions
    ]
    odd += [[copy_runtime(naming, "number_forms.h", "half")]] * ("float_of_half" in functions)
    odd += [
        [copy_runtime(naming, "number_forms.h", "magnitude", _magnitude_words(bits))]
        for bits in range(8, 65, 8)
        if f"of_magnitude_{bits}" in functions
    ]
    numbers = [*(wire.value for wire in wires), *_part_values(layout)]
    digits = digits_parts([value for value in numbers if value.digits])
    encoded = any(wire.value.text_form is not None for wire in wires)
    odd += [[copy_runtime(naming, "encoded_texts.h", "encoded_texts")]] * encoded
    has_spans = any(record.spans for record in all_records(layout))
    has_lists = any(record.inner_lists is not None for record in all_records(layout))
    odd += [[copy_runtime(naming, "counts.h", "counts")]] * (has_spans or has_lists)
    odd += [[copy_runtime(naming, "widths.h", "widths")]] * has_spans
    if has_lists:
        odd += [[copy_runtime(naming, f"{part}.h", part)] for part in ("list_elements", "inner_lists")]
    odd += [_codec(naming, name, codec) for name, codec in number_codecs(layout).items()]
    additional = odd + [[copy_runtime(naming, "digits.h", part)] for part in digits]
    accesses = _copy_accesses(naming, _accesses(layout, wires), is_odd=False)
    return accesses + [[copy_runtime(naming, "numbers.h", part)] for part in parts] + additional


def _accesses(layout: DeviceLayout, wires: Iterable[WireValue]) -> set[str]:
    """The widths and orders of the device's numbers, as in the names of the functions that load and store them."""
    used = {wire.access for wire in wires if not wire.is_array and not wire.value.is_as_sent}
    for link in layout.links.values():
        for frame in (link.request, link.response):
            used |= {access_name(part.size, part.order, False) for part in frame.parts if not part.form}
        used |= {access_name(4, "big", False)} if link.link.is_can else set()  # that of the identifier
    return used | {access_name(subcode.size, subcode.order, False) for subcode in all_subcodes(layout)}


def _odd_accesses(layout: DeviceLayout, wires: Iterable[WireValue]) -> set[str]:
    """The functions that load and store numbers of odd sizes or in BCD."""
    odd = (wire for wire in wires if is_odd(wire.encoding) or wire.value.digits in NIBBLES)
    parts = (part for part in _parts_of_frames(layout) if part.value is not None and is_odd(part.value.encoding))
    used = {wire.access for wire in odd} | {access_name(part.size, part.order, False) for part in parts}
    subcodes = (subcode for subcode in all_subcodes(layout) if 8 * subcode.size not in MACHINE_BITS)
    return used | {access_name(subcode.size, subcode.order, False) for subcode in subcodes}


def package_text(naming: Naming, codec: Codec) -> Source:
    """The C of a package, with the names of a device."""
    return _named(naming, codec.c.strip() + "\n")


def _codec(naming: Naming, name: str, codec: NumberCodec) -> list[Source]:
    """The C of a codec, and the functions that test what bytes are before they load it."""
    words = {"codec_decode": f"{name}_decode", "is_codec": f"is_codec_{name}", "load_codec": f"load_codec_{name}"}
    words |= {"LOW": f"INT64_C({codec.low})", "HIGH": f"INT64_C({codec.high})"}
    return [package_text(naming, codec), copy_runtime(naming, "number_forms.h", "codec", words)]


def signed_words(bits: int) -> dict[str, str]:
    """The words of the function from the bits of a signed number that has fewer bits than its type to the number."""
    number = machine(Whole(bits, Sign.COMPLEMENT))
    sign = f"0x{1 << bits - 1:X}"
    sign, lowest = (f"{sign}u", sign) if bits < 32 else (f"UINT64_C({sign})", f"INT64_C({sign})")
    words = {"signed": f"signed_{bits}", "number_type": number.type, "word_type": number.word}
    return {**words, "SIGN": sign, "LEAST": lowest}


def _magnitude_words(bits: int) -> dict[str, str]:
    """The words of the functions between the bits of a number with sign and magnitude and the number."""
    sign = Whole(bits, Sign.MAGNITUDE)
    width = max(machine_bits(bits), 32)
    return {
        "of_magnitude": f"of_magnitude_{bits}",
        "magnitude_of": f"magnitude_of_{bits}",
        "number_type": machine(sign).type,
        "word_type": machine(sign).word,
        "wide_type": f"int{width}_t",
        "wide_word": f"uint{width}_t",
        "SIGN": hexadecimal(1 << bits - 1, machine_bits(bits) // 8).text,
        "MAGNITUDE": hexadecimal((1 << bits - 1) - 1, machine_bits(bits) // 8).text,
    }


def _wire_values(layout: DeviceLayout) -> Iterator[WireValue]:
    """The values of records, registers and parameters, as they lie in bytes."""
    device = layout.device
    orders = Orders(device.byte_order, device.word_order)
    for record in all_records(layout):
        for field in record.fields:
            if field.value is not None:
                yield WireValue(field.value, field.order, field.swapped)
            yield from (WireValue(case.value, case.order, case.swapped) for case in field.cases)
    for register in layout.registers:
        if not is_bit(register):
            value = register.register.value
            for swapped in {register.swapped, value.write_swapped(register.swapped)}:
                yield WireValue(value, register.order, swapped)
    for parameters in device.parameters.values():
        for parameter in parameters.parameters:
            for value in (parameter.value, *(inner.value for inner in parameter.subindices)):
                yield WireValue(value, *orders.of(value))


def _part_values(layout: DeviceLayout) -> Iterator[Value]:
    """The values of the parts of frames that have one."""
    yield from (part.value for part in _parts_of_frames(layout) if part.value is not None)


def _parts_of_frames(layout: DeviceLayout) -> Iterator[PartLayout]:
    """The parts of the frames of both directions."""
    for link in layout.links.values():
        yield from (*link.request.parts, *link.response.parts)


def has_bits(layout: DeviceLayout) -> bool:
    """Whether the device has registers of single bits."""
    return any(is_bit(register) for register in layout.registers)


def is_bit(register: RegisterLayout) -> bool:
    """Whether a register is a single bit, which messages pack into bytes."""
    return register.register.value.type.name == BIT


def all_records(layout: DeviceLayout) -> Iterator[RecordLayout]:
    """The records of a device, then the data of its messages."""
    yield from layout.records.values()
    for message in layout.messages.values():
        yield from message.bodies
