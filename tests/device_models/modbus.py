"""A device with registers behind Modbus RTU: frames in, answers out. What registers mean is left to each device."""

from __future__ import annotations

import struct

from device_models.axis import Axis, Event, State
from device_models.draws import Draws
from device_models.frames import crc, with_crc

FUNCTION, ADDRESS, VALUE, FAILURE = 1, 2, 3, 4
"""The codes of exceptions [tc100 8.3 L1774-1776, ck10 1.4 L236-239]."""
READ, WRITE, WRITE_SEVERAL = 3, 6, 0x10


class RefusedError(Exception):
    """The device answers with an exception."""

    def __init__(self, code: int) -> None:
        super().__init__(code)
        self.code = code


class ModbusDevice:
    """Registers behind a station, and an axis.

    A subclass has `read` of a register and `write` of words, which may raise RefusedError, and `state`.
    """

    STATION = 1
    MOST_WORDS = 60
    latency = (0.002, 0.02)

    def __init__(self, draws: Draws) -> None:
        self.draws = draws
        self.axis = Axis(draws)
        self.alarm = 0
        self.servo = False

    def answer(self, frame: bytes) -> bytes | None:
        """What the device answers to a frame; None where it stays silent."""
        if len(frame) < 4 or frame[0] not in (0, self.STATION) or crc(frame[:-2]) != frame[-2:]:
            return None
        try:
            body = self._answered(frame[1], frame[2:-2])
        except RefusedError as error:
            body = bytes([frame[1] | 0x80, error.code])
        return with_crc(bytes([self.STATION]) + body) if frame[0] else None

    @classmethod
    def foreign(cls, answer: bytes) -> bytes:
        """The same answer by another station, with other data."""
        body = bytes([7, answer[1]])
        body += bytes([answer[2], *(byte ^ 0x55 for byte in answer[3:-2])]) if answer[1] == READ else answer[2:-2]
        return with_crc(body)

    @staticmethod
    def alike(first: bytes, second: bytes) -> bool:
        """Whether two answers may be for the same request: a read repeats its count alone, a write its address too."""
        return len(first) == len(second) and first[1] == second[1] and (first[1] == READ or first[2:6] == second[2:6])

    def _answered(self, function: int, body: bytes) -> bytes:
        if function not in (READ, WRITE, WRITE_SEVERAL):
            raise RefusedError(FUNCTION)
        if len(body) < 4:
            raise RefusedError(VALUE)
        address, count = struct.unpack(">HH", body[:4])
        if function == READ:
            if not 1 <= count <= self.MOST_WORDS:
                raise RefusedError(VALUE)
            words = [self.read(address + index) & 0xFFFF for index in range(count)]
            return struct.pack(f">BB{count}H", function, 2 * count, *words)
        if function == WRITE:
            self.write(address, [count])
        else:
            if len(body) != 5 + 2 * count or body[4] != 2 * count or not 1 <= count <= self.MOST_WORDS:
                raise RefusedError(VALUE)
            self.write(address, list(struct.unpack(f">{count}H", body[5:])))
        return bytes([function]) + body[:4]

    def read(self, address: int) -> int:
        """The word of a register."""
        raise NotImplementedError

    def write(self, address: int, words: list[int]) -> None:
        """Takes words."""
        raise NotImplementedError

    def pass_time(self, seconds: float) -> None:
        """Some time goes by."""
        self.axis.pass_time(seconds)

    @property
    def homing_needed(self) -> bool:
        """Whether an axis without a home refuses to move."""
        raise NotImplementedError

    @property
    def state(self) -> State:
        """What is true of the axis now."""
        return self.axis.state(self.servo, bool(self.alarm))

    @property
    def events(self) -> list[Event]:
        """What has happened."""
        return self.axis.events

    def set_alarm(self, number: int) -> None:
        """It has an alarm, which stops it and takes the servo off; 0 when what caused it is gone."""
        raise NotImplementedError

    def power_cycle(self) -> None:
        """It is switched off and on."""
        raise NotImplementedError

    def stop_outside(self, visible: bool = False) -> None:
        """Somebody stops it: a pendant, or the input of an interlock; `visible` says whether the registers tell."""
        self.axis.stop(outside=True, visible=visible)

    def move_outside(self) -> None:
        """Somebody moves it by hand at the pendant for a moment, if nothing else does."""
        if self.servo and not self.alarm and not self.axis.expected:
            self.axis.accept("outside", 0.0, self.axis.position + 200.0, 2000.0, outside=True)


def high(value: float) -> int:
    """The high word of a number of 32 bits."""
    return round(value) >> 16 & 0xFFFF


def low(value: float) -> int:
    """The low word of a number of 32 bits."""
    return round(value) & 0xFFFF


def number_of(words: list[int]) -> int:
    """A signed number of 32 bits, the high word first [tc100 8.4 L1953-1961, ck10 1.2 L86]."""
    value: int = struct.unpack(">i", struct.pack(">HH", *words))[0]
    return value
