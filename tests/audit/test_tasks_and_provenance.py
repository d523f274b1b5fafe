"""An audit lists the tasks of a device, what is not printed, and what the print leaves empty."""

from __future__ import annotations

from typing import Any

import pytest

from audit.audit_pages import projects
from fieldspec.language.model.operand import Operands
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.tools.audit.manual_lines import index_of
from fieldspec.tools.audit.print_gaps import empty_cells, labels_elsewhere, without_unit
from fieldspec.tools.audit.report import tasks
from fieldspec.tools.audit.section import Section, Subject
from fieldspec.tools.audit.sources import sources
from layouts import SPECS, TEST_SPECS, layout_at, newest
from spec_files import gadget

DEVICES = ("ck10", "esc11", "hiwin-e", "tc100")
MODES = """
enums:
  - name: mode
    source: 1 L1
    members:
      - {value: 0, name: slow, doc: Moves slowly., source: 1 L1}
      - {value: 1, name: fast, doc: Moves fast., source: 1 L2%s}
"""
PINS = """
lookups:
  - name: pins
    title: Pins
    source: 1 L1-3
    %s
    columns: [{name: pin}, {name: signal}, {name: meaning}]
    rows:
      - {cells: [1, stop +, contact], source: 1 L1}
      - {cells: [2, stop, contact], source: 1 L2}
      - {cells: [3, stop -, contact], source: "1 L1, 3"}
"""


def subject(spec: DeviceSpec) -> Subject:
    layout = layout_at(spec, spec.versions()[-1])
    return Subject(spec, layout, (layout,), ((),))


def column(section: Section, table: str, name: str) -> list[Any]:
    rows_of = next(candidate for candidate in section.tables if candidate.name == table)
    return [row[rows_of.columns.index(name)] for row in rows_of.rows]


def test_a_task_that_nothing_answers_is_missing() -> None:
    section = tasks(subject(gadget("registers: []\n")))
    assert set(column(section, "tasks", "answer")) == {"missing"}


@pytest.mark.parametrize("device", DEVICES)
def test_every_device_answers_every_task(device: str) -> None:
    kinds = {task.kind for task in newest(SPECS, device).device.tasks}
    section = tasks(subject(gadget("registers: []\n")))
    assert kinds >= set(column(section, "tasks", "task"))


def test_tasks_of_grippers_are_in_the_audit_of_those_that_have_them() -> None:
    esc11, ck10 = (tasks(subject(projects()[device][1])) for device in ("esc11", "ck10"))
    assert set(column(esc11, "tasks", "task")) - set(column(ck10, "tasks", "task")) == {"grip", "release"}


@pytest.mark.parametrize("device", DEVICES)
def test_every_target_of_a_step_is_one_operand(device: str) -> None:
    model = newest(SPECS, device).device
    operands = Operands(model)
    steps = [(step, name) for task in model.tasks for step in task.steps for name in task.messages or ("",)]
    assert steps
    assert {len(operands.target(step.target, name)) for step, name in steps} == {1}


def test_what_is_not_printed_has_tables_of_its_own() -> None:
    model = newest(TEST_SPECS, "widget").device
    assert [fact.name for fact in model.limits if fact.reported] == ["reply_time"]
    text = "limits: [{name: a, source: 1 L1, reported: [{by: A user, how: Seen., doc: It is so.}]}]\n"
    section = sources(subject(gadget(text)))
    assert column(section, "reported", "fact") == ["limits/a"]
    assert column(section, "standards", "fact") == []


@pytest.mark.parametrize(("key", "expected"), [("", ["fast"]), (", inferred: {doc: As above.}", [])])
def test_an_empty_cell_that_somebody_has_filled_is_listed(key: str, expected: list[str]) -> None:
    index = index_of("gadget.txt", b"0 | slow | 5 | stops\n1 | fast | | stops 7\n")
    model = subject(gadget(MODES % key)).device
    assert [empty_cell.place.path.rpartition("/")[2] for empty_cell in empty_cells(model, index)] == expected


@pytest.mark.parametrize(("key", "expected"), [("", ["lookups/pins/rows/2"]), ("inferred: {rows: As above.}", [])])
def test_an_empty_cell_that_a_row_of_a_lookup_has_filled_is_listed(key: str, expected: list[str]) -> None:
    index = index_of("gadget.txt", b"1\tstop +\tcontact 3\n\t2\tstop 4\n3\tstop -\n")
    model = subject(gadget(PINS % key)).device
    assert [empty_cell.place.path for empty_cell in empty_cells(model, index)] == expected


@pytest.mark.parametrize(("label", "expected"), [("Speed limit", []), ("Speedlimit", []), ("Torque", ["speed"])])
def test_a_label_that_does_not_stand_on_the_cited_line_is_listed(label: str, expected: list[str]) -> None:
    row = f"      - {{at: 1, name: speed, type: u16, label: {label}, source: L1}}\n"
    text = f"registers:\n  - group: all\n    section: '1'\n    rows:\n{row}"
    model = subject(gadget(text)).device
    assert [fact.name for fact in labels_elsewhere(model, "1 | Speed limit |\n2 | Torque\n")] == expected


@pytest.mark.parametrize(
    ("keys", "expected"),
    [
        ("", ["speed"]),
        (", unit: rpm", []),
        (", notes: No unit is printed.", []),
        (", range: 0..9", []),
        (", const: 1", []),
    ],
)
def test_a_number_of_which_nothing_says_what_it_counts_is_listed(keys: str, expected: list[str]) -> None:
    row = f"      - {{at: 1, name: speed, type: u16, source: L1{keys}}}\n"
    text = f"registers:\n  - group: all\n    section: '1'\n    rows:\n{row}"
    assert [fact.name for fact in without_unit(subject(gadget(text)).device)] == expected
