"""Values that do not fill the words of their register: a byte alone, and an odd number of characters or bytes."""

from __future__ import annotations

from ._error import CodecError
from ._typing import TYPE_CHECKING, T
from ._values import Value

if TYPE_CHECKING:
    from typing import Any

    from ._typing import Data


class Filled(Value[T]):
    """A value and the byte after it that fills its last word: written as zero, and ignored when it is read."""

    __slots__ = ("own",)

    def __init__(self, own: Value[T]) -> None:
        for key in Value.__slots__:
            setattr(self, key, getattr(own, key))
        self.own, self.size = own, own.size + 1

    def decode(self, name: str, data: Data) -> T:
        """The value in exactly `size` bytes. Raises CodecError."""
        if len(data) != self.size:
            reason = "incomplete" if len(data) < self.size else "wrong_length"
            raise CodecError(reason, f"{name} has {self.size} bytes, not {len(data)}", min(len(data), self.size))
        return self.own.decode(name, data[:-1])

    def encode(self, name: str, value: T) -> bytes:
        """The bytes of a value. Raises CodecError."""
        return self.own.encode(name, value) + b"\0"

    def refused(self, name: str, value: Any) -> CodecError | None:
        """Why a value cannot be encoded; None for one that can."""
        return self.own.refused(name, value)
