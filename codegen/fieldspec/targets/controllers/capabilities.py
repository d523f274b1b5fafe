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
    "formed_texts": "texts in other encodings than ASCII, and with a padding, an end or a byte order of their own",
    "text_lists": "lists of texts",
    "closed_enums": "closed enums",
    "open_enums": "open enums",
    "aliases": "values of enums with several names",
    "flags": "words of flags",
    "bit_fields": "fields of several bits",
    "bit_numbers": "fields of several bits with a sign or a scale",
    "records": "records, and records in records",
    "lists": "lists with a fixed number of elements",
    "inner_lists": "lists of free length and choices that fields follow, and records that differ in size",
    "choices": "fields whose type another field decides",
    "groups": "groups of registers",
    "bits": "registers of single bits",
    "byte_registers": "registers in spaces of bytes",
    "tables": "tables of records in registers",
    "moving_tables": "tables of records that begin where a register says",
    "pieces": "values of parameters that are read and written in pieces",
    "frames": "frames: head, length, check, refusals",
    "hex_frames": "frames whose bytes are sent as two characters",
    "escaped_frames": "frames with escapes",
    "other_frames": "frames with several checksums, or others than CRC-8, CRC-16, and sums and xors of 8 bits",
    "can_frames": "frames of CAN buses",
    "telegrams": "process data of telegrams, as values",
    "aligned_images": "process data whose words begin at even bytes, as a struct laid over the bytes",
    "images": "process data whose words begin at odd bytes, as a struct laid over the bytes",
    "orders": "byte and word orders",
    "scales": "scales, offsets and units",
    "powers": "scales that are read from another register or field",
    "conversions": "shares of a reference",
    "ranges": "ranges, sentinels and constants",
    "told_ranges": "numbers that are read outside of their range, distinguished from others",
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
            "become two numbers of 32 bits, whose scale and range programs must apply to both"
        )
        capabilities["wide_lists"] = refused("the halves of an element cannot be adjacent: plc_numbers_fit")
        capabilities["odd_numbers"] = adapted("numbers of 24 bits are exact; wider ones are refused: plc_numbers_fit")
        capabilities["magnitudes"] = adapted("up to 32 bits are exact; wider numbers are refused: plc_numbers_fit")
    capabilities["digits"] = refused("there are no functions that convert them: plc_numbers_binary")
    capabilities["inner_lists"] = refused("no functions find the fields after them: plc_lists_last")
    capabilities["formed_texts"] = refused("there are no functions that convert them: plc_texts_ascii")
    if not dialect.nested_arrays:
        capabilities["text_lists"] = refused("there are no arrays of arrays: plc_arrays_flat")
    if not dialect.enums:
        capabilities["closed_enums"] = adapted(
            "are numbers with constants; the functions refuse numbers that are not listed"
        )
    capabilities["open_enums"] = adapted("are numbers with constants, because a variable of an enum holds nothing else")
    capabilities["aliases"] = adapted("have the name to write; the others are in its comment")
    capabilities["floats"] = adapted("infinity and NaN are refused, because comparing them differs between controllers")
    capabilities["half_floats"] = adapted("are numbers of 32 bits; infinity and NaN are refused")
    capabilities["wide_floats"] = refused("the functions do not convert their bits: plc_reals_fit")
    capabilities["absent_reals"] = refused("a function would refuse the whole message: plc_reals_present")
    capabilities["can_frames"] = refused("there are no functions for them: plc_frames_supported")
    capabilities["escaped_frames"] = refused("there are no functions for them: plc_frames_supported")
    capabilities["other_frames"] = refused("there are no functions for them: plc_frames_supported")
    capabilities["byte_registers"] = refused("there are no functions for them: plc_spaces_supported")
    capabilities["moving_tables"] = refused("the addresses of elements are constants: plc_addresses_constant")
    capabilities["pieces"] = refused("nothing puts the pieces together: plc_values_whole")
    capabilities["choices"] = adapted(
        "are bit strings as wide as the widest type, with a function that returns the type; programs that convert them "
        "to a number compare it with the ranges and the enum"
    )
    capabilities["bit_numbers"] = adapted("are masks with the sign and the scale in a comment")
    capabilities["told_ranges"] = adapted("are numbers; programs compare them with the constants of the range")
    capabilities["powers"] = adapted("are counts, with the name of the exponent in a comment")
    if dialect.bits == "packed":
        capabilities["bit_fields"] = adapted("are masks and single bits in images, because a BOOL is one bit")
        capabilities["images"] = refused("a gap would move every value after it: plc_images_exact")
    else:
        capabilities["flags"] = adapted("are words with masks, because a BOOL is a byte there")
        capabilities["images"] = capabilities["aligned_images"] = adapted(
            "have the bytes of the wire; numbers are read through functions, which turn them"
        )
    if not dialect.packs:
        capabilities["images"] = capabilities["aligned_images"] = adapted(
            "are bytes, which functions make values of: the standard does not say how a struct lies in memory"
        )
    if not dialect.texts:
        capabilities["code_texts"] = refused("are lists of structs with values, which constants cannot be there")
    elif not dialect.wide_texts:
        capabilities["code_texts"] = adapted("have ASCII alone, and at most 254 characters")
    capabilities["remedies"] = refused("are texts for people: see the output for operator panels")
    capabilities["labels"] = adapted("are comments")
    if dialect.foreign:
        capabilities["records"] = capabilities["closed_enums"] = capabilities["constants"] = adapted(dialect.foreign)
    return {name: capabilities.get(name, Capability(EXACT)) for name in CONSTRUCTS}
