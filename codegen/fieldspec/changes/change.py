"""One difference between two versions of a device, as data. Nothing here prints."""

from __future__ import annotations

from enum import Enum

from fieldspec.classes import dataclass
from fieldspec.source import Span


class Effect(Enum):
    """Who is hurt, the gravest first.

    `wire`: bytes mean something else. `source`: generated names or types change, so that programs must be changed.
    `behaviour`: limits, defaults, access, or more than there was. `docs`: nobody; people read something else.
    """

    WIRE = "wire"
    SOURCE = "source"
    BEHAVIOUR = "behaviour"
    DOCS = "docs"

    @property
    def rank(self) -> int:
        """0 for the gravest."""
        return _ORDER.index(self)

    @property
    def breaking(self) -> bool:
        """Whether programs that worked may fail, or must be changed."""
        return self in (Effect.WIRE, Effect.SOURCE)


_ORDER = (Effect.WIRE, Effect.SOURCE, Effect.BEHAVIOUR, Effect.DOCS)


@dataclass(frozen=True, slots=True)
class Change:
    """One difference. `rule` is the name of its rule, `effect` its gravest effect.

    `what` is the kind of fact, `path` the fact's path, in the new device where it is there, else in the old one. `old`
    and `new` are the two values as text, empty where there is none, and `before` and `after` their places, None
    where the fact is not there. `outputs` are those in which names or types change.
    """

    rule: str
    effect: Effect
    what: str
    path: str
    message: str
    old: str
    new: str
    before: Span | None
    after: Span | None
    outputs: tuple[str, ...] = ()

    def order(self) -> tuple[int, str, str, str, str]:
        """A key that sorts changes by effect, then by fact, then by rule."""
        return self.effect.rank, self.path, self.rule, self.old, self.new
