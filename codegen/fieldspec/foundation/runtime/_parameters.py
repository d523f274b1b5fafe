"""Parameters that are addressed by number, in sets, whose numbers on the wire may be shared by several sets."""

from __future__ import annotations

from struct import error as StructError

from ._absent import first_number
from ._carried import Unknown
from ._conversions import carried_bits, number_struct
from ._error import CodecError
from ._typing import TYPE_CHECKING, Generic, T
from ._values import Text, Value

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Mapping, Sequence
    from typing import Any, TypeAlias

    from ._typing import Quantity

    Rows: TypeAlias = "Mapping[str, Parameter[Any] | tuple[Parameter[Any], ...]]"


class Subindex:
    """Elements of a parameter that have a meaning of their own; `indices` are intervals with both ends.

    `access` is empty where it is that of the parameter.
    """

    __slots__ = ("access", "indices", "name", "reserved", "source", "type", "value")

    def __init__(
        self,
        name: str,
        indices: tuple[tuple[int, int], ...],
        value: Value[Any],
        *,
        type: str = "",
        reserved: bool = False,
        source: str = "",
        access: str = "",
    ) -> None:
        self.name, self.indices, self.value, self.type = name, indices, value, type
        self.reserved, self.source, self.access = reserved, source, access

    def __contains__(self, index: int) -> bool:
        return any(first <= index <= last for first, last in self.indices)

    def __repr__(self) -> str:
        return f"<subindex {', '.join(f'{a}' if a == b else f'{a}..{b}' for a, b in self.indices)} {self.name}>"


class Parameter(Generic[T]):
    """One parameter. Its value is of type T; a message carries it as a number or as bytes.

    `number` is its number in the set `set`, and `wire_number` the number on the wire. `printed_name` is its name in the
    manual, or its number as the manual writes it. `type` is its type on the wire. `name`, `type` and `source` are empty
    where the manual prints the number alone. `default` is a count. `elements` is the length of an array, None for a
    single value. `access` is ro, rw or wo; it is empty, and `restart` None, where the manual does not state it.
    `applies_to` and `messages` are the objects and the messages that it has an effect on, and `only` the versions or
    models that have it; they are empty where it applies to all.
    """

    __slots__ = (
        "access",
        "applies_to",
        "carrier",
        "default",
        "elements",
        "messages",
        "name",
        "number",
        "only",
        "printed_name",
        "reserved",
        "restart",
        "set",
        "source",
        "subindices",
        "type",
        "value",
        "wire_number",
    )

    def __init__(
        self,
        name: str,
        number: int,
        value: Value[T],
        access: str = "",
        *,
        type: str = "",
        carrier: str = "",
        printed_name: str = "",
        default: int | str | None = None,
        elements: int | None = None,
        subindices: tuple[Subindex, ...] = (),
        restart: bool | None = None,
        applies_to: tuple[str, ...] = (),
        messages: tuple[str, ...] = (),
        only: tuple[str, ...] = (),
        reserved: bool = False,
        source: str = "",
        set: str = "",
        base: int = 0,
    ) -> None:
        self.name, self.number, self.value, self.access = name, number, value, access
        self.type, self.carrier, self.printed_name, self.default = type, carrier, printed_name or str(number), default
        self.elements, self.subindices, self.restart = elements, subindices, restart
        self.applies_to, self.messages, self.reserved, self.source = applies_to, messages, reserved, source
        self.only, self.set, self.wire_number = only, set, base + number

    def __repr__(self) -> str:
        return f"<parameter {' '.join(word for word in (self.printed_name, self.name) if word)}>"

    @property
    def title(self) -> str:
        """Its name in errors: the name, or else the printed name."""
        return self.name or self.printed_name

    @property
    def ranges(self) -> tuple[tuple[int, int], ...]:
        """The counts that may be written, as intervals with both ends; none if only the type limits them."""
        return self.value.ranges

    @property
    def unit(self) -> str:
        """The unit, empty where there is none."""
        return self.value.unit

    @property
    def scale(self) -> float:
        """What one count is worth in the unit."""
        return self.value.ratio[0] / self.value.ratio[2]

    def in_unit(self, count: float, subindex: int = 0) -> float | None:
        """A count in the unit of the element with an index; None for one that stands for an absent value."""
        return self._element(subindex)[0].in_unit(count)

    def from_unit(self, value: Quantity | None, subindex: int = 0) -> T:
        """The count that is nearest to a value in the unit of the element with an index, of two the even one.

        None becomes the only absent value. Raises CodecError as `from_unit` of a register does.
        """
        own, title = self._element(subindex)
        count: T = own.from_unit(title, value)
        return count

    @property
    def absent(self) -> dict[str, float]:
        """The values that stand for a state and are not a quantity, by the names of their states."""
        return {state: first_number(number) for state, number in self.value.absent}

    def state_of(self, value: T | float, subindex: int = 0) -> str | None:
        """The name of the state that a value of the element with an index stands for, or `out_of_range`; else None."""
        return self._element(subindex)[0].state_of(value)

    def subindex(self, index: int) -> Subindex | None:
        """The description of the element with an index; None where all elements are alike."""
        return next((subindex for subindex in self.subindices if index in subindex), None)

    def index(self, name: str) -> int:
        """The index of the element with a name, of several the first one. Raises KeyError."""
        for subindex in self.subindices:
            if subindex.name == name:
                return subindex.indices[0][0]
        raise KeyError(f"{self.title} has no element {name}")

    def decode(self, data: bytes) -> T:
        """The value of exactly all of its bytes. Raises CodecError."""
        return self.value.decode(self.title, data)

    def encode(self, value: T) -> bytes:
        """The bytes of a value. Raises CodecError where it is out of range."""
        return self.value.encode(self.title, value)

    def writable(self, first: int = 0, count: int = 1) -> None:
        """Raises CodecError for elements that can only be read."""
        for index in range(first, first + count):
            element = self.subindex(index) if self.subindices else None
            if (self.access if element is None else element.access or self.access) == "ro":
                raise CodecError("read_only", f"{self._title(element)} can only be read")

    def from_raw(self, raw: float | str | bytes, subindex: int = 0) -> T:
        """The value of a raw value in a message, for its element with an index. Raises CodecError."""
        own, title = self._element(subindex)
        carrier = self.carrier if own is self.value else ""
        value: T = own.of_carried(title, carried_bits(carrier, own.struct, own.size, raw))
        return value

    def to_raw(self, value: T, subindex: int = 0) -> Any:
        """The raw value in a message. Raises CodecError where the value is out of range."""
        own, title = self._element(subindex)
        error = own.refused(title, value)
        if error is not None:
            raise error
        if not self.carrier or own is not self.value:
            return own.to_raw(value)
        try:
            return number_struct(self.carrier).unpack(own.struct.pack(own.to_raw(value)))[0]
        except StructError:
            raise CodecError("out_of_range", f"no message can carry {self.title}") from None

    def from_bytes(self, data: bytes, subindex: int = 0) -> T:
        """The value of exactly all of the bytes that a message carries, for its element with an index.

        The padding zeros of a text may be missing. Raises CodecError.
        """
        own, title = self._element(subindex)
        data = _filled(own, data)
        if len(data) != own.struct.size:
            raise CodecError("wrong_length", f"{title} has {own.struct.size} bytes, not {len(data)}")
        value: T = own.decode(title, data)
        return value

    def to_bytes(self, value: T, subindex: int = 0) -> bytes:
        """The bytes of a value in a message. Raises CodecError where the value is out of range."""
        own, title = self._element(subindex)
        return own.encode(title, value)

    def from_raws(self, raws: Sequence[float | str | bytes], subindex: int = 0) -> list[T]:
        """The values of its elements, of which `subindex` is the first one. Raises CodecError."""
        return [self.from_raw(raw, subindex + place) for place, raw in enumerate(raws)]

    def to_raws(self, values: Sequence[T], subindex: int = 0) -> list[Any]:
        """The raw values of its elements in a message. Raises CodecError."""
        return [self.to_raw(value, subindex + place) for place, value in enumerate(values)]

    def size(self, subindex: int = 0) -> int:
        """The bytes of its value, or of that of the element with an index."""
        return self._element(subindex)[0].struct.size

    def _element(self, index: int) -> tuple[Value[Any], str]:
        """The type of the element with an index, and its name in errors."""
        element = self.subindex(index) if self.subindices else None
        return self.value if element is None else element.value, self._title(element)

    def _title(self, element: Subindex | None) -> str:
        return self.title if element is None else f"{self.title}.{element.name}"


class ParameterSet:
    """The parameters of a set, in the order of their numbers; each is an attribute too, a run of them a tuple.

    `space` is the space of the numbers on the wire, which are the numbers of the set plus `base`. `numbers` are all
    numbers of the set as intervals, where the manual describes only some. `printed_as` is the format of a number.
    """

    __slots__ = ("_index", "_make", "_rows", "base", "name", "numbers", "printed_as", "space", "title")

    def __init__(
        self,
        name: str,
        make: Callable[[], Rows],
        *,
        title: str = "",
        space: str = "",
        base: int = 0,
        numbers: tuple[tuple[int, int], ...] = (),
        printed_as: str = "",
    ) -> None:
        self.name, self.title, self.space, self.base = name, title, space or name, base
        self.numbers, self.printed_as = numbers, printed_as
        self._make: Callable[[], Rows] = make
        self._rows: dict[str, Any] = {}
        self._index: dict[int, Parameter[Any]] = {}

    def _parameters(self) -> dict[int, Parameter[Any]]:
        """All parameters by number; they are created on first use, as few programs need many of them."""
        if not self._index:
            self._rows |= self._make()
            for row in self._rows.values():
                for parameter in row if isinstance(row, tuple) else (row,):
                    self._index[parameter.number] = parameter
        return self._index

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            if not name.startswith("_"):
                self._parameters()
                if name in self._rows:
                    return self._rows[name]
            raise AttributeError(f"{self.__class__.__name__} has no parameter {name}")

    def __dir__(self) -> list[str]:
        self._parameters()
        return [*super().__dir__(), *self._rows]

    def __len__(self) -> int:
        return len(self._parameters())

    def __iter__(self) -> Iterator[Parameter[Any]]:
        return iter(self._parameters().values())

    def __contains__(self, number: int) -> bool:
        return number in self._parameters() or any(first <= number <= last for first, last in self.numbers)

    def __getitem__(self, number: int) -> Parameter[Any]:
        """The parameter with a number of the set. Raises IndexError."""
        parameter = self._parameters().get(number)
        if parameter is None and number not in self:
            raise IndexError(f"there is no parameter {number}")
        return parameter or self._unknown(number)

    def __call__(self, wire_number: int) -> Parameter[Any]:
        """The parameter with a number on the wire. Raises CodecError for a number that the set does not have."""
        if wire_number - self.base not in self:
            raise no_parameter(self.space, wire_number)
        return self[wire_number - self.base]

    def _unknown(self, number: int) -> Parameter[Any]:
        """A parameter of which only the number is known."""
        unknown: Value[Any] = Unknown()
        return Parameter("", number, unknown, printed_name=self.number_text(number), set=self.name, base=self.base)

    def number_text(self, number: int) -> str:
        """The text of a number of the set, as the manual prints it."""
        return self.printed_as.format(number=number) if self.printed_as else str(number)

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


class ParameterSpace:
    """Sets of parameters that share the numbers on the wire."""

    __slots__ = ("_parameters", "name", "sets")

    def __init__(self, name: str, *sets: ParameterSet) -> None:
        self.name, self.sets = name, sets
        self._parameters: dict[int, Parameter[Any]] = {}

    def __call__(self, wire_number: int) -> Parameter[Any]:
        """The parameter with a number on the wire, even where only its set is known.

        Raises CodecError, which is a ValueError, for a number that no set has.
        """
        parameter = self._parameters.get(wire_number)
        if parameter is None:
            parameter_set = next(
                (parameter_set for parameter_set in self.sets if wire_number - parameter_set.base in parameter_set),
                None,
            )
            if parameter_set is None:
                raise no_parameter(self.name, wire_number)
            parameter = self._parameters[wire_number] = parameter_set[wire_number - parameter_set.base]
        return parameter

    def __contains__(self, wire_number: int) -> bool:
        return any(wire_number - parameter_set.base in parameter_set for parameter_set in self.sets)

    def __iter__(self) -> Iterator[Parameter[Any]]:
        return (parameter for parameter_set in self.sets for parameter in parameter_set)


def _filled(value: Value[Any], data: bytes) -> bytes:
    """The bytes of a value with the zeros after a text, which need not be sent."""
    return data.ljust(value.struct.size, b"\0") if isinstance(value, Text) else data


def no_parameter(space: str, wire_number: int) -> CodecError:
    """The error for a number that no set has."""
    return CodecError("unknown_value", f"{space} has no number {wire_number} ({wire_number:#06x})")


def single(parameter: Parameter[Any], values: Sequence[T]) -> T:
    """The value of a response. Raises CodecError unless there is exactly one."""
    if len(values) != 1:
        raise CodecError("wrong_length", f"{parameter.title} has {len(values)} values, not one")
    return values[0]


def selected(parameter: Parameter[Any], formats: Mapping[str, T], selector: T | None) -> T:
    """The selector of the type of values: the argument, or else the one for the parameter's type. Raises CodecError."""
    if selector is not None:
        return selector
    selection = formats.get(parameter.type)
    if selection is None:
        text = f"no value of the selector is known for {parameter.title}: give one"
        raise CodecError("unknown_value", text)
    return selection


def no_message(parameter: Parameter[Any], data: bytes) -> CodecError:
    """The error for a value with a number of bytes that no message carries."""
    return CodecError("out_of_range", f"no message carries the {len(data)} bytes of {parameter.title}")
