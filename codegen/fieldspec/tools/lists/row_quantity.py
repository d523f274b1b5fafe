"""The quantity of a row: its unit, and what its cells say of the scale and the offset of its counts."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction

from fieldspec.foundation.classes import replace
from fieldspec.tools.lists.cells import number, whole
from fieldspec.tools.lists.quantities import Quantity, factor, formula, known_unit, states_direction, unit_cell
from fieldspec.tools.lists.words import folded, words

FACTORS = ("scale", "gain", "divisor")
"""The roles of columns with factors, whose direction a list may leave open."""

SCALED_BOUNDS = ("raw_low", "raw_high", "scaled_low", "scaled_high")
"""The roles of columns with two counts and the quantities that they stand for."""

IDLE_SCALES = ("none", "linear")
"""Cells of columns of scales that have no scale: the kinds of scaling that need no word."""

_ASIDE = re.compile(r"[\[(]([^()\[\]]+)[\])]\s*$")
_WEIGHT = re.compile(r"(?:value\s+)?weight\s*:?\s*([^\W\d]+)\s*[*x\u00d7]\s*([1-9][0-9]{0,8})", re.IGNORECASE)
"""How many counts are one of a unit: `Value weight: Volt*10`."""

_TIMES = re.compile(r"^\s*[*x\u00d7]\s*", re.IGNORECASE)
_FIXED = re.compile(r"fix(?:ed)?[ _]?([0-9])", re.IGNORECASE)
_FORMATS = {"temp": 1}
"""The places after the point of formats that have names beside `FIX2`."""

_HIGHEST_EXPONENT = 9


def quantity_of(
    texts: Mapping[str, str],
    names: Sequence[str],
    notes: Sequence[tuple[str, str]],
    decimal: str,
    doubts: list[str],
) -> Quantity:
    """The unit of a row, and the scale and the offset that need no decision for the whole list."""
    text = texts.get("unit", "")
    unit = unit_cell(text, decimal) if text else _unit_of_name(names, decimal)
    if unit is None:
        doubts.append(f"Unit in the list: {text}.")
        unit = Quantity()
    stated: list[tuple[Fraction, str]] = [(unit.scale, text)] if unit.scale not in (None, 1) else []
    offset = number(texts.get("value_offset", ""), decimal) or Decimal(0)
    if texts.get("value_offset") and number(texts["value_offset"], decimal) is None:
        doubts.append(f"Offset in the list: {texts['value_offset']}.")
    if texts.get("formula"):
        linear = formula(texts["formula"], decimal)
        if linear is None:
            doubts.append(f"Formula in the list: {texts['formula']}.")
        else:
            stated.append((linear.scale or Fraction(1), texts["formula"]))
            offset = offset or linear.offset
    line = _between_bounds(texts, decimal)
    if line is not None:
        stated.append((line.scale or Fraction(1), "raw and scaled bounds"))
        offset = offset or line.offset
    else:
        doubts += [
            f"{role.replace('_', ' ').capitalize()} in the list: {texts[role]}."
            for role in SCALED_BOUNDS
            if role in texts
        ]
    stated += _powers(texts, doubts)
    for _, note in notes:
        weight = _WEIGHT.fullmatch(note.strip())
        if weight and known_unit(weight[1]):
            stated.append((Fraction(1, int(weight[2])), note))
            unit = replace(unit, unit=unit.unit or known_unit(weight[1]))
    for role in FACTORS:
        if texts.get(role) and states_direction(texts[role]):
            scaled = unit_cell(_TIMES.sub("", texts[role]), decimal)
            own_factor = factor(texts[role], decimal)
            if own_factor is None and scaled is not None and scaled.scale is not None:
                own_factor, unit = scaled.scale, replace(unit, unit=unit.unit or scaled.unit)
            if own_factor is not None:
                stated.append((own_factor, texts[role]))
    scales = {scale for scale, _ in stated}
    if len(scales) > 1:
        doubts.append("The list has several scales: " + ", ".join(cell for _, cell in stated) + ".")
        return replace(unit, scale=None, offset=offset)
    return Quantity(next(iter(scales), None), unit.unit, offset)


def open_factor(texts: Mapping[str, str], role: str, decimal: str) -> Fraction | None:
    """The factor of a row whose cell does not say whether it multiplies or divides; None if it says so, or has none."""
    text = texts.get(role, "")
    return None if states_direction(text) else factor(text, decimal)


def unread_scales(texts: Mapping[str, str]) -> list[str]:
    """The cells of columns of scales, but those that have none."""
    return [texts[role] for role in FACTORS if role in texts and folded(texts[role]) not in IDLE_SCALES]


def decimal_places(text: str) -> int | None:
    """How many places a count has after the point: a number, or the name of a format such as `FIX2`."""
    fixed = _FIXED.fullmatch(text.strip())
    return int(fixed[1]) if fixed else _FORMATS.get(folded(text), whole(text))


def _powers(texts: Mapping[str, str], doubts: list[str]) -> Iterator[tuple[Fraction, str]]:
    """The scales of a number of places, and of a power of ten."""
    for role, sign in (("places", -1), ("exponent", 1)):
        text = texts.get(role, "")
        power = decimal_places(text) if role == "places" else whole(text)
        if power is not None and -_HIGHEST_EXPONENT <= sign * power <= (_HIGHEST_EXPONENT if role == "exponent" else 0):
            yield Fraction(10) ** (sign * power), text
        elif text:
            doubts.append(f"{role.capitalize()} in the list: {text}.")


def _between_bounds(texts: Mapping[str, str], decimal: str) -> Quantity | None:
    """The line through two counts and the quantities that they stand for."""
    ends = [number(texts.get(role, ""), decimal) for role in SCALED_BOUNDS]
    raw_low, raw_high, low, high = ends
    if raw_low is None or raw_high is None or low is None or high is None or raw_low >= raw_high or low >= high:
        return None
    scale = Fraction(high - low) / Fraction(raw_high - raw_low)
    offset = Fraction(low) - Fraction(raw_low) * scale
    places = Decimal(offset.numerator) / Decimal(offset.denominator)
    return Quantity(scale, "", places) if Fraction(places) == offset else None


def _unit_of_name(names: Sequence[str], decimal: str) -> Quantity:
    """The unit in brackets after a name, where the list has no cell for it: `Speed [rpm]`."""
    for name in names:
        aside = _ASIDE.search(name)
        quantity = unit_cell(aside[1], decimal) if aside else None
        if aside is None or quantity is None or not known_unit(quantity.unit):
            continue
        if quantity.scale or aside[0].startswith("[") or not _may_be_a_phase(known_unit(quantity.unit), name):
            return quantity
    return Quantity()


def _may_be_a_phase(unit: str, name: str) -> bool:
    """Whether a capital letter in round brackets may be a phase or a half: the name does not say what it measures."""
    is_capital = len(unit) == 1 and unit.isupper()
    return is_capital and not any(word in folded(name) for word in words("measured").get(unit, ()))
