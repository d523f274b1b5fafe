"""The units that every spec may use: symbols, codes, and exact conversions."""

from __future__ import annotations

from collections import Counter
from decimal import Decimal
from fractions import Fraction

import pytest

from fieldspec.language.model.ucum import is_code
from fieldspec.language.model.units import Unit, standard_unit, standard_units

UNITS = standard_units()


def unit(symbol: str) -> Unit:
    result = standard_unit(symbol)
    assert result is not None, symbol
    return result


def test_no_symbol_stands_for_two_units() -> None:
    symbols = Counter(symbol for unit in UNITS.values() for symbol in (unit.symbol, *unit.others))
    assert [symbol for symbol, number in symbols.items() if number > 1] == []


def test_every_unit_has_a_code_that_other_software_reads_or_none() -> None:
    assert [unit.symbol for unit in UNITS.values() if unit.ucum and not is_code(unit.ucum)] == []


# From NIST SP 811, appendix B, and the definitions of the International System.
@pytest.mark.parametrize(
    ("number", "symbol", "other", "expected"),
    [
        ("1", "ft", "m", "0.3048"),
        ("1", "mm2", "m²", "1/1000000"),
        ("1", "mph", "m/s", "0.44704"),
        ("1", "knot", "km/h", "1.852"),
        ("6", "rpm/s", "°/s²", "36"),
        ("1", "lb", "kg", "0.45359237"),
        ("16", "oz", "lb", "1"),
        ("1", "lbf", "N", "4.4482216152605"),
        ("760", "Torr", "atm", "1"),
        ("1", "mmHg", "Pa", "133.322387415"),
        ("1", "inHg", "mmHg", "25.4"),
        ("1", "gal", "L", "3.785411784"),
        ("1", "cfm", "L/s", "28.316846592/60"),
        ("1", "gpm", "L/min", "3.785411784"),
        ("1", "t/h", "kg/h", "1000"),
        ("1", "g/cm3", "kg/m³", "1000"),
        ("1", "mg/L", "g/m³", "1"),
        ("1", "µg/m³", "mg/m³", "1/1000"),
        ("1", "mS/cm", "µS/cm", "1000"),
        ("1", "°C/min", "K/s", "1/60"),
        ("1", "hp", "W", "745.69987158227022"),
        ("1", "MVAh", "kVAh", "1000"),
        ("1", "MJ", "kWh", "1/3.6"),
        ("1", "ppm", "ppb", "1000"),
    ],
)
def test_a_unit_is_converted_exactly(number: str, symbol: str, other: str, expected: str) -> None:
    above, _, below = expected.partition("/")
    assert unit(symbol).in_unit(Decimal(number), unit(other)) == Fraction(above) / Fraction(below or "1")


def test_one_psi_has_the_pascals_of_its_definition() -> None:
    assert unit("psi").in_unit(Decimal(1), unit("Pa")) == Fraction("4.4482216152605") / Fraction("0.0254") ** 2
