"""Single numbers of a manual."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.classes import dataclass
from fieldspec.model.fact import Fact


@dataclass(frozen=True, slots=True, kw_only=True)
class Limit(Fact):
    """A timing, a maximum, a supply: a value, bounds, or a text."""

    kind: str
    value: Decimal | None
    low: Decimal | None
    high: Decimal | None
    text: str
    unit: str
