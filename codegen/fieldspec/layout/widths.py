"""Records whose values vary in width, such as lines of text: where each value is in some data.

Codecs work on the image of such a record, in which each value has all the bytes that it may have: digits have leading
zeros and their sign, and texts are filled up with zeros.
"""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.digits import digits_letters, digits_text, has_sign, widest_digits
from fieldspec.model.text_form import encoding_title
from fieldspec.model.value import Value


@dataclass(frozen=True, slots=True)
class Span:
    """The bytes of a field: `size` in the image. `value` is None where as many are sent.

    `end` is the byte that follows a value that varies in width; None where the record ends behind it.
    """

    name: str
    size: int
    value: Value | None
    end: int | None


class WidthError(ValueError):
    """Bytes that are not those of a record: the reason, the field, and the place."""

    def __init__(self, reason: str, name: str, at: int) -> None:
        super().__init__(f"{reason}: {name} at byte {at}")
        self.reason, self.name, self.at = reason, name, at


@dataclass(frozen=True, slots=True)
class Extent:
    """Where a field is in some data, and its bytes in the image; None for bytes that are not those of its value."""

    start: int
    stop: int
    image: bytes | None


def extents(spans: tuple[Span, ...], data: bytes) -> list[Extent]:
    """The fields of a record as far as the data go: the last one may lack bytes, or its end."""
    known: list[Extent] = []
    at = 0
    for span in spans:
        stop = _stop(span, data, at)
        if stop is None:
            return known
        piece = data[at:stop]
        image = piece if span.value is None else widened(span.value, piece)
        known.append(Extent(at, stop, image))
        at = stop
    return known


def _stop(span: Span, data: bytes, at: int) -> int | None:
    """Where a field ends that begins at a byte; None where its bytes, or its end, are missing."""
    if span.value is None:
        return at + span.size if at + span.size <= len(data) else None
    if span.end is None:
        return len(data)
    stop = data.find(span.end, at)
    return None if stop < 0 else stop


def image_of(spans: tuple[Span, ...], data: bytes) -> tuple[bytes, list[Extent]]:
    """The image of a record, and where its fields are in the data. Raises WidthError."""
    fields = extents(spans, data)
    for span, extent in zip(spans, fields, strict=False):
        if extent.image is None:
            raise WidthError("unknown_value", span.name, extent.start)
    if len(fields) < len(spans):
        raise WidthError("incomplete", spans[len(fields)].name, len(data))
    end = fields[-1].stop if fields else 0
    if end < len(data):
        raise WidthError("wrong_length", spans[-1].name, end)
    return b"".join(extent.image or b"" for extent in fields), fields


def data_of(spans: tuple[Span, ...], image: bytes) -> bytes:
    """What is sent of an image. Raises WidthError for a text that has the byte which would end it."""
    data = b""
    at = 0
    for span in spans:
        piece = image[at : at + span.size]
        at += span.size
        if span.value is not None:
            piece = narrowed(span.value, piece)
            if span.end is not None and span.end in piece:
                raise WidthError("unknown_value", span.name, len(data))
        data += piece
    return data


def place_in_data(spans: tuple[Span, ...], fields: list[Extent], at: int) -> int:
    """The byte in the data for a byte of the image."""
    first = 0
    for span, extent in zip(spans, fields, strict=True):
        if at < first + span.size:
            return extent.start + (at - first if span.value is None else 0)
        first += span.size
    return fields[-1].stop if fields else 0


def widened(value: Value, piece: bytes) -> bytes | None:
    """The bytes in the image of a value that varies in width; None for bytes that are none of it."""
    if not value.digits:
        return None if len(piece) > value.size or 0 in piece else piece.ljust(value.size, b"\0")
    sign, text = b"", piece
    if has_sign(value):
        sign = piece[:1] if piece[:1] in (b"+", b"-") else b"+"
        text = piece[1:] if piece[:1] in (b"+", b"-") else piece
    whole, point, fraction = text.partition(b".") if value.places else (text, b"", b"")
    letters = digits_letters(value)
    if not whole or (point and not fraction) or len(fraction) > value.places:
        return None
    if any(letter not in letters for letter in whole + fraction):
        return None
    whole, fraction = whole.lstrip(b"0") or b"0", fraction.ljust(value.places, b"0")
    image = sign + whole.rjust(widest_digits(value), b"0") + (b"." + fraction if value.places else b"")
    return image if len(narrowed(value, image)) <= value.width and len(piece) <= value.width else None


def narrowed(value: Value, image: bytes) -> bytes:
    """What is sent of the bytes of a value in the image: no leading zeros, and a sign only below zero."""
    if not value.digits:
        return image.rstrip(b"\0")
    digits = image[1:] if has_sign(value) else image
    whole, point, fraction = digits.partition(b".")
    is_negative = image[:1] == b"-" and digits.strip(b"0.") != b""
    return (b"-" if is_negative else b"") + (whole.lstrip(b"0") or b"0") + point + fraction


def value_form(value: Value) -> str:
    """How people call the form of a value that varies in width: `1 to 4 characters: decimal digits`."""
    if value.digits:
        return digits_text(value)
    return f"a text of at most {value.width} bytes in {encoding_title(value)}"


def span_data(span: Span) -> dict[str, str | int | bool]:
    """A field as programs in JavaScript have it; what is 0, false or absent is left out."""
    data: dict[str, str | int | bool] = {"name": span.name, "size": span.size}
    value = span.value
    if value is None:
        return data
    data |= {"most": value.width, "form": value.digits or "text"}
    data |= {"places": value.places} if value.places else {}
    data |= {"hasSign": True} if has_sign(value) else {}
    return data | ({"end": span.end} if span.end is not None else {})
