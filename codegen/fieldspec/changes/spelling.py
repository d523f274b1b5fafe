"""Values of the model as text, as a person reads them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

from fieldspec.classes import attributes
from fieldspec.model.device import Manual
from fieldspec.model.enum import Cause
from fieldspec.model.fact import Citation, Claim
from fieldspec.model.lookup import Column
from fieldspec.model.primitive import Primitive
from fieldspec.model.ranges import Ranges
from fieldspec.model.value import ParameterPart

NOTHING = "nothing"


def hexadecimal(number: int | None) -> str:
    """`0x2011`"""
    return "" if number is None else f"0x{number:04X}" if number > 0xFF else f"0x{number:02X}"


def spelled(held: object) -> str:
    """A value as text; an empty one for nothing."""
    if held is None:
        return ""
    if isinstance(held, bool):
        return "yes" if held else "no"
    if isinstance(held, Decimal):
        return plain(held)
    if isinstance(held, bytes):
        return held.hex(" ").upper()
    if isinstance(held, Ranges | Citation):
        return held.text()
    if isinstance(held, Primitive):
        return held.name
    if isinstance(held, ParameterPart):
        return f"{held.part} of {held.set}" + (f" by {held.number}" if held.number else "")
    if isinstance(held, Claim):
        return f"{spelled(held.values)} in {spelled(held.sources)}"
    if isinstance(held, Column | Cause | Manual):
        parts = (spelled(getattr(held, name)) for name in attributes(held.__class__))
        return ": ".join(part for part in parts if part)
    if isinstance(held, Mapping):
        return ", ".join(f"{key}: {spelled(value)}" for key, value in held.items())
    if isinstance(held, Sequence) and not isinstance(held, str):
        return ", ".join(map(spelled, held))
    return str(held)


def plain(number: Decimal) -> str:
    """An exact number without an exponent or needless zeros."""
    text = f"{number:f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def quoted(held: object) -> str:
    """The same for a sentence: `nothing` for nothing."""
    return spelled(held) or NOTHING


def listed(words: Sequence[object], most: int = 6) -> str:
    """`a, b and c`, or `a, b, c, d, e and 12 more`"""
    texts = [str(word) for word in words]
    if len(texts) > most:
        texts = [*texts[: most - 1], f"{len(texts) - most + 1} more"]
    return texts[0] if len(texts) == 1 else ", ".join(texts[:-1]) + " and " + texts[-1]
