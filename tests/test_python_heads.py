"""Headers of frames with arguments and constants, with every checksum."""

from __future__ import annotations

from functools import cache
from types import ModuleType
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from drive_variants import drive_variant
from example_counts import examples
from fieldspec.codec.layout.checksums import checksum as checksum_of
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import DeviceCodec, codec
from fieldspec.language.model.checksums import SIMPLE
from layouts import TEST_SPECS, newest
from python_package import built, codec_error, module_of, outcome, package
from random_values import values_of

GLIDER = module_of(newest(TEST_SPECS, "glider-x"))
CodecError = codec_error()
BODY = "      - {name: body, role: body}\n    exception_response"
WIDE = ("{name: axis, type: u8, const: 0}", "{name: axis, type: u16, const: 0x1234}")
CHANGES: dict[str, tuple[tuple[str, str], ...]] = {
    "no_check": (),
    "wide_constant": (WIDE,),
    **{
        f"{check}_check": (
            WIDE,
            (BODY, BODY.replace("body}\n", f"body}}\n      - {{name: check, role: checksum, algorithm: {check}}}\n")),
        )
        for check in SIMPLE
    },
}


@cache
def built_from(name: str) -> tuple[DeviceLayout, ModuleType, DeviceCodec]:
    """The made-up drive with a varied channel, and its reference codec."""
    layout, module = drive_variant(f"head_{name}", CHANGES[name])
    return layout, module, codec(layout)


@pytest.mark.parametrize("name", CHANGES)
@examples(80)
@given(data=st.data())
def test_a_frame_is_made_as_the_reference_makes_it(name: str, data: st.DataObject) -> None:
    layout, module, reference = built_from(name)
    message_layout = layout.messages[data.draw(st.sampled_from(["read_parameter", "write_parameter"]))]
    direction = data.draw(st.sampled_from(["request", "response"]))
    values = data.draw(values_of(layout, message_layout.data(direction)))
    number = data.draw(st.integers(0, 256))
    message = built(module, layout, message_layout.data(direction), values)
    link = reference.links["channel"]
    expected = outcome(lambda: link.encode(direction, message_layout.name, {**values, "reference": number}))
    actual = outcome(lambda: getattr(module.channel, f"encode_{direction}")(message, reference=number))
    assert actual == expected


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", CHANGES)
@examples(120)
@given(data=st.data())
def test_a_frame_is_read_as_the_reference_reads_it(name: str, data: st.DataObject) -> None:
    layout, module, reference = built_from(name)
    link = reference.links["channel"]
    frame = bytearray(link.encode("request", "read_parameter", READ))
    for _ in range(data.draw(st.integers(0, 2))):
        frame[data.draw(st.integers(0, len(frame) - 1))] ^= data.draw(st.sampled_from([1, 0x80, 0xFF]))
    check = layout.links["channel"].request.checksum
    if check is not None and data.draw(st.booleans()):
        at = len(frame) - check.size
        frame[at:] = checksum_of(check.algorithm, bytes(frame[:at])).to_bytes(check.size, "little")
    expected = outcome(lambda: link.decode(bytes(frame), "request"))
    actual = outcome(lambda: module.channel.decode_request(bytes(frame)))
    assert actual[0] == expected[0]
    if actual[0]:
        assert actual == expected


READ = {"reference": 7, "element_count": 1, "number": 0x2317, "subindex": 3}


@pytest.mark.parametrize("name", CHANGES)
def test_a_part_that_is_always_the_same_is_no_argument_and_is_looked_at(name: str) -> None:
    layout, module, reference = built_from(name)
    link = reference.links["channel"]
    frame = bytearray(link.encode("request", "read_parameter", READ))
    request = module.channel.decode_request(bytes(frame))
    assert request.__match_args__ == ("unit_address", "message", "reference")
    frame[2] ^= 1
    check = layout.links["channel"].request.checksum
    if check is not None:
        frame[-check.size :] = checksum_of(check.algorithm, bytes(frame[: -check.size])).to_bytes(check.size, "little")
    with pytest.raises(CodecError) as caught:
        module.channel.decode_request(bytes(frame))
    assert (caught.value.reason, caught.value.offset) == ("wrong_const", 2)


def test_a_refusal_has_all_parts_of_the_head() -> None:
    frame = bytes.fromhex("07 81 00 44 00 01")
    reply = GLIDER.channel.decode_response(frame, GLIDER.ReadParameterRequest)
    assert isinstance(reply, package().ExceptionResponse)
    assert (reply.reference, reply.code, reply.unit_address) == (7, 1, 0)
    assert reply.exception.error_number is GLIDER.ErrorNumber.NOT_WRITABLE
    assert GLIDER.channel.encode_exception_response(1, reply.exception, reference=7) == frame
    assert repr(reply).startswith("ChannelExceptionResponse(unit_address=0, code=1, ")
    for wrong in (0, 256, "7"):
        with pytest.raises(CodecError) as caught:
            GLIDER.channel.encode_exception_response(1, reply.exception, reference=wrong)
        assert caught.value.detail.startswith("reference is ")


def test_requests_differ_where_a_part_of_the_head_does() -> None:
    def request(reference: int) -> Any:
        return GLIDER.channel.decode_request(bytes([reference]) + bytes.fromhex("01 00 01 23 17 00 00"))

    assert request(7) == request(7)
    assert request(7) != request(8)
