"""A TC100 by its manual: registers of status, of motion, of simulated inputs, and the points.

The manual says little about time and order. What it leaves open is drawn, each under a name of its own:

- "busy command": a motion command while it moves is refused with fault 1 [8.2 L1515], or takes the motion's place.
- "refusal": a refused command has a normal answer and a fault in 100DH [8.2 L1515], or exception 03 [8.3 L1776] too.
- "fault": the next accepted command clears 100DH, or only a reset of alarms does [8.2 L1515 lists values and no end].
- "in position": 1001H compares the target with the position, or the commanded with the actual one [5.1 L1161], or is
  always 1, as the manual warns [5.1 L1161, 6.4 L1362].
- "moving": 1000H is 1 from the acceptance on, or from the begin of the motion on [8.2 L1506].
- "stopped": 1000H is 0 or 2 after a stop from outside [8.2 L1506].
- "homing": parameter 051BH demands a home before a move, or does not [5.3 L1186].
- "servo": parameter 0515H has the servo on after power-on, or off [5.3 L1185].
- "outside": what stops it from outside is the interlock, which is fault 9 [10.3 L3045], or the vendor's software.
- "soft limit": a target beyond it is refused, or the axis stops there with fault 10 [10.3 L3046].
"""

from __future__ import annotations

import struct

from device_models.draws import Draws
from device_models.frames import with_crc
from device_models.modbus import ADDRESS, VALUE, ModbusDevice, RefusedError, high, low, number_of

BUSY, LIMIT, SERVO_FAULT, LOCKED, SOFT_LIMIT, UNHOMED = 1, 2, 8, 9, 10, 12
"""Values of ErrorStatus, 100DH [8.2 L1515]."""
RELATIVE, ABSOLUTE, HOME, RESET, STOP, EMERGENCY_STOP, JOG_POSITIVE, JOG_NEGATIVE = 0, 1, 3, 6, 8, 9, 11, 12
"""Values of MovType, 201EH [8.2 L1624]."""
POINTS, POINT_WORDS = 0x9010, 0x10
"""Where the first point is, and how far the next one [8.2 L1648-1661]."""
IN_ORIGIN, IN_SERVO, IN_RESET, IN_START, IN_LOCK = 0, 1, 2, 3, 11
"""Bits of the simulated inputs, 2040H [6.2 L1300-1313]."""
TOP_SPEED = 20000.0
"""0802H, in counts a second."""


class Tc100(ModbusDevice):
    """A TC100 on Modbus RTU. `LIMIT_COUNTS` is the soft limit on both ends."""

    LIMIT_COUNTS = 100000

    def __init__(self, draws: Draws) -> None:
        super().__init__(draws)
        self.distance = self.target = 0
        self.speed = self.inputs = self.fault = self.last_point = self.abnormal = 0
        self.cause = 0
        self.locked = False
        self.points: dict[int, dict[int, int]] = {}
        self.last_point = 0xFFFF
        self.servo = self.draws.reading("servo", "on", "off") == "on"

    @property
    def homing_needed(self) -> bool:
        return self.draws.reading("homing", "needed", "needed", "not needed") == "needed"

    def read(self, address: int) -> int:
        axis = self.axis
        if 0x9010 <= address < 0x9010 + 127 * POINT_WORDS:
            return self._point(address)
        if 0x2041 <= address <= 0x204E:
            return self.inputs >> address - 0x2041 & 1
        if 0x1021 <= address <= 0x102A:
            return self._outputs() >> address - 0x1021 & 1
        values = {
            0x1000: self._action,
            0x1001: self._in_position,
            0x1004: lambda: 0,
            0x1005: lambda: self.alarm,
            0x1006: lambda: round(axis.velocity / 10),
            0x1007: lambda: 36,
            0x1008: lambda: high(axis.position),
            0x1009: lambda: low(axis.position),
            0x100A: lambda: high(axis.position),
            0x100B: lambda: low(axis.position),
            0x100C: lambda: int(self.servo),
            0x100D: lambda: self.fault,
            0x100E: lambda: self.last_point,
            0x1020: self._outputs,
            0x1040: lambda: self.inputs,
            0x2000: lambda: high(self.distance),
            0x2001: lambda: low(self.distance),
            0x2002: lambda: high(self.target),
            0x2003: lambda: low(self.target),
            0x2011: lambda: int(not self.servo),
            0x2014: lambda: self.speed,
            0x2040: lambda: self.inputs,
        }
        if address not in values:
            raise RefusedError(ADDRESS)
        return values[address]()

    def write(self, address: int, words: list[int]) -> None:
        if address == 0x2000 and len(words) == 2:
            self.distance = number_of(words)
        elif address == 0x2002 and len(words) == 2:
            self.target = number_of(words)
        elif address == 0x2011 and len(words) == 1:
            self._switch(words[0])
        elif address == 0x2014 and len(words) == 1:
            if words[0] > 100:
                raise RefusedError(VALUE)
            self.speed = words[0]
        elif address == 0x201E and len(words) == 1:
            self._command(words[0])
        elif address == 0x2040 and len(words) == 1:
            self._set_inputs(words[0])
        elif 0x2041 <= address <= 0x204E and len(words) == 1:
            bit = 1 << address - 0x2041
            self._set_inputs(self.inputs | bit if words[0] else self.inputs & ~bit)
        elif POINTS <= address < POINTS + 127 * POINT_WORDS:
            for index, word in enumerate(words):
                number, offset = divmod(address + index - POINTS, POINT_WORDS)
                self.points.setdefault(number + 1, {})[offset] = word
        elif address not in (0x9999, 0x999B):
            raise RefusedError(ADDRESS)

    def set_alarm(self, number: int) -> None:
        """An alarm takes the servo off [6.3 L1337, 6.4 L1367] and is an abnormal stop [8.2 L1506]."""
        self.cause = number
        if not number:
            self.axis.record("cause gone", "alarm")
        else:
            self.alarm, self.servo, self.abnormal = number, False, 1
            self.axis.record("alarm", f"{number}")
            self.axis.cut()

    def power_cycle(self) -> None:
        self.axis.cut()
        self.axis.homed = False
        self.alarm = self.cause
        self.servo = not self.alarm and self.draws.reading("servo", "on", "off") == "on"
        self.inputs = self.fault = self.abnormal = 0
        self.locked = False
        self.last_point = 0xFFFF

    def pass_time(self, seconds: float) -> None:
        super().pass_time(seconds)
        if abs(self.axis.position) > self.LIMIT_COUNTS:
            self.axis.position = self.LIMIT_COUNTS if self.axis.position > 0 else -self.LIMIT_COUNTS
            self.fault, self.abnormal = SOFT_LIMIT, 1
            self.axis.cut()

    def stop_outside(self, visible: bool = False) -> None:
        if self.axis.moving:
            if self.locked or self.draws.reading("outside", "interlock", "software") == "interlock":
                self.fault, visible = LOCKED, True
            self.abnormal = int(self.draws.reading("stopped", "0", "2") == "2")
        super().stop_outside(visible or bool(self.abnormal))

    def _action(self) -> int:
        accepted = self.draws.reading("moving", "from acceptance", "from begin") == "from acceptance"
        if self.axis.moving or (accepted and self.axis.waiting):
            return 1
        return 2 if self.abnormal else 0

    def _in_position(self) -> int:
        reading = self.draws.reading("in position", "target", "target", "lag", "always")
        motion = self.axis.motion
        if reading == "always" or motion is None:
            return 1
        if reading == "lag":
            return int(abs(self.axis.velocity) < 1000)
        return int(motion.target is not None and abs(motion.target - self.axis.position) < 80)

    def _outputs(self) -> int:
        """OUT 1 is ORG-S, OUT 2 INP, OUT 3 READY, OUT 4 SERVO-S [6.2 L1314-1317]."""
        ready = self.servo and not self.axis.expected and not self.alarm
        return int(self.axis.homed) | self._in_position() << 1 | ready << 2 | self.servo << 3

    def _switch(self, off: int) -> None:
        """0 is servo ON, 1 servo OFF [8.2 L1622]. In an alarm the servo stays off [6.3 L1337]."""
        if off > 1:
            raise RefusedError(VALUE)
        if off:
            self.servo = False
            self.axis.record("stop", "servo off")
            self.axis.cut()
        elif self.alarm:
            self.fault = SERVO_FAULT
        else:
            self.servo = True

    def _command(self, command: int) -> None:
        if command > 12 or command in (5, 10):
            raise RefusedError(VALUE)
        if command in (STOP, EMERGENCY_STOP):
            self.axis.stop(*([160000.0] if command == EMERGENCY_STOP else []))
        elif command == RESET:
            self._reset()
        elif command == RELATIVE:
            self._start("relative", self.distance, None, self._speed())
        elif command == ABSOLUTE:
            self._start("absolute", self.target, self.target, self._speed())
        elif command == HOME:
            self._start("home", 0, None, 4000.0)
        elif command in (JOG_POSITIVE, JOG_NEGATIVE):
            kind, sign = ("jog_forward", 1) if command == JOG_POSITIVE else ("jog_backward", -1)
            self._start(kind, sign, None, sign * self._speed())

    def _speed(self, percent: int | None = None) -> float:
        """A part of the highest speed; 0 is the start speed [8.2 L1623]."""
        percent = self.speed if percent is None else percent
        return TOP_SPEED * percent / 100 if percent else 500.0

    def _start(self, kind: str, value: float, target: float | None, speed: float) -> None:
        fault = self._reason(kind, target, value)
        if fault:
            self.fault = fault
            self.axis.record("refused", kind, value)
            if self.draws.reading("refusal", "fault", "exception") == "exception":
                raise RefusedError(VALUE)
            return
        if self.draws.reading("fault", "cleared", "cleared", "cleared", "stays") == "cleared":
            self.fault = 0
        self.abnormal = 0
        self.axis.accept(kind, value, target, speed)

    @staticmethod
    def meaning(frame: bytes) -> str:
        """What a request asks for: a start, a stop, or something else."""
        if frame[1] == 3:
            return "read"
        address, word = struct.unpack(">HH", frame[2:6])
        names = {0: "relative", 1: "absolute", 3: "home", 11: "jog_forward", 12: "jog_backward"}
        if frame[1] == 6 and address == 0x201E:
            return f"start {names[word]}" if word in names else "stop" if word in (8, 9) else "write"
        if frame[1] == 6 and address == 0x2040 and word >> IN_START & 1:
            return "start point"
        return "off" if frame[1] == 6 and address == 0x2011 and word else "write"

    def _reason(self, kind: str, target: float | None, value: float) -> int:
        """Why a start is refused: a value of ErrorStatus, or 0."""
        if not self.servo or self.alarm:
            return SERVO_FAULT
        if self.locked:
            return LOCKED
        if self.homing_needed and not self.axis.homed and kind != "home":
            return UNHOMED
        if self.axis.expected and self.draws.reading("busy command", "refused", "taken") == "refused":
            return BUSY
        end = self.axis.position + value if kind == "relative" else target
        beyond = end is not None and abs(end) > self.LIMIT_COUNTS
        if beyond and self.draws.reading("soft limit", "refused", "stops there") == "refused":
            return SOFT_LIMIT
        return LIMIT if self.draws.refuses() else 0

    def _reset(self) -> None:
        """With the servo on it is fault 8 [10.3 L3044]."""
        if self.servo:
            self.fault = SERVO_FAULT
        elif not self.cause:
            self.alarm = self.fault = 0

    def _set_inputs(self, word: int) -> None:
        risen = word & ~self.inputs
        self.inputs = word
        self.locked = bool(word >> IN_LOCK & 1)
        if risen >> IN_LOCK & 1:
            self.stop_outside()
        if risen >> IN_SERVO & 1:
            self._switch(1)
        if risen >> IN_RESET & 1:
            self._reset()
        if risen >> IN_ORIGIN & 1:
            self._start("home", 0, None, 4000.0)
        if risen >> IN_START & 1:
            self._run(word >> 4 & 0x7F)

    def _run(self, number: int) -> None:
        """Carries out a point [6.3 L1339-1340]; mode 0 is relative, 1 absolute, 2 homing [8.2 L1648]."""
        mode = self._point_word(number, 0)
        position = number_of([self._point_word(number, 1), self._point_word(number, 2)])
        self.last_point = number
        if mode == 2:
            self._start("home", 0, None, 4000.0)
        else:
            target = position if mode else self.axis.position + position
            self._start("point", number, target, self._speed(self._point_word(number, 3)))

    def _point(self, address: int) -> int:
        number, offset = divmod(address - POINTS, POINT_WORDS)
        return self._point_word(number + 1, offset)

    def _point_word(self, number: int, offset: int) -> int:
        """A word of a point; a fresh one moves to a place of its own, so that a test can tell the points apart."""
        fresh = {0: 1, 2: 100 * number, 3: 50, 10: 300, 11: 300, 13: 0xFFFF}
        return self.points.get(number, {}).get(offset, fresh.get(offset, 0))


class AsciiTc100(Tc100):
    """A TC100 as delivered, on Modbus ASCII: the same bytes as digits, with an LRC instead of the CRC [8.4 L1730]."""

    def answer(self, frame: bytes) -> bytes | None:
        """What the device answers to a frame; None where it stays silent."""
        sent = _rtu(frame)
        return None if sent is None else _ascii(super().answer(sent))

    def meaning(self, frame: bytes) -> str:
        """What a request asks for, in words."""
        return super().meaning(_rtu(frame) or b"")

    @classmethod
    def foreign(cls, answer: bytes) -> bytes:
        """The same answer by another station, with other data."""
        return _ascii(super().foreign(_rtu(answer) or b"")) or b""

    @staticmethod
    def alike(first: bytes, second: bytes) -> bool:
        """Whether two answers may be for the same request."""
        return ModbusDevice.alike(_rtu(first) or b"", _rtu(second) or b"")


def _ascii(frame: bytes | None) -> bytes | None:
    """A frame of RTU as ASCII: the LRC makes the sum of all bytes zero [8.3 L1744-1746]."""
    if frame is None:
        return None
    body = frame[:-2]
    return b":" + (body + bytes([-sum(body) & 0xFF])).hex().upper().encode() + b"\r\n"


def _rtu(frame: bytes) -> bytes | None:
    """A frame of ASCII as RTU; None where a mark or the LRC is wrong."""
    digits = frame[1:-2]
    if frame[:1] != b":" or frame[-2:] != b"\r\n" or len(digits) % 2 or not set(digits) <= set(b"0123456789ABCDEF"):
        return None
    body = bytes.fromhex(digits.decode())
    return None if not body or sum(body) & 0xFF else with_crc(body[:-1])
