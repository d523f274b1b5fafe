"""Counts to quantities in their units and back, in LREAL: a count out of range is read with a mark, and never sent."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction as Ratio

from fieldspec.language.model.value import Conversion as Share
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.quantities import Quantity, quantities
from fieldspec.targets.controllers.routines.remarks import count_of
from fieldspec.targets.controllers.routines.stated import is_special, outside_stated
from fieldspec.targets.controllers.routines.world import PREFIXES, World
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    LREAL,
    Elementary,
    Expression,
    Fraction,
    Operation,
    Whole,
    either,
    every,
    outside,
)
from fieldspec.targets.controllers.statements.numbers import whole_type
from fieldspec.targets.controllers.statements.routine import Assignment, Condition, Routine

# A double has no halves beyond this.
_WHOLE_ONLY = 1 << 52

_ZERO = Fraction("0.0")

OUT_OF_RANGE = "xOutOfRange"
"""The output of functions that says whether a number that was read is outside of its stated range."""


def scaling_routines(world: World) -> Iterator[Routine]:
    """The functions from counts to quantities and back, also of conversions by a reference."""
    for name, same in quantities(world.layout).items():
        yield _from_counts(world, name, same)
        yield _to_counts(world, name, same)
    for share in world.layout.device.conversions.values():
        yield _share_from_counts(world, share)
        yield _share_to_counts(world, share)


def _digits(number: Ratio | int) -> Fraction:
    """A whole number as a literal of LREAL."""
    return Fraction(f"{int(number)}.0")


def times(value: Expression, ratio: Ratio) -> Expression:
    """A product with a ratio: multiplied and divided by whole numbers, which rounds less than a decimal factor."""
    above, below = ratio.numerator, ratio.denominator
    product = value if above == 1 else value.combined("*", _digits(above))
    return product if below == 1 else product.combined("/", _digits(below))


def _about(world: World, same: list[Quantity], direction: str) -> list[str]:
    first = same[0]
    owners = ", ".join(dict.fromkeys(quantity.owner for quantity in same if quantity.owner != quantity.name))
    ranges, write_ranges = first.value.ranges, first.value.write_ranges
    return [
        f"{direction}: 1 count = {count_of(first.value)}.",
        f"Counts: {ranges.text()}." if ranges is not None else "",
        f"Counts that may be written: {write_ranges.text()}." if write_ranges is not None else "",
        f"Of {owners}. {world.comment(first.fact, None)}" if owners else world.comment(first.fact, None),
        " ".join(f"{sentinel.text} is {sentinel.name}, no quantity." for sentinel in first.value.sentinels),
    ]


def _from_counts(world: World, name: str, same: list[Quantity]) -> Routine:
    first = same[0]
    draft = Draft(world, world.routine(name, "from_counts"), "scaling", *_about(world, same, "Counts to quantity"))
    counts = draft.declare(f"{PREFIXES[first.kind.name]}Counts", first.kind, "input")
    value = draft.declare("lrValue", LREAL, "output", f"in {first.value.unit}" if first.value.unit else "")
    draft.add([Assignment(value, _ZERO)])
    _marked(draft, counts_out_of_range(world, same, counts))
    if first.value.sentinels:
        draft.refuse(is_special(first.value, counts, first.kind), "out_of_range")
    scaled = times(counts.converted(LREAL), Ratio(first.value.scale))
    draft.add([Assignment(value, _plus(scaled, Ratio(first.value.offset)))])
    return draft.finished()


def counts_out_of_range(world: World, same: list[Quantity], counts: Expression) -> Expression | None:
    """Whether counts of one function are out of range; None where they cannot be, and its output is not there."""
    read = next((quantity for quantity in same if not quantity.trigger), same[0])
    return outside_stated(world, read.answer or read.value, read.trigger, counts)


def _marked(draft: Draft, wrong: Expression | None) -> None:
    """Adds the output that says whether what was read is out of range; none where it cannot be."""
    if wrong is not None:
        draft.add([Assignment(draft.declare(OUT_OF_RANGE, BOOL, "output"), wrong)])


def _plus(value: Expression, term_value: Ratio) -> Expression:
    """A sum with an exact number, which is divided where it is not a whole number."""
    if not term_value:
        return value
    whole = _digits(abs(term_value.numerator))
    term = whole if term_value.denominator == 1 else whole.combined("/", _digits(term_value.denominator))
    return value.combined("+" if term_value > 0 else "-", term)


def _to_counts(world: World, name: str, same: list[Quantity]) -> Routine:
    first = same[0]
    draft = Draft(
        world,
        world.routine(name, "to_counts"),
        "scaling",
        *_about(world, same, "Quantity to the nearest count, of two equally near ones the even one"),
    )
    value = draft.declare("lrValue", LREAL, "input", f"in {first.value.unit}" if first.value.unit else "")
    shifted = _plus(value, -Ratio(first.value.offset))
    sendable = first.value.for_writing().quantity_intervals
    _rounded(draft, times(shifted, 1 / Ratio(first.value.scale)), first.kind, sendable)
    return draft.finished()


def _rounded(draft: Draft, count: Expression, kind: Elementary, intervals: Iterable[tuple[int, int]]) -> None:
    """Adds the statements that round a number to a count in the intervals, however the dialect converts."""
    bounds = sorted(intervals)
    low, high = bounds[0][0], bounds[-1][1]
    counts = draft.declare(f"{PREFIXES[kind.name]}Counts", kind, "output")
    exact, rest = draft.local("lrCount", LREAL), draft.local("lrRest", LREAL)
    draft.add([Assignment(counts, Whole(0, kind)), Assignment(exact, count)])
    above_low = exact.compared(">=", _digits(low)) if -low > _WHOLE_ONLY else exact.compared(">", _half(low, -1))
    below_high = exact.compared("<", _digits(high + 1)) if high > _WHOLE_ONLY else exact.compared("<", _half(high, 1))
    draft.refuse(every([above_low, below_high]).negated(), "out_of_range")
    whole = draft.local(f"{PREFIXES[kind.name]}Whole", kind)
    odd = whole.combined("MOD", 2).compared("<>", 0)
    half, less = Fraction("0.5"), Fraction("-0.5")
    up = either([rest.compared(">", half), every([rest.compared("=", half), odd])])
    down = either([rest.compared("<", less), every([rest.compared("=", less), odd])])
    unit = Whole(1, kind)
    draft.add(
        [
            Assignment(whole, exact.converted(kind)),
            Assignment(rest, exact.combined("-", whole.converted(LREAL))),
            Condition(
                (
                    (up, (Assignment(whole, whole.combined("+", unit)),)),
                    (down, (Assignment(whole, whole.combined("-", unit)),)),
                )
            ),
        ]
    )
    wrong = outside(whole, bounds) if len(bounds) > 1 else None
    if wrong is not None:
        draft.refuse(wrong, "out_of_range")
    draft.add([Assignment(counts, whole)])


def _half(bound: int, sign: int) -> Fraction:
    """A bound and half a count beyond it, as a literal."""
    twice = 2 * bound + sign
    minus = "-" if twice < 0 else ""
    return Fraction(f"{minus}{abs(twice) // 2}.5")


def _share_bounds(world: World, share: Share) -> tuple[int, int]:
    """The least and the greatest count that one of a conversion's signals may have."""
    ranges = [world.layout.device.signals[name].value.ranges for name in share.signals]
    known = [ranges for ranges in ranges if ranges is not None]
    if not known or len(known) < len(ranges):
        return share.type.low, share.type.high
    return max(share.type.low, min(ranges.low for ranges in known)), min(
        share.type.high, max(ranges.high for ranges in known)
    )


def _share_about(world: World, share: Share) -> list[str]:
    full = f"{share.full_scale}"
    formula = f"reference * (1 - counts / {full})" if share.complement else f"reference * counts / {full}"
    return [
        f"{share.title or share.name} = {formula}. {world.comment(share, None)}".strip(),
        f"For {', '.join(share.signals)}." if share.signals else "",
        f"The reference is {' or '.join(share.references)}." if share.references else "",
    ]


def _share_kind(share: Share) -> Elementary:
    return whole_type(share.type.encoding)


def _share_from_counts(world: World, share: Share) -> Routine:
    kind = _share_kind(share)
    draft = Draft(world, world.routine(share.name, "from_counts"), "scaling", *_share_about(world, share))
    counts = draft.declare(f"{PREFIXES[kind.name]}Counts", kind, "input")
    reference = draft.declare("lrReference", LREAL, "input", "in the unit of the quantity")
    value = draft.declare("lrValue", LREAL, "output")
    draft.add([Assignment(value, _ZERO)])
    _marked(draft, outside(counts, [_share_bounds(world, share)]))
    part: Expression = counts.converted(LREAL).combined("/", _digits(share.full_scale))
    if share.complement:
        part = _digits(1).combined("-", part)
    draft.add([Assignment(value, reference.combined("*", part))])
    return draft.finished()


def _share_to_counts(world: World, share: Share) -> Routine:
    kind = _share_kind(share)
    draft = Draft(
        world,
        world.routine(share.name, "to_counts"),
        "scaling",
        *_share_about(world, share),
        "The nearest count, of two equally near ones the even one; a reference of 0 is refused.",
    )
    value = draft.declare("lrValue", LREAL, "input")
    reference = draft.declare("lrReference", LREAL, "input", "in the unit of the quantity")
    zero = [reference.compared("<", _ZERO), reference.compared(">", _ZERO)]
    draft.refuse(Operation("OR", tuple(zero), BOOL).negated(), "out_of_range")
    part: Expression = value.combined("/", reference)
    if share.complement:
        part = _digits(1).combined("-", part)
    exact = part.combined("*", _digits(share.full_scale))
    _rounded(draft, exact, kind, [_share_bounds(world, share)])
    return draft.finished()
