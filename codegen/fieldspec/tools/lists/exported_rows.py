"""Rows of our own exports, which say what they are, and where the manual has each fact."""

from __future__ import annotations

import re
from fractions import Fraction

from fieldspec.foundation.classes import replace
from fieldspec.language.model.address_space import BIT
from fieldspec.language.model.fact import LINES, PAGES, Citation
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.language.model.value import exact_scale
from fieldspec.tools.lists.cells import number_in_unit
from fieldspec.tools.lists.item import REGISTERS
from fieldspec.tools.lists.quantities import known_unit
from fieldspec.tools.lists.row_reading import FIELD, LAST_SUBINDEX, PARAMETER, REGISTER, ListRow, bits
from fieldspec.tools.lists.type_words import Typed
from fieldspec.tools.lists.value_forms import type_parts

OF_THE_MANUAL = ("section", "line", "unverified")
"""The columns of an export about the place where the manual prints a fact."""

_SECTION, _LINE = re.compile("[0-9A-Za-z.]+"), re.compile(f"({PAGES}?)([1-9][0-9]{{0,5}})")


def exported_row(row: ListRow) -> ListRow:
    """A row of an export, whose columns need no decision: bounds are counts, and a scale is exact."""
    text = row.texts.get("scale", "")
    try:
        exact = exact_scale(text) if text and not text.startswith("10^") else None
        scale = Fraction(exact) if exact is not None else None
    except ValueError:
        scale = row.factor
    own_text = text if "/" in text else ""
    is_parameter = row.length is None and row.texts.get("type") != BIT and row.space not in ("", REGISTERS)
    kind = PARAMETER if is_parameter else FIELD if "." in row.texts.get("name", "") else REGISTER
    type_name, form = type_parts(row.texts.get("type", ""))
    own_type = Typed(type_name) if type_name in PRIMITIVES else None
    subindices = bits(row.texts.get("subindex", ""), LAST_SUBINDEX)
    doubts = list(row.doubts)
    section, line, unverified = (row.texts.get(role, "") for role in OF_THE_MANUAL)
    cited = None
    if _SECTION.fullmatch(section) and (place := _LINE.fullmatch(line)):
        cited = Citation(section, ((int(place[2]), int(place[2])),), place[1] or LINES)
    else:
        doubts += _unciting(row)
    row = replace(row, doubts=tuple(doubts), cited=cited, is_verified=cited is not None and not unverified)
    row = replace(row, type=own_type, form=form, kind=kind, words=row.length, is_own=True, subindices=subindices)
    unit = row.texts.get("unit", "")
    low, high = (number_in_unit(row.texts.get(role, "")) for role in ("min", "max"))
    return replace(row, low=low, high=high, scale=scale, scale_text=own_text, unit=known_unit(unit) or unit)


def uncited(row: ListRow) -> ListRow:
    """An exported row without its place in the manual, which becomes a note."""
    return replace(row, cited=None, is_verified=False, doubts=(*row.doubts, *_unciting(row)))


def _unciting(row: ListRow) -> list[str]:
    return [f"{role.capitalize()} in the list: {row.texts[role]}." for role in OF_THE_MANUAL if role in row.texts]
