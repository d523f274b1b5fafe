"""Values of parameters in pieces: read and written after the message that begins."""

from __future__ import annotations

from fieldspec.codec.layout.segments import SegmentsLayout
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.tools.live.client import Client, UnfitAnswerError

if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

    from fieldspec.codec.reference.frames import Decoded


class _PieceError(Exception):
    """A piece that does not follow: the `cause` is `counter` or `size`."""

    def __init__(self, cause: str, text: str) -> None:
        super().__init__(text)
        self.cause = cause


def read_pieces(
    client: Client, pieces: SegmentsLayout, first: Mapping[str, Any], values: Mapping[str, Any], maximum: int
) -> bytes:
    """The value whose pieces follow the response to a request with the fields `first`: at most `maximum` bytes.

    Raises UnfitAnswerError, RefusedError, NoAnswerError and CarrierError.
    """
    try:
        return _read(client, pieces, values, maximum)
    except _PieceError as error:
        _end(client, pieces, first, error)
        raise UnfitAnswerError(str(error)) from None


def _end(client: Client, pieces: SegmentsLayout, first: Mapping[str, Any], error: _PieceError) -> None:
    """Tells the device that a transfer has ended, where a message does."""
    if pieces.abort is not None:
        client.send(pieces.abort.message.name, pieces.abort.request(first, error.cause))


def _read(client: Client, pieces: SegmentsLayout, values: Mapping[str, Any], maximum: int) -> bytes:
    """The value from its pieces. Raises _PieceError for a piece that does not follow the one before."""
    size = pieces.stated_size(values)
    limit = maximum if size is None else size
    if limit > maximum:
        raise _PieceError("size", f"the device has {size} bytes, more than {maximum}")
    content = b""
    count = 0
    while True:
        # A request that is sent again could ask for the next piece.
        answer = client.ask(pieces.piece.name, pieces.request(count), retries=0)
        _check_piece(pieces, answer, count)
        piece = pieces.content(answer.values, None if size is None else size - len(content))
        if piece is None:
            raise _PieceError("size", "more bytes of a piece are unused than it has")
        content += piece
        if len(content) > limit:
            raise _PieceError("size", f"more than {limit} bytes came")
        if pieces.is_last(answer.values) or (pieces.last is None and len(content) >= limit):
            break
        if not piece:
            raise _PieceError("size", "a piece is empty, and is not the last one")
        count += 1
    if size is not None and len(content) != size:
        raise _PieceError("size", f"the device has announced {size} bytes, and {len(content)} came")
    return content


def write_pieces(client: Client, pieces: SegmentsLayout, first: Mapping[str, Any], content: bytes) -> None:
    """Writes a value in pieces after the request with the fields `first` that has begun it.

    Raises UnfitAnswerError, RefusedError, NoAnswerError and CarrierError.
    """
    for count, (piece, is_last) in enumerate(pieces.pieces(content)):
        answer = client.ask(pieces.piece.name, pieces.request(count, piece, is_last), retries=0)
        try:
            _check_piece(pieces, answer, count)
        except _PieceError as error:
            _end(client, pieces, first, error)
            raise UnfitAnswerError(str(error)) from None


def _check_piece(pieces: SegmentsLayout, answer: Decoded, count: int) -> None:
    """Raises _PieceError for an answer that does not have, or accept, the piece after `count` others."""
    for place in (pieces.answered, *((pieces.unused, pieces.last) if pieces.reads else ())):
        value = place.field.value if place is not None else None
        if place is not None and value is not None and value.ranges is not None:
            number = int(answer.values[place.field.name])
            if number not in value.ranges:
                raise _PieceError("counter", f"{place.field.name} is {number}, which is not an answer with a piece")
    if not pieces.has_number(answer.values, count, pieces.answered):
        raise _PieceError("counter", "the device counts the pieces in another way: one is missing, or came twice")
