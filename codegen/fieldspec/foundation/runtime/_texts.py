"""Texts that are not ASCII filled up with zeros after them."""

from __future__ import annotations

from ._conversions import turned
from ._error import CodecError
from ._typing import TYPE_CHECKING
from ._values import Text

_PACKABLE = frozenset(range(0x20, 0x60))

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any


class TextForm:
    """What reads and writes a text of a fixed size.

    `letters` are the encoding, the number of bytes, the codes of the character that fills the text up and of the one
    that ends it, `-` without one, and where the text is: `utf-16-be 12 32 - right` is after spaces. With `turned`, the
    bytes of each word are exchanged. `packed_ascii` has four characters in three bytes. Characters that the encoding
    does not have are refused.
    """

    __slots__ = ("codec", "end", "is_packed", "is_right", "is_turned", "padding", "room", "size", "unit")

    def __init__(self, letters: str) -> None:
        codec, size, padding, end, align, *options = letters.split()
        self.is_packed = codec == "packed_ascii"
        self.codec = "ascii" if self.is_packed else codec
        self.is_turned = bool(options)
        self.padding = chr(int(padding))
        self.end = "" if end == "-" else chr(int(end))
        self.size, self.is_right = int(size), align == "right"
        self.unit = len("0".encode(self.codec))
        self.room = (self.size // 3 * 4 if self.is_packed else self.size) - len(self.end) * self.unit

    def text(self, name: str, raw: bytes, offset: int) -> str:
        """The characters of the bytes at byte `offset` of the whole. Raises CodecError."""
        sent_data = raw[: self.size]
        sent_data = turned(sent_data) if self.is_turned else sent_data
        content = self._content(_unpacked(sent_data) if self.is_packed else sent_data)
        try:
            text = None if content is None else content.decode(self.codec)
        except UnicodeDecodeError:
            text = None
        if text is None or "\0" in text:
            raise CodecError("unknown_value", f"{name} is {raw!r}, which is not a text of its form", offset)
        return text

    def texts(self, name: str, raws: Sequence[bytes], offset: int) -> list[str]:
        """The texts of a list that begins at byte `offset` of the whole. Raises CodecError."""
        return [self.text(name, raw, offset + number * self.size) for number, raw in enumerate(raws)]

    def refused(self, name: str, text: Any) -> CodecError | None:
        """Why a text cannot be sent; None where it can."""
        if not isinstance(text, str):
            return CodecError("wrong_type", f"{name} is a text, not {text!r}")
        try:
            data = text.encode(self.codec)
        except UnicodeEncodeError:
            data = None
        if data is None or (self.is_packed and not _PACKABLE.issuperset(data)):
            encoding = "packed ASCII" if self.is_packed else self.codec
            return CodecError("unknown_value", f"{name} holds characters that {encoding} does not have")
        if "\0" in text:
            return CodecError("unknown_value", f"{name} holds a zero, which ends a text")
        if self.end and self.end in text:
            return CodecError("unknown_value", f"{name} holds {self.end!r}, which ends the text")
        if not self.end and self._is_filled(text):
            return CodecError("unknown_value", f"{name} is {text!r}, of which {self.padding!r} would fill up the field")
        if len(data) > self.room:
            units = "characters" if self.is_packed else "bytes"
            return CodecError("wrong_length", f"{name} has {self.room} {units}, not {len(data)}")
        return None

    def fits(self, text: str) -> bool:
        """Whether a text can be sent."""
        return self.refused("", text) is None

    def data(self, text: str) -> bytes:
        """The bytes of a text that can be sent."""
        content = text.encode(self.codec)
        padding = self.padding.encode(self.codec) * ((self.room - len(content)) // self.unit)
        data = padding + content if self.is_right else content + self.end.encode(self.codec) + padding
        data = _packed(data) if self.is_packed else data
        return turned(data) if self.is_turned else data

    def _is_filled(self, text: str) -> bool:
        return text.startswith(self.padding) if self.is_right else text.endswith(self.padding)

    def _content(self, raw: bytes) -> bytes | None:
        """The bytes of the characters alone; None where nothing ends the text."""
        if self.end:
            end = self.end.encode(self.codec)
            places = range(0, len(raw) - self.unit + 1, self.unit)
            return next((raw[:offset] for offset in places if raw[offset : offset + self.unit] == end), None)
        padding = self.padding.encode(self.codec)
        first, last = 0, len(raw)
        while not self.is_right and last > first and raw[last - self.unit : last] == padding:
            last -= self.unit
        while self.is_right and last > first and raw[first : first + self.unit] == padding:
            first += self.unit
        return raw[first:last]


def _unpacked(data: bytes) -> bytes:
    """The characters of packed ASCII: the highest bit of each is the opposite of the next one."""
    number = int.from_bytes(data, "big")
    codes = (number >> shift & 0x3F for shift in range(8 * len(data) - 6, -1, -6))
    return bytes(code if code & 0x20 else code | 0x40 for code in codes)


def _packed(characters: bytes) -> bytes:
    """The bytes of characters of packed ASCII."""
    number = 0
    for character in characters:
        number = number << 6 | character & 0x3F
    return number.to_bytes(len(characters) // 4 * 3, "big")


_FORMS: dict[str, TextForm] = {}


def text_form(letters: str) -> TextForm:
    """What reads and writes texts, made once for each form."""
    form = _FORMS.get(letters)
    if form is None:
        form = _FORMS[letters] = TextForm(letters)
    return form


class FormedText(Text):
    """Characters in a form of their own, as `TextForm` has it. `length` is the number of their bytes."""

    __slots__ = ("form",)

    def __init__(self, letters: str, length: int, form: str) -> None:
        super().__init__(letters, length)
        self.form = text_form(form)

    def of_raw(self, name: str, raw: bytes) -> str:
        return self.form.text(name, raw, 0)

    def to_raw(self, value: str) -> bytes:
        return self.form.data(value)

    def refused(self, name: str, value: Any) -> CodecError | None:
        return self.form.refused(name, value)
