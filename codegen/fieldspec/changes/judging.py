"""Sets aside the changes that a spec accepts, and finds acceptances that accept nothing.

An acceptance counts where it is new: in a comparison of what has it with what has it not. One with `since` belongs to
versions, and counts between different ones; one without belongs to the spec, and counts between two states of it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from fieldspec.changes.change import Change
from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.texts import Acceptance


@dataclass(frozen=True, slots=True)
class Compared:
    """Two devices and their changes. `step` says that the new version follows the old one on its line."""

    old: Device
    new: Device
    changes: Sequence[Change]
    step: bool


@dataclass(frozen=True, slots=True)
class Judged:
    """A change, and what accepts it."""

    change: Change
    accepted: Acceptance | None


def judged(compared: Compared) -> list[Judged]:
    """The changes, each with the acceptance that counts and names it."""
    accepted = {(acceptance.rule, acceptance.path): acceptance for acceptance in counting(compared.old, compared.new)}
    return [Judged(change, accepted.get((change.rule, change.path))) for change in compared.changes]


def counting(old: Device, new: Device) -> list[Acceptance]:
    """The acceptances that count between two devices."""
    known = {_identity(acceptance) for acceptance in old.accepts}
    fresh = [acceptance for acceptance in new.accepts if _identity(acceptance) not in known]
    return [acceptance for acceptance in fresh if not acceptance.since or old.version != new.version]


def rules_known(acceptances: Iterable[Acceptance], rules: Collection[str]) -> Iterator[Diagnostic]:
    """A finding for every acceptance that names no rule."""
    for acceptance in acceptances:
        if acceptance.rule not in rules:
            text = f"there is no rule `{acceptance.rule}` that could find a change"
            yield Diagnostic(
                "accepts_used", text, acceptance.place["rule"], help="`fieldspec rule` lists the rules of changes"
            )


def accepts_used(comparisons: Sequence[Compared]) -> Iterator[Diagnostic]:
    """A finding for every acceptance that counts in these comparisons and finds no change.

    One that belongs to a version is asked for where its version is compared with the one before it: a later version
    may have taken the change back.
    """
    asked: dict[tuple[object, ...], Acceptance] = {}
    met: set[tuple[object, ...]] = set()
    for compared in comparisons:
        changed = {(change.rule, change.path) for change in compared.changes}
        for acceptance in counting(compared.old, compared.new):
            if not acceptance.since or (compared.step and compared.new.version in acceptance.since):
                asked[_identity(acceptance)] = acceptance
            if (acceptance.rule, acceptance.path) in changed:
                met.add(_identity(acceptance))
    for identity, acceptance in asked.items():
        if identity not in met:
            text = f"`{acceptance.rule}` finds no change at `{acceptance.path}`"
            yield Diagnostic(
                "accepts_used", text, acceptance.place["path"], help="put the path right, or remove the entry"
            )


def _identity(acceptance: Acceptance) -> tuple[object, ...]:
    return acceptance.rule, acceptance.path, acceptance.reason, acceptance.date, acceptance.since
