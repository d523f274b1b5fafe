"""Every `allow` names a check, and that check would fail here.

Why: an allowance that is not needed any more hides the next slip at the same place.

Example: `allow: {addresses_disjoint: an alias}` on a register that overlaps nothing.

Cure: Remove the allowance, or put the name of the check right.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from fieldspec.checks.finding import Allowance, finding
from fieldspec.diagnostics import Diagnostic


def allowances_used(
    allowances: Iterable[Allowance], used: Collection[Allowance], names: Collection[str]
) -> Iterator[Diagnostic]:
    """Judges the allowances themselves. The runner calls it after the checks with the allowances that they needed.

    An allowance that a block and its copies share counts once.
    """
    needed = {_position(allowance) for allowance in used}
    for allowance in allowances:
        if allowance.check not in names:
            text = f"there is no check `{allowance.check}` that could be allowed to fail"
            yield _finding(allowance, text, "`fieldspec rule` lists the checks")
        elif _position(allowance) not in needed:
            text = f"`{allowance.check}` passes here, so nothing needs to be allowed"
            yield _finding(allowance, text, "remove the allowance")


def _position(allowance: Allowance) -> tuple[str, str, int]:
    span = allowance.fact.place["allow"]
    return allowance.check, span.file.path, span.start


def _finding(allowance: Allowance, text: str, help: str) -> Diagnostic:
    return finding("allowances_used", allowance.fact.place, "allow", text, help)
