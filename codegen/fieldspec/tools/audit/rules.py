"""The documentation of the rules of audits: what must hold, why, an example, and the fix."""

from __future__ import annotations

RULES = {
    "audit_sound": """The audit settings of a spec are valid, and all of them are needed.

Why: a pattern without matches, or an unused exception, hides the next mistake at the same place.

Example: `{like: "- {number} -", reason: Page numbers.}` for a manual without page numbers.

Fix: Correct the lines, the pattern or the paths, or remove the entry.
""",
    "citations_hold": """The lines that a fact cites contain its address, code or identifier, and the numbers of its
value: the ends of ranges, scales, defaults, counts. For a signed type, the lines print a type or a negative number,
unless the value itself has a negative number. The lines are in the section that the fact names.

Why: a citation of the wrong line cannot be verified, and often the fact is wrong too.

Example: a register 2011h whose source is a line with `2014 H`, or a range `0..1000` where the line has `0~100`.

Fix: Correct the section, the lines or the value. If the manual is wrong, write an erratum. If the manual only
implies the value, say why under `inferred`, or list the fact under `audit: unprinted` with the reason.
""",
    "dump_address_known": """Every address in a register dump is in the spec.

Why: an address that answers and is not in the spec is a register that the manual hides, or a mistake.

Example: a dump with a value at 2004h, which is missing from the register table.

Fix: Transcribe the register, use `--base` or `--offset` if the addresses of the dump are shifted, or remove
the address from the dump.
""",
    "dump_reserved_clear": """Reserved bits are 0, and reserved values have their initial values.

Why: if a device sets a reserved bit, it reports something that the manual does not describe.

Example: bit 9 of a status word is set, but the list of its bits ends with 7.

Fix: Find out the meaning of the bit or value and transcribe it, or report it to the manufacturer.
""",
    "dump_value_known": """Every value in a dump is known to the spec: a member of its enum, 0 or 1, or its
constant.

Why: different firmware or a misread table first shows in unexpected values.

Example: the mode register contains 5, but its enum has the values 0 to 3.

Fix: If the device is right, correct the spec, and write an erratum if the manual disagrees.
""",
    "dump_value_whole": """A dump contains all words of a value, and each address once.

Why: one word of a two-word value is not a value.

Example: a dump with 2000h but not 2001h, which together contain a position.

Fix: Read all words of the value in one request, and include them in the dump.
""",
    "dump_value_within_range": """Every value in a dump is within its range in the spec.

Why: if the device returns a value that the manual does not permit, one of the two is wrong.

Example: a percentage of 130 in a register with the range 0..100.

Fix: If the device is right, correct the range, and write an erratum if the manual disagrees.
""",
    "evidence_agrees": """Values from real devices agree with the spec.

Why: if the wire contradicts the spec, the manual, the spec or the device is wrong, and machines move by wrong values.

Example: a capture in which the speed is 130, with the range 0..100.

Fix: Decide who is right. Correct the spec, with an erratum if the manual is wrong, or report the device to the
manufacturer. If the baseline contains the contradiction, the finding is a warning.
""",
    "evidence_not_lost": """The present evidence shows everything that the baseline showed.

Why: a fact whose only capture was deleted, or that the spec now states elsewhere, is supported only by the manual.

Example: the baseline has `observed` for a register, and the file that showed it is missing.

Fix: Bring back the files, or record the table `evidence` again as the baseline.
""",
    "evidence_notes_complete": """The note of a tested device identifies its model and firmware, but contains no serial
number.

Why: evidence counts for a model and a firmware; a serial number identifies the owner.

Example: a `unit.yaml` without `firmware`.

Fix: Write `model`, `firmware` and `serial_number: redacted`; `unit_address` and `remarks` are optional.
""",
    "manual_accounted": """Everything in the manual that looks like a fact is in the spec, is covered by an
erratum, or is deliberately left out.

Why: a fact that was not transcribed is missing from every output, and no other rule would notice.

Example: a row of the register table in the manual that no register of the spec cites.

Fix: Transcribe it, write an erratum, or state under `audit: left_out` why the spec does not need it.
""",
    "manual_recorded": """The index of the manual is next to the spec and belongs to the text that the spec
cites.

Why: the manual cannot be in the repository, and only its index allows others to repeat the audit.

Example: `manual.index` with the hash of an older edition.

Fix: Run `fieldspec audit DEVICE --manual FILE --record`.
""",
    "statements_accounted": """Every line of the manual with words is left out with a reason, or is cited by an entry of
the behaviour, or states facts but no behaviour. The rule applies only to specs with `audit: without_behaviour`.

Why: a sentence about behaviour contains no number, so no pattern finds it, and a simulator that does not implement it
gives no warning.

Example: a line of the manual says that an input stops the motor, and no entry of `behaviour` cites it.

Fix: Write the entry, or `unmodelled` with its reason; or list the line under `audit: without_behaviour` if facts cover
all of it, or under `left_out`.
""",
    "reviews_sound": """Every review names sections that facts cite, a valid date, and the current state of
its facts.

Why: a review that was edited by hand claims a comparison that was not made.

Example: `section: "8.22"` where facts cite 8.2, or a `state` copied from another section.

Fix: Remove the entry, compare the section, and record it with `fieldspec audit DEVICE --sign SECTION --by NAME`.
""",
}
