"""Tasks of generated clients return only where the device shows that it is where it was sent, and stop it otherwise."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import AbstractContextManager
from time import sleep

import pytest
import serial

from fieldspec.testing import SimulatedDevice, simulation
from fieldspec_devices import errors, transports
from fieldspec_devices.esc11 import client as esc11_client
from fieldspec_devices.hiwin_e import client as hiwin_client
from fieldspec_devices.tc100 import client as tc100_client
from simulators import SPECS


@pytest.fixture
def gripper() -> Iterator[tuple[esc11_client.Client, SimulatedDevice]]:
    with simulation("esc11", rate=5, folder=SPECS) as device, serial.Serial(device.place, 9600, timeout=0.02) as port:
        client = esc11_client.Client(port, settle=0.1, pause=0.0, begin=1.0)
        client.servo_on()
        yield client, device


@pytest.fixture
def slider() -> Iterator[tuple[tc100_client.Client, SimulatedDevice]]:
    with simulation("tc100", rate=5, folder=SPECS) as device, serial.Serial(device.place, 19200, timeout=0.02) as port:
        client = tc100_client.Client(port, timeout=0.6, settle=0.02, begin=1.0)
        client.servo_on()
        yield client, device


def drive() -> AbstractContextManager[SimulatedDevice]:
    """A drive with telegram 111."""
    return simulation("hiwin-e", ports={"cyclic": "udp://127.0.0.1:0"}, message="telegram_111", rate=5, folder=SPECS)


def test_a_gripper_that_has_not_homed_is_not_where_it_was_sent(
    gripper: tuple[esc11_client.Client, SimulatedDevice],
) -> None:
    client, device = gripper
    with pytest.raises(errors.NotReadyError, match="homing_complete"):
        client.move_absolute(position_mm=5, speed=50)
    assert not device.value("axis/moving")


def test_a_move_that_ends_at_a_soft_limit_has_not_reached_its_target(
    gripper: tuple[esc11_client.Client, SimulatedDevice],
) -> None:
    client, _ = gripper
    client.home()
    with pytest.raises(errors.MotionError, match="position is 2000, not 90000"):
        client.move_absolute(position_mm=900, speed=100)


def test_a_gripper_reaches_targets_that_are_absolute_and_relative(
    gripper: tuple[esc11_client.Client, SimulatedDevice],
) -> None:
    client, device = gripper
    client.home()
    client.move_absolute(position_mm=5, speed=100)
    client.move_relative(distance_mm=-1.5, speed=100)
    assert device.value("axis/position") == 350


def test_a_homing_that_is_stopped_from_outside_is_no_homing(
    slider: tuple[tc100_client.Client, SimulatedDevice],
) -> None:
    client, device = slider
    stopping = threading.Timer(0.15, lambda: device.simulation.engine.axis.halt(device.simulation.now()))
    stopping.start()
    with pytest.raises(errors.TimeLimitError, match="output_1"):
        client.home(limit=2.0)
    stopping.join()


def test_a_time_that_is_over_stops_the_axis(slider: tuple[tc100_client.Client, SimulatedDevice]) -> None:
    client, device = slider
    client.home()
    with pytest.raises(errors.TimeLimitError):
        client.move_absolute(position=90000, speed=5, limit=0.3)
    sleep(0.3)
    assert not device.value("axis/moving")


def test_the_servo_comes_on_at_once_after_a_quick_stop() -> None:
    with drive() as device:
        host, _, port = device.places["cyclic"].rpartition("//")[2].rpartition(":")
        with transports.udp(host, int(port)) as transport:
            client = hiwin_client.Telegram111(transport, settle=0.05)
            client.servo_on()
            client.quick_stop()
            client.servo_on(limit=2.0)
            assert device.value("state/drive") == "operation"


def test_a_servo_that_is_on_keeps_its_power() -> None:
    with drive() as device:
        host, _, port = device.places["cyclic"].rpartition("//")[2].rpartition(":")
        with transports.udp(host, int(port)) as transport:
            client = hiwin_client.Telegram111(transport, settle=0.05)
            client.servo_on()
            with client.jog_positive():
                client.servo_on()
                assert device.value("axis/moving")
                assert device.value("state/drive") == "operation"
