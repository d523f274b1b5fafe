"""Values that stand for a state and not for a quantity, by the names of their states."""

from __future__ import annotations

from struct import Struct

from ._conversions import counts
from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any

    from ._refusals import BoundedBits
    from ._typing import Absent, Others, Quantity

_REALS = {2: Struct(">e"), 4: Struct(">f"), 8: Struct(">d")}


class LeftOut:
    """The type of `LEFT_OUT`."""

    __slots__ = ()

    def __repr__(self) -> str:
        return "LEFT_OUT"


LEFT_OUT = LeftOut()
"""Stands for an argument that a call leaves out, where None is an absent value."""


OUT_OF_RANGE = "out_of_range"
"""The state of a value that is read outside of what is stated of it. It is a quantity all the same."""


def bits_at(raw: int, place: int | tuple[tuple[int, int, int], ...]) -> int:
    """The bits of a word in a mask; of bits that lie apart, the number that their runs are."""
    if isinstance(place, int):
        return raw & place
    return sum((raw >> first & ones) << weight for first, ones, weight in place)


def state_of(
    value: Any, absent: Absent = (), ranges: tuple[tuple[float, float], ...] = (), bits: tuple[BoundedBits, ...] = ()
) -> str | None:
    """The name of the state that a value stands for, `out_of_range` outside of `ranges`, where there are any, and
    where a field of `bits` is outside of its own; None for any other value. Every NaN is the same.
    """
    number = getattr(value, "raw", value)
    for name, other in absent:
        if is_among(number, (other,)):
            return name
    is_within = not ranges or any(low <= number <= high for low, high in ranges)
    for _, place, images, _ in bits:
        is_within &= any(low <= bits_at(number, place) <= high for low, high in images)
    return None if is_within else OUT_OF_RANGE


def is_among(value: float, other_values: Others) -> bool:
    """Whether a number is one of some others, or in a range of them, where every NaN equals every other NaN."""
    for other in other_values:
        if isinstance(other, range):
            if other.start <= value < other.stop:
                return True
        elif value == other or (value != value and other != other):
            return True
    return False


def first_number(state: float | range) -> float:
    """The number that is written for a state: the least of a range."""
    return state[0] if isinstance(state, range) else state


def absent_number(name: str, absent: Absent) -> Any:
    """The value for None: the only absent one. Raises CodecError where there are several, or none."""
    if not absent:
        raise CodecError("wrong_type", f"{name} is a number, not None")
    if len(absent) > 1:
        states = " or ".join(f"{state} ({first_number(other)})" for state, other in absent)
        raise CodecError("wrong_type", f"None is not a single value of {name}: write {states}")
    return next(first_number(state) for _, state in absent)


def counts_or_absent(
    name: str,
    value: Quantity | None,
    ratio: tuple[int, int, int],
    ranges: tuple[tuple[int, int], ...],
    absent: Absent,
) -> int:
    """The count that is nearest to a value in the unit, as `counts` gives it; for None the only absent one."""
    count: int = absent_number(name, absent) if value is None else counts(name, value, ratio, ranges)
    return count


def real_or_absent(
    name: str,
    value: Quantity | None,
    size: int,
    ranges: tuple[tuple[float, float], ...],
    absent: Absent,
) -> float:
    """The number of `size` bytes that is nearest to a value in the unit; for None the only absent one.

    Raises CodecError out of range, for a number that stands for a state, and for what is not a number.
    """
    number: float
    if value is None:
        number = absent_number(name, absent)
        return number
    try:
        number = _REALS[size].unpack(_REALS[size].pack(float(value)))[0]
    except OverflowError:
        raise CodecError("out_of_range", f"{name} is {value}, more than {8 * size} bits can hold") from None
    except (TypeError, ValueError):
        raise CodecError("wrong_type", f"{name} is a number, not {value!r}") from None
    state = state_of(number, absent)
    if state is not None:
        raise CodecError("out_of_range", f"{name} is {value}, which is sent as {number} and stands for {state}")
    if number != number or (ranges and not any(low <= number <= high for low, high in ranges)):
        allowed = ", ".join(f"{low}..{high}" for low, high in ranges) or "the numbers of its type"
        raise CodecError("out_of_range", f"{name} is {value}, not in {allowed}")
    return number
