"""Faults of a device and its line, by a script, by a command, or by chance with a seed."""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping

from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.codec.reference.records import CodecError
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass

if TYPE_CHECKING:
    from typing import Any

    from fieldspec.codec.layout.part import PartLayout
    from fieldspec.tools.simulator.server import Server

KINDS: Mapping[str, str] = {
    "no_answer": "the device does not answer",
    "late_answer": "the answer comes `seconds` too late",
    "wrong_unit": "another unit answers",
    "wrong_checksum": "the checksum is wrong",
    "truncated": "the end of the answer is missing",
    "garbage": "garbage comes before the answer",
    "exception": "the request is refused, for the `reason`",
    "busy": "the request is refused because the device is busy",
    "stuck_bit": "the `signal` keeps the `value`, from now on",
    "out_of_range": "the `signal` has the `value`, which is beyond its range, from now on",
    "inserted_word": "a word is inserted in the middle of the data",
    "connection_lost": "the connection is closed",
    "power_cycle": "the device loses its power and comes back",
}
"""The kinds of faults, and what each does."""

_LASTING = ("stuck_bit", "out_of_range")
_KEYS = {"fault", "at", "request", "count", "seconds", "reason", "signal", "value", "probability"}


class FaultError(ValueError):
    """A fault that cannot be: the message says why."""


@dataclass(frozen=True, slots=True)
class Fault:
    """A fault. It strikes at the time `at`, at the request with the number `request`, or with a probability.

    It strikes `count` times; 0 is without end.
    """

    kind: str
    at: float | None = None
    request: int | None = None
    probability: float = 0.0
    count: int = 1
    seconds: float = 1.0
    reason: str = "device_failure"
    signal: str = ""
    value: int = 0

    def refusal(self, server: Server) -> str:
        """The reason for which a request is refused under this fault; empty if it is not."""
        if self.kind == "exception":
            return self.reason
        return "busy" if self.kind == "busy" else ""


def fault_of(data: Mapping[str, Any]) -> Fault:
    """The fault that a script or a command describes. Raises FaultError."""
    unknown = sorted(set(data) - _KEYS)
    if unknown:
        raise FaultError(f"a fault has no `{unknown[0]}`; it has {', '.join(sorted(_KEYS))}")
    kind = data.get("fault")
    if kind not in KINDS:
        raise FaultError(f"there is no fault `{kind}`; choose from {', '.join(KINDS)}")
    if kind in _LASTING and not isinstance(data.get("signal"), str):
        raise FaultError(f"the fault {kind} needs a `signal`")
    numbers = {key: data[key] for key in ("at", "request", "count", "seconds", "value", "probability") if key in data}
    for key, number in numbers.items():
        if isinstance(number, bool) or not isinstance(number, int | float):
            raise FaultError(f"`{key}` of the fault {kind} is {spec_text(number)}, which is not a number")
    if not 0 <= numbers.get("probability", 0) <= 1:
        raise FaultError(f"the probability of the fault {kind} is {numbers['probability']}, not 0 to 1")
    by_chance = "probability" in numbers
    return Fault(
        str(kind),
        at=numbers.get("at"),
        request=numbers.get("request"),
        probability=float(numbers.get("probability", 0)),
        count=int(numbers.get("count", 0 if by_chance else 1)),
        seconds=float(numbers.get("seconds", 1.0)),
        reason=str(data.get("reason", "device_failure")),
        signal=str(data.get("signal", "")),
        value=int(numbers.get("value", 0)),
    )


class Faults:
    """The faults that wait to strike, and the chance of others."""

    def __init__(self, faults: Iterable[Fault] = (), seed: int = 0) -> None:
        self.waiting: list[tuple[Fault, int]] = [(fault, fault.count) for fault in faults]
        self.chance = random.Random(seed)
        self.requests = 0
        self.struck: dict[str, int] = {}

    def add(self, fault: Fault) -> None:
        """Adds a fault that strikes at the next request where it does not say when."""
        self.waiting.append((fault, fault.count))

    def clear(self) -> None:
        """Removes all faults."""
        self.waiting.clear()

    def next(self, now: float) -> Fault | None:
        """The fault that strikes at the request that has just come; None if none does."""
        self.requests += 1
        for number, (fault, left) in enumerate(self.waiting):
            if fault.at is not None and now < fault.at:
                continue
            if fault.request is not None and self.requests < fault.request:
                continue
            if fault.probability and self.chance.random() >= fault.probability:
                continue
            if left == 1:
                del self.waiting[number]
            elif left > 1:
                self.waiting[number] = (fault, left - 1)
            self.struck[fault.kind] = self.struck.get(fault.kind, 0) + 1
            return fault
        return None

    def damaged(self, fault: Fault, server: Server, link: str, frame: bytes) -> tuple[bytes, float]:
        """The bytes that are sent instead of an answer, and by how many seconds they are late."""
        kind = fault.kind
        if kind == "no_answer":
            return b"", 0.0
        if kind == "late_answer":
            return frame, fault.seconds
        if kind == "truncated":
            return frame[: self.chance.randrange(len(frame))], 0.0
        if kind == "garbage":
            return bytes(self.chance.randrange(256) for _ in range(self.chance.randrange(1, 9))) + frame, 0.0
        if kind in ("wrong_checksum", "wrong_unit", "inserted_word"):
            return self._altered(kind, server, link, frame), 0.0
        return frame, 0.0

    def _altered(self, kind: str, server: Server, link: str, frame: bytes) -> bytes:
        """A frame with other parts. A frame without the part that would change is sent as it is."""
        frames = server.codecs[link]
        shape = frames.link.response
        try:
            parts = bytearray(frames.original_parts(frame, "response"))
        except CodecError:
            return frame
        if kind == "wrong_checksum" and shape.checksum is not None:
            parts[shape.checksum.at(len(parts))] ^= 0x55
            return frames.joined_parts("response", bytes(parts))
        addressed = shape.role("unit_address")
        if kind == "wrong_unit" and addressed is not None:
            offset = addressed.at(len(parts))
            place = slice(offset, offset + addressed.size)
            parts[place] = addressed.bytes_with(bytes(parts[place]), _another_number(addressed, bytes(parts)))
        if kind == "inserted_word":
            middle = shape.header_size + (len(parts) - shape.header_size - shape.trailer_size) // 2
            parts[middle:middle] = self.chance.randrange(0x10000).to_bytes(2, "big")
        return frames.joined_parts("response", frames.with_checksum("response", bytes(parts)))


def _another_number(part: PartLayout, parts: bytes) -> int:
    """The next number of a part, or 0 after its last one."""
    number = part.read(parts[part.offset : part.offset + part.size])
    assert number is not None
    assert part.value is not None
    return (number + 1) % (part.value.high + 1)


def hold(server: Server, fault: Fault) -> None:
    """Makes a lasting fault act. Raises FaultError for a signal that the device does not have."""
    if fault.kind in _LASTING:
        if not server.engine.cells.of(fault.signal):
            raise FaultError(server.engine.cells.names.unknown(fault.signal))
        server.engine.overridden[fault.signal] = fault.value


def is_lasting(fault: Fault) -> bool:
    """Whether a fault acts from its beginning on, and not at one request."""
    return fault.kind in _LASTING
