"""Registers, and the parameters and answers that messages of the same link carry, as values by name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from fieldspec.tools.live.messages import ParameterAssignment, Signal, SignalReading

if TYPE_CHECKING:
    from typing import Any

    from fieldspec.language.model.value import Value
    from fieldspec.tools.live.access import Access, Assignment, DumpRow, Item, Reading
    from fieldspec.tools.live.client import Client
    from fieldspec.tools.live.parameter_access import ParameterAccess
    from fieldspec.tools.live.register_access import RegisterAccess


class JointAccess:
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

    def heading(self, value: Reading) -> str:
        """The heading of the number of a value."""
        return self._owner(value).heading(value)

    def number(self, value: Reading) -> int | None:
        """The address of a register, or the number of a parameter."""
        return self._owner(value).number(value)

    def number_text(self, value: Reading) -> str:
        """The address or the number as people write it."""
        return self._owner(value).number_text(value)

    def dump_rows(self, items: Sequence[Item], values: Sequence[Any]) -> list[DumpRow]:
        """A row for each word of registers, and for each parameter."""
        rows: list[DumpRow] = []
        for access in (self._registers, self._parameters):
            chosen = [pair for pair in zip(items, values, strict=True) if self._owner(pair[0]) is access]
            rows += access.dump_rows([item for item, _ in chosen], [value for _, value in chosen])
        return rows

    def items(self) -> Sequence[Item]:
        """The occupants of all addresses, and all other values that messages read."""
        return [*self._registers.items(), *self._free(self._parameters.items())]

    def path(self, item: Item) -> str:
        """The path of an item."""
        return self._owner(item).path(item)

    def value(self, item: Item) -> Value:
        """The value of an item."""
        return self._owner(item).value(item)

    def named(self, name: str) -> list[Item]:
        """The registers and signals with a name."""
        return [*self._registers.named(name), *self._free(self._parameters.named(name))]

    def harmless(self) -> list[Item]:
        """The items that are read without an effect."""
        return [*self._registers.harmless(), *self._free(self._parameters.harmless())]

    def reason_unread(self, name: str) -> str:
        """Why what a name means is not read; empty where it means nothing."""
        return self._registers.reason_unread(name) or self._parameters.reason_unread(name)

    def remarks(self, names: Sequence[str]) -> list[str]:
        """The values of messages that are not read, and the parameters whose names mean registers."""
        hidden = [item.path for item in self._parameters.items() if item.path in self._taken]
        hidden = [path for path in hidden if path in names or not names]
        texts = [f"not read, as registers have their names: {', '.join(hidden)}"] * bool(hidden)
        return [*self._parameters.remarks(names), *texts]

    def objection(self, item: Item) -> str:
        """Why an item is in no list that is written to a device; empty where it may be."""
        return self._owner(item).objection(item)

    def assignment(self, item: Item, text: str) -> Assignment:
        """The assignment of a value as people write it. Raises WriteError."""
        return self._owner(item).assignment(item, text)

    def together(self, chosen: Sequence[Any]) -> tuple[list[Any], dict[str, str]]:
        """Assignments with the words of all registers that share a word; no parameter shares a request."""
        registers, reasons = self._registers.together([own for own in chosen if self._owner(own) is self._registers])
        merged = iter(registers)
        return [
            next(merged) if self._owner(own) is self._registers else own for own in chosen if own.path not in reasons
        ], reasons

    def intended(self, chosen: Any) -> Reading:
        """What would be read once a value is written."""
        return self._owner(chosen).intended(chosen)

    def size(self, items: Iterable[Item]) -> int:
        """The number of words in all requests, and of signals."""
        parts = list(items)
        return sum(
            access.size([item for item in parts if self._owner(item) is access])
            for access in (self._registers, self._parameters)
        )

    def read(
        self, client: Client, items: Sequence[Item], done: Callable[[int], None] | None = None
    ) -> Iterator[Reading]:
        """Reads items, registers first. Raises NoAnswerError and CarrierError."""
        values: dict[str, Reading] = {}
        for access in (self._registers, self._parameters):
            chosen = [item for item in items if self._owner(item) is access]
            values |= {value.path: value for value in access.read(client, chosen, done)}
        return (values[self.path(item)] for item in items)

    def frame(self, client: Client, chosen: Any) -> bytes:
        """The request that writes a value. Raises WriteError."""
        return self._owner(chosen).frame(client, chosen)

    def address_register(self, chosen: Any) -> str:
        """The register that says where the table of a value begins; empty where its address is fixed."""
        return self._owner(chosen).address_register(chosen)

    def write(self, client: Client, chosen: Any) -> None:
        """Writes a value, once. Raises WriteError, NoAnswerError, RefusedError and CarrierError."""
        self._owner(chosen).write(client, chosen)

    def read_back(self, client: Client, chosen: Any) -> Reading | None:
        """The value of the device after a write. Raises NoAnswerError and CarrierError."""
        return self._owner(chosen).read_back(client, chosen)

    def signals(self, item: Item, roles: Sequence[str]) -> Iterator[tuple[str, int]]:
        """The roles of a value or of its bits, each with its mask; -1 for all bits."""
        return self._owner(item).signals(item, roles)

    def item(self, chosen: Any) -> Item:
        """The item to which a value is assigned."""
        return self._owner(chosen).item(chosen)

    def words_of(self, value: Any, text: str) -> tuple[int, ...]:
        """The words that a text means for a value that was read. Raises WriteError."""
        return self._owner(value).words_of(value, text)
