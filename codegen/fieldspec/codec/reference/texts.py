"""Texts as the reference codec reads and writes them: as characters, each of one or several bytes."""

from __future__ import annotations

from fieldspec.language.model.value import Value

_CODECS = {"ascii": "ascii", "latin_1": "iso8859-1", "utf_8": "utf-8", "packed_ascii": "ascii"}
_NUL = "\0"
_SIX_BITS = "@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_ !\"#$%&'()*+,-./0123456789:;<=>?"
"""The characters of packed ASCII by their codes."""


def text_of_bytes(value: Value, order: str, data: bytes) -> str | None:
    """The characters of all bytes of a text; None for bytes that are not a text in its form."""
    form = value.text_form
    if form is None:
        return data.rstrip(b"\0").decode("ascii") if data.isascii() else None
    data = _turned(data) if form.is_turned else data
    data = _unpacked(data) if _is_packed(value) else data
    codec = _codec(value, order)
    if form.terminator is None:
        # What fills a text up is a whole character of its own, and no part of another one in any of the encodings.
        filler = chr(form.padding).encode(codec)
        width = len(filler)
        units = [data[place : place + width] for place in range(0, len(data), width)]
        while units and units[0 if form.is_right else -1] == filler:
            units.pop(0 if form.is_right else -1)
        content = b"".join(units)
    else:
        end = chr(form.terminator).encode(codec)
        places = [place for place in range(0, len(data), len(end)) if data[place : place + len(end)] == end]
        if not places:
            return None
        content = data[: places[0]]
    try:
        text = content.decode(codec)
    except UnicodeDecodeError:
        return None
    return None if _NUL in text else text


def bytes_of_text(value: Value, order: str, text: str) -> bytes:
    """All bytes of a text that fits them."""
    form = value.text_form
    if form is None:
        return text.encode("ascii").ljust(value.size, b"\0")
    codec = _codec(value, order)
    content = (text if form.terminator is None else text + chr(form.terminator)).encode(codec)
    filler = chr(form.padding).encode(codec)
    room = (_characters_room(value) - len(content)) // len(filler) * filler
    whole = room + content if form.is_right else content + room
    whole = _packed(whole) if _is_packed(value) else whole
    return _turned(whole) if form.is_turned else whole


def text_refusal(value: Value, order: str, text: str) -> tuple[str, str] | None:
    """The reason for which a text cannot be sent, with words; None where it can."""
    form, codec = value.text_form, _codec(value, order)
    try:
        size = len(text.encode(codec))
    except UnicodeEncodeError:
        return "unknown_value", "has characters that its encoding lacks"
    if _is_packed(value) and not set(text) <= set(_SIX_BITS):
        return "unknown_value", "has characters that six bits lack"
    if _NUL in text:
        return "unknown_value", "has a zero"
    room = _characters_room(value)
    if form is not None and form.terminator is not None:
        room -= len(chr(form.terminator).encode(codec))
        if chr(form.terminator) in text:
            return "unknown_value", "has the character that ends it"
    elif form is not None and text and (text[0] if form.is_right else text[-1]) == chr(form.padding):
        return "unknown_value", "has at its end what fills it up"
    return ("wrong_length", f"has {size} bytes and room for {room}") if size > room else None


def _codec(value: Value, order: str) -> str:
    if value.text_form is None:
        return "ascii"
    wide = "utf-16-be" if order == "big" else "utf-16-le"
    return _CODECS.get(value.text_form.encoding, wide)


def _is_packed(value: Value) -> bool:
    return value.text_form is not None and value.text_form.encoding == "packed_ascii"


def _characters_room(value: Value) -> int:
    return value.size * 8 // 6 if _is_packed(value) else value.size


def _unpacked(data: bytes) -> bytes:
    """The characters that each six bits of the data are."""
    bits = "".join(f"{byte:08b}" for byte in data)
    codes = (int(bits[place : place + 6], 2) for place in range(0, len(bits), 6))
    return "".join(_SIX_BITS[code] for code in codes).encode()


def _packed(characters: bytes) -> bytes:
    """The bytes that six bits of each character make."""
    bits = "".join(f"{_SIX_BITS.index(chr(character)):06b}" for character in characters)
    return bytes(int(bits[place : place + 8], 2) for place in range(0, len(bits), 8))


def _turned(data: bytes) -> bytes:
    """Words of 16 bits with the two bytes of each exchanged."""
    turned = bytearray(data)
    turned[0::2], turned[1::2] = data[1::2], data[0::2]
    return bytes(turned)
