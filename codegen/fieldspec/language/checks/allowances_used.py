"""Every `allow` names a rule that the fact would break without it in at least one version.

Why: an allowance that is no longer needed hides the next mistake at the same place.

Example: `allow: {addresses_disjoint: an alias}` on a register that overlaps nothing.

Fix: Remove the allowance, or correct the name of the rule.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable

from fieldspec.language.checks.finding import Allowance, Findings, finding_of
from fieldspec.language.diagnostics import Diagnostic


def allowances_used(allowances: Iterable[Allowance], used: Collection[Allowance], names: Collection[str]) -> Findings:
    """Judges the allowances themselves. The runner calls it after the checks with the allowances that they needed.

    An allowance that a block and its copies share counts once.
    """
    used_positions = {_position(allowance) for allowance in used}
    for allowance in allowances:
        if allowance.check not in names:
            text = f"there is no rule `{allowance.check}` to allow"
            yield _finding(allowance, text, "`fieldspec rule` lists the rules")
        elif _position(allowance) not in used_positions:
            text = f"the fact does not break `{allowance.check}`, so the allowance is not needed"
            yield _finding(allowance, text, "remove the allowance")


def _position(allowance: Allowance) -> tuple[str, str, int]:
    span = allowance.fact.place["allow"]
    return allowance.check, span.file.path, span.start


def _finding(allowance: Allowance, text: str, help: str) -> Diagnostic:
    return finding_of("allowances_used", allowance.fact.place, "allow", text, help)
