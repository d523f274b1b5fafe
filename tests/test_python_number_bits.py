"""Halves, and whole numbers with sign and magnitude, in Python: by NumPy, by counting, and by the reference."""

from __future__ import annotations

import itertools
import random
from typing import Any

import numpy
import pytest

from fieldspec.codec.reference.parameters import number_in_field
from fieldspec.foundation.classes import replace
from fieldspec.language.model.encoding import bounds_of
from fieldspec.language.model.primitives import PRIMITIVES
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of, runtime

COMPASS = newest(TEST_SPECS, "compass")
MODULE = module_of(COMPASS)
CodecError = codec_error()
Half, Float = runtime("_reals").Half, runtime("_reals").Float
Number, Parameter, MANY = runtime("_values").Number, runtime("_parameters").Parameter, runtime("many")
HALVES = numpy.arange(1 << 16, dtype="u2").view("f2").astype("f8").tolist()
HEADING = next(row.register.value for row in COMPASS.registers if row.name == "heading")


def same(left: float, right: float) -> bool:
    """Whether two numbers are equal, and one NaN like another."""
    return left == right or (left != left and right != right)


@pytest.mark.parametrize("order", [">", "<"])
def test_every_half_is_the_number_that_numpy_reads(order: str) -> None:
    value = Half(f"{order}e")
    for bits, number in enumerate(HALVES):
        assert same(value.decode("field", bits.to_bytes(2, "big" if order == ">" else "little")), number), hex(bits)


def test_every_number_becomes_the_half_that_numpy_rounds_it_to() -> None:
    value, finite = Half(">e"), HALVES[:0x7C00]
    middles = [(low + high) / 2 for low, high in itertools.pairwise(finite)]
    beside = [float(numpy.nextafter(middle, end)) for middle in middles[::9] for end in (0, 1e9)]
    for number in [*finite, *middles, *beside]:
        for signed in (number, -number):
            assert value.encode("field", signed) == numpy.array([signed]).astype(">f2").tobytes(), signed


def test_a_special_value_that_is_no_number_has_the_bits_of_the_spec() -> None:
    assert MODULE.FIELD.value.encode("field", float("nan")) == bytes.fromhex("7E00")
    assert MODULE.FIELD.state_of(MODULE.FIELD.value.decode("field", bytes.fromhex("FE01"))) == "not_measured"


@pytest.mark.parametrize("number", [65520.0, -65520.0, 65520, 70000, 10**400, -(10**400)])
@pytest.mark.parametrize("letters", [">e", ">f"])
def test_a_finite_number_that_becomes_infinite_is_out_of_range(letters: str, number: float) -> None:
    value = Half(letters) if letters == ">e" else Float(letters)
    if letters == ">f" and abs(number) < 2**127:
        assert value.refused("field", number) is None
        return
    assert value.refused("field", number).reason == "out_of_range"


def test_a_record_refuses_a_half_that_becomes_infinite() -> None:
    request = MODULE.SetLimitRequest(MODULE.Kind.HALF, 65519.0)
    assert request.encode() == bytes.fromhex("01 7BFF")
    request.limit = 65520
    with pytest.raises(CodecError) as caught:
        request.encode()
    assert caught.value.reason == "out_of_range"


@pytest.mark.parametrize("bits", range(8, 65, 8))
@pytest.mark.parametrize("order", ["big", "little"])
def test_the_highest_bit_alone_is_the_sign(bits: int, order: Any) -> None:
    value, sign, dice = Number(f"{'>' if order == 'big' else '<'}sm{bits}"), 1 << (bits - 1), random.Random(bits)
    for magnitude in [0, 1, sign - 1, *(dice.randrange(sign) for _ in range(50))]:
        for number in (magnitude, -magnitude):
            data = (magnitude | sign * (number < 0)).to_bytes(bits // 8, order)
            assert value.encode("heading", number) == data
            assert value.decode("heading", data) == number


@pytest.mark.parametrize("bits", range(8, 65, 8))
def test_zero_below_zero_is_zero_and_the_least_number_of_two_s_complement_is_none(bits: int) -> None:
    value, sign = Number(f">sm{bits}"), 1 << (bits - 1)
    assert value.decode("heading", sign.to_bytes(bits // 8, "big")) == 0
    with pytest.raises(CodecError) as caught:
        value.encode("heading", -sign)
    assert caught.value.reason == "out_of_range"


@pytest.mark.parametrize("own", ["u16", "i16", "sm16"])
@pytest.mark.parametrize("carrier", ["u16", "i16", "sm16"])
def test_the_bits_of_a_parameter_are_those_in_a_field_with_another_sign(own: str, carrier: str) -> None:
    letters = {"u16": ">H", "i16": ">h", "sm16": ">sm16"}
    parameter: Any = Parameter("offset", 1, Number(letters[own]), "rw", carrier=letters[carrier])
    value, field = (replace(HEADING, type=PRIMITIVES[name], sentinels=(), ranges=None) for name in (own, carrier))
    (low, high), dice = bounds_of(value.encoding), random.Random(1)
    for raw in [low, -1, 0, 1, high, *(dice.randint(low, high) for _ in range(100))]:
        if not low <= raw <= high:
            continue
        carried = number_in_field(field, value, raw)
        assert parameter.to_raw(raw) == carried
        assert parameter.from_raw(carried) == number_in_field(value, field, carried)


def test_columns_have_halves_as_numbers_of_32_bits_and_magnitudes_as_signed_ones() -> None:
    data = b"".join(bytes.fromhex("8001 83E80000 010080 8000000000000002 3C00 003C 01FC 0001 8001 8000") for _ in "12")
    columns, arrays = MANY.decode_many(MODULE.Sample, data), MANY.arrays(MODULE.Sample, data)
    for name, numbers in {"heading": [-1], "odd": [-1], "wide": [-2], "field": [1.0], "steps": [1, -1, 0]}.items():
        assert columns[name].ravel().tolist() == numbers * 2 == arrays[name].tolist()
    assert arrays["pair"].tolist()[:1] == [1.0]
    assert (columns["field"].dtype, arrays["field"].typecode) == (numpy.dtype("f2"), "f")
