"""What the rules of audits say, in the words of their documentation: what holds, why, an example, the cure."""

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
