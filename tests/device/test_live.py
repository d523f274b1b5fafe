"""The verbs of `fieldspec live` against simulated devices, with faults."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from simulators import SPECS


@pytest.fixture
def tc100() -> Iterator[SimulatedDevice]:
    with simulation("tc100", ports={"ascii": "tcp://127.0.0.1:0"}, folder=SPECS) as device:
        yield device


def live(device: SimulatedDevice, *arguments: str, name: str = "tc100") -> int:
    """The exit code of a verb."""
    place = device.place.replace("tcp://", "socket://")
    return main(["live", name, *arguments, "--port", place, "--timeout", "0.5", "--specs", SPECS])


def read_json(device: SimulatedDevice, capsys: pytest.CaptureFixture[str], *names: str) -> dict[str, Any]:
    """Values by name."""
    capsys.readouterr()
    live(device, "read", *names, "--format", "json")
    return {row["name"]: row for row in json.loads(capsys.readouterr().out)}


def test_values_are_read_by_name_role_and_address(tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    rows = read_json(tc100, capsys, "actual_position", "servo_on", "0x2014", "points[2].mode")
    assert rows["encoder_position"]["words"] == [0, 5000]
    assert rows["servo_on"]["value"] is True
    assert rows["motion_speed"]["meaning"] == "100 %"
    assert rows["points[2].mode"]["meaning"] == "relative_move"


def test_the_settings_of_an_exchange_are_printed(tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    for more, expected in (
        ((), "tc100: link ascii, unit address 1\n"),
        (("--unit", "1"), "tc100: link ascii, unit address 1\n"),
        (("--format", "json"), ""),
    ):
        assert live(tc100, "read", "alarm", *more) == 0
        assert capsys.readouterr().err == expected


def test_everything_is_read_in_blocks(tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    requests: list[bytes] = []
    tc100.simulation.listeners.append(
        lambda now, link, way, data, text: requests.append(data) if way == "request" else None
    )
    rows = read_json(tc100, capsys)
    assert len(rows) > 1400
    assert len(requests) < 170  # a hole follows each of the 127 points
    assert not any(row["refused"] for row in rows.values())


def test_a_refused_value_costs_no_other(tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    for address in (0x1005,):
        del tc100.simulation.engine.memory.occupants["", address]
    rows = read_json(tc100, capsys, "alarm", "motor_speed", "torque_limit_reached")
    assert rows["alarm"]["refused"] == "exception 2, illegal_data_address"
    assert rows["motor_speed"]["value"] == 0
    assert rows["torque_limit_reached"]["value"] is False


def test_a_write_is_read_back(tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    assert live(tc100, "write", "push_torque_positive=12.5%", "absolute_position=-7") == 0
    assert "push_torque_positive: 125 12.5 %" in capsys.readouterr().out
    assert tc100.value("target_position") == -7


def test_a_write_that_the_device_does_not_take_over_is_told(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    tc100.fault("stuck_bit", signal="registers/motion_speed", value=3)
    assert live(tc100, "write", "motion_speed=50%") == 1
    assert "the device holds 3" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["read", "motion_sped"], "did you mean motion_speed?"),
        (["write"], "name what to write"),
        (["write", "motion_speed"], "has no value; write motion_speed=VALUE"),
        (["write", "points[1]=5"], "`points[1]` is the name of 11 values"),
        (["write", "motion_speed=101%"], "out_of_range"),
        (["write", "motion_speed=fast"], "`fast` is not a number"),
        (["write", "action_status=1"], "can only be read"),
        (["write", "points[1].reserved_5=1"], "is reserved"),
        (["write", "motion_command=homing"], "confirm the list above with --yes"),
        (["write", "motion_speed=5", "motion_command=homing"], "confirm the list above with --yes"),
        (["watch"], "name what to watch"),
        (["dump"], "name one file"),
        (["scan", "0x1000..0x0FFF"], "is not an address range up to 0xFFFF"),
        (["scan", "x:1..5"], "names a space, and the device declares none"),
        (["read", "alarm", "--unit", "17"], "17 is not in 1..16"),
        (["read", "alarm", "--link", "usb"], "there is no link usb"),
    ],
)
def test_wrong_use_writes_nothing(
    tc100: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    expected: str,
) -> None:
    monkeypatch.setattr("sys.stdin", open("/dev/null", encoding="utf-8"))  # noqa: SIM115
    requests: list[bytes] = []
    tc100.simulation.listeners.append(lambda now, link, way, data, text: requests.append(data))
    assert live(tc100, *arguments) == 2
    assert expected in capsys.readouterr().err
    assert requests == []


def test_a_dry_run_shows_the_frame_and_needs_no_device(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["live", "tc100", "write", "servo=servo_off", "--dry-run", "--specs", SPECS]) == 0
    assert capsys.readouterr().out == f"servo: {b':010620110001C7'.hex(' ').upper()} 0D 0A\n"


@pytest.mark.proof(3)
@pytest.mark.parametrize("kind", ["no_answer", "wrong_checksum", "truncated", "garbage", "wrong_unit", "late_answer"])
def test_a_read_survives_a_fault(tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], kind: str) -> None:
    details = {"count": 1, "seconds": 0.7} if kind == "late_answer" else {"count": 2}
    tc100.fault(kind, **details)
    assert read_json(tc100, capsys, "actual_position")["encoder_position"]["words"] == [0, 5000]


def test_a_device_that_does_not_answer_is_named(tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    tc100.fault("no_answer", count=0)
    assert live(tc100, "read", "alarm") == 1
    assert "tc100: no answer" in capsys.readouterr().err


@pytest.mark.parametrize(("kind", "state"), [("no_answer", "may be written or not"), ("exception", "is not written")])
def test_a_failed_write_says_what_was_written(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], kind: str, state: str
) -> None:
    details = {"reason": "value_invalid"} if kind == "exception" else {}
    tc100.fault(kind, request=3, **details)
    assert live(tc100, "write", "motion_speed=5", "acceleration_time=500") == 1
    error = capsys.readouterr().err
    assert f"acceleration_time {state}" in error
    assert "written before it: motion_speed" in error


def test_what_starts_something_is_sent_once(tc100: SimulatedDevice, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("fieldspec.command.live.writing.active_states", lambda access, client: [])
    requests: list[bytes] = []
    tc100.simulation.listeners.append(
        lambda now, link, way, data, text: requests.append(data) if way == "request" else None
    )
    tc100.fault("no_answer", count=0)
    assert live(tc100, "write", "motion_command=homing", "--yes") == 1
    assert len(requests) == 1


def test_a_dump_is_what_another_device_begins_with(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    tc100.set(target_position=4711)
    path = str(tmp_path / "dump.csv")
    assert live(tc100, "dump", path) == 0
    from fieldspec.tools.lists.dump import dump
    from fieldspec.tools.lists.text_sheet import text_sheet
    from fieldspec.tools.simulator.seeding import seed

    with simulation("tc100", folder=SPECS) as other:
        count, unused = seed(other.simulation.engine, dump(text_sheet(Path(path).read_bytes(), ""), {}))
        assert (count > 1800, unused) == (True, 0)
        assert other.value("target_position") == 4711


def test_changes_are_watched(tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]) -> None:
    assert live(tc100, "watch", "alarm", "servo_on", "--count", "3", "--every", "0.01") == 0
    assert capsys.readouterr().out.count("servo_on") == 1


def test_a_dump_and_a_scan_are_evidence_without_a_contradiction(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    unit = tmp_path / "units" / "bench"
    unit.mkdir(parents=True)
    (unit / "unit.yaml").write_text('model: TC100\nfirmware: "2.0"\nserial_number: redacted\n', "utf-8")
    assert live(tc100, "dump", str(unit / "rest.csv")) == 0
    capsys.readouterr()
    assert live(tc100, "scan", "0x1000..0x103F", "--format", "json") == 0
    (unit / "scan.json").write_text(capsys.readouterr().out, "utf-8")
    code = main(["audit", "tc100", "--evidence", str(unit.parent), "--format", "json", "--specs", str(SPECS)])
    rows = json.loads(capsys.readouterr().out)["sections"]["evidence"]["tables"]["evidence"]
    seen = {row["fact"]: row["state"] for row in rows if row["aspect"] == "address"}
    assert code == 0
    assert seen["registers/action_status"] == "observed"
    assert "contradicted" not in seen.values()


def test_a_scan_finds_what_the_spec_does_not_have_and_what_does_not_answer(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    memory = tc100.simulation.engine.memory
    memory.occupants["", 0x1010] = memory.occupants["", 0x1000]
    memory.words["", 0x1010] = 5
    del memory.occupants["", 0x1005]
    assert live(tc100, "scan", "0x1000..0x103F", "--format", "json") == 0
    result = json.loads(capsys.readouterr().out)
    assert result["spaces"][0]["unknown"] == [[0x1010, 0x1010]]
    assert result["spaces"][0]["silent"] == ["alarm"]
    assert result["looks_like"] == ["before-2.0", "2.0"]
