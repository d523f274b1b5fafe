"""Simulated devices on the other side of a port: they answer requests, move, have alarms, and lose power.

`starts` has the name of each motion that has begun, in order. A device moves for some scans.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from benches import Bench

from fieldspec.codec.reference import CodecError, codec
from fieldspec.targets.controllers.routines.blocks.ports import ABANDONED, ANSWERED, ASKED, FREE
from layouts import SPECS, newest

TIMEOUT = 2
"""The error of a transport that gets no answer."""


class Transport:
    """Whoever serves a port: it takes a request when it is free, and answers some scans later.

    `carry` has the error and changes the port. While `lost`, nothing gets through; `swallowed` carries the request out
    and loses the answer.
    """

    def __init__(self, bench: Bench, port: str, variable: str, delay: int = 2) -> None:
        self.bench, self.key, self.variable, self.delay = bench, port, variable, delay
        self.lost = self.swallowed = False
        self.left = 0
        self.error = 0
        self.asked: dict[str, Any] = {}
        self.taken = 0

    def of(self, name: str) -> Any:
        """A member of the port."""
        return self.bench.ports[self.variable][self.bench.port(self.key, name)]

    def put(self, name: str, value: Any) -> None:
        """Changes a member of the port."""
        self.bench.ports[self.variable][self.bench.port(self.key, name)] = value

    def restart(self) -> None:
        """The controller is switched off and on."""
        self.left = 0

    def serve(self, carry: Callable[[Transport], int]) -> None:
        """What happens between two scans."""
        state = self.of("state")
        self.put("urgent", max(0, self.of("urgent") - 1))
        if self.left:
            self.left -= 1
            if not self.left:
                self.put("error", self.error)
                self.put("answered", self.taken)
                self.put("state", FREE if state == ABANDONED else ANSWERED)
        elif state == ABANDONED:
            self.put("state", FREE)
        elif state == ASKED:
            self.left, self.taken = self.delay, self.of("request")
            self.error = TIMEOUT if self.lost else carry(self)
            if self.swallowed:
                self.error = TIMEOUT


class Motion:
    """What moves: for some scans after a start, unless it is stopped."""

    def __init__(self) -> None:
        self.starts: list[str] = []
        self.moving = 0
        self.endless = False
        self.position = 0
        self.target: int | None = None
        self.homed = False

    def begin(self, name: str, scans: int, endless: bool = False, target: int | None = None) -> None:
        """Begins a motion, which ends at its target; that of `home` finds the origin."""
        self.starts.append(name)
        self.moving, self.endless, self.target = scans, endless, target
        self.homing = "home" in name or "homing" in name
        self.homed = self.homed and not self.homing

    def end(self) -> None:
        """Stops."""
        self.moving, self.endless = 0, False

    def pass_scan(self) -> None:
        """One scan goes by."""
        if self.moving and not self.endless:
            self.moving -= 1
            if not self.moving:
                self.homed = self.homed or self.homing
                self.position = 0 if self.homing else self.position if self.target is None else self.target


class Tc100:
    """A TC100: its registers, and what writing them does. Its line is that of Modbus RTU, by the reference codec."""

    STATION = 3
    ALARM, SERVO, FAULT = 0x1005, 0x100C, 0x100D

    def __init__(self) -> None:
        self.motion = Motion()
        self.words: dict[int, int] = {}
        self.codec = codec(newest(SPECS, "tc100")).links["rtu"]
        self.written: list[tuple[int, list[int]]] = []
        self.refusing = False

    def power_cycle(self) -> None:
        """It is switched off and on."""
        self.words.clear()
        self.motion.end()

    def alarm(self, number: int) -> None:
        """It has an alarm, which stops it; 0 when what caused it is gone."""
        self.words[self.ALARM] = number
        if number:
            self.motion.end()

    def pass_scan(self) -> None:
        """One scan goes by."""
        self.motion.pass_scan()
        motion = self.motion
        self.words |= {0x1000: int(motion.moving > 0), 0x1001: int(not motion.moving), 0x1020: int(motion.homed)}
        self.words |= {0x1021: int(motion.homed), 0x1008: motion.position >> 16 & 0xFFFF}
        self.words[0x1009] = motion.position & 0xFFFF

    def exchanged(self, transport: Transport) -> int:
        """Takes a frame out of the port and puts the answer into it."""
        frame = bytes(transport.of("frame")[: transport.of("send")])
        name, values = self._asked(frame)
        if self.refusing:
            body = bytes([self.STATION, frame[1] | 0x80, 2])
            answer = body + _crc(body)
        elif name == "read_registers":
            words = [self.words.get(values["address"] + at, 0) for at in range(values["word_count"])]
            answer = self.codec.encode("response", name, {"station": self.STATION, "values": words})
        else:
            words = values["values"] if name == "write_registers" else [values["value"]]
            self._write(values["address"], words)
            answered = {"station": self.STATION, "address": values["address"]}
            answered |= {"word_count": len(words)} if name == "write_registers" else {"value": words[0]}
            answer = self.codec.encode("response", name, answered)
        data = list(transport.of("frame"))
        data[: len(answer)] = answer
        transport.put("frame", data)
        transport.put("received", len(answer))
        return 0

    def _asked(self, frame: bytes) -> tuple[str, dict[str, Any]]:
        for name in ("read_registers", "write_register", "write_registers"):
            try:
                values = dict(self.codec.decode(frame, "request", name).values)
            except CodecError:
                continue
            assert frame[0] == self.STATION
            return name, values
        raise AssertionError(frame.hex(" "))

    def _write(self, address: int, words: list[int]) -> None:
        self.written.append((address, words))
        for at, word in enumerate(words):
            self.words[address + at] = word
        if address == 0x2011:
            self.words[self.SERVO] = int(words[0] == 0 and not self.words.get(self.ALARM))
        elif address == 0x201E:
            self._command(words[0])
        elif address == 0x2040 and words[0] & 1 << 3 and self.ready:
            self.motion.begin(f"point {words[0] >> 4 & 0x7F}", 30)

    @property
    def ready(self) -> bool:
        """Whether it can move."""
        return bool(self.words.get(self.SERVO)) and not self.words.get(self.ALARM)

    def _long(self, address: int) -> int:
        number = self.words.get(address, 0) << 16 | self.words.get(address + 1, 0)
        return number - (1 << 32) if number >> 31 else number

    def _command(self, command: int) -> None:
        names = {0: "move_relative", 1: "move_absolute", 3: "home", 11: "jog_positive", 12: "jog_negative"}
        if command in names:
            self.words[self.FAULT] = 0 if self.ready else 8
            if self.ready:
                targets = {0: self.motion.position + self._long(0x2000), 1: self._long(0x2002)}
                self.motion.begin(names[command], 30, endless=command >= 11, target=targets.get(command))
        elif command in (8, 9):
            self.motion.end()
        elif command == 6 and not self.words.get(self.SERVO):
            self.words[self.ALARM] = 0


def _crc(body: bytes) -> bytes:
    check = 0xFFFF
    for byte in body:
        check ^= byte
        for _ in range(8):
            check = check >> 1 ^ (0xA001 if check & 1 else 0)
    return check.to_bytes(2, "little")


class Esc11:
    """An ESC11 with a station, whose frames are those of the reference codec."""

    STATION = 2

    def __init__(self) -> None:
        self.motion = Motion()
        self.codec = codec(newest(SPECS, "esc11")).links["serial"]
        self.messages = self.codec.link.messages
        self.servo, self.has_alarm, self.point = False, False, 0

    def power_cycle(self) -> None:
        """It is switched off and on."""
        self.servo = self.motion.homed = False
        self.motion.end()

    def alarm(self, number: int) -> None:
        """It has an alarm, which stops it."""
        self.has_alarm = bool(number)
        if number:
            self.motion.end()

    def pass_scan(self) -> None:
        """One scan goes by."""
        self.motion.pass_scan()

    @property
    def status(self) -> int:
        """The byte that each answer carries."""
        return (self.motion.moving > 0) | (not self.servo) << 2 | self.has_alarm << 6

    def exchanged(self, transport: Transport) -> int:
        """Takes a frame out of the port and puts the answer into it."""
        frame = bytes(transport.of("frame")[: transport.of("send")])
        name, values = self._asked(frame)
        answered: dict[str, Any] = {"address": self.STATION}
        moves = {"move_absolute", "move_relative", "move_open", "move_close", "start_homing", "move_to_point"}
        if name in moves and self.servo and not self.has_alarm:
            place = {"move_absolute": 0, "move_relative": self.motion.position}.get(name)
            distance = next((value for key, value in values.items() if key in ("position", "distance")), 0)
            self.point = values.get("point_number", self.point)
            self.motion.begin(name, 30, target=None if place is None else place + distance)
        elif name == "stop":
            self.motion.end()
        elif name == "set_motor_excitation":
            self.servo = bool(values["excited"])
        elif name == "reset_alarm":
            self.has_alarm = False
        elif name == "read_homing_state":
            answered["homing_complete"] = self.motion.homed
        elif name == "read_current_position":
            answered["position"] = self.motion.position
        elif name == "read_current_point_number":
            answered["point_number"] = self.point
        elif name == "read_alarm_code":
            answered["alarm_code"] = 0
        answered["status"] = self.status
        answer = self.codec.encode("response", name, answered)
        data = list(transport.of("frame"))
        data[: len(answer)] = answer
        transport.put("frame", data)
        transport.put("received", len(answer))
        return 0

    def _asked(self, frame: bytes) -> tuple[str, dict[str, Any]]:
        name = next(name for name, message in self.messages.items() if message.message.code == frame[2])
        return name, dict(self.codec.decode(frame, "request", name).values)


class Telegram111:
    """A HIWIN E drive on telegram 111, by the masks of its words."""

    KEY = "axis of telegram_111"

    def __init__(self) -> None:
        self.motion = Motion()
        self.motion.homed = True
        self.has_alarm = False
        self.ready = self.operation = self.acknowledged = False
        self.inhibited = True
        self.before = 0

    def power_cycle(self) -> None:
        """It is switched off and on."""
        self.ready = self.operation = self.acknowledged = self.motion.homed = False
        self.inhibited = True
        self.motion.end()

    def alarm(self, number: int) -> None:
        """It has an alarm, which stops it."""
        self.has_alarm = bool(number)
        if number:
            self.operation, self.inhibited = False, True
            self.motion.end()

    def obey(self, word: int, absolute: bool = True, target: int = 0) -> None:
        """What it does with a control word and a target."""
        risen = word & ~self.before
        self.before = word
        if not word & 0x0400:
            return
        if risen & 0x80:
            self.has_alarm = False
        if not word & 0x01:
            self.inhibited = False
        self.inhibited = self.inhibited or word & 0x06 != 0x06 or self.has_alarm
        self.ready = not self.inhibited
        self.operation = self.ready and word & 0x09 == 0x09
        motion = self.motion
        if (not self.operation or not word & 0x10) and motion.moving and not word & 0x0900:
            motion.end()
        if self.operation and risen & 0x0800:
            motion.begin("home", 30)
        jog = "jog_positive" if risen & 0x100 else "jog_negative" if risen & 0x200 else ""
        if jog and self.operation:
            motion.begin(jog, 30, endless=True)
        if motion.endless and not word & 0x300:
            motion.end()
        if self.operation and risen & 0x40 and word & 0x30 == 0x30:
            motion.begin("move", 30, target=target if absolute else motion.position + target)
        self.acknowledged = bool(word & 0x40) and self.operation

    def pass_scan(self) -> None:
        """One scan goes by."""
        self.motion.pass_scan()

    @property
    def status(self) -> int:
        """Its status word."""
        stands = not self.motion.moving
        bits = self.ready | self.ready << 1 | self.operation << 2 | self.has_alarm << 3 | self.inhibited << 6
        return bits | stands << 10 | self.motion.homed << 11 | self.acknowledged << 12 | stands << 13
