"""Values that have no type of their own: records in registers, and parameters of which the manual tells no type."""

from __future__ import annotations

from ._error import CodecError
from ._typing import TYPE_CHECKING, T
from ._values import Value

if TYPE_CHECKING:
    from typing import Any

    from ._typing import Data


class RecordValue(Value[T]):
    """A record in registers."""

    __slots__ = ("record",)

    def __init__(self, record: type[T], size: int) -> None:
        super().__init__(f"{size}s")
        self.record = record

    def decode(self, name: str, data: Data) -> T:
        """The record in exactly `size` bytes. Raises CodecError."""
        decoded: T = self.record.decode(data)  # type: ignore[attr-defined]
        return decoded

    def encode(self, name: str, value: T) -> bytes:
        """The bytes of a record. Raises CodecError."""
        if not isinstance(value, self.record):
            raise CodecError("wrong_type", f"{name} is a {self.record.__name__}, not {value!r}")
        encoded: bytes = value.encode()  # type: ignore[attr-defined]
        return encoded


class Unknown(Value["Any"]):
    """A value whose type the manual does not state: the carried bytes are passed on."""

    __slots__ = ()

    def __init__(self) -> None:
        super().__init__("0s")

    def decode(self, name: str, data: Data) -> Any:
        """Nothing is known of its bytes: raises CodecError."""
        raise CodecError("unknown_value", f"the type of {name} is not known")

    def encode(self, name: str, value: Any) -> bytes:
        """Nothing is known of its bytes: raises CodecError."""
        raise CodecError("unknown_value", f"the type of {name} is not known")

    def of_carried(self, name: str, raw: Any) -> Any:
        """The carried value."""
        return raw

    def refused(self, name: str, value: Any) -> CodecError | None:
        """Why no message can carry a value; None for a number."""
        return None if isinstance(value, (int, float)) else CodecError("wrong_type", f"{name} is a number: {value!r}")
