"""Registers of single bits: frames that carry them, on the command line and in the generated Python."""

from __future__ import annotations

import json
from typing import Any

import pytest

from command_line import TEST_SPECS, CommandLine
from fieldspec.foundation.classes import replace
from layouts import all_layouts, newest
from python_package import codec_error, module_of

STATION = module_of(newest(TEST_SPECS, "station"))
CodecError = codec_error()
READ_INPUTS, INPUTS = "000300000006010200000011", "000300000006010203810001"


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, TEST_SPECS)


@pytest.mark.parametrize(
    ("arguments", "frame"),
    [
        (["write_coil", "address=enable", "value=on"], "01 05 00 08 FF 00 0D F8"),
        (["write_coil", "address=enable", "value=false"], "01 05 00 08 00 00 4C 08"),
        (["write_coils", "address=relays", "bit_count=3", "bits=on, off, true"], "01 0F 00 00 00 03 01 05 4F 54"),
        (["write_coils", "address=0", "bit_count=3", "bits=5"], "01 0F 00 00 00 03 01 05 4F 54"),
    ],
)
def test_truth_values_are_written_as_bits(run: CommandLine, arguments: list[str], frame: str) -> None:
    result = run("encode", "station", *arguments, "station=1", "--link", "rtu")
    assert (result.code, result.err, result.lines[0]) == (0, "", frame)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["read_coils", "address=8", "bit_count=3"], "clear_counters at 0x000A can only be written"),
        (["read_coils", "address=fault", "bit_count=1"], "fault lies in discrete_inputs, and read_coils reads coils"),
        (["write_coil", "address=0", "value=on,off"], "on,off has 2 bits, and the message carries one"),
        (["write_coil", "address=0", "value=7"], "out_of_range"),
    ],
)
def test_bits_that_cannot_be_accessed_are_refused(run: CommandLine, arguments: list[str], message: str) -> None:
    result = run("encode", "station", *arguments, "station=1", "--link", "rtu")
    assert result.code == 2
    assert message in result.err


def decoded(run: CommandLine, *arguments: str) -> Any:
    result = run("decode", "station", *arguments, "--format", "json")
    return json.loads(result.out)


def test_each_bit_of_a_response_is_explained(run: CommandLine) -> None:
    rows = decoded(run, "--request", READ_INPUTS, INPUTS)["registers"]
    assert [row["path"] for row in rows] == [*(f"digital_inputs[{number}]" for number in range(1, 17)), "fault"]
    assert [place for place, row in enumerate(rows) if row["number"]] == [0, 7, 16]
    assert [(row["offset"], row["raw"], row["bits"]) for row in (rows[7], rows[8])] == [(9, "81", 1), (10, "00", 1)]
    assert rows[16]["meanings"][0]["name"] == "short_circuit"


def test_a_single_bit_is_explained_by_its_number(run: CommandLine) -> None:
    (row,) = decoded(run, "--link", "rtu", "--direction", "request", "01050008FF000DF8")["registers"]
    assert (row["path"], row["number"], row["raw"]) == ("enable", True, "FF00")


def test_a_response_with_other_bits_than_requested_does_not_fit(run: CommandLine) -> None:
    result = decoded(run, "--request", READ_INPUTS, "00030000000501020281 00")
    assert "the request asks for 17 bits, which take 3 bytes, but the response has 2" in result["remarks"]


def test_a_space_is_read_and_written_by_its_own_functions() -> None:
    assert STATION.read_request(STATION.ENABLE) == STATION.ReadCoilsRequest(address=8, bit_count=1)
    assert STATION.read_request(STATION.FAULT) == STATION.ReadDiscreteInputsRequest(address=16, bit_count=1)
    assert STATION.write_request(STATION.ENABLE, True) == STATION.WriteCoilRequest(address=8, value=0xFF00)
    relays = STATION.write_request(STATION.RELAYS.all, [True, True, False, False, False, False, False, True])
    assert relays == STATION.WriteCoilsRequest(address=0, bit_count=8, bits=[0x83])
    assert STATION.register_at(8, "coils") is STATION.ENABLE


@pytest.mark.parametrize(
    ("value", "reason"),
    [([True] * 7, "wrong_length"), ([2] * 8, "wrong_type"), (True, "wrong_type")],
)
def test_other_values_than_bits_are_refused(value: object, reason: str) -> None:
    with pytest.raises(CodecError, match=reason):
        STATION.write_request(STATION.RELAYS.all, value)


def test_a_response_with_too_few_bytes_is_refused() -> None:
    with pytest.raises(CodecError, match="wrong_length"):
        STATION.read_value(STATION.DIGITAL_INPUTS.all, STATION.ReadDiscreteInputsResponse(bits=[1]))
    with pytest.raises(CodecError, match="wrong_type"):
        STATION.read_value(STATION.FAULT, STATION.ReadCoilsResponse(bits=[1]))


def test_valves_that_are_apart_are_read_one_by_one() -> None:
    assert [valve.address for valve in STATION.VALVES] == [0x10, 0x12, 0x14]
    assert not hasattr(STATION.VALVES, "all")


@pytest.mark.parametrize(("width", "signed", "text"), [(4, False, "0..15"), (4, True, "-8..7"), (1, True, "-1..0")])
def test_a_field_of_bits_holds_what_its_width_and_sign_allow(width: int, signed: bool, text: str) -> None:
    bit = next(bit for layout in all_layouts() for word in layout.device.flags.values() for bit in word.bits)
    ranges = replace(bit, first=0, last=width - 1, signed=signed).as_value.ranges
    assert ranges is not None
    assert ranges.text() == text


@pytest.mark.parametrize(("count", "data"), [(9, [5]), (8, [5, 0]), (16, [5])])
def test_a_number_of_bits_that_takes_other_bytes_is_refused(count: int, data: list[int]) -> None:
    message = STATION.WriteCoilsRequest(address=0, bit_count=count, bits=data)
    with pytest.raises(CodecError) as refused:
        message.encode()
    assert refused.value.reason == "wrong_measure"
    body = bytes((0, 0, 0, count, len(data), *data))
    with pytest.raises(CodecError) as refused:
        STATION.WriteCoilsRequest.decode(body)
    assert (refused.value.reason, refused.value.offset) == ("wrong_measure", 2)


def test_the_explanation_says_how_many_bits_there_may_be(run: CommandLine) -> None:
    result = run("decode", "station", "00 02 00 00 00 08 01 0F 00 00 00 09 01 A5", "--link", "tcp")
    assert "wrong: bit_count at byte 10: should be 1 to 8" in result.out
