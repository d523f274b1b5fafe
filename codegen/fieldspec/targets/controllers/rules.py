"""What outputs for programmable controllers refuse, in the words of their documentation."""

from __future__ import annotations

RULES = {
    "plc_arrays_flat": """Every dialect that is built has a type for each list of texts.

Why: in these dialects a text is an array of bytes, and TIA Portal does not support arrays of arrays.

Example: a field with `type: text, length: 8, count: 4`.

Fix: Do without the omitted facts, or state the list as a record with one text and a `count`.
""",
    "plc_frames_supported": """The PLC functions can build and check every frame of the device.

Why: a PLC that cannot compute a checksum can neither send nor accept a frame.

Example: a link whose frames end with `algorithm: crc32_iso_hdlc`.

Fix: Exclude the output for the device (`--to`).
""",
    "plc_spaces_supported": """The PLC functions convert the registers of address spaces of words and of bits.

Why: a program that reads bytes as words would read every second value from the wrong address.

Example: the control table of a servo, in an address space with `unit: byte`.

Fix: Exclude the output for the device (`--to`).
""",
    "plc_images_exact": """A struct that overlays process data has its members at the offsets of the wire, and
no extra bytes.

Why: compilers insert padding to align numbers, and every value after the padding would be wrong.

Example: a telegram with a byte before a word, for a PLC that aligns words to even bytes.

Fix: Use the functions that convert bytes.
""",
    "plc_names_distinct": """Any two names of a device remain distinct in every dialect that is built.

Why: some dialects ignore case and underscores, so one declaration would replace the other.

Example: the enums `axis_1` and `axis1`, which both become E_Gadget_Axis1.

Fix: Rename one of them.
""",
    "plc_names_fit": """Every name is a valid identifier of the dialect and not too long.

Why: an engineering tool reports such a name only when it compiles, long after the import.

Example: a message with a name of 130 characters.

Fix: Use a shorter name.
""",
    "plc_numbers_fit": """The dialect has a type for every number, or can split the number into two.

Why: an S7-1200 has no 64-bit integers. A single 64-bit integer can be split, but not a list of them, an integer of 40,
48 or 56 bits, or an integer in sign and magnitude.

Example: a field with `type: u64, count: 4`.

Fix: Do without the omitted facts, or state the numbers as separate fields.
""",
    "plc_enums_fit": """All numbers of an enum fit one type, and so do all codes that have texts.

Why: a member is compared with the number on the wire in one type, and lists of texts have their codes in one column.

Example: an enum with -1 and 0x8000000000000000.

Fix: Exclude the output for the device (`--to`), or state two enums.
""",
    "plc_numbers_binary": """Every number is binary on the wire.

Why: the PLC functions do not convert digits, so the characters would be read as a number.

Example: a field with `type: u16, digits: decimal, length: 5`.

Fix: Do without the omitted facts, or state the digits as a text.
""",
    "plc_texts_ascii": """Every text is ASCII of one length, padded with zeros.

Why: the PLC functions copy the bytes of a text, so other encodings, spaces and terminators would be read as characters
of the text.

Example: a field with `type: text, length: 8, padding: space`.

Fix: Do without the omitted facts, or state the text as `bytes`.
""",
    "plc_lists_last": """A list of free length, or a choice, comes last in its message, and elements have one size. No
field is optional, and no bits count a list or end it.

Why: after such a list or field, and in a list whose elements differ in size, the offset of a field differs from frame
to frame, and the PLC functions have one offset for each field.

Example: `values` with `repeat: 0..8`, counted by a field before it, with a `status` after it.

Fix: Do without the omitted facts, or use another output.
""",
    "plc_addresses_constant": """Every record table begins at a constant address.

Why: the PLC functions contain the addresses of all elements as constants, which are wrong if a register of the device
contains a different base address.

Example: a table with `base: 0x1000, base_by: log_address`.

Fix: Do without the omitted facts, or use Python, JavaScript or C, which use the address from the device.
""",
    "plc_values_whole": """No value of a parameter is read or written in segments.

Why: the PLC functions do not reassemble segments. Functions for only the messages would leave the transfer to untested
programs.

Example: a message with `segments: {message: upload_segment, when: [segments], data: data, unused: unused, last: last}`.

Fix: Do without the omitted facts. Python clients read and write such values.
""",
    "plc_reals_fit": """Floating-point numbers have 16 or 32 bits.

Why: the conversion between 64 bits and LREAL differs between dialects, and the functions do not implement it.

Example: a field with `type: f64`.

Fix: Do without the omitted facts, or state the number as a `u64` of bits.
""",
    "plc_reals_present": """No sentinel of a floating-point number is a NaN.

Why: PLCs compare NaN in different ways, so the functions reject every NaN. One missing value would then make the whole
message invalid.

Example: `sentinels: [{bits: 0x7FC00000, name: not_measured}]` on an `f32`.

Fix: Do without the omitted facts, or state the bits of the value as a `u32`, or as a `u16` for an `f16`.
""",
    "plc_telegrams_fit": """The process data of a telegram fits into a frame of the fieldbus.

Why: no engineering tool can configure more, so the types would be useless.

Example: a telegram of 2000 bytes.

Fix: Correct the sizes of the fields.
""",
}
