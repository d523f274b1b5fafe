"""Messages that share a code: a constant in their data tells them apart, or only their requests do."""

from __future__ import annotations

from ._error import CodecError
from ._typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any, Literal

    from ._typing import Data


class Subcodes:
    """The classes of messages with one code, by the number that is `size` bytes at an offset in their data."""

    __slots__ = ("classes", "offset", "order", "size")

    def __init__(self, offset: int, size: int, order: Literal["big", "little"], classes: dict[int, Any]) -> None:
        self.order: Literal["big", "little"] = order
        self.offset, self.size, self.classes = offset, size, classes

    def of(self, body: Data, head_size: int, code_offset: int, answer: Any) -> Any:
        """The class of some data after a header, which must be `answer`, if there is one. Raises CodecError.

        Data that are too short for the number are left to the first class, which refuses them.
        """
        message_class = self._class(body, head_size)
        if answer is not None and message_class is not answer:
            raise CodecError("unknown_code", "the subcode answers another request", code_offset)
        return message_class

    def _class(self, body: Data, head_size: int) -> Any:
        end = self.offset + self.size
        if len(body) < end:
            return next(iter(self.classes.values()))
        number = int.from_bytes(body[self.offset : end], self.order)
        message_class = self.classes.get(number)
        if message_class is None:
            raise CodecError("unknown_code", f"no message has the subcode {number:#x}", head_size + self.offset)
        return message_class


class Answers:
    """The classes of responses with one code that only their requests identify."""

    __slots__ = ("classes",)

    def __init__(self, *classes: Any) -> None:
        self.classes = classes

    def of(self, _body: Data, _head_size: int, code_offset: int, answer: Any) -> Any:
        """The class of the response to a request, `answer`. Raises CodecError for None, and for any other class."""
        if answer is None:
            raise CodecError("unknown_code", "only the request identifies this message: pass it", code_offset)
        if answer not in self.classes:
            raise CodecError("unknown_code", "the code answers another request", code_offset)
        return answer
