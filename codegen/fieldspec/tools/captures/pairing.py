"""Pairs responses with the requests that they answer."""

from __future__ import annotations

import numpy as np

from fieldspec.foundation.classes import dataclass
from fieldspec.tools.captures.columns import Mask, Numbers, numbers
from fieldspec.tools.captures.payloads import REQUEST, RESPONSE

NONE = -1
MOST_OPEN = 4096
"""The requests without an answer that are remembered for the next batch."""


@dataclass(frozen=True, slots=True)
class Exchanges:
    """What pairing needs to know of frames, one row each, in the order of the capture.

    `repeated` is one number for all that a response repeats from its request, the unit among it; NONE where the link
    has nothing of that. `message` is a place in the messages of the link. `number` is the number of the frame in its
    source. The columns of requests that ask for registers have the `address` and the `count`, others have NONE.
    """

    stream: Numbers
    direction: Numbers
    repeated: Numbers
    unit_address: Numbers
    code: Numbers
    message: Numbers
    number: Numbers
    time: Numbers
    address: Numbers
    count: Numbers

    def rows(self, rows: Numbers | Mask) -> Exchanges:
        """The exchanges in some rows."""
        return Exchanges(*(column[rows] for column in self.columns()))

    def columns(self) -> tuple[Numbers, ...]:
        """All columns in their order."""
        return (
            self.stream, self.direction, self.repeated, self.unit_address, self.code, self.message, self.number,
            self.time, self.address, self.count,
        )  # fmt: skip


NO_EXCHANGES = Exchanges(*(numbers([]) for _ in range(10)))


def joined(left: Exchanges, right: Exchanges) -> Exchanges:
    """The exchanges of both, first `left` and then `right`."""
    return Exchanges(*(np.concatenate(pair) for pair in zip(left.columns(), right.columns(), strict=True)))


def paired(exchanges: Exchanges) -> Numbers:
    """For each response the row of its request; NONE for others, and for a response to none.

    A response answers the frame before it on its line, among those with the same repeated numbers, if that is a request
    to the same unit with the same code. A response without a code answers any, one without a unit those to any, and a
    request without a unit is answered by any unit.
    """
    result = np.full(len(exchanges.stream), NONE)
    if not len(result):
        return result
    order = np.lexsort((np.arange(len(result)), exchanges.repeated, exchanges.stream))
    before, after = order[:-1], order[1:]
    fits = (exchanges.stream[before] == exchanges.stream[after]) & (
        exchanges.repeated[before] == exchanges.repeated[after]
    )
    fits &= (exchanges.direction[before] == REQUEST) & (exchanges.direction[after] == RESPONSE)
    unit, code = exchanges.unit_address, exchanges.code
    fits &= (unit[before] == unit[after]) | (unit[after] == NONE) | (unit[before] == NONE)
    fits &= (code[before] == code[after]) | (code[after] == NONE) | (code[before] == NONE)
    result[after[fits]] = before[fits]
    return result


def still_open(exchanges: Exchanges, requests: Numbers) -> Exchanges:
    """The last requests that may still be answered: for each line and repeated number the last frame, if it is one."""
    if not len(exchanges.stream):
        return exchanges
    order = np.lexsort((np.arange(len(requests)), exchanges.repeated, exchanges.stream))
    stream, repeated = exchanges.stream[order], exchanges.repeated[order]
    last = np.ones(len(order), np.bool_)
    last[:-1] = (stream[1:] != stream[:-1]) | (repeated[1:] != repeated[:-1])
    rows = np.sort(order[last])
    rows = rows[exchanges.direction[rows] == REQUEST]
    return exchanges.rows(rows[-MOST_OPEN:])
