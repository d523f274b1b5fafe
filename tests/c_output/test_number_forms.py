"""Half precision, and numbers with sign and magnitude, in C: judged by `struct`, and by their definition."""

from __future__ import annotations

import math
import random
import struct
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import compiled

from fieldspec.targets.c.backend import files
from layouts import TEST_SPECS, newest

FILES = files([newest(TEST_SPECS, "compass")])
MAIN = """
#include "compass_v1.h"
#include <inttypes.h>
#include <stdio.h>
#define MAGNITUDE(word, bits) \\
    printf("%" PRId64 " %" PRIu64 "\\n", (int64_t)compass_of_magnitude_##bits((word)number), \\
           (uint64_t)compass_magnitude_of_##bits(compass_of_magnitude_##bits((word)number)))
int main(void)
{
    unsigned form;
    uint64_t number;
    float value;
    while (scanf("%u %" SCNu64, &form, &number) == 2) {
        switch (form) {
        case 0:
            printf("%" PRIu32 "\\n", compass_bits_of(compass_float_of_half((uint16_t)number)));
            break;
        case 1:
            value = compass_float_of((uint32_t)number);
            printf("%u %u\\n", (unsigned)compass_half_of(value), (unsigned)compass_exceeds_half(value));
            break;
        case 8: MAGNITUDE(uint8_t, 8); break;
        case 16: MAGNITUDE(uint16_t, 16); break;
        case 24: MAGNITUDE(uint32_t, 24); break;
        case 32: MAGNITUDE(uint32_t, 32); break;
        default: MAGNITUDE(uint64_t, 64); break;
        }
    }
    return 0;
}
"""
DECODED, ENCODED = 0, 1
HALVES = range(1 << 16)


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("forms")
    for path, text in FILES.items():
        (folder / path).write_text(text, encoding="utf-8")
    (folder / "main.c").write_text(MAIN, encoding="utf-8")
    return compiled("sanitized", folder / "main.c", folder / "main")


def answers(program: Path, form: int, numbers: Iterable[int]) -> list[tuple[int, ...]]:
    """The numbers in each line that the program answers."""
    text = "".join(f"{form} {number}\n" for number in numbers)
    output = subprocess.run([str(program)], input=text, capture_output=True, text=True, check=True).stdout
    return [tuple(map(int, line.split())) for line in output.splitlines()]


def half(bits: int) -> float:
    number: float = struct.unpack("<e", struct.pack("<H", bits))[0]
    return number


def single_bits(number: float) -> int:
    bits: int = struct.unpack("<I", struct.pack("<f", number))[0]
    return bits


def single(bits: int) -> float:
    number: float = struct.unpack("<f", struct.pack("<I", bits))[0]
    return number


def test_all_halves_are_the_numbers_that_struct_says(program: Path) -> None:
    numbers = [bits for bits in HALVES if not math.isnan(half(bits))]
    assert answers(program, DECODED, numbers) == [(single_bits(half(bits)),) for bits in numbers]


def test_all_halves_come_back_with_their_bits_those_of_every_nan_included(program: Path) -> None:
    singles = [number for (number,) in answers(program, DECODED, HALVES)]
    assert [bits for bits, _ in answers(program, ENCODED, singles)] == list(HALVES)


def test_numbers_around_all_halves_are_rounded_as_struct_rounds_them(program: Path) -> None:
    finite = [half(bits) for bits in range(0x7C00)]
    middles = [single_bits((low + high) / 2) for low, high in zip(finite, [*finite[1:], 65536.0], strict=True)]
    rng = random.Random(32)
    near = [bits + step for bits in middles for step in (-1, 0, 1)] + [rng.getrandbits(32) for _ in range(20_000)]
    numbers = [bits | sign for bits in near for sign in (0, 1 << 31) if not math.isnan(single(bits))]
    assert answers(program, ENCODED, numbers) == [struct_half(single(bits)) for bits in numbers]


def struct_half(number: float) -> tuple[int, int]:
    """The bits of a half, and whether a finite number is too large for one, which then has those of infinity."""
    try:
        return struct.unpack("<H", struct.pack("<e", number))[0], 0
    except OverflowError:
        return struct.unpack("<H", struct.pack("<e", math.copysign(math.inf, number)))[0], 1


@pytest.mark.parametrize("bits", [8, 16, 24, 32, 64])
def test_a_number_is_its_magnitude_and_its_highest_bit_the_sign(program: Path, bits: int) -> None:
    sign = 1 << bits - 1
    magnitudes = [0, 1, 2, sign // 2, sign - 2, sign - 1]
    expected = [(number, number) for number in magnitudes]
    expected += [(-number, sign | number if number else 0) for number in magnitudes]
    assert answers(program, bits, [*magnitudes, *(sign | number for number in magnitudes)]) == expected
