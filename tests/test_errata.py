"""Every erratum of the devices is proven by the rule that it names, or marked as a judgement."""

from __future__ import annotations

from pathlib import Path

import pytest

from fieldspec.language.checks import table as checks
from fieldspec.language.model.texts import JUDGEMENT
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.tools.proofs.errata import errata_by_version, put_back
from fieldspec.tools.proofs.running import FindingsCache, errata_proofs, everything
from layouts import TEST_SPECS, newest

SPECS = Path(__file__).resolve().parent.parent / "specs"
FILES = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.glob("*/*.yaml"))}
DEVICES = read(FILES).devices


@pytest.mark.parametrize("spec", DEVICES.values(), ids=list(DEVICES))
def test_a_device_has_several_dozen_errata_and_many_of_them_are_proven(spec: DeviceSpec) -> None:
    device, _ = spec.at(spec.versions()[-1])
    proven = [erratum for erratum in device.errata if erratum.proof != JUDGEMENT]
    assert len(device.errata) >= 36
    assert len(proven) >= len(device.errata) / 4


@pytest.mark.parametrize("spec", DEVICES.values(), ids=list(DEVICES))
def test_an_erratum_is_a_judgement_only_if_no_rule_can_prove_it(spec: DeviceSpec) -> None:
    version = spec.versions()[-1]
    device, _ = spec.at(version)
    clean = {finding.message for finding in checks.run(device)}
    provable = {}
    for erratum in device.errata:
        if erratum.proof == JUDGEMENT and erratum.printed and None not in erratum.printed.values():
            wrong, broken = put_back(spec, spec.tree_at(version), version, device, erratum)
            findings = [*broken, *checks.run(wrong)]
            provable[erratum.id] = {finding.code for finding in findings if finding.message not in clean}
    assert {id: codes for id, codes in provable.items() if codes} == {}


@pytest.mark.parametrize("spec", DEVICES.values(), ids=list(DEVICES))
def test_an_erratum_is_proven_once_at_the_newest_version_that_has_it(spec: DeviceSpec) -> None:
    newest_with = {erratum.id: version for version in spec.versions() for erratum in spec.at(version)[0].errata}
    proven = [(erratum.id, version) for version, _, errata in errata_by_version(spec) for erratum in errata]
    assert sorted(proven) == sorted(newest_with.items())


def test_an_erratum_whose_printed_value_keeps_its_rule_is_a_finding() -> None:
    text = FILES["esc11/errata.yaml"].decode()
    wrong = text.replace("proof: restatements_agree", "proof: bits_unique", 1)
    assert wrong != text
    changed = read({**FILES, "esc11/errata.yaml": wrong.encode()}).devices["esc11"]
    assert _faults(changed) == ["errata_proven"]


def test_an_erratum_whose_printed_value_is_that_of_the_spec_is_a_finding() -> None:
    text = FILES["tc100/errata-registers.yaml"].decode()
    wrong = text.replace("printed: {at: 0x080A}", "printed: {at: 0x070A}", 1)
    assert wrong != text
    changed = read({**FILES, "tc100/errata-registers.yaml": wrong.encode()}).devices["tc100"]
    assert _faults(changed) == ["errata_differ"]


def test_an_erratum_about_no_fact_is_a_finding() -> None:
    text = FILES["tc100/errata-registers.yaml"].decode()
    wrong = text.replace("fact: registers/motor_type", "fact: registers/no_such_register", 1)
    assert wrong != text
    changed = read({**FILES, "tc100/errata-registers.yaml": wrong.encode()}).devices["tc100"]
    assert _faults(changed) == ["errata_paths_resolve"]


def test_an_erratum_names_a_row_by_a_cell() -> None:
    text = FILES["ck10/errata.yaml"].decode()
    named = text.replace("position_loop_gains/rows/23", "position_loop_gains/rows/value=23")
    assert named != text
    spec = read({**FILES, "ck10/errata.yaml": named.encode()}).devices["ck10"]
    version = spec.versions()[-1]
    facts = [[erratum.fact for erratum in own.at(version)[0].errata] for own in (spec, DEVICES["ck10"])]
    assert facts[0] == facts[1]
    assert _faults(spec) == []


def test_a_row_that_an_erratum_names_by_a_cell_may_move() -> None:
    files = {**FILES, "ck10/errata.yaml": FILES["ck10/errata.yaml"].replace(b"s/rows/23", b"s/rows/value=23")}
    rows = files["ck10/tables-and-notes.yaml"].decode()
    first = "      - {cells: [0, 1, 1]"
    assert rows.count(first) == 1
    files["ck10/tables-and-notes.yaml"] = rows.replace(first, f"      - {{cells: [64, 5, 1]}}\n{first}").encode()
    spec = read(files).devices["ck10"]
    facts = {erratum.id: erratum.fact for erratum in spec.at(spec.versions()[-1])[0].errata}
    assert facts["position-loop-gain-23"] == "lookups/position_loop_gains/rows/24"


def _faults(spec: DeviceSpec) -> list[str]:
    """The findings about the errata of a device."""
    return [fault.code for proof in errata_proofs(spec) for fault in proof.faults]


def test_a_device_is_judged_without_a_cache_too() -> None:
    device = newest(TEST_SPECS, "caller").device
    assert everything(device, []) == everything(device, [], remembered=FindingsCache()) == []
