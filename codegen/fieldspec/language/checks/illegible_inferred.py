"""A value that the spec states for an empty or garbled place of the manual is inferred, with a reason.

Why: if nothing is legible, the value is our own interpretation. Without `inferred` it looks as if it were
printed.

Example: an erratum with `illegible: garbled` about a member whose `doc` has no entry under `inferred`.

Fix: Add a reason under `inferred` for the key that was interpreted, or remove the value from the fact.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact


def illegible_inferred(device: Device) -> Findings:
    illegible = [erratum for erratum in device.errata if erratum.illegible]
    if not illegible:
        return
    by_path = {fact.place.path: fact for fact in facts(device)}
    for erratum in illegible:
        fact = by_path.get(erratum.fact.partition("/restated/")[0])
        if fact is not None and not fact.inferred and _inferred_key(fact):
            text = f"the manual is {erratum.illegible} here, but no key of {fact.name} is inferred"
            related_label = label(fact.place, _inferred_key(fact), "inferred from the illegible text")
            help = "add the reason under `inferred`"
            yield finding(erratum.place, "illegible", text, help, related_label)


def _inferred_key(fact: Fact) -> str:
    """The key under which something was inferred from the illegible text of a fact, or nothing."""
    return next((key for key in ("doc", "causes", "remedies", "notes") if key in fact.place), "")
