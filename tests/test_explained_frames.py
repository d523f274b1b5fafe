"""Explanations of single frames of random devices: tables, values of sets, and escapes."""

from __future__ import annotations

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.explain.readings import FrameOptions, read_frame, remarks_on
from fieldspec.codec.explain.row import Spot
from fieldspec.codec.reference import codec
from random_devices.agreement import layouts_of
from random_devices.fuzz import CASES


def test_fields_that_begin_in_the_middle_of_a_word_are_read_from_there() -> None:
    (layout,) = layouts_of((CASES / "bytes-of-words.yaml").read_text("utf-8"))
    data = bytes.fromhex("01 FE 00 05 41 42 43 07 08 09")
    words = [int.from_bytes(data[at : at + 2], "big") for at in range(0, len(data), 2)]
    request = codec(layout).links["serial"].encode("request", "write_words", {"address": 0x4008, "values": words})
    rows = explained(layout, "serial", "request", request).registers
    assert [(row.path.removeprefix("entries[1]."), row.number, row.offset, row.length) for row in rows] == [
        ("mode", 1, 5, 1),
        ("shift", -2, 6, 1),
        ("speed", 5, 7, 2),
        ("title", "ABC", 9, 3),
        ("limits[0]", 7, 12, 1),
        ("limits[1]", 8, 13, 1),
        ("limits[2]", 9, 14, 1),
    ]


def test_the_values_of_a_set_are_named_by_the_numbers_of_its_parameters() -> None:
    spec = (CASES / "parameters-in-rows.yaml").read_text("utf-8")
    (layout,) = layouts_of(spec)
    answer = explained(layout, "serial", "response", bytes.fromhex("02 0001 0002 0003"), "read_all")
    meanings = [(row.path, row.meanings[0].name) for row in answer.rows[1:]]
    assert meanings == [("values[0]", "speed"), ("values[1]", "speed"), ("values[2]", "stroke")]


def test_the_code_of_cobs_before_no_data_is_explained() -> None:
    (layout, *_) = layouts_of((CASES / "137a6d61.yaml").read_text("utf-8"))
    rows = explained(layout, "speed_25", "response", bytes.fromhex("01 00"), "limit_42").rows
    assert [(row.path, row.offset, row.raw.hex(), row.verdict) for row in rows] == [
        ("escape", 0, "01", "right"),
        ("end", 1, "00", "right"),
    ]


@pytest.mark.parametrize(("frame", "size"), [("02 05 00", "1 byte"), ("01 02 03 00", "2 bytes")])
def test_the_size_of_a_frame_is_counted_as_those_of_messages_are(frame: str, size: str) -> None:
    (layout, *_) = layouts_of((CASES / "137a6d61.yaml").read_text("utf-8"))
    options = FrameOptions((("speed_25", "response"),), "limit_42")
    chosen = read_frame(layout, bytes.fromhex(frame), options)
    assert list(remarks_on(layout, chosen, 0, options))[1] == (
        f"without its delimiters and escapes, the frame has {size}; limit_42 response has 0"
    )


@pytest.mark.parametrize(("width", "text"), [(1, "byte 4"), (2, "byte 7")])
def test_texts_count_the_bytes_and_characters_of_the_whole_frame(width: int, text: str) -> None:
    assert Spot(bytes(9), start=1, width=width).byte_text(3) == text
