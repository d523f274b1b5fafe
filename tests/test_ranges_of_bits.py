"""Fields of bits with a range: a word with another number is not sent, and is marked when it is read."""

from __future__ import annotations

import pytest

from fieldspec.explain.values import decode_value
from fieldspec.layout.values import MeaningError, raw_value
from fieldspec.reference.records import CodecError, decoded, encoded
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of

COUNTER = newest(TEST_SPECS, "counter")
MODULE = module_of(COUNTER)
DRIVE = COUNTER.messages["signals"].response.fields[0].value
RECORD = COUNTER.messages["signals"].response
assert DRIVE is not None


def word(speed: int, temperature: int = 0) -> int:
    return speed & 0xFFF | temperature << 12


@pytest.mark.parametrize("number", [word(2000), word(-2000), word(0, 510), word(-1, 510) | 1 << 63])
def test_a_word_within_the_ranges_is_sent(number: int) -> None:
    data = encoded(RECORD, {"drive": number}, COUNTER.device)
    assert data == number.to_bytes(8, "little")
    assert MODULE.SignalsResponse(drive=MODULE.Drive(number)).encode() == data


@pytest.mark.parametrize(
    ("number", "text"), [(word(2001), "2001"), (word(-2001), "-2001"), (word(2047), "2047"), (word(0, 511), "511")]
)
def test_a_word_with_bits_out_of_their_range_is_read_and_not_sent(number: int, text: str) -> None:
    with pytest.raises(CodecError, match=rf"^out_of_range: \w+ of drive is {text}, not in"):
        encoded(RECORD, {"drive": number}, COUNTER.device)
    with pytest.raises(codec_error(), match=r"^out_of_range: \w+ of drive is not in"):
        MODULE.SignalsResponse(drive=MODULE.Drive(number)).encode()
    data = number.to_bytes(8, "little")
    assert decoded(RECORD, data, COUNTER.device) == {"drive": number}
    assert MODULE.SignalsResponse.decode(data).drive.raw == number


def test_an_explanation_marks_bits_out_of_their_range() -> None:
    assert DRIVE is not None
    explained = decode_value(COUNTER.device, DRIVE, word(2001).to_bytes(8, "little"), "little", False)
    assert (explained.reason, explained.verdict) == ("out_of_range", "wrong: should be speed -500.00..500.00 rpm")
    explained = decode_value(COUNTER.device, DRIVE, word(0, 511).to_bytes(8, "little"), "little", False)
    assert explained.verdict == "wrong: should be temperature -40.0..215.0 °C"


def test_a_number_that_the_bits_do_not_hold_has_no_word() -> None:
    assert DRIVE is not None
    assert raw_value(COUNTER.device, "drive", DRIVE, "speed=-2000") == word(-2000)
    with pytest.raises(MeaningError, match="5000 does not fit the 12 bits of speed"):
        raw_value(COUNTER.device, "drive", DRIVE, "speed=5000")
