"""Another edition of a manual is found again line by line, and what is left of it is said."""

from __future__ import annotations

import random
import time

import pytest

import gauge
from fieldspec.tools.audit.manual_lines import ManualError, aligned, index_of, index_text, parsed

LINES = gauge.MANUAL.splitlines(keepends=True)


def edition(*, insert: dict[int, str] | None = None, remove: set[int] | None = None) -> str:
    """The manual with lines before some lines, and without others."""
    lines = []
    for number, line in enumerate(LINES, 1):
        lines += [(insert or {}).get(number, "")]
        lines += [line] if number not in (remove or set()) else []
    return "".join(lines)


SHIFTED = [
    ("lines before everything", {1: "NEW COVER\nof another year\n\n"}),
    ("a line between two rows", {8: "a remark between the rows\n"}),
    ("a page", {11: "\n" * 5 + "Page four\n\n"}),
]


@pytest.mark.parametrize("insert", [case[1] for case in SHIFTED], ids=[case[0] for case in SHIFTED])
def test_lines_are_found_again_after_a_shift(insert: dict[int, str]) -> None:
    section = gauge.covered(manual=edition(insert=insert))
    assert gauge.finding_texts(section) == []
    assert any("another edition" in text for text in section.paragraphs)
    assert any("13 of 13 lines with text are there unchanged (100 %)" in text for text in section.paragraphs)


def test_a_row_that_an_edition_adds_is_not_accounted_for() -> None:
    (messages,) = gauge.finding_texts(gauge.covered(manual=edition(insert={10: "0105 H | 1 | Outputs | - |\n"})))
    assert messages.startswith("manual_accounted: line 10 of the manual, section 1, prints `address` 0105")


def test_a_row_that_an_edition_drops_lets_its_citations_fail() -> None:
    messages = gauge.finding_texts(gauge.covered(manual=edition(remove={8})))
    assert messages == [
        "citations_hold: registers/total cites 1 L8, where the manual does not print `at` 0x0102",
        "citations_hold: registers/total cites 1 L8, where the manual does not print `printed_name` Total",
        "citations_hold: registers/total cites line 8, on which nothing is printed",
    ]


def test_a_row_that_an_edition_changes_is_found_at_its_place() -> None:
    messages = gauge.finding_texts(gauge.covered(manual=gauge.MANUAL.replace("0~1000", "0~2000")))
    assert [text.partition(", and")[0] for text in messages] == [
        "manual_accounted: line 6 of the manual, section 1, prints `range` 0~2000",
        "citations_hold: registers/level cites 1 L6, where the manual does not print `range` 1000",
    ]


def test_a_line_that_an_edition_adds_below_a_heading_is_no_heading() -> None:
    messages = gauge.finding_texts(gauge.covered(manual=edition(insert={4: "Since 2031 there are 7 registers.\n"})))
    assert messages == ["manual_accounted: line 4 of the manual, section 1, has numbers, and no fact cites it"]


def test_a_line_that_is_left_out_for_what_it_says_is_looked_at_where_an_edition_changes_it() -> None:
    manual = gauge.MANUAL.replace("Two years", "See page 7.\n\nTwo years")
    audit = (
        gauge.AUDIT.replace('[Front, "9"], reason', "[Front], reason") + '    - {lines: "19, 21", reason: A page.}\n'
    )
    other = manual.replace("page 7", "page 8")
    assert gauge.finding_texts(gauge.covered(audit=audit, cited=manual)) == []
    (messages,) = gauge.finding_texts(gauge.covered(audit=audit, cited=manual, manual=other))
    assert messages.startswith(
        "manual_accounted: line 19 of the manual, section 9, has numbers, and says something else"
    )


def test_a_line_that_only_a_remark_cites_is_looked_at_where_an_edition_changes_it() -> None:
    cited = gauge.MANUAL.replace("\n9 Warranty", "At most 4 at once.\n\n9 Warranty")
    device = gauge.DEVICE.replace(
        "{name: read_registers, source: 2 L14}", '{name: read_registers, source: "2 L14, 16"}'
    )
    audit = gauge.AUDIT.replace("line: 17", "line: 18")
    assert gauge.finding_texts(gauge.covered(device=device, audit=audit, cited=cited)) == []
    (messages,) = gauge.finding_texts(
        gauge.covered(device=device, audit=audit, cited=cited, manual=cited.replace("At most 4", "At most 5"))
    )
    assert messages.endswith(
        "line 16 of the manual, section 2, has numbers, and says something else in the edition that the spec cites"
    )


def test_the_same_text_saved_in_another_way_fits() -> None:
    for data in (b"\xef\xbb\xbf" + gauge.MANUAL.encode(), gauge.MANUAL.replace("\n", "\r\n").encode()):
        other = index_of("gauge.txt", data)
        manual = aligned(gauge.index(), other)
        assert other.sha256 != gauge.index().sha256
        assert (manual.same, manual.whole, manual.new, manual.gone) == (13, 13, frozenset(), frozenset())


def test_an_index_is_read_as_it_is_written() -> None:
    index = gauge.index()
    assert parsed("specs/gauge/manual.index", index_text(index, "gauge")) == index


def test_findings_lead_to_the_line_in_the_index() -> None:
    index = parsed("manual.index", index_text(gauge.index(), "gauge"))
    line, _ = index.span(8).position()
    assert index.file.line(line).endswith("0102 H | 2 | Total | - | …")


@pytest.mark.parametrize(
    "text",
    [
        "",
        "sha256 0\n",
        index_text(gauge.index(), "gauge").replace("lines 19", "lines 18"),
        index_text(gauge.index(), "gauge").replace("0102 H", "\n0102 H"),
        index_text(gauge.index(), "gauge").replace("Total", "Total\n| - | x"),
    ],
)
def test_an_index_that_is_damaged_is_refused(text: str) -> None:
    with pytest.raises(ManualError, match="is not an index of a manual"):
        parsed("manual.index", text)


def test_an_old_index_is_a_finding() -> None:
    other = gauge.MANUAL.replace("5000", "6000")
    section = gauge.covered(cited=gauge.MANUAL, recorded=False, manual=other)
    assert [text for text in gauge.finding_texts(section) if text.startswith("manual_recorded")]


def test_long_manuals_are_aligned_soon() -> None:
    chosen = random.Random(5)
    rows = [f"{chosen.randrange(400):04X} H | row" for _ in range(6000)]
    moved = [row for row in rows if chosen.random() > 0.02]
    old, new = (index_of("m", "\n".join(text).encode()) for text in (rows, ["cover", *moved]))
    before = time.process_time()
    manual = aligned(old, new)
    assert time.process_time() - before < 10
    assert manual.same > 0.9 * len(moved)
