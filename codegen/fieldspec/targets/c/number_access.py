"""The functions that load the bytes of a number and store them, one for each size and order."""

from __future__ import annotations

from functools import cache

from fieldspec.language.model.encoding import MACHINE_BITS
from fieldspec.language.model.raw_numbers import byte_places
from fieldspec.targets.c.machine import machine_bits

_FUNCTIONS = """DEVICE_INLINE {word} device_load_{access}(const uint8_t *in)
{{
    return {loaded};
}}

DEVICE_INLINE void device_store_{access}(uint8_t *out, {word} value)
{{
{stores}
}}
"""
_AT_ONCE = """#ifdef DEVICE_STORES_AT_ONCE
{swap}    DEVICE_COPY(out, &value, sizeof value);
#else
{stores}
#endif"""
_ORDERS = (("big", False), ("big", True), ("little", False), ("little", True))


def access_name(size: int, order: str, swapped: bool) -> str:
    """The end of the names of functions that load and store a number: `u32_be`, `u32_be_words_le`"""
    if size == 1:
        return "u8"
    first = "be" if order == "big" else "le"
    second = ("_words_le" if order == "big" else "_words_be") if swapped else ""
    return f"u{8 * size}_{first}{second}"


@cache
def access_functions(is_odd: bool) -> dict[str, str]:
    """The functions by the end of their names, for the sizes that C has numbers of, or for the others."""
    orders = [
        (size, order, swapped)
        for size in range(1, 9)
        if (8 * size not in MACHINE_BITS) == is_odd
        for order, swapped in _ORDERS
        if not swapped or (size % 2 == 0 and size > 2)
    ]
    return {access_name(*access): _functions(*access) for access in orders}


def _functions(size: int, order: str, swapped: bool) -> str:
    """`return ((uint32_t)in[0] << 8) | (uint32_t)in[1];` and `out[0] = (uint8_t)(value >> 8);`, of each byte."""
    word = f"uint{machine_bits(8 * size)}_t"
    shifts = {byte: 8 * (size - 1 - index) for index, byte in enumerate(byte_places(size, order, swapped))}
    stores = "\n".join(f"    out[{byte}] = {_cast(word, shifts[byte])};" for byte in range(size))
    if 8 * size in MACHINE_BITS and size > 1 and not swapped:
        swap = f"    value = __builtin_bswap{8 * size}(value);\n" if order == "big" else ""
        stores = _AT_ONCE.format(swap=swap, stores=stores)
    return _FUNCTIONS.format(
        word=word, access=access_name(size, order, swapped), loaded=_loaded(word, shifts), stores=stores
    )


def _cast(word: str, shift: int) -> str:
    """A byte of `value`; of a number of one byte it is the number."""
    if word == "uint8_t":
        return "value"
    return f"(uint8_t)(value >> {shift})" if shift else "(uint8_t)value"


def _loaded(word: str, shifts: dict[int, int]) -> str:
    """The number in the bytes of `in`, two bytes in a line. C computes with narrow numbers as with int."""
    if word == "uint8_t":
        return "in[0]"
    wide = "uint64_t" if word == "uint64_t" else "uint32_t"
    bytes_in_order = [
        f"(({wide})in[{byte}] << {shifts[byte]})" if shifts[byte] else f"({wide})in[{byte}]" for byte in sorted(shifts)
    ]
    lines = [" | ".join(bytes_in_order[first : first + 2]) for first in range(0, len(bytes_in_order), 2)]
    number = " |\n           ".join(lines)
    return f"(uint16_t)({number})" if word == "uint16_t" else number
