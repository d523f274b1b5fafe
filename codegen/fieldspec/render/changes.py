"""Changes as shown to people, grouped by effect, and as findings for code reviews."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.evidence import enumeration
from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic, Label, Severity
from fieldspec.model.texts import Acceptance
from fieldspec.render.finding_text import place
from fieldspec.source import Span

MEANINGS = {
    Effect.WIRE: "bytes mean something else",
    Effect.SOURCE: "generated names or types change",
    Effect.BEHAVIOUR: "limits, defaults or access change, or something is new",
    Effect.DOCS: "only the documentation changes",
}


@dataclass(frozen=True, slots=True)
class AcceptedChange:
    """A change, its acceptance if there is one, and the versions that have the change; none where all have it."""

    change: Change
    accepted: Acceptance | None = None
    versions: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Difference:
    """The differences of two versions, by the names that a user gave: the gravest first."""

    old: str
    new: str
    changes: tuple[AcceptedChange, ...]

    @property
    def open(self) -> tuple[AcceptedChange, ...]:
        """The changes that are not accepted."""
        return tuple(entry for entry in self.changes if entry.accepted is None)

    @property
    def accepted(self) -> tuple[AcceptedChange, ...]:
        """The changes that are accepted."""
        return tuple(entry for entry in self.changes if entry.accepted is not None)


@dataclass(frozen=True, slots=True)
class Group:
    """A heading and its changes. `effect` is None for accepted changes."""

    heading: str
    effect: Effect | None
    changes: tuple[AcceptedChange, ...]


def groups(difference: Difference) -> list[Group]:
    """The changes by effect, then the accepted ones; no empty groups."""
    by_effect = [
        Group(
            f"{effect.value}: {meaning}",
            effect,
            tuple(entry for entry in difference.open if entry.change.effect is effect),
        )
        for effect, meaning in MEANINGS.items()
    ]
    return [group for group in (*by_effect, Group("accepted", None, difference.accepted)) if group.changes]


def summary(difference: Difference) -> str:
    """`2 wire, 1 docs, 1 accepted`, or `no differences`"""
    counts = [
        (sum(entry.change.effect is effect for entry in difference.open), effect.value) for effect in MEANINGS
    ] + [(len(difference.accepted), "accepted")]
    return ", ".join(f"{count} {name}" for count, name in counts if count) or "no differences"


def places(change: Change, place_text: Callable[[Span], str] = place) -> str:
    """`old.yaml:3:5 -> new.yaml:4:5`; a single place where only one version has the fact."""
    return " -> ".join(place_text(span) for span in (change.before, change.after) if span is not None)


def remark(entry: AcceptedChange) -> str:
    """A remark on a change: its outputs, its versions, its reason, and why it is accepted."""
    parts = []
    if entry.change.outputs:
        parts.append(f"in {enumeration(entry.change.outputs)}")
    if entry.versions:
        parts.append(f"at {enumeration(entry.versions)} only")
    if entry.change.reason:
        parts.append(f"because: {entry.change.reason}")
    if entry.accepted is not None:
        parts.append(f"accepted {entry.accepted.date}: {entry.accepted.reason}")
    return "; ".join(parts)


def hurts(differences: Iterable[Difference], threshold: str) -> bool:
    """Whether a change that is not accepted is at least `breaking`, `behaviour` or `any`."""
    lowest_effect = {"breaking": Effect.SOURCE, "behaviour": Effect.BEHAVIOUR, "any": Effect.DOCS}[threshold]
    return any(
        entry.change.effect.rank <= lowest_effect.rank for difference in differences for entry in difference.open
    )


def title(difference: Difference) -> str:
    """`drive@1.5 -> drive@2.0`"""
    return f"{difference.old} -> {difference.new}"


def unaccepted_changes(differences: Sequence[Difference]) -> list[AcceptedChange]:
    """The changes of all comparisons that are not accepted."""
    return [entry for difference in differences for entry in difference.open]


def findings(differences: Sequence[Difference]) -> list[Diagnostic]:
    """A finding for each change that is not accepted, except in documentation; a breaking change is an error.

    Its place is in the new version, with the old place as a label, or in the old one where the fact is gone.
    """
    return list(_findings(unaccepted_changes(differences)))


def _findings(entries: Sequence[AcceptedChange]) -> Iterator[Diagnostic]:
    for entry in entries:
        change = entry.change
        span = change.after or change.before
        if span is None or change.effect is Effect.DOCS:
            continue
        severity = Severity.ERROR if change.effect.breaking else Severity.WARNING
        labels = (Label(change.before, "before"),) if change.before is not None and change.after is not None else ()
        help = "; ".join(part for part in (f"{change.effect.value} at {change.path}", remark(entry)) if part)
        yield Diagnostic(change.rule, change.message, span, labels, help, severity)
