"""Compiled blocks with a simulated device on the other side: TC100 and ESC11 by frames, HIWIN E by telegram 111."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, ClassVar

from benches import Bench, block_names
from devices import Esc11, Tc100, Telegram111, Transport

from fieldspec.targets.controllers.routines.blocks.ports import FRAMES
from fieldspec.targets.controllers.routines.blocks.standard import ERRORS
from layouts import SPECS

NUMBER = {name: number for name, (number, _) in ERRORS.items()}
"""The number of each error of a block."""


class Rig:
    """Blocks, the device on the other side, and the rule that nothing starts without an edge.

    A block may start what it is for once for each rising edge of its input that it has seen.
    """

    STARTS = ("Execute", "JogForward", "JogBackward")
    device: Any
    transport: Transport | None = None
    starting: ClassVar[dict[str, Sequence[str]]]
    """The motions that each block may begin."""

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.allowed = dict.fromkeys(self.starting, 0)
        self.before: dict[tuple[str, str], bool] = {key: True for key in bench.inputs if key[1] in self.STARTS}
        self.seen = 0

    def serve(self) -> None:
        """What the other side does between two scans."""
        assert self.transport is not None
        self.transport.serve(self.device.exchanged)

    def scan(self) -> None:
        """One scan, and what the device does until the next one; checks the rule."""
        now = {key: bool(self.bench.now[key]) for key in self.before if key[0] in self.bench.blocks}
        for (name, start), level in now.items():
            # Of two directions the one that remains begins when the other is taken away.
            turned = start != "Execute" and now[name, start] != self.before[name, start]
            if name in self.allowed and (turned or (level and not self.before[name, start])):
                self.allowed[name] = 1
        self.before |= now
        self.bench.scan()
        self.serve()
        self.device.pass_scan()
        for start in self.device.motion.starts[self.seen :]:
            blocks = [name for name, starts in self.starting.items() if start in starts and self.allowed[name]]
            assert blocks, f"{start} without an edge"
            self.allowed[blocks[0]] = 0
        self.seen = len(self.device.motion.starts)

    def run(self, scans: int, block: str = "", **inputs: Any) -> Rig:
        """Sets inputs of a block and runs some scans."""
        if block:
            self.bench.set(block, **inputs)
        for _ in range(scans):
            self.scan()
        return self

    def restart(self) -> None:
        """The controller is switched off and on; a request that is on its way is forgotten."""
        self.bench.restart()
        self.before = dict.fromkeys(self.before, True)
        self.allowed = dict.fromkeys(self.allowed, 0)
        if self.transport is not None:
            self.transport.restart()

    def done(self, block: str, scans: int = 400, **inputs: Any) -> str:
        """How a block ends after an edge; the input is withdrawn in the end."""
        self.run(2, block, Execute=False, **inputs)
        self.run(1, block, Execute=True)
        for _ in range(scans):
            if self.bench.ended(block) != "Busy":
                break
            self.scan()
        result = self.bench.ended(block)
        if result == "Error":
            result = f"Error {self.bench.reason(block)}"
        self.run(2, block, Execute=False)
        return result

    def ended(self, block: str) -> str:
        """How a block has ended, with its number."""
        result = self.bench.ended(block)
        return f"Error {self.bench.reason(block)}" if result == "Error" else result


class Tc100Rig(Rig):
    """A TC100 by frames: its blocks, and the client after them."""

    starting: ClassVar[dict[str, Sequence[str]]] = {
        "MoveAbsolute": ["move_absolute"],
        "MoveRelative": ["move_relative"],
        "Home": ["home"],
        "Jog": ["jog_positive", "jog_negative"],
        "RunPoint": [f"point {number}" for number in range(128)],
    }
    blocks = ("ServoOn", "ServoOff", *starting, "Stop", "Halt", "ResetAlarm", "ReadPosition", "RtuClient")

    def __init__(self, folder: Path, dialect: str = "iec") -> None:
        super().__init__(Bench(SPECS, "tc100", self.blocks, folder, dialect))
        self.device = Tc100()
        variable = next(name for name in self.bench.ports if name.lower().endswith("frames"))
        self.transport = Transport(self.bench, FRAMES, variable, delay=1)
        station = next(name for block, name in self.bench.inputs if block == "RtuClient" and "tation" in name)
        self.bench.set("RtuClient", Retries=2, **{station: Tc100.STATION})
        self.bench.set("MoveAbsolute", Velocity=20, PositionCounts=5000)
        self.bench.set("MoveRelative", Velocity=20, DistanceCounts=-10)
        self.bench.set("Jog", Velocity=20)


class Esc11Rig(Rig):
    """An ESC11 by frames."""

    starting: ClassVar[dict[str, Sequence[str]]] = {
        "MoveAbsolute": ["move_absolute"],
        "MoveRelative": ["move_relative"],
        "Home": ["start_homing"],
        "Jog": ["move_open", "move_close"],
        "RunPoint": ["move_to_point"],
    }
    blocks = ("ServoOn", "ServoOff", *starting, "Stop", "Halt", "ResetAlarm", "ReadPosition")

    def __init__(self, folder: Path, dialect: str = "iec") -> None:
        super().__init__(Bench(SPECS, "esc11", self.blocks, folder, dialect, block_names(SPECS, "esc11")))
        self.device = Esc11()
        variable = next(name for name in self.bench.ports if name.lower().endswith("frames"))
        self.transport = Transport(self.bench, FRAMES, variable, delay=1)
        for block, name in self.bench.inputs:
            if "ddress" in name:
                self.bench.set(block, **{name: Esc11.STATION})
            if name == "Velocity":
                self.bench.set(block, Velocity=50)
            if name == "PointNumber":
                self.bench.set(block, PointNumber=3)


class HiwinRig(Rig):
    """A HIWIN E on telegram 111. While `lost`, no response comes."""

    starting: ClassVar[dict[str, Sequence[str]]] = {
        "Telegram111MoveAbsolute": ["move"],
        "Telegram111MoveRelative": ["move"],
        "Telegram111Home": ["home"],
        "Telegram111Jog": ["jog_positive", "jog_negative"],
    }
    blocks = (
        *("Telegram111ServoOn", "Telegram111ServoOff", *starting, "Telegram111Stop", "Telegram111Halt"),
        *("Telegram111ResetAlarm", "Telegram111ReadPosition"),
    )

    def __init__(self, folder: Path, dialect: str = "iec") -> None:
        super().__init__(Bench(SPECS, "hiwin-e", self.blocks, folder, dialect, block_names(SPECS, "hiwin-e")))
        self.device = Telegram111()
        self.lost = False
        self.axis = self.bench.lent["Telegram111ServoOn", "Axis"]
        for (block, name), kind in self.bench.inputs.items():
            if kind == "lreal":
                self.bench.set(block, **{name: 50.0})

    def _of(self, name: str) -> str:
        return self.bench.port(Telegram111.KEY, name)

    def serve(self) -> None:
        port = self.bench.ports[self.axis]
        request, response = port[self._of("request")], port[self._of("response")]

        def of(struct: dict[str, Any], end: str) -> str:
            return next(name for name in struct if name.endswith(end))

        if not self.lost:
            absolute = request[of(request, "positioningcontrolword1")] & 0x100
            target = request[of(request, "targetposition")]
            word = next(name for name in request if name.endswith("controlword1") and "positioning" not in name)
            self.device.obey(request[word], bool(absolute), target)
            word = next(name for name in response if name.endswith("statusword1") and "positioning" not in name)
            response[word] = int(self.device.status)
            response[of(response, "positionactuala")] = self.device.motion.position
        port[self._of("valid")] = not self.lost


RIGS: dict[str, Callable[..., Rig]] = {"tc100": Tc100Rig, "esc11": Esc11Rig, "hiwin-e": HiwinRig}
WORDS = {
    "hiwin-e": ("Telegram111{}", "Telegram111MoveAbsolute", "Telegram111MoveRelative", "Telegram111Jog"),
    "tc100": ("{}", "MoveAbsolute", "MoveRelative", "Jog"),
    "esc11": ("{}", "MoveAbsolute", "MoveRelative", "Jog"),
}


class Axis:
    """A rig whose servo is on, with the names of its blocks in common."""

    def __init__(self, name: str, folder: Path, dialect: str = "iec") -> None:
        self.rig = RIGS[name](folder, dialect)
        form, self.absolute, self.relative, self.jog = WORDS[name]
        self.form = form
        self.rig.run(3)
        assert self.rig.done(self.block("ServoOn")) == "Done"

    def block(self, name: str) -> str:
        """A block by the name of its task."""
        return self.form.format(name)

    @property
    def starts(self) -> list[str]:
        """The motions that have begun."""
        return list(self.rig.device.motion.starts)
