"""The text of a manual on the command line: recorded, compared, and refused where it is none."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

import gauge
from command_line import CommandLine


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder of specs with the gauge, beside its manual."""
    (tmp_path / "gauge.txt").write_text(gauge.MANUAL, "utf-8", newline="\n")
    for path, text in gauge.files().items():
        (tmp_path / "specs" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "specs" / path).write_text(text, "utf-8", newline="\n")
    return tmp_path


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, folder: Path) -> CommandLine:
    return CommandLine(capsys, monkeypatch, folder / "specs")


def recorded(folder: Path) -> Path:
    """Where the index of the gauge is kept."""
    return folder / "specs" / "gauge" / "manual.index"


def test_a_manual_is_recorded_and_then_not_needed(run: CommandLine, folder: Path) -> None:
    manual = folder / "gauge.txt"
    ran = run("audit", "gauge", "--manual", str(manual), "--record")
    assert (ran.code, ran.lines) == (0, [f"wrote {recorded(folder)}: 19 lines"])
    manual.unlink()
    section = run.json("audit", "gauge")["sections"]["coverage"]
    assert section["findings"] == []
    assert [figure["number"] for figure in section["figures"][:4]] == [13, 0, 4, 0]
    assert run("audit", "gauge").code == 0


def test_recording_twice_writes_the_same_bytes(run: CommandLine, folder: Path) -> None:
    contents = []
    for _ in range(2):
        run("audit", "gauge", "--manual", str(folder / "gauge.txt"), "--record")
        contents.append(recorded(folder).read_bytes())
    assert contents[0] == contents[1]
    assert set(contents[0].decode()) <= {"…", *map(chr, range(128))}


def test_the_index_holds_no_sentence_of_the_manual(run: CommandLine, folder: Path) -> None:
    run("audit", "gauge", "--manual", str(folder / "gauge.txt"), "--record")
    text = recorded(folder).read_text("utf-8")
    assert "0102 H | 2 | Total" in text
    assert [words for words in ("all that has run", "at most", "the level") if words in text] == []


def test_a_device_without_an_index_says_how_to_record_it(run: CommandLine) -> None:
    ran = run("audit", "gauge")
    assert ran.code == 1
    assert "fieldspec audit gauge --manual FILE --record" in ran.out


def test_a_finding_shows_the_line_of_the_manual_at_hand(run: CommandLine, folder: Path) -> None:
    run("audit", "gauge", "--manual", str(folder / "gauge.txt"), "--record")
    other = folder / "next.txt"
    other.write_text(gauge.MANUAL.replace("0~1000", "0~2000"), "utf-8", newline="\n")
    ran = run("audit", "gauge", "--manual", str(other))
    assert ran.code == 1
    assert f"{other}:6:1: error[manual_accounted]" in ran.out
    assert "0100 H | 1 | Level | 0~2000 | the level" in ran.out
    assert "The text is another edition" in ran.out
    assert "12 of 13 lines with text are there unchanged (92 %)" in ran.out


def test_findings_are_sarif_too(run: CommandLine, folder: Path) -> None:
    run("audit", "gauge", "--manual", str(folder / "gauge.txt"), "--record")
    text = recorded(folder).read_text("utf-8").replace("0~1000", "0~2000")
    recorded(folder).write_text(text, "utf-8", newline="\n")
    results = json.loads(run("audit", "gauge", "--format", "sarif").out)["runs"][0]["results"]
    assert sorted(result["ruleId"] for result in results) == ["citations_hold", "manual_accounted"]
    (result,) = (result for result in results if result["ruleId"] == "manual_accounted")
    assert result["locations"][0]["physicalLocation"]["region"]["startLine"] == 10


BAD = [
    ("an empty file", b"", "is empty"),
    ("blanks alone", b" \n\t\n", "is empty"),
    ("a PDF", b"%PDF-1.7\n\x00\x01\x02", "is not a text"),
    ("UTF-16", gauge.MANUAL.encode("utf-16"), "is UTF-16"),
    ("another encoding", "1 \u5bc4\u5b58\u5668\n2 x".encode("gbk"), "is not UTF-8: line 1 has a byte BCh"),
    ("another text", b"one\ntwo\nthree\n", "is not this manual: 0 of its 13 lines"),
]


@pytest.mark.parametrize(("data", "message"), [case[1:] for case in BAD], ids=[case[0] for case in BAD])
def test_what_is_no_manual_is_refused(run: CommandLine, folder: Path, data: bytes, message: str) -> None:
    run("audit", "gauge", "--manual", str(folder / "gauge.txt"), "--record")
    before = recorded(folder).read_bytes()
    bad = folder / "bad.txt"
    bad.write_bytes(data)
    for more in ([], ["--record"]):
        ran = run("audit", "gauge", "--manual", str(bad), *more)
        assert ran.code == 2
        assert ran.out == ""
        assert len(ran.err.splitlines()) == 1
        if not more or "not this manual" not in message:
            assert message in ran.err
    assert recorded(folder).read_bytes() == before


def test_a_text_with_a_tenth_of_the_lines_is_another_edition(run: CommandLine, folder: Path) -> None:
    lines = [f"Line {number}\n" for number in range(7)]
    longer, manual = gauge.MANUAL + "".join(lines), folder / "gauge.txt"
    (folder / "specs/gauge/device.yaml").write_text(gauge.files(manual=longer)["gauge/device.yaml"], "utf-8")
    manual.write_text(longer, "utf-8", newline="\n")
    assert run("audit", "gauge", "--manual", str(manual), "--record").code == 0
    for text, code in ((lines[0], 2), ("".join(lines[:2]), 1)):
        manual.write_text(text, "utf-8", newline="\n")
        assert run("audit", "gauge", "--manual", str(manual)).code == code


def test_a_manual_with_a_byte_order_mark_is_the_manual(run: CommandLine, folder: Path) -> None:
    run("audit", "gauge", "--manual", str(folder / "gauge.txt"), "--record")
    marked = folder / "marked.txt"
    marked.write_bytes(b"\xef\xbb\xbf" + gauge.MANUAL.encode())
    ran = run("audit", "gauge", "--manual", str(marked))
    assert ran.code == 0
    assert "was saved in another way" in ran.out


def test_another_edition_is_not_recorded(run: CommandLine, folder: Path) -> None:
    other = gauge.MANUAL.replace("5000", "6000").encode()
    (folder / "next.txt").write_bytes(other)
    ran = run("audit", "gauge", "--manual", str(folder / "next.txt"), "--record")
    assert ran.code == 2
    assert f"sha256: {hashlib.sha256(other).hexdigest()}, lines: 19" in ran.err
    assert not recorded(folder).exists()


def test_a_file_that_is_not_there_is_wrong_use(run: CommandLine, folder: Path) -> None:
    ran = run("audit", "gauge", "--manual", str(folder / "none.txt"))
    assert (ran.code, ran.err) == (2, f"fieldspec: cannot read {folder / 'none.txt'}: No such file or directory\n")


def test_recording_needs_a_manual(run: CommandLine) -> None:
    ran = run("audit", "gauge", "--record")
    assert ran.code == 2
    assert "--manual FILE --record" in ran.err


@pytest.mark.parametrize("damage", [b"", b"\xff\xfe", b"# x\nsha256 0\nlines 1\n\n"])
def test_an_index_that_is_damaged_is_refused(run: CommandLine, folder: Path, damage: bytes) -> None:
    recorded(folder).write_bytes(damage)
    ran = run("audit", "gauge")
    assert ran.code == 2
    assert str(recorded(folder)) in ran.err
