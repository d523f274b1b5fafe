"""Records whose values vary in width, such as lines of text.

They are read and written as an image, in which each value has all the bytes that it may have: digits have leading zeros
and their sign, and texts are filled up with zeros.
"""

from __future__ import annotations

from ._digits import size_data, size_in
from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_LETTERS = {"decimal": b"0123456789", "upper_hex": b"0123456789ABCDEF", "lower_hex": b"0123456789abcdef"}


class Varying:
    """A value that varies in width: a text, or digits.

    `letters` are its form, the most bytes, how many digits follow a point, `+` where it has a sign, and the byte that
    follows it, `-` where nothing does: `decimal 8 2 + 44`.
    """

    __slots__ = ("end", "form", "has_sign", "most", "places", "size", "whole")

    def __init__(self, letters: str) -> None:
        self.form, maximum, places, sign, end = letters.split()
        self.most, self.places, self.has_sign = int(maximum), int(places), sign == "+"
        self.end = b"" if end == "-" else bytes([int(end)])
        self.size = self.most + self.has_sign
        self.whole = self.most - (self.places + 1 if self.places else 0)

    def stop(self, data: bytes, offset: int) -> int:
        """Where the value ends that begins at a byte; -1 where its end is missing."""
        return data.find(self.end, offset) if self.end else len(data)

    def widened(self, piece: bytes) -> bytes | None:
        """The bytes in the image; None for other bytes."""
        if len(piece) > self.most:
            return None
        if self.form == "text":
            return None if 0 in piece else piece.ljust(self.size, b"\0")
        sign, text = b"", piece
        if self.has_sign:
            sign, text = (piece[:1], piece[1:]) if piece[:1] in (b"+", b"-") else (b"+", piece)
        whole, point, fraction = text.partition(b".") if self.places else (text, b"", b"")
        if not whole or (point and not fraction) or len(fraction) > self.places:
            return None
        if (whole + fraction).strip(_LETTERS[self.form]):
            return None
        image = sign + (whole.lstrip(b"0") or b"0").rjust(self.whole, b"0")
        image += b"." + fraction.ljust(self.places, b"0") if self.places else b""
        return image if len(self.narrowed(image)) <= self.most else None

    def narrowed(self, image: bytes) -> bytes:
        """The sent form of the bytes in the image: without leading zeros, with a sign only below zero."""
        if self.form == "text":
            return image.rstrip(b"\0")
        digits = image[1:] if self.has_sign else image
        whole, point, fraction = digits.partition(b".")
        is_negative = image[:1] == b"-" and digits.strip(b"0.") != b""
        return (b"-" if is_negative else b"") + (whole.lstrip(b"0") or b"0") + point + fraction


class Widths:
    """The fields of a record: each has a name, and its bytes or the letters of a value that varies in width.

    `counts` are the texts whose number of bytes another field has, by their numbers: the number of that field, its
    bytes, their order or the form of their digits, and what it contains in addition.
    """

    __slots__ = ("counts", "fields", "title")

    def __init__(
        self, title: str, *fields: tuple[str, int | str], counts: dict[int, tuple[int, int, str, int]] | None = None
    ) -> None:
        self.title, self.counts = title, counts or {}
        self.fields = [(name, form if isinstance(form, int) else Varying(form)) for name, form in fields]

    def decoded(self, function: Callable[[bytes], Any], data: bytes) -> Any:
        """The result of a function for the image of some data. Raises CodecError with the place in the data."""
        image, starts = self._image(data)
        try:
            return function(image)
        except CodecError as error:
            raise CodecError(error.reason, error.detail, self._place(starts, error.offset)) from None

    def encoded(self, image: bytes) -> bytes:
        """The sent form of an image. Raises CodecError for a text that has the byte which would end it."""
        pieces: list[bytes] = []
        offset = 0
        for name, form in self.fields:
            size = form if isinstance(form, int) else form.size
            piece = image[offset : offset + size]
            offset += size
            if not isinstance(form, int):
                piece = form.narrowed(piece)
                if form.end and form.end in piece:
                    raise CodecError("unknown_value", f"{name} has the character that ends it")
            if len(pieces) in self.counts:
                number, count_size, order, plus = self.counts[len(pieces)]
                pieces[number] = size_data(len(piece) + plus, count_size, order)
            pieces.append(piece)
        return b"".join(pieces)

    def _image(self, data: bytes) -> tuple[bytes, list[int]]:
        """The image of some data, and where each field begins in them. Raises CodecError."""
        pieces: list[bytes] = []
        starts = [0]
        unfit: CodecError | None = None
        for name, form in self.fields:
            offset = starts[-1]
            stop = offset + form if isinstance(form, int) else form.stop(data, offset)
            if len(pieces) in self.counts and not isinstance(form, int):
                number, count_size, order, plus = self.counts[len(pieces)]
                count_at = starts[number]
                length = size_in(data[count_at : count_at + count_size], order)
                if length is None or not 0 <= length - plus <= form.most:
                    text = f"{self.fields[number][0]} is not a number of bytes"
                    raise unfit or CodecError("unknown_value" if length is None else "wrong_measure", text, count_at)
                stop = offset + length - plus
                pieces[number] = size_data(form.size + plus, count_size, order)
            if not offset <= stop <= len(data):
                raise unfit or CodecError("incomplete", f"{name} has no end", len(data))
            piece = data[offset:stop] if isinstance(form, int) else form.widened(data[offset:stop])
            if piece is None and unfit is None:
                unfit = CodecError(
                    "unknown_value", f"{name} is {data[offset:stop]!r}, which is not in its form", offset
                )
            pieces.append(piece or b"")
            starts.append(stop)
        if unfit is not None:
            raise unfit
        if starts[-1] < len(data):
            raise CodecError("wrong_length", f"{self.title} is followed by more bytes", starts[-1])
        return b"".join(pieces), starts

    def _place(self, starts: list[int], offset: int | None) -> int | None:
        """The byte in the data for a byte of the image."""
        first = 0
        for start, (_, form) in zip(starts, self.fields, strict=False):
            size = form if isinstance(form, int) else form.size
            if offset is None or offset < first + size:
                return None if offset is None else start + (offset - first if isinstance(form, int) else 0)
            first += size
        return starts[-1]
