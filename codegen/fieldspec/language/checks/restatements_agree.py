"""A fact that the manual states in two places is the same in both.

Why: two tables of one manual that differ are a contradiction, and a reader of either table believes it.
`restated` contains what the second place should say, so every difference between printed values needs an erratum.

Example: a speed of 0..100 in the register table, restated as 1..100 in the chapter on points.

Fix: State the right value in both places, and write an erratum for the misprinted place. Omit from `restated` what that
place does not print.
"""

from __future__ import annotations

from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.checks.restatements import as_text, claimed_value, statements
from fieldspec.language.diagnostics import Label
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Claim, Fact
from fieldspec.language.model.sizes import RecordSizes

_NOT_HERE = ("printed_name", "label", "span", "word_span")
"""Names are shown, not compared; spans are compared with the layout, by spans_match_layout."""

_STANDS_UNDER = {
    "at": ("at", "base"),
    "decimal": ("decimal", "at", "base"),
    "wire_number": ("wire_number", "number", "base"),
    "code": ("code", "number", "value"),
    "range": ("range", "unit_range", "numbers"),
    "unit_range": ("unit_range", "range"),
    "available_since": ("since",),
    "default": ("default", "unit_default"),
    "unit_default": ("unit_default", "default"),
    "value": ("value", "const", "full_scale"),
    "count": ("count", "elements", "rows"),
    "words": ("words", "type", "record"),
    "length": ("length", "type"),
    "enum_values": ("enum", "members"),
}


def restatements_agree(device: Device) -> Findings:
    sizes = RecordSizes(device)
    for fact in facts(device):
        if fact.restated:
            own = statements(device, sizes, fact)
            for claim in fact.restated:
                yield from _compare_claim(fact, own, claim)


def _compare_claim(fact: Fact, own: dict[str, object], claim: Claim) -> Findings:
    for key, claimed in claim.values.items():
        if key in _NOT_HERE:
            continue
        if key == "present":
            if claimed is not True:
                text = f"{fact.name} is missing where {_place_text(claim)} should have it"
                help = "set `present: true` and write an erratum"
                yield finding(claim.place, key, text, help, _place_label(fact, key))
            continue
        actual = own.get(key)
        if actual is None:
            text = f"{fact.name} has no `{key}` for {_place_text(claim)} to restate"
            help = "add it to the fact, or remove it from `restated`"
            yield finding(claim.place, key, text, help, _place_label(fact, key))
        elif claimed_value(key, claimed) != actual:
            text = (
                f"`{key}` of {fact.name} is {as_text(key, actual)}, but {as_text(key, claimed)} in {_place_text(claim)}"
            )
            help = "use the right value in both places, and write an erratum for the misprint"
            yield finding(claim.place, key, text, help, _place_label(fact, key))


def _place_text(claim: Claim) -> str:
    return claim.sources[0].text() if claim.sources else "the other place"


def _place_label(fact: Fact, key: str) -> Label:
    places = [name for name in _STANDS_UNDER.get(key, (key,)) if name in fact.place]
    return label(fact.place, places[0] if places else "name", "the fact itself")
