"""Parameters that are addressed by number."""

from __future__ import annotations

from struct import Struct
from struct import error as StructError

from ._error import CodecError
from ._typing import TYPE_CHECKING, Generic, T
from ._values import Value

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from typing import Any


class Parameter(Generic[T]):
    """One parameter. Its value is of type T; a message carries it as a whole number or as bytes.

    `access` is ro, rw or wo, and empty where the manual does not say it.
    """

    __slots__ = ("access", "carrier", "name", "number", "reserved", "value")

    def __init__(
        self, name: str, number: int, value: Value[T], access: str = "", *, carrier: str, reserved: bool = False
    ) -> None:
        self.name, self.number, self.value, self.access = name, number, value, access
        self.carrier, self.reserved = Struct(carrier), reserved

    def __repr__(self) -> str:
        return f"<parameter {self.number} {self.name}>"

    @property
    def ranges(self) -> tuple[tuple[int, int], ...]:
        """The counts that it may hold, as intervals with both ends; none where there is no limit but the type's."""
        return self.value.ranges

    @property
    def unit(self) -> str:
        """The unit, empty where there is none."""
        return self.value.unit

    @property
    def scale(self) -> float:
        """What one count is worth in the unit."""
        return self.value.ratio[0] / self.value.ratio[2]

    def decode(self, data: bytes) -> T:
        """The value of exactly all of its bytes. Raises CodecError."""
        return self.value.decode(self.name, data)

    def encode(self, value: T) -> bytes:
        """The bytes of a value. Raises CodecError where it is out of range."""
        return self.value.encode(self.name, value)

    def writable(self) -> None:
        """Raises CodecError for a parameter that can only be read."""
        if self.access == "ro":
            raise CodecError("read_only", f"{self.name} can only be read")

    def from_raw(self, raw: int) -> T:
        """The value of the number that a message carries. Raises CodecError."""
        try:
            data = self.carrier.pack(raw)
        except StructError:
            raise CodecError("out_of_range", f"{self.name} is {raw!r}, which no message can carry") from None
        return self.decode(data)

    def to_raw(self, value: T) -> int:
        """The number by which a message carries a value. Raises CodecError where the value is out of range."""
        raw: int = self.carrier.unpack(self.encode(value))[0]
        return raw


class ParameterSet:
    """The parameters of a set, in the order of their numbers; each is an attribute too."""

    __slots__ = ("_parameters",)

    def __init__(self, parameters: Sequence[Parameter[Any]]) -> None:
        self._parameters = {parameter.number: parameter for parameter in parameters}

    def __len__(self) -> int:
        return len(self._parameters)

    def __iter__(self) -> Iterator[Parameter[Any]]:
        return iter(self._parameters.values())

    def __getitem__(self, number: int) -> Parameter[Any]:
        try:
            return self._parameters[number]
        except KeyError:
            raise IndexError(f"there is no parameter {number}") from None

    def from_raws(self, raws: Sequence[int]) -> dict[str, Any]:
        """The values of all parameters by name, from the numbers that a message carries in order."""
        if len(raws) != len(self):
            raise CodecError("wrong_length", f"there are {len(self)} parameters, not {len(raws)}")
        return {parameter.name: parameter.from_raw(raw) for parameter, raw in zip(self, raws, strict=True)}

    def to_raws(self, values: Mapping[str, Any]) -> list[int]:
        """The numbers by which a message carries the values of all parameters, in order.

        Raises CodecError for a name that is missing or unknown, and for a value that is out of range.
        """
        names = [parameter.name for parameter in self]
        wrong = sorted(set(values) ^ set(names))
        if wrong:
            raise CodecError("unknown_value", f"{wrong[0]} is {'unknown' if wrong[0] in values else 'missing'}")
        return [parameter.to_raw(values[parameter.name]) for parameter in self]
