"""Reads scales and units as people write them: `0.1V`, `/10`, `x0.1`, `10^-1`, `V (Volt)`, `x/10 - 40`."""

from __future__ import annotations

import re
import unicodedata
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.units import standard_units
from fieldspec.tools.lists.brackets import parted
from fieldspec.tools.lists.cells import number
from fieldspec.tools.lists.words import meanings

_DIVIDED = re.compile(r"(?:[x\w]\s*)?(?:/|÷|:|divided? by)\s*([0-9.,]+)", re.IGNORECASE)
_TIMES = re.compile(r"(?:[*x\u00d7·]|times)\s*(.+)|(.+?)\s*[*x\u00d7]", re.IGNORECASE)
_HEXADECIMAL = re.compile(r"0x", re.IGNORECASE)
"""The beginning of a mask: factors are not written in this form."""

_DISPLAYED = re.compile(r"[x#]+[.,]([x#]{1,6})", re.IGNORECASE)
"""How a value is displayed: `xxx.x`."""

_RATIO = re.compile(r"([0-9]{1,9})\s*[/:]\s*([0-9]{1,9})")
_LEADING = re.compile(
    r"([-+]?[0-9]*[.,]?[0-9]+(?:[eE][-+]?[0-9]+)?|[/÷]\s*[0-9.,]+|10\s*\^\s*\(?[-+]?[0-9]+\)?|[0-9]+\s*/\s*[0-9]+|[X#]+\.[X#]+)\s*[*x\u00d7·]?\s*([^\s0-9.,*/^].*)"
)
_COUNTS = re.compile(r"[1-9][0-9]*\s*[*x\u00d7·]", re.IGNORECASE)
"""A factor above 1 with the sign after it: the counts per unit, or the units per count."""

_BEFORE = re.compile(
    r"(?:(÷|/|divided? by)|[x\u00d7*])\s*(10{1,6}|0\.0{0,5}1)(?:\s*(?:for|=|in)?\s*([^\s0-9]{1,6}))?", re.IGNORECASE
)
"""A factor with the sign before it, and perhaps a unit: `÷10 for %`."""

_BEHIND = re.compile(r"(\S.*?)\s*([*/x\u00d7÷])\s*([0-9][0-9.,]*)")
_LINEAR = re.compile(
    r"\(?\s*(?:[a-z_][a-z_ ]*|\[[0-9]+\])\s*(?:(?P<sign>[*/x\u00d7÷])\s*(?P<value>[0-9][0-9.,]*(?:e-?[0-9]+)?))?"
    r"\s*\)?\s*(?:(?P<plus>[-+])\s*(?P<added>[0-9][0-9.,]*))?",
    re.IGNORECASE,
)
_SHIFTED = re.compile(
    r"\(\s*[a-z_][a-z_ ]*\s*(?P<plus>[-+])\s*(?P<added>[0-9][0-9.,]*)\s*\)\s*(?P<sign>[*/x\u00d7÷])"
    r"\s*(?P<value>[0-9][0-9.,]*)",
    re.IGNORECASE,
)
"""A formula that adds before it scales: `(x - 400) / 10`."""

_CALLED = re.compile(r"(?:(scale|multiply|mul|times)|divide|div)\(\s*([0-9][0-9.,]*)\s*\)", re.IGNORECASE)
"""A formula that is a function of the count: `scale(0.1)`."""

_SYMBOL = re.compile(r"[^\W\d_°%µΩ\u2032″‰]*[°%‰]?[^\W\d_]*(?:[/·*^⁻¹²³][^\W_]{1,8}){0,3}[²³]?")
_PER_COUNT = re.compile(r"\s*(?:/|\bper\b)\s*(?:bit|digit|lsb|count|step)s?$", re.IGNORECASE)
_NO_UNIT = ("", "-", "--", "---", "n/a", "na", "none", "/", "1", ".", "无", "無", "keine", "aucune", "\u2013", "\u2014")
_LONGEST_SYMBOL, _SHORTEST_WORD = 12, 4


@dataclass(frozen=True, slots=True)
class Quantity:
    """A scale with a unit, either of which may be missing: None, or empty. `offset` is added after scaling.

    `times` is a factor after a multiplication sign, as in `V x 10`: the counts per unit, or the units per count.
    `evidence` is the text that says it, or a scale that no cell of scales has.
    """

    scale: Fraction | None = None
    unit: str = ""
    offset: Decimal = Decimal(0)
    times: Fraction | None = None
    evidence: str = ""


def _units() -> dict[str, str]:
    symbols = {}
    for unit in reversed(standard_units().values()):
        for symbol in (*unit.others, unit.symbol):
            symbols[_key(symbol)] = unit.symbol
    return {**meanings("units"), **symbols}


def _key(text: str) -> str:
    """A symbol without blanks and width. Its case counts for some: mW is not MW."""
    return "".join(unicodedata.normalize("NFKC", text).split())


_UNITS = _units()
_BY_CASE: dict[str, set[str]] = {}
for _symbol, _unit in _UNITS.items():
    _BY_CASE.setdefault(_symbol.casefold(), set()).add(_unit)


def known_unit(text: str) -> str:
    """The unit of the language that a symbol or a word names; empty if it names none, or one of several."""
    key = _key(text.strip().strip("[]()").strip())
    if key in _UNITS:
        return _UNITS[key]
    units = _BY_CASE.get(key.casefold(), set())
    return next(iter(units)) if len(units) == 1 else ""


def is_symbol(text: str) -> bool:
    """Whether a text may be the symbol of a unit that the language does not have."""
    return 0 < len(text) <= _LONGEST_SYMBOL and _SYMBOL.fullmatch(text) is not None and any(map(str.isalpha, text))


@lru_cache(maxsize=20_000)  # rows have most texts in common, and each is read several times
def factor(text: str, decimal: str) -> Fraction | None:
    """The factor that a cell states, with its direction: `/10`, `x0.1`, `1/10`; None if it states none above 0."""
    text = unicodedata.normalize("NFKC", text).strip().strip("`").strip()
    if _HEXADECIMAL.match(text):
        return None
    if displayed := _DISPLAYED.fullmatch(text):
        return Fraction(1, 10 ** len(displayed[1]))
    if ratio := _RATIO.fullmatch(text):
        return Fraction(int(ratio[1]), int(ratio[2])) if int(ratio[1]) and int(ratio[2]) else None
    if divided := _DIVIDED.fullmatch(text):
        value = number(divided[1], decimal)
        return 1 / Fraction(value) if value is not None and value > 0 else None
    times = _TIMES.fullmatch(text)
    value = number((times[1] or times[2]) if times else text, decimal)
    return Fraction(value) if value is not None and value > 0 else None


def times(text: str, decimal: str) -> Fraction | None:
    """The factor above 1 of a cell with nothing else than it and a multiplication sign: `x10`; None for another one."""
    match = _TIMES.fullmatch(unicodedata.normalize("NFKC", text).strip())
    value = number(match[1] or match[2], decimal) if match else None
    return Fraction(value) if value is not None and value > 1 else None


def states_direction(text: str) -> bool:
    """Whether a cell says by itself how a factor is used: `/10`, `x0.1`, `1/10`, `0.1 V`."""
    return re.search(r"[/÷*x\u00d7^%‰°]|[^\W\d_]", unicodedata.normalize("NFKC", text).strip()) is not None


def unit_cell(text: str, decimal: str) -> Quantity | None:
    """The unit of a cell, with the scale that it may have before or after it. None if the cell is not understood."""
    text = _PER_COUNT.sub("", " ".join(unicodedata.normalize("NFC", text).split()).strip("`"))
    if text.casefold() in _NO_UNIT:
        return Quantity()
    if unit := known_unit(text):
        return Quantity(unit=unit)
    if (scaled := scaled_unit(text, decimal)) is not None:
        return scaled
    if (prefix := _BEFORE.fullmatch(text)) and (known_unit(prefix[3] or "") or not prefix[3]):
        unit, step = known_unit(prefix[3] or ""), Fraction(prefix[2])
        step = 1 / step if prefix[1] else step
        return Quantity(step, unit) if prefix[1] or step < 1 else Quantity(unit=unit, times=step)
    if suffix := _BEHIND.fullmatch(text):
        unit, value = known_unit(suffix[1]), number(suffix[3], decimal)
        scaled = scaled_unit(suffix[1], decimal) if suffix[2] not in "/÷" and value is not None else None
        if scaled is not None and scaled.scale is not None and scaled.scale * Fraction(value or 0) == 1:
            return scaled  # `0.1 °C x 10` says the step, and how many of them are one of the unit
        if unit and value is not None and value > 0 and suffix[2] in "/÷":
            return Quantity(1 / Fraction(value), unit)
        if unit and value is not None and 0 < value < 1:
            return Quantity(Fraction(value), unit)
        if unit and value is not None and value > 1:
            return Quantity(unit=unit, times=Fraction(value))
    if all(pieces := parted(text)):
        outer, inner = (unit_cell(piece, decimal) for piece in pieces)
        if outer is not None and outer.unit and (inner is None or inner.unit in ("", outer.unit)):
            return Quantity(outer.scale or (inner.scale if inner else None), outer.unit)
        return None
    symbol = text.strip("[]() ")
    is_word = symbol.isalpha() and (symbol.islower() or (len(symbol) >= _SHORTEST_WORD and symbol[1:].islower()))
    return Quantity(unit=symbol) if is_symbol(symbol) and not is_word else None


def scaled_unit(text: str, decimal: str) -> Quantity | None:
    """The unit of a cell with the scale before it, as in `0.1 %`; None for another cell."""
    leading = _LEADING.fullmatch(text)
    if leading is None or _COUNTS.match(text):
        return None
    scale, inner = factor(leading[1], decimal), unit_cell(leading[2], decimal)
    if scale is None or inner is None or inner.scale is not None or inner.times is not None or not inner.unit:
        return None
    return Quantity(scale, inner.unit)


def exact_decimal(number: Fraction) -> Decimal | None:
    """A number as a decimal one; None if it has none."""
    result = Decimal(number.numerator) / number.denominator
    return result if Fraction(result) == number else None


def formula(text: str, decimal: str) -> Quantity | None:
    """The scale and the offset of a linear formula, such as `x/10 - 40`; None for any other."""
    before, _, suffix = unicodedata.normalize("NFKC", text).partition("=")
    right = (suffix or before).strip()
    if called := _CALLED.fullmatch(right):
        right = f"x {'*' if called[1] else '/'} {called[2]}"
    shifted = _SHIFTED.fullmatch(right)
    match = shifted or _LINEAR.fullmatch(right)
    if match is None or not (match["sign"] or match["plus"]):
        return None
    value, added = number(match["value"] or "1", decimal), number(match["added"] or "0", decimal)
    if value is None or added is None or value <= 0:
        return None
    scale = 1 / Fraction(value) if match["sign"] in ("/", "÷") else Fraction(value)
    moved = Fraction(added) * (scale if shifted else 1)
    offset = exact_decimal(-moved if match["plus"] == "-" else moved)
    return None if offset is None else Quantity(scale, "", offset)
