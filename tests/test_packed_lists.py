"""Lists of numbers that share bytes, as others have published them and as construct packs them."""

from __future__ import annotations

from typing import Any, Literal

import construct
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fieldspec.codec.layout.packing import Packing
from fieldspec.codec.reference import codec
from fieldspec.language.model.encoding import Sign, Whole
from layouts import TEST_SPECS, newest
from python_package import link_of, module_of

SEISMOGRAPH = newest(TEST_SPECS, "seismograph")
REFERENCE = codec(SEISMOGRAPH).links["line"]
MODULE = module_of(SEISMOGRAPH)

PUBLISHED = {
    # Microsoft, FAT: General Overview of On-Disk Format 1.03: the first entries of FAT12, then two of a file.
    "F0 FF FF 03 40 00": ("read_clusters", "clusters", [0xFF0, 0xFFF, 3, 4]),
    # Modbus Application Protocol 1.1b3, 6.1: the coils 20 to 38.
    "CD 6B 05": ("read_coils", "coils", [int(bit) for bit in "1011001111010110101"]),
}


@pytest.mark.parametrize("data", PUBLISHED)
def test_published_bytes_are_read_and_written(data: str) -> None:
    message, name, numbers = PUBLISHED[data]
    frame = REFERENCE.encode("response", message, {name: numbers})
    assert bytes.fromhex(data) in frame
    assert REFERENCE.decode(frame, "response").values[name] == numbers
    own = link_of(MODULE, "line").decode_response(frame)
    assert getattr(own.message, name) == numbers
    assert link_of(MODULE, "line").encode_response(own.message) == frame


def packed_by_construct(numbers: list[int], bits: int, order: str, is_signed: bool) -> bytes:
    """What construct makes of numbers: from the first bit on, or from the last one backwards."""
    element = construct.BitsInteger(bits, signed=is_signed)
    padding = construct.Padding(-len(numbers) * bits % 8)
    items = construct.Array(len(numbers), element)
    parts = [items, padding] if order == "big" else [padding, items]
    numbers = numbers if order == "big" else numbers[::-1]
    values = [numbers if part is items else None for part in parts]
    data: bytes = construct.Bitwise(construct.Sequence(*parts)).build(values)
    return data if order == "big" else data[::-1]


@given(st.data(), st.integers(1, 31), st.sampled_from(("big", "little")), st.booleans())
def test_numbers_are_packed_as_construct_packs_them(
    data: Any, bits: int, order: Literal["big", "little"], is_signed: bool
) -> None:
    whole = Whole(bits, Sign.COMPLEMENT if is_signed else Sign.NONE)
    packing = Packing(whole, 4, order)
    numbers = data.draw(st.lists(st.integers(*whole.bounds), max_size=9))
    image = b"".join(number.to_bytes(4, order, signed=is_signed) for number in numbers)
    sent = packed_by_construct(numbers, bits, order, is_signed)
    assert packing.packed(image) == sent
    assert packing.unpacked(sent, len(numbers)) == image
