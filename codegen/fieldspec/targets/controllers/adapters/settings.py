"""How the line of a device is set, as its spec says: as it is delivered, with the times that its frames take."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.link import Serial
from fieldspec.language.model.texts import Limit

USUAL_TIMEOUT = 500
"""Milliseconds until an answer begins, where the manual prints none: that of the blocks which exchange messages."""
PAUSE = "next_request_delay"
"""The name of the limit that says how long a line rests before a request."""
_START, _PARITY = 1, 1
_PARITIES = {"none": "N", "even": "E", "odd": "O"}


@dataclass(frozen=True, slots=True)
class Settings:
    """The settings of a serial line. Where a spec lists several, the first one is that of a device as it is delivered.

    `station` is the lowest unit address. Times are in milliseconds: `timeout` until an answer begins, `pause` before a
    request, `longest` of the longest frame, `slowest` of the same at the lowest rate.
    """

    rate: int
    parity: str
    data_bits: int
    stop_bits: int
    station: int
    timeout: int
    pause: int
    longest: int
    slowest: int

    @property
    def frame(self) -> str:
        """The form of a character, as in `8N1`"""
        return f"{self.data_bits}{_PARITIES[self.parity]}{self.stop_bits}"

    @property
    def begun(self) -> int:
        """The time from the begin of a request until the answer begins."""
        return _hundreds(self.longest + self.timeout)

    @property
    def whole(self) -> int:
        """The time from the end of a request until its response is complete."""
        return _hundreds(2 * self.longest + self.timeout)

    @property
    def write_micros(self) -> int:
        """The microseconds in which any request is sent, whatever rate the device is set to."""
        return 1000 * max(USUAL_TIMEOUT, _hundreds(self.slowest))


def _hundreds(milliseconds: int) -> int:
    return -(-milliseconds // 100) * 100


def settings(layout: DeviceLayout, link: LinkLayout, frame_bytes: int) -> Settings | None:
    """The settings of a link; None where its spec does not state them all."""
    serial = link.link.serial
    if serial is None or not (serial.baud and serial.parity and serial.data_bits and serial.stop_bits):
        return None
    rate = serial.default_baud or serial.baud[0]
    character = _START + serial.data_bits[0] + _PARITY + serial.stop_bits[0]
    addresses = link.link.unit_addresses
    known = addresses.ranges.intervals if addresses is not None and addresses.ranges is not None else ()
    return Settings(
        rate,
        serial.parity[0],
        serial.data_bits[0],
        serial.stop_bits[0],
        known[0][0] if known else 0,
        max(_timeouts(layout), default=USUAL_TIMEOUT),
        next((_milliseconds(limit) for limit in layout.device.limits if limit.name == PAUSE), 0),
        frame_bytes * character * 1000 // rate + 1,
        frame_bytes * character * 1000 // min(serial.baud) + 1,
    )


def _timeouts(layout: DeviceLayout) -> Iterator[int]:
    """The limits of the answers that tasks wait for."""
    paths = {step.timeout for task in layout.device.tasks for step in task.steps if step.timeout}
    for limit in layout.device.limits:
        if f"limits/{limit.name}" in paths and limit.unit == "ms":
            yield _milliseconds(limit)


def _milliseconds(limit: Limit) -> int:
    number = limit.most if limit.most is not None else limit.low
    return int(number or 0) if limit.unit == "ms" else 0


def lines(link: LinkLayout, line: Settings) -> Iterator[str]:
    """The comment on the settings: the settings of the program, alternatives of the device, notes of the spec."""
    serial = link.link.serial
    assert serial is not None
    yield f"Settings of {link.link.title or link.link.name}: {line.rate} bps, {line.frame}, station {line.station}."
    yield from _choices(serial)
    yield f"An answer begins within {line.timeout} ms; the line rests {line.pause} ms before a request."
    yield from link.link.notes


def _choices(serial: Serial) -> Iterator[str]:
    """The settings of which the device has several."""
    for name, values in (
        ("bps", serial.baud),
        ("parity", serial.parity),
        ("data bits", serial.data_bits),
        ("stop bits", serial.stop_bits),
    ):
        if len(values) > 1:
            yield f"The device may be set to {name} {', '.join(map(str, values))}: set the controller alike."
