"""BCD with a sign nibble, and hexadecimal digits with the low byte first, as others have published them."""

from __future__ import annotations

from typing import Any

import pytest

from fieldspec.codec.explain.explanation import explained
from fieldspec.codec.reference import codec
from fieldspec.language.model.raw_numbers import bytes_of_number, number_in
from layouts import TEST_SPECS, newest
from python_package import codec_error, link_of, module_of

LEVER = newest(TEST_SPECS, "lever")
REFERENCE = codec(LEVER).links["line"]
PYTHON = link_of(module_of(LEVER), "line")

PUBLISHED = {
    # Siemens, Statement List for S7-300 and S7-400: ITB, DTB and BTI with their examples.
    ("counters", "word", "F4 13"): -413,
    ("counters", "word", "09 15"): 915,
    ("counters", "double", "F0 00 07 01"): -701,
    # IBM z/Architecture Principles of Operation, "Decimal-Number Formats": packed +123 and -123, and an unsigned one.
    ("counters", "balance", "12 3C"): 123,
    ("counters", "balance", "12 3D"): -123,
    ("counters", "total", "3F 12 00 00"): 123,
    # Victron, BlueSolar HEX protocol: `:7F0ED009600DB`, a maximum current of 15.0 A in register 0xEDF0.
    ("get_register", "register", "46 30 45 44"): 0xEDF0,
    ("get_register", "current", "39 36 30 30"): 150,
}


def value_of(message: str, name: str) -> Any:
    field = next(own for own in LEVER.device.messages[message].response.fields if own.name == name)
    order = "little" if name == "total" else "big"
    return field.value, order


@pytest.mark.parametrize(("case", "number"), PUBLISHED.items(), ids=str)
def test_published_digits_are_read_and_written(case: tuple[str, str, str], number: int) -> None:
    message, name, data = case
    value, order = value_of(message, name)
    raw = bytes.fromhex(data)
    assert number_in(value, raw, order, False) == number
    assert bytes_of_number(value, number) == (raw if order == "big" else raw[::-1])


FRAMES = {
    "05 F4 13 F0 00 07 01 12 3D 3F 12 00 00": {"word": -413, "double": -701, "balance": -123, "total": 123},
    "3A " + b"7F0ED009600DB".hex(" "): {"function": 7, "register": 0xEDF0, "flags": 0, "current": 150, "check": 0xDB},
}


@pytest.mark.parametrize("frame", FRAMES)
def test_all_codecs_read_a_frame_of_them_and_write_it_again(frame: str) -> None:
    data, numbers = bytes.fromhex(frame), FRAMES[frame]
    assert REFERENCE.decode(data, "response").values == numbers
    message = PYTHON.decode_response(data).message
    assert {name: getattr(message, name) for name in numbers} == numbers
    assert PYTHON.encode_response(message) == data
    rows = {row.path: row for row in explained(LEVER, "line", "response", data).rows}
    assert {name: rows[name].number for name in numbers} == numbers


WRONG = {
    "a nibble that is not a digit": "05 A4 13 F0 00 07 01 12 3D 3F 12 00 00",
    "a sign that is no first nibble": "05 F4 F3 F0 00 07 01 12 3D 3F 12 00 00",
    "a last nibble that is not a sign": "05 F4 13 F0 00 07 01 12 3F 3F 12 00 00",
    "a sign where there is none": "05 F4 13 F0 00 07 01 12 3D 3C 12 00 00",
}


@pytest.mark.parametrize("frame", WRONG.values(), ids=WRONG)
def test_other_nibbles_are_refused(frame: str) -> None:
    with pytest.raises(codec_error(), match="not the digits of a number"):
        PYTHON.decode_response(bytes.fromhex(frame))
