"""Functions and commands: a request and its response."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.fact import Fact
from fieldspec.model.handling import Handling
from fieldspec.model.record import Record


@dataclass(frozen=True, slots=True)
class RegisterAccess:
    """That a message reads or writes registers, and which fields hold the address, the number and the words.

    `count` is empty where it is always one word. `space` is empty where the spec names none, which means the first
    one of the device.
    """

    operation: str
    start: str
    count: str
    values: str
    space: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Message(Fact):
    """A code, the data of its request and of its response.

    A message without a code may have a `number` by which people know it. It is sent on `links`, which are all
    of the device's where they are empty, and never without one of those that it `supplements`. The lengths are
    the frame's in bytes, and the words those of the data, as printed.
    """

    title: str
    group: str
    code: int | None
    number: int | None
    links: tuple[str, ...]
    supplements: tuple[str, ...]
    request: Record
    response: Record
    request_length: int | None
    response_length: int | None
    request_words: int | None
    response_words: int | None
    broadcast: bool
    handling: Handling
    accesses: RegisterAccess | None
