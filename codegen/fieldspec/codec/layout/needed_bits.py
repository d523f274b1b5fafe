"""The fields of bits that must not be omitted: their 0 is not the quantity 0, or is not permitted."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.enums import Bit, Enum, Flags


@dataclass(frozen=True, slots=True)
class NeededBit:
    """A field of bits that has to be given, and why. Any of `bits` gives it: itself, and other meanings of its bits."""

    bit: Bit
    reason: str
    bits: tuple[Bit, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """The names of which one has to be given."""
        return tuple(bit.name for bit in self.bits)


def needed_bits(word: Flags, enums: Mapping[str, Enum]) -> tuple[NeededBit, ...]:
    """The fields of bits that have to be given whenever a word is put together from its bits."""
    reasons = ((bit, bit.reason_to_give(enums.get(bit.enum))) for bit in word.bits)
    return tuple(
        NeededBit(bit, reason, tuple(member for member in word.bits if member.mask & bit.mask and not member.reserved))
        for bit, reason in reasons
        if reason
    )
