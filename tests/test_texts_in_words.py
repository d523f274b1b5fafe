"""Texts whose bytes are exchanged in each word: the first character is in the low byte of the first register."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fieldspec.codec.explain.values import decode_value
from fieldspec.language.model.text_form import decoded_text, text_bytes
from layouts import TEST_SPECS, newest
from python_package import codec_error, module_of

LAYOUT = newest(TEST_SPECS, "weigher")
MODEL = next(register.register for register in LAYOUT.registers if register.name == "model")
REGISTER = module_of(LAYOUT).MODEL


def words_of(text: str) -> bytes:
    """The registers as a program fills them that puts the first of two characters into the low byte."""
    codes = [ord(character) for character in text.ljust(2 * MODEL.width, "\0")]
    words = [low | high << 8 for low, high in zip(codes[::2], codes[1::2], strict=True)]
    return b"".join(word.to_bytes(2, "big") for word in words)


@given(text=st.text(st.characters(min_codepoint=1, max_codepoint=0x7F), max_size=8))
def test_the_first_character_is_in_the_low_byte(text: str) -> None:
    data = words_of(text)
    assert text_bytes(MODEL.value, "little", text) == data
    assert decoded_text(MODEL.value, "little", data) == text
    assert REGISTER.encode(text) == data
    assert REGISTER.decode(data) == text


@pytest.mark.parametrize("data", [b"\xc4A\0\0\0\0\0\0", b"\0A\0B\0\0\0\0"])
def test_what_is_no_text_is_refused(data: bytes) -> None:
    assert decoded_text(MODEL.value, "little", data) is None
    with pytest.raises(codec_error(), match="unknown_value"):
        REGISTER.decode(data)


def test_an_explanation_has_the_characters_in_order() -> None:
    assert decode_value(LAYOUT.device, MODEL.value, b"EWGIM-\0X", "little", False).number == "WEIG-MX"
