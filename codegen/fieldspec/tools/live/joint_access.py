"""Registers, and the parameters and answers that messages of the same link carry, as values by name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, TypeVar

from fieldspec.tools.live.access import Access
from fieldspec.tools.live.messages import ParameterAssignment, Signal, SignalReading

if TYPE_CHECKING:
    from typing import Any

    from fieldspec.tools.live.access import DumpRow, Item, Reading
    from fieldspec.tools.live.client import Client
    from fieldspec.tools.live.parameter_access import ParameterAccess
    from fieldspec.tools.live.register_access import RegisterAccess

T = TypeVar("T")


def _of_owner(method: Callable[..., T], place: int = 0) -> Callable[..., T]:
    """A method that the access of its argument at a place answers, an item, a value or an assignment."""

    def forwarded(self: JointAccess, *arguments: Any) -> T:
        own: T = getattr(self._owner(arguments[place]), method.__name__)(*arguments)
        return own

    return forwarded


class JointAccess(Access):
    """The registers and the signals of a link. A signal with the name of a register is left out, by name."""

    what, rows_text = "value", "words and parameters"

    def __init__(self, registers: RegisterAccess, parameters: ParameterAccess) -> None:
        self.layout = registers.layout
        self._registers, self._parameters = registers, parameters
        self._taken = {registers.path(item) for item in registers.items()}

    def _owner(self, part: object) -> Access:
        """The access of an item, of a value that was read, or of an assignment."""
        return self._parameters if isinstance(part, Signal | SignalReading | ParameterAssignment) else self._registers

    def _free(self, items: Iterable[Signal]) -> list[Signal]:
        return [item for item in items if item.path not in self._taken]

    heading = _of_owner(Access.heading)
    number = _of_owner(Access.number)
    number_text = _of_owner(Access.number_text)
    path = _of_owner(Access.path)
    value = _of_owner(Access.value)
    objection = _of_owner(Access.objection)
    assignment = _of_owner(Access.assignment)
    intended = _of_owner(Access.intended)
    signals = _of_owner(Access.signals)
    item = _of_owner(Access.item)
    words_of = _of_owner(Access.words_of)
    address_register = _of_owner(Access.address_register)
    frame = _of_owner(Access.frame, 1)
    write = _of_owner(Access.write, 1)
    read_back = _of_owner(Access.read_back, 1)

    def dump_rows(self, items: Sequence[Item], values: Sequence[Any]) -> list[DumpRow]:
        rows: list[DumpRow] = []
        for access in (self._registers, self._parameters):
            chosen = [pair for pair in zip(items, values, strict=True) if self._owner(pair[0]) is access]
            rows += access.dump_rows([item for item, _ in chosen], [value for _, value in chosen])
        return rows

    def items(self) -> Sequence[Item]:
        return [*self._registers.items(), *self._free(self._parameters.items())]

    def named(self, name: str) -> list[Item]:
        return [*self._registers.named(name), *self._free(self._parameters.named(name))]

    def harmless(self) -> list[Item]:
        return [*self._registers.harmless(), *self._free(self._parameters.harmless())]

    def reason_unread(self, name: str) -> str:
        return self._registers.reason_unread(name) or self._parameters.reason_unread(name)

    def remarks(self, names: Sequence[str]) -> list[str]:
        hidden = [item.path for item in self._parameters.items() if item.path in self._taken]
        hidden = [path for path in hidden if path in names or not names]
        texts = [f"not read, as registers have their names: {', '.join(hidden)}"] * bool(hidden)
        return [*self._parameters.remarks(names), *texts]

    def together(self, chosen: Sequence[Any]) -> tuple[list[Any], dict[str, str]]:
        registers, reasons = self._registers.together([own for own in chosen if self._owner(own) is self._registers])
        merged = iter(registers)
        return [
            next(merged) if self._owner(own) is self._registers else own for own in chosen if own.path not in reasons
        ], reasons

    def size(self, items: Iterable[Item]) -> int:
        parts = list(items)
        return sum(
            access.size([item for item in parts if self._owner(item) is access])
            for access in (self._registers, self._parameters)
        )

    def read(
        self, client: Client, items: Sequence[Item], done: Callable[[int], None] | None = None
    ) -> Iterator[Reading]:
        values: dict[str, Reading] = {}
        for access in (self._registers, self._parameters):
            chosen = [item for item in items if self._owner(item) is access]
            values |= {value.path: value for value in access.read(client, chosen, done)}
        return (values[self.path(item)] for item in items)
