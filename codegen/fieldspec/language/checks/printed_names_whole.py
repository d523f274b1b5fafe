"""A printed identifier with underscores contains no space.

Why: narrow columns break identifiers and leave a space at the break. A search for the name then fails.

Example: `printed_name: TARGET_SPEE D`

Fix: Write the name without the space, and an erratum with the printed name.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, finding
from fieldspec.language.model.device import Device


def printed_names_whole(device: Device) -> Findings:
    for fact in facts(device):
        if "_" in fact.printed_name and len(fact.printed_name.split()) > 1:
            text = f"the printed name `{fact.printed_name}` contains a space"
            help = "write it without the space, or allow it with a reason"
            yield finding(fact.place, "printed_name", text, help)
