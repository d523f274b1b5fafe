"""The imports of a version's module: of the private names that its text uses, and of no others."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.python.parts import all_words


@dataclass(frozen=True, slots=True)
class ImportsView:
    """The lines that import from the standard library and from the shared modules, and those that define tables."""

    standard: list[str]
    shared: list[str]
    tables: list[str]


def imports_view(words: AbstractSet[str]) -> ImportsView:
    """The imports of a module with some words; the tables are defined from names that are imported too."""
    tables = [line for names, line in _TABLES if not words.isdisjoint(names)]
    used = words | all_words("\n".join(tables))
    shared = [
        f"from ..{module} import {name} as _{name}"
        for module, names in _SHARED.items()
        for name in sorted(names.split())
        if f"_{name}" in used
    ]
    standard = [f"from {module} import {name} as {alias}" for alias, module, name in _STANDARD if alias in used]
    return ImportsView(standard, shared, tables)


def client_imports(words: AbstractSet[str]) -> list[str]:
    """The lines that import what a client with some words needs from the shared modules."""
    return [
        f"from ..{module} import {name} as _{name}"
        for module, names in _CLIENT.items()
        for name in sorted(names.split())
        if f"_{name}" in words
    ]


_STANDARD = (
    ("_IntEnum", "enum", "IntEnum"),
    ("_Struct", "struct", "Struct"),
    ("_index", "operator", "index"),
    ("_StructError", "struct", "error"),
)
_SHARED = {
    "_absent": "LEFT_OUT LeftOut counts_or_absent real_or_absent state_of",
    "_bits": "BitArray packed_bits single_bit unpacked_bits",
    "_checks": "BYTES CRC CRC_EXCHANGED crc16_modbus",
    "_checksums": "Avoiding Crc Fletcher Followed Sum Swapped Xor",
    "_choices": "Cases Choice",
    "_can": "CanFrame CanIdentifier",
    "_codes": "by_number by_printed_name",
    "_codecs": "CHECKSUMS",
    "_conversions": (
        "UNFIT UNREAD Repeated booleans constants counts decoded_at decoded_each float_bytes float_of magnitude_bytes"
        " magnitude_of members new packing text texts turned"
    ),
    "_digits": "digits",
    "_end_framer": "EndFramer",
    "_error": (
        "CodecError no_boolean unknown_member wrong_bits wrong_const wrong_end wrong_length wrong_measure"
        " wrong_presence"
    ),
    "_escapes": "Add Cobs EscapeFramer EscapedFrames Insert Replace",
    "_filled": "Filled",
    "_flags": "BITS_OF Flags PresetFlags",
    "_framers": "CodeFramer Intervals LengthFramer",
    "_frames": "ExceptionResponse Frames Request RequestOf Response",
    "_inner_lists": "InnerList InnerLists Parts",
    "_list_parts": "Decision More Packing",
    "_mark_framer": "MarkFramer",
    "_parameters": "Parameter ParameterSet ParameterSpace Subindex no_message selected single",
    "_part_frames": "CountFramer PartFrames",
    "_quantities": "Conversion PowerUnit",
    "_reals": "Double Float Half",
    "_record": "Record",
    "_refusals": (
        "refused_bits refused_broadcast refused_bytes refused_code refused_double refused_flags refused_float"
        " refused_half refused_list refused_number refused_record refused_text unfit"
    ),
    "_registers": "Register RegisterArray Table find only replies spans unreachable writable",
    "_subcodes": "Answers Subcodes",
    "_texts": "FormedText text_form",
    "_values": "Boolean Bytes Closed Constant MarkedBytes Number Open Setting Text Trigger Word",
    "_widths": "Widths",
}
_CLIENT = {
    "_client": "Link Session link_named",
    "_client_async": "AsyncBaseClient AsyncMotion AsyncParameterClient AsyncRegisterClient",
    "_client_cyclic": "CyclicWork",
    "_client_registers": "Group ParameterAccess ParameterWork RegisterWork",
    "_client_sync": "BlockingClient Motion ParameterClient RegisterClient",
    "_client_tasks": "Condition DeviceWork Jog Target",
    "_segments": "Place Segments",
}
_CRC = [f"_C{place}" for place in range(8)]
_CRC_EXCHANGED = [f"_X{place}" for place in range(8)]
_TABLES = (
    (["_int_of"], "_int_of = int.from_bytes"),
    (_CRC, f"{', '.join(_CRC)} = _CRC"),
    (_CRC_EXCHANGED, f"{', '.join(_CRC_EXCHANGED)} = _CRC_EXCHANGED"),
)
