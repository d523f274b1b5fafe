"""A made-up manual with one misprint of each kind that real manuals show: all of them are found, and nothing else.

`printed` is its transcription without a correction, `right` the same with every misprint put right by an erratum.
"""

from __future__ import annotations

import hashlib
from pathlib import Path

import pytest

from command_line import CommandLine
from fieldspec.command.pipeline import checked, load
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.tools.audit.detection import as_printed
from fieldspec.tools.audit.ledger import verdict
from fieldspec.tools.proofs.running import errata_proofs

HERE = Path(__file__).parent
MANUAL = HERE / "pump.txt"

# What is misprinted, the line of the manual, the file and line of the spec, and the checks that find it there.
MISPRINTS = [
    ("an address out of order and twice", 21, "registers.yaml", 12, {"addresses_ascending", "addresses_disjoint"}),
    ("the hole that this address leaves", 21, "registers.yaml", 13, {"gaps_declared"}),
    ("hexadecimal and decimal that disagree", 30, "registers.yaml", 20, {"decimal_equals_hex"}),
    ("an enum beyond its range", 30, "registers.yaml", 20, {"enum_within_range"}),
    ("a text too long for its words", 22, "registers.yaml", 13, {"words_match_type"}),
    ("a span and a word count that differ", 69, "registers.yaml", 73, {"elements_match_table"}),
    ("a checksum off by a digit", 83, "examples.yaml", 3, {"checksum_correct"}),
    ("a record one byte short", 56, "registers.yaml", 57, {"record_size_matches"}),
    ("a frame one byte short", 86, "examples.yaml", 4, {"length_byte_correct"}),
    ("a row of characters unlike its bytes", 92, "examples.yaml", 6, {"characters_match_bytes"}),
    ("a range with a digit missing", 28, "registers.yaml", 18, {"default_within_range"}),
    ("two tables with different maxima", 78, "device.yaml", 49, {"restatements_agree"}),
    ("a list that claims four and shows five", 44, "registers.yaml", 38, {"restatements_agree"}),
    ("a copied description", 19, "registers.yaml", 10, {"descriptions_differ"}),
    ("twin blocks whose names differ", 38, "registers.yaml", 30, {"copies_agree"}),
]


def files(folder: str) -> dict[str, bytes]:
    return {path.relative_to(HERE / folder).as_posix(): path.read_bytes() for path in (HERE / folder).glob("*/*.yaml")}


def spec(folder: str) -> DeviceSpec:
    return read(files(folder)).devices["pump"]


def placed(findings: list[Diagnostic]) -> set[tuple[str, int, str]]:
    return {
        (finding.span.file.path.rpartition("/")[2], finding.span.position()[0], finding.code) for finding in findings
    }


FINDINGS_IN_PRINT = checked(load(files("printed")))


@pytest.mark.parametrize(("file", "line", "checks"), [row[2:] for row in MISPRINTS], ids=[row[0] for row in MISPRINTS])
def test_a_misprint_is_found_at_its_place(file: str, line: int, checks: set[str]) -> None:
    assert {(file, line, check) for check in checks} <= placed(FINDINGS_IN_PRINT)


def test_nothing_else_is_found() -> None:
    expected = {(file, line, check) for _, _, file, line, checks in MISPRINTS for check in checks}
    assert placed(FINDINGS_IN_PRINT) == expected
    assert len(FINDINGS_IN_PRINT) == len(expected)


def test_nothing_is_found_where_all_is_right() -> None:
    assert checked(load(files("right"))) == []


def test_every_misprint_has_an_erratum_that_cites_its_line() -> None:
    device, _ = spec("right").at("1")
    cited = {citation.line() for erratum in device.errata for citation in erratum.sources}
    assert cited == {line for _, line, *_ in MISPRINTS}


def test_every_erratum_is_proven() -> None:
    assert {verdict(proof) for proof in errata_proofs(spec("right"))} == {"proven"}


def test_every_erratum_is_found_blindly_alone_and_together() -> None:
    right = spec("right")
    printed_device = as_printed(right, errata_proofs(right), thorough=True)
    assert [
        detection.erratum.id for detection in printed_device.detections if not detection.alone or not detection.together
    ] == []


def test_the_right_spec_with_all_prints_put_back_is_the_printed_one() -> None:
    right = spec("right")
    printed_device = as_printed(right, errata_proofs(right), thorough=True)
    assert {(finding.code, finding.message) for finding in printed_device.findings} == {
        (finding.code, finding.message) for finding in FINDINGS_IN_PRINT
    }


@pytest.mark.parametrize("folder", ["printed", "right"])
def test_the_specs_are_about_this_very_text(folder: str) -> None:
    text = MANUAL.read_bytes()
    manual = spec(folder).at("1")[0].manual
    assert (manual.sha256, manual.lines) == (hashlib.sha256(text).hexdigest(), text.count(b"\n"))


@pytest.mark.parametrize("more", [(), ("--manual", str(MANUAL))], ids=["index", "text"])
def test_the_whole_manual_is_accounted_for(
    more: tuple[str, ...], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    run = CommandLine(capsys, monkeypatch, HERE / "right")
    ran = run("audit", "pump", *more)
    assert ran.code == 0
    assert "0 of 49 are not accounted for" in ran.lines
    assert "11 of 49 are covered with a correction" in ran.lines


def test_a_row_that_is_left_out_of_the_spec_is_not_accounted_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "pump"
    folder.mkdir()
    for path in (HERE / "right" / "pump").iterdir():
        text = path.read_text("utf-8")
        lines = [line for line in text.splitlines(keepends=True) if "name: flow," not in line]
        folder.joinpath(path.name).write_text("".join(lines), "utf-8")
    ran = CommandLine(capsys, monkeypatch, tmp_path)("audit", "pump")
    assert ran.code == 1
    assert "line 20 of the manual, section 2.1, prints `address` 1003" in ran.out
