"""Numbers that routines call by a name, which each declares as a constant: codes and sizes, addresses, masks, errors.

The last word of a name says what it is, so that no two kinds have the same, and none is a word of a language.
"""

from __future__ import annotations

from fieldspec.foundation.names import Name
from fieldspec.language.model.enums import Bit
from fieldspec.targets.controllers.statements.expressions import INT, Elementary, Expression, Operation, Shift, Whole


def named(value: int, kind: Elementary, *words: str, hexadecimal: bool = False) -> Whole:
    """A number with a name of some words."""
    name = Name(())
    for word in words:
        name += Name.of(word)
    return Whole(value, kind, hexadecimal, name.upper())


def size_of(record: str, word: str, size: int) -> Whole:
    """The bytes of the data of a record, as a bound or as they are; 0 needs no name."""
    return named(size, INT, record, word) if size else Whole(0, INT)


def mask_of(bit: Bit, kind: Elementary) -> Whole:
    """The mask of a bit, or of a field of several, in its word: `MOTION_STATUS_MOVING_MASK`"""
    word, name = bit.place.path.split("/")[-2:]
    return named(bit.mask, kind, word, name, "mask", hexadecimal=True)


def image_of(bit: Bit, word: Expression, kind: Elementary) -> Expression:
    """The bits of a field in a word of a type of bits, in the form that its `images` have."""
    return joined_bits(bit, word, kind) if bit.pieces else word.combined("AND", bit.mask)


def joined_bits(bit: Bit, word: Expression, kind: Elementary) -> Expression:
    """The bits of a field in a word of a type of bits, beside each other, where they lie apart."""
    parts: list[Expression] = []
    for run in bit.runs:
        masked = word.combined("AND", Whole(run.most << run.first, kind, True))
        moved = run.weight - run.first
        parts.append(Shift("SHL" if moved > 0 else "SHR", masked, abs(moved), kind) if moved else masked)
    return Operation("OR", tuple(parts), kind)
