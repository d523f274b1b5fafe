"""The generated clients against simulated devices, over pseudo-terminals, TCP and UDP, with faults."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from typing import Any

import pytest
import serial

from fieldspec.testing import SimulatedDevice, simulation
from fieldspec_devices import DeviceError, errors, esc11, hiwin_e, tc100, transports
from fieldspec_devices._client_async import _read_async
from fieldspec_devices.esc11 import client as esc11_client
from fieldspec_devices.hiwin_e import client as hiwin_client
from fieldspec_devices.tc100 import client as tc100_client
from simulators import SPECS


def address(place: str) -> tuple[str, int]:
    """The host and the port of a place."""
    host, _, port = place.rpartition("//")[2].rpartition(":")
    return host, int(port)


@pytest.fixture
def device() -> Iterator[SimulatedDevice]:
    """A TC100 whose time passes ten times as fast, on both of its links."""
    ports = {"rtu": "pty", "ascii": "tcp://127.0.0.1:0"}
    with simulation("tc100", ports=ports, rate=10, folder=SPECS) as running:
        yield running


@pytest.fixture
def client(device: SimulatedDevice) -> Iterator[tc100_client.Client]:
    with serial.Serial(device.places["rtu"], 19200, timeout=0.02) as port:
        client = tc100_client.Client(port, link="rtu", timeout=0.6, settle=0.02)
        client.home()
        yield client


def requests(device: SimulatedDevice) -> list[bytes]:
    """The requests from now on."""
    frames: list[bytes] = []
    device.simulation.listeners.append(
        lambda now, link, way, data, text: frames.append(data) if way == "request" else None
    )
    return frames


def test_registers_have_values_and_quantities(client: tc100_client.Client, device: SimulatedDevice) -> None:
    client.write_in_unit(tc100.PUSH_TORQUE_POSITIVE, 12.5)
    client.write(tc100.HOMING_MODE, tc100.HomingMode.TORQUE_POSITIVE)
    assert client.read(tc100.PUSH_TORQUE_POSITIVE) == 125
    assert client.read_in_unit(tc100.PUSH_TORQUE_POSITIVE) == 12.5
    assert client.read(tc100.HOMING_MODE) is tc100.HomingMode.TORQUE_POSITIVE
    assert device.value("registers/push_torque_positive") == 125


def test_a_record_of_a_table_is_read_and_written(client: tc100_client.Client) -> None:
    point = client.read(tc100.points[3])
    point.torque_limit_percent = 40
    client.write(tc100.points[3], point)
    assert client.read(tc100.points[3]).torque_limit == 400


def test_a_group_is_read_in_as_few_requests_as_the_device_permits(
    client: tc100_client.Client, device: SimulatedDevice
) -> None:
    frames = requests(device)
    values = client.read_group(tc100_client.STATUS)
    assert values[tc100.ENCODER_POSITION] == 0
    assert values.in_unit(tc100.MOTOR_CURRENT) == 0.0
    assert len(values) > 30
    assert len(frames) < 10


def test_a_refused_register_costs_no_other(client: tc100_client.Client, device: SimulatedDevice) -> None:
    del device.simulation.engine.memory.occupants["", 0x1005]
    values = client.read_group(tc100_client.STATUS)
    assert values[tc100.ENCODER_POSITION] == 0
    assert values.refused["alarm"].number == 2
    with pytest.raises(errors.RefusedError, match="illegal_data_address"):
        values[tc100.ALARM]


TASKS: list[tuple[str, dict[str, Any], str, Any]] = [
    ("servo_off", {}, "servo_state", 0),
    ("home", {}, "axis/homed", True),
    ("move_absolute", {"position": 700, "speed": 50}, "actual_position", 700),
    ("stop", {}, "busy", 0),
    ("save", {}, "busy", 0),
]


@pytest.mark.parametrize(("name", "arguments", "signal", "expected"), TASKS, ids=[task[0] for task in TASKS])
def test_a_task_brings_the_device_where_it_says(
    client: tc100_client.Client,
    device: SimulatedDevice,
    name: str,
    arguments: dict[str, Any],
    signal: str,
    expected: Any,
) -> None:
    getattr(client, name)(**arguments)
    assert device.value(signal) == expected


def test_a_point_is_run_and_its_start_is_taken_back(client: tc100_client.Client, device: SimulatedDevice) -> None:
    point = client.read(tc100.points[1])
    point.mode, point.position = tc100.PointMode.ABSOLUTE_MOVE, 9000
    # Long enough that a client on a busy machine sees the axis move.
    point.speed = 1
    client.write(tc100.points[1], point)
    client.run_point(point_number=1)
    assert client.read_position() == 9000
    assert not client.read(tc100.SIMULATED_INPUTS).simulated_input_4


def test_a_point_that_no_bits_can_have_is_refused_before_anything_is_written(client: tc100_client.Client) -> None:
    with pytest.raises(errors.InvalidValueError, match=r"128 is not in 0\.\.127"):
        client.run_point(point_number=128)


def test_a_failed_point_takes_its_start_back(client: tc100_client.Client, device: SimulatedDevice) -> None:
    with pytest.raises(errors.TimeLimitError, match="action_status is still"):
        client.run_point(point_number=1, limit=0.3)
    assert not client.read(tc100.SIMULATED_INPUTS).simulated_input_4


def test_a_jog_ends_with_its_block_whatever_happens(client: tc100_client.Client, device: SimulatedDevice) -> None:
    def work() -> None:
        with client.jog_positive(speed=5) as jog:
            jog.check()
            assert device.value("axis/moving")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        work()
    client.session.settle = 0.3
    client.stop()
    assert not device.value("axis/moving")


REFUSALS: list[tuple[type[Exception], dict[str, Any], Callable[[Any], Any]]] = [
    (errors.AlarmError, {"alarm_code": "overcurrent"}, lambda client: client.home()),
    (errors.ServoOffError, {"servo_enable": 1}, lambda client: client.home()),
    (errors.InvalidValueError, {}, lambda client: client.move_absolute(position=1, speed=101)),
    (errors.InvalidValueError, {}, lambda client: client.write(tc100.ALARM, tc100.AlarmCode.NO_ALARM)),
    (errors.InvalidValueError, {}, lambda client: client.write_in_unit(tc100.PUSH_TORQUE_POSITIVE, 101)),
]


@pytest.mark.parametrize(("kind", "signals", "call"), REFUSALS)
def test_what_must_not_be_done_is_not_sent(
    client: tc100_client.Client,
    device: SimulatedDevice,
    kind: type[Exception],
    signals: dict[str, Any],
    call: Callable[[Any], Any],
) -> None:
    device.set(**signals)
    frames = requests(device)
    with pytest.raises(kind) as error:
        call(client)
    assert isinstance(error.value, DeviceError)
    assert not [frame for frame in frames if frame[1] != 3]


FAULTS = ("no_answer", "wrong_checksum", "truncated", "garbage", "wrong_unit", "inserted_word", "late_answer", "busy")


@pytest.mark.proof(4)
@pytest.mark.parametrize("kind", FAULTS)
def test_a_fault_never_gives_a_wrong_value(client: tc100_client.Client, device: SimulatedDevice, kind: str) -> None:
    details = {"seconds": 8.0} if kind == "late_answer" else {}
    torque = client.read(tc100.HOMING_TORQUE_LIMIT)
    device.fault(kind, **details)
    try:
        assert client.read(tc100.HOMING_TORQUE_LIMIT) == torque
    except errors.RefusedError:
        assert kind == "busy"
    assert client.read(tc100.MOTION_SPEED) == 100
    assert client.read(tc100.ALARM) == 0


def test_an_answer_that_comes_too_late_is_not_taken_for_that_to_another_request(
    client: tc100_client.Client, device: SimulatedDevice
) -> None:
    client.session.retries = 0
    device.fault("late_answer", seconds=8.0)
    with pytest.raises(errors.NoAnswerError):
        client.read(tc100.MOTION_SPEED)
    assert client.read(tc100.ALARM) == tc100.AlarmCode.NO_ALARM


def test_a_write_is_sent_once(client: tc100_client.Client, device: SimulatedDevice) -> None:
    frames = requests(device)
    device.fault("no_answer")
    with pytest.raises(errors.NoAnswerError):
        client.write(tc100.MOTION_SPEED, 7)
    assert len(frames) == 1


def test_a_lost_connection_is_a_transport_error(device: SimulatedDevice) -> None:
    with transports.tcp(*address(device.places["ascii"])) as transport:
        client = tc100_client.Client(transport, link="ascii", timeout=0.6)
        assert client.read(tc100.MOTION_SPEED) == 100
        device.fault("connection_lost")
        with pytest.raises(errors.TransportError, match="closed"):
            client.read(tc100.MOTION_SPEED)


def test_a_transport_that_waits_for_ever_is_refused(device: SimulatedDevice) -> None:
    with serial.Serial(device.places["rtu"], 19200) as port, pytest.raises(ValueError, match="time-out"):
        tc100_client.Client(port)


def test_the_same_work_is_awaited(device: SimulatedDevice) -> None:
    async def work() -> list[Any]:
        async with await transports.async_tcp(*address(device.places["ascii"])) as transport:
            client = tc100_client.AsyncClient(transport, link="ascii", timeout=0.6, settle=0.02)
            await client.home()
            await client.move_absolute(position=300, speed=50)
            values = await client.read_group(tc100_client.STATUS)
            async with client.jog_negative(speed=5) as jog:
                await jog.check()
            device.fault("no_answer")
            return [await client.read_position(), values[tc100.SERVO_ON], await client.read(tc100.SERVO_ON)]

    _, before, after = asyncio.run(work())
    assert before is after is True


def test_a_cancelled_point_takes_its_start_back(device: SimulatedDevice) -> None:
    async def work() -> bool:
        async with await transports.async_tcp(*address(device.places["ascii"])) as transport:
            client = tc100_client.AsyncClient(transport, link="ascii", timeout=0.6, settle=0.1)
            await client.home()
            with pytest.raises(asyncio.TimeoutError):
                await asyncio.wait_for(client.run_point(point_number=1), 0.5)
            return (await client.read(tc100.SIMULATED_INPUTS)).simulated_input_4

    assert asyncio.run(work()) is False


def test_packets_have_tasks_messages_and_parameters() -> None:
    with simulation("esc11", rate=5, folder=SPECS) as device, serial.Serial(device.place, 19200, timeout=0.02) as port:
        client = esc11_client.Client(port, settle=0.1, pause=0.0)
        client.servo_on()
        client.home()
        client.move_absolute(position_mm=12.5, speed=50)
        assert client.read_position() == 12.5
        assert not client.ask(esc11.NoOperationRequest()).status.executing
        client.write_parameter_in_unit(esc11.parameters.POSITIVE_SOFT_LIMIT, 30)
        assert client.ask(esc11.ReadParametersRequest(), retries=1).message.parameters[1] == 300
        with client.jog_open(speed=10):
            assert device.value("axis/moving")
        device.set(**{"messages/read_alarm_code/response/alarm_code": 1})
        with pytest.raises(errors.AlarmError):
            client.move_absolute(position_mm=5, speed=50)


def test_a_gripper_closes_and_opens() -> None:
    with simulation("esc11", rate=5, folder=SPECS) as device, serial.Serial(device.place, 19200, timeout=0.02) as port:
        client = esc11_client.Client(port, settle=0.1, pause=0.0)
        client.servo_on()
        client.home()
        client.move_absolute(position_mm=10, speed=100)
        client.grip(speed=100, force=70)
        closed = client.read_position()
        client.release(speed=100)
        assert closed < 10 < client.read_position()


def test_telegrams_have_tasks_and_parameters_their_channel() -> None:
    ports = {"cyclic": "udp://127.0.0.1:0", "parameter_channel": "udp://127.0.0.1:0"}
    with simulation("hiwin-e", ports=ports, message="telegram_111", rate=20, folder=SPECS) as device:
        with transports.udp(*address(device.places["parameter_channel"])) as transport:
            client = hiwin_client.Client(transport)
            assert client.read_firmware_version() == 200
            assert len(client.read_alarm()) == 64
            with pytest.raises(errors.RefusedError):
                client.read_elements(hiwin_e.profidrive_parameters.ALARM_CODES, 0, 65)
        with transports.udp(*address(device.places["cyclic"])) as transport:
            axis = hiwin_client.Telegram111(transport, settle=0.1, cycle=0.002)
            with pytest.raises(errors.ServoOffError):
                axis.home()
            axis.servo_on()
            axis.home()
            axis.move_absolute(
                position=1000,
                speed_control_unit_per_min=600000,
                acceleration_percent=100,
                deceleration_percent=100,
                speed_override_percent=100,
            )
            assert axis.read_position() == 1000
            assert not axis.request.control_word_1.raw & 0x40
            with axis.jog_positive():
                axis.run(0.02)
                assert device.value("axis/moving")
            axis.run(0.3)
            assert not device.value("axis/moving")


def test_a_task_that_is_cancelled_while_bytes_come_ends() -> None:
    class Transport:
        """Cancels the task that reads from it, at the moment at which a byte comes."""

        async def read(self, size: int) -> bytes:
            loop = asyncio.get_running_loop()
            byte: asyncio.Future[bytes] = loop.create_future()
            loop.call_later(0.01, lambda: (byte.set_result(b"x"), task.cancel()))
            return await byte

        async def write(self, data: bytes) -> None:
            """Sends nothing."""

    async def is_cancelled() -> bool:
        nonlocal task
        task = asyncio.ensure_future(_read_async(Transport(), 1, 1.0))
        await asyncio.wait({task})
        return task.cancelled()

    task: asyncio.Future[bytes]
    assert asyncio.run(is_cancelled())
