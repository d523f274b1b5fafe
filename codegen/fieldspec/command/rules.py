"""Every rule of findings and of changes between versions by its code, with its documentation."""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Iterator

from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.behaviour.rules import RULES as OF_BEHAVIOURS
from fieldspec.language.changes.table import RULES as OF_CHANGES
from fieldspec.language.checks.allowances_used import allowances_used
from fieldspec.language.checks.table import CHECKS, INSTALLED
from fieldspec.language.reading.rules import RULES as OF_READING
from fieldspec.targets.controllers.rules import RULES as OF_CONTROLLERS
from fieldspec.targets.rules import RULES as OF_OUTPUTS
from fieldspec.tools.audit.rules import RULES as OF_AUDITS
from fieldspec.tools.proofs.rules import RULES as OF_PROOFS

_PARTS = ("Why: ", "Example: ", "Fix: ")
_TITLES = {
    "reading": "Rules for files",
    "checks": "Rules for a device",
    "behaviours": "Rules for what a device does over time",
    "proofs": "Rules for examples and errata",
    "outputs": "Rules for what outputs can express",
    "audits": "Rules for a spec compared with its manual",
}
_INTRODUCTION = """\
<!-- Written by `fieldspec.command.rules.page`; a test keeps it fresh. -->

# Rules

Every finding has the code of its rule, and `fieldspec rule CODE` shows the entry of a rule. `fieldspec audit` applies
the rules for a spec compared with its manual, `fieldspec check` all others. If a fact may break a rule for a device,
state the reason there: `allow: {<code>: <reason>}`.
"""

_CHANGES = """\
<!-- Written by `fieldspec.command.rules.changes_page`; a test keeps it fresh. -->

# Changes

`fieldspec diff A B` assigns every difference between two versions of a device to one of these rules, and `fieldspec
rule CODE` shows the entry of a rule. A and B are versions (`drive@1.5`), folders of specs, or git revisions (`HEAD~3`,
`main:specs/drive`). Folders and revisions are compared version by version. A version that exists only in B is compared
with its base version. The class of a change shows whom it affects:

- `wire`: bytes have a different meaning. Programs read and write wrong values without an error.
- `source`: generated names or types change. Programs must be changed.
- `behaviour`: limits, defaults or access change, or a fact is new.
- `docs`: only the documentation changes.

`wire` and `source` are breaking. If a rule has several classes, a change has the most serious one that applies.

With `--fail-on breaking`, `behaviour` or `any`, the exit code is 1 if there is such a change and B does not accept
it with [`accepts`](language-structure.md#acceptance). It is also 1 if an entry of `accepts` matches no change, and 2
if A or B cannot be read. The formats `sarif` and `github` omit the class `docs`.
"""


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule's documentation. `stage` is one of the keys of `_TITLES`, or `changes`; `classes` are the classes of
    changes.
    """

    code: str
    stage: str
    what: str
    why: str
    example: str
    fix: str
    classes: tuple[str, ...] = ()


def all_rules() -> tuple[Rule, ...]:
    """All rules of findings, by code."""
    return tuple(sorted(_rules(), key=lambda rule: rule.code))


def change_rules() -> tuple[Rule, ...]:
    """All rules of changes, by code."""
    return tuple(
        replace(_parsed(code, "changes", _rule_text(function)), classes=tuple(effect.value for effect in effects))
        for code, function, effects in OF_CHANGES
    )


def installed_rules() -> tuple[Rule, ...]:
    """The rules of the checks of installed packages that are loaded, by code."""
    return tuple(check_rule(code, check) for code, check in sorted(INSTALLED.items()))


def check_rule(code: str, check: object) -> Rule:
    """The rule of a check. Raises ValueError where its documentation has not the four parts."""
    return _parsed(code, "checks", _rule_text(check))


def rule(code: str) -> Rule | None:
    """The rule with a code."""
    return next((rule for rule in (*_rules(), *installed_rules(), *change_rules()) if rule.code == code), None)


def page() -> str:
    """The documentation of all rules of findings, as Markdown."""
    blocks = [_INTRODUCTION]
    for stage, title in _TITLES.items():
        blocks.append(f"## {title}\n")
        for rule in all_rules():
            if rule.stage == stage:
                blocks += _entry(rule)
    return "\n".join(blocks)


def changes_page() -> str:
    """The documentation of all rules of changes, as Markdown."""
    return "\n".join([_CHANGES, *(line for rule in change_rules() for line in _entry(rule, "##"))])


def _entry(rule: Rule, heading: str = "###") -> Iterator[str]:
    yield f"{heading} {rule.code}\n"
    if rule.classes:
        yield f"**Class:** {', '.join(f'`{name}`' for name in rule.classes)}\n"
    texts = (rule.what, f"**Why:** {rule.why}", f"**Example:** {rule.example}", f"**Fix:** {rule.fix}")
    for text in texts:
        yield textwrap.fill(text, 118, break_long_words=False, break_on_hyphens=False) + "\n"


def _rules() -> Iterator[Rule]:
    for code, text in OF_READING.items():
        yield _parsed(code, "reading", text)
    for code, check in (*CHECKS, ("allowances_used", allowances_used)):
        yield check_rule(code, check)
    for code, text in OF_BEHAVIOURS.items():
        yield _parsed(code, "behaviours", text)
    for code, text in OF_PROOFS.items():
        yield _parsed(code, "proofs", text)
    for code, text in (*OF_CONTROLLERS.items(), *OF_OUTPUTS.items()):
        yield _parsed(code, "outputs", text)
    for code, text in OF_AUDITS.items():
        yield _parsed(code, "audits", text)


def _rule_text(function: object) -> str:
    """The docstring of a rule's function, or of the module that is named after it."""
    documentation = sys.modules[function.__module__].__doc__ or ""
    return documentation if _PARTS[-1] in documentation else function.__doc__ or ""


def _parsed(code: str, stage: str, text: str) -> Rule:
    """A rule from its text: what holds, then the three parts in their order."""
    statement, *parts = (" ".join(paragraph.split()) for paragraph in text.strip().split("\n\n"))
    if len(parts) != len(_PARTS) or not all(map(str.startswith, parts, _PARTS)):
        raise ValueError(f"the text of the rule {code} has not the parts {', '.join(_PARTS)}")
    reason, example, fix = (part.removeprefix(start) for part, start in zip(parts, _PARTS, strict=True))
    return Rule(code, stage, statement, reason, example, fix)
