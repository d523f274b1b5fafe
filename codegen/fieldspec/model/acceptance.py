"""Changes that are accepted although they hurt somebody."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.place import Place


@dataclass(frozen=True, slots=True)
class Acceptance:
    """That the rule `rule` may find a change at the fact with a path, why, and since when. `date` is as in 2026-01-31.

    `since` has the versions that bring the change, one for each line; it is empty where the change is one of the spec.
    """

    place: Place
    rule: str
    path: str
    reason: str
    date: str
    since: tuple[str, ...]
