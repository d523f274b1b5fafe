"""The arithmetic of addresses and ranges in the checks agrees with sets of numbers."""

from __future__ import annotations

from itertools import combinations, pairwise

from hypothesis import given
from hypothesis import strategies as st

from fieldspec.language.checks.finding import enumeration, longest_ascent, missing, near
from fieldspec.language.model.ranges import Ranges, merged, uncovered

small = st.integers(min_value=-8, max_value=24)
interval = st.tuples(small, small).map(sorted).map(tuple)
intervals = st.lists(interval, max_size=5).map(tuple)


def numbers(pairs: tuple[tuple[int, int], ...] | list[tuple[int, int]]) -> set[int]:
    return {number for low, high in pairs for number in range(low, high + 1)}


@given(intervals, st.lists(small))
def test_missing_values_are_those_of_the_range_that_are_not_taken(
    pairs: tuple[tuple[int, int], ...], have: list[int]
) -> None:
    assert numbers(missing(Ranges(pairs), have)) == numbers(pairs) - set(have)


@given(intervals)
def test_merged_intervals_hold_the_same_numbers_and_do_not_touch(pairs: tuple[tuple[int, int], ...]) -> None:
    joined = merged(pairs)
    assert numbers(joined) == numbers(pairs)
    assert all(before[1] + 1 < behind[0] for before, behind in pairwise(joined))


@given(interval, intervals)
def test_free_addresses_are_those_that_nothing_takes(
    extent: tuple[int, int], taken: tuple[tuple[int, int], ...]
) -> None:
    assert numbers(uncovered(*extent, merged(taken))) == numbers([extent]) - numbers(taken)


@given(st.lists(small, max_size=9))
def test_longest_ascent_leaves_out_as_few_as_possible(sequence: list[int]) -> None:
    ascent = [sequence[index] for index in sorted(longest_ascent(sequence))]
    assert ascent == sorted(ascent)
    more = combinations(sequence, len(ascent) + 1)
    assert not any(list(other) == sorted(other) for other in more)


def test_long_lists_are_cut() -> None:
    assert enumeration(["a"]) == "a"
    assert enumeration("abc") == "a, b and c"
    assert enumeration("abcdefgh") == "a, b, c, d, e and 3 more"


def test_hint_does_not_depend_on_the_order_of_a_set() -> None:
    assert near("spedd", {"speed", "force"}) == "did you mean `speed`?"
    assert near("x", {"speed", "force", "angle"}) == "choose from `angle`, `force` and `speed`"
