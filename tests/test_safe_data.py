"""Checksums with a prefix, on serial lines and in the data of CAN frames, and frames with several lengths."""

from __future__ import annotations

import random
from functools import partial

import pytest
from crccheck.crc import Crc8SaeJ1850, Crc16Modbus

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.layout.checksums import checksum
from fieldspec.codec.reference import CodecError, codec
from fieldspec.language.model.checksums import SIMPLE, Checksum, algorithm_name, checksum_named, preceded
from fieldspec.language.schema.crc_catalogue import CRC_CATALOGUE
from layouts import TEST_SPECS, layout_at, newest
from python_package import codec_error, link_of, module_apart, module_of
from spec_files import gadget

PEDAL, STAMPER = newest(TEST_SPECS, "pedal"), newest(TEST_SPECS, "stamper")
HOST = codec(STAMPER).links["host"]
ALGORITHMS = [*SIMPLE, *(line.split()[0] for line in CRC_CATALOGUE.splitlines()), "sum16", "sum24", "xor8"]


@pytest.mark.parametrize("name", ALGORITHMS)
def test_a_checksum_behind_a_prefix_is_that_of_both(name: str) -> None:
    chance = random.Random(name)
    for size in (0, 1, 2, 9):
        prefix, data = chance.randbytes(chance.randrange(1, 6)), chance.randbytes(size)
        derived = algorithm_name(preceded(checksum_named(name), prefix, "big"))
        assert checksum(derived, data) == checksum(name, prefix + data)


@pytest.mark.parametrize("order", ["big", "little"])
def test_a_prefix_of_whole_numbers_precedes_a_sum_of_numbers(order: str) -> None:
    prefix, data = bytes.fromhex("12 34 56 78"), bytes.fromhex("9A BC DE")
    for kind in (Checksum("sum", 16, unit_size=2, complement="ones"), Checksum("xor", 16, unit_size=2)):
        derived = algorithm_name(preceded(kind, prefix, order))
        assert checksum(derived, data, order) == checksum(algorithm_name(kind), prefix + data, order)


def test_safe_data_on_a_bus_have_the_crc_of_their_identifier_and_themselves() -> None:
    values = {"counter": 3, "travel": 1000, "pressed": 1}
    frame = codec(PEDAL).links["position"].encode("response", "pedal_position", values)
    data = frame[8:]
    assert data == bytes([Crc8SaeJ1850.calc(bytes.fromhex("34 12") + data[1:])]) + bytes.fromhex("03 E8 03 01")
    wrong = frame[:8] + bytes([data[0] ^ 1]) + data[1:]
    assert explained(PEDAL, "position", "response", wrong, "pedal_position").reasons == ("wrong_checksum",)
    with pytest.raises(CodecError, match="wrong_checksum"):
        codec(PEDAL).links["position"].decode(wrong, "response", "pedal_position")


def test_each_length_is_written_and_compared() -> None:
    frame = HOST.encode("request", "read_log", {"station": 3, "sequence": 7, "first": 2})
    data = bytes.fromhex("00 09 03 05 01 07 02 00 02")
    assert frame == b"\xa5" + data + Crc16Modbus.calc(data).to_bytes(2, "little")
    host = link_of(module_of(STAMPER), "host")
    for place, offset in ((2, 0), (7, 6)):
        other = bytearray(data)
        other[place - 1] += 1
        wrong = b"\xa5" + other + Crc16Modbus.calc(other).to_bytes(2, "little")
        assert explained(STAMPER, "host", "request", wrong).reasons == ("wrong_length",)
        for decode in (partial(HOST.decode, wrong, "request"), partial(host.decode_request, wrong)):
            with pytest.raises((CodecError, codec_error())) as refused:
                decode()
            assert (refused.value.reason, refused.value.offset) == ("wrong_length", offset)


def test_a_response_may_have_another_subcommand_and_an_exception_response_the_flag_of_the_command() -> None:
    host = link_of(module_of(STAMPER), "host")
    head = {"station": 3, "sequence": 7}
    answer = HOST.encode("response", "write_force", head)
    assert answer[4:6] == bytes.fromhex("04 82")
    refusal = HOST.encode("response", "write_force", {**head, "reason": 2}, error=True)
    assert refusal[4:6] == bytes.fromhex("84 82")
    reply = host.decode_response(refusal)
    assert (reply.code, reply.exception.reason) == (0x0482, 2)


def test_frames_with_two_lengths_are_found_in_a_stream() -> None:
    host = link_of(module_of(STAMPER), "host")
    frames = [HOST.encode("request", "read_log", {"station": 3, "sequence": n, "first": n}) for n in range(3)]
    framer = host.request_framer()
    cut: list[bytes] = []
    for byte in b"\xa5\x00" + b"".join(frames):
        cut += framer.feed(bytes([byte]))
    assert cut[-3:] == frames


ESCAPED = """
links:
  - name: line
    source: 1 L1
    byte_order: big
    escape: {method: xor, bytes: "7E", byte: 0x7D, mask: 0x20, from: code, to: crc}
    request: &line
      - {name: size, role: length, type: u8}
      - {name: code, role: code, type: u8}
      - {name: inner, role: length, type: u8, measures: {from: data, to: data}}
      - {name: data, role: body}
      - {name: crc, role: checksum, algorithm: sum8, covers: {from: code}}
    response: *line
messages:
  - {name: write, code: 1, source: 1 L2, request: [{name: value, type: u16, source: 1 L3}], response: []}
"""


def test_a_length_of_what_is_sent_counts_the_escapes_of_a_checksum() -> None:
    spec = gadget(ESCAPED)
    layout = layout_at(spec, spec.versions()[0])
    module = module_apart(layout, "escaped_lengths")
    line, request = link_of(module, "line"), module.WriteRequest
    for value, data in ((0x7B, "00 7B"), (0x7E, "00 7D 5E")):
        inner = bytes.fromhex(f"01 02 {data}")
        total = sum(bytes.fromhex("01 02")) + value & 0xFF
        check = b"\x7d" + bytes([total ^ 0x20]) if total in (0x7D, 0x7E) else bytes([total])
        frame = bytes([1 + len(inner) + len(check)]) + inner + check
        reference = codec(layout).links["line"]
        assert reference.encode("request", "write", {"value": value}) == frame
        assert line.encode_request(request(value)) == frame
        assert reference.decode(frame, "request").values["value"] == value
