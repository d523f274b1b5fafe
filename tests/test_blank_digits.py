"""Decimal digits with blanks in place of leading zeros, `padding: space`: one form of each number, and no other."""

from __future__ import annotations

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import CodecError, codec
from fieldspec.language.model.digits import digits_text
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of

LAYOUT = newest(TEST_SPECS, "weigher")
WEIGHER = module_of(LAYOUT)
LINES = link_of(WEIGHER, "lines")
REFERENCE = codec(LAYOUT).links["lines"]

WEIGHTS = {
    b"    0.00": 0,
    b"    0.05": 5,
    b"   -0.05": -5,
    b"   12.34": 1234,
    b" -999.99": -99999,
    b"99999.99": 9999999,
    b"   -0.00": 0,
}
"""The characters of weights with two places, and their counts."""

DRIFTS = {b"   0": 0, b"  12": 12, b" -12": -12, b"-999": -999, b"9999": 9999, b"  -0": 0}

WRONG = (
    b"0012",
    b" 012",
    b"-012",
    b" +12",
    b"+012",
    b"- 12",
    b"12  ",
    b" 1 2",
    b"    ",
    b"   -",
    b" --1",
    b"1-23",
    b" 1.2",
    b"  1A",
    b"\x00\x0012",
    b"\t 12",
)
"""Other ways to write a number in four characters, and what is not a number."""


def frame(weight: bytes = b"    0.00", drift: bytes = b"   0") -> bytes:
    """A response with some characters as its weight and its drift."""
    return b"V" + weight + b"," + drift + b", 1" + b"7".rjust(19) + b" 0-1\r\n"


@pytest.mark.parametrize(("weight", "count"), WEIGHTS.items())
def test_weights_are_read_and_written_in_one_form(weight: bytes, count: int) -> None:
    data = frame(weight)
    values = REFERENCE.decode(data, "response", "read_display").values
    response = LINES.decode_response(data, WEIGHER.ReadDisplayRequest(7)).message
    assert values["net_weight"] == response.net_weight == count
    assert explained(LAYOUT, "lines", "response", data).reasons == ()
    if weight != b"   -0.00":
        assert LINES.encode_response(response) == data
        assert REFERENCE.encode("response", "read_display", values) == data


@pytest.mark.parametrize(("drift", "number"), DRIFTS.items())
def test_a_sign_takes_the_place_of_a_digit(drift: bytes, number: int) -> None:
    data = frame(drift=drift)
    response = LINES.decode_response(data, WEIGHER.ReadDisplayRequest(7)).message
    assert REFERENCE.decode(data, "response", "read_display").values["drift"] == response.drift == number
    assert (response.pulses, list(response.tries)) == (7, [0, -1])


@pytest.mark.parametrize("drift", WRONG)
def test_other_ways_to_write_a_number_are_refused_where_it_begins(drift: bytes) -> None:
    data = frame(drift=drift)
    with pytest.raises(CodecError) as expected:
        REFERENCE.decode(data, "response", "read_display")
    with pytest.raises(codec_error()) as caught:
        LINES.decode_response(data, WEIGHER.ReadDisplayRequest(7))
    for error in (expected.value, caught.value):
        assert (error.reason, error.offset) == ("unknown_value", 10)
    assert "unknown_value" in explained(LAYOUT, "lines", "response", data).reasons


@pytest.mark.parametrize("number", [-1000, 10000])
def test_numbers_beyond_their_characters_are_refused(number: int) -> None:
    values = REFERENCE.decode(frame(), "response", "read_display").values
    with pytest.raises(CodecError, match="drift"):
        REFERENCE.encode("response", "read_display", values | {"drift": number})
    response = LINES.decode_response(frame(), WEIGHER.ReadDisplayRequest(7)).message
    response.drift = number
    with pytest.raises(codec_error()):
        LINES.encode_response(response)


def test_texts_say_where_blanks_are() -> None:
    field = LAYOUT.messages["read_display"].response.named("drift")
    assert field is not None
    assert field.value is not None
    assert digits_text(field.value) == "4 decimal digits, blanks in place of leading zeros, a sign below zero"
