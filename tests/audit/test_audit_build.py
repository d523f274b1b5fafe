"""A build writes the audit of a device beside its documentation, and anew where what it is made from has changed."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from command_line import TEST_SPECS
from fieldspec.cli import main
from fieldspec.tools.audit.manual_lines import NAME, index_of, index_text

SPECS = Path(__file__).parent / "right"
AUDIT = "docs/pump/audit.html"


@pytest.fixture
def specs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    shutil.copytree(SPECS, tmp_path / "specs")
    return tmp_path / "specs"


def build(specs: Path, *arguments: str) -> int:
    return main(["build", *arguments, "--specs", str(specs), "--out", str(specs.parent / "out")])


def text(specs: Path, path: str = AUDIT) -> str:
    return (specs.parent / "out" / path).read_text("utf-8")


def recorded(specs: Path) -> Path:
    """The index of the manual beside the spec."""
    path = specs / "pump" / NAME
    path.write_text(index_text(index_of("pump.txt", (SPECS.parent / "pump.txt").read_bytes()), "pump"), "utf-8")
    return path


def test_the_audit_is_a_part_of_the_documentation(specs: Path) -> None:
    recorded(specs)
    assert build(specs, "--to", "docs") == 0
    assert "No finding in any part of the audit." in text(specs)
    assert 'href="audit.html"' in text(specs, "docs/pump/index.html")
    assert build(specs, "--to", "docs", "--check") == 0


def test_other_outputs_have_no_audit(specs: Path) -> None:
    assert build(specs, "--to", "vectors") == 0
    assert not (specs.parent / "out" / "docs").exists()


def test_a_change_of_the_index_makes_the_page_anew(specs: Path) -> None:
    index = recorded(specs)
    assert build(specs, "--to", "docs") == 0
    before = text(specs)
    index.unlink()
    assert build(specs, "--to", "docs") == 0
    assert text(specs) != before
    recorded(specs)
    assert build(specs, "--to", "docs") == 0
    assert text(specs) == before


def test_an_index_that_cannot_be_read_stops_its_device(specs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    recorded(specs).write_bytes(b"\xff\xfe")
    assert build(specs, "--to", "docs") == 1
    assert "pump/manual.index" in capsys.readouterr().err
    assert not (specs.parent / "out").exists()


def test_a_device_at_some_of_its_versions_has_no_audit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    out = tmp_path / "out"
    assert main(["build", "glider-x@1.1", "--to", "docs", "--specs", str(TEST_SPECS), "--out", str(out)]) == 0
    assert (out / "docs/glider-x/index.html").exists()
    assert not (out / "docs/glider-x/audit.html").exists()


def test_a_review_is_in_the_page_of_the_next_build(specs: Path) -> None:
    recorded(specs)
    assert build(specs, "--to", "docs") == 0
    assert "second reader" not in text(specs)
    arguments = ["--sign", "all", "--by", "second reader", "--on", "2026-05-03", "--specs", str(specs)]
    assert main(["audit", "pump", *arguments]) == 0
    assert build(specs, "--to", "docs") == 0
    assert "second reader" in text(specs)
