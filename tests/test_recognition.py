"""A frame alone tells what it may be: its link, its direction and its message."""

from __future__ import annotations

import pytest

from fieldspec.codec.explain.recognition import closest, recognised
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.texts import Example
from layouts import TEST_SPECS, all_layouts, newest

EXAMPLES = [
    pytest.param(layout, example, id=f"{layout.device.id}@{layout.device.version}-{example.id}")
    for layout in all_layouts()
    for example in layout.device.examples.values()
    if not example.refused
]
WIDGET = newest(TEST_SPECS, "widget")


@pytest.mark.parametrize(("layout", "example"), EXAMPLES)
def test_every_example_is_recognised(layout: DeviceLayout, example: Example) -> None:
    explanations = recognised(layout, example.frame)
    link, message = layout.links[example.link], example.message
    # Only the request tells what an exception response answers that has a code of its own, or one that messages share.
    if example.exception_response and message and (mark := link.link.exception_response):
        shared = link.subcodes("request")
        is_nameless = mark.code is not None or mark.field
        message = "" if is_nameless or link.messages[message].message.code in shared else message
    assert (example.link, example.direction, message, example.exception_response) in explanations


def test_a_frame_that_is_equal_in_both_directions_is_ambiguous() -> None:
    frame = bytes.fromhex("00 06 20 00 00 05 43 D8")
    assert recognised(WIDGET, frame) == [
        ("rtu", "request", "write_register", False),
        ("rtu", "response", "write_register", False),
    ]


def test_a_frame_with_a_wrong_checksum_is_not_recognised_but_has_a_closest_reading() -> None:
    frame = WIDGET.device.examples["wrong-crc"].frame
    assert recognised(WIDGET, frame) == []
    assert closest(WIDGET, frame) == [("rtu", "request", "read_registers", False)]


def test_bytes_that_are_no_frame_are_not_recognised() -> None:
    assert recognised(WIDGET, b"") == []
    assert closest(WIDGET, b"no frame at all") == []
