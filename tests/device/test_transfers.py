"""Points and settings go from a simulated device to files and back; breaks at every step leave a known state."""

from __future__ import annotations

import csv
import io
import json
import os
from collections.abc import Mapping
from pathlib import Path

import pytest

from fieldspec.cli import main
from fieldspec.testing import SimulatedDevice, simulation
from fieldspec.tools.live.list_reading import entries
from fieldspec.tools.live.reading import reading
from fieldspec.tools.live.register_access import RegisterAccess
from fieldspec.tools.live.value_files import file_content, file_sheet
from fieldspec.tools.live.value_lists import elements, table_list
from point_lists import (
    HEAD,
    five_points,
    live,
    points_file,
    set_values,
    value_of,
    writes_of,
)
from simulators import SPECS, parts_of


def test_points_go_to_a_file_and_back(tc100: SimulatedDevice, tmp_path: Path) -> None:
    path = tmp_path / "points.csv"
    points = {"points[3].position": -1250, "points[3].torque_limit": 335, "points[7].next_point": 9}
    set_values(tc100, points)
    assert live(tc100, "points", "download", str(path)) == 0
    row = list(csv.DictReader(io.StringIO(path.read_text("utf-8"))))[2]
    assert (row["Index"], row["mode"]) == ("3", "relative_move")
    assert (row["torque_limit"], row["next_point"]) == ("33.5 %", "end")
    assert row["position"] == "'-1250 pulse"
    assert "reserved_5" not in row
    set_values(tc100, {"points[3].position": 5, "points[3].torque_limit": 1000, "points[7].next_point": -1})
    assert live(tc100, "compare", str(path)) == 1
    writes = writes_of(tc100)
    assert live(tc100, "points", "upload", str(path), "--yes") == 0
    assert len(writes) == 3
    assert {name: value_of(tc100, name) for name in points} == points
    assert not Path(f"{path}.journal").exists()


@pytest.mark.parametrize("ending", ["csv", "xlsx", "json", "yaml"])
def test_a_file_means_the_words_that_it_is_written_from(ending: str) -> None:
    layout, _ = parts_of("tc100")
    access = RegisterAccess(layout)
    words = [0, 3, 0xFFFF, 0x8000, 335]
    placed_values = [pair for pair in elements(access, "points") if pair[1].path.startswith("points[1")]
    values = []
    for number, (_, occupant) in enumerate(placed_values):
        value = reading(layout, "", occupant, [words[number % 5]] * occupant.words)
        wrong = value.decoded is not None and value.decoded.verdict
        values.append(reading(layout, "", occupant, [1] * occupant.words) if wrong else value)
    content = file_content(f"a.{ending}", table_list(access, "points", values))
    wanted, findings = entries(access, file_sheet(f"a.{ending}", content))
    assert findings == []
    assert [(item.occupant.path, item.words) for item in wanted] == [(v.occupant.path, v.words) for v in values]


def test_settings_are_restored_over_a_pseudo_terminal(tmp_path: Path) -> None:
    path = tmp_path / "settings.json"
    with simulation("tc100", ports={"rtu": "pty"}, folder=SPECS) as device:
        options = ("--link", "rtu", "--port", device.place, "--specs", SPECS)
        set_values(device, {"points[1].wait_time": 123, "motion_speed": 41})
        assert main(["live", "tc100", "backup", str(path), *options]) == 0
        names = {row["Name"] for row in json.loads(path.read_text("utf-8"))}
        assert "points[1].wait_time" in names
        assert not names & {"servo", "motion_command", "parameter_storage", "write_enable_key", "action_status"}
        set_values(device, {"points[1].wait_time": 0, "motion_speed": 7})
        assert main(["live", "tc100", "restore", str(path), "--yes", *options]) == 0
        assert value_of(device, "points[1].wait_time") == 123
        assert value_of(device, "motion_speed") == 41


def test_points_of_another_device_are_transferred_by_table(tmp_path: Path) -> None:
    path = str(tmp_path / "points.csv")
    Path(path).write_text("Index,position,command\n5,-20 pulse,1\n", "utf-8")
    with simulation("ck10", ports={"rtu": "tcp://127.0.0.1:0"}, folder=SPECS) as device:
        assert live(device, "points", "upload", path, "--table", "points", "--yes", name="ck10") == 0
        assert value_of(device, "points[5].position") == -20


def test_a_dry_run_prints_the_plan_and_writes_nothing(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    path = five_points(tmp_path)
    writes = writes_of(tc100)
    assert live(tc100, "points", "upload", path, "--dry-run") == 0
    output = capsys.readouterr()
    assert "points[1].speed" in output.out
    assert "100 %" in output.out
    assert "01 06 90 13 00 0A" in output.out
    assert "6 of 6 values differ" in output.err
    assert writes == []
    assert not Path(f"{path}.journal").exists()


def test_nothing_is_written_without_consent(
    tc100: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    with open(os.devnull, encoding="utf-8") as nobody:
        monkeypatch.setattr("sys.stdin", nobody)
        writes = writes_of(tc100)
        assert live(tc100, "points", "upload", five_points(tmp_path)) == 2
    assert "confirm the list above with --yes" in capsys.readouterr().err
    assert writes == []


def test_all_findings_of_a_file_are_reported_at_once(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    path = points_file(
        tmp_path,
        "ck10,2.0,points,1,50 %,5,5",
        "tc100,1.0,points,2,101 %,fast,5",
        "tc100,2.0,points,128,50 %,5,",
        "tc100,2.0,points,3,50 %,,",
        "tc100,2.0,points,3,51 %,,",
        "tc100,2.0,programs,3,51 %,,",
        head=f"{HEAD}speed,wait_time,sped",
    )
    requests: list[bytes] = []
    tc100.simulation.listeners.append(lambda now, link, way, data, text: requests.append(data))
    assert live(tc100, "points", "upload", path, "--yes") == 1
    error = capsys.readouterr().err
    for expected in (
        f"{path}:A2: is for the device ck10, not tc100",
        f"{path}:B3: is for the version 1.0, not 2.0; --any-version takes it nevertheless",
        f"{path}:E3: out_of_range: points[2].speed is 101",
        f"{path}:F3: points[2].wait_time: `fast` is not a number",
        f"{path}:G2: there is no points[1].sped; did you mean points[1].speed?",
        f"{path}:D4: there is no points[128]; choose from 1..127",
        f"{path}:E6: points[3].speed stands in row 5 too",
        f"{path}:C7: there is no table programs; choose from points",
        "nothing was written",
    ):
        assert expected in error
    assert requests == []


@pytest.mark.parametrize(
    ("name", "content", "expected"),
    [
        ("a.csv", "Name,Value\nservo,servo_on\n", "a.csv:A2: servo commands the device"),
        ("a.csv", "Name,Value\naction_status,1\n", "a.csv:A2: action_status can only be read"),
        ("a.csv", "Name,Value\nwrite_enable_key,1\n", "a.csv:A2: write_enable_key commands the device"),
        ("a.csv", "Name,Value\npoints[1].reserved_5,1\n", "a.csv:A2: points[1].reserved_5 is reserved"),
        ("a.csv", "Name,Value\n,5\n", "a.csv:A2: a value without a name"),
        ("a.csv", "Name,Value\nmotion_speed,\n", "no row below has a value"),
        ("a.csv", "Name,Value,Comment\nmotion_speed,5,x\n", "a.csv:C1: a list of settings has no column Comment"),
        ("a.csv", "Name,Value,Name\nmotion_speed,5,\n", "the heading Name stands here twice"),
        ("a.csv", "name,value\nmotion_speed,5\n", "write the heading as Name"),
        ("a.yaml", "- {Name: motion_speed, Value: 400}\n", "a.yaml:1: out_of_range: motion_speed is 400"),
        ("a.json", '[{"Name": "motion_sped", "Value": 4}]', "a.json:item 1: there is no motion_sped; did you mean"),
    ],
)
def test_what_no_list_may_write_is_a_finding(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path, name: str, content: str, expected: str
) -> None:
    (tmp_path / name).write_text(content, "utf-8")
    assert live(tc100, "restore" if "ame" in content else "upload", str(tmp_path / name)) in (1, 2)
    assert expected in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "content", "expected"),
    [
        (("points",), "", "say `points download FILE` or `points upload FILE`"),
        (("points", "upload"), "", "say `points download FILE`"),
        (("backup",), "", "name one file to write"),
        (("backup", "a.txt"), "", "must end in one of .csv, .xlsx, .json, .yaml, .yml"),
        (("restore", "a.csv"), "Index,speed\n1,5\n", "is a list for `points upload`, by its headings"),
        (("points", "upload", "a.csv"), "Name,Value\nmotion_speed,5\n", "is a list for `restore`, by its headings"),
        (("points", "download", "a.csv", "--table", "programs"), "", "there is no table programs"),
        (("compare", "a.yaml"), "a: [1", "is not YAML"),
        (("compare", "a.yaml"), "a: 1", "is YAML but not a list of mappings"),
        (("compare", "a.csv"), " ", "is empty"),
        (("compare", "b.csv"), "", "cannot read"),
    ],
)
def test_wrong_use_is_refused(
    tc100: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    arguments: tuple[str, ...],
    content: str,
    expected: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    if content:
        Path(arguments[-1]).write_text(content, "utf-8")
    assert live(tc100, *arguments) == 2
    assert expected in capsys.readouterr().err


@pytest.mark.parametrize(
    ("device", "values", "expected"),
    [
        ("tc100", {"servo_on": 0}, ""),
        ("tc100", {"servo_on": 1}, "the servo is on: servo_on is "),
        ("tc100", {"servo_on": 0, "action_status": 1}, "the device may be busy: action_status is moving"),
        ("ck10", {"motion_status": 1 << 20}, "the servo is on: motion_status is servo_on"),
    ],
)
def test_the_state_of_a_device_is_known_before_a_write(
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    device: str,
    values: Mapping[str, int],
    expected: str,
) -> None:
    path = points_file(tmp_path, "2,5", head="Index,position")
    with (
        simulation(device, ports={"rtu": "tcp://127.0.0.1:0"}, folder=SPECS) as simulated_device,
        open(os.devnull, encoding="utf-8") as nobody,
    ):
        monkeypatch.setattr("sys.stdin", nobody)
        monkeypatch.setattr(simulated_device.simulation.engine, "refresh", lambda: None)
        set_values(simulated_device, values)
        assert live(simulated_device, "points", "upload", path, "--table", "points", name=device) == 2
    error = capsys.readouterr().err
    assert expected in error if expected else "servo" not in error and "busy" not in error
