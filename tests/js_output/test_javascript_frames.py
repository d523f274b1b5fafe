"""The generated JavaScript against all example frames and against damaged ones, as the reference codec reads them."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import codec
from fieldspec.language.model.texts import Example
from js_output.javascript import expectation, judged, module_path
from layouts import all_layouts

LAYOUTS = {f"{layout.device.id}-{layout.device.version}": layout for layout in all_layouts()}
DAMAGED_FRAMES = 12
"""The damaged frames of each example."""


def job(layout: DeviceLayout, example: Example, number: int, frame: bytes) -> dict[str, Any]:
    return {
        "id": f"{example.id}#{number}",
        "module": module_path(layout),
        "link": example.link,
        "direction": example.direction,
        "message": "" if coded(layout, example) else example.message,
        "frame": frame.hex(),
        "coded": layout.links[example.link].frame(example.direction).role("code") is not None,
    }


def coded(layout: DeviceLayout, example: Example) -> bool:
    """Whether frames like that of an example carry the code of their message."""
    return not layout.links[example.link].is_guessed(example.direction, example.message)


def damaged(frame: bytes, chance: random.Random) -> bytes:
    data = bytearray(frame)
    kind = chance.randrange(4)
    place = chance.randrange(len(data)) if data else 0
    if kind == 0 and data:
        data[place] ^= 1 << chance.randrange(8)
    elif kind == 1 and data:
        del data[place:]
    elif kind == 2:
        data.insert(place, chance.randrange(256))
    else:
        data = bytearray(chance.randbytes(chance.randrange(20)))
    return bytes(data)


def checked_again(layout: DeviceLayout, example: Example, frame: bytes) -> bytes:
    """A damaged frame with a right checksum, so that what follows that test is tried too."""
    shape = layout.links[example.link].frame(example.direction)
    link = layout.links[example.link].link
    if link.start or link.end or link.transmission != "binary" or len(frame) < shape.header_size + shape.trailer_size:
        return frame
    data = bytearray(frame)
    for part in shape.checksums:
        at = part.at(len(data))
        data[at : at + part.size] = part.checksum(bytes(data))
    return bytes(data)


def frames_of(layout: DeviceLayout, example: Example) -> Iterator[bytes]:
    chance = random.Random(f"{layout.device.id} {example.id}")
    yield example.frame
    for number in range(DAMAGED_FRAMES):
        frame = damaged(example.frame, chance)
        yield checked_again(layout, example, frame) if number % 2 else frame


@pytest.mark.proof(8)
@pytest.mark.parametrize("name", LAYOUTS)
def test_frames_are_read_or_refused_as_the_reference_does(name: str) -> None:
    layout = LAYOUTS[name]
    reference = codec(layout)
    jobs, expected = [], []
    for example in layout.device.examples.values():
        message = "" if coded(layout, example) else example.message
        for number, frame in enumerate(frames_of(layout, example)):
            jobs.append(job(layout, example, number, frame))
            expected.append((frame, expectation(layout, reference, example.link, example.direction, message, frame)))
    for have, (frame, want) in zip(judged(jobs), expected, strict=True):
        assert ("error" in have) == ("error" in want), (have, want, frame.hex(" "))
        if "error" in want:
            assert have["error"][0] == want["error"][0], (have, want, frame.hex(" "))
            if want["error"][1] is not None:
                assert have["error"][1] == want["error"][1], (have, want, frame.hex(" "))
        else:
            assert have["value"] == want["value"], (have["id"], frame.hex(" "))


@pytest.mark.proof(8)
@pytest.mark.parametrize("name", LAYOUTS)
def test_an_example_is_encoded_as_it_was_read(name: str) -> None:
    layout = LAYOUTS[name]
    examples = [example for example in layout.device.examples.values() if not example.refused]
    results = judged(job(layout, example, 0, example.frame) for example in examples)
    for example, have in zip(examples, results, strict=True):
        sent = layout.links[example.link].frame(example.direction).as_sent(example.frame)
        assert have.get("again") == sent.hex(), (have["id"], have)
