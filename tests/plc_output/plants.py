"""The examples of docs/plc.md, each with a device that is simulated on the other side of its line.

A plant runs scan by scan. It counts the starts that reach the device, and checks at each whether the program was
allowed to start: there was a rising edge of its input since the controller was switched on, and since then neither the
end of a move, nor an alarm, a failure or a withdrawal of the input that the program could have seen.
"""

from __future__ import annotations

import random
from pathlib import Path

import example_programs
from test_docs_examples import Controller, channels


class Plant:
    """What all plants have: inputs of the program that a test sets, its outputs, and the rule.

    `start` is the input with the edge. `alarm` is that of the device, `lost` that telegrams do not arrive.
    """

    def __init__(self) -> None:
        self.start = self.alarm = self.lost = False
        self.done = self.error = False
        self.starts = self.finished = self.failed = 0
        self.allowed, self._before = False, True

    def watched(self, disturbed: bool = False) -> None:
        """Notes what the program sees in the scan that comes."""
        if self.start and not self._before:
            self.allowed = True
        if not self.start or disturbed:
            self.allowed = False
        self._before = self.start

    def ended(self, done: bool, error: bool) -> None:
        """Notes the outputs of a scan."""
        self.finished += done and not self.done
        self.failed += error and not self.error
        self.done, self.error = done, error
        if done or error:
            self.allowed = False

    def started(self, allowed: bool) -> None:
        """A start has reached the device."""
        assert allowed, "it moves without a fresh edge"
        self.starts += 1

    def restart(self) -> None:
        """The controller is switched off and on; the device keeps its state."""
        self.allowed, self._before = False, True
        self.done = self.error = False

    def scan(self) -> None:
        """One scan of the program, and what the device does until the next one."""
        raise NotImplementedError

    def power_cycle(self) -> None:
        """The device is switched off and on; the program runs on."""
        raise NotImplementedError


class Telegram111(Plant):
    """A HIWIN E drive on telegram 111. `lost` lets DPRD_DAT fail, `unsent` DPWR_DAT."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self.program = example_programs.telegram_111(folder)
        self.program.restart()
        self.enable, self.homed, self.unsent = True, True, False
        self.command = {"onMember": False, "enableOperation": False, "startTraversingTask": False}
        self.ready = self.operation = self.acknowledged = False
        self.moving = 0

    def restart(self) -> None:
        super().restart()
        self.program.restart()

    def power_cycle(self) -> None:
        self.ready = self.operation = self.acknowledged = False
        self.moving = 0

    def scan(self) -> None:
        received = (self.ready, self.ready, self.operation, self.alarm, self.homed, self.acknowledged, not self.moving)
        ready = self.enable and self.operation and not self.alarm and not self.lost
        self.watched(disturbed=not ready)
        arguments = (self.enable, self.start, 1000, 250, int(self.lost), int(self.unsent), *received, self.moving > 0)
        done, error, _, *bits, _ = self.program.scan(4, arguments)
        command = dict(zip(self.command, bits, strict=True))
        if not self.lost and not self.unsent:
            self._obeyed(command)
        self.ended(done, error)

    def _obeyed(self, command: dict[str, bool]) -> None:
        """What the drive does with a telegram."""
        rising = command["startTraversingTask"] and not self.command["startTraversingTask"]
        self.command = command
        self.operation = command["enableOperation"] and self.ready and not self.alarm
        self.ready = True
        self.moving = max(0, self.moving - 1) if self.operation else 0
        if rising and self.operation:
            self.started(self.allowed)
            self.moving = 6
        self.acknowledged = command["startTraversingTask"] and self.operation


class Tc100(Plant):
    """A TC100 on a channel of Modbus; each answer takes some scans. `lost` lets the channel fail."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self.program = example_programs.tc100(folder)
        self.channels = channels()
        self.controller = Controller(polls=3)
        self.status, self.monitor = [0, 0], [0] * 11
        self.restart()

    def restart(self) -> None:
        super().restart()
        self.program.restart()
        self.executing, self.silent, self.waits = False, False, 0

    def power_cycle(self) -> None:
        self.controller = Controller(polls=3)
        self.controller.words[0x100C] = 0

    def scan(self) -> None:
        self.controller.words[0x1005] = 3 if self.alarm else 0
        if self.alarm:
            self.controller.left = self.controller.words[0x1000] = 0
        self.waits -= self.waits > 0
        over = self.executing and not self.waits
        self.silent = self.silent or self.lost
        self.watched()
        arguments = (self.start, 5000, over and not self.silent, over and self.silent, self.status, self.monitor)
        done, error, _, executing, channel, servo, command, position = self.program.scan(10, arguments)
        if executing and not self.executing:
            self.waits, self.silent = 2, self.lost
            if not self.lost:
                self._exchanged(channel, servo, command, position)
        self.executing = executing
        self.ended(done, error)

    def _exchanged(self, channel: int, servo: int, command: int, position: list[int]) -> None:
        """What the controller does with a request, and what it answers."""
        _, offset, length, name = self.channels[channel]
        if name == "astatus":
            self.status = self.controller.read(offset, length)
        elif name == "amonitor":
            self.monitor = self.controller.read(offset, length)
        elif name == "wcommand":
            self.started(self.allowed)
            if self.controller.words[0x100C]:
                self.controller.write(offset, [command])
        else:
            words = {"wservo": [servo], "aposition": position}.get(name)
            if words is not None:
                self.controller.write(offset, words)


class Esc11(Plant):
    """An ESC11 on a serial line, byte by byte, with its delays. `lost` keeps it silent, `damaged` spoils its sums."""

    MILLISECONDS = 50

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self.program = example_programs.esc11(folder)
        self.damaged = self.busy = False
        self.line, self.coming = bytearray(), bytearray()
        self.executing, self.delay, self.unpowered = 0, 0, 0
        self.calls = self.received = 0
        self.permitted = False
        self.restart()

    def restart(self) -> None:
        super().restart()
        self.program.restart()
        self.calls = self.received = 0
        self.line.clear()

    def power_cycle(self) -> None:
        self.executing, self.unpowered = 0, 30
        self.coming.clear()

    def scan(self) -> None:
        self.delay -= self.delay > 0
        self.executing -= self.executing > 0
        self.unpowered -= self.unpowered > 0
        arrived = bool(self.coming) and not self.delay
        self.watched()
        arguments = (self.start, self.busy, arrived, self.coming[0] if arrived else 0)
        done, error, _, _, byte, calls, received = self.program.scan(self.MILLISECONDS, arguments)
        if calls != self.calls and not self.busy:
            self._heard(byte)
        if received != self.received and arrived:
            self.coming.pop(0)
        self.calls, self.received = calls, received
        self.ended(done, error)

    def _heard(self, byte: int) -> None:
        """A byte on the line; a whole packet is obeyed, and answered some time later."""
        if not self.line:
            self.permitted = self.allowed
        if len(self.line) == 2 and byte == 0x21:
            self.started(self.permitted)
        self.line.append(byte)
        if len(self.line) < self.line[0]:
            return
        code = self.line[2]
        assert self.line[-1] == sum(self.line[:-1]) & 0xFF
        self.line.clear()
        self.coming.clear()
        if self.lost:
            return
        if code == 0x21 and not self.alarm and not self.unpowered:
            self.executing = 20
        status = (0x40 if self.alarm else 0) | (0x04 if self.unpowered else 0) | (self.executing > 0)
        body = bytes([4, 0, status])
        self.coming += body + bytes([(sum(body) + self.damaged) & 0xFF])
        self.delay = 5


def disturbed(plant: Plant, dice: random.Random, steps: int) -> None:
    """Runs a plant for some scans, while its inputs, its device and its line change at random."""
    flags = [name for name in ("enable", "homed", "unsent", "damaged", "busy") if hasattr(plant, name)]
    for _ in range(steps):
        chance = dice.random()
        if chance < 0.04:
            plant.start = not plant.start
        elif chance < 0.043:
            plant.alarm = True
        elif chance < 0.046:
            plant.lost = True
        elif chance < 0.049 and flags:
            name = dice.choice(flags)
            setattr(plant, name, not getattr(plant, name))
        elif chance < 0.0495:
            plant.power_cycle()
        elif chance < 0.053:
            plant.restart()
        elif chance < 0.08:
            plant.alarm = plant.lost = False
            for name in flags:
                setattr(plant, name, name in ("enable", "homed"))
        plant.scan()
