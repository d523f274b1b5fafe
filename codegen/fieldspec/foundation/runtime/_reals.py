"""Floating-point numbers in bytes, which are in their unit."""

from __future__ import annotations

from ._absent import real_or_absent, state_of
from ._error import CodecError
from ._refusals import refused_double, refused_float, refused_half
from ._typing import TYPE_CHECKING
from ._values import Value

if TYPE_CHECKING:
    from typing import Any

    from ._typing import Absent, Quantity, Stated


class Float(Value[float]):
    """A floating-point number of 32 bits."""

    __slots__ = ()

    def __init__(
        self,
        letters: str,
        *,
        swapped: bool = False,
        ranges: tuple[tuple[float, float], ...] = (),
        unit: str = "",
        absent: Absent = (),
        stated: Stated | None = None,
    ) -> None:
        stated = (ranges,) if stated is None else stated
        super().__init__(letters, swapped=swapped, unit=unit, absent=absent, stated=stated)
        self.ranges = ranges  # type: ignore[assignment]  # those of other values are whole numbers

    def of_carried(self, name: str, raw: Any) -> float:
        """The number that a message carries. Raises CodecError."""
        if not isinstance(raw, (int, float)):
            raise CodecError("wrong_type", f"{name} is a number, not {raw!r}")
        return float(raw)

    def of_raw(self, name: str, raw: float) -> float:
        return raw

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_float(name, value, self.ranges, self.others)

    def in_unit(self, count: float, ratio: tuple[int, int, int] | None = None) -> float | None:
        """The number itself, which is in the unit; None for one that stands for an absent value."""
        return None if state_of(count, self.absent) is not None else float(count)

    def from_unit(self, name: str, value: Quantity | None, ratio: tuple[int, int, int] | None = None) -> float:
        """The number that is nearest to a value in the unit; for None the only absent value.

        Raises CodecError out of range, for a number that stands for an absent value, and for None where several do.
        """
        return real_or_absent(name, value, self.size, self.ranges, self.absent)


class Half(Float):
    """A floating-point number of 16 bits."""

    __slots__ = ()

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_half(name, value, self.ranges, self.others)


class Double(Float):
    """A floating-point number of 64 bits."""

    __slots__ = ()

    def refused(self, name: str, value: Any) -> CodecError | None:
        return refused_double(name, value, self.ranges, self.others)
