"""The ledger of errata: what is printed and used, the verdict and its evidence, as text and as lists."""

from __future__ import annotations

import csv
import io
from collections import Counter
from pathlib import Path

import pytest

from command_line import SPECS, CommandLine
from fieldspec.command.rendering.audit_formats import as_csv, as_xlsx
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.tools.audit.ledger import COLUMNS, EFFECTS, KINDS, by_effect, verdict
from fieldspec.tools.audit.section import SectionTable
from fieldspec.tools.lists.workbook_reader import workbook_sheet
from fieldspec.tools.proofs.running import errata_proofs

HERE = Path(__file__).parent
FILES = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in sorted(SPECS.glob("*/*.yaml"))}
DEVICES = read(FILES).devices
RIGHT = {path.relative_to(HERE / "right").as_posix(): path.read_bytes() for path in (HERE / "right").glob("*/*.yaml")}
HOSTILE = ("=cmd|' /C calc'!A0", "+1+2", "-a", "@SUM(A1)", "*/", "{{", 'a"b,c', "伺服;\u2028x", "line\nbreak", "\\")


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    return CommandLine(capsys, monkeypatch, HERE / "right")


def changed(old: str, new: str) -> DeviceSpec:
    text = RIGHT["pump/errata.yaml"].decode()
    assert text.count(old) == 1
    return read({**RIGHT, "pump/errata.yaml": text.replace(old, new).encode()}).devices["pump"]


@pytest.mark.parametrize("spec", DEVICES.values(), ids=list(DEVICES))
def test_every_erratum_of_a_device_has_one_verdict_and_none_is_unproven(spec: DeviceSpec) -> None:
    every = {erratum.id for version in spec.versions() for erratum in spec.at(version)[0].errata}
    proofs = errata_proofs(spec)
    assert Counter(proof.erratum.id for proof in proofs) == Counter(every)
    assert {verdict(proof) for proof in proofs} <= {"proven", "judgement", "open"}


@pytest.mark.parametrize("spec", DEVICES.values(), ids=list(DEVICES))
def test_what_is_proven_has_the_finding_of_the_named_check_as_its_evidence(spec: DeviceSpec) -> None:
    for proof in errata_proofs(spec):
        named = {finding.code for finding in proof.evidence}
        assert named == ({proof.erratum.proof} if verdict(proof) == "proven" else set())


@pytest.mark.parametrize("spec", DEVICES.values(), ids=list(DEVICES))
def test_an_effect_on_the_wire_is_one_of_something_that_is_printed(spec: DeviceSpec) -> None:
    for proof in errata_proofs(spec):
        if proof.erratum.effect == "bytes":
            assert proof.erratum.printed, proof.erratum.id


def test_the_worst_effect_comes_first() -> None:
    effects = [proof.erratum.effect for proof in by_effect(errata_proofs(DEVICES["esc11"]))]
    assert effects == sorted(effects, key=list(EFFECTS).index)
    assert set(effects) == set(EFFECTS)


def test_an_erratum_whose_proof_does_not_fail_is_not_proven() -> None:
    spec = changed("proof: default_within_range", "proof: bits_unique")
    unproven = [proof for proof in errata_proofs(spec) if verdict(proof) == "not proven"]
    assert [(proof.erratum.id, proof.faults[0].code) for proof in unproven] == [("speed-range", "errata_proven")]


def test_an_erratum_whose_proof_does_not_fail_is_a_finding_of_the_audit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "pump").mkdir()
    for path in (HERE / "right" / "pump").iterdir():
        text = path.read_text("utf-8").replace("proof: default_within_range", "proof: bits_unique")
        (tmp_path / "pump" / path.name).write_text(text, "utf-8")
    ran = CommandLine(capsys, monkeypatch, tmp_path)("audit", "pump")
    assert ran.code == 1
    assert "1 of 14 errata whose proof does not fail" in ran.lines
    assert "error[errata_proven]: with the printed value, `bits_unique` still passes" in ran.out


def test_a_judgement_that_nothing_decides_is_open() -> None:
    text = "confidence: certain\n    effect: range\n    proof: default_within_range"
    judged = changed(text, "confidence: likely\n    effect: range\n    proof: judgement")
    left = changed(text, "confidence: open\n    effect: range\n    proof: judgement")
    assert [Counter(verdict(proof) for proof in errata_proofs(spec))["proven"] for spec in (judged, left)] == [13, 13]
    assert {verdict(proof) for proof in errata_proofs(judged)} == {"proven", "judgement"}
    assert {verdict(proof) for proof in errata_proofs(left)} == {"proven", "open"}


def test_a_row_says_print_use_reason_proof_and_evidence(run: CommandLine) -> None:
    (row,) = [row for row in run.json("audit", "pump", "--table", "ledger") if row["erratum"] == "pressure-address"]
    assert {key: row[key] for key in COLUMNS if key not in ("spec", "reason")} == {
        "effect": "wrong bytes",
        "erratum": "pressure-address",
        "fact": "registers/pressure",
        "printed": "at 0x1001",
        "literal": None,
        "used": "at 0x1004",
        "confidence": "certain",
        "verdict": "proven",
        "proof": "addresses_disjoint",
        "evidence": "pressure at 0x1001 overlaps inputs",
        "versions": None,
        "source": "2.1 L21",
    }
    assert row["spec"]["line"] == 3


def test_the_ledger_as_text_says_it_line_by_line(run: CommandLine) -> None:
    lines = run("audit", "pump", "--table", "ledger").lines
    start = lines.index("wrong bytes, pressure-address")
    assert lines[start + 1 : start + 4] == [
        "    fact: registers/pressure",
        "    printed: at 0x1001",
        "    used: at 0x1004",
    ]
    assert lines[start + 7] == "    proof: addresses_disjoint"
    assert sum(not line.startswith(" ") for line in lines) == 14


def test_the_ledger_as_csv_and_xlsx_says_the_same(run: CommandLine, tmp_path: Path) -> None:
    text = run("audit", "pump", "--table", "ledger", "--format", "csv").out
    rows = list(csv.reader(io.StringIO(text)))
    file = tmp_path / "ledger.xlsx"
    ran = run("audit", "pump", "--table", "ledger", "--format", "xlsx", "--out", str(file))
    assert (ran.code, ran.out) == (0, "")
    cells = [list(row.cells) for row in workbook_sheet(file.read_bytes()).rows]
    width = len(COLUMNS)
    assert rows[0] == list(COLUMNS)
    assert len(rows) == 15
    assert [row[:width] + [""] * (width - len(row)) for row in cells] == rows


def test_the_same_ledger_is_the_same_bytes(run: CommandLine) -> None:
    once, again = (run("audit", "pump", "--table", "ledger", "--format", "csv").out for _ in range(2))
    assert once == again


@pytest.mark.parametrize("text", HOSTILE)
def test_hostile_cells_are_no_formulas_and_stay_in_their_rows(text: str) -> None:
    table = SectionTable("ledger", "Ledger", ("a", "b"), ((text, 1), ("next", 2)))
    rows = list(csv.reader(io.StringIO(as_csv(table).decode())))
    assert [row[1] for row in rows] == ["b", "1", "2"]
    assert not rows[1][0].startswith(("=", "+", "-", "@"))
    sheet = workbook_sheet(as_xlsx(table))
    assert not sheet.formulas
    assert [row.cells[1] for row in sheet.rows] == ["b", "1", "2"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("--format", "csv"), "csv holds a single table; name it with --table"),
        (("--table", "ledger", "--format", "sarif"), "use --table with text, json, csv or xlsx"),
        (("--out", "x.csv"), "such as --table ledger"),
        (("--table", "ledger", "--out", "x"), "--out needs a format for the table"),
        (("--table", "legder"), "there is no table legder; did you mean ledger?"),
        (("--as-printed", "--table", "ledger"), "there is no table ledger"),
    ],
)
def test_wrong_use_says_what_to_do_and_writes_nothing(
    run: CommandLine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...], message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = run("audit", "pump", *arguments)
    assert ran.code == 2
    assert message in ran.err
    assert list(tmp_path.iterdir()) == []


def test_every_verdict_has_a_column_in_the_summary(run: CommandLine) -> None:
    rows = run.json("audit", "pump", "--table", "errata_by_effect")
    assert [row["effect"] for row in rows] == list(EFFECTS.values())
    assert [sum(row[kind] for kind in KINDS) for row in rows] == [row["errata"] for row in rows] == [8, 3, 2, 1]
