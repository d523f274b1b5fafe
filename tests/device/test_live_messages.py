"""The verbs of `fieldspec live` on devices without registers, and what is looked at before anything is written."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.command.live.connection import links_that_read
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.lists.dump import dump
from fieldspec.tools.lists.text_sheet import text_sheet
from fieldspec.tools.live.reading import message_for
from fieldspec.tools.simulator.seeding import seed
from layouts import TEST_SPECS, newest
from simulators import SPECS

TEST_FOLDER = str(TEST_SPECS)


def live(name: str, place: str, *arguments: str, folder: str = SPECS) -> int:
    """The exit code of a verb."""
    port = place.replace("tcp://", "socket://") if name == "esc11" else place
    return main(["live", name, *arguments, "--port", port, "--timeout", "0.5", "--pause", "0", "--specs", folder])


MESSAGES = [
    ("widget", "", "read_registers read_registers", "write_register write_registers"),
    ("weigher", "", "read_registers read_registers", "write_registers write_registers"),
    ("flowmeter", "memory", "read_memory read_memory", "write_memory write_memory"),
    ("meter", "coils", "read_coils read_coils", "none none"),
    ("meter", "holding_registers", "read_holding_registers read_holding_registers", "write_holding_register none"),
]


@pytest.mark.parametrize(("device", "space", "reads", "writes"), MESSAGES)
def test_one_word_and_two_have_the_messages_that_can_carry_them(
    device: str, space: str, reads: str, writes: str
) -> None:
    for operation, expected in (("read", reads), ("write", writes)):
        layout = newest(TEST_SPECS, device)
        link = layout.links[links_that_read(layout)[0]]
        messages = [message_for(layout.device, link, operation, space, words) for words in (1, 2)]
        assert " ".join(message.name if message is not None else "none" for message in messages) == expected


@pytest.fixture
def gripper() -> Iterator[SimulatedDevice]:
    with simulation("esc11", ports={"serial": "tcp://127.0.0.1:0"}, rate=20, folder=SPECS) as device:
        yield device


@pytest.fixture
def drive() -> Iterator[SimulatedDevice]:
    ports = {"cyclic": "udp://127.0.0.1:0", "parameter_channel": "udp://127.0.0.1:0"}
    with simulation("hiwin-e", ports=ports, folder=SPECS) as device:
        yield device


def rows(capsys: pytest.CaptureFixture[str]) -> dict[str, Any]:
    """What a verb has printed as JSON, by name."""
    return {row["name"]: row for row in json.loads(capsys.readouterr().out)}


def test_parameters_and_answers_are_read_by_name_role_and_printed_name(
    gripper: SimulatedDevice, drive: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    assert (
        live("esc11", gripper.place, "read", "actual_position", "positive_soft_limit", "busy", "--format", "json") == 0
    )
    values = rows(capsys)
    assert values["read_current_position.position"]["meaning"] == "0.00 mm"
    assert values["positive_soft_limit"]["value"] == 200
    assert values["status"]["value"] == 0
    channel = drive.places["parameter_channel"]
    assert live("hiwin-e", channel, "read", "firmware_version", "Pt533", "--format", "json") == 0
    values = rows(capsys)
    assert values["drive_identification.firmware_version"]["value"] == 200
    assert values["point_to_point_speed_rotary"]["meaning"].endswith("rpm")


def test_everything_that_only_asks_is_read_without_names(
    gripper: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    requests: list[bytes] = []
    gripper.simulation.listeners.append(
        lambda now, link, way, data, text: requests.append(data) if way == "request" else None
    )
    assert live("esc11", gripper.place, "read", "--format", "json") == 0
    assert len(rows(capsys)) > 20
    assert all(0x40 <= frame[2] < 0x60 for frame in requests)


def test_a_parameter_is_written_and_read_back(gripper: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    assert live("esc11", gripper.place, "write", "positive_soft_limit=30mm", "--yes") == 0
    assert "positive_soft_limit: 300 30.0 mm" in capsys.readouterr().out
    assert live("esc11", "x", "write", "positive_soft_limit=30mm", "--dry-run") == 0
    assert capsys.readouterr().out == "positive_soft_limit: 07 00 62 01 2C 01 97\n"


def test_a_servo_that_is_on_is_named_before_a_write(
    gripper: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    assert live("esc11", gripper.place, "write", "positive_soft_limit=30mm", "--yes") == 0
    assert "the servo is on: read_motor_excitation.excited is 1\n" in capsys.readouterr().err


def test_a_value_that_the_drive_refuses_is_told(drive: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    channel = drive.places["parameter_channel"]
    drive.fault("exception", reason="not_now")
    live("hiwin-e", channel, "read", "Pt533")
    assert "refused: exception" in capsys.readouterr().out


def place_of(name: str, gripper: SimulatedDevice, drive: SimulatedDevice) -> str:
    """Where the parameters of a device are read."""
    return gripper.place if name == "esc11" else drive.places["parameter_channel"]


@pytest.mark.parametrize(("name", "path", "raw"), [("esc11", "positive_soft_limit", 300), ("hiwin-e", "Pt533", 123)])
def test_parameters_are_backed_up_compared_and_restored(
    gripper: SimulatedDevice,
    drive: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    name: str,
    path: str,
    raw: int,
) -> None:
    place, file = place_of(name, gripper, drive), str(tmp_path / "settings.csv")
    assert live(name, place, "backup", file) == 0
    assert live(name, place, "write", f"{path}={raw}", "--yes") == 0
    assert live(name, place, "compare", file, "--format", "json") == 1
    capsys.readouterr()
    assert live(name, place, "restore", file, "--dry-run") == 0
    assert "1 of " in capsys.readouterr().err
    assert live(name, place, "restore", file, "--yes") == 0
    assert "1 value written and verified" in capsys.readouterr().err
    assert live(name, place, "compare", file) == 0
    assert not Path(f"{file}.journal").exists()


@pytest.fixture
def widget() -> Iterator[SimulatedDevice]:
    with simulation("widget", ports={"rtu": "tcp://127.0.0.1:0"}, folder=TEST_FOLDER) as device:
        yield device


def test_a_link_with_registers_and_parameters_reads_both(
    widget: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    assert live("widget", widget.place, "read", "--format", "json", folder=TEST_FOLDER) == 0
    values = rows(capsys)
    assert (values["lamp"]["address"], values["lamp"]["meaning"]) == (0x2000, "green")
    assert (values["stroke"]["number"], values["stroke"]["meaning"]) == (1, "12.5 mm")
    assert live("widget", widget.place, "read", "stroke", "lamp", folder=TEST_FOLDER) == 0
    assert capsys.readouterr().out.splitlines()[:2] == [
        "name    number or address  value  meaning",
        "stroke  1                  125    12.5 mm",
    ]


def test_a_parameter_with_the_name_of_a_register_is_named_and_not_read(
    capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    for part in ("widget", "protocols"):
        shutil.copytree(TEST_SPECS / part, tmp_path / part)
    file = tmp_path / "widget" / "registers.yaml"
    file.write_text(file.read_text(encoding="utf-8").replace("name: stroke,", "name: lamp,"), encoding="utf-8")
    with simulation("widget", ports={"rtu": "tcp://127.0.0.1:0"}, folder=str(tmp_path)) as device:
        assert live("widget", device.place, "read", "lamp", "--format", "json", folder=str(tmp_path)) == 0
    output = capsys.readouterr()
    assert [row["address"] for row in json.loads(output.out)] == [0x2000]
    assert "widget: not read, as registers have their names: lamp" in output.err


def test_a_backup_of_registers_and_parameters_is_restored(
    widget: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    file = str(tmp_path / "backup.csv")
    runs = (
        ["backup", file],
        ["write", "stroke=20mm", "lamp=blue", "--yes"],
        ["restore", file, "--yes"],
        ["read", "stroke", "lamp", "--format", "json"],
    )
    for run in runs:
        capsys.readouterr()
        assert live("widget", widget.place, *run, folder=TEST_FOLDER) == 0
    values = rows(capsys)
    assert (values["stroke"]["value"], values["lamp"]["value"]) == (125, 1)


def test_a_dump_of_registers_and_parameters_is_what_another_device_begins_with(
    widget: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    file = tmp_path / "dump.csv"
    assert live("widget", widget.place, "write", "stroke=20mm", "lamp=blue", "--yes", folder=TEST_FOLDER) == 0
    assert live("widget", widget.place, "dump", str(file), folder=TEST_FOLDER) == 0
    with simulation("widget", ports={"rtu": "tcp://127.0.0.1:0"}, folder=TEST_FOLDER) as other:
        _, unused = seed(other.simulation.engine, dump(text_sheet(file.read_bytes(), ""), {}))
        assert unused == 0
        capsys.readouterr()
        live("widget", other.place, "read", "stroke", "lamp", "--format", "json", folder=TEST_FOLDER)
    values = rows(capsys)
    assert (values["stroke"]["value"], values["lamp"]["value"]) == (200, 5)


def test_a_dump_of_parameters_is_what_another_device_begins_with(
    drive: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    channel, file = drive.places["parameter_channel"], tmp_path / "dump.csv"
    assert live("hiwin-e", channel, "write", "Pt533=4711", "--yes") == 0
    assert live("hiwin-e", channel, "dump", str(file)) == 0
    assert main(["audit", "hiwin-e", "--dump", str(file), "--table", "values", "--specs", SPECS]) in (0, 1)
    assert "4711" in capsys.readouterr().out
    with simulation("hiwin-e", ports={"parameter_channel": "udp://127.0.0.1:0"}, folder=SPECS) as other:
        count, unused = seed(other.simulation.engine, dump(text_sheet(file.read_bytes(), ""), {}))
        assert (count > 60, unused) == (True, 0)
        capsys.readouterr()
        live("hiwin-e", other.place, "read", "Pt533", "--format", "json")
    assert rows(capsys)["point_to_point_speed_rotary"]["value"] == 4711


def test_a_scan_of_parameters_finds_what_the_spec_does_not_have(
    drive: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    drive.simulation.engine.memory.elements["drive_parameters", 0x3FF, 0] = 7
    channel = drive.places["parameter_channel"]
    assert live("hiwin-e", channel, "scan", "0x3B0..0x3C0", "pnu:0x2215", "--format", "json") == 0
    (space,) = json.loads(capsys.readouterr().out)["spaces"]
    assert space["unknown"] == []
    assert len(space["refused"]) > 5


@pytest.mark.parametrize(
    ("name", "arguments", "expected"),
    [
        ("esc11", ["points", "upload", "x"], "esc11 has no record table; `backup` and `restore` are for its settings"),
        ("esc11", ["read", "nonsense"], "there is no value nonsense"),
        ("esc11", ["write", "status=1"], "only parameters are written"),
        ("esc11", ["write", "positive_soft_limit=1 km"], "positive_soft_limit"),
        ("esc11", ["write", "positive_soft_limit=5"], "confirm the list above with --yes"),
        ("hiwin-e", ["read", "--link", "cyclic"], "nothing on cyclic only asks"),
        ("hiwin-e", ["write", "alarm_codes[0]=1"], "not written by itself"),
    ],
)
def test_wrong_use_writes_nothing(
    gripper: SimulatedDevice,
    drive: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    name: str,
    arguments: list[str],
    expected: str,
) -> None:
    monkeypatch.setattr("sys.stdin", open("/dev/null", encoding="utf-8"))  # noqa: SIM115
    place = gripper.place if name == "esc11" else drive.places["parameter_channel"]
    assert live(name, place, *arguments) == 2
    assert expected in capsys.readouterr().err


@pytest.mark.parametrize(
    ("version", "options", "code", "expected"),
    [
        ("2", [], 0, ""),
        ("1", [], 1, "the firmware 512 of the device is 2, and the verb is for 1; nothing is written: say wattmeter@2"),
        ("1", ["--any-version"], 1, "ratio is not written: exception 3, illegal_data_value"),
    ],
)
def test_another_firmware_stops_before_a_write(
    capsys: pytest.CaptureFixture[str], version: str, options: list[str], code: int, expected: str
) -> None:
    folder = str(TEST_SPECS)
    with simulation("wattmeter@2", ports={"tcp": "tcp://127.0.0.1:0"}, folder=folder) as meter:
        meter.set(**{"registers/firmware": 0x0200})
        own = ["--link", "tcp", "--unit", "1", *options]
        assert live(f"wattmeter@{version}", meter.place, "write", "ratio=5", *own, folder=folder) == code
    assert expected in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ([], "in registers/firmware, and the verb is for 2; nothing is written: see what the manual says of it, or"),
        (
            ["--any-version"],
            "wattmeter: the device does not say its firmware in registers/firmware, and the verb is for 2",
        ),
    ],
)
def test_a_device_that_does_not_say_its_firmware_stops_before_a_write(
    capsys: pytest.CaptureFixture[str], options: list[str], expected: str
) -> None:
    folder = str(TEST_SPECS)
    with simulation("wattmeter@2", ports={"tcp": "tcp://127.0.0.1:0"}, folder=folder) as meter:
        meter.fault("exception", reason="unknown_address", probability=1)
        own = ["--link", "tcp", "--unit", "1", *options]
        assert live("wattmeter@2", meter.place, "write", "ratio=5", *own, folder=folder) == 1
    text = capsys.readouterr().err
    assert expected in text
    assert ("ratio is not written" in text) == bool(options)


def test_what_the_device_is_doing_is_said_before_something_is_started(capsys: pytest.CaptureFixture[str]) -> None:
    with simulation("tc100", ports={"ascii": "tcp://127.0.0.1:0"}, folder=SPECS) as device:
        place = device.place.replace("tcp://", "socket://")
        assert live("tc100", place, "write", "motion_command=homing", "--yes") == 0
    assert "the servo is on" in capsys.readouterr().err
