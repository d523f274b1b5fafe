"""Single bits and fields of bits as the reference codec has them, in both ways in which manuals number bits."""

from __future__ import annotations

from fieldspec.language.model.enums import Bit, Flags


def bits_of_word(word: Flags, number: int) -> list[int]:
    """The bits of a number as zeros and ones, the least significant first."""
    return [number >> place & 1 for place in range(8 * word.type.size)]


def printed_number(word: Flags, place: int) -> int:
    """The number that the manual prints for the bit at a place, of which 0 is the least significant."""
    return 8 * word.type.size - 1 - place if word.bit_0 == "most" else place


def bit_places(bit: Bit) -> list[int]:
    """The places in a word of the bits of a number, the least significant first."""
    pieces = bit.pieces or ((bit.first, bit.last),)
    return [place for first, last in pieces for place in range(first, last + 1)]


def number_of_bits(word: Flags, bit: Bit, number: int) -> int:
    """The number in a field of bits, of which the first one is the least significant; below zero where it is signed."""
    all_bits = bits_of_word(word, number)
    bits = [all_bits[place] for place in bit_places(bit)]
    weights = [1 << place for place in range(len(bits))]
    if bit.signed:
        weights[-1] = -weights[-1]
    return sum(weight for weight, is_set in zip(weights, bits, strict=True) if is_set)


def unlisted_bits(word: Flags, number: int) -> list[int]:
    """The places of the bits that are 1 and that the spec does not list."""
    known_places = {place for bit in word.bits for place in bit_places(bit)}
    return [place for place, is_set in enumerate(bits_of_word(word, number)) if is_set and place not in known_places]
