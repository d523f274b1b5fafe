"""A version may be a file of its changes to another one; whatever does not fit is a finding with both places."""

from __future__ import annotations

import pytest

from fieldspec.language.model.device import Device
from fieldspec.language.reading.nodes import Mapping, Scalar
from fieldspec.language.reading.project import Project, read
from fieldspec.language.reading.removals import RemovedFact, removal_findings
from fieldspec.language.reading.yaml_reader import decoded, parsed
from spec_files import DEVICE, codes, pointed_at, unmarked

BASE = """
versions:
  - {line: firmware, builds: true, members: [{id: "1.0"}, {id: "2.0"}, {id: "3.0"}]}
  - {line: hardware, members: [{id: V1}, {id: V2}]}
enums:
  - {name: mode, members: [{value: 0, name: jog}, {value: 2, name: move}]}
registers:
  - group: motion
    rows:
      - {at: 0, name: speed, type: u16, range: 1..100, since: "1.0"}
      - {at: 2, name: mode, type: u16, enum: mode}
      - {at: 3, name: late, type: u16, since: "2.0"}
notes:
  - {name: trap, text: Mind it., about: [registers/mode, enums/mode/jog]}
"""

FULL = """
overlay: {id: "2.1", line: firmware, based_on: "2.0", title: Better}
changes:
  - {fact: registers/speed, set: {range: {was: 1..100, is: 1..120}, unit: {was: ~, is: rpm}}, reason: Faster}
adds:
  - {in: registers/motion, item: {at: 1, name: torque, type: i16, scale: 0.1, source: L6}, reason: New.}
  - {in: enums/mode, item: {value: 1, name: push}, reason: New.}
  - {in: enums, item: {name: colour, members: [{value: 1, name: red}]}, reason: New.}
  - {in: limits, item: {name: weight, value: 0x10}, reason: New.}
renames:
  - {fact: enums/mode/jog, to: inching, reason: Its name.}
  - {fact: enums/mode, to: way, reason: Its name.}
removes:
  - {fact: registers/late, reason: Gone.}
"""


def project(base: str = BASE, **files: str) -> Project:
    """The project of a device with overlays: `v2_1` is the file `versions/2.1.yaml`."""
    overlays = {f"gadget/versions/{name[1:].replace('_', '.')}.yaml": text for name, text in files.items()}
    return read({path: text.encode() for path, text in {"gadget/device.yaml": DEVICE + base, **overlays}.items()})


def at(version: str, base: str = BASE, **files: str) -> Device:
    """The device at a version. Raises AssertionError if there are findings."""
    built = project(base, **files)
    assert codes(built.findings) == []
    device, findings = built.devices["gadget"].at(version)
    assert codes(findings) == []
    return device


def overlay(rest: str, version: str = "2.1", based_on: str = "2.0") -> str:
    return f'overlay: {{id: "{version}", line: firmware, based_on: "{based_on}"}}\n{rest}'


def test_a_version_in_a_file_follows_the_one_that_it_is_based_on() -> None:
    spec = project(v2_1=FULL).devices["gadget"]
    assert spec.versions() == ["1.0", "2.0", "2.1", "3.0"]
    assert [version.title for version in spec.at("1.0")[0].lines[0].versions] == ["", "", "Better", ""]


def test_a_changed_key_has_its_new_value() -> None:
    old, new = at("2.0", v2_1=FULL).register("speed"), at("2.1", v2_1=FULL).register("speed")
    assert old is not None
    assert new is not None
    assert [register.value.ranges.text() for register in (old, new) if register.value.ranges] == ["1..100", "1..120"]
    assert [old.value.unit, new.value.unit] == ["", "rpm"]


def test_a_new_row_is_in_the_order_of_addresses() -> None:
    assert [row.name for row in at("2.1", v2_1=FULL).registers()] == ["speed", "torque", "mode"]
    assert [row.name for row in at("2.0", v2_1=FULL).registers()] == ["speed", "mode", "late"]


def test_new_values_are_typed_as_the_schema_wants_them() -> None:
    device = at("2.1", v2_1=FULL)
    torque = device.register("torque")
    assert torque is not None
    assert (str(torque.value.scale), torque.address) == ("0.1", 1)
    assert [str(limit.value) for limit in device.limits] == ["16"]
    assert "colour" in device.enums


def test_a_renamed_fact_has_its_new_name_wherever_it_is_referred_to() -> None:
    device = at("2.1", v2_1=FULL)
    mode = device.register("mode")
    assert mode is not None
    assert mode.value.enum == "way"
    assert [member.name for member in device.enums["way"].members] == ["inching", "push", "move"]
    assert device.notes[0].about == ("registers/mode", "enums/way/inching")


def test_steps_limits_links_and_spaces_follow_a_new_name() -> None:
    base = BASE.replace("- group: motion", "- group: motion\n    space: memory")
    base += """
spaces: [{name: memory}]
links: [{name: bus, request: [{name: body, role: body}], response: [{name: body, role: body}]}]
messages: [{name: ask, links: [bus], answered_on: [bus], request: [], response: []}]
limits: [{name: delay, value: 5, within: limits/timeout}, {name: timeout, value: 9}]
tasks: [{name: go, task: jog, steps: [{write: registers/speed, argument: speed, timeout: limits/timeout}]}]
"""
    names = (
        ("registers/speed", "velocity"),
        ("limits/timeout", "bound"),
        ("links/bus", "line"),
        ("spaces/memory", "ram"),
    )
    entries = "\n".join(f"  - {{fact: {fact}, to: {to}, reason: x}}" for fact, to in names)
    device = at("2.1", base, v2_1=overlay(f"renames:\n{entries}\n"))
    (step,) = device.tasks[0].steps
    assert (step.target, step.timeout, device.limits[0].within) == (
        "registers/velocity",
        "limits/bound",
        "limits/bound",
    )
    assert device.messages["ask"].answered_on == ("line",)
    assert device.groups[0].space == "ram"


def test_an_overlay_may_be_based_on_an_overlay() -> None:
    second = overlay(
        "changes: [{fact: registers/speed, set: {range: {was: 1..120, is: 1..130}}, reason: x}]", "2.2", "2.1"
    )
    device = at("2.2", v2_1=FULL, v2_2=second)
    speed = device.register("speed")
    assert speed is not None
    assert speed.value.ranges is not None
    assert speed.value.ranges.text() == "1..130"
    assert device.register("torque") is not None


def test_a_later_version_that_is_listed_has_nothing_of_an_overlay() -> None:
    assert [row.name for row in at("3.0", v2_1=FULL).registers()] == ["speed", "mode", "late"]


def test_versions_of_several_lines_are_picked_together() -> None:
    base = BASE + "limits: [{name: a, value: 1, only: [V1]}, {name: b, value: 1, since: V2, until: '2.0'}]\n"
    spec = project(base).devices["gadget"]
    limits = {v: [limit.name for limit in spec.at(v)[0].limits] for v in ("2.0", "2.0+V1", "2.0+V2", "3.0+V2")}
    assert limits == {"2.0": ["a", "b"], "2.0+V1": ["a"], "2.0+V2": ["b"], "3.0+V2": []}


# An overlay of 2.0 with its mark, and the code of the finding.
SAME = "overlay_changes_nothing"
WRONG = {
    "adds: [{in: registers/motion, item: {at: 1, name: torque, type: i16, since: «'3.0'»}, reason: x}]": SAME,
    "removes: [{fact: «versions/firmware/1.0», reason: x}]": "overlay_fact_missing",
    "adds: [{in: «uses», item: {protocol: modbus}, reason: x}]": "overlay_fact_missing",
    "changes: [{fact: device, set: {id: «{was: gadget, is: widget}»}, reason: x}]": "id_matches_path",
    "changes: [{fact: «registers/nothing», set: {unit: {was: ~, is: mm}}, reason: x}]": "overlay_fact_missing",
    "changes: [{fact: «registers», set: {unit: {was: ~, is: mm}}, reason: x}]": "overlay_fact_missing",
    "changes: [{fact: registers/speed, set: {range: {was: «1..99», is: 1..120}}, reason: x}]": "overlay_base_differs",
    "changes: [{fact: registers/speed, set: {unit: {was: «mm», is: rpm}}, reason: x}]": "overlay_base_differs",
    "changes: [{fact: registers/speed, set: {range: {was: «~», is: 1..120}}, reason: x}]": "overlay_base_differs",
    "changes: [{fact: registers/speed, set: {range: «{was: 1..100, is: 1..100}»}, reason: x}]": SAME,
    "changes: [{fact: registers/speed, set: {«colour»: {was: ~, is: red}}, reason: x}]": "unknown_key",
    "removes: [{fact: «registers/nothing», reason: x}]": "overlay_fact_missing",
    "removes: [{fact: «registers», reason: x}]": "overlay_fact_missing",
    "renames: [{fact: registers/speed, to: «mode», reason: x}]": "overlay_name_taken",
    "renames: [{fact: registers/speed, to: «speed», reason: x}]": "overlay_changes_nothing",
    "renames: [{fact: «registers/nothing», to: a, reason: x}]": "overlay_fact_missing",
    "adds: [{in: «registers/nothing», item: {name: a}, reason: x}]": "overlay_fact_missing",
    "adds: [{in: registers/motion, item: «{at: 9, name: speed, type: u8}», reason: x}]": "overlay_name_taken",
    "adds: [{in: registers/motion, item: {at: «nine», name: a, type: u8}, reason: x}]": "wrong_type",
    "adds: [{in: registers/motion, item: {at: 9, name: a, type: u8}, after: «b», reason: x}]": "overlay_fact_missing",
    "adds: [{in: registers/motion, item: {at: 9, name: a, type: u8, since: «9.9»}, reason: x}]": "version_unknown",
}


@pytest.mark.parametrize("text", WRONG)
def test_an_overlay_that_does_not_fit_its_base_is_a_finding(text: str) -> None:
    clean, start, end = unmarked(overlay(text))
    findings = project(v2_1=clean).findings
    assert codes(findings) == [WRONG[text]]
    assert pointed_at(findings[0].span) == clean[start:end]
    assert findings[0].span.file.path == "gadget/versions/2.1.yaml"


def test_an_old_value_that_differs_from_the_base_is_shown_in_both_places() -> None:
    text = overlay("changes: [{fact: registers/speed, set: {range: {was: 1..99, is: 1..120}}, reason: x}]")
    label = project(v2_1=text).findings[0].labels[0]
    assert (label.span.file.path, pointed_at(label.span)) == ("gadget/device.yaml", "1..100")


# Overlays by the names of their files, and the codes of the findings.
ORDERS: dict[str, tuple[dict[str, str], list[str]]] = {
    "unknown base": ({"v2_1": overlay("", "2.1", "1.9")}, ["version_unknown"]),
    "itself": ({"v2_1": overlay("", "2.1", "2.1")}, ["overlay_cycle"]),
    "each other": (
        {"v2_1": overlay("", "2.1", "2.2"), "v2_2": overlay("", "2.2", "2.1")},
        ["overlay_cycle", "overlay_cycle"],
    ),
    "declared too": ({"v2_0": overlay("", "2.0", "1.0")}, ["version_twice"]),
    "other file": ({"v2_1": overlay("", "2.2", "2.0")}, ["id_matches_path"]),
    "two after one": ({"v2_1": overlay("", "2.1", "2.0"), "v2_2": overlay("", "2.2", "2.0")}, ["version_twice"]),
    "no line": ({"v2_1": 'overlay: {id: "2.1", line: software, based_on: "2.0"}'}, ["version_unknown"]),
    "other line": ({"v2_1": 'overlay: {id: "2.1", line: hardware, based_on: "2.0"}'}, ["version_unknown"]),
    "not a version": ({"v2_1": "limits: []"}, ["missing_key"]),
    "facts beside it": ({"v2_1": overlay("limits: []")}, ["unknown_key"]),
    "in the spec itself": ({}, []),
}


@pytest.mark.parametrize("name", ORDERS)
def test_versions_that_do_not_follow_each_other_are_a_finding(name: str) -> None:
    files, expected = ORDERS[name]
    assert codes(project(**files).findings) == expected


def test_a_version_of_another_line_states_which_one_it_follows() -> None:
    text = 'overlay: {id: "V1b", line: hardware, based_on: "2.0", after: V1}'
    built = project(vV1b=text)
    assert codes(built.findings) == []
    assert [version.id for version in built.devices["gadget"].at("2.0")[0].lines[1].versions] == ["V1", "V1b", "V2"]


@pytest.mark.parametrize("section", ["overlay", "adds", "changes", "removes", "renames"])
def test_sections_of_an_overlay_are_findings_in_other_files(section: str) -> None:
    overlay = '{id: "2.1", line: firmware, based_on: "2.0"}' if section == "overlay" else "[]"
    assert codes(project(BASE + f"{section}: {overlay}\n").findings) == ["unknown_key"]


TWICE = BASE.replace(
    'range: 1..100, since: "1.0"}',
    'range: 1..50, until: "1.0"}\n      - {at: 0, name: speed, type: u16, range: 1..100, since: "2.0"}',
)


def test_an_entry_changes_the_fact_of_its_base_where_several_have_the_name() -> None:
    register = at("2.1", TWICE, v2_1=FULL).register("speed")
    assert register is not None
    assert str(register.value.ranges and register.value.ranges.text()) == "1..120"
    before = at("1.0", TWICE, v2_1=FULL).register("speed")
    assert before is not None
    assert str(before.value.ranges and before.value.ranges.text()) == "1..50"


def test_a_fact_that_only_another_version_has_cannot_be_changed() -> None:
    text = overlay("removes: [{fact: registers/late, reason: Gone.}]", "1.1", "1.0")
    assert codes(project(v1_1=text).findings) == ["overlay_fact_missing"]


def test_a_version_of_another_line_keeps_what_all_versions_have() -> None:
    text = 'overlay: {id: V3, line: hardware, based_on: "1.0", after: V2}\n' + (
        "changes: [{fact: registers/speed, set: {unit: {was: ~, is: rpm}}, reason: Known now.}]"
    )
    built = project(vV3=text)
    assert codes(built.findings) == []
    device, _ = built.devices["gadget"].at("2.0+V3")
    assert device.register("late") is not None


def test_versions_share_what_does_not_differ() -> None:
    spec = project(v2_1=FULL).devices["gadget"]
    old, new = spec.at("2.0")[0], spec.at("2.1")[0]
    assert old.register("late") is spec.at("3.0")[0].register("late")
    assert old.register("speed") is not new.register("speed")


def test_a_finding_about_a_row_is_reported_at_every_version() -> None:
    spec = project(BASE.replace("range: 1..100", "range: 9..1")).devices["gadget"]
    assert [codes(spec.at(version)[1]) for version in ("1.0", "2.0", "3.0")] == [["wrong_form"]] * 3


EXAMPLES = """
messages:
  - {name: read, code: 3, accesses: [{start: address}]}
  - {name: other, code: 4, accesses: [{start: address}]}
examples:
  - {id: reading, message: read}
  - {id: address, message: other, values: {address: 0x10}}
  - {id: count, message: other, values: {count: 0x10}}
registers: {at: 0x10}
"""


@pytest.mark.parametrize(
    ("path", "section", "about"),
    [("messages/read", "messages", "reading"), ("registers/speed", "registers", "address")],
)
def test_what_is_removed_takes_the_examples_along_that_are_about_it(path: str, section: str, about: str) -> None:
    tree, _ = parsed(decoded("a.yaml", f"{EXAMPLES}path: {path}\n".encode())[0])
    assert isinstance(tree, Mapping)
    named = tree.values["path"]
    assert isinstance(named, Scalar)
    (finding,) = removal_findings(tree, [RemovedFact(named, tree.values[section], tree)])
    assert finding.message == f"`{path}` goes, and examples/{about} is about it"
