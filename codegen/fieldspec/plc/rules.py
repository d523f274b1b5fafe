"""What outputs for programmable controllers refuse, in the words of their documentation."""

from __future__ import annotations

RULES = {
    "plc_arrays_flat": """What is a list of texts has a type in every dialect that is built.

Why: a text is an array of bytes there, and TIA Portal has no arrays of arrays.

Example: a field with `type: text, length: 8, count: 4`.

Cure: Leave the output out for the device (`--to`), or state the texts as a record with one text that is counted.
""",
    "plc_images_exact": """A struct laid over process data has its members where the wire has them, and no byte more.

Why: compilers fill up gaps so that numbers are aligned; every value behind a gap would be another one.

Example: a telegram with a byte before a word, for a controller that begins words at even bytes.

Cure: Use the functions that convert bytes, and leave the output out for the device (`--to`).
""",
    "plc_names_distinct": """Two names of a device differ in every dialect that is built.

Why: capital letters and underscores make no difference there, so that one declaration would replace the other.

Example: the enums `axis_1` and `axis1`, which both become E_Gadget_Axis1.

Cure: Give one of them another name.
""",
    "plc_names_fit": """Every name is an identifier of the dialect, and no longer than one may be.

Why: an engineering tool refuses such a name only when it compiles, long after the import.

Example: a message whose name has 130 characters.

Cure: Give it a shorter name.
""",
    "plc_numbers_fit": """Every number is one that the dialect has, or can be split into two that it has.

Why: an S7-1200 has no whole numbers of 64 bits. Single ones are split, lists of them cannot be.

Example: a field with `type: u64, count: 4`.

Cure: Leave the output out for the device (`--to`), or state the numbers as fields of their own.
""",
    "plc_reals_present": """No sentinel of a floating-point number is a NaN.

Why: comparing a NaN differs between controllers, so the functions refuse every one, and a value that is absent would
refuse the whole message.

Example: `sentinels: [{bits: 0x7FC00000, name: not_measured}]` on an `f32`.

Cure: Leave the output out for the device (`--to`), or state the value as a `u32` of bits.
""",
    "plc_telegrams_fit": """The process data of a telegram fits a frame of the fieldbus.

Why: no engineering tool can configure more, so that the types could not be used.

Example: a telegram of 2000 bytes.

Cure: Put the sizes of the fields right.
""",
}
