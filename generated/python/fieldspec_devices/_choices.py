"""Fields whose type an earlier field of their record, the selector, decides."""

from __future__ import annotations

from operator import index
from struct import Struct

from ._conversions import Repeated
from ._error import CodecError, wrong_length
from ._reals import Double, Float, Half
from ._refusals import refused_list
from ._typing import TYPE_CHECKING
from ._values import Number, Value

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any, Literal

    from ._typing import Data


class Case:
    """Elements of one type. `letters` are the letters of one element in the Struct of its record."""

    __slots__ = ("_direct", "_native", "size", "structs", "value")

    def __init__(self, fixed: str, letters: str, value: Value[Any]) -> None:
        self.value, self.size = value, value.size
        self.structs = Repeated(fixed, letters)
        self._native = not letters.endswith("s")
        # A Struct returns these values themselves, unless they have more bytes than their type.
        self._direct = self._native and type(value) in (Number, Half, Float, Double)

    def values(self, name: str, raws: Sequence[Any], offset: int) -> tuple[Any, ...]:
        """The elements of a field whose first byte is byte `offset`. Raises CodecError."""
        if self._direct:
            return tuple(raws)
        return tuple([self._value(name, raw, offset + number * self.size) for number, raw in enumerate(raws)])

    def _value(self, name: str, raw: Any, offset: int) -> Any:
        try:
            return self.value.of_raw(name, raw) if self._native else self.value.decode(name, raw)
        except CodecError as error:
            raise error.shifted(offset) from None

    def raws(self, name: str, values: Sequence[Any]) -> list[Any]:
        """The raw values of the elements for the Struct of the record. Raises CodecError."""
        if not self._native:
            return [self.value.encode(name, value) for value in values]
        for value in values:
            error = self.value.refused(name, value)
            if error is not None:
                raise error
        return [self.value.to_raw(value) for value in values]


class Cases:
    """The types of a single field that other fields follow, by the bits in the `mask` of its field `selector`."""

    __slots__ = ("by", "mask", "values")

    def __init__(self, selector: str, *cases: tuple[tuple[int, ...], Value[Any]], mask: int = -1) -> None:
        self.by, self.mask = selector, mask
        self.values: dict[int, Value[Any]] = {}
        for numbers, value in cases:
            self.values |= dict.fromkeys(numbers, value)

    def decoded(self, name: str, number: Any, data: bytes, offset: int) -> Any:
        """The value at the beginning of some bytes, the first of which is byte `offset`. Raises CodecError."""
        value = self._chosen(number)
        try:
            return value.decode(name, data[: value.size])
        except CodecError as error:
            raise error.shifted(offset) from None

    def raw(self, name: str, number: Any, value: Any) -> bytes:
        """The bytes of a value for a number of the selector. Raises CodecError."""
        return self._chosen(number).encode(name, value)

    def refused(self, name: str, number: Any, value: Any) -> CodecError | None:
        """Why a value cannot be encoded for a number of the selector; None for one that can be."""
        try:
            return self._chosen(number).refused(name, value)
        except CodecError as error:
            return error

    def _chosen(self, number: Any) -> Value[Any]:
        value = self.values.get(index(number) & self.mask) if hasattr(number, "__index__") else None
        if value is None:
            raise CodecError("unknown_value", f"{self.by} is {number}, which chooses nothing that may follow")
        return value


class Choice:
    """The last field of a record: `minimum` to `maximum` elements of the case that its selector chooses.

    The selector is `selector`: `by_size` bytes at byte `offset` of the record. `fixed` is the format of all fields
    before the decided one; each case has its numbers, the letters of an element, and the value.
    """

    __slots__ = (
        "at",
        "by",
        "by_size",
        "cases",
        "fixed_size",
        "least",
        "longest",
        "most",
        "order",
        "record",
        "shortest",
    )

    def __init__(
        self,
        record: str,
        fixed: str,
        selector: str,
        offset: int,
        by_size: int,
        *cases: tuple[tuple[int, ...], str, Value[Any]],
        minimum: int,
        maximum: int,
        order: Literal["big", "little"] = "big",
    ) -> None:
        self.record, self.by, self.at, self.by_size = record, selector, offset, by_size
        self.order: Literal["big", "little"] = order
        self.least, self.most, self.fixed_size = minimum, maximum, Struct(fixed).size
        self.cases: dict[int, Case] = {}
        for numbers, letters, value in cases:
            self.cases |= dict.fromkeys(numbers, Case(fixed, letters, value))
        sizes = [case.size for case in self.cases.values()]
        self.shortest = self.fixed_size + minimum * min(sizes)
        self.longest = self.fixed_size + maximum * max(sizes)

    def unpack(self, data: Data) -> tuple[Case, tuple[Any, ...]]:
        """The case of a record's bytes, and the raw values of all fields. Raises CodecError."""
        length = len(data)
        if not self.shortest <= length <= self.longest:
            raise wrong_length(self.record, length, self.shortest, self.longest)
        number = data[self.at] if self.by_size == 1 else self._selector(data)
        case = self.cases.get(number)
        if case is None:
            raise CodecError("unknown_value", f"{self.by} is {number}, which chooses nothing that may follow", self.at)
        fixed, size = self.fixed_size, case.size
        elements, rest = divmod(length - fixed, size)
        if rest or not self.least <= elements <= self.most:
            minimum, maximum = fixed + self.least * size, fixed + self.most * size
            raise wrong_length(self.record, length, minimum, maximum, fixed, size)
        return case, case.structs[elements].unpack(data)

    def _selector(self, data: Data) -> int:
        return int.from_bytes(data[self.at : self.at + self.by_size], self.order)

    def case(self, number: Any) -> Case:
        """The case for a value of the selector. Raises CodecError."""
        error = self.refused_by(number)
        if error is not None:
            raise error
        return self.cases[index(number)]

    def refused_by(self, number: Any) -> CodecError | None:
        """Why a value of the selector cannot be encoded; None for one that can be."""
        if hasattr(number, "__index__") and index(number) in self.cases:
            return None
        return CodecError("unknown_value", f"{self.by} is {number}, which chooses nothing that may follow")

    def refused(self, name: str, number: int, values: Any) -> CodecError | None:
        """Why elements cannot be encoded for a value of the selector; None for those that can be."""
        return refused_list(name, values, self.least, self.most, self.cases[index(number)].value.refused)

    def refused_element(self, name: str, number: int, value: Any) -> CodecError | None:
        """Why the element of a field that is not repeated cannot be encoded; None for one that can be."""
        return self.cases[index(number)].value.refused(name, value)
