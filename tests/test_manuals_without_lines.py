"""A document with pages, and a page on the web, are manuals too: a source is a page, or a section alone."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path
from typing import NamedTuple

import pytest

from fieldspec.cli import main


class Kind(NamedTuple):
    """A kind of manual: its keys, a source in it, and what the outputs say of both."""

    manual: str
    source: str
    extent: str
    remark: str


KINDS = {
    "document": Kind(
        f'{{title: Scan, file: scan.pdf, sha256: "{"a" * 64}", pages: 40}}',
        "1.2 P17",
        "scan.pdf, 40 pages",
        "A note such as [8.2 P17] is a section and a page of it.",
    ),
    "page": Kind(
        '{title: Page, url: "https://example.com/drive", read: "2026-01-31"}',
        "1.2",
        "https://example.com/drive, read on 2026-01-31",
        "A note such as [8.2] is a section of it.",
    ),
}


@pytest.fixture(params=KINDS)
def kind(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Kind:
    """A kind of manual, with a device in an empty folder that has it."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("FIELDSPEC_SPECS", raising=False)
    assert main(["new", "device", "drive", "--protocol", "packet"]) == 0
    kind = KINDS[request.param]
    path = Path("specs/drive/device.yaml")
    text = re.sub(r"manual:\n(    .*\n)+", f"manual: {kind.manual}\n", path.read_text("utf-8"))
    path.write_text(text.replace("source: 1 L1", f"source: {kind.source}"), "utf-8")
    return kind


def test_it_passes_the_check(kind: Kind, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert main(["check"]) == 0
    assert capsys.readouterr().out == "no findings in drive\n"


def test_outputs_say_how_their_citations_are_read(kind: Kind) -> None:
    assert main(["build", "--to", "docs,scl"]) == 0
    page = Path("generated/docs/drive/1.md").read_text("utf-8")
    name, _, rest = kind.extent.partition(", ")
    assert f"`{name}`, {rest}; a source is a section" in page
    assert f"| {kind.source} |" in page
    sources = "".join(path.read_text("utf-8") for path in sorted(Path("generated/scl").rglob("*.scl")))
    assert kind.remark in " ".join(sources.replace("//", "").split())


def test_its_facts_have_a_source_and_no_line(kind: Kind, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert main(["facts", "drive", "--format", "csv"]) == 0
    facts = {row["path"]: row for row in csv.DictReader(io.StringIO(capsys.readouterr().out))}
    fact = facts["messages/read_status"]
    assert (fact["section"], fact["line"], fact["sources"]) == ("1.2", "", kind.source)


def test_an_audit_says_that_there_are_no_lines_to_compare(kind: Kind, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert main(["audit", "drive"]) == 0
    assert f"{kind.extent}. It has no lines that an audit could compare." in capsys.readouterr().out


@pytest.mark.parametrize("options", [["--manual", "scan.txt"], ["--manual", "scan.txt", "--record"]])
def test_no_text_is_compared_with_it(kind: Kind, options: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert main(["audit", "drive", *options]) == 2
    assert f"the manual of drive is {kind.extent}: without lines, {options[-1 if len(options) > 2 else 0]}" in (
        capsys.readouterr().err
    )
