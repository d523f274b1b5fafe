"""The documentation of the rules of proofs: what holds, why, an example, the fix."""

from __future__ import annotations

RULES = {
    "accepts_used": """The comparison finds every change that a spec accepts.

Why: an acceptance that is no longer needed hides the next mistake at the same place.

Example: `accepts: [{rule: range_narrowed, path: registers/speed, ...}]` where the range of the speed has not
changed.

Fix: Correct the rule or the path as shown by `fieldspec diff`, or remove the entry.
""",
    "characters_match_bytes": """The printed characters of an example match its bytes.

Why: the manual prints an ASCII frame twice, as characters and as bytes. If they differ, one row is
misprinted.

Example: `characters: ":0106"` above `3A 30 31 30 33`.

Fix: Correct the misprinted row, and write an erratum.
""",
    "checksum_correct": """The checksum of every example is correct.

Why: a device rejects a frame with a wrong checksum. Either the checksum or a byte before it is misprinted.

Example: a packet that ends with 17h, where the sum of the bytes before it is 37h.

Fix: State the right bytes as `frame`, and write an erratum with the printed bytes.
""",
    "codec_exemplified": """At least three printed frames use each codec of a package.

Why: the language does not describe the bytes, so no other rule proves that the device uses this codec.

Example: a field with `codec: acme_float` in a message with one example.

Fix: Add the frames that the manual prints, or frames from a log of a device, as `examples` with their values.
""",
    "errata_differ": """The printed value in an erratum differs from the value in the spec.

Why: an erratum that corrects nothing is obsolete, or the spec contains the misprint.

Example: an erratum with `printed: {range: 0..100}` for a fact whose range is 0..100.

Fix: Use the right value in the spec, or remove the erratum.
""",
    "errata_paths_resolve": """The path of an erratum names an existing fact.

Why: an erratum without its fact corrects nothing.

Example: `fact: registers/servo_off` where the register has the name servo.

Fix: Correct the path; `fieldspec facts` lists all paths.
""",
    "errata_proven": """If the printed value replaces the correct one, the spec breaks the rule that the
erratum names.

Why: this proves that the printed value is wrong, and that the same mistake would be detected again.

Example: `proof: addresses_disjoint` for an address that overlaps nothing.

Fix: Name the rule that the printed value breaks, or use `judgement`.
""",
    "length_byte_correct": """The length in every example is the number of bytes that it counts.

Why: a frame with a wrong length is never complete, or it swallows the next frame. A byte is missing or superfluous.

Example: a frame of 19 bytes whose length is 14h.

Fix: If the manual misprints the bytes, state the right bytes as `frame`, and write an erratum with the printed bytes.
If the checksum is correct, or all examples differ in the same way, correct the `measures` of the link. If no `measures`
can express it, remove the role `length`; users then supply the number.
""",
    "lines_alike": """If a line is `like` a parallel line, each of its versions equals a version of the parallel line on
the wire.

Why: the two versions share outputs; if they differed on the wire, users would get wrong code.

Example: `like: firmware_2` where 3.12.5 has a parameter that no version of line 2 has.

Fix: Give the facts the bounds of both lines, or build separate outputs for the line: `builds: true`.
""",
    "meaning_matches_bytes": """The values of every example encode to its bytes, and its bytes decode to the
values.

Why: the frames in the manual prove the spec against the device.

Example: `distance: 20.00 mm` with bytes that mean 2 mm.

Fix: Correct the bytes, the values or the fields, and write an erratum for the misprint.
""",
}
