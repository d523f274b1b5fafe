"""A printed identifier whose words are joined by underscores has no blank in it.

Why: in a narrow column, identifiers are broken, and a blank stays where they were. Whoever looks for the name
does not find it.

Example: `printed_name: TARGET_SPEE D`

Cure: Write the name in one piece, and an erratum with the printed one.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import facts
from fieldspec.checks.finding import finding
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device


def printed_names_whole(device: Device) -> Iterator[Diagnostic]:
    for fact in facts(device):
        if "_" in fact.printed_name and len(fact.printed_name.split()) > 1:
            text = f"the printed name `{fact.printed_name}` has a blank in it"
            help = "write it in one piece, or allow it with a reason"
            yield finding("printed_names_whole", fact.place, "printed_name", text, help)
