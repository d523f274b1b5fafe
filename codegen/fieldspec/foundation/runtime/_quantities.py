"""Counts whose quantity depends on what the device stores elsewhere: a reference value, or the exponent of a scale."""

from __future__ import annotations

from ._absent import is_among
from ._conversions import counts
from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ._typing import Quantity
    from ._values import Value


Ratio = tuple[int, int, int]
"""(a, b, c) of quantity = (raw * a + b) / c."""


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
        """The quantity of a count, rounded once. Raises CodecError for a reference that is not a number."""
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
            numerator, under = reference.as_integer_ratio()
        except (ValueError, OverflowError):
            raise CodecError("out_of_range", f"the reference of {self.name} is {reference}") from None
        except AttributeError:
            raise CodecError("wrong_type", f"the reference of {self.name} is a number, not {reference!r}") from None
        if self.complement:
            return -numerator, numerator * self.full_scale, under * self.full_scale
        return numerator, 0, under * self.full_scale


def power_of_ten(name: str, exponent_name: str, limits: tuple[tuple[int, int], ...], exponent: int | None) -> Ratio:
    """The scale of a power of ten as a `Value` has it. Raises CodecError for an invalid or missing exponent."""
    if exponent is None:
        raise CodecError("wrong_type", f"the scale of {name} has an exponent, which is the value of {exponent_name}")
    is_whole = isinstance(exponent, int) and not isinstance(exponent, bool)
    if not is_whole or not any(low <= exponent <= high for low, high in limits):
        allowed = ", ".join(f"{low}..{high}" for low, high in limits)
        raise CodecError("out_of_range", f"{exponent_name} is {exponent!r}, not an exponent in {allowed}")
    return (10**exponent, 0, 1) if exponent > 0 else (1, 0, 10**-exponent)


class PowerUnit:
    """The unit of counts whose scale is a power of ten: `exponent` is the name of what has the exponent.

    That is another field of the record, or a register of the device.
    """

    __slots__ = ("_exponents", "_value", "exponent", "name")

    def __init__(self, name: str, value: Value[int], exponent: str, exponents: Value[int]) -> None:
        self.name, self.exponent, self._value, self._exponents = name, exponent, value, exponents

    def __repr__(self) -> str:
        return f"<unit of {self.name}: 10^{self.exponent} {self.unit}>".replace(" >", ">")

    @property
    def unit(self) -> str:
        """The unit of the quantity, empty where there is none."""
        return self._value.unit

    def in_unit(self, count: int, exponent: int | None) -> float | None:
        """A count in the unit; None where the count or the exponent stands for an absent value.

        Raises CodecError for an invalid exponent.
        """
        if exponent is not None and is_among(exponent, self._exponents.others):
            return None
        return self._value.in_unit(count, self._power(exponent))

    def from_unit(self, quantity: Quantity | None, exponent: int | None) -> int:
        """The count that is nearest to a quantity, of two the even one; for None the only absent value.

        Raises CodecError out of range, where that count stands for an absent value, for None if several do, and for an
        invalid exponent.
        """
        count: int = self._value.from_unit(self.name, quantity, self._power(exponent))
        return count

    def _power(self, exponent: int | None) -> Ratio:
        return power_of_ten(self.name, self.exponent, self._exponents.ranges, exponent)
