"""Decides for a whole list what its cells leave open: how a gain is used, what bounds are in, the unit of lengths."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.primitives import PRIMITIVES
from fieldspec.tools.lists.assumption import Assumption
from fieldspec.tools.lists.words import folded, words

MULTIPLY, DIVIDE = "multiply", "divide"
COUNTS, UNIT = "counts", "unit"
_OPTION = "--gain multiply or --gain divide"
LENGTHS = {"words": 1, "bytes": 2, "bits": 16}
"""The units of lengths, with their number in a word."""


@dataclass(frozen=True, slots=True)
class Measured:
    """The statements of a row about a number: the factor of its scale, its bounds, and the name of its type."""

    row: int
    factor: Fraction
    low: Decimal
    high: Decimal
    type: str

    def counts(self, factor: Fraction) -> bool:
        """Whether the bounds divided by a factor are whole counts that the type has."""
        kind = PRIMITIVES[self.type]
        if factor == 1 and any("." in str(bound) for bound in (self.low, self.high)):
            return False  # nobody writes counts with a fraction
        ends = [Fraction(bound) / factor for bound in (self.low, self.high)]
        return is_count(kind.encoding) and all(end.denominator == 1 and kind.low <= end <= kind.high for end in ends)


def gain_direction(
    heading: str,
    role: str,
    factors: Sequence[Fraction],
    measured: Sequence[Measured],
    coarse: int,
    fraction: str,
    stated: str,
) -> tuple[str, Assumption | None]:
    """Whether factors multiply or divide counts, and what was assumed; empty where the evidence is equal.

    `coarse` is the number of rows that would count in steps of ten volts, or the like, if their factors multiplied,
    `fraction` a cell such as `1/10` of the same column, which multiplies.
    """
    if stated or role == "divisor":
        return stated or DIVIDE, None
    other_factors = [factor for factor in factors if factor != 1]
    if not other_factors:
        return MULTIPLY, None
    proofs, (direction, evidence) = _proved(measured, role == "gain", coarse, fraction)
    if direction:
        return direction, Assumption(heading, _direction(direction), evidence, _OPTION)
    if proofs[DIVIDE] or (role == "gain" and min(other_factors) < 1 < max(other_factors)):
        return "", Assumption(
            heading, "open whether counts are multiplied or divided", "the evidence is equal", _OPTION
        )
    if role == "gain":
        direction = DIVIDE if min(other_factors) > 1 else MULTIPLY
        evidence = (
            "all factors are 1 or more, as of counts for a unit" if direction == DIVIDE else "all factors are 1 or less"
        )
        return direction, Assumption(heading, _direction(direction), evidence, _OPTION)
    evidence = "the heading; no bounds prove it" if max(other_factors) > 1 else "all factors are 1 or less"
    return MULTIPLY, Assumption(heading, _direction(MULTIPLY), evidence, _OPTION)


def _proved(
    measured: Sequence[Measured], is_gain: bool, coarse: int, fraction: str = ""
) -> tuple[Counter[str], tuple[str, str]]:
    """How many rows prove each direction, and the direction that is proved, with the evidence; empty for none."""
    proofs = Counter(proof for entry in measured for proof in _proofs(entry, is_gain))
    for direction, other in ((DIVIDE, MULTIPLY), (MULTIPLY, DIVIDE)):
        if proofs[direction] and not proofs[other]:
            evidence = f"the bounds of {proofs[direction]} rows are whole counts that their types have in no other way"
            return proofs, (direction, evidence)
    if fraction:
        return proofs, (MULTIPLY, f"`{fraction}` in the same column")
    if coarse and not proofs:
        return proofs, (DIVIDE, f"{coarse} rows would count in steps of ten units or more that are measured in less")
    return proofs, ("", "")


def times_direction(
    example: str, measured: Sequence[Measured], coarse: int, stated: str
) -> tuple[str, Assumption | None]:
    """The same for factors after a multiplication sign, as in `V x 10`, which are not used without evidence."""
    if stated:
        return stated, None
    _, (direction, evidence) = _proved(measured, True, coarse)
    reading = _direction(direction) if direction else "not used"
    evidence = evidence or "the factor is counts per unit, or units per count"
    return direction, Assumption(f"`{example}`", reading, evidence, _OPTION)


def _direction(direction: str) -> str:
    return (
        "quantity = count \u00d7 factor (multiply)" if direction == MULTIPLY else "quantity = count ÷ factor (divide)"
    )


def _proofs(measured: Measured, is_gain: bool) -> Iterator[str]:
    """The direction that the bounds of a row prove: bounds in the unit are whole counts in one direction alone.

    Whole bounds may be counts themselves, which proves nothing beside a heading that says how the factor is used.
    """
    if measured.factor == 1 or (measured.counts(Fraction(1)) and not is_gain):
        return
    multiplied, divided = measured.counts(measured.factor), measured.counts(1 / measured.factor)
    if multiplied != divided:
        yield MULTIPLY if multiplied else DIVIDE


def bounds_unit(measured: Sequence[Measured], in_unit: str, stated: str) -> tuple[str, Assumption | None]:
    """Whether bounds and defaults beside a scale are counts or in the unit; `in_unit` is evidence for it."""
    scaled = [entry for entry in measured if entry.factor != 1]
    if stated or not scaled:
        return stated or COUNTS, None
    either = {(entry.row, entry.counts(Fraction(1)), entry.counts(entry.factor)) for entry in scaled}
    unit = len({row for row, *proof in either if proof == [False, True]})
    counts = len({row for row, *proof in either if proof == [True, False]})
    fine = [entry for entry in scaled if entry.low != entry.high and is_count(PRIMITIVES[entry.type].encoding)]
    is_narrow = bool(fine) and all(Fraction(entry.high - entry.low) * entry.factor < 1 for entry in fine)
    direction = UNIT if (unit or in_unit or is_narrow) and not counts else COUNTS
    if direction == UNIT and unit:
        evidence = f"{unit} rows contain no counts of their types"
    elif direction == UNIT:
        evidence = in_unit or "as counts, they are less than one of the unit apart"
    elif counts and not unit:
        evidence = f"only so, {counts} rows contain whole counts"
    else:
        evidence = "nothing shows which"
    subject = "bounds" if any(entry.low != entry.high for entry in scaled) else "defaults"
    reading = "in counts" if direction == COUNTS else "in the unit"
    return direction, Assumption(f"{subject} beside a scale", reading, evidence, "--bounds")


def length_unit(heading: str, sizes: Sequence[tuple[int, int, int]], stated: str) -> tuple[str, Assumption | None]:
    """The unit of lengths. `sizes` has each row's length, the words of its type and those to the next address, or 0."""
    if stated or not sizes:
        return stated or "words", None
    matches = Counter(
        name
        for length, size, gap in sizes
        for name, factor in LENGTHS.items()
        if length == (size or gap) * factor and (size or gap)
    )
    own_words = words("lengths")
    stated_unit = next((name for name in LENGTHS if any(word in folded(heading) for word in own_words[name])), "")
    ranked = matches.most_common(2)
    likely = ranked[0][0] if ranked and (len(ranked) == 1 or ranked[0][1] > ranked[1][1]) else ""
    fits = [name for name in LENGTHS if all(not gap or length <= gap * LENGTHS[name] for length, _, gap in sizes)]
    if len(fits) == 1 and not stated_unit and not likely:
        return fits[0], Assumption(heading, f"lengths in {fits[0]}", "others overlap the next addresses", "--length")
    direction = stated_unit or likely or "words"
    if direction == "words" and not (stated_unit and likely and stated_unit != likely):
        return direction, None
    if stated_unit and likely and stated_unit != likely:
        evidence = f"the heading; {matches[likely]} rows have their types or neighbours as if they were {likely}"
    else:
        evidence = "the heading" if stated_unit else f"the types or neighbours of {matches[direction]} rows"
    return direction, Assumption(heading, f"lengths in {direction}", evidence, "--length")
