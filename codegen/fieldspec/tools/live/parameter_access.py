"""Parameters, and values in answers, as values by name."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from fieldspec.codec.explain.hazards import reads_state, roles_of
from fieldspec.language.model.access import writable
from fieldspec.tools.live.access import Access, DumpRow, clears_on_read, role_masks
from fieldspec.tools.live.left_out import ADVICE, reason_unread, remarks
from fieldspec.tools.live.messages import (
    ParameterAssignment,
    Signal,
    SignalReading,
    named_signals,
    parameter_assignment,
    parameter_message,
    parameter_request,
    read_signals,
    signal_reading,
    signals,
    write_parameter,
    writes_elements,
)
from fieldspec.tools.live.value_lists import COMMANDS

if TYPE_CHECKING:
    from fieldspec.codec.layout.device import DeviceLayout
    from fieldspec.codec.layout.frame import LinkLayout
    from fieldspec.language.model.value import Value
    from fieldspec.tools.live.client import Client


class ParameterAccess(Access):
    """The values that the messages of a link read and write, by name. An item is a signal."""

    what, rows_text = "value", "parameters"

    def __init__(self, layout: DeviceLayout, link: LinkLayout) -> None:
        self.layout, self.link = layout, link
        self._items = list(signals(layout, link))

    def heading(self, value: SignalReading) -> str:
        return "number"

    def number(self, value: SignalReading) -> int | None:
        numbered = value.signal.numbered
        return numbered.wire_number if numbered is not None else None

    def number_text(self, value: SignalReading) -> str:
        number = self.number(value)
        return "" if number is None else str(number)

    def dump_rows(self, items: Sequence[Signal], values: Sequence[SignalReading]) -> list[DumpRow]:
        """A row for each parameter that was read, with the counts of its elements.

        Texts and fractions have no counts, and elements after one that was refused have no place.
        """
        counts: dict[tuple[str, int], list[int]] = {}
        for value in values:
            signal, number = value.signal, value.decoded.number if value.decoded is not None else None
            numbered = signal.numbered
            if numbered is None or not isinstance(number, int):
                continue
            own = counts.setdefault((numbered.parameter_set.space, numbered.wire_number), [])
            if len(own) == (signal.index or 0):
                own.append(int(number))
        return [DumpRow(*key, " ".join(map(str, own))) for key, own in sorted(counts.items()) if own]

    def items(self) -> Sequence[Signal]:
        return self._items

    def path(self, item: Signal) -> str:
        return item.path

    def value(self, item: Signal) -> Value:
        return item.value

    def named(self, name: str) -> list[Signal]:
        """The signals with a path, all fields of a message, a parameter by its printed name, a role."""
        return named_signals(self.layout, self._items, name)

    def harmless(self) -> list[Signal]:
        """Parameters, and what messages answer that only read, as far as the spec shows it."""
        messages = self.layout.messages
        return [
            item
            for item in self._items
            if (reads_state(self.layout, messages[item.query]) if item.query else not clears_on_read(item.fact))
        ]

    def reason_unread(self, name: str) -> str:
        reason = reason_unread(self.link, name)
        return f"{reason}: {ADVICE}" if reason else ""

    def remarks(self, names: Sequence[str]) -> list[str]:
        return list(remarks(self.layout, self.link, names))

    def objection(self, item: Signal) -> str:
        """Why an item is in no list that is written to a device; empty where it may be.

        Where a set states the access of none of its parameters, the messages that read and write them do.
        """
        if item.numbered is None:
            return "is part of a response"
        fact, parameter_set = item.numbered.parameter, item.numbered.parameter_set
        message = parameter_message(self.link, parameter_set, "write", item.value.size)
        if item.index is not None and not (message is not None and writes_elements(message)):
            return "is an element, not written by itself"
        if fact.trigger or COMMANDS.intersection(roles_of(self.layout.device, item.fact, item.value)):
            return "commands the device; write it by its name, with the verb write"
        stated = any(row.access for row in parameter_set.parameters)
        if not writable(item.access) and (item.access or stated):
            return "can only be read" if item.access else "is not stated to be writable"
        if item.access == "wo" or fact.handling.clears_on_read:
            return "cannot be read back, so that nothing could be verified; write it by its name, with the verb write"
        if message is None:
            return "has no message that writes it by itself"
        return ""

    def assignment(self, item: Signal, text: str) -> ParameterAssignment:
        return parameter_assignment(self.layout, self.link, item, text)

    def together(self, chosen: Sequence[ParameterAssignment]) -> tuple[list[ParameterAssignment], dict[str, str]]:
        """The same assignments: no value shares a request with another one."""
        return list(chosen), {}

    def intended(self, chosen: ParameterAssignment) -> SignalReading:
        return signal_reading(self.layout, chosen.signal, chosen.raw)

    def size(self, items: Iterable[Signal]) -> int:
        """The number of values."""
        return len(list(items))

    def read(
        self, client: Client, items: Sequence[Signal], done: Callable[[int], None] | None = None
    ) -> Iterator[SignalReading]:
        """Reads items; one request serves all values of a response. Raises NoAnswerError and CarrierError."""
        for value in read_signals(client, items):
            if done is not None:
                done(1)
            yield value

    def frame(self, client: Client, chosen: ParameterAssignment) -> bytes:
        return parameter_request(client, chosen)[2]

    def address_register(self, chosen: ParameterAssignment) -> str:
        """Empty: no parameter has an address that moves."""
        return ""

    def write(self, client: Client, chosen: ParameterAssignment) -> None:
        write_parameter(client, chosen)

    def read_back(self, client: Client, chosen: ParameterAssignment) -> SignalReading | None:
        numbered = chosen.signal.numbered
        if numbered is not None and (numbered.parameter.trigger or chosen.signal.access == "wo"):
            return None
        return next(read_signals(client, [chosen.signal]))

    def signals(self, item: Signal, roles: Sequence[str]) -> Iterator[tuple[str, int]]:
        yield from role_masks(self.layout.device, item.fact, item.value, roles)

    def item(self, chosen: ParameterAssignment) -> Signal:
        return chosen.signal

    def words_of(self, value: SignalReading, text: str) -> tuple[int, ...]:
        return self.assignment(value.signal, text).words
