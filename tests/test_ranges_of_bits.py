"""Fields of bits with a range or a unit: what does not fit is not sent, and is marked when it is read."""

from __future__ import annotations

import re

import pytest

from fieldspec.codec.explain.values import decode_value
from fieldspec.codec.layout.values import MeaningError, raw_value
from fieldspec.codec.reference.records import CodecError, decoded, encoded
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
    # The temperature that is left out has its default, 20 °C.
    assert raw_value(COUNTER.device, "drive", DRIVE, "speed=-2000") == word(-2000, 120)
    with pytest.raises(MeaningError, match="5000 does not fit the 12 bits of speed"):
        raw_value(COUNTER.device, "drive", DRIVE, "speed=5000")


def test_a_quantity_becomes_the_nearest_count_of_its_bits() -> None:
    drive = MODULE.Drive(speed_rpm=-12.6, temperature_celsius=20, enabled=True)
    assert (drive.speed, drive.temperature, drive.enabled) == (-50, 120, True)
    assert (drive.speed_rpm, drive.temperature_celsius) == (-12.5, 20)


@pytest.mark.parametrize(
    ("bits", "error", "text"),
    [
        ({"speed_rpm": 512}, codec_error(), "out_of_range: speed is 512, not in -512.0..511.75"),
        ({"speed": 1, "speed_rpm": 1}, TypeError, "takes only one of 'speed' or 'speed_rpm'"),
        ({"speed": 1.5}, TypeError, "cannot be interpreted as an integer"),
    ],
)
def test_bits_refuse_a_quantity_that_they_do_not_hold(
    bits: dict[str, float], error: type[Exception], text: str
) -> None:
    with pytest.raises(error, match=re.escape(text)):
        MODULE.Drive(**bits)


def test_a_quantity_between_counts_of_a_fraction_names_the_counts_beside_it() -> None:
    value = COUNTER.records["counts"].named("forward")
    assert value is not None
    assert value.value is not None
    with pytest.raises(MeaningError, match=r"the nearest counts are 2 and 3$"):
        raw_value(COUNTER.device, "forward", value.value, "1%")
