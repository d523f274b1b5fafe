"""The elementary types of Structured Text: their numbers, and the functions from one to another."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from typing import Any

from st_syntax import StError

SIZES = {"byte": 1, "word": 2, "dword": 4, "lword": 8, "usint": 1, "uint": 2, "udint": 4, "ulint": 8}
SIGNED = {"sint": 1, "int": 2, "dint": 4, "lint": 8}
BITS = ("byte", "word", "dword", "lword")
REALS = ("real", "lreal")
WHOLE = (*SIZES, *SIGNED)
NUMBERS = tuple(kind for kind in WHOLE if kind not in BITS)
ELEMENTARY = ("bool", *WHOLE, *REALS)


def bounds(kind: str) -> tuple[int, int]:
    """The least and the greatest number of a type."""
    if kind in SIGNED:
        return -(1 << (8 * SIGNED[kind] - 1)), (1 << (8 * SIGNED[kind] - 1)) - 1
    return 0, (1 << (8 * SIZES[kind])) - 1


def wrapped(kind: str, value: int) -> int:
    """The lowest bits of a number in a type."""
    low, high = bounds(kind)
    return (value - low) % (high - low + 1) + low


def single(value: float) -> float:
    """The nearest number of 32 bits."""
    try:
        return float(struct.unpack("<f", struct.pack("<f", value))[0])
    except OverflowError:
        return math.copysign(math.inf, value)


class MachineError(Exception):
    """Something that must not happen while a function runs."""


def wrapped_number(kind: str) -> Callable[[int], int]:
    """What passes a number on that its type holds, and refuses others."""
    low, high = bounds(kind)

    def check(value: int) -> int:
        if not low <= value <= high:
            raise MachineError(f"{value} leaves {kind}")
        return value

    return check


def at(index: int, low: int, high: int) -> int:
    """The place of an element in a list."""
    if not low <= index <= high:
        raise MachineError(f"index {index} is not in {low}..{high}")
    return index - low


def divided(left: int, right: int) -> int:
    """A quotient, cut towards zero."""
    return abs(left) // abs(right) * (1 if (left < 0) == (right < 0) else -1)


def remainder(left: int, right: int) -> int:
    """What a division leaves; it has the sign of the left one."""
    return left - right * divided(left, right)


def _rounded(value: float, rounding: str) -> int:
    if rounding == "even":
        return round(value)
    if rounding == "away":
        return int(math.copysign(math.floor(abs(value) + 0.5), value))
    return math.trunc(value)


def conversion(source: str, target: str, rounding: str) -> Callable[[Any], Any]:
    """The function from one elementary type to another."""
    if source in REALS and target in REALS:
        return float if target == "lreal" else single
    if target in REALS:
        if source in BITS or source == "bool":
            raise StError(f"{source}_to_{target} means different things in dialects")
        return float if target == "lreal" else lambda value: single(float(value))
    if source in REALS:
        check = wrapped_number(target)
        return lambda value: check(_rounded(value, rounding))
    if source == "bool" or target == "bool":
        raise StError(f"{source}_to_{target}")
    if source in BITS or target in BITS:
        return lambda value: wrapped(target, value)
    return wrapped_number(target)
