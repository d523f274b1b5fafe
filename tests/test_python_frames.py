"""The generated Python codecs against all example frames, and frame by frame against the reference codec."""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from example_counts import examples
from fieldspec.codec.layout.checksums import checksum as checksum_of
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.values import body_of, raw_values
from fieldspec.codec.reference import CodecError, DeviceCodec, codec
from fieldspec.language.model.texts import Example
from layouts import all_layouts
from python_package import (
    built,
    class_of,
    codec_error,
    link_of,
    module_of,
    only_stored,
    outcome,
    raw,
    raws,
    record_class,
)
from random_values import values_of

EXAMPLE_COUNT = 50
LAYOUTS = {f"{layout.device.id}-{layout.device.version}": layout for layout in all_layouts()}
EXAMPLES = [
    pytest.param(layout, example, id=f"{name}-{example.id}")
    for name, layout in LAYOUTS.items()
    for example in layout.device.examples.values()
]


@cache
def _reference(name: str) -> DeviceCodec:
    return codec(LAYOUTS[name])


def reference_of(layout: DeviceLayout) -> DeviceCodec:
    """The reference codec of a layout, which takes a while to be built."""
    return _reference(f"{layout.device.id}-{layout.device.version}")


def decode(layout: DeviceLayout, link: str, direction: str, message: str, frame: bytes) -> Any:
    """The result of the generated codec for a frame; `message` identifies a frame without a code."""
    module = module_of(layout)
    spoken = link_of(module, link)
    coded = layout.links[link].frame(direction).role("code") is not None
    if direction == "request":
        return (
            spoken.decode_request(frame)
            if coded
            else spoken.decode_request(frame, record_class(module, layout.messages[message].request))
        )
    if message and layout.messages[message].message.is_requested:
        return spoken.decode_response(frame, record_class(module, layout.messages[message].request))
    return spoken.decode_response(frame) if coded else spoken.decode_response(frame, message)


def encode(layout: DeviceLayout, example: Example, values: dict[str, Any], code: int) -> bytes:
    """The frame that the generated codec encodes from the values of an example; `code` is that of the request."""
    module = module_of(layout)
    spoken, frame = link_of(module, example.link), layout.links[example.link].frame(example.direction)
    body = built(
        module,
        layout,
        body_of(layout, example.link, example.direction, example.message, example.exception_response),
        values,
    )
    station = frame.role("unit_address")
    first = [values[station.name]] if station else []
    parts = {part.name: head_value(module, part, values[part.name]) for part in frame.header if is_argument(part)}
    named = {name if name not in KEYWORDS else f"{name}_": value for name, value in parts.items()}
    if example.exception_response:
        codes = [code] if frame.role("code") is not None else []
        encoded = spoken.encode_exception_response(*first, *codes, body, **named)
    else:
        encoded = getattr(spoken, f"encode_{example.direction}")(*first, body, **named)
    assert isinstance(encoded, bytes)
    return encoded


KEYWORDS = {"return"}


def is_argument(part: PartLayout) -> bool:
    """Whether a header part is an argument besides the unit address."""
    return part.role == "plain" and part.is_argument


def head_value(module: Any, part: Any, number: int) -> Any:
    """The argument for a header part."""
    return class_of(module, part.value.flags, "Flags")(number) if part.value.flags else number


def head_of(layout: DeviceLayout, link: str, direction: str, decoded: Any) -> dict[str, Any]:
    """The header parts of a decoded frame by the names of the spec, without the code."""
    parts = {}
    for part in layout.links[link].frame(direction).header:
        if part.role == "unit_address":
            parts[part.name] = decoded.unit_address
        elif is_argument(part):
            name = part.name if hasattr(decoded, part.name) else f"{part.name}_"
            parts[part.name] = raw(getattr(decoded, name))
    return parts


@pytest.mark.parametrize(("layout", "example"), EXAMPLES)
def test_an_example_frame_means_what_the_spec_says_and_is_made_of_it(layout: DeviceLayout, example: Example) -> None:
    if example.refused:
        with pytest.raises(codec_error()) as caught:
            decode(layout, example.link, example.direction, example.message, example.frame)
        assert caught.value.reason == example.refused
        return
    asked = (layout, example.link, example.direction, example.message, example.frame)
    error, code, head, body = decoded_by_codec(*asked)
    assert (error, code, head, body) == decoded_by_reference(*asked)
    expected = raw_values(layout, example)
    assert all(head.get(name, value) == value for name, value in expected.items())
    assert all(holds(body.get(name, value), value) for name, value in expected.items())
    shape, frame = layout.links[example.link].frame(example.direction), example.frame
    encoded = encode(layout, example, {**head, **body, **expected}, code)
    # A frame may have a longer preamble than the one that is sent.
    assert encoded[shape.surplus(encoded) :] == frame[shape.surplus(frame) :]


def holds(actual: Any, expected: Any) -> bool:
    """Whether a value is the expected one; reserved fields and constants of records are not compared."""
    if isinstance(actual, dict):
        return all(holds(value, expected[name]) for name, value in actual.items() if name in expected)
    if isinstance(actual, list):
        return len(actual) == len(expected) and all(map(holds, actual, expected))
    return bool(actual == expected)


@pytest.mark.proof(8)
@pytest.mark.parametrize("name", LAYOUTS)
@examples(EXAMPLE_COUNT)
@given(data=st.data())
def test_a_frame_is_read_or_refused_as_the_reference_does(name: str, data: st.DataObject) -> None:
    layout = LAYOUTS[name]
    link = data.draw(st.sampled_from(sorted(layout.links)))
    ways = [way for way in ("request", "response") if layout.links[link].carried(way)]
    direction = data.draw(st.sampled_from(ways))
    coded = layout.links[link].frame(direction).role("code") is not None
    messages = layout.links[link].messages if direction == "response" else layout.links[link].carried("request")
    message = data.draw(st.sampled_from(sorted(messages)))
    reference = reference_of(layout).links[link]
    record = layout.messages[message].data(direction)
    values = data.draw(values_of(layout, record))
    heads = {
        p.name: p.value.ranges.low if p.value and p.value.ranges else 1
        for p in layout.links[link].frame(direction).header
    }
    stations = layout.links[link].link.unit_addresses
    station = layout.links[link].frame(direction).role("unit_address")
    if stations and stations.ranges and station:
        heads[station.name] = stations.ranges.low
    try:
        frame = reference.encode(direction, message, {**heads, **values})
    except (CodecError, UnicodeEncodeError):
        return
    spoiled = bytearray(frame)
    for _ in range(data.draw(st.integers(0, 2)) if spoiled else 0):
        spoiled[data.draw(st.integers(0, len(spoiled) - 1))] = data.draw(st.integers(0, 255))
    frame = bytes(spoiled[: data.draw(st.one_of(st.just(len(spoiled)), st.integers(0, len(spoiled))))])
    asked = message if not coded or (direction == "response" and data.draw(st.booleans())) else ""
    if data.draw(st.booleans()):
        frame = _with_right_check(layout, link, direction, frame)
    actual = outcome(lambda: decoded_by_codec(layout, link, direction, asked, frame))
    assert actual == outcome(lambda: decoded_by_reference(layout, link, direction, asked, frame))


@pytest.mark.proof(8)
@pytest.mark.parametrize("name", LAYOUTS)
def test_an_example_with_one_wrong_byte_is_refused_as_the_reference_does(name: str) -> None:
    layout = LAYOUTS[name]
    shapes = {
        (example.link, example.direction, example.message, len(example.frame)): example
        for example in layout.device.examples.values()
    }
    for example in shapes.values():
        coded = layout.links[example.link].frame(example.direction).role("code") is not None
        message = "" if coded and example.direction == "request" else example.message
        for at, byte in enumerate(example.frame):
            for other in (byte ^ 1, byte ^ 0x80, 7):
                frame = example.frame[:at] + bytes([other]) + example.frame[at + 1 :]
                asked = (layout, example.link, example.direction, message, frame)
                expected = outcome(partial(decoded_by_reference, *asked))
                assert outcome(partial(decoded_by_codec, *asked)) == expected, frame.hex(" ")


def decoded_by_codec(layout: DeviceLayout, link: str, direction: str, message: str, frame: bytes) -> Any:
    """A frame decoded by the generated codec: whether it is an exception response, the code, the header, the body."""
    decoded = decode(layout, link, direction, message, frame)
    head, coded = head_of(layout, link, direction, decoded), layout.links[link].frame(direction).role("code")
    refusal = layout.links[link].link.exception_response
    if refusal is not None and hasattr(decoded, "exception"):
        return True, decoded.code if coded else None, head, raws(decoded.exception, layout.records[refusal.record])
    content = decoded.message
    records = (body for message_layout in layout.messages.values() for body in message_layout.bodies)
    record = next(record for record in records if record_class(module_of(layout), record) is type(content))
    return False, type(content).CODE if coded else None, head, raws(content, record)


def decoded_by_reference(layout: DeviceLayout, link: str, direction: str, message: str, frame: bytes) -> Any:
    """The same by the reference codec."""
    decoded = reference_of(layout).links[link].decode(frame, direction, message)
    coded, head = layout.links[link].frame(direction).role("code"), dict(decoded.head)
    code = head.pop(coded.name) if coded else None
    for part in layout.links[link].frame(direction).header:
        if part.role == "plain" and not is_argument(part):
            head.pop(part.name, None)
    assert decoded.body is not None
    return decoded.error, code, head, only_stored(decoded.body, decoded.values)


def _with_right_check(layout: DeviceLayout, link: str, direction: str, frame: bytes) -> bytes:
    """The frame with the right checksum and length, so that the bytes in between are decoded."""
    reference = reference_of(layout).links[link]
    shape = layout.links[link].frame(direction)
    try:
        data = bytearray(reference.parts(frame, direction))
    except CodecError:
        return frame
    length, check = shape.role("length"), shape.checksum
    if len(data) < shape.header_size + shape.trailer_size:
        return frame
    units = length.number(len(data)) if length is not None else None
    if length is not None and units is not None:
        order = "big" if length.order == "big" else "little"
        data[length.offset : length.offset + length.size] = units.to_bytes(length.size, order)
    if check is not None:
        at = check.at(len(data))
        order = "big" if check.order == "big" else "little"
        number = checksum_of(check.algorithm, bytes(data[check.start : check.stop]))
        data[at : at + check.size] = number.to_bytes(check.size, order)
    marks = layout.links[link].link
    inner = bytes(data).hex().upper().encode() if marks.transmission == "hex_ascii" else bytes(data)
    return marks.start + inner + marks.end
