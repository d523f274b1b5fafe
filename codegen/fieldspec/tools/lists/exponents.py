"""The rows of a list whose scale is a power of ten, and the rows with the exponents: `10^power_sf`, or `W_SF`."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from decimal import Decimal

from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.language.model.value import MOST_PLACES
from fieldspec.tools.lists.row_reading import ListRow
from fieldspec.tools.lists.words import folded

USUAL = (Decimal(-10), Decimal(10))
"""The exponents of SunSpec, whose lists do not say them."""

_POWER = re.compile(r".*(?:\b10\s*(?:\^|\*\*)|pow\w*\(\s*10\s*,|pow\w*10)\W*(?:\w+\[['\"]?)?", re.IGNORECASE)
"""The beginning of a formula, up to the name of an exponent: `x * 10^`, `pow(10, sf[`."""


def exponents(rows: Sequence[ListRow], types: Sequence[str]) -> dict[int, int]:
    """The places of the rows with exponents, by the places of the rows that they scale.

    A row names another one that is the only one of its name. What cannot have an exponent, or be one, is left out.
    """
    places: dict[str, list[int]] = {}
    for place, row in enumerate(rows):
        for name in {folded(text) for text in (*row.names, row.texts.get("address", ""))} - {""}:
            places.setdefault(name, []).append(place)
    readable = ("ro", "rw") if any(row.access for row in rows) else ("",)
    return {
        place: other
        for place, row in enumerate(rows)
        if (other := _named(row, places)) is not None
        and other != place
        and is_count(PRIMITIVES[types[place]].encoding)
        and _named(rows[other], places) is None
        and is_exponent(rows[other], types[other], readable)
    }


def _named(row: ListRow, places: Mapping[str, Sequence[int]]) -> int | None:
    """The place of the row that the scale of a row names, or its formula with a power of ten."""
    formula = row.texts.get("formula", "")
    text = formula if _POWER.match(formula) else row.texts.get("scale", "")
    places_of_name = places.get(folded(_POWER.sub("", text)), ())
    return places_of_name[0] if len(places_of_name) == 1 else None


def is_exponent(row: ListRow, type_name: str, readable: Sequence[str]) -> bool:
    """Whether a row may have exponents: a single whole number within the usual bounds that is `readable`."""
    kind = PRIMITIVES[type_name]
    if not is_count(kind.encoding) or row.count > 1 or row.access not in readable:
        return False
    if row.texts.get("scale", "1") != "1":
        return False
    low, high = bounds(row)
    is_default = row.default is None or low <= row.default <= high
    return -MOST_PLACES <= low <= high <= MOST_PLACES and kind.low <= low and high <= kind.high and is_default


def bounds(row: ListRow) -> tuple[Decimal, Decimal]:
    """The least and the greatest exponent of a row; the usual ones where the list says none."""
    return (row.low, row.high) if row.low is not None and row.high is not None else USUAL


def is_open(row: ListRow) -> bool:
    """Whether the list states no bounds for a row."""
    return row.low is None or row.high is None
