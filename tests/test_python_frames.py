"""The generated Python codecs against all example frames, and frame by frame against the reference codec."""

from __future__ import annotations

from functools import cache
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import CHECKSUMS, PartLayout
from fieldspec.layout.values import body_of, raw_values
from fieldspec.model.texts import Example
from fieldspec.reference import CodecError, DeviceCodec, codec
from laid_out import all_layouts
from made_python import built, class_of, codec_error, link_of, made, only_stored, outcome, raw, raws, record_class
from random_values import values_of

EXAMPLE_COUNT = 150
LAID_OUT = {f"{layout.device.id}-{layout.device.version}": layout for layout in all_layouts()}
EXAMPLES = [
    pytest.param(layout, example, id=f"{name}-{example.id}")
    for name, layout in LAID_OUT.items()
    for example in layout.device.examples.values()
]


@cache
def _reference(name: str) -> DeviceCodec:
    return codec(LAID_OUT[name])


def reference_of(layout: DeviceLayout) -> DeviceCodec:
    """The reference codec of a layout, which takes a while to be built."""
    return _reference(f"{layout.device.id}-{layout.device.version}")


def decode(layout: DeviceLayout, link: str, direction: str, message: str, frame: bytes) -> Any:
    """What the generated codec makes of a frame; `message` says what a frame without a code is, or must be."""
    module = made(layout)
    spoken = link_of(module, link)
    coded = layout.links[link].frame(direction).role("code") is not None
    if direction == "request":
        return (
            spoken.decode_request(frame)
            if coded
            else spoken.decode_request(frame, record_class(module, layout.messages[message].request))
        )
    if message:
        return spoken.decode_response(frame, record_class(module, layout.messages[message].request))
    return spoken.decode_response(frame)


def encode(layout: DeviceLayout, example: Example, values: dict[str, Any], code: int) -> bytes:
    """The frame that the generated codec makes of an example's meaning; `code` is that of a refused request."""
    module = made(layout)
    spoken, frame = link_of(module, example.link), layout.links[example.link].frame(example.direction)
    body = built(
        module,
        layout,
        body_of(layout, example.link, example.direction, example.message, example.exception_response),
        values,
    )
    station = frame.role("unit_address")
    first = [values[station.name]] if station else []
    plain = {part.name: head_value(module, part, values[part.name]) for part in frame.head if given_part(part)}
    named = {name if name not in KEYWORDS else f"{name}_": held for name, held in plain.items()}
    if example.exception_response:
        made_frame = spoken.encode_error(*first, code, body, **named)
    else:
        made_frame = getattr(spoken, f"encode_{example.direction}")(*first, body, **named)
    assert isinstance(made_frame, bytes)
    return made_frame


KEYWORDS = {"return"}


def given_part(part: PartLayout) -> bool:
    """Whether a part of the head is neither of a special kind nor always the same."""
    return part.role == "plain" and part.is_argument


def head_value(module: Any, part: Any, held: int) -> Any:
    """What a part of the head is given as."""
    return class_of(module, part.value.flags, "Flags")(held) if part.value.flags else held


def head_of(layout: DeviceLayout, link: str, direction: str, decoded: Any) -> dict[str, Any]:
    """The parts of the head of what was decoded, by the names of the spec, but for the code."""
    found = {}
    for part in layout.links[link].frame(direction).head:
        if part.role == "unit_address":
            found[part.name] = decoded.station
        elif given_part(part):
            name = part.name if hasattr(decoded, part.name) else f"{part.name}_"
            found[part.name] = raw(getattr(decoded, name))
    return found


@pytest.mark.parametrize(("layout", "example"), EXAMPLES)
def test_an_example_frame_means_what_the_spec_says_and_is_made_of_it(layout: DeviceLayout, example: Example) -> None:
    if example.refused:
        with pytest.raises(codec_error()) as caught:
            decode(layout, example.link, example.direction, example.message, example.frame)
        assert caught.value.reason == example.refused
        return
    asked = (layout, example.link, example.direction, example.message, example.frame)
    error, code, head, body = made_of(*asked)
    assert (error, code, head, body) == meant_by(*asked)
    written = raw_values(layout, example)
    assert all(head.get(name, held) == held for name, held in written.items())
    assert all(holds(body.get(name, held), held) for name, held in written.items())
    assert encode(layout, example, {**head, **body, **written}, code) == example.frame


def holds(actual: Any, written: Any) -> bool:
    """Whether a value is what the spec says of it; reserved fields and constants of records are not compared."""
    if isinstance(actual, dict):
        return all(holds(held, written[name]) for name, held in actual.items() if name in written)
    if isinstance(actual, list):
        return len(actual) == len(written) and all(map(holds, actual, written))
    return bool(actual == written)


@pytest.mark.parametrize("name", LAID_OUT)
@settings(max_examples=EXAMPLE_COUNT, deadline=None)
@given(data=st.data())
def test_a_frame_is_read_or_refused_as_the_reference_does(name: str, data: st.DataObject) -> None:
    layout = LAID_OUT[name]
    link = data.draw(st.sampled_from(sorted(layout.links)))
    direction = data.draw(st.sampled_from(["request", "response"]))
    coded = layout.links[link].frame(direction).role("code") is not None
    message = data.draw(st.sampled_from(sorted(layout.links[link].messages)))
    reference = reference_of(layout).links[link]
    record = layout.messages[message].data(direction)
    values = data.draw(values_of(layout, record))
    heads = {
        p.name: p.value.ranges.low if p.value and p.value.ranges else 1
        for p in layout.links[link].frame(direction).head
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
    actual = outcome(lambda: made_of(layout, link, direction, asked, frame))
    assert actual == outcome(lambda: meant_by(layout, link, direction, asked, frame))


@pytest.mark.parametrize("name", LAID_OUT)
def test_an_example_with_one_wrong_byte_is_refused_as_the_reference_does(name: str) -> None:
    layout = LAID_OUT[name]
    shapes = {(one.link, one.direction, one.message, len(one.frame)): one for one in layout.device.examples.values()}
    for example in shapes.values():
        coded = layout.links[example.link].frame(example.direction).role("code") is not None
        message = "" if coded and example.direction == "request" else example.message
        for at, byte in enumerate(example.frame):
            for other in (byte ^ 1, byte ^ 0x80, 7):
                frame = example.frame[:at] + bytes([other]) + example.frame[at + 1 :]
                asked = (layout, example.link, example.direction, message, frame)
                assert outcome(lambda: made_of(*asked)) == outcome(lambda: meant_by(*asked)), frame.hex(" ")  # noqa: B023


def made_of(layout: DeviceLayout, link: str, direction: str, message: str, frame: bytes) -> Any:
    """What the generated codec finds in a frame: whether it is a refusal, the code, the head, the body."""
    decoded = decode(layout, link, direction, message, frame)
    head, coded = head_of(layout, link, direction, decoded), layout.links[link].frame(direction).role("code")
    refusal = layout.links[link].link.exception_response
    if refusal is not None and hasattr(decoded, "exception"):
        return True, decoded.code, head, raws(decoded.exception, layout.records[refusal.record])
    content = decoded.message
    records = (laid.data(direction) for laid in layout.messages.values())
    record = next(record for record in records if record_class(made(layout), record) is type(content))
    return False, type(content).CODE if coded else None, head, raws(content, record)


def meant_by(layout: DeviceLayout, link: str, direction: str, message: str, frame: bytes) -> Any:
    """The same of the reference."""
    decoded = reference_of(layout).links[link].decode(frame, direction, message)
    coded, head = layout.links[link].frame(direction).role("code"), dict(decoded.head)
    code = head.pop(coded.name) if coded else None
    for part in layout.links[link].frame(direction).head:
        if part.role == "plain" and not given_part(part):
            head.pop(part.name, None)
    assert decoded.body is not None
    return decoded.error, code, head, only_stored(decoded.body, decoded.values)


def _with_right_check(layout: DeviceLayout, link: str, direction: str, frame: bytes) -> bytes:
    """The same frame with the check and the length that its bytes should have: what lies within is then looked at."""
    reference = reference_of(layout).links[link]
    shape = layout.links[link].frame(direction)
    try:
        data = bytearray(reference.parts(frame))
    except CodecError:
        return frame
    length, check = shape.role("length"), shape.checksum
    if len(data) < shape.head_size + shape.tail_size:
        return frame
    units = length.number(len(data)) if length is not None else None
    if length is not None and units is not None:
        order = "big" if length.order == "big" else "little"
        data[length.offset : length.offset + length.size] = units.to_bytes(length.size, order)
    if check is not None:
        at = check.at(len(data))
        order = "big" if check.order == "big" else "little"
        number = CHECKSUMS[check.algorithm](bytes(data[check.start : check.stop]))
        data[at : at + check.size] = number.to_bytes(check.size, order)
    marks = layout.links[link].link
    inner = bytes(data).hex().upper().encode() if marks.encoding == "hex_ascii" else bytes(data)
    return marks.start + inner + marks.end
