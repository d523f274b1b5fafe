"""What the rules of proofs say, in the words of their documentation: what holds, why, an example, the cure."""

from __future__ import annotations

RULES = {
    "accepts_used": """Every change that a spec accepts is one that the comparison finds.

Why: an acceptance that is not needed any more hides the next slip at the same place.

Example: `accepts: [{rule: range_narrowed, path: registers/speed, ...}]` where the range of the speed is what it was.

Cure: Put the rule or the path right as `fieldspec diff` shows them, or remove the entry.
""",
    "characters_match_bytes": """The row of characters above an example's bytes is what the bytes read as.

Why: the manual prints an ASCII frame twice, as characters and as bytes. Where they differ, one row is misprinted.

Example: `characters: ":0106"` above `3A 30 31 30 33`.

Cure: Put the row right that is misprinted, and write an erratum.
""",
    "check_code_correct": """The check of every example is right.

Why: a frame with a wrong check is refused by the device; either the check or a byte before it is misprinted.

Example: a packet that ends with 17h where the bytes before add up to 37h.

Cure: Give the right bytes as `frame`, and an erratum with the printed ones.
""",
    "errata_differ": """What an erratum calls printed differs from what the spec says.

Why: an erratum that puts nothing right is left over, or the spec holds the misprint.

Example: an erratum with `printed: {range: 0..100}` for a fact whose range is 0..100.

Cure: Use the right value in the spec, or remove the erratum.
""",
    "errata_paths_resolve": """The path of an erratum leads to a fact.

Why: an erratum about nothing corrects nothing.

Example: `fact: registers/servo_off` where the register is called servo.

Cure: Put the path right; `fieldspec facts` lists them.
""",
    "errata_proven": """With the printed value put back, the check that an erratum names fails.

Why: that is the proof that the print is wrong, and that somebody would notice it again.

Example: `proof: addresses_disjoint` for an address that overlaps nothing.

Cure: Name the check that fails, or say `judgement`.
""",
    "length_byte_correct": """The length in every example is the number of its bytes.

Why: a frame whose length is wrong is never complete, or swallows the next one; a byte is missing, or one too many.

Example: 19 bytes that begin with 14h.

Cure: Where the manual misprints the bytes, give the right ones as `frame`, and an erratum with the printed ones. Where
the checksum is right, or all examples differ in one way, put right what the link's length `counts`. If no `counts` says
it, take the role `length` away: users then give the number.
""",
    "lines_alike": """Each version of a line that is like another one is on the wire as a version of that line.

Why: it shares the outputs of that version; where they differ on the wire, its users would get wrong code.

Example: `like: firmware_2` where 3.12.5 has a parameter that no version of line 2 has.

Cure: Give the facts the bounds of both lines, or let the line have outputs of its own: `builds: true`.
""",
    "meaning_matches_bytes": """The values of every example are what its bytes mean, in both directions.

Why: the manual's own frames are the only proof that a spec is right.

Example: `distance: 20.00 mm` beside bytes that hold 2 mm.

Cure: Put the bytes, the values or the fields right; write an erratum for what is misprinted.
""",
}
