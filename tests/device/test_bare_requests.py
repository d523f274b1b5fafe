"""A simulated device takes from the generated codec only what the reference would decode equally."""

from __future__ import annotations

import random
from collections.abc import Iterator

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.codec.reference.frames import FrameCodec
from fieldspec.tools.simulator.bare_requests import bare_decoder, has_bare_requests
from fieldspec.tools.simulator.codecs import device_module, link_codec
from fieldspec.tools.simulator.raw_values import initial_values
from fieldspec.tools.simulator.received import received
from layouts import SPECS, TEST_SPECS, layouts, newest

BARE = [
    pytest.param(versions[-1], link, id=f"{name}-{link.name}")
    for root in (SPECS, TEST_SPECS)
    for name, versions in layouts(root).items()
    for link in versions[-1].links.values()
    if has_bare_requests(link)
]


def frames_of(layout: DeviceLayout, frames: FrameCodec) -> Iterator[bytes]:
    """Requests with every code, whole ones and ones with other bits, most of these with a right checksum."""
    chance = random.Random(layout.device.id)
    address = frames.link.request.role("unit_address")
    assert address is not None
    for name, message in frames.link.carried("request").items():
        for number in (0, 1, 2):
            values = initial_values(layout.device, message.request)
            try:
                frame = frames.encode("request", name, {address.name: number, **values})
            except CodecError:
                continue
            yield frame
            for _ in range(12):
                parts = bytearray(frames.original_parts(frame, "request"))
                for _ in range(chance.randrange(1, 4)):
                    parts[chance.randrange(len(parts))] ^= 1 << chance.randrange(8)
                yield bytes(parts)
                yield frames.joined_parts("request", frames.with_checksum("request", bytes(parts)))


@pytest.mark.parametrize(("layout", "link"), BARE)
def test_the_generated_codec_says_of_a_request_what_the_reference_says(layout: DeviceLayout, link: LinkLayout) -> None:
    frames = codec(layout).links[link.name]
    decode = bare_decoder(link_codec(device_module(layout), link.name), link)
    for frame in frames_of(layout, frames):
        bare, expected = received(frames, 1, frame, "", decode), received(frames, 1, frame, "")
        assert bare == expected, frame.hex(" ")
        values = [getattr(request, "values", None) or {} for request in (bare, expected)]
        assert repr(values[0]) == repr(values[1])


def test_requests_that_read_and_write_registers_are_decoded_by_the_generated_codec() -> None:
    layout = newest(SPECS, "tc100")
    frames = codec(layout).links["rtu"]
    decode = bare_decoder(link_codec(device_module(layout), "rtu"), layout.links["rtu"])
    decoded = set()
    for frame in frames_of(layout, frames):
        bare = decode(frame)
        if bare is not None:
            decoded.add(bare.message.name)
    assert decoded == set(frames.link.carried("request"))
