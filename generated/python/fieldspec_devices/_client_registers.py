"""Registers and parameters of clients by their names, read in as few requests as the device permits."""

from __future__ import annotations

from ._error import CodecError
from ._parameters import Parameter
from ._registers import Register, RegisterArray, Table
from ._typing import TYPE_CHECKING, T
from ._values import Bytes
from .errors import InvalidAnswerError, InvalidValueError, RefusedError

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any

    from ._client import Session, Work
    from ._segments import Segments
    from ._typing import Quantity

Span = tuple[str, int, int]
"""A space, the first address, and the address after the last one."""


class Group:
    """Registers that are read together. `spans` are the addresses that may be read without a hole between them."""

    __slots__ = ("name", "registers", "spans")

    def __init__(self, name: str, registers: tuple[Any, ...], spans: tuple[Span, ...]) -> None:
        self.name, self.spans = name, spans
        self.registers: tuple[Register[Any], ...] = tuple(single for entry in registers for single in _singles(entry))

    def __repr__(self) -> str:
        return f"<group {self.name}: {len(self.registers)} registers>"

    def blocks(self) -> Iterator[list[Register[Any]]]:
        """The registers that one request each reads. Values outside of all spans are left out, such as values that
        reading clears.
        """
        for space, start, end in self.spans:
            block = [
                register
                for register in self.registers
                if register.space == space and start <= register.address and register.address + register.words <= end
            ]
            if block:
                yield sorted(block, key=lambda register: register.address)


class Values:
    """Values of registers that were read together. `refused` has the registers that the device refused, by name."""

    __slots__ = ("_values", "refused")

    def __init__(self) -> None:
        self._values: dict[str, tuple[Register[Any], Any]] = {}
        self.refused: dict[str, RefusedError] = {}

    def add(self, register: Register[Any], value: Any) -> None:
        """Adds a value."""
        self._values[register.name] = register, value

    def __getitem__(self, register: Register[T]) -> T:
        """The value of a register. Raises KeyError where it was not read, and RefusedError where it was refused."""
        if register.name in self.refused:
            raise self.refused[register.name]
        value: T = self._values[register.name][1]
        return value

    def in_unit(self, register: Register[Any]) -> float | None:
        """The value in its unit; None for one that stands for an absent value. Raises what `values[register]` does.

        Where the scale is in another register, this one must have been read, too.
        """
        return register.in_unit(self[register], None if register.scale_by is None else self[register.scale_by])

    def __contains__(self, register: Register[Any]) -> bool:
        return register.name in self._values

    def __iter__(self) -> Iterator[Register[Any]]:
        return (register for register, _ in self._values.values())

    def __len__(self) -> int:
        return len(self._values)

    def __repr__(self) -> str:
        return f"<values {', '.join(f'{name}={value!r}' for name, (_, value) in self._values.items())}>"


def _singles(entry: Any) -> Iterator[Register[Any]]:
    if isinstance(entry, Register):
        yield entry
    else:
        yield from entry


class RegisterWork:
    """Reads and writes of registers, as generators. `codec` is the module of the device's version."""

    def __init__(self, session: Session, codec: Any) -> None:
        self.session, self.codec, self.options = session, codec, session.link.registers

    def read(self, register: Register[T]) -> Work[T]:
        """The value of a register."""
        responses = []
        for request in _encoded(self.codec.read_requests, _single(register), **self.options):
            response = yield from self.session.ask(request)
            responses.append(response.message)
        value: T = _decoded(self.codec.read_value, register, *responses, **self.options)
        return value

    def read_in_unit(self, register: Register[Any]) -> Work[float | None]:
        """The value of a register in its unit, by the exponent that the device has for it."""
        scale_by = _single(register).scale_by
        exponent = None if scale_by is None else (yield from self.read(scale_by))
        quantity: float | None = _decoded(register.in_unit, (yield from self.read(register)), exponent)
        return quantity

    def read_table(self, table: Table[T]) -> Work[list[T]]:
        """The records of a table that the device has. Their number and their address are read first where registers
        have them."""
        if not isinstance(table, Table):
            raise InvalidValueError(f"{table!r} is not a table of records: read it with `read`")
        if table.base_by is not None:
            table = _decoded(table.at_base, (yield from self.read(table.base_by)))
        count = table.count if table.count_by is None else (yield from self.read(table.count_by))
        records = []
        for register in _decoded(table.present, count):
            record = yield from self.read(register)
            records.append(record)
        return records

    def write(self, register: Register[T], value: T) -> Work[None]:
        """Writes a register; the value is encoded at once."""
        write_requests = _function(self.codec, "write_requests", _single(register).name)
        return self._sent(_encoded(write_requests, register, value, **self.options))

    def write_in_unit(self, register: Register[Any], quantity: Quantity | None) -> Work[None]:
        """Writes a register by a value in its unit; it is encoded at once, or by the exponent that the device has."""
        scale_by = _single(register).scale_by
        if scale_by is not None:
            return self._write_by_exponent(register, scale_by, quantity)
        return self.write(register, _encoded(register.from_unit, quantity))

    def _write_by_exponent(
        self, register: Register[Any], scale_by: Register[int], quantity: Quantity | None
    ) -> Work[None]:
        exponent = yield from self.read(scale_by)
        yield from self.write(register, _encoded(register.from_unit, quantity, exponent))

    def _sent(self, requests: Sequence[Any]) -> Work[None]:
        # A request that is sent again could start something twice.
        for request in requests:
            if request.__class__ in self.session.link.unanswered:
                yield from self.session.send(request)
            else:
                yield from self.session.ask(request, 0)

    def read_group(self, group: Group) -> Work[Values]:
        """The registers of a group. A block that the device refuses is divided, so that a refusal costs no other."""
        if not isinstance(group, Group):
            raise InvalidValueError(f"{group!r} is not a group: pass one of the module of the client")
        values = Values()
        for block in group.blocks():
            yield from self._read_block(block, values)
        return values

    def _read_block(self, block: list[Register[Any]], values: Values) -> Work[None]:
        register = block[0] if len(block) == 1 else _whole(block)
        try:
            content = yield from self.read(register)
        except RefusedError as error:
            if len(block) == 1:
                values.refused[register.name] = error
                return
            middle = len(block) // 2
            yield from self._read_block(block[:middle], values)
            yield from self._read_block(block[middle:], values)
            return
        if len(block) == 1:
            values.add(register, content)
            return
        for single in block:
            size = single.unit_size
            offset = size * (single.address - register.address)
            values.add(single, _decoded(single.decode, content[offset : offset + size * single.words]))


def _single(register: Register[T]) -> Register[T]:
    """The same register. Raises InvalidValueError for several registers, and for other objects."""
    if isinstance(register, Register):
        return register
    if isinstance(register, Table | RegisterArray):
        number = register.first
        raise InvalidValueError(f"{register.name} has several registers: pass one of them, such as [{number}]")
    raise InvalidValueError(f"{register!r} is not a register: pass a constant of the device, not its name")


def _whole(block: list[Register[Any]]) -> Register[Any]:
    """The words of a block as one register of bytes."""
    first = block[0]
    words = max(register.address + register.words for register in block) - first.address
    size = first.unit_size * words
    value: Any = Bytes(f"{size}s", size)
    options: dict[str, Any] = {"order": first.order, "space": first.space, "unit_size": first.unit_size}
    return Register(first.name, first.address, words, value, **options)


class ParameterAccess:
    """How the parameters of a set are reached: the functions of their space that make requests, and the arguments.

    `count` is the argument with the number of elements, empty where there is none. It is 0 for a single value.
    `reads` and `writes` say how values follow in pieces that no message carries alone.
    """

    def __init__(
        self,
        space: Any,
        *,
        count: str = "",
        indexed: bool = False,
        reads: Segments | None = None,
        writes: Segments | None = None,
    ) -> None:
        self.space, self.count, self.indexed, self.reads, self.writes = space, count, indexed, reads, writes

    def reading(self, parameter: Parameter[Any]) -> Any:
        """The function that makes the request to read a parameter. Raises InvalidValueError where there is none."""
        return _function(self.space, "read_request", parameter.title)

    def writing(self, parameter: Parameter[Any]) -> Any:
        """The function that makes the request to write a parameter. Raises InvalidValueError where there is none."""
        return _function(self.space, "write_request", parameter.title)

    def arguments(self, parameter: Parameter[Any], subindex: int, count: int) -> dict[str, int]:
        """The arguments of a request for some elements."""
        arguments = {"subindex": subindex} if self.indexed else {}
        if self.count:
            arguments[self.count] = 0 if parameter.elements is None and not subindex and count == 1 else count
        return arguments


class ParameterWork:
    """Reads and writes of parameters, as generators. `accesses` are by the names of the sets."""

    def __init__(self, session: Session, accesses: dict[str, ParameterAccess]) -> None:
        self.session, self.accesses = session, accesses

    def read(self, parameter: Parameter[T], subindex: int = 0) -> Work[T]:
        """The value of a parameter, or of one element."""
        access = self._access(parameter)
        request = _encoded(access.reading(parameter), parameter, **access.arguments(parameter, subindex, 1))
        response = yield from self.session.ask(request)
        if access.reads is not None and access.reads.follows(response.message):
            data = yield from access.reads.read(self.session, request, response.message, parameter.size(subindex))
            whole: T = _decoded(parameter.from_bytes, data, subindex)
            return whole
        value: T = _decoded(access.space.read_value, parameter, response.message, *([subindex] if subindex else []))
        return value

    def read_elements(self, parameter: Parameter[T], first: int = 0, count: int | None = None) -> Work[list[T]]:
        """The values of `count` elements from the `first` one on; of all where it is None."""
        access = self._access(parameter)
        if not access.count:
            raise InvalidValueError(f"no message reads several elements of {parameter.title}")
        elements = (parameter.elements or 1) - first if count is None else count
        request = _encoded(access.reading(parameter), parameter, **access.arguments(parameter, first, elements))
        response = yield from self.session.ask(request)
        values: list[T] = _decoded(access.space.read_values, parameter, response.message, first)
        return values

    def read_in_unit(self, parameter: Parameter[Any], subindex: int = 0) -> Work[float | None]:
        """The value of a parameter, or of one element, in its unit."""
        value = yield from self.read(parameter, subindex)
        return parameter.in_unit(value, subindex)

    def write_in_unit(self, parameter: Parameter[Any], quantity: Quantity | None, subindex: int = 0) -> Work[None]:
        """Writes a parameter, or one element, by a value in its unit; it is encoded at once."""
        self._access(parameter)
        return self.write(parameter, _encoded(parameter.from_unit, quantity, subindex), subindex)

    def write(self, parameter: Parameter[T], value: T, subindex: int = 0) -> Work[None]:
        """Writes a parameter, or one element; the value is encoded at once."""
        access = self._access(parameter)
        if access.writes is not None and parameter.size(subindex) not in access.writes.whole:
            _encoded(parameter.writable, subindex)
            data = _encoded(parameter.to_bytes, value, subindex)
            first = _encoded(access.writes.begin, parameter, subindex, data)
            return access.writes.write(self.session, first, data)
        arguments = access.arguments(parameter, subindex, 1)
        return self._sent(_encoded(access.writing(parameter), parameter, value, **arguments))

    def _sent(self, request: Any) -> Work[None]:
        yield from self.session.ask(request, 0)

    def _access(self, parameter: Parameter[Any]) -> ParameterAccess:
        if not isinstance(parameter, Parameter):
            raise InvalidValueError(f"{parameter!r} is not a parameter: pass a constant of the device, not its name")
        access = self.accesses.get(parameter.set)
        if access is None:
            raise InvalidValueError(f"no message reads or writes single parameters of {parameter.set}")
        return access


def _function(owner: Any, name: str, title: str) -> Any:
    """A function that some devices do not have. Raises InvalidValueError."""
    function = getattr(owner, name, None)
    if function is None:
        raise InvalidValueError(f"no message {name.partition('_')[0]}s {title}")
    return function


def _encoded(encode: Any, *arguments: Any, **options: Any) -> Any:
    """The result of a function that encodes. Raises InvalidValueError."""
    try:
        return encode(*arguments, **options)
    except CodecError as error:
        raise InvalidValueError(str(error)) from error


def _decoded(decode: Any, *arguments: Any, **options: Any) -> Any:
    try:
        return decode(*arguments, **options)
    except CodecError as error:
        raise InvalidAnswerError(str(error)) from error
