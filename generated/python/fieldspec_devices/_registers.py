"""Registers, arrays of them, and tables of records in their space.

Addresses and widths are in words of 16 bits, or in bytes where an address of the space has one byte.
"""

from __future__ import annotations

from struct import pack, unpack

from ._absent import first_number, is_among
from ._carried import RecordValue
from ._conversions import turned
from ._error import CodecError
from ._quantities import Ratio, power_of_ten
from ._typing import TYPE_CHECKING, Generic, T
from ._values import Value

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence
    from typing import Any

    from typing_extensions import Self

    from ._typing import Data, Quantity


_LETTERS = {1: "B", 2: "H"}


class Register(Generic[T]):
    """`words` registers from `address` on with one value of type T.

    `access` is ro, rw or wo, and empty where the manual does not state it. The words of an `atomic` register must be
    accessed in one request. `trigger`: writing starts an action, and reading returns no meaningful value.
    `number` is its number in another list of the manual, `copy_of` the name of the register that it copies.
    `space` is its address space, empty where the device has only one. An address has `unit_size` bytes: 2, or 1 in a
    space of bytes, in which `words` counts these. With `turns_writes`, the words of a write have the opposite order
    from a read. `scale_by` is the register with the exponent of the scale, None where
    the scale is always the same.
    """

    __slots__ = (
        "access",
        "address",
        "atomic",
        "copy_of",
        "name",
        "number",
        "order",
        "scale_by",
        "space",
        "trigger",
        "turns_writes",
        "unit_size",
        "value",
        "words",
    )

    def __init__(
        self,
        name: str,
        address: int,
        words: int,
        value: Value[T],
        access: str = "",
        *,
        atomic: bool = False,
        trigger: bool = False,
        number: int | None = None,
        copy_of: str = "",
        order: str = ">",
        space: str = "",
        unit_size: int = 2,
        turns_writes: bool = False,
        scale_by: Register[int] | None = None,
    ) -> None:
        self.name, self.address, self.words, self.space, self.unit_size = name, address, words, space, unit_size
        self.value, self.access, self.number, self.copy_of = value, access, number, copy_of
        self.atomic, self.trigger, self.order, self.scale_by = atomic, trigger, order, scale_by
        self.turns_writes = turns_writes

    def __repr__(self) -> str:
        last = f"..0x{self.address + self.words - 1:04X}" if self.words > 1 else ""
        return f"<register {self.name} at 0x{self.address:04X}{last}>"

    @property
    def ranges(self) -> tuple[tuple[int, int], ...]:
        """The counts that may be written, as intervals with both ends; none if only the type limits them."""
        return self.value.ranges

    @property
    def unit(self) -> str:
        """The unit, empty where there is none."""
        return self.value.unit

    @property
    def absent(self) -> dict[str, float]:
        """The values that stand for a state and are not a quantity, by the names of their states."""
        return {state: first_number(number) for state, number in self.value.absent}

    def state_of(self, value: T | float) -> str | None:
        """The name of the state that a value stands for, or `out_of_range`; None for any other value."""
        return self.value.state_of(value)

    @property
    def scale(self) -> float:
        """The value of one count in the unit, before the power of ten that `scale_by` has the exponent of."""
        return self.value.ratio[0] / self.value.ratio[2]

    @property
    def offset(self) -> float:
        """The value of a count of 0 in the unit."""
        return self.value.ratio[1] / self.value.ratio[2]

    def decode(self, data: Data) -> T:
        """The value of exactly all of its bytes, as a response carries them. Raises CodecError."""
        return self.value.decode(self.name, data)

    def encode(self, value: T) -> bytes:
        """The bytes of a value, as a request carries them. Raises CodecError where it is out of range."""
        data = self.value.encode(self.name, value)
        return turned(data)[::-1] if self.turns_writes else data

    def from_words(self, words: Sequence[int]) -> T:
        """The value of all of its words, as a response carries them. Raises CodecError."""
        return self.decode(pack(f"{self.order}{len(words)}{_LETTERS[self.unit_size]}", *words))

    def to_words(self, value: T) -> list[int]:
        """The words of a value, as a request carries them. Raises CodecError."""
        return list(unpack(f"{self.order}{self.words}{_LETTERS[self.unit_size]}", self.encode(value)))

    def in_unit(self, count: float, exponent: int | None = None) -> float | None:
        """A count in the unit; None for one that stands for an absent value.

        Where `scale_by` is a register, `exponent` is its value: the quantity is the count times 10 to its power, and
        None where the exponent stands for an absent value. Raises CodecError for an invalid or missing exponent.
        """
        if self.scale_by is None:
            if exponent is not None:
                raise self._exponent_error(exponent)
            return self.value.in_unit(count)
        if exponent is not None and is_among(exponent, self.scale_by.value.others):
            return None
        return self.value.in_unit(count, self._power(exponent))

    def from_unit(self, value: Quantity | None, exponent: int | None = None) -> T:
        """The count that is nearest to a value in the unit, of two the even one; for None the only absent value.

        Where `scale_by` is a register, `exponent` is its value. Raises CodecError out of range, where that count stands
        for an absent value, for None if several do, and for an invalid or missing exponent.
        """
        if self.scale_by is None:
            if exponent is not None:
                raise self._exponent_error(exponent)
            own: T = self.value.from_unit(self.name, value)
            return own
        count: T = self.value.from_unit(self.name, value, self._power(exponent))
        return count

    def _power(self, exponent: int | None) -> Ratio:
        """The scale of a power of ten as a `Value` has it. Raises CodecError."""
        scale_by = self.scale_by
        if scale_by is None:
            raise self._exponent_error(exponent)
        return power_of_ten(self.name, scale_by.name, scale_by.ranges, exponent)

    def _exponent_error(self, exponent: int | None) -> CodecError:
        return CodecError("wrong_type", f"the scale of {self.name} has no exponent, and {exponent!r} is one")


class RegisterArray(Generic[T]):
    """Equal registers, `stride` words apart, by their numbers in the manual."""

    __slots__ = ("_registers", "access", "address", "copy_of", "first", "name", "number", "space", "stride")

    def __init__(
        self,
        name: str,
        address: int,
        words: int,
        value: Value[T],
        access: str = "",
        *,
        count: int,
        first: int,
        stride: int,
        number: int | None = None,
        copy_of: str = "",
        space: str = "",
        **options: Any,
    ) -> None:
        self.name, self.address, self.access, self.space = name, address, access, space
        self.first, self.stride, self.number, self.copy_of = first, stride, number, copy_of
        self._registers = tuple(
            Register(
                f"{name}[{first + number}]", address + number * stride, words, value, access, space=space, **options
            )
            for number in range(count)
        )

    def __repr__(self) -> str:
        return f"<registers {self.name}[{self.first}..{self.first + len(self) - 1}] at 0x{self.address:04X}>"

    def __len__(self) -> int:
        return len(self._registers)

    def __iter__(self) -> Iterator[Register[T]]:
        return iter(self._registers)

    def __getitem__(self, number: int) -> Register[T]:
        if not self.first <= number < self.first + len(self._registers):
            raise IndexError(f"{self.name} has the numbers {self.first}..{self.first + len(self) - 1}, not {number}")
        return self._registers[number - self.first]


class Table(Generic[T]):
    """Records in an address space, `stride` words apart, by their numbers in the manual.

    `count_by` is the register with the number of records that the device has, of which `count` is the greatest; it is
    None where the device has all of them. `base_by` is the register with the address of the first record, and `base`
    the usual one; such a table has no records before `at_base`. It is None where the table does not move.
    """

    __slots__ = (
        "_order",
        "_value",
        "access",
        "base",
        "base_by",
        "count",
        "count_by",
        "first",
        "name",
        "record",
        "space",
        "stride",
        "words",
    )

    def __init__(
        self,
        name: str,
        record: type[T],
        *,
        base: int,
        words: int,
        stride: int,
        count: int,
        first: int,
        access: str = "",
        order: str = ">",
        space: str = "",
        count_by: Register[int] | None = None,
        base_by: Register[int] | None = None,
    ) -> None:
        self.name, self.record, self.access, self.space = name, record, access, space
        self.count_by, self.base_by = count_by, base_by
        self.base, self.words, self.stride, self.count, self.first = base, words, stride, count, first
        self._value, self._order = RecordValue(record, 2 * words), order

    def __repr__(self) -> str:
        place = f"0x{self.base:04X}" if self.base_by is None else f"what {self.base_by.name} is"
        return f"<table {self.name}[{self.first}..{self.first + self.count - 1}] at {place}>"

    def __len__(self) -> int:
        return self.count

    def __iter__(self) -> Iterator[Register[T]]:
        return map(self.__getitem__, range(self.first, self.first + self.count))

    def __getitem__(self, number: int) -> Register[T]:
        if not self.first <= number < self.first + self.count:
            raise IndexError(f"{self.name} has the numbers {self.first}..{self.first + self.count - 1}, not {number}")
        if self.base_by is not None:
            raise CodecError("no_base", f"{self.name} begins where {self.base_by.name} says: use at_base")
        address = self.base + (number - self.first) * self.stride
        options: dict[str, Any] = {"order": self._order, "space": self.space}
        return Register(f"{self.name}[{number}]", address, self.words, self._value, self.access, **options)

    def at_base(self, base: int) -> Self:
        """The table of a device that has its first record at `base`. Raises CodecError for other addresses."""
        if not isinstance(base, int) or isinstance(base, bool):
            raise CodecError("wrong_type", f"the address of {self.name} is a whole number, not {base!r}")
        if not 0 <= base <= 0x10000 - (self.count - 1) * self.stride - self.words:
            raise CodecError("out_of_range", f"{self.name} does not fit after the address {base}")
        return type(self)(
            self.name,
            self.record,
            base=base,
            words=self.words,
            stride=self.stride,
            count=self.count,
            first=self.first,
            access=self.access,
            order=self._order,
            space=self.space,
            count_by=self.count_by,
        )

    def present(self, count: int) -> list[Register[T]]:
        """The records that a device has whose `count_by` is `count`. Raises CodecError for more than there can be."""
        if not isinstance(count, int) or isinstance(count, bool):
            raise CodecError("wrong_type", f"the number of records of {self.name} is a whole number, not {count!r}")
        if not 0 <= count <= self.count:
            raise CodecError("out_of_range", f"{self.name} has 0..{self.count} records, not {count}")
        return [self[self.first + number] for number in range(count)]

    def at(self, address: int) -> Register[T] | None:
        """The element that begins at an address; None where only the device says where the table is."""
        if self.base_by is not None:
            return None
        number, rest = divmod(address - self.base, self.stride)
        return self[self.first + number] if rest == 0 and 0 <= number < self.count else None


def spans(register: Register[Any], maximum: int) -> list[tuple[int, int]]:
    """First address and number of words of each request that reads or writes a register, `maximum` words at once.

    Raises CodecError where an atomic register does not fit one request.
    """
    end = register.address + register.words
    if register.atomic and register.words > maximum:
        unit = "words" if register.unit_size > 1 else "bytes"
        raise CodecError(
            "wrong_length", f"{register.name} has {register.words} {unit}, and one request at most {maximum}"
        )
    return [(start, min(maximum, end - start)) for start in range(register.address, end, maximum)]


def writable(register: Register[Any]) -> None:
    """Raises CodecError for a register that can only be read."""
    if register.access == "ro":
        raise CodecError("read_only", f"{register.name} can only be read")


def unreachable(register: Register[Any], operation: str, link: str = "") -> CodecError:
    """The error for a register in a space that no message reads or writes, or none of a link."""
    owner, place = f" of {link}" if link else "", f" in {register.space}" if register.space else ""
    return CodecError("no_message", f"no message{owner} {operation}s {register.name}{place}")


def replies(register: Register[Any], responses: Iterable[object], kind: type[T]) -> list[T]:
    """Responses with words of the space of a register. Raises CodecError for others."""
    checked = []
    for response in responses:
        if not isinstance(response, kind):
            raise CodecError("wrong_type", f"{type(response).__name__} carries nothing of {register.name}")
        checked.append(response)
    return checked


def only(name: str, requests: list[T]) -> T:
    """The only request of a list. Raises CodecError where there are several."""
    if len(requests) != 1:
        raise CodecError("wrong_length", f"{name} takes {len(requests)} requests")
    return requests[0]


def find(
    address: int,
    registers: Iterable[Register[Any] | RegisterArray[Any]],
    tables: Iterable[Table[Any]],
    space: str = "",
) -> Register[Any] | None:
    """The register, or the element of a table, that begins at an address of a space."""
    for entry in registers:
        if entry.space != space:
            continue
        for register in (entry,) if isinstance(entry, Register) else entry:
            if register.address == address:
                return register
    return next(
        (element for table in tables if table.space == space and (element := table.at(address)) is not None), None
    )
