"""Words of flags in the generated package: their bits, snapshots, and the words in records."""

from __future__ import annotations

import pytest

from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of

WIDGET, SERVO = module_of(newest(TEST_SPECS, "widget")), module_of(newest(TEST_SPECS, "servo2"))
CodecError = codec_error()


def test_flags_are_booleans_over_the_raw_word() -> None:
    word = WIDGET.Status(0x8A21)
    assert (word.ready, word.start, word.brake, word.overlay) == (True, False, False, False)
    assert word.level is WIDGET.Level.HIGH
    assert word.lap == 10
    assert word.raw == int(word) == 0x8A21


def test_a_field_of_bits_that_its_enum_does_not_list_is_a_number() -> None:
    assert WIDGET.Status(0x30).level == 3


def test_flags_are_made_from_keywords() -> None:
    assert WIDGET.Status(ready=True, level=WIDGET.Level.MIDDLE, lap=15).raw == 0x0F11
    assert WIDGET.Status() == WIDGET.Status(0)
    with pytest.raises(CodecError) as caught:
        WIDGET.Status(lap=16)
    assert caught.value.reason == "out_of_range"


def test_a_snapshot_of_flags_has_every_name() -> None:
    bits = WIDGET.Status(0x8021).flags()
    assert bits == {"ready": True, "start": False, "brake": False, "level": 2, "lap": 0, "overlay": False}


def test_flags_show_which_are_set() -> None:
    assert repr(WIDGET.Status(0x8021)) == "<Status 0x8021: ready, level=2>"
    assert repr(WIDGET.Status(0)) == "<Status 0x0: none>"


def test_flags_are_equal_where_their_words_are() -> None:
    assert WIDGET.Status(1) == WIDGET.Status(1)
    assert WIDGET.Status(1) != WIDGET.Status(2)
    assert WIDGET.Status(1) != WIDGET.PacketStatus(1)
    assert len({WIDGET.Status(1), WIDGET.Status(1), WIDGET.PacketStatus(1)}) == 2


def test_a_part_of_a_header_may_be_given_as_a_number() -> None:
    bus, done = SERVO.bus, SERVO.RebootResponse()
    assert bus.encode_response(1, done, error=0x80) == bus.encode_response(1, done, error=SERVO.Error(alert=True))
    refusal = bus.encode_exception_response(1, SERVO.NoData(), error=SERVO.Error(number=7))
    assert bus.encode_exception_response(1, SERVO.NoData(), error=7) == refusal
    for error, reason in ((256, "out_of_range"), (SERVO.Error(256), "out_of_range"), ("alert", "wrong_type")):
        with pytest.raises(CodecError, match="error is") as caught:
            bus.encode_response(1, done, error=error)
        assert caught.value.reason == reason


def test_a_word_may_be_given_as_a_number() -> None:
    by_word = WIDGET.Point(WIDGET.Color.RED, 0, 1, WIDGET.Status(5), -1, 0)
    by_number = WIDGET.Point(WIDGET.Color.RED, 0, 1, 5, -1, 0)
    assert by_number.encode() == by_word.encode()
    assert by_number.status == WIDGET.Status(5)


def test_a_word_is_made_once() -> None:
    point = WIDGET.Point.decode(WIDGET.Point(WIDGET.Color.RED, 0, 1, 5, -1, 0).encode())
    assert point.status is point.status
