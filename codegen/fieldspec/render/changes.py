"""Changes as they are shown: with what accepts them, grouped by whom they hurt. The words that all forms share."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.spelling import listed
from fieldspec.classes import dataclass
from fieldspec.model.acceptance import Acceptance
from fieldspec.render.text import place
from fieldspec.source import Span

MEANINGS = {
    Effect.WIRE: "bytes mean something else",
    Effect.SOURCE: "generated names or types change",
    Effect.BEHAVIOUR: "limits, defaults or access change, or there is more",
    Effect.DOCS: "people read something else",
}


@dataclass(frozen=True, slots=True)
class Found:
    """A change, what accepts it, and the versions in which it is found; none where it is found in all."""

    change: Change
    accepted: Acceptance | None = None
    versions: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Difference:
    """What differs between two things, by the names that users gave them: the gravest first."""

    old: str
    new: str
    found: tuple[Found, ...]

    @property
    def open(self) -> tuple[Found, ...]:
        """What nothing accepts."""
        return tuple(found for found in self.found if found.accepted is None)

    @property
    def accepted(self) -> tuple[Found, ...]:
        """What something accepts."""
        return tuple(found for found in self.found if found.accepted is not None)


@dataclass(frozen=True, slots=True)
class Group:
    """A heading and what stands below it. `effect` is None for what is accepted."""

    heading: str
    effect: Effect | None
    found: tuple[Found, ...]


def groups(difference: Difference) -> list[Group]:
    """The changes by effect, then those that are accepted; no empty groups."""
    held = [
        Group(
            f"{effect.value}: {meaning}", effect, tuple(one for one in difference.open if one.change.effect is effect)
        )
        for effect, meaning in MEANINGS.items()
    ]
    return [group for group in (*held, Group("accepted", None, difference.accepted)) if group.found]


def summary(difference: Difference) -> str:
    """`2 wire, 1 docs, 1 accepted`, or `no differences`"""
    counts = [(sum(one.change.effect is effect for one in difference.open), effect.value) for effect in MEANINGS] + [
        (len(difference.accepted), "accepted")
    ]
    return ", ".join(f"{count} {name}" for count, name in counts if count) or "no differences"


def places(change: Change, shown: Callable[[Span], str] = place) -> str:
    """`old.yaml:3:5 -> new.yaml:4:5`; one place where the other side has none."""
    return " -> ".join(shown(span) for span in (change.before, change.after) if span is not None)


def remark(found: Found) -> str:
    """What is to be said beside the message: in which outputs and versions, and why it is accepted."""
    parts = []
    if found.change.outputs:
        parts.append(f"in {listed(found.change.outputs)}")
    if found.versions:
        parts.append(f"at {listed(found.versions)} only")
    if found.accepted is not None:
        parts.append(f"accepted {found.accepted.date}: {found.accepted.reason}")
    return "; ".join(parts)


def hurts(differences: Iterable[Difference], threshold: str) -> bool:
    """Whether there is a change that nothing accepts and that is as grave as `breaking`, `behaviour` or `any`."""
    least = {"breaking": Effect.SOURCE, "behaviour": Effect.BEHAVIOUR, "any": Effect.DOCS}[threshold]
    return any(found.change.effect.rank <= least.rank for one in differences for found in one.open)


def title(difference: Difference) -> str:
    """`drive@1.5 -> drive@2.0`"""
    return f"{difference.old} -> {difference.new}"


def all_found(differences: Sequence[Difference]) -> list[Found]:
    """The changes of all comparisons that nothing accepts."""
    return [found for one in differences for found in one.open]
