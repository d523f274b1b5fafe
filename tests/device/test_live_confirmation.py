"""What starts, energizes or releases something is written only when a person agrees; and what an exception proves."""

from __future__ import annotations

import io
import json
import socket
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

from fieldspec.cli import main
from fieldspec.codec.explain.hazards import COMMANDING, write_hazards
from fieldspec.language.model.value import UNSPECIFIED
from fieldspec.testing import SimulatedDevice
from simulators import SPECS

HARMLESS = {
    *("ready", "servo_state", "homing_mode", "homing_done", "move_mode", "target_position", "target_distance"),
    *("target_speed", "target_acceleration", "target_deceleration", "torque_limit", "torque_reduction"),
    *("command_accepted", "busy", "in_position", "speed_reached", "done", "jog_direction", "jog_speed"),
    *("point_number", "point_active", "actual_position", "actual_speed", "actual_torque", "alarm_present"),
    *("command_position", "standstill", "switch_on_inhibited"),
    *("alarm_code", "fault_code", "warning_present", "warning_code", "firmware_version", "serial_number"),
}
"""The roles of what is set before something begins, and of what a device says."""
STOPPING = {"stop", "quick_stop"}
"""A stop waits for no answer of a person."""


def schema_roles() -> set[str]:
    path = Path(SPECS).parent / "codegen" / "fieldspec" / "language" / "schema" / "spec.schema.json"
    return set(json.loads(path.read_text("utf-8"))["$defs"]["role"]["enum"])


def live(place: str, *arguments: str) -> int:
    place = place.replace("tcp://", "socket://")
    return main(["live", "tc100", *arguments, "--link", "rtu", "--port", place, "--timeout", "0.5", "--specs", SPECS])


def test_every_role_says_whether_writing_it_commands_the_device() -> None:
    assert schema_roles() == COMMANDING.keys() | HARMLESS | STOPPING


@pytest.mark.parametrize("role", sorted(schema_roles()))
def test_a_write_has_a_hazard_if_its_role_commands_the_device(role: str) -> None:
    hazards = list(write_hazards(trigger=False, access="rw", restart=None, handlings=(UNSPECIFIED,), roles=(role,)))
    assert bool(hazards) == (role in COMMANDING)


@pytest.mark.parametrize("state", ["servo_on", "servo_off"])
def test_the_servo_is_not_switched_where_nobody_can_agree(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, state: str
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO())
    requests: list[bytes] = []
    tc100.simulation.listeners.append(lambda now, link, way, data, text: requests.append(data))
    assert live(tc100.place, "write", f"servo={state}") == 2
    error = capsys.readouterr().err
    assert "servo: it energizes the motor, or releases what the motor holds" in error
    assert "confirm the list above with --yes" in error
    assert requests == []


def test_the_servo_is_switched_when_a_person_agrees(tc100: SimulatedDevice) -> None:
    assert live(tc100.place, "write", "servo=servo_off", "--yes") == 0
    assert tc100.value("registers/servo") == 1


@pytest.fixture
def failing_device() -> Iterator[tuple[str, list[int]]]:
    """A Modbus RTU device that stores a value and then answers exception 4, `server device failure`.

    The standard says of that exception that an error occurred while the server attempted to perform the action.
    """
    stored: list[int] = []
    with socket.create_server(("127.0.0.1", 0)) as server:

        def serve() -> None:
            connection, _ = server.accept()
            with connection:
                while request := connection.recv(256):
                    if request[1] == 6:
                        stored.append(int.from_bytes(request[4:6], "big"))
                        connection.sendall(with_crc(bytes([request[0], 0x86, 4])))
                    else:
                        words = int.from_bytes(request[4:6], "big")
                        content = b"".join(value.to_bytes(2, "big") for value in [*stored[-1:], *([0] * words)][:words])
                        connection.sendall(with_crc(bytes([request[0], request[1], len(content)]) + content))

        thread = threading.Thread(target=serve, daemon=True)
        thread.start()
        yield f"tcp://127.0.0.1:{server.getsockname()[1]}", stored


def with_crc(data: bytes) -> bytes:
    """A frame with the CRC of the standard for Modbus over serial lines."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xA001 if crc & 1 else 0)
    return data + crc.to_bytes(2, "little")


def test_an_exception_that_the_spec_does_not_list_proves_nothing_of_a_write(
    failing_device: tuple[str, list[int]], capsys: pytest.CaptureFixture[str]
) -> None:
    place, stored = failing_device
    assert live(place, "write", "motion_speed=50%", "--any-version") == 1
    assert stored == [50]
    error = capsys.readouterr().err
    assert "motion_speed may be written or not: exception 4, which the spec does not list" in error


def test_after_such_an_exception_a_restore_asks_the_device(
    failing_device: tuple[str, list[int]], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    place, stored = failing_device
    settings = tmp_path / "settings.csv"
    settings.write_text("Name,Value\nmotion_speed,50\n", "utf-8")
    assert live(place, "restore", str(settings), "--yes", "--any-version") == 0
    assert stored == [50]
    assert "1 value written and verified" in capsys.readouterr().err
