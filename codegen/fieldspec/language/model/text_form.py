"""Texts of a fixed size: their encoding, what fills them up, and what ends them."""

from __future__ import annotations

import re

from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, field

if TYPE_CHECKING:
    from typing import Protocol

    from fieldspec.foundation.runtime import _texts

    class Text(Protocol):
        """What matters of a `Value` that is a text. The model of values is made of this module."""

        @property
        def size(self) -> int: ...
        @property
        def text_form(self) -> TextForm | None: ...


UTF_16 = "utf_16"
"""The encoding whose characters are numbers of 16 bits, in the byte order of the value."""

PACKED_ASCII = "packed_ascii"
"""The encoding whose characters, from the space to `_`, have six bits: four of them are in three bytes."""

_PACKABLE = re.compile("[ -_]*")

PADDINGS = {"nul": 0x00, "space": 0x20}
"""The characters that fill up a text."""

_CODECS = {"ascii": "ascii", "latin_1": "latin-1", "utf_8": "utf-8", PACKED_ASCII: "ascii"}
_TITLES = {"ascii": "ASCII", "latin_1": "Latin-1", "utf_8": "UTF-8", UTF_16: "UTF-16", PACKED_ASCII: "packed ASCII"}


@dataclass(frozen=True, slots=True)
class TextForm:
    """How a text is sent that is not ASCII padded with zeros.

    `padding` is the code of the character that fills the text up, before it where `is_right`. `terminator` is the code
    of the character that ends the text, None without one; what follows it is not read. Where it `is_turned`, the two
    bytes of each word of 16 bits are exchanged, so that the first character is in the low byte. Where it `is_packed`,
    its bytes are one for each character before they are packed.
    """

    encoding: str
    padding: int
    is_right: bool
    terminator: int | None
    is_turned: bool = field(default=False, repr=False)

    @property
    def is_packed(self) -> bool:
        """Whether four characters are in three bytes."""
        return self.encoding == PACKED_ASCII

    @property
    def unit(self) -> int:
        """The bytes of the padding and of the terminator."""
        return 2 if self.encoding == UTF_16 else 1

    def codec(self, order: str) -> str:
        """What Python calls the encoding, in a byte order."""
        return ("utf-16-be" if order == "big" else "utf-16-le") if self.encoding == UTF_16 else _CODECS[self.encoding]

    def room(self, size: int) -> int:
        """The bytes that the characters of a text of `size` bytes may take."""
        whole = size // 3 * 4 if self.is_packed else size
        return whole if self.terminator is None else whole - self.unit

    def has(self, text: str) -> bool:
        """Whether the encoding has the characters of a text."""
        try:
            text.encode(self.codec("big"))
        except UnicodeEncodeError:
            return False
        return not self.is_packed or _PACKABLE.fullmatch(text) is not None

    def arguments(self, size: int, order: str) -> str:
        """The arguments of the runtime for a text of `size` bytes: encoding, bytes, padding, terminator and side."""
        end = "-" if self.terminator is None else str(self.terminator)
        side = "right" if self.is_right else "left"
        codec = self.encoding if self.is_packed else self.codec(order)
        return f"{codec} {size} {self.padding} {end} {side}{' turned' * self.is_turned}"


def text_form(encoding: str, padding: str, align: str, terminator: int | None, byte_order: str) -> TextForm | None:
    """The form of a text by what a spec states; None for ASCII that is padded with zeros."""
    is_turned = byte_order == "little" and encoding != UTF_16
    usual = "space" if encoding == PACKED_ASCII else "nul"
    form = TextForm(encoding or "ascii", PADDINGS[padding or usual], align == "right", terminator, is_turned)
    return None if form == TextForm("ascii", 0, False, None) else form


def decoded_text(value: Text, order: str, data: bytes) -> str | None:
    """The characters of the bytes of a text; None for bytes that its encoding does not have, and for a zero in it."""
    form = value.text_form
    try:
        return (
            data.rstrip(b"\0").decode("ascii") if form is None else _runtime_form(form, value, order).text("", data, 0)
        )
    except ValueError:
        return None


def _runtime_form(form: TextForm, value: Text, order: str) -> _texts.TextForm:
    """What reads and writes the text."""
    from fieldspec.foundation.runtime import _texts

    return _texts.text_form(form.arguments(value.size, order))


def text_fault(value: Text, order: str, text: str) -> tuple[str, str] | None:
    """Why a text cannot be sent, as a reason and in words; None where it can."""
    form = value.text_form
    if not (text.isascii() if form is None else form.has(text)):
        return "unknown_value", f"holds characters that are not {encoding_title(value)}"
    if "\0" in text:
        return "unknown_value", "holds a zero, which ends a text"
    if form is not None and form.terminator is not None:
        if chr(form.terminator) in text:
            return "unknown_value", f"holds {_character(form.terminator)}, which ends the text"
    elif form is not None and text[-1 if not form.is_right else 0 :][:1] == chr(form.padding):
        place = "begins" if form.is_right else "ends"
        return "unknown_value", f"{place} with {_character(form.padding)}, which fills the text up"
    size = len(text) if form is None else len(text.encode(form.codec(order)))
    room = value.size if form is None else form.room(value.size)
    if size > room:
        units = "characters" if form is not None and form.is_packed else "bytes"
        return "wrong_length", f"has {room} {units}, not {size}"
    return None


def text_bytes(value: Text, order: str, text: str) -> bytes:
    """The bytes of a text; a question mark for a character that its encoding does not have, and no more than fit."""
    form = value.text_form
    if form is None:
        return text.encode("ascii", "replace").ljust(value.size, b"\0")[: value.size]
    codec = form.codec(order)
    text = "".join(letter if form.has(letter) else "?" for letter in text) if form.is_packed else text
    data = text.encode(codec, "replace")
    while len(data) > form.room(value.size):
        text = text[:-1]
        data = text.encode(codec, "replace")
    return _runtime_form(form, value, order).data(data.decode(codec))


def encoding_title(value: Text) -> str:
    """How people call the encoding of a text: `Latin-1`."""
    return _TITLES[value.text_form.encoding if value.text_form is not None else "ascii"]


def text_form_title(value: Text) -> str:
    """How people call the form of a text: `Latin-1, filled up with spaces before it`; empty for the usual form."""
    form = value.text_form
    if form is None:
        return ""
    parts = [encoding_title(value)]
    if form.terminator is not None:
        parts.append(f"ended by {_character(form.terminator)}")
    if form.padding or form.is_right:
        filler = "spaces" if form.padding else "zeros"
        parts.append(f"filled up with {filler} {'before' if form.is_right else 'after'} it")
    if form.is_turned:
        parts.append("the low byte of each word first")
    return ", ".join(parts)


def _character(code: int) -> str:
    """A character by its code, as a part of a sentence."""
    names = {0x00: "a zero", 0x20: "a space", 0x0A: "a line feed", 0x0D: "a carriage return"}
    return names.get(code, f"the character 0x{code:02X}")
