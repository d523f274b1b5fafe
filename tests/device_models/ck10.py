"""A CK10 by its manual, as far as its tasks go: status, motion control, the points and their store.

What is left open is drawn: "busy command", "start refusal" (exception 04 [1.4 L239], or a normal answer and nothing),
"moving" and "in position" (flags of 3E8H as they are at acceptance), "homing" (whether a move needs a home; the manual
demands none), "servo" after power-on, "reset" with the servo on, and what stops it from "outside".
"""

from __future__ import annotations

import struct

from device_models.draws import Draws
from device_models.modbus import ADDRESS, FAILURE, VALUE, ModbusDevice, RefusedError, high, low, number_of

ERROR, EMERGENCY, SLOW_STOP, HOMING, IN_POSITION = 1, 1 << 16, 1 << 17, 1 << 18, 1 << 19
SERVO_ON, TABLE_STOPPED, HOMED, DIRECTION, MOVING = 1 << 20, 1 << 22, 1 << 25, 1 << 26, 1 << 27
"""Flags of 3E8H [3.1 L637-668]."""
POINTS, FLASH_POINTS, POINT_WORDS = 10000, 20000, 32
"""The table in memory and in flash [2.7 L575-614]."""
PARAMETERS = range(0x1388, 0x1432)
NONE = 0xFFFF


class Ck10(ModbusDevice):
    """A CK10 on Modbus RTU."""

    MOST_WORDS = 125

    def __init__(self, draws: Draws) -> None:
        super().__init__(draws)
        self.words: dict[int, int] = {}
        self.flash: dict[int, int] = {}
        self.point, self.running, self.cause = 0, False, 0
        self.emergency = False
        self.servo = self.draws.reading("servo", "on", "off") == "on"

    @property
    def homing_needed(self) -> bool:
        return self.draws.reading("homing", "needed", "not needed", "not needed") == "needed"

    def read(self, address: int) -> int:
        axis, position = self.axis, self.axis.position
        values = {
            0x3E8: lambda: high(self._flags()),
            0x3E9: lambda: low(self._flags()),
            0x3EA: lambda: high(position),
            0x3EB: lambda: low(position),
            0x3EC: lambda: high(position),
            0x3ED: lambda: low(position),
            0x3EE: lambda: high(axis.velocity),
            0x3EF: lambda: low(axis.velocity),
            0x3F6: lambda: self.point,
            0x3F7: lambda: int(self.running),
            0x3F9: lambda: self.alarm,
            0x837: lambda: 100,
        }
        if address in values:
            return values[address]()
        # Triggers read 0, except that of moves, which reads the last one [2.4 L311-338].
        if address in (0x7DF, 0x7EE, 0x7EF, 0x7F0, 0x7F2, 0x7F3, 0x7F4, 0x7F5):
            return 0
        if address == 0x7F1:
            return int(self.servo)
        if FLASH_POINTS <= address < FLASH_POINTS + 128 * POINT_WORDS:
            return self.flash.get(address - FLASH_POINTS, 0)
        if 0x3E8 <= address < 0x442 or 0x7D0 <= address < 0x840 or address in PARAMETERS or self._is_point(address):
            return self.words.get(address, 0)
        raise RefusedError(ADDRESS)

    def write(self, address: int, words: list[int]) -> None:
        for index, word in enumerate(words):
            place = address + index
            if not (0x7D0 <= place < 0x7FE or place in PARAMETERS or self._is_point(place) or 0x410 <= place < 0x41A):
                raise RefusedError(ADDRESS)
            self.words[place] = word
        for index, word in enumerate(words):
            self._triggered(address + index, word)

    def set_alarm(self, number: int) -> None:
        """An alarm stops the axis and takes the servo off [2.3 L301]."""
        self.cause = number
        if not number:
            self.axis.record("cause gone", "alarm")
        else:
            self.alarm, self.servo, self.running = number, False, False
            self.axis.record("alarm", f"{number}")
            self.axis.cut()

    def power_cycle(self) -> None:
        self.axis.cut()
        self._end_emergency()
        self.axis.homed, self.running = False, False
        self.alarm = self.cause
        self.servo = not self.alarm and self.draws.reading("servo", "on", "off") == "on"
        self.words = {place: word for place, word in self.words.items() if not self._is_point(place)}
        self.words |= {POINTS + offset: word for offset, word in self.flash.items()}

    def stop_outside(self, visible: bool = False) -> None:
        """Software stops it, or its input of emergency stops, whose state lasts until a reset [2.4 L335, 3.1 L653]."""
        self.emergency = self.draws.reading("outside", "software", "emergency stop") == "emergency stop"
        self.running = False
        super().stop_outside(visible or self.emergency)

    def pass_time(self, seconds: float) -> None:
        super().pass_time(seconds)
        if self.running and not self.axis.expected:
            self._next_point()

    @staticmethod
    def meaning(frame: bytes) -> str:
        """What a request asks for: a start, a stop, or something else."""
        if frame[1] == 3:
            return "read"
        address, word = struct.unpack(">HH", frame[2:6])
        if frame[1] == 0x10 and len(frame) >= 9 + 2:
            # A trigger may be the last word of several.
            count, words = word, struct.unpack(f">{word}H", frame[7 : 7 + 2 * word])
            address, word = address + count - 1, words[-1]
        moves = {1: "start relative", 2: "start absolute"}
        if address == 0x7D8:
            return moves.get(word, "write")
        if address == 0x7F1 and not word:
            return "off"
        return {0x7DF: "start jog", 0x7EF: "start home", 0x7F0: "stop", 0x7F7: "start point"}.get(address, "write")

    def _is_point(self, address: int) -> bool:
        return POINTS <= address < POINTS + 128 * POINT_WORDS

    def _flags(self) -> int:
        axis = self.axis
        accepted = self.draws.reading("moving", "from acceptance", "from begin") == "from acceptance"
        moving = axis.moving or (accepted and axis.waiting is not None)
        flags = SERVO_ON * self.servo | HOMED * axis.homed | ERROR * bool(self.alarm) | MOVING * moving
        flags |= IN_POSITION * (not moving) | TABLE_STOPPED * (not self.running)
        flags |= HOMING * bool(moving and axis.motion and axis.motion.kind == "home")
        flags |= EMERGENCY * self.emergency
        flags |= SLOW_STOP * axis.stopping | DIRECTION * (axis.velocity < 0)
        return flags

    def _long(self, address: int) -> int:
        return number_of([self.words.get(address, 0), self.words.get(address + 1, 0)])

    def _triggered(self, address: int, word: int) -> None:
        """What writing a register sets off [2.4 L305-338]."""
        speed = float(self._long(0x7D4) or 1000)
        if address == 0x7D8:
            if word not in (1, 2):
                raise RefusedError(VALUE)
            place = self._long(0x7D6)
            self._start("relative" if word == 1 else "absolute", place, None if word == 1 else place, speed)
        elif address == 0x7DF and word == 1:
            sign = 1 if self.words.get(0x7DE) else -1
            kind = "jog_forward" if sign > 0 else "jog_backward"
            self._start(kind, sign, None, sign * float(self._long(0x7DC) or 1000))
        elif address == 0x7EF and word == 1:
            self._start("home", 0, None, 4000.0)
        elif address == 0x7F0:
            self.running = False
            self.axis.stop(*([] if word else [160000.0]))
        elif address == 0x7F1:
            self._switch(bool(word))
        elif address == 0x7F3 and word == 1:
            self._end_emergency()
            needs_off = self.draws.reading("reset", "any time", "servo off") == "servo off"
            if not self.cause and not (needs_off and self.servo):
                self.alarm = 0
        elif address == 0x7F5 and word == 1:
            self.flash = {place - POINTS: value for place, value in self.words.items() if self._is_point(place)}
        elif address == 0x7F7:
            self._run(word)

    def _end_emergency(self) -> None:
        if self.emergency:
            self.axis.record("stop ended", "outside")
        self.emergency = False

    def _switch(self, on: bool) -> None:
        if not on:
            self.servo = self.running = False
            self.axis.record("stop", "servo off")
            self.axis.cut()
        elif self.alarm:
            raise RefusedError(FAILURE)
        else:
            self.servo = True

    def _start(self, kind: str, value: float, target: float | None, speed: float) -> None:
        busy = self.axis.expected and self.draws.reading("busy command", "refused", "taken") == "refused"
        unhomed = self.homing_needed and not self.axis.homed and kind != "home"
        if not self.servo or self.alarm or self.emergency or busy or unhomed or self.draws.refuses():
            self.axis.record("refused", kind, value)
            if self.draws.reading("start refusal", "exception", "exception", "nothing") == "exception":
                raise RefusedError(FAILURE)
            return
        self.axis.accept(kind, value, target, speed)

    def _run(self, word: int) -> None:
        """1 runs the table from a point on, 2 a single point, 3 the next one [2.4 L337-338]."""
        self.point = self.words.get(0x7F6, 0) if word != 3 else self._following()
        if not 0 <= self.point < 128:
            raise RefusedError(VALUE)
        self._start_point()
        self.running = word == 1

    def _start_point(self) -> None:
        """Commands 0 to 3 are absolute, 4 to 7 relative, 8 homing [3.5 L821-834]."""
        place = POINTS + POINT_WORDS * self.point
        command, position = self.words.get(place + 8, 1), self._long(place)
        speed = float(self._long(place + 4) or 1000)
        if command == 8:
            self._start("home", 0, None, 4000.0)
        else:
            self._start("point", self.point, position if command < 4 else self.axis.position + position, speed)

    def _following(self) -> int:
        return self.words.get(POINTS + POINT_WORDS * self.point + 11, NONE)

    def _next_point(self) -> None:
        following = self._following()
        if following >= 128 or not self.servo or self.alarm:
            self.running = False
            return
        self.point = following
        self.axis.record("asked", "point", following)
        self._start_point()
