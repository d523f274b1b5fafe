"""The documentation of the rules of audits: what must hold, why, an example, and the cure."""

from __future__ import annotations

RULES = {
    "audit_sound": """How the spec says that an audit reads the manual can be understood, and all of it is needed.

Why: a pattern that finds nothing, or an exception that nothing needs, hides the next slip at the same place.

Example: `{like: "- {number} -", reason: Page numbers.}` for a manual without page numbers.

Cure: Put the lines, the form or the paths right, or remove the entry.
""",
    "citations_hold": """The lines that a fact cites hold its address, code or identifier, in the section that it names.

Why: a citation that leads to another line cannot be checked by anybody, and often the fact is wrong, too.

Example: a register 2011h whose source is a line that prints `2014 H`.

Cure: Put the section, the lines or the value right; where the print is wrong, write an erratum; where the fact only
follows from the line, list it under `audit: unprinted` with the reason.
""",
    "dump_address_known": """Every address of a dump is one that the spec knows.

Why: what a device answers at an address that nobody has transcribed is a register that the manual hides, or a slip.

Example: a dump with a value at 2004h, which the table of registers leaves out.

Cure: Transcribe it, say `--base` or `--offset` where the dump counts otherwise, or leave it out of the dump.
""",
    "dump_reserved_clear": """Reserved bits are 0, reserved values the initial ones.

Why: a device that sets what the manual calls reserved says something that the manual does not tell.

Example: bit 9 of a status word is set, and the list of its bits ends with 7.

Cure: Find out what it means, and transcribe it; or report it to the maker.
""",
    "dump_value_known": """Every value that was read is known to the spec: a member of its enum, 0 or 1, its constant.

Why: a device of another firmware, or a misread table, shows first in values that should not be there.

Example: the register of the mode holds 5, and its enum goes from 0 to 3.

Cure: Where the device is right, put the spec right, with an erratum if the manual has it otherwise.
""",
    "dump_value_whole": """A dump has all words of a value, and each address once.

Why: half of a value of two words is no value.

Example: a dump with 2000h and without 2001h, which together hold a position.

Cure: Read all words of the value in one request, and dump them.
""",
    "dump_value_within_range": """Every value that was read lies in the range that the spec has for it.

Why: a value that the manual does not allow and the device holds means that one of the two is wrong.

Example: a percentage of 130 in a register with the range 0 to 100.

Cure: Where the device is right, put the range right, with an erratum if the manual has it otherwise.
""",
    "manual_accounted": """Whatever in the manual looks like a fact is in the spec, corrected, or left out on purpose.

Why: what nobody has transcribed is missing in every output, and nothing else would ever notice it.

Example: a row of the manual's table of registers that no register of the spec cites.

Cure: Transcribe it, put it right with an erratum, or say under `audit: left_out` why the spec does not need it.
""",
    "manual_recorded": """The index of the manual stands beside the spec, and is that of the text which the spec cites.

Why: the manual cannot be in the repository; without its index nobody else can repeat the audit.

Example: `manual.index` with the hash of an older edition.

Cure: `fieldspec audit DEVICE --manual FILE --record`.
""",
    "reviews_sound": """Every review names sections that facts cite, a day that there is, and the state of its facts.

Why: a review that was edited by hand says that somebody has compared what nobody has.

Example: `section: "8.22"` where facts cite 8.2, or `state` copied from another section.

Cure: Remove the entry, compare the section, and record it with `fieldspec audit DEVICE --sign SECTION --by NAME`.
""",
}
