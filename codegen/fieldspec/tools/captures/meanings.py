"""What numbers mean, as columns: the verdicts on many numbers of a value, and their names, at once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import partial

import numpy as np
import numpy.typing as npt

from fieldspec.codec.explain.values import bit_name, shows_bit
from fieldspec.codec.layout.accepted import (
    Equals,
    Fits,
    HasCharacters,
    HasDigits,
    IsBit,
    Known,
    PartWithin,
    RealWithin,
    Test,
    Within,
    accepted,
)
from fieldspec.foundation.exhaustive import assert_never
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Flags
from fieldspec.language.model.value import Value
from fieldspec.tools.captures.columns import Mask, Numbers, Texts, Verdicts
from fieldspec.tools.captures.text_list import TextList
from fieldspec.tools.captures.verdicts import OK, UNLISTED_BITS, UNLISTED_MEMBER, VERDICT_NUMBERS, WRONG_CONST

Counts = Numbers | npt.NDArray[np.int64] | npt.NDArray[np.uint64]
Verdicts = Verdicts

SEGMENT = 8
"""The bits of a word that are named at once, as far as they are not of one field."""


class Meanings:
    """The meanings of a value's numbers, as in an explanation of a frame."""

    def __init__(self, device: Device, value: Value, texts: TextList) -> None:
        conditions = accepted(device, value)
        self.conditions = (*conditions.reading, *conditions.remarked)
        self.value, self.texts = value, texts
        self.sentinels = () if value.const is not None else tuple(own for own in value.sentinels if not own.is_nan)
        self.listing = BitListing(device, device.flags[value.flags]) if value.flags else None
        names = (
            {member.value: member.name for member in reversed(device.enums[value.enum].members)} if value.enum else {}
        )
        self.members = sorted(names)
        self.names = [names[number] for number in self.members]

    def of(self, numbers: Counts) -> tuple[Texts, Verdicts, Mask]:
        """The texts, the verdicts, and whether there is a quantity."""
        verdicts = np.full(len(numbers), OK, np.int8)
        for condition in self.conditions:
            verdicts[(verdicts == OK) & ~passing(condition.test, numbers)] = VERDICT_NUMBERS[condition.reason]
        texts = np.full(len(numbers), -1, np.int32)
        has_quantity = np.full(len(numbers), not self.value.enum and self.listing is None, np.bool_)
        is_named = verdicts != WRONG_CONST
        state = self._states(numbers)
        own = np.flatnonzero(state < 0) if self.sentinels else slice(None)
        if self.listing is not None:
            texts[own], verdicts[own] = self._of_bits(numbers[own], is_named[own], verdicts[own])
        elif self.value.enum:
            texts[own], verdicts[own] = self._members(numbers[own], is_named[own], verdicts[own])
        if self.sentinels:
            places = np.array([self.texts.place(sentinel.name) for sentinel in self.sentinels], np.int32)
            texts[state >= 0] = places[state[state >= 0]]
            has_quantity[state >= 0] = False
        return texts, verdicts, has_quantity

    def _states(self, numbers: Counts) -> npt.NDArray[np.int64]:
        """The index of the first sentinel for each number; -1 for other numbers."""
        result = np.full(len(numbers), -1, np.int64)
        for place in reversed(range(len(self.sentinels))):
            result[is_in(numbers, (self.sentinels[place].interval,))] = place
        return result

    def _members(self, numbers: Counts, is_named: Mask, verdicts: Verdicts) -> tuple[Texts, Verdicts]:
        texts = np.full(len(numbers), -1, np.int32)
        limits = np.iinfo(numbers.dtype)
        known = [place for place, number in enumerate(self.members) if limits.min <= number <= limits.max]
        if known:
            members = np.array([self.members[place] for place in known], numbers.dtype)
            places = np.array([self.texts.place(self.names[place]) for place in known], np.int32)
            nearest = np.minimum(np.searchsorted(members, numbers), len(members) - 1)
            texts = np.where((members[nearest] == numbers) & is_named, places[nearest], texts)
        return texts, np.where((verdicts == OK) & (texts < 0), UNLISTED_MEMBER, verdicts).astype(np.int8)

    def _of_bits(self, numbers: Counts, is_named: Mask, verdicts: Verdicts) -> tuple[Texts, Verdicts]:
        assert self.listing is not None
        words = np.where(is_named, numbers, 0).astype(numbers.dtype).view(np.uint64)
        names = self.listing.texts(words)
        texts = np.array([self.texts.place(text) for text in names], np.int32).reshape(len(numbers))
        texts[~is_named] = self.texts.place("")
        is_unlisted = (words & np.uint64(self.listing.unlisted)) != 0
        return texts, np.where((verdicts == OK) & is_unlisted, UNLISTED_BITS, verdicts).astype(np.int8)


class BitListing:
    """The names of the bits of words: those that are set, and fields of several bits with their numbers."""

    def __init__(self, device: Device, word: Flags) -> None:
        self.device = device
        full = (1 << 8 * word.type.size) - 1
        self.unlisted = full & ~sum(bit.mask for bit in word.bits)
        self.segments = _segments(word.bits)
        places = [place for place in range(8 * word.type.size) if self.unlisted >> place & 1]
        self.unlisted_segments = [places[start : start + SEGMENT] for start in range(0, len(places), SEGMENT)]

    def texts(self, words: npt.NDArray[np.uint64]) -> list[str]:
        """The names in each word, joined. Each distinct value of some bits is named once."""
        columns = [
            *(_named(words, sum(bit.mask for bit in bits), partial(self._names, bits)) for bits in self.segments),
            *(_named(words, sum(1 << place for place in places), _bit_numbers) for places in self.unlisted_segments),
        ]
        return ["+".join(filter(None, names)) for names in zip(*columns, strict=True)]

    def _names(self, bits: Sequence[Bit], word: int) -> str:
        numbers = ((bit, bit.number_in(word)) for bit in bits)
        return "+".join(bit_name(self.device, bit, number) for bit, number in numbers if shows_bit(bit, number))


def _segments(bits: Iterable[Bit]) -> list[list[Bit]]:
    """Neighbouring bits of a word in groups, each of few bits or of one field."""
    result: list[list[Bit]] = []
    width = SEGMENT
    for bit in bits:
        if width + bit.width > SEGMENT:
            result.append([])
            width = 0
        result[-1].append(bit)
        width += bit.width
    return result


def _bit_numbers(word: int) -> str:
    return "+".join(f"bit_{place}" for place in range(word.bit_length()) if word >> place & 1)


def _named(words: npt.NDArray[np.uint64], mask: int, name: Callable[[int], str]) -> list[str]:
    distinct, places = np.unique(words & np.uint64(mask), return_inverse=True)
    names = [name(number) for number in distinct.tolist()]
    return [names[place] for place in places.tolist()]


def passing(test: Test, numbers: Counts) -> Mask:
    """Whether numbers pass a test of whole numbers. Raises AssertionError for a test of something else."""
    match test:
        case Equals():
            return is_in(numbers, ((test.number, test.number),))
        case IsBit():
            return is_in(numbers, ((0, 1),))
        case Known():
            return is_in(numbers, (*test.sentinels, *test.members))
        case Within():
            return is_in(numbers, (*test.sentinels, *test.intervals))
        case PartWithin():
            return is_in(numbers, test.sentinels) | is_in(_part(numbers.view(np.uint64), test.bit), test.bit.images)
        case HasDigits():
            return np.ones(len(numbers), np.bool_)  # what is not a number has none to judge
        case HasCharacters() | RealWithin() | Fits():
            raise AssertionError(f"{test} is not a test of whole numbers")
        case _:
            assert_never(test)


def _part(words: npt.NDArray[np.uint64], bit: Bit) -> npt.NDArray[np.uint64]:
    """The bits of a field in the form that its `images` have."""
    if not bit.pieces:
        masked: npt.NDArray[np.uint64] = words & np.uint64(bit.mask)
        return masked
    part = np.zeros(len(words), np.uint64)
    for run in bit.runs:
        part |= (words >> np.uint64(run.first) & np.uint64(run.most)) << np.uint64(run.weight)
    return part


def is_in(numbers: Counts, intervals: Iterable[tuple[int, int]]) -> Mask:
    """Whether numbers are in any interval. Bounds that the type of the column cannot have become the limits of the
    type.
    """
    limits = np.iinfo(numbers.dtype)
    result = np.zeros(len(numbers), np.bool_)
    for low, high in intervals:
        if high < limits.min or low > limits.max:
            continue
        bounds = numbers.dtype.type(max(low, limits.min)), numbers.dtype.type(min(high, limits.max))
        result |= (numbers >= bounds[0]) & (numbers <= bounds[1])
    return result
