"""Records whose values vary in width, such as lines of text: where each value is in some data.

Codecs work on the image of such a record, in which each value has all the bytes that it may have: digits have leading
zeros and their sign, and texts are filled up with zeros. A field with the number of bytes of a text has in the image
that of all the bytes that the text may have.
"""

from __future__ import annotations

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.runtime._digits import size_data, size_in
from fieldspec.language.model.digits import digits_letters, digits_text, has_sign, widest_digits
from fieldspec.language.model.text_form import encoding_title
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class Span:
    """The bytes of a field: `size` in the image. `value` is None if the size is the number of sent bytes.

    `end` is the byte that follows a value that varies in width; None where the record ends after it, and where the
    span number `count` has its bytes, plus `plus`, in the byte order or as the digits `order`.
    """

    name: str
    size: int
    value: Value | None
    end: int | None
    count: int | None = None
    order: str = "big"
    plus: int = 0


class WidthError(ValueError):
    """Bytes that are not a valid record: the reason, the field, and the offset."""

    def __init__(self, reason: str, name: str, offset: int) -> None:
        super().__init__(f"{reason}: {name} at byte {offset}")
        self.reason, self.name, self.at = reason, name, offset


@dataclass(frozen=True, slots=True)
class Extent:
    """Where a field is in some data, and its bytes in the image; None for bytes that are not a valid value."""

    start: int
    stop: int
    image: bytes | None


def extents(spans: tuple[Span, ...], data: bytes) -> list[Extent]:
    """The fields of a record as far as the data go: the last one may lack bytes, or its end."""
    known: list[Extent] = []
    start = 0
    for span in spans:
        stop = _stop(span, data, start, known)
        if stop is None:
            return known
        piece = data[start:stop]
        image = piece if span.value is None else widened(span.value, piece)
        known.append(Extent(start, stop, image))
        if span.count is not None:
            count = known[span.count]
            whole = size_data(span.size + span.plus, count.stop - count.start, span.order)
            known[span.count] = Extent(count.start, count.stop, whole)
        start = stop
    return known


def _text_bytes(span: Span, data: bytes, known: list[Extent]) -> int | None:
    """The bytes of a text that another field counts; None for a number that the text cannot have, and without one."""
    if span.count is None or span.value is None:
        return None
    count = known[span.count]
    number = size_in(data[count.start : count.stop], span.order)
    return number - span.plus if number is not None and 0 <= number - span.plus <= span.value.width else None


def _stop(span: Span, data: bytes, start: int, known: list[Extent]) -> int | None:
    """Where a field ends that begins at a byte; None where its bytes, its number of bytes, or its end, are missing."""
    if span.value is None:
        return start + span.size if start + span.size <= len(data) else None
    if span.count is not None:
        number = _text_bytes(span, data, known)
        return None if number is None or start + number > len(data) else start + number
    if span.end is None:
        return len(data)
    stop = data.find(span.end, start)
    return None if stop < 0 else stop


def image_of(spans: tuple[Span, ...], data: bytes) -> tuple[bytes, list[Extent]]:
    """The image of a record, and where its fields are in the data. Raises WidthError."""
    fields = extents(spans, data)
    for span, extent in zip(spans, fields, strict=False):
        if extent.image is None:
            raise WidthError("unknown_value", span.name, extent.start)
    if len(fields) < len(spans):
        missing = spans[len(fields)]
        if missing.count is not None and _text_bytes(missing, data, fields) is None:
            count = fields[missing.count]
            has_number = size_in(data[count.start : count.stop], missing.order) is not None
            raise WidthError("wrong_measure" if has_number else "unknown_value", spans[missing.count].name, count.start)
        raise WidthError("incomplete", missing.name, len(data))
    end = fields[-1].stop if fields else 0
    if end < len(data):
        raise WidthError("wrong_length", spans[-1].name, end)
    return b"".join(extent.image or b"" for extent in fields), fields


def image_with_counts(spans: tuple[Span, ...], data: bytes, fields: list[Extent]) -> bytes:
    """The image of the fields of some data, in which the numbers of bytes of texts are those that were sent."""
    pieces = [extent.image or b"" for extent in fields]
    for span in spans[: len(fields)]:
        if span.count is not None:
            count = fields[span.count]
            pieces[span.count] = data[count.start : count.stop]
    return b"".join(pieces)


def data_of(spans: tuple[Span, ...], image: bytes) -> bytes:
    """The bytes that are sent for an image. Raises WidthError for a text that contains the byte which ends it."""
    pieces: list[bytes] = []
    offset = 0
    for span in spans:
        piece = image[offset : offset + span.size]
        offset += span.size
        if span.value is not None:
            piece = narrowed(span.value, piece)
            if span.end is not None and span.end in piece:
                raise WidthError("unknown_value", span.name, sum(map(len, pieces)))
        if span.count is not None:
            pieces[span.count] = size_data(len(piece) + span.plus, len(pieces[span.count]), span.order)
        pieces.append(piece)
    return b"".join(pieces)


def place_in_data(spans: tuple[Span, ...], fields: list[Extent], offset: int) -> int:
    """The byte in the data for a byte of the image."""
    first = 0
    for span, extent in zip(spans, fields, strict=True):
        if offset < first + span.size:
            return extent.start + (offset - first if span.value is None else 0)
        first += span.size
    return fields[-1].stop if fields else 0


def widened(value: Value, piece: bytes) -> bytes | None:
    """The bytes of a value that varies in width as an image has them, without a mark; None for invalid ones."""
    if value.is_marked:
        return piece
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
    """The bytes that are sent for a value in an image: no leading zeros, and a sign only below zero."""
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


def order_data(order: str) -> dict[str, str | int | bool]:
    """The form of a number that counts, as programs in JavaScript have it."""
    if order in ("big", "little"):
        return {"little": True} if order == "little" else {}
    return {"digits": order}


def span_data(span: Span) -> dict[str, str | int | bool]:
    """A field as programs in JavaScript have it; what is 0, false or absent is left out."""
    data: dict[str, str | int | bool] = {"name": span.name, "size": span.size}
    value = span.value
    if value is None:
        return data
    data |= {"most": value.width, "form": value.digits or ("bytes" if value.is_marked else "text")}
    data |= {"places": value.places} if value.places else {}
    data |= {"hasSign": True} if has_sign(value) else {}
    if span.count is not None:
        data |= {"count": span.count, "plus": span.plus} | order_data(span.order)
    return data | ({"end": span.end} if span.end is not None else {})
