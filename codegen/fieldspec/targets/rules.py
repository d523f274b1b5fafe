"""What outputs refuse that are not for controllers, in the words of their documentation."""

from __future__ import annotations

RULES = {
    "output_numbers_binary": """Every number is binary on the wire, in dissectors, queries and word maps.

Why: these outputs do not convert digits, so they would read the characters as a number.

Example: a field with `type: u16, digits: decimal, length: 5`.

Fix: Do without the omitted facts, or state the digits as a text.
""",
    "output_has_codec": """The package that provides a codec contains its text for the output.

Why: the language does not describe the bytes, so an output can only contain the text from the package.

Example: a field with `codec: acme_float` whose package has Python and C, in JavaScript.

Fix: Do without the omitted facts, or add the text to the package. Outputs for controllers, dissectors, queries and word
maps print none.
""",
    "wireshark_parameters_typed": """The value of a parameter is a number or a text, for dissectors.

Why: the dissector reads the value of a parameter in the type of its field. A field of `bytes` has no such type.

Example: `{name: data, type: bytes, length: 4, parameter: {set: objects, part: value, number: index}}`.

Fix: Do without the omitted facts, or state the type of the field.
""",
    "output_addresses_constant": """Every record table begins at a constant address, in dissectors, queries, word maps
and exported lists.

Why: these outputs have the addresses of all elements as constants, which are wrong if a register of the device contains
a different base address.

Example: a table with `base: 0x1000, base_by: log_address`.

Fix: Do without the omitted facts, or use Python, JavaScript or C, which use the address from the device.
""",
    "output_texts_ascii": """Every text is ASCII of one length, padded with zeros, in dissectors, queries
and word maps.

Why: these outputs do not convert encodings, so they would show wrong characters or padding.

Example: a field with `type: text, length: 8, padding: space`.

Fix: Do without the omitted facts, or state the text as `bytes`.
""",
    "output_lists_last": """In dissectors, queries and word maps, a list of free length, or a choice, comes last in its
message, and elements have one size. No field is optional, and no bits count a list or end it.

Why: after such a list or field, and in a list whose elements differ in size, the offset of a field differs from frame
to frame, and these outputs state one offset.

Example: `values` with `repeat: 0..8`, counted by a field before it, with a `status` after it.

Fix: Do without the omitted facts, or use another output.
""",
    "output_frames_words": """The frames of a link are the bytes of their parts, between the delimiters, in word maps.

Why: the map states the byte offset of each value in a frame. If bytes are escaped, sent as two characters, sent after a
preamble of varying length or part of a CAN identifier, a program that fills the words and sends them would send wrong
bytes.

Example: a link with `escape: {method: slip}`.

Fix: Do without the frames, or use another output: Python, JavaScript and C escape and unescape.
""",
    "output_registers_words": """Every register occupies whole words, in word maps.

Why: several registers of bits or bytes share a word, and the request that reads them determines which registers. If the
words of a register are read in one order and written in the other, each of its bits has two positions.

Example: the control table of a servo, in an address space with `unit: byte`.

Fix: Do without the registers; the map contains the bytes of the messages that read and write them.
""",
    "wireshark_frames_unescaped": """The frames that a dissector shows contain the sent bytes unchanged.

Why: the dissector does not undo escapes, so it would show wrong values.

Example: a link with `escape: {method: slip}`.

Fix: Exclude the output for the device (`--to`).
""",
}
