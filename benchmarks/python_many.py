"""Many frames of telegram 111 at once: columns with NumPy and with nothing but Python, against C and struct."""

from __future__ import annotations

import ctypes
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from struct import Struct

import numpy
from rows import Row, printed, timed, use_generated

use_generated()

GROUP = "Python, many frames"
FRAME = bytes.fromhex("04 BF 91 00 00 07 00 00 00 00 FF FF CF C7 10 00 20 00 00 00 00 00 00 00")
NUMBER = 1_000_000
SOME = 100_000
STRUCT = Struct(">HHHHHiiHH2x")
SOURCE = Path(__file__).parent / "peers" / "columns.c"


def by_hand() -> ctypes.CDLL:
    """The loops in C, compiled with -O3."""
    with tempfile.TemporaryDirectory() as folder:
        library = Path(folder) / "columns.so"
        subprocess.run(["gcc", "-O3", "-shared", "-fPIC", "-o", library, SOURCE], check=True)
        return ctypes.CDLL(str(library))


def pointer(column: numpy.ndarray) -> ctypes.c_void_p:
    """Where a column lies."""
    return ctypes.c_void_p(column.ctypes.data)


def rows() -> Iterator[Row]:
    """The rows."""
    from fieldspec_devices.hiwin_e.v2_14_4 import StatusWord1Positioning, Telegram111Response
    from fieldspec_devices.many import arrays, bits, decode_many, records, view

    data, some = FRAME * NUMBER, FRAME * SOME
    library = by_hand()
    columns = decode_many(Telegram111Response, data)

    def in_c() -> list[numpy.ndarray]:
        columns_out = [numpy.empty_like(column) for column in columns.values()]
        library.columns(data, ctypes.c_size_t(NUMBER), *map(pointer, columns_out))
        return columns_out

    words = columns["status_word_1"]
    masks = [1 << (bit % 16) for bit in range(40)]
    named = type("Word", (StatusWord1Positioning,), {"_BITS": {str(at): (at % 16, 1) for at in range(40)}})

    def bits_in_c() -> list[numpy.ndarray]:
        bit_arrays = [numpy.empty(NUMBER, bool) for _ in masks]
        for mask, bits_out in zip(masks, bit_arrays, strict=True):
            library.bits(pointer(words), ctypes.c_size_t(NUMBER), ctypes.c_uint16(mask), pointer(bits_out))
        return bit_arrays

    copied = bytearray(data)
    assert all((left == other).all() for left, other in zip(in_c(), columns.values(), strict=True))
    assert all((left == other).all() for left, other in zip(bits_in_c(), bits(named, words).values(), strict=True))
    version = f"numpy {numpy.__version__}"
    yield timed(GROUP, f"columns, {version}", lambda: decode_many(Telegram111Response, data), "a loop in C, gcc -O3",
                in_c, at_most=1.5)  # fmt: skip
    yield timed(GROUP, f"native records, {version}", lambda: records(Telegram111Response, data), "memcpy",
                lambda: copied.__setitem__(slice(None), data), at_most=3.6)  # fmt: skip
    yield timed(GROUP, f"a view of {NUMBER} frames", lambda: view(Telegram111Response, data), "of one frame",
                lambda: view(Telegram111Response, FRAME), at_most=1.1)  # fmt: skip
    yield timed(GROUP, f"40 columns of booleans, {version}", lambda: bits(named, words), "loops in C, gcc -O3",
                bits_in_c, at_most=4.5)  # fmt: skip
    yield timed(GROUP, "columns, standard library", lambda: arrays(Telegram111Response, some), "list(iter_unpack)",
                lambda: list(STRUCT.iter_unpack(some)), at_least=12)  # fmt: skip


if __name__ == "__main__":
    printed(rows())
