"""Counts that are fractions of a reference value, which the device stores elsewhere."""

from __future__ import annotations

from ._conversions import counts
from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._typing import Quantity


class Conversion:
    """quantity = reference * raw / full_scale; with `complement`, reference * (1 - raw / full_scale).

    `ranges` are the valid counts, as intervals with both ends.
    """

    __slots__ = ("complement", "full_scale", "name", "ranges")

    def __init__(
        self, name: str, full_scale: int, ranges: tuple[tuple[int, int], ...], complement: bool = False
    ) -> None:
        self.name, self.full_scale, self.ranges, self.complement = name, full_scale, ranges, complement

    def quantity(self, raw: int, reference: Quantity) -> float:
        """The quantity of a count, rounded once. Raises CodecError for a reference that is no number."""
        a, b, c = self._ratio(reference)
        return (raw * a + b) / c

    def raw(self, quantity: Quantity, reference: Quantity) -> int:
        """The count that is nearest to a quantity; of two equally near ones the even one.

        Raises CodecError where it is outside the ranges, and for a reference of 0, which makes all quantities equal.
        """
        ratio = self._ratio(reference)
        if ratio[0] == 0:
            raise CodecError("out_of_range", f"the reference of {self.name} is 0")
        return counts(self.name, quantity, ratio, self.ranges)

    def _ratio(self, reference: Quantity) -> tuple[int, int, int]:
        """(a, b, c) of quantity = (raw * a + b) / c."""
        try:
            over, under = reference.as_integer_ratio()
        except (ValueError, OverflowError):
            raise CodecError("out_of_range", f"the reference of {self.name} is {reference}") from None
        except AttributeError:
            raise CodecError("wrong_type", f"the reference of {self.name} is a number, not {reference!r}") from None
        if self.complement:
            return -over, over * self.full_scale, under * self.full_scale
        return over, 0, under * self.full_scale
