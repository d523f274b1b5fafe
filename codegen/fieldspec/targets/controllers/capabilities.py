"""What outputs for engineering tools can express of a device: exactly, with a loss, or not at all."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import dataclass
from fieldspec.targets.controllers.dialects import Dialect

EXACT, ADAPTED, REFUSED = "exact", "adapted", "refused"

CONSTRUCTS = {
    "numbers": "whole numbers up to 32 bits",
    "wide_numbers": "whole numbers of 64 bits",
    "wide_lists": "lists of whole numbers of 64 bits",
    "odd_numbers": "whole numbers of 24, 40, 48 and 56 bits",
    "magnitudes": "whole numbers with a sign and a magnitude",
    "digits": "whole numbers that are sent as digits",
    "floats": "floating-point numbers of 32 bits",
    "half_floats": "floating-point numbers of 16 bits",
    "wide_floats": "floating-point numbers of 64 bits",
    "absent_reals": "sentinels of floating-point numbers that are NaN",
    "booleans": "booleans",
    "texts": "texts and bytes",
    "formed_texts": "texts that are not ASCII, or with a special padding, terminator or byte order",
    "text_lists": "lists of texts",
    "closed_enums": "closed enums",
    "open_enums": "open enums",
    "aliases": "enum values with several names",
    "flags": "bit fields",
    "bit_fields": "groups of several bits",
    "bit_numbers": "groups of several bits with a sign or a scale",
    "records": "records, also nested",
    "lists": "lists with a fixed number of elements",
    "inner_lists": "lists of varying length and choices before other fields, records of varying size, optional fields,"
    " counts in bits, lists that tell their end",
    "choices": "fields whose type a different field selects",
    "groups": "register groups",
    "bits": "registers of single bits",
    "byte_registers": "registers in spaces of bytes",
    "tables": "record tables in registers",
    "moving_tables": "record tables whose address is in a register",
    "pieces": "parameter values that are transferred in segments",
    "frames": "frames: header, length, checksum, exception responses",
    "hex_frames": "frames whose bytes are sent as two characters",
    "escaped_frames": "frames with escapes",
    "other_frames": "frames with several checksums, with parts of some bits, or with a checksum other than CRC-8, "
    "CRC-16, 8-bit sum or xor",
    "can_frames": "frames of CAN buses",
    "telegrams": "process data of telegrams, as values",
    "aligned_images": "process data with words at even offsets, as a struct that overlays the bytes",
    "images": "process data with words at odd offsets, as a struct that overlays the bytes",
    "orders": "byte and word orders",
    "scales": "scales, offsets and units",
    "powers": "scales that are read from a different register or field",
    "conversions": "fractions of a reference",
    "ranges": "ranges, sentinels and constants",
    "told_ranges": "a mark for received numbers outside their range",
    "constants": "addresses, codes, masks and limits as constants",
    "code_texts": "texts of codes",
    "remedies": "causes and remedies of codes",
    "labels": "labels in the manual's language",
}
"""The constructs of a device, and their names in the matrix."""


@dataclass(frozen=True, slots=True)
class Capability:
    """How far an output expresses a construct, and why not further."""

    level: str
    reason: str = ""


def adapted(reason: str) -> Capability:
    """A capability whose construct the output has in another form."""
    return Capability(ADAPTED, reason)


def refused(reason: str) -> Capability:
    """A capability whose construct the output refuses."""
    return Capability(REFUSED, reason)


def of_dialect(dialect: Dialect) -> Mapping[str, Capability]:
    """The capabilities of a dialect, as its row of facts says; what is not named is exact."""
    capabilities: dict[str, Capability] = {}
    if dialect.widest < 8:
        capabilities["wide_numbers"] = adapted(
            "each is two 32-bit numbers; programs must apply scale and range to the whole number"
        )
        capabilities["wide_lists"] = refused("the two halves of an element cannot be adjacent: plc_numbers_fit")
        capabilities["odd_numbers"] = adapted("24 bits are exact, wider numbers are refused: plc_numbers_fit")
        capabilities["magnitudes"] = adapted("up to 32 bits are exact, wider numbers are refused: plc_numbers_fit")
    capabilities["digits"] = refused("the functions do not convert digits: plc_numbers_binary")
    capabilities["inner_lists"] = refused("the functions cannot locate the fields after a list: plc_lists_last")
    capabilities["formed_texts"] = refused("the functions do not convert such texts: plc_texts_ascii")
    if not dialect.nested_arrays:
        capabilities["text_lists"] = refused("arrays of arrays are not supported: plc_arrays_flat")
    if not dialect.enums:
        capabilities["closed_enums"] = adapted("numbers with named constants; the functions reject unlisted numbers")
    capabilities["open_enums"] = adapted(
        "numbers with named constants, because an enum variable holds only listed numbers"
    )
    capabilities["aliases"] = adapted("the main name; its comment lists the other names")
    capabilities["floats"] = adapted("infinity and NaN are rejected, because controllers compare them differently")
    capabilities["half_floats"] = adapted("32-bit numbers; infinity and NaN are rejected")
    capabilities["wide_floats"] = refused("the functions do not convert 64-bit floating-point numbers: plc_reals_fit")
    capabilities["absent_reals"] = refused(
        "one missing value would make a function reject the whole message: plc_reals_present"
    )
    for frames in ("can_frames", "escaped_frames", "other_frames"):
        capabilities[frames] = refused("the functions do not support such frames: plc_frames_supported")
    capabilities["byte_registers"] = refused("the functions do not support byte addresses: plc_spaces_supported")
    capabilities["moving_tables"] = refused(
        "the functions contain element addresses as constants: plc_addresses_constant"
    )
    capabilities["pieces"] = refused("the functions do not reassemble segments: plc_values_whole")
    capabilities["choices"] = adapted(
        "bit strings as wide as the widest type, with a function that returns the type; programs that convert them to "
        "numbers must check the ranges and the enum"
    )
    capabilities["bit_numbers"] = adapted("masks, with the sign and the scale in a comment")
    capabilities["told_ranges"] = adapted("no mark; programs compare the number with the constants of the range")
    capabilities["powers"] = adapted("raw values, with the name of the exponent in a comment")
    if dialect.bits == "packed":
        capabilities["bit_fields"] = adapted(
            "masks, or single bits in a struct over the bytes, where a BOOL is one bit"
        )
        capabilities["images"] = refused(
            "the compiler inserts a gap, which moves the following values: plc_images_exact"
        )
    else:
        capabilities["flags"] = adapted("words with masks, because a BOOL occupies a byte")
        capabilities["images"] = capabilities["aligned_images"] = adapted(
            "the bytes in wire order; functions convert the byte order of numbers"
        )
    if not dialect.packs:
        capabilities["images"] = capabilities["aligned_images"] = adapted(
            "bytes, which functions convert to values: the standard does not define the memory layout of a struct"
        )
    if not dialect.texts:
        capabilities["code_texts"] = refused("they are lists of structs, which cannot be constants in this dialect")
    elif not dialect.wide_texts:
        capabilities["code_texts"] = adapted("only ASCII, at most 254 characters")
    capabilities["remedies"] = refused("see the output for operator panels")
    capabilities["labels"] = adapted("comments")
    if dialect.foreign:
        capabilities["records"] = capabilities["closed_enums"] = capabilities["constants"] = adapted(dialect.foreign)
    return {name: capabilities.get(name, Capability(EXACT)) for name in CONSTRUCTS}
