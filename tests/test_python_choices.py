"""Fields whose type another one decides, in the generated Python: also in the other byte order, alone, in two bytes."""

from __future__ import annotations

from functools import cache
from types import ModuleType
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from drive_variants import drive_variant
from example_counts import examples
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.records import decoded, encoded
from layouts import TEST_SPECS, newest
from python_package import built, codec_error, module_of, only_stored, outcome, raws, record_class
from random_values import bytes_of, values_of

GLIDER = module_of(newest(TEST_SPECS, "glider-x"))
CodecError = codec_error()
LITTLE = ("byte_order: big\n    word_order: big", "byte_order: little\n    word_order: little")
WORDS = ("byte_order: big\n    word_order: big", "byte_order: big\n    word_order: little")
ALONE = ("repeat: 1..8, parameter", "parameter")
ALONE_TOO = ("        repeat: 1..8\n", "")
BYTES = ("measures: {items: values}", "measures: {bytes: values}")
WIDE = ("{name: format, type: u8, enum: format}", "{name: format, type: u16, enum: format}")
TEXT = ("{name: boolean, when: [boolean], type: bool8}", "{name: boolean, when: [boolean], type: text, length: 3}")
CODES = ("{name: integer8, when: [integer8], type: i8}", "{name: path, when: [integer8], type: u8, enum: path}")
FLAGS = ("{name: integer32, when: [integer32], type: i32}", "{name: bits, when: [integer32], type: u32, flags: inputs}")
CHANGES: dict[str, tuple[tuple[str, str], ...]] = {
    "as_it_is": (),
    "least_significant_byte_first": (LITTLE, BYTES),
    "least_significant_word_first": (WORDS, WIDE),
    "one_value": (ALONE, ALONE_TOO, BYTES),
    "one_value_little": (ALONE, ALONE_TOO, LITTLE, WIDE),
    "texts_and_codes": (TEXT, CODES, BYTES),
    "words_of_bits": (FLAGS, WIDE, LITTLE),
}


@cache
def built_from(name: str) -> tuple[DeviceLayout, ModuleType]:
    """The made-up drive with a varied channel."""
    return drive_variant(name, CHANGES[name])


def messages(layout: DeviceLayout) -> list[Any]:
    """The data of those messages that have a choice in them."""
    data = [side for message in layout.messages.values() for side in message.bodies]
    return [side for side in data if side.selector is not None]


@pytest.mark.proof(4)
@pytest.mark.parametrize("name", CHANGES)
@examples(80)
@given(data=st.data())
def test_values_of_any_type_become_the_bytes_of_the_reference(name: str, data: st.DataObject) -> None:
    layout, module = built_from(name)
    record = data.draw(st.sampled_from(messages(layout)))
    values = data.draw(values_of(layout, record))
    instance = built(module, layout, record, values)
    actual = outcome(instance.encode)
    assert actual == outcome(lambda: encoded(record, values, layout.device))
    if not actual[0]:
        assert type(instance).decode(instance.encode()).encode() == instance.encode()


@pytest.mark.proof(4)
@pytest.mark.parametrize("name", CHANGES)
@examples(80)
@given(data=st.data())
def test_bytes_become_the_values_of_the_type_that_the_reference_finds(name: str, data: st.DataObject) -> None:
    layout, module = built_from(name)
    record = data.draw(st.sampled_from(messages(layout)))
    drawn_bytes = data.draw(bytes_of(record))
    cls = record_class(module, record)
    expected = outcome(lambda: only_stored(record, decoded(record, drawn_bytes, layout.device)))
    assert outcome(lambda: raws(cls.decode(drawn_bytes), record)) == expected


@pytest.mark.parametrize(
    ("data", "format_", "values"),
    [
        ("01 02 00 01", "BOOLEAN", (False, True)),
        ("02 01 FF", "INTEGER8", (-1,)),
        ("06 01 FF FE", "UNSIGNED16", (0xFFFE,)),
        ("42 01 FF FE", "WORD", (0xFFFE,)),
        ("04 01 FF FF FF FE", "INTEGER32", (-2,)),
        ("08 02 3F C0 00 00 BF 00 00 00", "FLOATING", (1.5, -0.5)),
    ],
)
def test_the_format_says_of_what_type_the_values_are(data: str, format_: str, values: tuple[Any, ...]) -> None:
    response = GLIDER.ReadParameterResponse.decode(bytes.fromhex(data))
    assert response == GLIDER.ReadParameterResponse(GLIDER.Format[format_], values)
    assert [type(value) for value in response.values] == [type(value) for value in values]
    assert response.encode() == bytes.fromhex(data)


@pytest.mark.parametrize(
    ("data", "reason", "offset"),
    [
        ("06 01", "incomplete", 2),
        ("07 01 00", "unknown_value", 0),
        ("06 01 00", "incomplete", 3),
        ("06 01 00 00 00", "wrong_length", 5),
        ("06 02 00 00", "wrong_measure", 1),
        ("01 02 00 02", "unknown_value", 3),
        ("02 09 00 00 00 00 00 00 00 00 00", "wrong_length", 10),
    ],
)
def test_what_is_wrong_is_told_by_its_place(data: str, reason: str, offset: int) -> None:
    with pytest.raises(CodecError) as caught:
        GLIDER.ReadParameterResponse.decode(bytes.fromhex(data))
    assert (caught.value.reason, caught.value.offset) == (reason, offset)


@pytest.mark.parametrize(
    ("format_", "values", "reason", "name"),
    [
        ("UNSIGNED16", (65536,), "out_of_range", "values[0]"),
        ("UNSIGNED16", (1, -1), "out_of_range", "values[1]"),
        ("INTEGER8", (128,), "out_of_range", "values[0]"),
        ("BOOLEAN", (2,), "out_of_range", "values[0]"),
        ("INTEGER32", (1.5,), "wrong_type", "values[0]"),
        ("FLOATING", (1e39,), "out_of_range", "values[0]"),
        ("UNSIGNED16", (), "wrong_length", "values"),
        ("UNSIGNED16", (0,) * 9, "wrong_length", "values"),
        ("UNSIGNED16", 5, "wrong_type", "values"),
    ],
)
def test_values_must_be_of_the_type_that_the_format_says(format_: str, values: Any, reason: str, name: str) -> None:
    with pytest.raises(CodecError) as caught:
        GLIDER.WriteParameterRequest(0x2317, GLIDER.Format[format_], values).encode()
    assert (caught.value.reason, caught.value.offset) == (reason, None)
    assert caught.value.detail.startswith(f"{name} ")


def test_a_format_that_there_is_not_is_refused_before_the_values() -> None:
    for number, reason in ((7, "unknown_value"), ("6", "wrong_type"), (None, "wrong_type")):
        with pytest.raises(CodecError) as caught:
            GLIDER.WriteParameterRequest(0x2317, number, ("what",)).encode()
        assert caught.value.reason == reason
