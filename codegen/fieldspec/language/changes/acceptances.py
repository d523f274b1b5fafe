"""Sets the changes aside that a spec accepts, and reports acceptances without a change.

An acceptance is effective in a comparison of a device that has it with one that does not have it yet. With `since`, it
is about versions, and is effective between different ones. Without, it is about the spec, and is effective between any
two states of it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from fieldspec.foundation.classes import dataclass
from fieldspec.language.changes.change import Change
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Acceptance


@dataclass(frozen=True, slots=True)
class ComparedVersions:
    """Two devices and their changes. `step` if the new version is the next one on the line of the old version."""

    old: Device
    new: Device
    changes: Sequence[Change]
    step: bool


@dataclass(frozen=True, slots=True)
class JudgedChange:
    """A change, and the acceptance that names it, if there is one."""

    change: Change
    accepted: Acceptance | None


def judged_changes(compared: ComparedVersions) -> list[JudgedChange]:
    """The changes, each with the effective acceptance that names it."""
    acceptances = {
        (acceptance.rule, acceptance.path): acceptance
        for acceptance in effective_acceptances(compared.old, compared.new)
    }
    return [JudgedChange(change, acceptances.get((change.rule, change.path))) for change in compared.changes]


def effective_acceptances(old: Device, new: Device) -> list[Acceptance]:
    """The acceptances of the new device that are effective in a comparison with the old one."""
    known = {_identity(acceptance) for acceptance in old.accepts}
    added = [acceptance for acceptance in new.accepts if _identity(acceptance) not in known]
    return [acceptance for acceptance in added if not acceptance.since or old.version != new.version]


def rules_known(acceptances: Iterable[Acceptance], rules: Collection[str]) -> Iterator[Diagnostic]:
    """A finding for every acceptance that names no rule."""
    for acceptance in acceptances:
        if acceptance.rule not in rules:
            text = f"there is no rule of changes `{acceptance.rule}`"
            yield Diagnostic(
                "accepts_used", text, acceptance.place["rule"], help="`fieldspec rule` lists the rules of changes"
            )


def accepts_used(comparisons: Sequence[ComparedVersions]) -> Iterator[Diagnostic]:
    """A finding for every acceptance that is effective in these comparisons and names none of their changes.

    An acceptance with `since` must name a change between its version and the version before; later versions may have
    taken the change back.
    """
    expected: dict[tuple[object, ...], Acceptance] = {}
    used: set[tuple[object, ...]] = set()
    for compared in comparisons:
        changes = {(change.rule, change.path) for change in compared.changes}
        for acceptance in effective_acceptances(compared.old, compared.new):
            if not acceptance.since or (compared.step and compared.new.version in acceptance.since):
                expected[_identity(acceptance)] = acceptance
            if (acceptance.rule, acceptance.path) in changes:
                used.add(_identity(acceptance))
    for identity, acceptance in expected.items():
        if identity not in used:
            text = f"`{acceptance.rule}` finds no change at `{acceptance.path}`"
            help = "correct the path, or remove the entry"
            yield Diagnostic("accepts_used", text, acceptance.place["path"], help=help)


def _identity(acceptance: Acceptance) -> tuple[object, ...]:
    return acceptance.rule, acceptance.path, acceptance.reason, acceptance.date, acceptance.since
