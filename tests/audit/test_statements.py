"""Each line of a manual with words states facts alone, is in a part of the behaviour, or is left out with a reason."""

from __future__ import annotations

import gauge
from fieldspec.tools.audit.section import Section
from fieldspec.tools.audit.statements import statements

BEHAVIOUR = """\
behaviour:
  - {name: moving, show: registers/level, value: 5, source: 1 L6}
  - {name: modes, initial: registers/mode, value: run, source: 1 L7, assumed: It runs at first.}
  - {name: total, unmodelled: It counts., reason: Nothing runs., source: 1 L8}
"""
WITHOUT = '  without_behaviour:\n    - {lines: "9-15", reason: Facts.}\n'


def stated(behaviour: str = BEHAVIOUR, without: str = WITHOUT, manual: str = gauge.MANUAL) -> Section:
    """The section about the statements of the gauge."""
    return statements(gauge.subject(gauge.DEVICE + behaviour, gauge.AUDIT + without, manual))


def test_every_line_has_a_use_or_a_reason_but_headings_that_nobody_has_left_out() -> None:
    assert gauge.finding_texts(stated()) == [
        "statements_accounted: line 5 of the manual, section 1: nothing cites it",
        "statements_accounted: line 13 of the manual, section 2: nothing cites it",
    ]


def test_the_statements_are_counted_by_what_a_simulator_does() -> None:
    figures = stated().figures
    assert [(figure.number, figure.whole) for figure in figures[:3]] == [(1, 3), (1, 3), (1, 3)]
    assert [figure.number for figure in figures[3:8]] == [0, 3, 4, 4, 2]


def test_a_line_that_only_facts_cite_is_asked_for_its_behaviour() -> None:
    without = '  without_behaviour:\n    - {lines: "14-15", reason: Facts.}\n'
    texts = gauge.finding_texts(stated(without=without))
    assert (
        "statements_accounted: line 9 of the manual, section 1: facts cite it, but no part of the behaviour does"
        in texts
    )


def test_a_sentence_without_a_number_is_asked_for_its_behaviour() -> None:
    manual = gauge.MANUAL.replace("~ Bit3 : lamp\n\n", "~ Bit3 : lamp\nThe door stops it.\n")
    texts = gauge.finding_texts(stated(manual=manual))
    assert "statements_accounted: line 10 of the manual, section 1: nothing cites it" in texts


def test_lines_without_behaviour_that_apply_to_nothing_are_found() -> None:
    texts = gauge.finding_texts(stated(without=WITHOUT + "    - {lines: 18-19, reason: Facts.}\n"))
    assert texts[-1] == "audit_sound: this applies to no line that facts cite and no part of the behaviour does"


def test_a_spec_that_does_not_say_which_lines_state_facts_alone_is_not_judged() -> None:
    section = stated(without="")
    assert section.findings == ()
    assert section.figures[-1].good is None
