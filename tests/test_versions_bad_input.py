"""Errors in versions are findings at their places, with an exit code, and nothing is written."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from command_line import SPECS
from fieldspec.cli import main

HEAD = 'overlay: {id: "2.1", line: firmware, based_on: "2.0", inferred: A test.}\n'
NEXT = 'overlay: {id: "2.2", line: firmware, based_on: "2.1", inferred: A test.}\n'

# By error: the files of versions, then the code of the finding and its place.
CASES: dict[str, tuple[dict[str, str], str, str]] = {
    "a cycle": (
        {"2.1": HEAD.replace('"2.0"', '"2.2"'), "2.2": NEXT},
        "overlay_cycle",
        "versions/2.1.yaml:1:48",
    ),
    "a version that is based on itself": (
        {"2.1": HEAD.replace('"2.0"', '"2.1"')},
        "overlay_cycle",
        "versions/2.1.yaml:1:48",
    ),
    "a version that is based on an unknown one": (
        {"2.1": HEAD.replace('"2.0"', '"1.9"')},
        "version_unknown",
        "versions/2.1.yaml:1:48",
    ),
    "a version of an unknown line": (
        {"2.1": HEAD.replace("firmware", "software")},
        "version_unknown",
        "versions/2.1.yaml:1:28",
    ),
    "a version on a line where it follows nothing": (
        {"2.1": HEAD.replace("firmware", "hardware")},
        "version_unknown",
        "versions/2.1.yaml:1:15",
    ),
    "a version that is declared already": (
        {"2.0": HEAD.replace('"2.1"', '"2.0"').replace('based_on: "2.0"', "based_on: before-2.0")},
        "version_twice",
        "versions/2.0.yaml:1:15",
    ),
    "two versions after the same one": (
        {"2.1": HEAD, "2.2": NEXT.replace('based_on: "2.1"', 'based_on: "2.0"')},
        "version_twice",
        "versions/2.",
    ),
    "a bound that fits no line": (
        {"2.1": HEAD + "adds: [{in: enums/control_mode, reason: R, item: {value: 9, name: x, since: '7.7'}}]\n"},
        "version_unknown",
        "versions/2.1.yaml:2:",
    ),
    "a change of what another version has": (
        {
            "2.1": HEAD.replace('"2.0"', "before-2.0")
            + "removes: [{fact: records/point/acceleration_time, reason: R}]\n"
        },
        "overlay_fact_missing",
        "versions/2.1.yaml:2:18",
    ),
    "an old value that the base does not have": (
        {"2.1": HEAD + "changes: [{fact: registers/acceleration_time, set: {unit: {was: s, is: min}}, reason: R}]\n"},
        "overlay_base_differs",
        "versions/2.1.yaml:2:65",
    ),
    "a change that changes nothing": (
        {"2.1": HEAD + "changes: [{fact: registers/acceleration_time, set: {unit: {was: ms, is: ms}}, reason: R}]\n"},
        "overlay_changes_nothing",
        "versions/2.1.yaml:2:59",
    ),
    "a register that is gone and that an example uses": (
        {"2.1": HEAD + "removes: [{fact: registers/motion_command, reason: R}]\n"},
        "examples_fit_registers",
        "examples.yaml:",
    ),
    "a new name that is taken": (
        {"2.1": HEAD + "renames: [{fact: registers/acceleration_time, to: deceleration_time, reason: R}]\n"},
        "overlay_name_taken",
        "versions/2.1.yaml:2:51",
    ),
    "an accepted change that has not happened": (
        {"2.1": HEAD + "accepts: [{rule: renamed, path: registers/speed, reason: R, date: 2026-05-01}]\n"},
        "accepts_used",
        "versions/2.1.yaml:2:33",
    ),
    "an accepted change by a rule that is not there": (
        {"2.1": HEAD + "accepts: [{rule: rename, path: registers/speed, reason: R, date: 2026-05-01}]\n"},
        "accepts_used",
        "versions/2.1.yaml:2:18",
    ),
    "a file with another name than its version": (
        {"2.2": HEAD},
        "id_matches_path",
        "versions/2.2.yaml:1:15",
    ),
}


@pytest.mark.proof(8)
@pytest.mark.parametrize("name", CASES)
def test_a_slip_is_found_at_its_place_and_nothing_is_written(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    files, code, place = CASES[name]
    specs = tmp_path / "specs"
    for folder in ("protocols", "tc100"):
        shutil.copytree(SPECS / folder, specs / folder)
    (specs / "tc100" / "versions").mkdir()
    for version, text in files.items():
        (specs / "tc100" / "versions" / f"{version}.yaml").write_text(text, "utf-8")
    assert main(["check", "tc100", "--specs", str(specs)]) == 1
    lines = [line for line in capsys.readouterr().out.splitlines() if f"error[{code}]" in line]
    assert [line for line in lines if f"tc100/{place}" in line], lines
    out = tmp_path / "out"
    assert main(["build", "tc100", "--specs", str(specs), "--out", str(out)]) == 1
    assert not out.exists()


@pytest.mark.parametrize(
    "words",
    [
        ("diff", "tc100@9.9", "tc100@2.0"),
        ("diff", "no-such-revision", "tc100"),
        ("resolve", "tc100@9.9"),
        ("blame", "tc100@9.9", "registers/speed"),
        ("new", "version", "tc100", "2.1", "--based-on", "9.9"),
        ("build", "tc100@9.9"),
    ],
    ids=" ".join,
)
def test_a_version_or_a_revision_that_does_not_exist_is_wrong_use(
    words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([*words, "--specs", str(SPECS)]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("fieldspec: ")
    assert list(tmp_path.iterdir()) == []
