"""Everything in a manual is covered, corrected, left out or not accounted for, and citations hold what they should."""

from __future__ import annotations

import pytest

import gauge
from fieldspec.tools.audit.section import SectionTable


def without(text: str, *lines: str) -> str:
    """A text without the lines that hold some words."""
    remaining = [line for line in text.splitlines(keepends=True) if not any(word in line for word in lines)]
    assert len(remaining) < len(text.splitlines())
    return "".join(remaining)


def changed(text: str, old: str, new: str) -> str:
    """A text with one piece changed."""
    assert text.count(old) == 1
    return text.replace(old, new)


def table(name: str, **texts: str) -> SectionTable:
    """A table of the coverage of the gauge."""
    return next(table for table in gauge.covered(**texts).tables if table.name == name)


def test_a_manual_that_is_transcribed_is_accounted_for() -> None:
    section = gauge.covered()
    assert gauge.finding_texts(section) == []
    assert gauge.numbers(section) == [13, 0, 4, 0, 17]


def test_every_fact_with_a_number_would_be_missed() -> None:
    figure = gauge.covered().figures[4]
    assert (figure.number, figure.whole) == (12, 12)


REMOVED = [
    ("a register", "name: total", "line 8 of the manual, section 1, prints `address` 0102, `words` 2, `name` Total"),
    ("a member of an enum", "name: stop", "line 7 of the manual, section 1, prints `code` 2"),
    ("a bit between two that are printed", "name: hatch", "line 9 of the manual, section 1, prints `bit` 1"),
]


@pytest.mark.parametrize(("row", "message"), [case[1:] for case in REMOVED], ids=[case[0] for case in REMOVED])
def test_a_fact_that_is_removed_is_not_accounted_for(row: str, message: str) -> None:
    messages = gauge.finding_texts(gauge.covered(without(gauge.DEVICE, row)))
    assert next(text for text in messages if "manual_accounted" in text).startswith(f"manual_accounted: {message}")


def test_an_example_that_is_removed_is_not_accounted_for() -> None:
    spec = gauge.DEVICE.partition("examples:")[0]
    (messages,) = gauge.finding_texts(gauge.covered(spec))
    assert messages.startswith(
        "manual_accounted: line 15 of the manual, section 2, prints `frame` 01 03 01 00 00 01 85 F6"
    )


WRONG = [
    ("an address", "at: 0x0102", "at: 0x0103", "address"),
    ("a size", "type: u32, checked: {words: 2}", "type: u16", "words"),
    ("a range", "range: 0..1000", "range: 0..100", "range"),
    ("a printed name", "printed_name: Mode", "printed_name: Made", "name"),
    ("a frame", "01 03 01 00 00 01 85 F6", "01 03 01 00 00 02 C5 F7", "frame"),
]


@pytest.mark.parametrize(("old", "new", "column"), [case[1:] for case in WRONG], ids=[case[0] for case in WRONG])
def test_a_value_unlike_the_print_is_not_accounted_for(old: str, new: str, column: str) -> None:
    messages = gauge.finding_texts(gauge.covered(changed(gauge.DEVICE, old, new)))
    assert [text for text in messages if text.startswith("manual_accounted") and f"`{column}`" in text]


UNPRINTED = [
    ("an end of a range", "range: 0..1000", "range: 0..1001", "`range` 1001"),
    ("the other end", "range: 0..1000", "range: -5..1000", "`range` -5"),
    ("an end of the range of writing", "range: 0..1000", "range: 0..1000, write_range: 0..999", "`write_range` 999"),
    ("a default", "range: 0..1000", "range: 0..1000, default: 7", "`default` 7"),
    ("a scale", "range: 0..1000", "range: 0..1000, scale: 0.1, unit: mm", "`scale` 0.1"),
    ("a number of elements", "type: u32, checked: {words: 2}", "type: u32, checked: {words: 2}, count: 7", "`count` 7"),
    ("a sign", "name: mode, printed_name: Mode, type: u16", "name: mode, printed_name: Mode, type: i16", "`type` i16"),
]


@pytest.mark.parametrize(("old", "new", "what"), [case[1:] for case in UNPRINTED], ids=[case[0] for case in UNPRINTED])
def test_a_value_that_the_cited_line_does_not_print_is_a_finding(old: str, new: str, what: str) -> None:
    messages = gauge.finding_texts(gauge.covered(changed(gauge.DEVICE, old, new)))
    assert [text for text in messages if text.startswith("citations_hold") and text.endswith(f"not print {what}")]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("range: 0..1000", "range: 0..1000, default: 7, inferred: {default: As all others.}"),
        ("range: 0..1000", "range: 0..65535, inferred: {range: All of the word.}"),
        ("range: 0..1000", "range: 0..10000, scale: 0.1, unit: mm, inferred: {scale: As it is shown.}"),
        ("range: 0..2, source: L7}", "range: 0..2, source: L7, inferred: {type: It turns both ways.}}"),
    ],
)
def test_what_is_inferred_or_follows_need_not_be_printed(old: str, new: str) -> None:
    spec = changed(gauge.DEVICE, old, new)
    spec = spec.replace("name: mode, printed_name: Mode, type: u16", "name: mode, printed_name: Mode, type: i16")
    messages = [text for text in gauge.finding_texts(gauge.covered(spec)) if text.startswith("citations_hold")]
    assert messages in ([], ["citations_hold: registers/mode cites 1 L7, where the manual does not print `type` i16"])
    assert bool(messages) == ("It turns" not in new)


def test_a_printed_number_below_zero_is_a_reason_for_a_sign() -> None:
    manual = gauge.MANUAL.replace("0 : hold 1 : run 2 : stop", "0 : hold 1 : run 2 : stop (-1 is an error)")
    spec = changed(
        gauge.DEVICE, "name: mode, printed_name: Mode, type: u16", "name: mode, printed_name: Mode, type: i16"
    )
    assert gauge.finding_texts(gauge.covered(spec, cited=manual)) == []


def test_an_erratum_of_another_key_does_not_excuse_a_value() -> None:
    spec = changed(gauge.DEVICE, "range: 0..1000", "range: 0..1001") + (
        "errata:\n  - {id: digit, fact: registers/level, printed: {words: 1}, reason: It is a height.,\n"
        "     confidence: certain, effect: range, proof: judgement, source: 1 L6}\n"
    )
    messages = gauge.finding_texts(gauge.covered(spec))
    assert "citations_hold: registers/level cites 1 L6, where the manual does not print `range` 1001" in messages


@pytest.mark.parametrize(("access", "is_accounted"), [("rw", True), ("ro", False)])
def test_an_access_that_a_pattern_states_in_words_is_that_of_the_fact(access: str, is_accounted: bool) -> None:
    spec = changed(gauge.DEVICE, "type: u32, checked: {words: 2},", "type: u32, checked: {words: 2}, access: rw,")
    audit = gauge.AUDIT.replace(
        "  patterns:\n",
        f'  patterns:\n    - {{name: total, kind: table_row, lines: "8", each: Total, access: {access}}}\n',
    )
    messages = gauge.finding_texts(gauge.covered(spec, audit))
    assert messages == [] if is_accounted else [text for text in messages if "prints `access` ro" in text]


def test_an_erratum_accounts_for_what_is_printed_wrongly() -> None:
    spec = changed(gauge.DEVICE, "range: 0..1000", "range: 0..100") + (
        "errata:\n  - {id: digit, fact: registers/level, printed: {range: 0..1000}, reason: A digit too many.,\n"
        "     confidence: certain, effect: range, proof: judgement, source: 1 L6}\n"
    )
    section = gauge.covered(spec)
    assert gauge.finding_texts(section) == []
    assert gauge.numbers(section) == [12, 1, 4, 0, 17]
    assert [row[1:4] for row in table("places", device=spec).rows if row[3] == "corrected"] == [
        (6, "rows of tables", "corrected")
    ]


def test_an_erratum_accounts_for_nothing_else() -> None:
    spec = changed(gauge.DEVICE, "range: 0..1000", "range: 0..100") + (
        "errata:\n  - {id: digit, fact: registers/level, printed: {range: 0..10}, reason: A digit is missing.,\n"
        "     confidence: certain, effect: range, proof: judgement, source: 1 L6}\n"
    )
    assert len(gauge.finding_texts(gauge.covered(spec))) == 1


def test_a_line_with_a_number_is_accounted_for_without_a_pattern() -> None:
    manual = gauge.MANUAL.replace("\n2 Frames", "Wait 50 ms after each write.\n2 Frames")
    (messages,) = gauge.finding_texts(gauge.covered(cited=manual))
    assert messages == "manual_accounted: line 10 of the manual, section 1, has numbers, and no fact cites it"
    noted = gauge.DEVICE + "notes:\n  - {name: wait, text: Wait 50 ms., source: 1 L10}\n"
    assert gauge.finding_texts(gauge.covered(noted, cited=manual)) == []


def test_a_remark_in_words_cites_a_line_too() -> None:
    manual = gauge.MANUAL.replace("\n2 Frames", "Wait 50 ms after each write.\n2 Frames")
    spec = changed(gauge.DEVICE, "printed_name: Level,", "printed_name: Level, doc: Wait 50 ms after writing (L10).,")
    assert gauge.finding_texts(gauge.covered(spec, cited=manual)) == []


def test_a_name_with_a_number_cites_nothing() -> None:
    manual = gauge.MANUAL.replace("\n2 Frames", "Wait 50 ms after each write.\n2 Frames")
    spec = changed(gauge.DEVICE, "printed_name: Level,", "printed_name: Level, label: Phase L10,")
    assert len(gauge.finding_texts(gauge.covered(spec, cited=manual))) == 1


def test_what_is_left_out_says_why_and_how_often() -> None:
    rows = [row[:4] for row in table("left_out").rows]
    assert rows == [
        (3, "1-2, 17-19", "", "Cover and warranty."),
        (1, "", "", "Headings of the sections."),
    ]


def test_a_section_that_is_left_out_hides_no_contradiction() -> None:
    manual = gauge.MANUAL.replace("Two years", "0102 H | 3 | Total | spare\nTwo years")
    audit = changed(gauge.AUDIT, 'kind: address, sections: ["1"]', 'kind: address, sections: ["1", "9"]')
    spec = changed(
        gauge.DEVICE, "words: 2}, source: L8}", "words: 2}, source: L8, restated: [{source: 9 L19, at: 0x0102}]}"
    )
    (messages,) = gauge.finding_texts(gauge.covered(spec, audit, cited=manual))
    assert messages.startswith("manual_accounted: line 19 of the manual, section 9, prints `words` 3")
    assert gauge.finding_texts(gauge.covered(audit=audit, cited=manual)) == []


def test_coverage_is_counted_by_section() -> None:
    rows = [row[:3] for row in table("sections").rows]
    assert rows == [("Front", "", 1), ("1", "Registers", 11), ("2", "Frames", 3), ("9", "Warranty", 2)]


MOVED = [
    ("a register", "u16, range: 0..1000, source: L6", "u16, range: 0..1000, source: L7", "`at` 0x0100"),
    ("a bit", "{bit: 3, name: lamp}", "{bit: 3, name: lamp, source: L8}", "`bit` 3"),
    ("a code", "{value: 2, name: stop}", "{value: 2, name: stop, source: 2 L14}", "`value` 2"),
    ("a frame", "source: 2 L15", "source: 2 L14", "`frame`"),
    ("an empty line", "source: 2 L15", "source: 2 L12", "on which nothing is printed"),
    ("a line of another section", "source: 2 L15", "source: 1 L15", "as one of section 1"),
]


@pytest.mark.parametrize(("old", "new", "message"), [case[1:] for case in MOVED], ids=[case[0] for case in MOVED])
def test_a_citation_that_leads_to_another_line_fails(old: str, new: str, message: str) -> None:
    messages = gauge.finding_texts(gauge.covered(changed(gauge.DEVICE, old, new)))
    assert [text for text in messages if text.startswith("citations_hold") and message in text]


def test_a_fact_that_is_not_printed_as_such_says_why() -> None:
    spec = changed(gauge.DEVICE, "{value: 2, name: stop}", "{value: 2, name: stop, source: 2 L14}")
    audit = gauge.AUDIT + '  unprinted:\n    - {facts: ["enums/mode/st*"], reason: It follows.}\n'
    manual = changed(gauge.MANUAL, " 2 : stop", "")
    before = gauge.finding_texts(gauge.covered(spec, cited=manual))
    assert [text for text in before if "citations_hold" in text]
    assert gauge.finding_texts(gauge.covered(spec, audit, cited=manual)) == []


UNSOUND = [
    ("a pattern that finds nothing", "lines: 6-7", "lines: 13-14", "the pattern `values` finds nothing"),
    ("a left-out that leaves nothing out", '[Front, "9"]', '[Front, "9"], like: "{value}:"', "this leaves out nothing"),
    ("a section that is not there", 'sections: ["2"], each', 'sections: ["7"], each', "there is no section 7"),
    ("lines that are not there", "lines: 6-7", "lines: 6-70", "there are no lines 6 to 70"),
    ("a column that is not there", "{code:decimal} :", "{colour} :", "nothing is called `colour`"),
    ("a form that is not there", '[Front, "9"]', '[Front, "9"], like: "{value:colour}"', "there is no form `colour`"),
    ("a broken placeholder", "{code:decimal} :", "{code decimal} :", "a placeholder is written as"),
    ("sections out of order", "line: 11", "line: 2", "not in the order of the manual"),
]


@pytest.mark.parametrize(("old", "new", "message"), [case[1:] for case in UNSOUND], ids=[case[0] for case in UNSOUND])
def test_a_plan_that_is_wrong_is_found(old: str, new: str, message: str) -> None:
    messages = gauge.finding_texts(gauge.covered(audit=changed(gauge.AUDIT, old, new)))
    assert [text for text in messages if text.startswith("audit_sound") and message in text]


def test_an_exception_that_nothing_needs_is_found() -> None:
    audit = gauge.AUDIT + "  unprinted:\n    - {facts: [registers/level], reason: No reason.}\n"
    assert ["contain them" in text for text in gauge.finding_texts(gauge.covered(audit=audit))] == [True]


def test_a_device_without_a_plan_says_so() -> None:
    (messages,) = gauge.finding_texts(gauge.covered(audit=""))
    assert messages == "audit_sound: the spec does not say how an audit reads the manual"
