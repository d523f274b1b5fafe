"""The words and bytes of registers that messages carry as hexadecimal digits, two for each byte."""

from __future__ import annotations

from fieldspec.codec.layout.record import FieldLayout
from fieldspec.language.model.digits import digits_letters


def has_word_digits(field: FieldLayout) -> bool:
    """Whether a field with the words of registers carries them as hexadecimal digits."""
    return field.value is not None and bool(field.value.digits)


def word_bytes(field: FieldLayout, data: bytes) -> bytes:
    """The bytes of the words in the `data` of a field, up to the first word with other characters."""
    if field.value is None or not field.value.digits:
        return data
    letters = digits_letters(field.value)
    length = next((offset for offset, letter in enumerate(data) if letter not in letters), len(data))
    return bytes.fromhex(data[: length // field.size * field.size].decode("ascii"))


def field_bytes(field: FieldLayout, content: bytes) -> bytes:
    """The data of a field for the bytes of its words: the opposite of `word_bytes`."""
    if field.value is None or not field.value.digits:
        return content
    text = content.hex()
    return (text.upper() if field.value.digits == "upper_hex" else text).encode("ascii")
