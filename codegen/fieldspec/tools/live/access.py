"""What can be read and written on a device by name, whatever carries it: registers, or parameters and answers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Protocol

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value
from fieldspec.tools.live.client import Client


@dataclass(frozen=True, slots=True)
class DumpRow:
    """A row of a dump: the name of the space, the address or the number there, and the counts."""

    space: str
    address: int
    value: str


if TYPE_CHECKING:
    from typing import Any, TypeAlias

    from fieldspec.tools.live import reading, writing
    from fieldspec.tools.live.messages import ParameterAssignment, SignalReading

    Item: TypeAlias = Any
    """A value that an access knows: what is at an address with its space, or a signal of messages."""

    Reading: TypeAlias = reading.Reading | SignalReading
    """A value that was read, or the reason why the device refused it. Equal `words` are the same value."""
    Assignment: TypeAlias = writing.Assignment | ParameterAssignment
    """A value that is to be written, and what a person should know before."""


class Access(Protocol):
    """Values of a device by name. Those that talk to it raise NoAnswerError and CarrierError."""

    layout: DeviceLayout
    what: str
    """The noun in the message about an unknown name."""
    rows_text: str
    """The values with rows in a dump, as a plural."""

    def heading(self, value: Any) -> str:
        """The heading of the number of a value: `address` or `number`."""

    def number(self, value: Any) -> int | None:
        """The address or the number of a value; None where it has none."""

    def number_text(self, value: Any) -> str:
        """The address or number of a value as people write it; empty where it has none."""

    def dump_rows(self, items: Sequence[Item], values: Sequence[Any]) -> list[DumpRow]:
        """The rows of a dump of values that were read, in order."""

    def items(self) -> Sequence[Item]:
        """All items that have a name."""

    def path(self, item: Item) -> str:
        """The path of an item."""

    def value(self, item: Item) -> Value:
        """The value of an item."""

    def named(self, name: str) -> list[Item]:
        """The items that a name means; none where it is unknown."""

    def harmless(self) -> list[Item]:
        """The items that can be read without an effect."""

    def reason_unread(self, name: str) -> str:
        """The reason why items of a name are not read; empty where the name means none."""

    def remarks(self, names: Sequence[str]) -> list[str]:
        """The values of the device that are not read with some names, or without names."""

    def objection(self, item: Item) -> str:
        """The reason why an item is in no list that is written to a device; empty where it may be."""

    def assignment(self, item: Item, text: str) -> Assignment:
        """The assignment of a value as people write it. Raises WriteError."""

    def together(self, chosen: Sequence[Any]) -> tuple[list[Any], dict[str, str]]:
        """Assignments with what is written beside them in one request, and by path why some are not written."""

    def intended(self, chosen: Any) -> Reading:
        """What would be read once a value is written."""

    def size(self, items: Iterable[Item]) -> int:
        """The number of steps that a read of items has, in which `read` tells its progress."""

    def read(
        self, client: Client, items: Sequence[Item], done: Callable[[int], None] | None = None
    ) -> Iterator[Reading]:
        """Reads items, each once. A refused one costs no other."""

    def frame(self, client: Client, chosen: Any) -> bytes:
        """The request that writes a value; in a table that moves, at its usual address. Raises WriteError."""

    def address_register(self, chosen: Any) -> str:
        """The register that says where the table of a value begins; empty where its address is fixed."""

    def write(self, client: Client, chosen: Any) -> None:
        """Writes a value, once. Raises WriteError and RefusedError."""

    def read_back(self, client: Client, chosen: Any) -> Reading | None:
        """The value of the device after a write; None for what does not give back what was written."""

    def signals(self, item: Item, roles: Sequence[str]) -> Iterator[tuple[str, int]]:
        """The roles of a value or of its bits, each with its mask; -1 for all bits."""

    def item(self, chosen: Any) -> Item:
        """The item to which a value is assigned."""

    def words_of(self, value: Any, text: str) -> tuple[int, ...]:
        """The words that a text means for a value that was read. Raises WriteError."""


def differs(chosen: Assignment, now: Reading) -> bool:
    """Whether the value in the device differs from the assigned value, whatever shares its words."""
    if now.refusal or not chosen.mask:
        return bool(now.refusal) or tuple(now.words) != chosen.words
    return any((word ^ own) & mask for word, own, mask in zip(now.words, chosen.words, chosen.mask, strict=True))


def find(access: Access, names: Sequence[str]) -> tuple[list[Item], list[str]]:
    """The items that names mean, and the names that mean none."""
    result: dict[str, Item] = {}
    unknown = []
    for name in names:
        own = access.named(name)
        if not own:
            unknown.append(name)
        result |= {access.path(item): item for item in own}
    return list(result.values()), unknown


def clears_on_read(fact: object) -> bool:
    """Whether reading a fact clears it."""
    handling = getattr(fact, "handling", None)
    return handling is not None and bool(handling.clears_on_read)


def role_masks(device: Device, fact: Fact, value: Value, roles: Sequence[str]) -> Iterator[tuple[str, int]]:
    """Those of the roles that a value or its bits have, each with its mask; -1 for all bits."""
    bits = device.flags[value.flags].bits if value.flags else ()
    for role in roles:
        if role in fact.roles:
            yield role, -1
        yield from ((role, bit.mask) for bit in bits if role in bit.roles)
