"""Halves, and whole numbers with sign and magnitude, in the modules that generated JavaScript shares."""

from __future__ import annotations

import json
import math
import subprocess
from typing import Any

import numpy as np
import pytest

from external_tools import require_tool
from js_output.javascript import package
from number_bits import FIRST_TOO_GREAT, HALVES, MAGNITUDES, half_bits, numbers_near_halves

PROGRAM = """
const bits = await import(process.argv[1] + "/runtime/number_bits.js");
const { halfBitsOf } = await import(process.argv[1] + "/runtime/values.js");
const { readFileSync } = await import("node:fs");
const { floatText } = await import(process.argv[1] + "/runtime/explain/numbers.js");
const refused = (number) => { try { halfBitsOf("speed", number, null, []); } catch (error) { return error.reason; } };
const numbers = JSON.parse(readFileSync(0, "utf-8"));
const all = Array.from({ length: 65536 }, (_, at) => bits.halfOf(at));
console.log(JSON.stringify({
  halves: all.map((number) => floatText(number)),
  texts: all.map((number) => floatText(number, 2)),
  bits: numbers.map((number) => bits.realBits(number, 2)),
  nan: bits.realBits(NaN, 2),
  refused: [65519.9, -65519.9, Infinity, NaN, 65520, -65520, 1e300].map(refused),
  magnitudes: Array.from({ length: 256 }, (_, at) => bits.magnitudeOf(at, 8)),
  wide: Array.from({ length: 256 }, (_, at) => String(bits.magnitudeOf(BigInt(at) << 56n, 64) >> 56n)),
  again: Array.from({ length: 256 }, (_, at) => bits.magnitudeBits(bits.magnitudeOf(at, 8), 8)),
}));
"""


@pytest.fixture(scope="module")
def answers() -> dict[str, Any]:
    numbers = json.dumps(list(numbers_near_halves(1, 4000)))
    command = [require_tool("node"), "--input-type=module", "-e", PROGRAM, str(package())]
    run = subprocess.run(command, input=numbers, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    result: dict[str, Any] = json.loads(run.stdout)
    return result


def test_all_halves_have_the_numbers_of_struct(answers: dict[str, Any]) -> None:
    assert answers["halves"] == [repr(number) for number in HALVES]


def test_the_shortest_texts_of_halves_lead_back_to_their_bits(answers: dict[str, Any]) -> None:
    finite = [half_bits(float(text)) for text in answers["texts"] if text not in ("nan", "inf", "-inf")]
    assert finite == [bits for bits, number in enumerate(HALVES) if math.isfinite(number)]


def test_the_texts_of_halves_have_no_more_digits_than_those_of_numpy(answers: dict[str, Any]) -> None:
    shortest = [len(repr(float(str(number)))) for number in np.array(HALVES, np.float16)]
    assert [len(text) for text in answers["texts"]] == shortest


def test_numbers_are_rounded_to_the_half_to_which_struct_rounds_them(answers: dict[str, Any]) -> None:
    numbers = [number for number in numbers_near_halves(1, 4000) if abs(number) < FIRST_TOO_GREAT]
    assert answers["bits"] == [half_bits(number) for number in numbers]


def test_a_nan_is_quiet_and_has_no_sign(answers: dict[str, Any]) -> None:
    assert answers["nan"] == 0x7E00


def test_finite_numbers_that_would_become_infinite_are_refused(answers: dict[str, Any]) -> None:
    assert answers["refused"] == [None] * 4 + ["out_of_range"] * 3


def test_the_highest_bit_of_a_magnitude_is_its_sign(answers: dict[str, Any]) -> None:
    assert answers["magnitudes"] == MAGNITUDES


def test_bigints_have_signs_beside_magnitudes_too(answers: dict[str, Any]) -> None:
    assert answers["wide"] == [str(number) for number in MAGNITUDES]


def test_a_negative_zero_is_written_as_zero(answers: dict[str, Any]) -> None:
    assert answers["again"] == [0 if bits == 0x80 else bits for bits in range(256)]
