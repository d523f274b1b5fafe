"""The four specs account for everything in their manuals, from the recorded indexes and from the texts themselves.

The texts are not in the repository; where the folder with them is not beside it, those tests are skipped.
"""

from __future__ import annotations

import hashlib
import random
import re
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path

import pytest

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.tools.audit.accounting import OPEN, Accounts, accounts_of
from fieldspec.tools.audit.citations import CitationResults, citation_results
from fieldspec.tools.audit.coverage import coverage
from fieldspec.tools.audit.line_facts import LineCitations, LineFacts, line_citations
from fieldspec.tools.audit.manual_lines import (
    NAME,
    AlignedManual,
    ManualIndex,
    aligned,
    index_of,
    index_text,
    parsed,
    unmoved,
)
from fieldspec.tools.audit.plan import Plan, plan_of
from fieldspec.tools.audit.section import Section, Subject
from fieldspec.tools.facts import FactRow, rows

ROOT = Path(__file__).resolve().parent.parent
SPECS = ROOT / "specs"
PAGE = ROOT / "docs" / "readings.md"
MANUALS = ROOT.parent / "shared" / "manuals"
DEVICES = sorted(path.parent.name for path in SPECS.glob(f"*/{NAME}"))

LEAST_NEEDED = {"ck10": 0.9, "esc11": 0.95, "hiwin-e": 0.8, "tc100": 0.9}
"""The share of the facts with a number that the patterns would miss if they were gone, at least."""


@cache
def spec(device: str) -> DeviceSpec:
    """The spec of a device."""
    files = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.glob("*/*.yaml"))}
    return read(files, frozenset({device})).devices[device]


@cache
def layouts(device: str) -> tuple[DeviceLayout, ...]:
    """The layouts of all its versions."""
    return tuple(device_layout(spec(device).at(version)[0]) for version in spec(device).versions())


@cache
def facts(device: str) -> tuple[list[FactRow], ...]:
    """The facts of all its versions."""
    return tuple(map(rows, layouts(device)))


@cache
def recorded(device: str) -> ManualIndex:
    """The index beside its spec."""
    path = SPECS / device / NAME
    return parsed(str(path), path.read_text("utf-8"))


def text(device: str) -> bytes:
    """Its manual; the test is skipped where it is not there."""
    path = MANUALS / layouts(device)[-1].device.manual.file
    if not path.exists():
        pytest.skip(f"there is no {path}")
    return path.read_bytes()


def covered(device: str, manual: ManualIndex | None = None) -> Section:
    """The coverage of its manual, from the index or from another text."""
    newest = layouts(device)[-1]
    return coverage(Subject(spec(device), newest, layouts(device), facts(device), (), recorded(device), manual))


@cache
def planned(device: str) -> tuple[Plan, LineCitations]:
    """How its manual is read, and what cites each line."""
    audit_plan, findings = plan_of(spec(device), len(recorded(device).lines))
    assert audit_plan is not None
    assert findings == []
    return audit_plan, line_citations(spec(device), layouts(device), facts(device))


def accounts_with(device: str, manual: AlignedManual, citations: LineCitations | None = None) -> Accounts:
    """What is accounted for in a text of its manual."""
    audit_plan, known = planned(device)
    return accounts_of(manual, audit_plan, citations or known)


def judgement(device: str, manual: AlignedManual) -> CitationResults:
    """Which citations hold."""
    return citation_results([layout.device for layout in layouts(device)], manual, planned(device)[0])


def test_every_device_has_an_index() -> None:
    assert sorted(path.parent.name for path in SPECS.glob("*/device.yaml")) == DEVICES


@pytest.mark.parametrize("device", DEVICES)
def test_nothing_is_unaccounted_and_no_citation_fails(device: str) -> None:
    assert [finding.message for finding in covered(device).findings] == []


def test_the_documentation_gives_the_numbers_of_the_manuals(accept: bool) -> None:
    page = PAGE.read_text("utf-8")
    fresh = page
    for device in DEVICES:
        places, corrected, left_out, unaccounted, needed, _, figure = covered(device).figures
        cells = [places.whole, places.number, corrected.number, left_out.number, unaccounted.number]
        fractions = [f"{figure.number} of {figure.whole}" for figure in (needed, figure)]
        row = f"| `{device}` | {' | '.join(map(str, [*cells, *fractions]))} |"
        fresh = re.sub(rf"^\| `{device}` \|(?: \d+ \|){{5}} \d+ of .*", row, fresh, flags=re.MULTILINE)
    if accept:
        PAGE.write_text(fresh, "utf-8", newline="\n")
    assert fresh.count(" of ") > 8
    assert PAGE.read_text("utf-8") == fresh


@pytest.mark.parametrize("device", DEVICES)
def test_most_facts_would_be_missed(device: str) -> None:
    needed = accounts_with(device, unmoved(recorded(device))).needed
    numbered = judgement(device, unmoved(recorded(device))).numbered
    assert len(needed & numbered.keys()) >= LEAST_NEEDED[device] * len(numbered)


@pytest.mark.proof(2)
@pytest.mark.parametrize("device", DEVICES)
def test_a_fact_that_is_gone_is_noticed(device: str) -> None:
    known = planned(device)[1]
    manual = unmoved(recorded(device))
    needed = sorted(accounts_with(device, manual).needed)
    for gone in random.Random(1).sample(needed, 12):
        by_line = {
            line: LineFacts(
                [row for row in figure.facts if not f"{row['path']}/".startswith(f"{gone}/")], figure.errata
            )
            for line, figure in known.by_line.items()
        }
        left = accounts_with(device, manual, LineCitations(by_line, known.lines, known.elided))
        assert OPEN in {candidate.status for candidate in left.candidates}, gone


@pytest.mark.parametrize("device", DEVICES)
def test_the_index_is_that_of_the_manual(device: str) -> None:
    index = index_of("manual", text(device))
    assert index_text(index, device) == (SPECS / device / NAME).read_text("utf-8")
    assert index.sha256 == layouts(device)[-1].device.manual.sha256


@pytest.mark.parametrize("device", DEVICES)
def test_the_text_itself_says_the_same(device: str) -> None:
    section = covered(device, index_of("manual", text(device)))
    assert [finding.message for finding in section.findings] == []
    assert section.figures == covered(device).figures


@pytest.mark.parametrize("device", DEVICES)
def test_lines_that_are_inserted_and_removed_move_the_citations_along(device: str) -> None:
    chosen = random.Random(device)
    lines = recorded(device).lines
    numbers = [number for number, digest in enumerate(recorded(device).digests) if digest or chosen.random() > 0.5]
    shifted = []
    for number in numbers:
        shifted += ["inserted in another edition"] if chosen.random() < 0.02 else []
        shifted.append(number)
    other = ManualIndex(
        hashlib.sha256(b"another").hexdigest(),
        [recorded(device).digests[number] if isinstance(number, int) else "0000abcd" for number in shifted],
        [lines[number] if isinstance(number, int) else "…" for number in shifted],
        recorded(device).file,
        recorded(device).offset,
    )
    section = covered(device, other)
    assert [finding.message for finding in section.findings] == []
    assert any("(100 %)" in text for text in section.paragraphs)


@pytest.mark.parametrize("device", DEVICES)
def test_a_line_that_is_changed_fails_what_it_alone_is_cited_for(device: str) -> None:
    audit_plan, known = planned(device)
    index = recorded(device)
    alone = sorted(
        (line, str(row["path"]))
        for line, figure in known.by_line.items()
        for row in figure.facts
        if row["kind"] in ("register", "bit", "enum_value", "parameter")
        and re.fullmatch(rf"\S+ L{line}", str(row["sources"]))
        and not any(
            fnmatchcase(str(row["path"]), like) for unprinted in audit_plan.unprinted for like in unprinted.facts
        )
    )
    for number, path in random.Random(device).sample(alone, 8):
        texts = [line if at != number else "…" for at, line in enumerate(index.lines, 1)]
        digests = [digest if at != number else "0000abcd" for at, digest in enumerate(index.digests, 1)]
        other = ManualIndex("0" * 64, digests, texts, index.file, index.offset)
        failing = judgement(device, aligned(index, other)).missing
        assert any(f"{path}/".startswith(f"{missing.path}/") for missing in failing), path


@pytest.mark.parametrize("device", DEVICES)
def test_indexes_hold_no_long_run_of_words(device: str) -> None:
    longest = max(len(run.split()) for line in recorded(device).lines for run in line.replace("|", "…").split("…"))
    assert longest < 45
    assert set().union(*recorded(device).lines) <= {"…", *map(chr, range(128))}
