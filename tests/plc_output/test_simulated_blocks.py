"""The blocks for tasks are compiled and run against the simulator, each device with the behaviour of its spec."""

from __future__ import annotations

import os
import random
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, ClassVar

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from benches import Bench, block_names
from devices import Transport
from loaded import programs
from rigs import NUMBER, Esc11Rig, HiwinRig, Rig, Tc100Rig
from simulated import ProcessData, Simulated

from fieldspec.targets.controllers.routines.blocks.ports import FRAMES
from layouts import SPECS

STEPS = int(os.environ.get("FIELDSPEC_RANDOM_STEPS", "800"))


class Ck10Rig(Rig):
    """A CK10 by frames of Modbus RTU."""

    starting: ClassVar[dict[str, Sequence[str]]] = {
        "MoveAbsolute": ["absolute"],
        "MoveRelative": ["relative"],
        "Home": ["home"],
        "Jog": ["endless"],
        "RunPoint": ["absolute", "relative"],
    }
    blocks = ("ServoOn", "ServoOff", *starting, "Stop", "Halt", "ResetAlarm", "ReadPosition", "RtuClient")

    def __init__(self, folder: Path) -> None:
        super().__init__(Bench(SPECS, "ck10", self.blocks, folder))
        connect(self, "ck10", "rtu")
        self.bench.set("MoveAbsolute", PositionCounts=2000, VelocityCounts=20000)
        self.bench.set("MoveRelative", DistanceCounts=-500, VelocityCounts=20000)
        self.bench.set("Jog", Velocity=1000)


class Ck10TableRig(Rig):
    """The blocks of the point table of a CK10."""

    starting: ClassVar[dict[str, Sequence[str]]] = {"RunPointTable": ["absolute", "relative"]}
    blocks = (
        *("ServoOn", "RunPointTable", "ReadPointsElement", "WritePointsElement", "ReadPoints", "WritePoints"),
        *("SavePoints", "ReadFlashPointsElement", "RtuClient"),
    )

    def __init__(self, folder: Path) -> None:
        super().__init__(Bench(SPECS, "ck10", self.blocks, folder))
        connect(self, "ck10", "rtu")

    def scan(self) -> None:
        if self.device.engine.states["program"] == "running":
            self.allowed["RunPointTable"] = 1  # the next point of the table that runs
        super().scan()


class Tc100SimulatedRig(Tc100Rig):
    """A TC100 by frames of Modbus RTU."""

    starting: ClassVar[dict[str, Sequence[str]]] = {
        "MoveAbsolute": ["absolute"],
        "MoveRelative": ["relative"],
        "Home": ["home"],
        "Jog": ["endless"],
        "RunPoint": ["absolute", "relative"],
    }

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        connect(self, "tc100", "rtu")


class Esc11SimulatedRig(Esc11Rig):
    """An ESC11 by its packets."""

    starting: ClassVar[dict[str, Sequence[str]]] = {
        "MoveAbsolute": ["absolute"],
        "MoveRelative": ["relative"],
        "Home": ["home"],
        "Jog": ["absolute", "endless"],
        "RunPoint": ["absolute", "relative"],
    }

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        connect(self, "esc11", "serial")


class TelegramRig(HiwinRig):
    """A HIWIN E on telegram 111."""

    message = "telegram_111"
    starting: ClassVar[dict[str, Sequence[str]]] = {
        "Telegram111MoveAbsolute": ["absolute"],
        "Telegram111MoveRelative": ["relative"],
        "Telegram111Home": ["home"],
        "Telegram111Jog": ["endless"],
    }

    def __init__(self, folder: Path) -> None:
        Rig.__init__(self, Bench(SPECS, "hiwin-e", self.blocks, folder, program=block_names(SPECS, "hiwin-e")))
        self.device = Simulated("hiwin-e", "cyclic", self.message)
        self.process_data = ProcessData(self.bench, self.device, self.message)
        for (block, name), kind in self.bench.inputs.items():
            if kind == "lreal":
                self.bench.set(block, **{name: 50.0})
        for block in self.blocks:
            if block.endswith(("MoveAbsolute", "MoveRelative")):
                self.bench.set(block, Velocity=6000000.0)

    def serve(self) -> None:
        self.process_data.lost = self.lost
        self.process_data.serve()

    lost = False


class Telegram9Rig(TelegramRig):
    """A HIWIN E on telegram 9."""

    message = "telegram_9"
    starting: ClassVar[dict[str, Sequence[str]]] = {
        "Telegram9MoveAbsolute": ["absolute"],
        "Telegram9MoveRelative": ["relative"],
        "Telegram9Home": ["home"],
        "Telegram9Jog": ["endless"],
    }
    blocks = (
        *("Telegram9ServoOn", "Telegram9ServoOff", *starting, "Telegram9Stop", "Telegram9Halt"),
        "Telegram9QuickStop",
        *("Telegram9ResetAlarm", "Telegram9ReadPosition"),
    )


class SpeedRig(TelegramRig):
    """A HIWIN E on a telegram with a speed; `move` is the block that commands it."""

    move = ""


def speed_rig(number: int, with_torque: bool) -> type[SpeedRig]:
    """The rig of a telegram, whose blocks have its number."""
    form = f"Telegram{number}"
    move = f"{form}MoveVelocity{'WithTorqueReduction' if with_torque else ''}"
    blocks = [f"{form}ServoOn", f"{form}ServoOff", move, f"{form}QuickStop", f"{form}ResetAlarm"]
    more = [f"{form}ReduceTorque"] if with_torque else []
    values = {
        "message": f"telegram_{number}",
        "move": move,
        "starting": {move: ["endless"]},
        "blocks": (*blocks[:3], *more, *blocks[3:]),
    }
    return type(f"{form}Rig", (SpeedRig,), values)


SPEEDS = {
    "telegram 3": speed_rig(3, with_torque=False),
    "telegram 5": speed_rig(5, with_torque=False),
    "telegram 102": speed_rig(102, with_torque=True),
    "telegram 105": speed_rig(105, with_torque=True),
}


def connect(rig: Any, device: str, link: str) -> None:
    """Puts a device of the simulator on the line of a rig."""
    variable = next(name for name in rig.bench.ports if name.lower().endswith("frames"))
    rig.device = Simulated(device, link)
    rig.transport = Transport(rig.bench, FRAMES, variable, delay=1)
    for block, name in rig.bench.inputs:
        if name in ("Station", "Address"):
            rig.bench.set(block, **{name: 1})


RIGS: dict[str, Callable[[Path], Any]] = {
    "ck10": Ck10Rig,
    "tc100": Tc100SimulatedRig,
    "esc11": Esc11SimulatedRig,
    "telegram 9": Telegram9Rig,
    "telegram 111": TelegramRig,
}


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


def moved(rig: Any, block: str, **inputs: Any) -> float:
    """Where a device is when a block that moves it is done."""
    assert rig.done(block, scans=3000, **inputs) == "Done"
    assert not rig.device.motion.moving
    position: float = rig.device.engine.axis.position(rig.device.unit.now)
    return position


@pytest.mark.proof(3)
@pytest.mark.parametrize(
    ("name", "form", "absolute", "relative"),
    [
        ("ck10", "{}", {"PositionCounts": 2000}, {"DistanceCounts": -500}),
        ("tc100", "{}", {"PositionCounts": 2000}, {"DistanceCounts": -500}),
        ("esc11", "{}", {"Position": 5.0}, {"Distance": -1.25}),
        ("telegram 9", "Telegram9{}", {"Position": 2000}, {"Distance": -500}),
        ("telegram 111", "Telegram111{}", {"Position": 2000}, {"Distance": -500}),
    ],
)
def test_a_device_goes_where_its_blocks_send_it(
    name: str, form: str, absolute: dict[str, Any], relative: dict[str, Any], folder: Path
) -> None:
    rig = RIGS[name](folder)
    rig.run(3)
    first, second, jog = (next(block for block in rig.starting if word in block) for word in ("Abs", "Rel", "Jog"))
    assert rig.done(form.format("ServoOn")) == "Done"
    assert moved(rig, form.format("Home")) == 0
    scale = 100 if name == "esc11" else 1
    assert moved(rig, first, **absolute) == pytest.approx(scale * next(iter(absolute.values())))
    between = rig.device.engine.axis.position(rig.device.unit.now)
    assert moved(rig, second, **relative) == pytest.approx(between + scale * next(iter(relative.values())))
    rig.run(40, jog, JogForward=True)
    assert rig.device.motion.moving
    rig.run(60, jog, JogForward=False)
    assert (rig.device.motion.moving, rig.ended(jog)) == (False, "")
    assert rig.done(form.format("ServoOff")) == "Done"


def point(rig: Any, position: int, next_point: int) -> dict[str, int]:
    """A point of a CK10 that moves to a position fast, with all else as small as it may be."""
    world = rig.bench.world
    values = {"position": position, "jump_point": next_point, "high_speed": 20000, "command": "absolute_high_speed"}
    result: dict[str, int] = {}
    for field in world.layout.records["point"].fields:
        content = field.value
        if content is None or field.field.reserved:
            continue
        raw = values.get(field.name, content.ranges.low if content.ranges is not None else 0)
        members = world.layout.device.enums[content.enum].members if content.enum else ()
        numbers = {member.name: member.value for member in members}
        result[world.member("point", field.name).lower()] = numbers.get(raw, raw)
    return result


def test_points_that_are_written_are_read_back_saved_and_run(folder: Path) -> None:
    rig = Ck10TableRig(folder)
    rig.run(3)
    position = rig.bench.world.member("point", "position").lower()
    several, single = (rig.bench.lent[block, "Data"] for block in ("ReadPoints", "ReadPointsElement"))
    rows = rig.bench.ports[several]
    for number in range(3):
        rows[number] |= point(rig, 1000 * (number + 1), number + 1 if number < 2 else 10000)
    rig.bench.ports[single] |= point(rig, 4000, 10000)
    assert rig.done("WritePoints", First=0, Last=2) == "Done"
    assert rig.done("WritePointsElement", Number=3) == "Done"
    for row in (rig.bench.ports[single], *rig.bench.ports[several]):
        row |= dict.fromkeys(row, 0)
    assert rig.done("ReadPoints", First=1, Last=3) == "Done"
    assert [row[position] for row in rig.bench.ports[several][:4]] == [0, 2000, 3000, 4000]
    assert rig.done("ReadPointsElement", Number=0) == "Done"
    assert rig.bench.ports[single][position] == 1000
    assert rig.done("SavePoints") == "Done"
    assert rig.done("ReadFlashPointsElement", Number=3) == "Done"
    assert rig.bench.ports[single][position] == 4000
    assert rig.done("ServoOn") == "Done"
    assert moved(rig, "RunPointTable") == 3000
    assert rig.device.motion.starts == ["absolute"] * 3
    assert rig.done("ReadPoints", First=127, Last=128) == f"Error {NUMBER['request']}"


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", [*RIGS, *SPEEDS])
def test_nothing_starts_without_an_edge_whatever_happens_to_a_simulated_device(name: str, folder: Path) -> None:
    rig = {**RIGS, **SPEEDS}[name](folder)
    dice, ended = random.Random(12), 0
    starts = [key for key in rig.bench.inputs if key[0] in rig.bench.blocks and key[1] in Rig.STARTS]
    rig.device.home()
    for _ in range(STEPS):
        chance = dice.random()
        if chance < 0.08:
            block, start = dice.choice([key for key in starts if chance < 0.02 or not key[0].endswith("Stop")])
            rig.bench.set(block, **{start: not rig.bench.now[block, start]})
        elif 0.2 < chance < 0.4:
            # A stop that is asked for all the time would let nothing move.
            for stop in (block for block, _ in starts if block.endswith("Stop")):
                rig.bench.set(stop, Execute=False)
        elif chance < 0.086:
            rig.device.alarm(dice.choice([0, 3]))
        elif chance < 0.0865:
            rig.device.power_cycle()
        elif chance < 0.087:
            rig.restart()
        if rig.transport is not None:
            rig.transport.lost = 0.09 < chance < 0.1
            rig.transport.swallowed = 0.1 < chance < 0.11
        else:
            rig.lost = 0.09 < chance < 0.095
        rig.scan()
        ended += sum(rig.bench.ended(block) == "Done" for block, _ in starts)
    assert ended
    assert rig.device.motion.starts
