"""Generic classes without the module `typing`, which takes longer to import than a whole device.

Type checkers treat `TYPE_CHECKING` as true, whatever is assigned to it.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from decimal import Decimal
    from fractions import Fraction
    from typing import Any, Generic, TypeAlias, TypeVar, overload

    T = TypeVar("T")
    R = TypeVar("R")
    M = TypeVar("M", covariant=True)
    Data: TypeAlias = bytes | bytearray | memoryview
    Quantity: TypeAlias = float | Decimal | Fraction
    Others: TypeAlias = tuple[float | range, ...]
    Absent: TypeAlias = tuple[tuple[str, float | range], ...]
    Stated: TypeAlias = tuple[Any, ...]
else:
    T = R = M = Absent = Any = Data = Others = Quantity = Stated = None

    def overload(function):
        """Stands in for `typing.overload`."""
        return function

    class Generic:
        """Stands in for `typing.Generic`: `Generic[T]` is the class itself."""

        __slots__ = ()

        def __class_getitem__(cls, _item):
            return cls


__all__ = [
    "TYPE_CHECKING",
    "Absent",
    "Any",
    "Data",
    "Generic",
    "M",
    "Others",
    "Quantity",
    "R",
    "Stated",
    "T",
    "overload",
]
