"""Every rule by its code, with its documentation: those of reading, of checks and of proofs."""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass

from fieldspec.checks import CHECKS
from fieldspec.checks.allowances_used import allowances_used
from fieldspec.proofs.rules import RULES as OF_PROOFS
from fieldspec.reading.rules import RULES as OF_READING

_PARTS = ("Why: ", "Example: ", "Cure: ")
_TITLES = {
    "reading": "What holds of the files",
    "checks": "What holds of a device",
    "proofs": "What holds of examples and errata",
}
_INTRODUCTION = """\
<!-- Written by `fieldspec.rules.page`; a test keeps it fresh. -->

# Rules

Every finding has the code of its rule. `fieldspec rule CODE` shows one of these entries, `fieldspec check` applies all
of them. A fact that may break a rule of the second part says so: `allow: {<code>: <reason>}`.
"""


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule's documentation. `stage` is `reading`, `checks` or `proofs`."""

    code: str
    stage: str
    what: str
    why: str
    example: str
    cure: str


def all_rules() -> tuple[Rule, ...]:
    """All rules, by code."""
    return tuple(sorted(_rules(), key=lambda rule: rule.code))


def rule(code: str) -> Rule | None:
    """The rule with a code."""
    return next((rule for rule in _rules() if rule.code == code), None)


def page() -> str:
    """The documentation of all rules, as Markdown."""
    blocks = [_INTRODUCTION]
    for stage, title in _TITLES.items():
        blocks.append(f"## {title}\n")
        for held in all_rules():
            if held.stage == stage:
                blocks += _entry(held)
    return "\n".join(blocks)


def _entry(held: Rule) -> Iterator[str]:
    yield f"### {held.code}\n"
    texts = (held.what, f"**Why:** {held.why}", f"**Example:** {held.example}", f"**Cure:** {held.cure}")
    for text in texts:
        yield textwrap.fill(text, 118, break_long_words=False, break_on_hyphens=False) + "\n"


def _rules() -> Iterator[Rule]:
    for code, text in OF_READING.items():
        yield _parsed(code, "reading", text)
    for code, check in (*CHECKS, ("allowances_used", allowances_used)):
        yield _parsed(code, "checks", sys.modules[check.__module__].__doc__ or "")
    for code, text in OF_PROOFS.items():
        yield _parsed(code, "proofs", text)


def _parsed(code: str, stage: str, text: str) -> Rule:
    """A rule from its text: what holds, then the three parts in their order."""
    what, *parts = (" ".join(paragraph.split()) for paragraph in text.strip().split("\n\n"))
    if len(parts) != len(_PARTS) or not all(map(str.startswith, parts, _PARTS)):
        raise ValueError(f"the text of the rule {code} has not the parts {', '.join(_PARTS)}")
    why, example, cure = (part.removeprefix(start) for part, start in zip(parts, _PARTS, strict=True))
    return Rule(code, stage, what, why, example, cure)
