"""Blind detection: what the checks find in the print, with no erratum written."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from command_line import SPECS, CommandLine
from fieldspec import checks
from fieldspec.audit.detection import CLASSES, OF_WRITING, WIRE, Printed, as_printed, misprint
from fieldspec.checks import table
from fieldspec.model.texts import JUDGEMENT
from fieldspec.proofs.running import errata_proofs
from fieldspec.reading.project import DeviceSpec, read

HERE = Path(__file__).parent
FILES = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.glob("*/*.yaml"))}
DEVICES = read(FILES).devices
RIGHT = {path.relative_to(HERE / "right").as_posix(): path.read_bytes() for path in (HERE / "right").glob("*/*.yaml")}


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, HERE / "right")


def printed(spec: DeviceSpec) -> Printed:
    return as_printed(spec, errata_proofs(spec), thorough=True)


@cache
def device(name: str) -> Printed:
    """What the print of a device shows; all tests share it."""
    return printed(DEVICES[name])


def pump(**replaced: tuple[str, str]) -> DeviceSpec:
    files = dict(RIGHT)
    for name, (old, new) in replaced.items():
        text = files[f"pump/{name}.yaml"].decode()
        assert text.count(old) == 1
        files[f"pump/{name}.yaml"] = text.replace(old, new).encode()
    return read(files).devices["pump"]


@pytest.mark.parametrize("name", DEVICES)
def test_most_errata_with_an_effect_on_the_wire_are_found_blindly(name: str) -> None:
    wire = [one for one in device(name).detections if one.erratum.effect in WIRE]
    assert sum(bool(one.alone) for one in wire) >= 0.85 * len(wire)
    assert sum(one.together for one in wire) >= 0.85 * len(wire)


@pytest.mark.parametrize("name", DEVICES)
def test_what_is_proven_is_found_blindly_and_what_is_judged_is_not(name: str) -> None:
    for one in device(name).detections:
        if one.erratum.proof == JUDGEMENT:
            assert one.checks == (), one.erratum.id
        else:
            assert one.erratum.proof in one.checks, one.erratum.id


@pytest.mark.parametrize("name", DEVICES)
def test_every_key_that_is_misprinted_has_a_class(name: str) -> None:
    classed = {key for keys in CLASSES.values() for key in keys}
    used = {key for one in device(name).detections for key in one.erratum.printed}
    assert used <= classed


def test_no_key_has_two_classes() -> None:
    keys = [key for keys in CLASSES.values() for key in keys]
    assert len(keys) == len(set(keys))


def test_checks_of_how_a_spec_is_written_do_not_count() -> None:
    assert set(OF_WRITING) < {name for name, _ in checks.CHECKS} | {"allowances_used"}
    for name in DEVICES:
        assert {found.code for found in device(name).findings}.isdisjoint(OF_WRITING)


def test_without_its_check_a_misprint_is_not_found(monkeypatch: pytest.MonkeyPatch) -> None:
    spec = pump()
    proofs = errata_proofs(spec)
    for held in ("CHECKS", "_BY_NAME"):
        kept = dict(getattr(table, held))
        kept["decimal_equals_hex"] = lambda device: iter(())
        monkeypatch.setattr(table, held, tuple(kept.items()) if held == "CHECKS" else kept)
    missed = [one.erratum.id for one in as_printed(spec, proofs, thorough=True).detections if not one.alone]
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
    made = printed(pump(errata=("  - id: run-sum\n", erratum)))
    found = {one.erratum.id: (bool(one.alone), one.together) for one in made.detections}
    assert found["dose-range"] == found["dose-maximum"] == (True, False)


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
    (one,) = [
        one
        for one in printed(pump(errata=("  - id: run-sum\n", erratum))).detections
        if one.erratum.id == "running-missing"
    ]
    assert "enum_contiguous" in one.checks
    assert misprint(one.erratum) == "left out"


@pytest.mark.parametrize("name", DEVICES)
def test_the_report_counts_what_a_thorough_look_counts(name: str) -> None:
    spec = DEVICES[name]
    brief = as_printed(spec, errata_proofs(spec), thorough=False)
    found = {one.erratum.id: (bool(one.alone), one.together) for one in device(name).detections}
    assert {one.erratum.id: (bool(one.alone), one.together) for one in brief.detections} == found
    assert brief.findings == device(name).findings


def test_the_verb_lists_what_is_found_and_says_nothing_against_the_spec(run: CommandLine) -> None:
    ran = run("audit", "pump", "--as-printed")
    assert ran.code == 0
    assert "11 of 11 errata with an effect on the wire or on ranges are found with no erratum written" in ran.lines
    assert ran.out.count(": error[") == 16
    rows = run.json("audit", "pump", "--as-printed", "--table", "detections")
    (row,) = [row for row in rows if row["erratum"] == "pressure-address"]
    assert row["found_by"] == "addresses_ascending, addresses_disjoint, gaps_declared"
    assert row["together"] == "yes"


def test_the_page_about_audits_has_the_numbers() -> None:
    page = (SPECS.parent / "docs" / "audit.md").read_text("utf-8")
    for name in DEVICES:
        every = device(name).detections
        wire = [one for one in every if one.erratum.effect in WIRE]
        alone, together = sum(bool(one.alone) for one in wire), sum(one.together for one in wire)
        found = sum(bool(one.alone) for one in every)
        assert f"| `{name}` | {len(wire)} | {alone} | {together} | {len(every)} | {found} |\n" in page
