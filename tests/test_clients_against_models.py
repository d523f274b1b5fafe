"""The generated Python clients, against models that are written from the manuals and know nothing of the specs.

Each test is a scene, in a time that nobody waits for.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from contextlib import suppress
from typing import Any

import pytest

from device_models.carrying import Carrier
from device_models.ck10 import POINT_WORDS, POINTS, Ck10
from device_models.draws import calm
from device_models.esc11 import Esc11
from device_models.hiwin import HiwinE
from device_models.tc100 import AsciiTc100, Tc100
from fieldspec_devices import DeviceError
from fieldspec_devices.ck10 import client as ck10_client
from fieldspec_devices.errors import NoAnswerError
from fieldspec_devices.esc11 import client as esc11_client
from fieldspec_devices.hiwin_e import client as hiwin_client
from fieldspec_devices.tc100 import client as tc100_client

CALM = {
    "servo": "off",
    "excitation": "off",
    "homing": "needed",
    "busy command": "taken",
    "in position": "target",
    "outside": "software",
    "late start": "cancelled",
    "no control": "zeros",
}
FRAMED = ("tc100", "tc100 rtu", "ck10", "esc11")
"""Devices by their names, each on the link that it uses as delivered unless another one is named."""
TELEGRAMS = ("9", "111")
SPEEDS = ("3", "102")


def connected(name: str, home: bool = True, **readings: str) -> tuple[Any, Carrier]:
    """A client whose device has its servo on and is at home, unless a scene wants it otherwise."""
    draws = calm(**{key.replace("_", " "): value for key, value in {**CALM, **readings}.items()})
    if name in FRAMED:
        model: Any = {"tc100": AsciiTc100, "tc100 rtu": Tc100, "ck10": Ck10, "esc11": Esc11}[name](draws)
        device, _, link = name.partition(" ")
        module: Any = {"tc100": tc100_client, "ck10": ck10_client, "esc11": esc11_client}[device]
        carrier = Carrier(model, draws)
        client = carrier.serve(module.Client(carrier, unit_address=model.STATION, **({"link": link} if link else {})))
    else:
        model = HiwinE(draws, int(name))
        carrier = Carrier(model, draws, model.exchanged)
        client = carrier.serve(getattr(hiwin_client, f"Telegram{name}")(carrier))
    client.servo_on()
    if home and name not in SPEEDS:
        client.home()
    return client, carrier


def arguments(method: Callable[..., Any], counts: float = 1900, slow: bool = True) -> dict[str, Any]:
    """Arguments of a task by the names of its parameters: a place or a distance in counts, and a speed."""
    result: dict[str, Any] = {}
    for name in inspect.signature(method).parameters:
        if name.startswith(("position", "distance", "target")):
            result[name] = counts / 100 if name.endswith("_mm") else round(counts)
        elif name.startswith(("acceleration", "deceleration", "speed_override", "velocity_override", "torque")):
            result[name] = 100.0
        elif name.startswith(("speed", "velocity")):
            unit = 12000.0 if name.endswith("_per_min") else 200 if "ck10" in method.__module__ else 1
            result[name] = unit * (10 if slow else 100)
        elif name.startswith("point_number"):
            result[name] = "bit" not in name or name.endswith("_1")
        elif name.startswith("direction"):
            result[name] = 1
    return result


def outcome(method: Callable[..., Any], **values: Any) -> str:
    """How a task ends: "done", or the name of what it raises."""
    try:
        method(**values)
    except DeviceError as error:
        return type(error).__name__
    return "done"


def jogs(client: Any) -> Callable[..., Any]:
    """The first task of a client that jogs."""
    method: Callable[..., Any] = getattr(client, min(name for name in dir(client) if name.startswith("jog")))
    return method


def reached(carrier: Carrier, kind: str) -> bool:
    """Whether the last command of a kind has come to its end."""
    numbers = [event.number for event in carrier.model.events if event.kind == "accepted" and event.about == kind]
    ends = {event.number for event in carrier.model.events if event.kind == "reached"}
    return bool(numbers) and numbers[-1] in ends


TASKS = {"move_absolute": "absolute", "move_relative": "relative", "home": "home"}


@pytest.mark.parametrize("name", [*FRAMED, *TELEGRAMS])
def test_every_task_is_done_with_a_calm_device(name: str) -> None:
    client, carrier = connected(name)
    for task, kind in TASKS.items():
        method = getattr(client, task)
        assert outcome(method, **arguments(method)) == "done"
        assert reached(carrier, kind)
    jog = jogs(client)
    with jog(**arguments(jog)):
        carrier.pass_time(0.2)
        assert carrier.model.state.velocity
    carrier.pass_time(1.0)
    assert carrier.model.state.velocity == 0
    assert [outcome(client.stop), outcome(client.servo_off)] == ["done", "done"]


@pytest.mark.parametrize("name", FRAMED)
def test_a_position_of_another_station_is_none(name: str) -> None:
    client, carrier = connected(name)
    carrier.line.fates = ["foreign"] * 9
    assert outcome(client.read_position) != "done"


@pytest.mark.parametrize("refusal", ["command error", "alarm", "number alone"])
def test_a_gripper_without_a_home_is_not_done(refusal: str) -> None:
    client, _ = connected("esc11", home=False, refusal=refusal)
    assert outcome(client.move_absolute, **arguments(client.move_absolute)) != "done"


@pytest.mark.parametrize("refusal", ["command error", "alarm", "number alone"])
def test_a_gripper_is_not_done_at_a_place_that_it_cannot_reach(refusal: str) -> None:
    client, _ = connected("esc11", refusal=refusal)
    assert outcome(client.move_absolute, **arguments(client.move_absolute, 90000)) != "done"


@pytest.mark.proof(7)
@pytest.mark.parametrize("name", [*FRAMED, *TELEGRAMS])
@pytest.mark.parametrize("task", TASKS)
def test_what_is_stopped_from_outside_is_not_done(name: str, task: str) -> None:
    client, carrier = connected(name)
    carrier.when(lambda: bool(carrier.model.state.velocity), carrier.model.stop_outside)
    method = getattr(client, task)
    assert outcome(method, **arguments(method)) != "done"


def test_a_point_that_an_emergency_stop_ends_is_not_done() -> None:
    client, carrier = connected("ck10", outside="emergency stop")
    carrier.model.words.update({POINTS + POINT_WORDS + 1: 20000, POINTS + POINT_WORDS + 5: 2000})
    carrier.when(lambda: bool(carrier.model.state.velocity), carrier.model.stop_outside)
    assert [outcome(client.run_point, point_number=1), outcome(client.home)] == ["AlarmError", "AlarmError"]
    assert [outcome(client.reset_alarm), outcome(client.home)] == ["done", "done"]


@pytest.mark.parametrize("name", [*FRAMED, *TELEGRAMS])
@pytest.mark.parametrize("delay", [0.38, 1.0])
@pytest.mark.parametrize("task", TASKS)
def test_what_begins_late_is_not_done_early(name: str, delay: float, task: str) -> None:
    late = {"moving": "from begin", "executing": "from begin", "target reached": "begin", "stopped": "begin"}
    client, carrier = connected(name, **{**late, "homed bit": "falls"})
    carrier.model.draws.delay = delay
    method = getattr(client, task)
    assert outcome(method, **arguments(method)) == "done"
    assert reached(carrier, TASKS[task])


@pytest.mark.parametrize("name", [*TELEGRAMS, *SPEEDS])
def test_the_servo_is_on_at_the_first_try_after_a_quick_stop(name: str) -> None:
    client, _ = connected(name)
    assert outcome(client.quick_stop) == "done"
    assert outcome(client.servo_on, limit=5.0) == "done"


@pytest.mark.parametrize("name", [*FRAMED, *TELEGRAMS])
def test_a_stop_returns_when_the_axis_stands(name: str) -> None:
    client, carrier = connected(name)
    jog = jogs(client)
    motion = jog(**arguments(jog, slow=False))
    motion.__enter__()
    carrier.pass_time(1.0)
    assert outcome(client.stop) == "done"
    assert carrier.model.state.velocity == 0


@pytest.mark.parametrize("name", FRAMED)
def test_a_jog_whose_stop_is_lost_asks_again(name: str) -> None:
    client, carrier = connected(name)
    jog = jogs(client)
    with suppress(NoAnswerError), jog(**arguments(jog)):
        carrier.pass_time(0.5)
        carrier.line.fates = ["lost request"] * 2
    carrier.pass_time(2.0)
    assert carrier.model.state.velocity == 0


@pytest.mark.parametrize("name", [*FRAMED, *TELEGRAMS])
def test_a_task_that_fails_while_the_axis_moves_stops_it_or_says_so(name: str) -> None:
    client, carrier = connected(name)
    carrier.when(lambda: bool(carrier.model.state.velocity), lambda: setattr(carrier.line, "silent", True))
    assert outcome(client.move_absolute, **arguments(client.move_absolute)) == "NoAnswerError"
