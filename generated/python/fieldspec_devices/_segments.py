"""Values of parameters that follow a message in pieces, each in a message of its own."""

from __future__ import annotations

from operator import index

from ._typing import TYPE_CHECKING
from .errors import InvalidAnswerError, InvalidValueError

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any, Literal

    from ._client import Session, Work


class PieceError(Exception):
    """A piece that does not follow: the `cause` is `counter` or `size`."""

    def __init__(self, cause: str, text: str) -> None:
        super().__init__(text)
        self.cause = cause


class Place:
    """A number in a field: `width` bits from the bit `shift` on, from `low` to `high`.

    `initial` is the field without it, and `ranges` are the numbers that the field itself may be.
    """

    def __init__(
        self,
        field: str,
        shift: int,
        width: int,
        low: int,
        high: int,
        *,
        initial: int = 0,
        ranges: tuple[tuple[int, int], ...] = (),
    ) -> None:
        self.field, self.shift, self.mask = field, shift, ((1 << width) - 1) << shift
        self.low, self.high, self.initial, self.ranges = low, high, initial, ranges

    def number(self, message: Any) -> int:
        """The number in a message. Raises PieceError where the field cannot be what it is."""
        value = index(getattr(message, self.field))
        if self.ranges and not any(low <= value <= high for low, high in self.ranges):
            raise PieceError("counter", f"{self.field} is {value}, which is not an answer with a piece")
        return (value & self.mask) >> self.shift

    def put(self, fields: dict[str, Any], number: int) -> None:
        """Puts a number into the fields of a request."""
        value = fields.get(self.field, self.initial)
        fields[self.field] = value & ~self.mask | number << self.shift

    def number_behind(self, count: int) -> int:
        """The number of the piece after `count` others."""
        return self.low + count % (self.high - self.low + 1)


class Segments:
    """How a value follows a message in pieces.

    `first` makes the request that begins to write, from the parameter, the sub-index and the number of bytes. `piece`
    is the request of a piece, with the `fields` that are always the same. Where a value is read, pieces follow a
    response whose field `number_name` has one of `numbers`; with those in `unsized`, the field `size` has no meaning.
    `data` is the field with a piece, of `length` bytes. `request_place` and `response_place` count the pieces in the
    two directions. A value of one of the `whole` numbers of bytes is written by a message alone. `abort` makes the
    request that ends a transfer, from the request that began and one of the `reasons`, which are by their causes; None
    where there is none.
    """

    def __init__(
        self,
        piece: Any,
        data: str,
        length: int,
        *,
        first: Any = None,
        fields: Mapping[str, int] | None = None,
        number_name: str = "",
        numbers: tuple[int, ...] = (),
        unsized: tuple[int, ...] = (),
        size: str = "",
        order: Literal["big", "little"] = "big",
        request_place: Place | None = None,
        response_place: Place | None = None,
        unused: Place | None = None,
        last: Place | None = None,
        whole: tuple[int, ...] = (),
        abort: Any = None,
        reasons: Mapping[str, int] | None = None,
    ) -> None:
        self.piece, self.data, self.length, self.first, self.fields = piece, data, length, first, dict(fields or {})
        self.by, self.numbers, self.unsized, self.size = number_name, numbers, unsized, size
        self.order: Literal["big", "little"] = order
        self.asked, self.answered = request_place, response_place
        self.unused, self.last, self.whole = unused, last, whole
        self.abort, self.reasons = abort, dict(reasons or {})

    def follows(self, response: Any) -> bool:
        """Whether pieces follow a response."""
        return index(getattr(response, self.by)) in self.numbers

    def read(self, session: Session, first: Any, response: Any, maximum: int) -> Work[bytes]:
        """The segmented value that follows the response to the request `first`, of at most `maximum` bytes."""
        try:
            content = yield from self._read(session, response, maximum)
        except PieceError as error:
            yield from self._end(session, first, error)
            raise InvalidAnswerError(str(error)) from error
        return content

    def _end(self, session: Session, first: Any, error: PieceError) -> Work[None]:
        """Tells the device that a transfer has ended, where a message does."""
        if self.abort is not None:
            yield from session.send(self.abort(first, self.reasons[error.cause]))

    def _read(self, session: Session, response: Any, maximum: int) -> Work[bytes]:
        size = self._size(response)
        if size is not None and size > maximum:
            raise PieceError("size", f"the device has {size} bytes, more than {maximum}")
        content = b""
        count = 0
        while True:
            # A request that is sent again could ask for the next piece.
            message = (yield from session.ask(self._request(count), 0)).message
            self._check_count(message, count)
            content += self._content(message, size, len(content))
            is_last = self.last.number(message) == 1 if self.last is not None else len(content) >= (size or 0)
            if len(content) > (maximum if size is None else size):
                raise PieceError("size", f"more than {maximum if size is None else size} bytes came")
            if is_last:
                break
            count += 1
            if self._is_empty(message):
                raise PieceError("size", "a piece is empty, and is not the last one")
        if size is not None and len(content) != size:
            raise PieceError("size", f"the device has announced {size} bytes, and {len(content)} came")
        return content

    def write(self, session: Session, first: Any, content: bytes) -> Work[None]:
        """Writes a value in pieces after the request that begins it."""
        yield from session.ask(first, 0)
        for count, (piece, is_last) in enumerate(self._pieces(content)):
            message = (yield from session.ask(self._request(count, piece, is_last), 0)).message
            try:
                self._check_count(message, count)
            except PieceError as error:
                yield from self._end(session, first, error)
                raise InvalidAnswerError(str(error)) from error

    def begin(self, parameter: Any, subindex: int, content: bytes) -> Any:
        """The request that begins to write a value. Raises InvalidValueError."""
        if self.first is None:
            raise InvalidValueError(f"no message writes {len(content)} bytes")
        return self.first(parameter, subindex, len(content))

    def _size(self, response: Any) -> int | None:
        if not self.size or index(getattr(response, self.by)) in self.unsized:
            return None
        content = getattr(response, self.size)
        return int.from_bytes(content, self.order) if isinstance(content, bytes) else index(content)

    def _request(self, count: int, piece: bytes | None = None, is_last: bool = False) -> Any:
        fields: dict[str, Any] = dict(self.fields)
        if self.asked is not None:
            self.asked.put(fields, self.asked.number_behind(count))
        if piece is not None:
            if self.unused is not None:
                self.unused.put(fields, self.length - len(piece))
            if self.last is not None:
                self.last.put(fields, int(is_last))
            fields[self.data] = piece.ljust(self.length, b"\0")
        return self.piece(**fields)

    def _pieces(self, content: bytes) -> Iterator[tuple[bytes, bool]]:
        for offset in range(0, max(len(content), 1), self.length):
            yield content[offset : offset + self.length], offset + self.length >= len(content)

    def _check_count(self, message: Any, count: int) -> None:
        place = self.answered
        if place is not None and (number := place.number(message)) != place.number_behind(count):
            raise PieceError(
                "counter", f"{place.field} counts the piece as {number}, not as {place.number_behind(count)}"
            )

    def _content(self, message: Any, size: int | None, done: int) -> bytes:
        data: bytes = getattr(message, self.data)
        if self.unused is None:
            return data if size is None else data[: size - done]
        unused = self.unused.number(message)
        if unused > len(data):
            raise PieceError("size", f"{unused} of {len(data)} bytes are unused")
        return data[: len(data) - unused]

    def _is_empty(self, message: Any) -> bool:
        return self.unused is not None and self.unused.number(message) >= self.length
