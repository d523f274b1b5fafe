"""Framers of links on which neither a length nor the code alone determines where frames end."""

from __future__ import annotations

import random
from types import ModuleType
from typing import Any

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from layouts import TEST_SPECS
from layouts import layouts as layouts_of
from python_package import link_of, module_of, runtime
from streams import frames_of, linker, linker_module, pieces_of

DIRECTIONS = ("request", "response")
NEWEST = [versions[-1] for versions in layouts_of(TEST_SPECS).values()]


def stands_out(framer: Any) -> bool:
    """Whether frames are recognized after garbage: other bytes than those of the garbage begin them, or a checksum."""
    frames = framer.frames
    return bool(frames.start or (frames.has_checksum and not isinstance(framer, runtime("_escapes").EscapeFramer)))


def lost_frames(layout: DeviceLayout, module: ModuleType) -> list[str]:
    """The links and directions on which a framer does not return all frames of a stream in their order."""
    wrong = []
    for link in layout.links:
        for direction in DIRECTIONS:
            make = getattr(link_of(module, link), f"{direction}_framer", None) if link in layout.links else None
            if make is None:
                continue
            chance = random.Random(f"{layout.device.id} {link} {direction}")
            frames = frames_of(layout, link, direction, chance)
            framer = make()
            received = []
            ends_by_idle = "only `idle`" in " ".join(make.__doc__.split())
            for stream in [[frame] for frame in frames] if ends_by_idle else [frames]:
                for piece in pieces_of(stream, 3 if stands_out(framer) else 0, chance):
                    received += framer.feed(piece)
                    assert len(framer._buffer) <= getattr(framer, "most", framer.longest)
                received += framer.idle()
            if received != frames:
                wrong.append(f"{link} {direction}: {len(received)} of {len(frames)}")
    return wrong


def test_all_frames_come_out_of_a_stream_with_garbage() -> None:
    assert lost_frames(linker(), linker_module()) == []


@pytest.mark.proof(14)
@pytest.mark.parametrize("layout", NEWEST, ids=lambda layout: layout.device.id)
def test_all_frames_of_made_up_devices_come_out(layout: DeviceLayout) -> None:
    assert lost_frames(layout, module_of(layout)) == []
