"""A difference of two versions of a device."""

from __future__ import annotations

from enum import Enum

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span


class Effect(Enum):
    """Whom a change affects, the gravest first.

    `wire`: bytes mean something else. `source`: generated names or types change, so programs must be changed.
    `behaviour`: limits, defaults or access change, or there is something new. `docs`: only the documentation changes.
    """

    WIRE = "wire"
    SOURCE = "source"
    BEHAVIOUR = "behaviour"
    DOCS = "docs"

    @property
    def rank(self) -> int:
        """The rank of the effect; that of the gravest is 0."""
        return _ORDER.index(self)

    @property
    def breaking(self) -> bool:
        """Whether programs may fail that worked, or must be changed."""
        return self in (Effect.WIRE, Effect.SOURCE)


_ORDER = (Effect.WIRE, Effect.SOURCE, Effect.BEHAVIOUR, Effect.DOCS)


@dataclass(frozen=True, slots=True)
class Change:
    """A difference that `rule` finds, with its gravest effect. The table of rules adds the name of the rule.

    `what` is the kind of the fact, `path` its path in the new device, or in the old one if the new one lacks it. `old`
    and `new` are the two values as text, empty for none; `before` and `after` are their places, None where there is no
    such fact. `outputs` are those in which names or types change. `reason` is what the overlay of the version says.
    """

    effect: Effect
    what: str
    path: str
    message: str
    old: str
    new: str
    before: Span | None
    after: Span | None
    outputs: tuple[str, ...] = ()
    rule: str = ""
    reason: str = ""

    def order(self) -> tuple[int, str, str, str, str]:
        """The key by which changes are sorted: by effect, then by fact, then by rule."""
        return self.effect.rank, self.path, self.rule, self.old, self.new
