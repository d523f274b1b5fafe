"""What outputs refuse that are not for controllers, in the words of their documentation."""

from __future__ import annotations

RULES = {
    "output_numbers_binary": """Every number is binary on the wire, in dissectors, queries and word maps.

Why: these outputs do not convert digits, so they would take the characters for a number.

Example: a field with `type: u16, digits: decimal, length: 5`.

Cure: Exclude the output for the device (`--to`), or state the digits as a text.
""",
    "query_scales_fixed": """Every quantity in a query has a scale that the spec states.

Why: a query decodes the words of one register. The exponent is in another one, and is missing where that was not read.

Example: a register with `scale_by: power_sf`.

Cure: Exclude the output for the device (`--to`), or state `scale` where the device always has the same exponent.
""",
    "wireshark_frames_unescaped": """The frames that a dissector shows have the bytes that are sent.

Why: the dissector does not undo escapes, so it would show other values than the frame has.

Example: a link with `escape: {method: slip}`.

Cure: Exclude the output for the device (`--to`).
""",
}
