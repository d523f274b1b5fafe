"""Payloads: what packets, lines of a log or rows of a file carry, as columns over one buffer."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from fieldspec.captures.columns import NO_TIME, Bytes, Mask, Numbers, numbers
from fieldspec.classes import dataclass

REQUEST, RESPONSE, UNKNOWN = 0, 1, -1
"""The direction of a payload."""

DIRECTION_CODES = {"request": REQUEST, "response": RESPONSE, "": UNKNOWN}


@dataclass(frozen=True, slots=True)
class Payloads:
    """Payloads in the order of their capture, `size` bytes each from `at` on in the buffer.

    `time` is in nanoseconds since 1970, or NO_TIME. `packet` is the number of the packet or the line, from 1. `stream`
    is the place of its connection in the names of the source. `is_datagram`: the medium sends a payload as a unit;
    else payloads are pieces of a stream of bytes. `follows_loss`: bytes before it are missing in the capture.
    """

    buffer: Bytes
    at: Numbers
    size: Numbers
    time: Numbers
    packet: Numbers
    stream: Numbers
    direction: Numbers
    is_datagram: Mask
    follows_loss: Mask

    @staticmethod
    def of_columns(buffer: Bytes, columns: Sequence[Numbers], is_datagram: Mask, follows_loss: Mask) -> Payloads:
        """Payloads from the columns of numbers in their order."""
        at, size, time, packet, stream, direction = columns
        return Payloads(buffer, at, size, time, packet, stream, direction, is_datagram, follows_loss)

    def __len__(self) -> int:
        return len(self.at)

    def at_rows(self, rows: Numbers | Mask) -> Payloads:
        """Some of them."""
        columns = (self.at, self.size, self.time, self.packet, self.stream, self.direction)
        own = [column[rows] for column in columns]
        return Payloads.of_columns(self.buffer, own, self.is_datagram[rows], self.follows_loss[rows])

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
        np.full(len(table), is_datagram),
        lost,
    )


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
