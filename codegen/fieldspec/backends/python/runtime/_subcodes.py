"""Messages that share a code: a constant in their data tells them apart."""

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

    def of(self, body: Data, head_size: int) -> Any:
        """The class of some data behind a header. Raises CodecError.

        Data that are too short for the number are left to the first class, which refuses them.
        """
        end = self.offset + self.size
        if len(body) < end:
            return next(iter(self.classes.values()))
        number = int.from_bytes(body[self.offset : end], self.order)
        message_class = self.classes.get(number)
        if message_class is None:
            raise CodecError("unknown_code", f"no message has the subcode {number:#x}", head_size + self.offset)
        return message_class
