"""What outputs refuse that are not for controllers, in the words of their documentation."""

from __future__ import annotations

RULES = {
    "output_numbers_binary": """Every number is binary on the wire, in dissectors, queries and word maps.

Why: these outputs do not convert digits, so they would take the characters for a number.

Example: a field with `type: u16, digits: decimal, length: 5`.

Cure: Do without what is left out, or state the digits as a text.
""",
    "wireshark_parameters_typed": """The value of a parameter is a number or a text where a dissector shows it.

Why: the dissector reads the value of a parameter in the type of its field. Bytes whose number another field says have
none.

Example: `{name: data, type: bytes, length: 4, parameter: {set: objects, part: value, number: index}}`.

Cure: Do without what is left out, or state the type of the field.
""",
    "output_addresses_constant": """Every record table begins at a constant address, in dissectors, queries, word maps
and exported lists.

Why: these outputs have the addresses of all elements as constants, which are wrong where a register of the device says
that the table begins elsewhere.

Example: a table with `base: 0x1000, base_by: log_address`.

Cure: Do without what is left out. Python, JavaScript and C take the address that the device says.
""",
    "output_texts_ascii": """Every text is ASCII of one length, padded with zeros, in dissectors, queries
and word maps.

Why: these outputs do not convert encodings, so they would show other characters, or spaces that are not part of a text.

Example: a field with `type: text, length: 8, padding: space`.

Cure: Do without what is left out, or state the text as `bytes`.
""",
    "output_lists_last": """In dissectors, queries and word maps, a list of free length comes last in its message, and
its elements have one size.

Why: after such a list, and in a list whose elements differ in size, the offset of a field differs from frame to
frame, and these outputs state one place.

Example: `values` with `repeat: 0..8`, counted by a field before it, with a `status` after it.

Cure: Do without what is left out, or use another output.
""",
    "output_frames_words": """The frames of a link are the bytes of their parts, between the delimiters, in word maps.

Why: the map says which byte of a frame each value is. Where bytes are escaped, are two characters each, come after a
preamble of varying length or are in the identifier of a CAN frame, a program that fills the words and sends them sends
wrong bytes.

Example: a link with `escape: {method: slip}`.

Cure: Do without the frames, or use another output: Python, JavaScript and C escape and unescape.
""",
    "output_registers_words": """Every register has words of its own, in word maps.

Why: several registers of bits or bytes share a word, and which ones depends on the request that reads them. A register
whose words are read in one order and written in the other has two places for each of its bits.

Example: the control table of a servo, in a space with `unit: byte`.

Cure: Do without the registers; the map has the bytes of the messages that read and write them.
""",
    "wireshark_frames_unescaped": """The frames that a dissector shows have the bytes that are sent.

Why: the dissector does not undo escapes, so it would show other values than the frame has.

Example: a link with `escape: {method: slip}`.

Cure: Exclude the output for the device (`--to`).
""",
}
