"""Files are merged into devices with their protocols, and rows take the defaults of their groups."""

from __future__ import annotations

from decimal import Decimal

import pytest

from fieldspec.language.model.device import Device
from fieldspec.language.reading.project import read
from spec_files import DEVICE, MANUAL, codes, gadget, pointed_at, project, unmarked

WIRE = """
protocol: {id: wire, title: A protocol}
links:
  - name: rtu
    transmission: binary
    byte_order: big
    doc: Of the protocol.
    request:
      - {name: station, role: unit_address, type: u8}
      - {name: function, role: code, type: u8, doc: Says which message it is.}
      - {name: body, role: body}
  - {name: ascii, transmission: hex_ascii}
messages:
  - name: read
    code: 3
    request: [{name: address, type: u16}, {name: count, type: u16, range: 1..100}]
    response: [{name: values, type: u16, repeat: 1..100}]
  - {name: write, code: 6, request: [], response: []}
enums:
  - {name: exception, members: [{value: 1, name: illegal}, {value: 2, name: busy}]}
records:
  - {name: refusal, fields: [{name: exception, type: u8, enum: exception}]}
"""


def device(text: str, **others: str) -> Device:
    """The model of the gadget's only version."""
    spec = gadget(text, **others)
    model, findings = spec.at(spec.versions()[-1])
    assert codes(findings) == []
    return model


def test_lists_of_several_files_are_joined_in_the_order_of_their_names() -> None:
    model = device(
        "limits: [{name: first}]\n",
        gadget_b="limits: [{name: third}]\n",
        gadget_a="limits: [{name: second}]\nnotes: [{name: n, text: t}]\n",
    )
    assert [limit.name for limit in model.limits] == ["first", "second", "third"]
    assert [note.name for note in model.notes] == ["n"]


def test_files_that_are_no_specs_are_skipped() -> None:
    files = {"gadget/device.yaml": DEVICE, "gadget/notes.txt": "\t", "README.md": "\t", "gadget/old/a.yaml": "\t"}
    read_from = read({path: text.encode() for path, text in files.items()})
    assert codes(read_from.findings) == []
    assert list(read_from.devices) == ["gadget"]


def test_a_section_that_is_no_list_is_in_one_file() -> None:
    clean, start, _ = unmarked(f"«device»: {{id: gadget, name: Other, vendor: Maker, manual: {MANUAL}}}\n")
    (finding,) = project("", gadget_other=clean).findings
    assert (finding.code, finding.span.file.path, finding.span.start) == ("section_twice", "gadget/other.yaml", start)
    assert [(label.span.file.path, pointed_at(label.span)) for label in finding.labels] == [
        ("gadget/device.yaml", "device")
    ]


def test_a_folder_needs_the_section_device() -> None:
    read_from = read({"gadget/a.yaml": b"notes: [{name: n, text: t}]\n", "gizmo/device.yaml": DEVICE.encode()})
    assert [(finding.code, finding.span.file.path) for finding in read_from.findings] == [
        ("device_section", "gadget/a.yaml"),
        ("id_matches_path", "gizmo/device.yaml"),
    ]


def test_two_devices_with_one_id_are_a_finding_at_the_second_with_a_label_at_the_first() -> None:
    read_from = read({"gadget/device.yaml": DEVICE.encode(), "gizmo/device.yaml": DEVICE.encode()})
    assert sorted(codes(read_from.findings)) == ["device_id_unique", "id_matches_path"]
    duplicate = next(finding for finding in read_from.findings if finding.code == "device_id_unique")
    assert duplicate.span.file.path == "gizmo/device.yaml"
    assert [label.span.file.path for label in duplicate.labels] == ["gadget/device.yaml"]
    assert pointed_at(duplicate.span) == pointed_at(duplicate.labels[0].span) == "gadget"


def test_a_file_with_findings_takes_its_device_out_and_no_other() -> None:
    gizmo = DEVICE.replace("id: gadget", "id: gizmo")
    read_from = read({"gadget/device.yaml": (DEVICE + "a: 1\n").encode(), "gizmo/device.yaml": gizmo.encode()})
    assert list(read_from.devices) == ["gizmo"]


def test_only_the_devices_that_are_asked_for_are_read() -> None:
    gizmo = DEVICE.replace("id: gadget", "id: gizmo")
    files = {"gadget/device.yaml": b"\t", "gizmo/device.yaml": gizmo.encode(), "protocols/wire.yaml": b"\t"}
    read_from = read(files, frozenset(["gizmo"]))
    assert (list(read_from.devices), read_from.findings) == (["gizmo"], [])


@pytest.mark.parametrize(
    ("text", "others", "code"),
    [
        ("uses: [{protocol: «wires»}]\n", {"protocols_wire": WIRE}, "file_missing"),
        ("uses: [{protocol: wire, links: [rtu, «tcp»]}]\n", {"protocols_wire": WIRE}, "references_resolve"),
        ("uses: [{protocol: wire, messages: [«reed»]}]\n", {"protocols_wire": WIRE}, "references_resolve"),
        ("«protocol»: {id: gadget, title: No}\n", {}, "unknown_key"),
    ],
)
def test_a_wrong_use_of_a_protocol_is_a_finding_at_its_place(text: str, others: dict[str, str], code: str) -> None:
    clean, start, end = unmarked(DEVICE + text)
    (finding,) = project(clean.removeprefix(DEVICE), **others).findings
    assert (finding.code, finding.span.start, finding.span.end) == (code, start, end)
    assert finding.help


def test_a_missing_protocol_has_a_hint() -> None:
    (finding,) = project("uses: [{protocol: wires}]\n", protocols_wire=WIRE).findings
    assert finding.help == "did you mean `wire`?"


@pytest.mark.parametrize(
    ("others", "chain"),
    [
        ({"protocols_a": ["a"]}, "a -> a"),
        ({"protocols_a": ["b"], "protocols_b": ["a"]}, "a -> b -> a"),
        ({"protocols_a": ["b"], "protocols_b": ["c"], "protocols_c": ["d", "b"], "protocols_d": []}, "b -> c -> b"),
    ],
)
def test_protocols_that_use_each_other_in_a_circle_are_a_finding(others: dict[str, list[str]], chain: str) -> None:
    files = {
        path: f"protocol: {{id: {path[-1]}, title: P}}\nuses: [{', '.join(f'{{protocol: {name}}}' for name in uses)}]\n"
        for path, uses in others.items()
    }
    (finding,) = project("uses: [{protocol: a}]\n", **files).findings
    assert finding.code == "import_cycle"
    assert finding.message.endswith(chain)
    assert pointed_at(finding.span) == chain[-1]


def test_a_protocol_that_no_device_uses_is_read_too() -> None:
    findings = project("", protocols_wire="protocol: {id: wire, title: P}\nlinkz: []\n").findings
    assert codes(findings) == ["unknown_key"]


@pytest.mark.parametrize("text", ["links: []\n", "protocol: {id: wire, title: P}\ndevice: 1\n"])
def test_a_protocol_is_no_device(text: str) -> None:
    assert project("uses: [{protocol: wire}]\n", protocols_wire=text).findings


def test_a_device_takes_all_of_a_protocol() -> None:
    model = device("uses: [{protocol: wire}]\n", protocols_wire=WIRE)
    assert list(model.links) == ["rtu", "ascii"]
    assert list(model.messages) == ["read", "write"]
    assert list(model.enums) == ["exception"]
    assert list(model.records) == ["refusal"]


def test_a_device_takes_the_links_and_messages_that_it_lists() -> None:
    model = device("uses: [{protocol: wire, links: [ascii], messages: [write]}]\n", protocols_wire=WIRE)
    assert (list(model.links), list(model.messages)) == (["ascii"], ["write"])
    assert list(model.enums) == ["exception"]


def test_a_device_takes_what_its_protocol_takes_from_another() -> None:
    layer = """
protocol: {id: layer, title: P}
uses: [{protocol: wire, links: [rtu]}]
links: [{name: rtu, doc: Laid over.}]
"""
    model = device("uses: [{protocol: layer}]\n", protocols_layer=layer, protocols_wire=WIRE)
    assert (model.links["rtu"].doc, model.links["rtu"].transmission) == ("Laid over.", "binary")


def test_facts_of_a_device_override_those_of_its_protocol_by_name_and_at_any_depth() -> None:
    model = device(
        """
uses: [{protocol: wire}]
links:
  - name: rtu
    unit_addresses: {range: 1..16}
    request: [{name: function, label: 功能}]
messages:
  - {name: read, request: [{name: count, range: 1..16}]}
  - {name: jog, code: 9, request: [], response: []}
enums:
  - {name: exception, members: [{name: busy, value: 5}, {name: late, value: 6}]}
""",
        protocols_wire=WIRE,
    )
    rtu = model.links["rtu"]
    assert (rtu.transmission, rtu.doc) == ("binary", "Of the protocol.")
    assert rtu.unit_addresses is not None
    assert [(part.name, part.role, part.label) for part in rtu.request] == [
        ("station", "unit_address", ""),
        ("function", "code", "功能"),
        ("body", "body", ""),
    ]
    count = model.messages["read"].request.fields[1]
    assert (count.name, count.value and count.value.type.name) == ("count", "u16")
    assert count.value is not None
    assert count.value.ranges is not None
    assert count.value.ranges.text() == "1..16"
    assert list(model.messages) == ["read", "write", "jog"]
    assert [(member.name, member.value) for member in model.enums["exception"].members] == [
        ("illegal", 1),
        ("busy", 5),
        ("late", 6),
    ]


def test_a_finding_about_a_fact_of_a_protocol_points_into_the_protocol() -> None:
    wire = "protocol: {id: wire, title: P}\nrecords: [{name: a, fields: [{name: b, scale: 0, type: u8}]}]\n"
    spec = gadget("uses: [{protocol: wire}]\n", protocols_wire=wire)
    (finding,) = spec.at("1")[1]
    assert (finding.span.file.path, pointed_at(finding.span)) == ("protocols/wire.yaml", "0")


ROWS = """
registers:
  - group: motion
    section: "8.2"
    defaults:
      type: i32
      checked: {words: 2}
      access: rw
      scale: 0.01
      unit: mm
      restart: true
      inferred: {access: All rows are set by the tool.}
      sentinels: [{value: -1, name: unused}]
    rows:
      - {at: 1, name: near, source: L5}
      - {at: 3, name: far, type: u16, checked: {words: 1}, scale: 1, access: ro, restart: false, source: 9 L6,
         inferred: {unit: So it is.}}
"""


def test_rows_take_what_they_lack_from_the_defaults_of_their_group() -> None:
    near, far = device(ROWS).groups[0].registers
    assert (near.value.type.name, near.words, near.access, near.value.scale, near.restart) == (
        "i32",
        2,
        "rw",
        Decimal("0.01"),
        True,
    )
    assert [sentinel.name for sentinel in near.value.sentinels] == ["unused"]
    assert (far.value.type.name, far.words, far.access, far.value.scale, far.restart) == (
        "u16",
        1,
        "ro",
        Decimal(1),
        False,
    )
    assert far.value.unit == "mm"


def test_what_a_row_states_in_counts_comes_before_what_its_group_states_in_the_unit() -> None:
    defaults = "{type: u16, scale: 0.1, unit: mm, unit_range: 0..10, unit_default: 1}"
    rows = "[{at: 1, name: own, range: 5..7, default: 6}, {at: 2, name: usual}]"
    own, usual = device(f"registers: [{{group: a, defaults: {defaults}, rows: {rows}}}]\n").groups[0].registers
    assert [own.value.ranges and own.value.ranges.text(), own.value.default] == ["5..7", 6]
    assert [usual.value.ranges and usual.value.ranges.text(), usual.value.default] == ["0..100", 10]


def test_reasons_of_a_row_are_added_to_those_of_its_group() -> None:
    near, far = device(ROWS).groups[0].registers
    assert list(near.inferred) == ["access"]
    assert sorted(far.inferred) == ["access", "unit"]


def test_a_section_of_a_group_applies_to_its_rows() -> None:
    near, far = device(ROWS).groups[0].registers
    assert [source.text() for source in (*near.sources, *far.sources)] == ["8.2 L5", "9 L6"]


def test_a_row_has_no_source_where_only_its_group_has_one() -> None:
    model = device("registers: [{group: a, source: 1 L2, rows: [{at: 1, name: b, type: u8}]}]\n")
    (group,) = model.groups
    assert [source.text() for source in group.sources] == ["1 L2"]
    assert group.registers[0].sources == ()


def test_parts_of_a_fact_have_its_source() -> None:
    model = device(
        "enums: [{name: a, source: 1 L2, members: [{name: b, value: 1}, {name: c, value: 2, source: 3 L4}]}]\n"
    )
    texts = [[source.text() for source in member.sources] for member in model.enums["a"].members]
    assert texts == [["1 L2"], ["3 L4"]]


def test_parameters_take_what_they_lack_from_the_defaults_of_their_set() -> None:
    text = "parameters: [{name: p, type: u16, defaults: {access: ro, unit: s}, rows: [{number: 1, name: a}]}]\n"
    (parameter,) = device(text).parameters["p"].parameters
    assert (parameter.value.type.name, parameter.access, parameter.value.unit) == ("u16", "ro", "s")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("limits: [{name: a}, {name: «a»}]\n", "duplicate_name"),
        ("registers: [{group: a, rows: [{at: 1, name: «b»}]}]\n", "type_present"),
        ("records: [{name: a, fields: [{name: b, type: «text»}]}]\n", "type_present"),
        ("records: [{name: a, fields: [{name: b, type: «u8», record: a}]}]\n", "type_present"),
        ("records: [{name: a, fields: [{name: b, type: u8, range: «5..1»}]}]\n", "wrong_form"),
        ("records: [{name: a, fields: [{name: b, type: u8, range: «0..0.5»}]}]\n", "wrong_form"),
        ("records: [{name: a, fields: [{name: b, type: u8, scale: 0.1, unit_range: «0..0.25»}]}]\n", "wrong_form"),
        ("records: [{name: a, fields: [{name: b, type: u8, scale: 3, unit_default: «10»}]}]\n", "wrong_form"),
        ("records: [{name: a, fields: [{name: b, type: u8, scale: «0»}]}]\n", "wrong_value"),
        ("flags: [{name: a, type: u8, bits: [{name: b, bits: «5..1»}]}]\n", "wrong_form"),
        ("flags: [{name: a, type: u8, bits: [{bit: «1»}]}]\n", "missing_key"),
        ("lookups: [{name: a, columns: [{name: b}], rows: [{cells: «[1, 2]»}]}]\n", "wrong_size"),
        ("links: [{name: a, request: [{name: b, role: «checksum»}]}]\n", "wrong_form"),
        (
            "registers: [{group: a, rows: [{at: 1, name: b, type: u8, count: 3, element_sources: «L5-99999»}]}]\n",
            "sources_present",
        ),
    ],
)
def test_errors_that_a_schema_cannot_express_are_found_when_the_model_is_built(text: str, code: str) -> None:
    clean, start, _ = unmarked(DEVICE + text)
    findings = gadget(clean.removeprefix(DEVICE)).at("1")[1]
    assert (findings[0].code, findings[0].span.start) == (code, start)
    assert findings[0].help


def test_findings_of_building_are_bounded() -> None:
    rows = ", ".join(f"{{at: {number}, name: r{number}}}" for number in range(1000))
    findings = gadget(f"registers: [{{group: a, rows: [{rows}]}}]\n").at("1")[1]
    assert codes(findings) == ["type_present"] * 200 + ["too_many_findings"]
