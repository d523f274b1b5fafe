"""Payloads: what packets, lines of a log or rows of a file carry, as columns over one buffer."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.captures.columns import NO_TIME, Bytes, Mask, Numbers, Verdicts, gathered, numbers

Carriers: TypeAlias = Verdicts

REQUEST, RESPONSE, UNKNOWN = 0, 1, -1
"""The direction of a payload."""

DATAGRAM, PIECE, STREAM = 0, 1, 2
"""What carries a payload: a medium that sends it as a unit, a line that carries any pieces, or a stream of TCP."""

DIRECTION_CODES = {"request": REQUEST, "response": RESPONSE, "": UNKNOWN}


@dataclass(frozen=True, slots=True)
class Payloads:
    """Payloads in the order of their capture, `size` bytes each from `at` on in the buffer.

    `time` is in nanoseconds since 1970, or NO_TIME. `packet` is the number of the packet or the line, from 1. `stream`
    is the place of its connection in the names of the source. `carrier` is DATAGRAM, PIECE or STREAM.
    `follows_loss`: bytes before it are missing in the capture.
    """

    buffer: Bytes
    at: Numbers
    size: Numbers
    time: Numbers
    packet: Numbers
    stream: Numbers
    direction: Numbers
    carrier: Carriers
    follows_loss: Mask

    @staticmethod
    def of_columns(buffer: Bytes, columns: Sequence[Numbers], carrier: Carriers, follows_loss: Mask) -> Payloads:
        """Payloads from the columns of numbers in their order."""
        offsets, size, time, packet, stream, direction = columns
        return Payloads(buffer, offsets, size, time, packet, stream, direction, carrier, follows_loss)

    def __len__(self) -> int:
        return len(self.at)

    def at_rows(self, rows: Numbers | Mask) -> Payloads:
        """The payloads in some rows."""
        columns = (self.at, self.size, self.time, self.packet, self.stream, self.direction)
        own = [column[rows] for column in columns]
        return Payloads.of_columns(self.buffer, own, self.carrier[rows], self.follows_loss[rows])

    def columns(self) -> tuple[npt.NDArray[Any], ...]:
        """All columns in their order."""
        return (
            self.at, self.size, self.time, self.packet, self.stream, self.direction, self.carrier, self.follows_loss
        )  # fmt: skip

    def compact(self) -> Payloads:
        """The payloads in a buffer that has no other bytes."""
        data, offsets = gathered(self.buffer, self.at, self.size)
        return Payloads(np.append(data, np.uint8(0)), offsets[:-1], *self.columns()[1:])

    def state(self) -> dict[str, Any]:
        """The payloads as data that JSON can hold, if they are compact."""
        return {"data": self.buffer.tobytes().hex(), "columns": [column.tolist() for column in self.columns()]}

    @staticmethod
    def of_state(state: dict[str, Any]) -> Payloads:
        """The payloads that `state` has returned."""
        *columns, carrier, loss = state["columns"]
        buffer = np.frombuffer(bytes.fromhex(state["data"]), np.uint8)
        carriers, losses = np.array(carrier, np.int8), np.array(loss, np.bool_)
        return Payloads.of_columns(buffer, [numbers(column) for column in columns], carriers, losses)

    def data(self, row: int) -> bytes:
        """The bytes of a payload."""
        return self.buffer[int(self.at[row]) : int(self.at[row] + self.size[row])].tobytes()


def payloads_of(
    rows: Iterable[tuple[bytes, int | None, int, int, int]], is_datagram: bool = True, loss: Iterable[bool] = ()
) -> Payloads:
    """Payloads from rows of bytes, time in nanoseconds, packet, stream and direction."""
    table = list(rows)
    sizes = numbers([len(row[0]) for row in table])
    lost = np.array(list(loss) or [False] * len(table), np.bool_)
    return Payloads(
        np.frombuffer(b"".join(row[0] for row in table) + b"\0", np.uint8),
        np.cumsum(sizes) - sizes,
        sizes,
        numbers([NO_TIME if row[1] is None else row[1] for row in table]),
        numbers([row[2] for row in table]),
        numbers([row[3] for row in table]),
        numbers([row[4] for row in table]),
        np.full(len(table), DATAGRAM if is_datagram else PIECE, np.int8),
        lost,
    )


def joined(left: Payloads, right: Payloads) -> Payloads:
    """The payloads of both, the first's before the second's."""
    buffer = np.concatenate([left.buffer, right.buffer])
    moved = Payloads(buffer, right.at + len(left.buffer), *right.columns()[1:])
    return Payloads(buffer, *map(np.concatenate, zip(left.columns(), moved.columns(), strict=True)))


class Names:
    """Names of connections, each with its place in the list, in the order in which they appear."""

    def __init__(self, texts: Iterable[str] = ()) -> None:
        self.texts = list(texts)
        self._places = {text: place for place, text in enumerate(self.texts)}

    def place(self, text: str) -> int:
        """The place of a name, which is added where it is new."""
        if text not in self._places:
            self._places[text] = len(self.texts)
            self.texts.append(text)
        return self._places[text]
