"""Findings in every format, and the verbs of the command line with their exit codes."""

from __future__ import annotations

import json
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from fieldspec.cli import main
from fieldspec.command.rendering import finding_text as text
from fieldspec.command.rendering.finding_formats import format_findings
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.diagnostics import Diagnostic, Label

SPECS = str(Path(__file__).resolve().parent.parent / "specs")
FILE = SourceFile("device/points.yaml", "label: 伺服, name: servo\nhostile: ]]> </x> %0A, :: \n")
FINDINGS = [
    Diagnostic(
        "some_rule",
        "the name is taken\nby 100% of ::x",
        Span(FILE, 17, 22),
        (Label(Span(FILE, 7, 9), "here"),),
        "rename it",
    )
]
BARE = [Diagnostic("other_rule", 'a </script> & \x00 "quoted"', Span(FILE, 33, 36))]


def test_the_caret_is_under_the_culprit_after_wide_characters() -> None:
    rendered = text.rendered(FINDINGS).splitlines()
    line, marks = rendered[1], rendered[2]
    before = line.split("servo")[0]
    assert text.width(marks.split("^")[0]) == text.width(before)
    assert marks.count("^") == len("servo")


def test_the_text_names_rule_place_label_and_help() -> None:
    rendered = text.rendered(FINDINGS)
    for part in ("device/points.yaml:1:18: error[some_rule]", "device/points.yaml:1:8: here", "help: rename it"):
        assert part in rendered


def test_only_coloured_text_has_escape_sequences() -> None:
    assert "\x1b" not in text.rendered([*FINDINGS, *BARE])
    assert "\x1b" in text.rendered(FINDINGS, coloured=True)


def test_json_has_every_place() -> None:
    (finding,) = json.loads(format_findings(FINDINGS, "json"))
    assert (finding["code"], finding["line"], finding["column"], finding["end_column"]) == ("some_rule", 1, 18, 23)
    assert finding["labels"][0]["column"] == 8


def test_sarif_has_a_rule_and_a_region_for_every_result() -> None:
    run = json.loads(format_findings([*FINDINGS, *BARE], "sarif"))["runs"][0]
    assert [rule["id"] for rule in run["tool"]["driver"]["rules"]] == ["other_rule", "some_rule"]
    for result in run["results"]:
        assert run["tool"]["driver"]["rules"][result["ruleIndex"]]["id"] == result["ruleId"]
    region = run["results"][0]["locations"][0]["physicalLocation"]["region"]
    assert (region["startLine"], region["startColumn"]) == (1, 18)


def test_github_commands_are_one_line_each_and_escaped() -> None:
    lines = format_findings(FINDINGS, "github").splitlines()
    assert len(lines) == 1
    assert lines[0].startswith("::error file=device/points.yaml,line=1,col=18,")
    assert "the name is taken%0Aby 100%25 of ::x" in lines[0]


@pytest.mark.parametrize("findings", [[], FINDINGS, BARE], ids=["none", "one", "hostile"])
def test_junit_is_xml_with_a_case_for_every_finding(findings: list[Diagnostic]) -> None:
    suite = ElementTree.fromstring(format_findings(findings, "junit"))
    assert suite.get("failures") == str(len(findings))
    assert len(suite.findall("testcase")) == max(1, len(findings))


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["devices"], 0),
        (["check"], 0),
        (["check", "esc11", "--format", "sarif"], 0),
        (["check", "no_such"], 2),
        (["rule"], 0),
        (["rule", "addresses_disjoint"], 0),
        (["rule", "adresses_disjoint"], 2),
        (["show", "tc100"], 0),
        (["show", "tc100", "0x2011"], 0),
        (["show", "esc11", "communication_status"], 0),
        (["show", "esc11", "no such thing"], 2),
        (["facts", "esc11@before-1.17", "--format", "json"], 0),
        (["facts", "esc11@9"], 2),
        (["decode", "tc100", "01 06 20 1E 00 03 A2 0D"], 0),
        (["decode", "tc100", ":0106201E0003B8"], 0),
        (["decode", "tc100", "01 06 20 1E 00 03 A2 0E"], 1),
        (["decode", "tc100", "not hex"], 2),
        (["encode", "esc11", "move_relative", "address=0", "distance=20.00mm", "speed=50"], 0),
        (["encode", "esc11", "move_relative", "address=0", "distance=20.00mm", "speed=101"], 2),
        (["encode", "esc11", "move_relativ"], 2),
        (["decode", "ck10", "01 03 07 D0 00 08 44 81"], 0),
        (["decode", "hiwin-e", "--telegram", "750", "--direction", "sent", "20 00"], 0),
        (["decode", "hiwin-e", "--telegram", "750", "--direction", "sent", "20 00 00"], 1),
        (["decode", "hiwin-e", "--telegram", "751", "20 00"], 2),
        (["encode", "hiwin-e", "--telegram", "750", "--direction", "sent", "M_ACT=50 %"], 0),
        (["show", "hiwin-e", "Pt317"], 0),
    ],
    ids=str,
)
def test_a_verb_exits_with_its_code(arguments: list[str], code: int, capsys: pytest.CaptureFixture[str]) -> None:
    verb, *rest = arguments
    specs = [] if verb == "rule" else ["--specs", SPECS]
    assert main([verb, *rest, *specs]) == code
    out, err = capsys.readouterr()
    if code == 2:
        assert err.startswith("fieldspec: ")
    else:
        assert out.strip()


@pytest.mark.parametrize("arguments", [["--version"], ["--help"], ["decode", "--help"]], ids=" ".join)
def test_help_and_version_exit_with_code_0(arguments: list[str]) -> None:
    result = subprocess.run([sys.executable, "-m", "fieldspec", *arguments], capture_output=True, check=False)
    assert (result.returncode, result.stderr) == (0, b"")
    assert result.stdout


def test_a_missing_and_an_unknown_verb_are_wrong_use(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 2
    assert main(["no-such-verb"]) == 2
    assert capsys.readouterr().out == ""


def test_a_folder_without_specs_is_wrong_use(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "--specs", str(tmp_path)]) == 2
    assert main(["check", "--specs", str(tmp_path / "missing")]) == 2
    assert len(capsys.readouterr().err.splitlines()) == 2


def test_a_log_is_explained_line_by_line_from_standard_input() -> None:
    log = b"12:00:01 TX: 01 03 10 00 00 01 80 CA\n12:00:02 RX: 01 03 02 00 01 79 84\n"
    command = [sys.executable, "-m", "fieldspec", "decode", "tc100", "-", "--specs", SPECS]
    result = subprocess.run(command, input=log, capture_output=True, check=False)
    assert result.returncode == 0
    assert b"read_registers request" in result.stdout
    assert b"action_status" in result.stdout


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_a_completion_script_knows_the_verbs(shell: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["completion", shell]) == 0
    assert "decode" in capsys.readouterr().out
