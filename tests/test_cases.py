"""Every rule has folders of specs that break it, with the findings that they must have, and of specs that keep it.

A case is a folder `cases/<rule>/failing*` or `cases/<rule>/passing*`. Its `*.yaml` are the files of one device, or, in
folders, those of several devices and protocols. `expected.txt` holds the findings of a failing case. `limits.json`
sets limits of the compiler to other values, where the real ones would ask for a large file. Of rules of audits, a case
also has `manual.txt`, the text of which an index stands beside the spec, `dump.csv`, what the device held, or
`evidence`, a folder with units and perhaps a baseline.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from fieldspec.command.audit_inputs.evidence_audit import folder_report
from fieldspec.command.pipeline import checked, layouts, load, refusals
from fieldspec.command.rendering.finding_text import concise
from fieldspec.command.rules import all_rules, rule
from fieldspec.command.sources.spec_files import files as specs
from fieldspec.foundation.source import SourceFile
from fieldspec.language.diagnostics import Diagnostic, in_order
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.targets import OUTPUTS
from fieldspec.tools.audit.coverage import coverage
from fieldspec.tools.audit.manual_lines import index_of
from fieldspec.tools.audit.register_dump import compared, judged
from fieldspec.tools.audit.review import sign_off
from fieldspec.tools.audit.section import Subject
from fieldspec.tools.audit.statements import statements
from fieldspec.tools.evidence.report import baseline
from fieldspec.tools.facts import rows
from fieldspec.tools.lists.dump import dump
from fieldspec.tools.lists.text_sheet import text_sheet

CASES = Path(__file__).parent / "cases"
FOLDERS = sorted(path for pattern in ("failing*", "passing*") for path in CASES.glob(f"*/{pattern}"))


def name(folder: Path) -> str:
    return folder.relative_to(CASES).as_posix()


def audited(folder: Path, spec: DeviceSpec) -> list[Diagnostic]:
    """The findings of an audit: from the manual and the reviews, or from a dump where the case has one."""
    versions = layouts(spec)
    path, manual = folder / "dump.csv", folder / "manual.txt"
    if (folder / "evidence").is_dir():
        recorded = folder / "baseline.json"
        old = baseline(recorded.name, recorded.read_text("utf-8")) if recorded.exists() else None
        return [*folder_report(folder / "evidence", old, versions[-1], {})[1]]
    if path.exists():
        data = path.read_bytes()
        file = SourceFile(path.name, data.decode("utf-8"))
        starts = {row: file.text.index(line) for row, line in enumerate(file.text.splitlines(), 1)}
        return judged(compared(versions[-1], dump(text_sheet(data), {})), file, starts)
    index = index_of(manual.name, manual.read_bytes()) if manual.exists() else None
    subject = Subject(spec, versions[-1], versions, [*map(rows, versions)], (), index)
    return [finding for part in (coverage, statements, sign_off) for finding in part(subject).findings]


def findings_text(folder: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """The findings of a case as text."""
    limits = folder / "limits.json"
    for limit, value in json.loads(limits.read_text("utf-8")).items() if limits.exists() else ():
        monkeypatch.setattr(limit, value)
    files = {f"gadget/{path.name}": path.read_bytes() for path in sorted(folder.glob("*.yaml"))} or specs(folder)
    assert files, f"{name(folder)} has no spec"
    project = load(files)
    findings = checked(project)
    stage = rule(folder.parent.name)
    if stage is not None and stage.stage == "audits" and not findings:
        findings = in_order(finding for spec in project.devices.values() for finding in audited(folder, spec))
    if stage is not None and stage.stage == "outputs" and not findings:
        findings = in_order(
            finding for spec in project.devices.values() for finding in refusals(layouts(spec), OUTPUTS)
        )
    return concise(findings)


@pytest.mark.parametrize("folder", [f for f in FOLDERS if f.name.startswith("failing")], ids=name)
def test_broken_spec_has_the_expected_findings(folder: Path, accept: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    text = findings_text(folder, monkeypatch)
    expected = folder / "expected.txt"
    if accept:
        expected.write_text(text, "utf-8", newline="\n")
    assert f": {folder.parent.name}: " in text
    assert text == expected.read_text("utf-8")


@pytest.mark.parametrize("folder", [f for f in FOLDERS if f.name.startswith("passing")], ids=name)
def test_good_spec_has_no_findings(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert findings_text(folder, monkeypatch) == ""


@pytest.mark.parametrize("kind", ["failing", "passing"])
def test_every_rule_has_a_case(kind: str) -> None:
    cased = {folder.parent.name for folder in FOLDERS if folder.name.startswith(kind)}
    assert cased == {rule.code for rule in all_rules()}
