"""Who has compared what is recorded, and told again with what has changed since."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import CommandLine
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.tools.audit.review import State, reviewed, reviews_of, since, state_hash, states, uncited
from fieldspec.tools.facts import rows
from layouts import layout_at
from spec_files import DEVICE, codes, gadget

ROWS = """
registers:
  - group: all
    section: "1"
    rows:
      - {at: 0, name: a, type: u16, source: L1}
      - {at: 1, name: b, type: u16, source: %s}
"""


@pytest.fixture
def run(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> CommandLine:
    (tmp_path / "gadget").mkdir()
    (tmp_path / "gadget" / "device.yaml").write_text(DEVICE + ROWS % "2 L2", "utf-8")
    return CommandLine(capsys, monkeypatch, tmp_path)


def state(text: str) -> dict[str, State]:
    return states([rows(layout_at(gadget(text), "1"))])


def change(run: CommandLine, old: str, new: str) -> None:
    path = run.folder / "gadget" / "device.yaml"
    text = path.read_text("utf-8")
    assert old in text
    path.write_text(text.replace(old, new), "utf-8")


def rows_since(run: CommandLine) -> list[tuple[str, str]]:
    """The sections with what has changed in them since they were compared."""
    tables = run.json("audit", "gadget")["sections"]["sign_off"]["tables"]
    return [(row["section"], row["since"]) for row in tables["reviewed"]]


def review_file(run: CommandLine) -> str:
    return (run.folder / "gadget" / "review.yaml").read_text("utf-8")


def test_facts_are_of_the_section_that_prints_them() -> None:
    assert {section: len(state.digests) for section, state in state(ROWS % "2 L2").items()} == {"1": 1, "2": 1}


def test_a_state_is_of_what_facts_say_and_not_of_the_lines() -> None:
    assert state(ROWS % "2 L2")["2"].hash == state(ROWS % "2 L7")["2"].hash
    assert state(ROWS % "2 L2")["2"].hash != state(ROWS % "2 L2, unit: mm")["2"].hash


def test_a_section_that_was_signed_is_as_it_was(run: CommandLine) -> None:
    assert run("audit", "gadget", "--sign", "1", "--by", "second reader", "--on", "2026-05-03").code == 0
    assert rows_since(run) == [("1", "as it was"), ("2", "it is not compared with the manual")]


def test_a_fact_that_changes_after_the_review_is_told(run: CommandLine) -> None:
    run("audit", "gadget", "--sign", "all", "--by", "second reader", "--on", "2026-05-03")
    change(run, "name: b, type: u16", "name: b, type: i16")
    texts = dict(rows_since(run))
    assert texts["1"] == "as it was"
    assert texts["2"] == "1 facts are new or changed; 1 were removed or changed"
    tables = run.json("audit", "gadget")["sections"]["sign_off"]["tables"]
    assert [row["fact"] for row in tables["changed_since"]] == ["registers/b"]


def test_another_text_of_the_manual_is_told(run: CommandLine) -> None:
    run("audit", "gadget", "--sign", "1", "--by", "second reader", "--on", "2026-05-03")
    change(run, "0" * 64, "1" * 64)
    assert dict(rows_since(run))["1"] == "compared with another text of the manual"


def test_several_reviews_follow_each_other_and_a_state_is_written_once(run: CommandLine) -> None:
    run("audit", "gadget", "--sign", "1", "--by", "first transcription", "--on", "2026-05-03")
    run(
        "audit",
        "gadget",
        "--sign",
        "1",
        "--by",
        'a "second": {reader} # of all',
        "--on",
        "2026-05-04",
        "--how",
        "By eye.",
    )
    assert review_file(run).count("facts: ") == 1
    tables = run.json("audit", "gadget")["sections"]["sign_off"]["tables"]
    assert [(row["by"], row["date"], row["how"]) for row in tables["readings"]] == [
        ("first transcription", "2026-05-03", ""),
        ('a "second": {reader} # of all', "2026-05-04", "By eye."),
    ]
    assert run("check", "gadget").code == 0


def test_a_chapter_stands_for_its_sections() -> None:
    sections = {"9": "9 L1", "9.1": "9.1 L2", "9.10": "9.10 L3", "91": "91 L4"}
    rows = "".join(
        f"      - {{at: {n}, name: r{n}, type: u16, source: {s}}}\n" for n, s in enumerate(sections.values())
    )
    sections_by_name = state("registers:\n  - group: all\n    rows:\n" + rows)
    from fieldspec.command.audit_inputs.audit_files import _picked

    assert list(_picked(sections_by_name, "9")) == ["9", "9.1", "9.10"]


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (("--sign", "1"), "--sign records who made the comparison"),
        (("--sign", "1", "--by", " "), "--sign records who made the comparison"),
        (("--sign", "7", "--by", "x"), "there is no section of the manual that facts cite 7"),
        (("--sign", "1", "--by", "x", "--on", "2026-02-30"), "--on 2026-02-30 is not a date"),
        (("--sign", "1", "--by", "x", "--on", "9998-02-03"), "--on 9998-02-03 is in the future"),
        (("--sign", "1", "--by", "x", "--dump", "d.csv"), "--sign and --dump cannot be combined"),
        (("--sign", "1", "--by", "x", "--as-printed"), "--sign and --as-printed cannot be combined"),
        (("--sign", "1", "--by", "x", "--manual", "m.txt"), "--sign reads no manual, so --manual has no effect"),
        (("--sign", "1", "--by", "x", "--format", "json"), "--sign prints no report, so --format has no effect"),
        (("--record", "--manual", "m.txt", "--table", "ledger"), "--record prints no report, so --table has no effect"),
        (("--by", "x"), "--by goes with --sign SECTION"),
        (("--on", "2026-02-03"), "--on goes with --sign SECTION"),
    ],
)
def test_a_review_that_cannot_be_recorded_writes_nothing(
    run: CommandLine, arguments: tuple[str, ...], expected: str
) -> None:
    ran = run("audit", "gadget", *arguments)
    assert ran.code == 2
    assert expected in ran.err
    assert not (run.folder / "gadget" / "review.yaml").exists()


def test_a_file_behind_which_no_entry_can_follow_is_left_alone(run: CommandLine) -> None:
    path = run.folder / "gadget" / "review.yaml"
    path.write_text("notes:\n  - {name: a, text: A note.}\n", "utf-8")
    ran = run("audit", "gadget", "--sign", "1", "--by", "x")
    assert ran.code == 2
    assert "must end with the list `reviews`" in ran.err
    assert path.read_text("utf-8") == "notes:\n  - {name: a, text: A note.}\n"


def with_review(**changed: str) -> DeviceSpec:
    state_of_section = state(ROWS % "2 L2")["1"]
    entry = {"section": '"1"', "state": f'"{state_of_section.hash}"', "facts": "".join(state_of_section.digests)}
    signed = ", ".join(f"{key}: {value}" for key, value in {**entry, **changed}.items() if key != "date")
    day = changed.get("date", "2026-05-03")
    text = f"reviews: [{{by: x, date: {day}, manual: {'0' * 64}, sections: [{{{signed}}}]}}]\n"
    return gadget(ROWS % "2 L2" + text)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({}, []),
        ({"date": "2026-02-30"}, ["there is no date 2026-02-30"]),
        ({"facts": "'*!'"}, ["these are not the hashes of facts"]),
        ({"state": "0123456789abcdef"}, ["the state of section 1 is 0123456789abcdef"]),
    ],
)
def test_a_review_that_was_written_by_hand_is_found(changed: dict[str, str], message: list[str]) -> None:
    _, findings = reviews_of(with_review(**changed))
    assert [finding.message[: len(text)] for finding, text in zip(findings, message, strict=False)] == message
    assert set(codes(findings)) <= {"reviews_sound"}
    assert bool(findings) is bool(message)


def test_a_review_of_a_section_that_no_fact_cites_is_found() -> None:
    reviews, _ = reviews_of(with_review(section='"8.22"'))
    assert codes(list(uncited(state(ROWS % "2 L2"), reviews))) == ["reviews_sound"]


def test_the_latest_review_comes_first() -> None:
    states = state(ROWS % "2 L2")
    review = reviews_of(with_review())[0][0]
    (section,) = [r for r in reviewed(states, [review, review], review.manual) if r.section == "1"]
    assert len(section.reviews) == 2
    assert all(changes.same for _, changes in section.reviews)


def test_nothing_is_the_same_as_a_state_with_other_facts() -> None:
    state_of_section = state(ROWS % "2 L2")["1"]
    signed = reviews_of(with_review())[0][0].sections[0]
    other = State({"AAAA": ("registers/x",)})
    assert since(state_of_section, signed, False).same
    assert since(other, signed, False).changed == ("registers/x",)
    assert state_hash(state_of_section.digests) == state_of_section.hash
