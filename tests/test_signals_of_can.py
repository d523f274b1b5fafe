"""Fields of bits against the signals of a DBC file: signed and scaled ones, in both byte orders, and over a bus."""

from __future__ import annotations

import random
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction

import can
import cantools
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fieldspec.codec.explain.values import decode_value
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of
from serial_lines import SECONDS

COUNTER = newest(TEST_SPECS, "counter")
MODULE = module_of(COUNTER)
DBC = """
VERSION ""
BS_:
BU_: Drive
BO_ 1 drive: 8 Drive
 SG_ speed : 0|12@1- (0.25,0) [0|0] "rpm" Drive
 SG_ temperature : 12|10@1+ (0.5,-40) [0|0] "C" Drive
 SG_ enabled : 22|1@1+ (1,0) [0|0] "" Drive
 SG_ position : 23|25@1- (0.001,0) [0|0] "mm" Drive
 SG_ serial : 48|16@1+ (1,0) [0|0] "" Drive
BO_ 2 brake: 8 Drive
 SG_ pressure : 7|5@0+ (1,0) [0|0] "bar" Drive
 SG_ force : 2|13@0- (0.1,0) [0|0] "N" Drive
 SG_ closed : 21|1@0+ (1,0) [0|0] "" Drive
 SG_ wear : 39|31@0- (1,0) [0|0] "" Drive
"""
MESSAGES = cantools.database.load_string(DBC, "dbc")
WORDS = {"drive": ("little", MODULE.Drive), "brake": ("big", MODULE.Brake)}
MASKS = {name: sum(bit.mask for bit in COUNTER.device.flags[name].bits) for name in WORDS}


@pytest.mark.parametrize("name", WORDS)
@given(data=st.binary(min_size=8, max_size=8))
def test_the_numbers_in_a_word_are_the_signals_of_the_message(name: str, data: bytes) -> None:
    order, word_class = WORDS[name]
    word = word_class(int.from_bytes(data, order))
    message = MESSAGES.get_message_by_name(name)
    assert {key: int(value) for key, value in word.flags().items()} == message.decode(data, scaling=False)
    in_units = message.decode(data)
    for bit in COUNTER.device.flags[name].bits:
        if bit.as_value.scaled:
            suffix = {"rpm": "rpm", "°C": "celsius", "mm": "mm", "N": "n"}[bit.unit]
            assert getattr(word, f"{bit.name}_{suffix}") == pytest.approx(in_units[bit.name])


@pytest.mark.parametrize("name", WORDS)
@given(data=st.binary(min_size=8, max_size=8))
def test_a_word_from_its_numbers_has_the_bytes_of_the_message(name: str, data: bytes) -> None:
    order, word_class = WORDS[name]
    message = MESSAGES.get_message_by_name(name)
    counts = message.decode(data, scaling=False)
    word = word_class(**counts)
    assert word.raw.to_bytes(8, order) == bytes(message.encode(counts, scaling=False))
    assert word.raw == int.from_bytes(data, order) & MASKS[name]


@pytest.mark.parametrize("name", WORDS)
@given(data=st.binary(min_size=8, max_size=8))
def test_the_explanation_has_the_signals_in_their_units(name: str, data: bytes) -> None:
    order, _ = WORDS[name]
    data_of_message = COUNTER.messages["signals"].data("request" if name == "brake" else "response")
    value = data_of_message.fields[0].value
    assert value is not None
    meanings = {
        meaning.name.partition("=")[0]: meaning
        for meaning in decode_value(COUNTER.device, value, data, order, False).meanings
    }
    in_units = MESSAGES.get_message_by_name(name).decode(data)
    for bit in COUNTER.device.flags[name].bits:
        if bit.as_value.scaled:
            number, unit = meanings[bit.name].text.split(" ")
            assert (float(Fraction(number)), unit) == (pytest.approx(in_units[bit.name], abs=1e-5), bit.unit)


@pytest.mark.parametrize(("name", "number"), [("speed", 2048), ("speed", -2049), ("serial", -1), ("temperature", 1024)])
def test_a_number_that_its_bits_do_not_hold_is_refused(name: str, number: int) -> None:
    with pytest.raises(codec_error()) as caught:
        MODULE.Drive(**{name: number})
    assert caught.value.reason == "out_of_range"


@contextmanager
def bus(channel: str) -> Iterator[tuple[can.BusABC, can.BusABC]]:
    """Two ends of a virtual CAN bus."""
    with can.Bus(interface="virtual", channel=channel) as near, can.Bus(interface="virtual", channel=channel) as far:
        yield near, far


def values_of(name: str, chance: random.Random) -> dict[str, int]:
    """Counts that fit all signals of a message."""
    return {
        signal.name: chance.randrange(1 << signal.length) - (1 << (signal.length - 1) if signal.is_signed else 0)
        for signal in MESSAGES.get_message_by_name(name).signals
    }


def test_cantools_reads_on_a_bus_what_the_generated_codec_sends() -> None:
    brake, chance = MESSAGES.get_message_by_name("brake"), random.Random(7)
    with bus("brake") as (near, far):
        for _ in range(50):
            counts = values_of("brake", chance)
            record = MODULE.bus.can_frame(MODULE.bus.encode_request(MODULE.SetBrakeRequest(MODULE.Brake(**counts))))
            near.send(can.Message(arbitration_id=record.identifier, data=record.data, is_extended_id=False))
            received = far.recv(SECONDS)
            assert received is not None
            assert received.arbitration_id == 0x2A0
            assert brake.decode(received.data, scaling=False) == counts


def test_a_generated_framer_reads_on_a_bus_what_cantools_sends() -> None:
    drive, chance = MESSAGES.get_message_by_name("drive"), random.Random(8)
    with bus("drive") as (near, far):
        for _ in range(50):
            counts = values_of("drive", chance)
            data = drive.encode(counts, scaling=False)
            near.send(can.Message(arbitration_id=0x101, data=data, is_extended_id=False))
            received = far.recv(SECONDS)
            assert received is not None
            frame = MODULE.bus.frame_of(received.arbitration_id, received.data)
            message = MODULE.bus.decode_response(frame, None).message
            assert {key: int(value) for key, value in message.drive.flags().items()} == counts
