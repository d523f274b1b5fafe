"""An ESC11 by its manual: packets, the byte of status in each answer, homing, moves, excitation, alarms.

What is left open is drawn:

- "executing": bit 0 is 1 from the acceptance on, as in the answers of 9.1 [L309, L317], or from the begin of motion on.
- "range": bit 1 says whether the axis is at its target, or is always 1, as in most answers of the manual [9.3 L745].
- "refusal": a command that is refused sets bit 5, bit 6, or leaves its number in 47H alone [8.2 L291-293, 10.4].
- "number": the number of an error stays until a reset, or until the next command is accepted [9.3.8].
- "busy command": refused as error 27H [10.4 L1320], or taken in place of the motion.
- "excitation": on after power-on, or off [9.2.2 does not say].
- "homing": a move needs a home, as error 23H says [10.4 L1316]; this is not a choice.
"""

from __future__ import annotations

import struct

from device_models.axis import Axis, Event, State
from device_models.draws import Draws
from device_models.frames import packet

EXECUTING, OUT_OF_RANGE, UNEXCITED, COMMAND_ERROR, ALARM, COMMUNICATION = 1, 2, 4, 0x20, 0x40, 0x80
"""Bits of the byte of status [8.2 L286-293]."""
SOFT_LIMIT, NOT_HOMED, SERVO_OFF, INTERLOCKED, NO_POINT, RUNNING = 0x20, 0x23, 0x24, 0x25, 0x26, 0x27
NO_COMMAND, DATA = 0x31, 0x32
"""Numbers of errors [10.4 L1313-1326]."""
STOP, HOME, MOVE_OPEN, MOVE_CLOSE, RELATIVE, ABSOLUTE, POINT = 0x10, 0x11, 0x14, 0x15, 0x16, 0x17, 0x1A
GRIP_CLOSE = 0x21
NO_OPERATION, EXCITE, RESET = 0x30, 0x31, 0x4E
SIZES = {STOP: 0, HOME: 0, 0x12: 3, 0x13: 3, MOVE_OPEN: 1, MOVE_CLOSE: 1, RELATIVE: 5, ABSOLUTE: 5, POINT: 2}
SIZES |= {0x20: 2, 0x21: 2, 0x22: 6, 0x23: 6, 0x24: 10, 0x25: 10, NO_OPERATION: 0, EXCITE: 1, RESET: 0}
SIZES |= {0x40: 0, 0x41: 0, 0x42: 0, 0x43: 1, 0x45: 0, 0x46: 0, 0x47: 0, 0x48: 0, 0x52: 0}
"""How many bytes of data each command has [10.1]."""
TOP_SPEED = 5000.0
END = 10000
"""The soft limits, in 0.01 mm, are -END..END."""


class Esc11:
    """An ESC11 on RS485."""

    STATION = 1
    latency = (0.2, 0.4)
    """It answers within 200 to 400 ms [7.2 L239]; nothing within 600 ms is an error [7.3 L247]."""

    def __init__(self, draws: Draws) -> None:
        self.draws, self.axis = draws, Axis(draws)
        self.number = self.cause = self.point = 0
        self.alarm = 0
        self.command_error = False
        self.target = 0.0
        self.servo = draws.reading("excitation", "on", "off") == "on"

    homing_needed = True

    @property
    def events(self) -> list[Event]:
        """What has happened."""
        return self.axis.events

    @property
    def state(self) -> State:
        """What is true of the axis now."""
        return self.axis.state(self.servo, bool(self.alarm))

    @property
    def status(self) -> int:
        """The byte that each answer carries."""
        axis = self.axis
        accepted = self.draws.reading("executing", "from acceptance", "from begin") == "from acceptance"
        status = EXECUTING * (axis.moving or (accepted and axis.waiting is not None))
        away = axis.motion is not None or abs(self.target - axis.position) > 5
        status |= OUT_OF_RANGE * (away if self.draws.reading("range", "target", "always 1") == "target" else True)
        status |= UNEXCITED * (not self.servo) | COMMAND_ERROR * self.command_error
        return status | ALARM * bool(self.alarm)

    def answer(self, frame: bytes) -> bytes | None:
        """What it answers to a packet; damaged ones and those of others it does not answer [7.3 L250]."""
        if len(frame) < 4 or frame[0] != len(frame) or frame[1] != self.STATION or sum(frame[:-1]) & 0xFF != frame[-1]:
            return None
        code, data = frame[2], frame[3:-1]
        self.command_error = False
        if SIZES.get(code) != len(data):
            self._refuse(NO_COMMAND, f"{code:02X}H", known=False)
            answer = b""
        else:
            answer = self._obey(code, data)
        return packet(bytes([self.STATION, self.status]) + answer)

    @staticmethod
    def meaning(frame: bytes) -> str:
        """What a request asks for: a start, a stop, or something else."""
        code = frame[2]
        if code == EXCITE and not frame[3]:
            return "off"
        names = {HOME: "home", MOVE_OPEN: "jog_forward", MOVE_CLOSE: "jog_backward", RELATIVE: "relative"}
        names |= {ABSOLUTE: "absolute", POINT: "point"}
        if code in names:
            return f"start {names[code]}"
        return "stop" if code == STOP else "read" if 0x40 <= code < RESET else "write"

    @classmethod
    def foreign(cls, answer: bytes) -> bytes:
        """The same answer by another station, with other data."""
        return packet(bytes([7, answer[2] & ~EXECUTING]) + bytes(byte ^ 0x55 for byte in answer[3:-1]))

    @staticmethod
    def alike(first: bytes, second: bytes) -> bool:
        """Whether two answers may be for the same request: they repeat nothing of it [8.2 L272]."""
        return len(first) == len(second)

    def pass_time(self, seconds: float) -> None:
        """Some time goes by."""
        self.axis.pass_time(seconds)

    def set_alarm(self, number: int) -> None:
        """It has an alarm, which stops it; 0 when what caused it is gone."""
        self.cause = number
        if not number:
            self.axis.record("cause gone", "alarm")
        else:
            self.alarm = self.number = number
            if self.draws.reading("alarm", "servo off", "servo stays") == "servo off":
                self.servo = False
            self.axis.record("alarm", f"{number}")
            self.axis.cut()

    def power_cycle(self) -> None:
        """It is switched off and on."""
        self.axis.cut()
        self.axis.homed = False
        self.alarm = self.number = self.cause
        self.servo = not self.alarm and self.draws.reading("excitation", "on", "off") == "on"
        self.command_error = False

    def stop_outside(self) -> None:
        """The interlock stops it."""
        self.axis.stop(outside=True)

    def move_outside(self) -> None:
        """Somebody moves it for a moment, if nothing else does."""
        if self.servo and not self.alarm and not self.axis.expected:
            place = self.axis.position + (200.0 if self.axis.position < 0 else -200.0)
            self.axis.accept("outside", 0.0, place, 1000.0, outside=True)

    def _obey(self, code: int, data: bytes) -> bytes:
        if code == STOP:
            self.axis.stop()
        elif code == HOME:
            self._start("home", 0, None, 1000.0)
        elif code in (MOVE_OPEN, MOVE_CLOSE):
            kind, end = ("jog_forward", END) if code == MOVE_OPEN else ("jog_backward", -END)
            self._start(kind, end, end, self._speed(data[0]))
        elif code == GRIP_CLOSE:
            self._start("grip", -END, -END, self._speed(data[0]))
        elif code in (RELATIVE, ABSOLUTE):
            place, percent = struct.unpack("<iB", data)
            target = place if code == ABSOLUTE else self.axis.position + place
            self._start("absolute" if code == ABSOLUTE else "relative", place, target, self._speed(percent))
        elif code == POINT:
            self.point = data[0]
            self._start("point", data[0], 10.0 * data[0], self._speed(data[1]))
        elif code == EXCITE:
            self._excite(bool(data[0]))
        elif code == RESET and not self.cause:
            self.alarm = self.number = 0
        return self._read(code)

    def _read(self, code: int) -> bytes:
        """The data of an answer [9.3 L738-866]."""
        return {
            0x40: b" 1.17 ",
            0x41: struct.pack("<i", round(self.axis.position)),
            0x42: bytes([self.point]),
            0x43: bytes(2),
            0x45: bytes([self.axis.homed]),
            0x46: bytes([self.servo]),
            0x47: bytes([self.number]),
            0x48: bytes(3),
            0x52: bytes([0, self.axis.homed << 5, self.servo | self.axis.expected << 1]),
        }.get(code, b"")

    def _excite(self, on: bool) -> None:
        if not on:
            self.axis.record("stop", "servo off")
            self.axis.cut()
            self.servo = False
        elif not self.alarm:
            self.servo = True

    @staticmethod
    def _speed(percent: int) -> float:
        """The start speed at 0 percent; the manual names none for 0, which 10.1 permits [10.1 L1165]."""
        return TOP_SPEED * min(percent, 100) / 100 if percent else 100.0

    def _start(self, kind: str, value: float, target: float | None, speed: float) -> None:
        number = self._reason(kind, target)
        if number:
            self._refuse(number, kind, value)
            return
        if self.draws.reading("number", "until reset", "until accepted") == "until accepted" and not self.alarm:
            self.number = 0
        if target is not None:
            self.target = target
        self.axis.accept(kind, value, target, speed)

    def _reason(self, kind: str, target: float | None) -> int:
        if not self.servo:
            return SERVO_OFF
        if self.alarm:
            return INTERLOCKED
        if not self.axis.homed and kind != "home":
            return NOT_HOMED
        if self.axis.expected and self.draws.reading("busy command", "refused", "taken") == "refused":
            return RUNNING
        if target is not None and abs(target) > END:
            return SOFT_LIMIT
        return INTERLOCKED if self.draws.refuses() else 0

    def _refuse(self, number: int, about: str, value: float = 0.0, known: bool = True) -> None:
        self.axis.record("refused", about, value)
        self.number = self.number or number
        reading = self.draws.reading("refusal", "command error", "alarm", "number alone")
        if reading == "command error" or not known:
            self.command_error = True
        elif reading == "alarm":
            self.alarm = self.alarm or number
