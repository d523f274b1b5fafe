"""Every fact has been compared with the manual. A fact with `unverified` is a warning and does not fail the
check.

Why: a list from another source may contain wrong numbers, and nothing in the list shows it.

Example: a register written by `fieldspec import`, with `unverified: true`.

Fix: Compare the fact with the manual, state the section and the line of the manual as its source, and remove
the key.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, enumeration, finding
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact


def facts_verified(device: Device) -> Findings:
    sections: dict[str, list[Fact]] = {}
    for fact in facts(device):
        if fact.unverified:
            sections.setdefault(fact.place.path.partition("/")[0], []).append(fact)
    for section, unverified in sections.items():
        names = enumeration([fact.name for fact in unverified])
        text = f"not compared with the manual: {names} of `{section}`"
        help = "compare them, cite the manual, and remove `unverified`"
        yield finding(unverified[0].place, "unverified", text, help, severity=Severity.WARNING)
