"""Somebody has compared every fact with the manual. A fact that is `unverified` is a warning, and stops nothing.

Why: what is taken from a list that someone else has made may be wrong in every number, and nothing shows it.

Example: a register that `fieldspec import` has written, with `unverified: true`.

Cure: Compare the fact with the manual, give the manual's section and line as its source, and take the key away.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import facts
from fieldspec.checks.finding import enumeration, finding
from fieldspec.diagnostics import Diagnostic, Severity
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact


def facts_verified(device: Device) -> Iterator[Diagnostic]:
    sections: dict[str, list[Fact]] = {}
    for fact in facts(device):
        if fact.unverified:
            sections.setdefault(fact.place.path.partition("/")[0], []).append(fact)
    for section, unverified in sections.items():
        names = enumeration([fact.name for fact in unverified])
        text = f"nobody has compared {names} of `{section}` with the manual"
        help = "compare, cite the manual, and take `unverified` away"
        yield finding("facts_verified", unverified[0].place, "unverified", text, help, severity=Severity.WARNING)
