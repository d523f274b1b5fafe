"""What an overlay renames has its new name wherever the spec refers to it, or means it."""

from __future__ import annotations

import pytest

from fieldspec.language.model.device import Device
from fieldspec.language.reading.nodes import exact
from fieldspec.language.reading.project import read
from layouts import SPECS, TEST_SPECS
from spec_files import codes
from test_reading_overlays import BASE, at, overlay, project

MEASURED = """
links:
  - name: bus
    byte_order: big
    request: &frame
      - {name: head, type: u8, const: 7}
      - {name: length, role: length, type: u8, measures: {from: data, to: data}}
      - {name: data, role: body}
    response: *frame
messages:
  - name: ask
    request: [{name: size, type: u8, measures: {items: values}}, {name: values, type: u8, repeat: 0..9}]
    response: [{name: way, type: u8, enum: mode}]
records:
  - {name: point, fields: [{name: x, type: u16}, {name: y, type: u16}]}
  - {name: line, fields: [{name: start, record: point}]}
flags:
  - {name: state, type: u16, bits: [{bit: 0, name: ready}, {bit: 1, name: late_bit}]}
tables:
  - {name: points, base: 0x100, count: 2, stride: 2, record: point}
lookups:
  - name: pins
    columns: [{name: pin}, {name: wire}]
    rows: [{cells: [2, red]}, {cells: [1, blue / white]}]
tasks:
  - name: go
    task: jog
    steps: [{wait: registers/status/ready, value: true}, {write: registers/speed, argument: speed}]
behaviour:
  - name: start
    rule: [{set: registers/status/ready, to: true}]
    when: {write: registers/speed}
    if: {registers/status/ready: false, registers/speed: nonzero}
    assumed: It does.
"""
WITH_STATUS = (
    BASE.replace("enum: mode}\n", "enum: mode}\n      - {at: 9, name: status, type: u16, flags: state}\n") + MEASURED
)


def renamed(*names: tuple[str, str]) -> Device:
    """The device under new names."""
    entries = "\n".join(f"  - {{fact: {fact}, to: {to}, reason: x}}" for fact, to in names)
    return at("2.1", WITH_STATUS, v2_1=overlay(f"renames:\n{entries}\n"))


@pytest.mark.parametrize("order", [1, -1])
def test_a_record_and_its_field_are_renamed_in_any_order(order: int) -> None:
    device = renamed(*(("records/point", "place"), ("records/point/x", "left"))[::order])
    assert [field.name for field in device.records["place"].fields] == ["left", "y"]
    assert device.tables["points"].record == device.records["line"].fields[0].record == "place"


@pytest.mark.parametrize("order", [1, -1])
def test_two_fields_may_change_names(order: int) -> None:
    device = renamed(*(("records/point/x", "y"), ("records/point/y", "x"))[::order])
    assert [field.name for field in device.records["point"].fields] == ["y", "x"]


def test_a_field_measures_a_list_under_its_new_name() -> None:
    (size, values) = renamed(("messages/ask/request/values", "samples")).messages["ask"].request.fields
    assert size.measures is not None
    assert (size.measures.field, values.name) == ("samples", "samples")


@pytest.mark.parametrize(("direction", "other"), [("request", "response"), ("response", "request")])
def test_a_length_counts_a_part_under_its_new_name_in_one_direction(direction: str, other: str) -> None:
    link = renamed((f"links/bus/{direction}/data", "payload")).links["bus"]
    spans = {name: (link.parts(name)[1].span.first, link.parts(name)[1].span.last) for name in (direction, other)}
    assert spans == {direction: ("payload", "payload"), other: ("data", "data")}


def test_behaviour_and_tasks_follow_the_new_names_of_a_register_and_of_a_bit_in_it() -> None:
    names = (("registers/status", "state"), ("flags/state/ready", "prepared"), ("registers/speed", "velocity"))
    entries = "\n".join(f"  - {{fact: {fact}, to: {to}, reason: x}}" for fact, to in names)
    built = project(WITH_STATUS, v2_1=overlay(f"renames:\n{entries}\n"))
    assert codes(built.findings) == []
    tree = built.devices["gadget"].tree_at("2.1")
    assert [step.target for step in built.devices["gadget"].at("2.1")[0].tasks[0].steps] == [
        "registers/state/prepared",
        "registers/velocity",
    ]
    behaviour = exact(tree.values["behaviour"])
    for path in ("registers/state/prepared", "registers/velocity"):
        assert path in str(behaviour)
    assert "registers/s" not in str(behaviour).replace("registers/state/prepared", "")


def test_a_row_of_a_table_is_named_by_a_cell() -> None:
    rest = """
changes:
  - {fact: lookups/pins/rows/pin=1, set: {cells: {was: [1, blue / white], is: [1, blue]}}, reason: x}
adds: [{in: lookups/pins, after: pin=2, item: {cells: [3, black]}, reason: x}]
"""
    rows = at("2.1", WITH_STATUS, v2_1=overlay(rest)).lookups[0].rows
    assert [[str(cell) for cell in row.cells] for row in rows] == [["2", "red"], ["3", "black"], ["1", "blue"]]
    gone = "removes: [{fact: lookups/pins/rows/wire=blue / white, reason: x}]"
    assert len(at("2.1", WITH_STATUS, v2_1=overlay(gone)).lookups[0].rows) == 1


NAMED_VALUES = (
    BASE
    + """
flags:
  - {name: state, type: u8, bits: [{bit: 0, name: ready}, {bit: 4, name: late_bit}]}
links:
  - name: bus
    byte_order: big
    request: &frame [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: *frame
messages:
  - name: ask
    code: 1
    request:
      - {name: way, type: u8, enum: mode}
      - name: content
        choice: {by: way, cases: [{name: near, when: [jog], type: u8}, {name: far, when: [move], type: u16}]}
    response: [{name: status, type: u8, flags: state}]
tasks:
  - {name: go, task: jog, steps: [{write: registers/mode, value: jog}, {wait: registers/mode, value: [jog, move]}]}
behaviour:
  - name: start
    rule: [{set: registers/mode, to: move}]
    when: {write: registers/mode}
    if: {registers/mode: jog}
    assumed: It does.
examples:
  - {id: asked, link: bus, direction: request, message: ask, frame: "01 00 07", values: {way: jog, content: 7}}
  - {id: told, link: bus, direction: response, message: ask, frame: "01 10", values: {status: [late_bit]}}
"""
)


@pytest.mark.parametrize(
    ("section", "text"),
    [
        ("messages", "{'name': 'near', 'when': ['inching'], 'type': 'u8'}"),
        ("tasks", "{'write': 'registers/mode', 'value': 'inching'}"),
        ("tasks", "{'wait': 'registers/mode', 'value': ['inching', 'moving']}"),
        ("behaviour", "[{'set': 'registers/mode', 'to': 'moving'}]"),
        ("behaviour", "{'registers/mode': 'inching'}"),
        ("examples", "{'direction_of': 'inching', 'content': 7}"),
        ("examples", "{'status': ['overdue']}"),
    ],
)
def test_what_means_a_value_follows_its_new_name(section: str, text: str) -> None:
    names = {
        "enums/mode/jog": "inching",
        "enums/mode/move": "moving",
        "flags/state/late_bit": "overdue",
        "messages/ask/request/way": "direction_of",
    }
    entries = "\n".join(f"  - {{fact: {fact}, to: {to}, reason: x}}" for fact, to in names.items())
    built = project(NAMED_VALUES, v2_1=overlay(f"renames:\n{entries}\n"))
    assert codes(built.findings) == []
    assert text in str(exact(built.devices["gadget"].tree_at("2.1").values[section]))


def test_what_is_sent_in_pieces_follows_the_new_names_of_members() -> None:
    names = {
        "enums/upload_size/segments": "pieces",
        "enums/upload_size/bytes_4": "whole",
        "enums/abort_code/toggle_bit_unchanged": "same_toggle",
    }
    entries = "\n".join(f"  - {{fact: {fact}, to: {to}, reason: x}}" for fact, to in names.items())
    files = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.glob("protocols/canopen.yaml")}
    versions = '\nversions: [{line: firmware, builds: true, members: [{id: "2.0"}]}]\n'
    files["node/device.yaml"] = (TEST_SPECS / "node/device.yaml").read_bytes() + versions.encode()
    files["node/versions/2.1.yaml"] = overlay(f"renames:\n{entries}\n").encode()
    device, findings = read(files).devices["node"].at("2.1")
    assert codes(findings) == []
    upload = device.messages["upload"]
    assert upload.segments is not None
    assert (upload.segments.when, upload.segments.unsized) == (("segments_of_size", "pieces"), ("pieces",))
    assert upload.segments.abort is not None
    assert upload.segments.abort.counter == "same_toggle"
    value = upload.response.fields[3].value
    assert value is not None
    assert value.parameter is not None
    assert value.parameter.sizes is not None
    assert value.parameter.sizes.cases[0].when == ("whole",)
