"""Single numbers of a manual."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.classes import dataclass
from fieldspec.model.fact import Fact


@dataclass(frozen=True, slots=True, kw_only=True)
class Limit(Fact):
    """A timing, a maximum, a supply: a value, bounds, or a text.

    `sum_of` are the paths of the limits that add up to this one, `within` is that of one that it may not exceed.
    `transmits` is the direction of the longest frame that goes over the line after it, or empty.
    """

    kind: str
    value: Decimal | None
    low: Decimal | None
    high: Decimal | None
    text: str
    unit: str
    sum_of: tuple[str, ...]
    within: str
    transmits: str

    @property
    def most(self) -> Decimal | None:
        """The greatest value, None where none is given."""
        return self.high if self.high is not None else self.value
