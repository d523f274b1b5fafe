"""Units: those that the language has, those that a spec declares, and exact conversions between them."""

from __future__ import annotations

from functools import cache

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.fact import Fact
from fieldspec.language.schema import built_in_units

if TYPE_CHECKING:
    from decimal import Decimal
    from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit by its `symbol`. `quantity` is what it measures, in words, as `volume_flow_rate`; `ucum` its UCUM code.

    A number in the unit, times `factor`, plus `offset`, is the number in the coherent SI unit of the quantity. Both are
    texts: `1/60000`, `pi/180`, `273.15`. The factor is empty where there is none. `others` are further symbols that
    people write for it, `word` its suffix in names.
    """

    symbol: str
    title: str
    quantity: str
    ucum: str = ""
    factor: str = ""
    offset: str = "0"
    others: tuple[str, ...] = ()
    word: str = ""

    @property
    def ascii_symbol(self) -> str:
        """A symbol with only ASCII characters: `degC`."""
        return next((symbol for symbol in (self.symbol, *self.others) if symbol.isascii()), self.word)

    def in_unit(self, number: Decimal, unit: Unit) -> Fraction | None:
        """A number in this unit as a number in another one; None if they do not measure the same, or not exactly."""
        from fractions import Fraction

        if unit.symbol == self.symbol:
            return Fraction(number)
        if not (self.quantity and self.quantity == unit.quantity and self.factor and unit.factor):
            return None
        (above, turning), (below, turning_below) = _exact_factor(self.factor), _exact_factor(unit.factor)
        if turning != turning_below or not below:
            return None
        return (Fraction(number) * above + Fraction(self.offset) - Fraction(unit.offset)) / below


@dataclass(frozen=True, slots=True, kw_only=True)
class DeclaredUnit(Fact):
    """A unit that a spec declares, with the attributes of `Unit`."""

    symbol: str
    title: str
    quantity: str
    ucum: str
    factor: str

    @property
    def unit(self) -> Unit:
        """The declared unit as conversions take it, without its place."""
        return Unit(self.symbol, self.title, self.quantity, self.ucum, self.factor, word=self.name)


def _exact_factor(text: str) -> tuple[Fraction, bool]:
    """A factor as an exact number, and whether it is to be multiplied by pi."""
    from fractions import Fraction

    above, _, below = text.partition("/")
    terms = above.split("*")
    number = Fraction(1)
    for term in terms:
        number *= 1 if term == "pi" else Fraction(term)
    return number / Fraction(below or "1"), "pi" in terms


@cache
def standard_units() -> dict[str, Unit]:
    """The units that the language has, by their symbols."""
    return {
        row["symbol"]: Unit(
            symbol=row["symbol"],
            title=row["title"],
            quantity=row["quantity"],
            ucum=row.get("ucum", ""),
            factor=row.get("factor", ""),
            offset=row.get("offset", "0"),
            others=tuple(row.get("also", ())),
            word=row.get("word", ""),
        )
        for row in built_in_units()
    }


@cache
def standard_unit(text: str) -> Unit | None:
    """The unit of the language with a symbol, or with another symbol that people write for it."""
    known = standard_units()
    return known.get(text) or next((unit for unit in known.values() if text in unit.others), None)
