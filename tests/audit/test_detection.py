"""Blind detection: what the checks find in the print, with no erratum written."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from command_line import SPECS, CommandLine
from fieldspec.language.checks import table
from fieldspec.language.checks import table as checks
from fieldspec.language.model.texts import JUDGEMENT
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.tools.audit.detection import CLASSES, OF_WRITING, WIRE, PrintedDevice, as_printed, misprint
from fieldspec.tools.proofs.running import errata_proofs

HERE = Path(__file__).parent
FILES = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.glob("*/*.yaml"))}
DEVICES = read(FILES).devices
RIGHT = {path.relative_to(HERE / "right").as_posix(): path.read_bytes() for path in (HERE / "right").glob("*/*.yaml")}


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, HERE / "right")


def printed(spec: DeviceSpec) -> PrintedDevice:
    return as_printed(spec, errata_proofs(spec), thorough=True)


@cache
def device(name: str) -> PrintedDevice:
    """What the print of a device shows; all tests share it."""
    return printed(DEVICES[name])


def pump(**replaced: tuple[str, str]) -> DeviceSpec:
    files = dict(RIGHT)
    for name, (old, new) in replaced.items():
        text = files[f"pump/{name}.yaml"].decode()
        assert text.count(old) == 1
        files[f"pump/{name}.yaml"] = text.replace(old, new).encode()
    return read(files).devices["pump"]


@pytest.mark.proof(1)
@pytest.mark.parametrize("name", DEVICES)
def test_most_errata_with_an_effect_on_the_wire_are_found_blindly(name: str) -> None:
    wire = [detection for detection in device(name).detections if detection.erratum.effect in WIRE]
    assert sum(bool(detection.alone) for detection in wire) >= 0.85 * len(wire)
    assert sum(detection.together for detection in wire) >= 0.85 * len(wire)


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", DEVICES)
def test_what_is_proven_is_found_blindly_and_what_is_judged_is_not(name: str) -> None:
    for detection in device(name).detections:
        if detection.erratum.proof == JUDGEMENT:
            assert detection.checks == (), detection.erratum.id
        else:
            assert detection.erratum.proof in detection.checks, detection.erratum.id


@pytest.mark.parametrize("name", DEVICES)
def test_every_key_that_is_misprinted_has_a_class(name: str) -> None:
    classed = {key for keys in CLASSES.values() for key in keys}
    used = {key for detection in device(name).detections for key in detection.erratum.printed}
    assert used <= classed


def test_no_key_has_two_classes() -> None:
    keys = [key for keys in CLASSES.values() for key in keys]
    assert len(keys) == len(set(keys))


def test_checks_of_how_a_spec_is_written_do_not_count() -> None:
    assert set(OF_WRITING) < {name for name, _ in checks.CHECKS} | {"allowances_used"}
    for name in DEVICES:
        assert {finding.code for finding in device(name).findings}.isdisjoint(OF_WRITING)


def test_without_its_check_a_misprint_is_not_found(monkeypatch: pytest.MonkeyPatch) -> None:
    spec = pump()
    proofs = errata_proofs(spec)
    for name in ("CHECKS", "_BY_NAME"):
        checks = dict(getattr(table, name))
        checks["decimal_equals_hex"] = lambda device: iter(())
        monkeypatch.setattr(table, name, tuple(checks.items()) if name == "CHECKS" else checks)
    missed = [
        detection.erratum.id for detection in as_printed(spec, proofs, thorough=True).detections if not detection.alone
    ]
    assert missed == ["mode-decimal"]


def test_two_misprints_that_agree_hide_each_other() -> None:
    erratum = """  - id: dose-maximum
    fact: messages/give/request/dose/restated/0
    printed: {range: 1..50}
    reason: Both places leave out a zero.
    confidence: likely
    effect: range
    proof: restatements_agree
    source: 2.2 L31
  - id: run-sum
"""
    printed_device = printed(pump(errata=("  - id: run-sum\n", erratum)))
    results = {
        detection.erratum.id: (bool(detection.alone), detection.together) for detection in printed_device.detections
    }
    assert results["dose-range"] == results["dose-maximum"] == (True, False)


def test_what_the_print_lacks_as_a_whole_is_taken_out() -> None:
    erratum = """  - id: running-missing
    fact: enums/state/running
    printed: {present: false}
    reason: Where it starts and stops, it runs.
    confidence: certain
    effect: bytes
    proof: enum_contiguous
    source: 2.4 L50
  - id: run-sum
"""
    (detection,) = [
        detection
        for detection in printed(pump(errata=("  - id: run-sum\n", erratum))).detections
        if detection.erratum.id == "running-missing"
    ]
    assert "enum_contiguous" in detection.checks
    assert misprint(detection.erratum) == "left out"


@pytest.mark.parametrize("name", DEVICES)
def test_the_report_counts_what_a_thorough_look_counts(name: str) -> None:
    spec = DEVICES[name]
    brief = as_printed(spec, errata_proofs(spec), thorough=False)
    results = {
        detection.erratum.id: (bool(detection.alone), detection.together) for detection in device(name).detections
    }
    assert {
        detection.erratum.id: (bool(detection.alone), detection.together) for detection in brief.detections
    } == results
    assert brief.findings == device(name).findings


def test_the_verb_lists_what_is_found_and_says_nothing_against_the_spec(run: CommandLine) -> None:
    ran = run("audit", "pump", "--as-printed")
    assert ran.code == 0
    assert "11 of 11 errata that affect the wire or a range are found without the erratum" in ran.lines
    assert (ran.out.count(": error["), ran.out.count(": warning[")) == (15, 1)  # a copied description is a warning
    rows = run.json("audit", "pump", "--as-printed", "--table", "detections")
    (row,) = [row for row in rows if row["erratum"] == "pressure-address"]
    assert row["found_by"] == "addresses_ascending, addresses_disjoint, gaps_declared"
    assert row["together"] == "yes"


def test_the_page_about_audits_has_the_numbers() -> None:
    page = (SPECS.parent / "docs" / "readings.md").read_text("utf-8")
    for name in DEVICES:
        every = device(name).detections
        wire = [detection for detection in every if detection.erratum.effect in WIRE]
        alone, together = (
            sum(bool(detection.alone) for detection in wire),
            sum(detection.together for detection in wire),
        )
        count = sum(bool(detection.alone) for detection in every)
        assert f"| `{name}` | {len(wire)} | {alone} | {together} | {len(every)} | {count} |\n" in page
