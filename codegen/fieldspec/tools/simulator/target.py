"""The meaning of a request to a numbered parameter."""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.registers import Parameter


@dataclass(frozen=True, slots=True)
class Target:
    """The elements of a parameter that a request means. `count` is None for one value.

    `parameter` is None for a number that the set has and no row describes: it holds what is written to it.
    """

    set_name: str
    number: int
    parameter: Parameter | None
    first: int
    count: int | None

    @property
    def elements(self) -> range:
        """The indices of the elements."""
        return range(self.first, self.first + (1 if self.count is None else self.count))
