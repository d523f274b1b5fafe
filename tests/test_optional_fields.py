"""Fields that a bit or a code says are sent: values of Bluetooth sensors, as others have published and read them."""

from __future__ import annotations

import pytest

from fieldspec.codec.reference import CodecError, codec
from layouts import TEST_SPECS, newest
from python_package import link_of, module_of

ARMBAND = newest(TEST_SPECS, "armband")
REFERENCE = codec(ARMBAND).links["att"]
LINK = link_of(module_of(ARMBAND), "att")

PUBLISHED = {
    # movisens, SmartGattLib, HeartRateMeasurementTest: 72, no energy, intervals of 0.33203125 and 0.73046875 s.
    "1B 37 2A 16 48 54 01 EC 02": {"rate": [72], "wide_rate": [], "energy": [], "intervals": [340, 748]},
    # ActiGraph, GT3X-File-Format, HeartRateBLE: 66, and two intervals.
    "1B 37 2A 16 42 18 04 70 01": {"rate": [66], "wide_rate": [], "energy": [], "intervals": [1048, 368]},
    # OpenTracks, BluetoothUtilsTest: a rate of one byte, and one of two.
    "1B 37 2A 02 3C": {"rate": [60], "wide_rate": [], "energy": [], "intervals": []},
    "1B 37 2A 01 01 01": {"rate": [], "wide_rate": [257], "energy": [], "intervals": []},
    # WebBluetoothCG, ble-test-peripheral-android, pull request 28: nothing but an energy of 0.
    "1B 37 2A 08 00 00 00": {"rate": [0], "wide_rate": [], "energy": [0], "intervals": []},
    # OpenTracks, BluetoothHandlerCyclingDistanceSpeedTest: the wheel alone.
    "1B 5B 2A 01 FF FF 00 01 45 99": {"wheel": [(0x0100FFFF, 0x9945)], "crank": []},
    # OpenVitals, BleParsersTest: the wheel and the crank, then the power with the crank.
    "1B 5B 2A 03 10 00 00 00 20 00 05 00 30 00": {"wheel": [(16, 0x20)], "crank": [(5, 0x30)]},
    "1B 63 2A 20 00 64 00 05 00 10 00": {"power": 100, "balance": [], "torque": [], "wheel": [], "crank": [(5, 0x10)]},
    # OpenTracks, BluetoothHandlerRunningSpeedAndCadenceTest: 5 m/s, 80 steps, 1684275.1 m.
    "1B 53 2A 02 00 05 50 FF FF 00 01": {"speed": 1280, "cadence": 80, "stride": [], "distance": [16842751]},
}


def without_records(content: object) -> object:
    """Values with records as tuples of their fields."""
    if isinstance(content, list):
        return [without_records(item) for item in content]
    return tuple(content.values()) if isinstance(content, dict) else content


@pytest.mark.parametrize("data", PUBLISHED)
def test_published_values_have_the_fields_that_their_flags_say(data: str) -> None:
    frame = bytes.fromhex(data)
    decoded = REFERENCE.decode(frame, "response")
    assert {name: without_records(decoded.values[name]) for name in PUBLISHED[data]} == PUBLISHED[data]
    values = {name: value for name, value in decoded.values.items() if name != "handle"}
    assert REFERENCE.encode("response", decoded.message.name, values) == frame


@pytest.mark.parametrize("data", PUBLISHED)
def test_python_reads_and_writes_the_same_bytes(data: str) -> None:
    frame = bytes.fromhex(data)
    assert LINK.encode_response(LINK.decode_response(frame).message) == frame


@pytest.mark.parametrize(
    ("flags", "fields"),
    [
        (0, {"rate": [], "wide_rate": [257]}),
        (0, {"rate": [60], "energy": [5]}),
        (8, {"rate": [60]}),
        (16, {"rate": [60]}),
    ],
)
def test_fields_that_the_flags_do_not_say_are_refused(flags: int, fields: dict[str, list[int]]) -> None:
    values = {"flags": flags, "rate": [], "wide_rate": [], "energy": [], "intervals": []} | fields
    with pytest.raises(CodecError, match="wrong_measure"):
        REFERENCE.encode("response", "heart_rate", values)


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        ("1B 37 2A 08 48", "incomplete at byte 5"),  # no energy
        ("1B 37 2A 10 48", "wrong_measure at byte 3"),  # no interval
        ("1B 37 2A 00 48 01 02", "wrong_measure at byte 3"),  # an interval
        ("1B 37 2A 10 48 01", "wrong_length at byte 6"),  # half an interval
    ],
)
def test_bytes_that_the_flags_do_not_say_are_refused(data: str, reason: str) -> None:
    with pytest.raises(CodecError, match=reason):
        REFERENCE.decode(bytes.fromhex(data), "response")


@pytest.mark.parametrize(("mask", "levels"), [(0, []), (0x0001, [5]), (0x1C04, [5]), (0x0300, []), (0xE000, [])])
def test_any_of_several_bits_says_that_a_field_is_sent(mask: int, levels: list[int]) -> None:
    reference = codec(ARMBAND).links["module"]
    values = {"source_address": 1, "network_address": 2, "options": 1, "digital_mask": mask, "analogue_mask": 0}
    values |= {name: [] for name in ("first_level", "second_level", "third_level", "fourth_level", "supply_voltage")}
    frame = reference.encode("response", "samples", {**values, "digital_levels": levels})
    module = link_of(module_of(ARMBAND), "module")
    assert module.encode_response(module.decode_response(frame).message) == frame
    with pytest.raises(CodecError, match="wrong_measure"):
        reference.encode("response", "samples", {**values, "digital_levels": [] if levels else [5]})


def test_a_list_ends_with_the_first_zero() -> None:
    assert REFERENCE.decode(bytes.fromhex("55 05 80 00"), "response").values == {"intervals": [5, 0x80, 0]}
    assert LINK.encode_response(LINK.decode_response(bytes.fromhex("55 05 80 00")).message).hex() == "55058000"
    with pytest.raises(CodecError, match="wrong_length at byte 3"):
        REFERENCE.decode(bytes.fromhex("55 05 00 07"), "response")
