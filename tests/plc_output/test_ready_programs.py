"""The ready programs run as they are generated, compiled, against models of the manuals: move, are refused, stop."""

from __future__ import annotations

import random
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from adapter_texts import program_texts
from benches import Bench
from compiled import Block, Compiled
from loaded import programs
from model_rigs import MODELS, FrameRig, ModelRig, TelegramRig
from model_scenes import CALM
from model_values import fitting
from st_syntax import parsed
from standard_text import anonymous, needed

from device_models.draws import calm
from device_models.esc11 import END
from device_models.hiwin import HiwinE
from fieldspec.foundation.names import Name
from fieldspec.targets.controllers.statements.expressions import TIME
from fieldspec.targets.iec.backend import source, text
from layouts import SPECS, newest

POSITIONING = ("tc100", "ck10", "esc11", "hiwin-e 9", "hiwin-e 111")
SPEEDS = ("hiwin-e 3", "hiwin-e 102")
PANEL = "fbPanel"


class ProgramBench(Bench):
    """A ready program: its only block is the panel, its only port the one that it leaves to a controller."""

    def __init__(self, device: str, telegram: int, folder: Path) -> None:
        iec = source(newest(SPECS, device))
        self.world = iec.declared.world
        pascal = Name.of(device).pascal()
        program, block = f"PRG_{pascal}", f"FB_{pascal}_Panel"
        if telegram:
            program, block = f"{program}_Telegram{telegram}", block.replace("Panel", f"Telegram{telegram}Panel")
        panel = next(routine for routine in iec.routines if routine.name == block)
        self.blocks = {PANEL: panel}
        kinds = {
            role: {(PANEL, item.variable.name): item.variable.type.name.lower() for item in panel.of_role(role)}  # type: ignore[union-attr]
            for role in ("input", "output")
        }
        self.inputs, self.outputs = kinds["input"], kinds["output"]
        self.initial = {key: key[1] == "Show" if kind == "bool" else 0 for key, kind in self.inputs.items()}
        port = "stAxis" if telegram else "stFrames"
        kind = f"st_{pascal.lower()}_" + (f"telegram{telegram}axis" if telegram else "frames")
        self._lent, self._kinds = [port], {port: kind}
        self._called, self._ordered, self._numbers = [], False, {}
        content = needed(text(iec), [block, f"FB_{pascal}_RtuClient"])
        paths = {key: f"{PANEL}.{key[1]}" for key in (*self.inputs, *self.outputs)}
        lent = ((port, kind),)
        inputs = ((paths[key], of) for key, of in self.inputs.items())
        outputs = ((paths[key], of) for key, of in self.outputs.items())
        compiled = Block(program, (*inputs, *lent), (*outputs, *lent))
        unit = parsed(anonymous(needed(content, ())))
        self.program = Compiled(content + program_texts("standard", device)[program], folder, compiled, unit)
        self.now: dict[tuple[str, str], Any] = {}
        self.restart()
        assert all(item.variable.type != TIME for item in panel.of_role("input"))


@cache
def bench(device: str, telegram: int, folder: Path) -> ProgramBench:
    """A ready program, which is compiled once."""
    return ProgramBench(device, telegram, folder)


class _Ready(ModelRig):
    """What the rigs of ready programs have in common: `set` and `get` are what a panel sets and shows."""

    def begin(self, device: str, telegram: int, folder: Path) -> None:
        """Switches everything on, with values that the device takes."""
        self.draws = calm(**CALM)  # type: ignore[arg-type]
        self.model = HiwinE(self.draws, telegram) if telegram else MODELS[device](self.draws)
        self.bench = bench(device, telegram, folder)
        self.asked: list[str] = []
        self.fates: list[str] = []
        self.bench.now.clear()
        self.bench.restart()
        for (_, name), of in self.bench.inputs.items():
            kind = "velocity" if (PANEL, "MoveVelocity") in self.bench.inputs else "absolute"
            value = fitting(device, kind, name, of, random.Random(1)) if of != "bool" else None
            if value is not None:
                self.put(**{name: value})
            if "ddress" in name:
                self.put(**{name: self.model.STATION})

    def put(self, **inputs: Any) -> None:
        """Sets what a panel sets."""
        self.bench.set(PANEL, **inputs)

    def show(self, name: str) -> Any:
        """What a panel shows."""
        return self.bench.out[PANEL, name]

    def pass_scans(self, scans: int) -> None:
        """Lets scans of 10 ms pass."""
        for _ in range(scans):
            self.bench.scan(10)
            self.serve(0.01)
            self.model.pass_time(0.01)

    def until(self, name: str, scans: int = 6000) -> bool:
        """Whether the panel shows something within a minute."""
        for _ in range(scans):
            self.pass_scans(1)
            if self.show(name):
                return True
        return False

    def until_moving(self) -> None:
        """Waits until the axis moves."""
        for _ in range(2000):
            self.pass_scans(1)
            if self.model.state.velocity:
                return
        raise AssertionError("it does not move")


class FrameProgram(_Ready, FrameRig):
    """A ready program on a line with frames."""

    def __init__(self, device: str, folder: Path) -> None:
        self.begin(device, 0, folder)
        self.connect()


class TelegramProgram(_Ready, TelegramRig):
    """A ready program with a telegram."""

    def __init__(self, telegram: int, folder: Path) -> None:
        self.begin("hiwin-e", telegram, folder)
        self.connect(telegram)


def ready(name: str, folder: Path, *inputs: str) -> Any:
    """A ready program whose axis has power, and carries out what some inputs say, one after the other."""
    device, _, telegram = name.partition(" ")
    rig: Any = TelegramProgram(int(telegram), folder) if telegram else FrameProgram(device, folder)
    rig.pass_scans(3)
    rig.put(Servo=True)
    assert rig.until("Ready"), rig.show("ErrorID")
    for item, output in zip(inputs[::2], inputs[1::2], strict=True):
        rig.put(**{item: True})
        assert rig.until(output), rig.show("ErrorID")
        rig.put(**{item: False})
        rig.pass_scans(3)
    return rig


def target(rig: Any, counts: float) -> tuple[str, float]:
    """The input for the position, and counts as it has them."""
    name, kind = next((name, kind) for (_, name), kind in rig.bench.inputs.items() if "osition" in name)
    return name, counts / 100 if kind == "lreal" else counts


@pytest.fixture
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where compiled programs are kept."""
    return programs(tmp_path_factory)


@pytest.mark.proof(1)
@pytest.mark.parametrize("name", POSITIONING)
def test_it_moves_to_a_position_and_shows_it(name: str, folder: Path) -> None:
    rig = ready(name, folder, "Home", "Homed")
    item, value = target(rig, 700)
    rig.put(**{item: value}, MoveAbsolute=True)
    assert rig.until("Moved"), rig.show("ErrorID")
    rig.pass_scans(300)
    output = next(name for _, name in rig.bench.outputs if "osition" in name and name != "PositionValid")
    assert (round(rig.model.state.position), rig.show("PositionValid"), rig.show("Error")) == (700, True, False)
    assert rig.show(output) == pytest.approx(value, abs=0.01)


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", POSITIONING)
def test_a_move_without_power_is_refused_and_says_why(name: str, folder: Path) -> None:
    rig = ready(name, folder, "Home", "Homed")
    rig.put(Servo=False)
    rig.pass_scans(400)
    item, value = target(rig, 700)
    before = rig.model.state.position
    rig.put(**{item: value}, MoveAbsolute=True)
    assert rig.until("Error")
    assert (rig.show("Moved"), rig.show("ErrorID") in (6, 10, 11), rig.model.state.position) == (False, True, before)


@pytest.mark.parametrize("name", POSITIONING)
def test_it_stops_while_it_moves_and_is_locked_until_the_stop_is_withdrawn(name: str, folder: Path) -> None:
    rig = ready(name, folder, "Home", "Homed")
    item, value = target(rig, 3000)
    rig.put(**{item: value}, MoveAbsolute=True)
    rig.until_moving()
    rig.put(Stop=True)
    assert rig.until("Stopped"), rig.show("ErrorID")
    rig.put(MoveAbsolute=False)
    rig.pass_scans(3)
    rig.put(MoveAbsolute=True)
    assert rig.until("Error")
    assert (rig.show("ErrorID"), rig.model.state.velocity) == (12, 0)


@pytest.mark.proof(1)
@pytest.mark.parametrize("name", SPEEDS)
def test_it_runs_at_a_speed_and_stops(name: str, folder: Path) -> None:
    rig = ready(name, folder, "MoveVelocity", "InVelocity")
    rig.pass_scans(500)
    assert rig.model.state.velocity == 0
    rig.put(MoveVelocity=True)
    rig.until_moving()
    rig.put(Stop=True)
    assert rig.until("Stopped"), rig.show("ErrorID")
    assert rig.model.state.velocity == 0


@pytest.mark.parametrize("name", [*POSITIONING, *SPEEDS])
def test_nothing_moves_where_all_inputs_are_true_in_the_first_scan(name: str, folder: Path) -> None:
    device, _, telegram = name.partition(" ")
    rig: Any = TelegramProgram(int(telegram), folder) if telegram else FrameProgram(device, folder)
    rig.put(**{item: True for _, item in rig.bench.inputs if item in ("Servo", "Home", "MoveAbsolute", "MoveVelocity")})
    rig.pass_scans(500)
    assert (rig.model.state.velocity, rig.model.state.servo) == (0, False)


def test_a_gripper_grips_and_releases(folder: Path) -> None:
    rig = ready("esc11", folder, "Home", "Homed")
    rig.put(Velocity=100, Force=70, Grip=True)
    assert rig.until("Gripped"), rig.show("ErrorID")
    assert [event.about for event in rig.model.events if event.kind == "accepted"][-1] == "grip"
    assert rig.model.state.position == -END
    rig.put(Grip=False, Release=True)
    assert rig.until("Released"), rig.show("ErrorID")
    assert (rig.model.state.position, rig.show("Gripped")) == (END, False)


def test_a_gripper_that_is_not_at_home_does_not_grip(folder: Path) -> None:
    rig = ready("esc11", folder)
    rig.put(Velocity=100, Force=70, Grip=True)
    assert rig.until("Error")
    assert (rig.show("Gripped"), rig.show("ErrorID"), rig.model.state.velocity) == (False, 11, 0)
