"""Numbers that routines call by a name, which each declares as a constant: codes and sizes, addresses, masks, errors.

The last word of a name says what it is, so that no two kinds have the same, and none is a word of a language.
"""

from __future__ import annotations

from fieldspec.foundation.names import Name
from fieldspec.language.model.enums import Bit
from fieldspec.targets.controllers.statements.expressions import INT, Elementary, Whole


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
