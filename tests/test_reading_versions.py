"""A fact holds for the versions that it names, and each version is a device of its own."""

from __future__ import annotations

import pytest

from fieldspec.language.model.device import Device
from spec_files import DEVICE, codes, gadget, pointed_at, project, unmarked

LINES = """
versions:
  - line: firmware
    builds: true
    members: [{id: "1.0"}, {id: "1.5"}, {id: "2.0"}]
  - line: hardware
    members: [{id: V1}, {id: V2}]
"""

# The bounds of a fact, and the versions of the firmware for which it holds.
BOUNDS = {
    "": ["1.0", "1.5", "2.0"],
    'since: "1.0"': ["1.0", "1.5", "2.0"],
    'since: "1.5"': ["1.5", "2.0"],
    'since: "2.0"': ["2.0"],
    'until: "1.0"': ["1.0"],
    'until: "1.5"': ["1.0", "1.5"],
    'until: "2.0"': ["1.0", "1.5", "2.0"],
    'since: "1.5", until: "1.5"': ["1.5"],
    'only: ["1.0", "2.0"]': ["1.0", "2.0"],
    'only: ["1.5"]': ["1.5"],
    'only: ["1.0", "2.0"], since: "1.5"': ["2.0"],
    "since: V2": ["1.0", "1.5", "2.0"],
    "until: V1": ["1.0", "1.5", "2.0"],
    "only: [V1]": ["1.0", "1.5", "2.0"],
    'only: [V1, "1.5"]': ["1.5"],
}

# A fact `x` of each kind, with its bounds at `BOUNDS`, and the names of its kind that a device has.
FACTS = {
    "registers": (
        "registers: [{group: a, rows: [{at: 1, name: x, type: u8, BOUNDS}]}]",
        lambda device: [register.name for group in device.groups for register in group.registers],
    ),
    "groups": (
        "registers: [{group: x, rows: [], BOUNDS}]",
        lambda device: [group.name for group in device.groups],
    ),
    "messages": ("messages: [{name: x, request: [], response: [], BOUNDS}]", lambda device: list(device.messages)),
    "fields": (
        "records: [{name: a, fields: [{name: x, type: u8, BOUNDS}]}]",
        lambda device: [field.name for field in device.records["a"].fields],
    ),
    "request": (
        "messages: [{name: a, request: [{name: x, type: u8, BOUNDS}], response: []}]",
        lambda device: [field.name for field in device.messages["a"].request.fields],
    ),
    "members": (
        "enums: [{name: a, members: [{name: x, value: 1, BOUNDS}]}]",
        lambda device: [member.name for member in device.enums["a"].members],
    ),
    "bits": (
        "flags: [{name: a, type: u8, bits: [{name: x, bit: 1, BOUNDS}]}]",
        lambda device: [bit.name for bit in device.flags["a"].bits],
    ),
    "parameters": (
        "parameters: [{name: a, rows: [{number: 1, name: x, type: u8, BOUNDS}]}]",
        lambda device: [parameter.name for parameter in device.parameters["a"].parameters],
    ),
    "tables": (
        "tables: [{name: x, base: 1, stride: 1, count: 1, record: r, BOUNDS}]",
        lambda device: list(device.tables),
    ),
    "limits": ("limits: [{name: x, BOUNDS}]", lambda device: [limit.name for limit in device.limits]),
    "notes": ("notes: [{name: x, text: t, BOUNDS}]", lambda device: [note.name for note in device.notes]),
    "examples": (
        "examples: [{id: x, link: l, direction: request, frame: '00', BOUNDS}]",
        lambda device: list(device.examples),
    ),
    "errata": (
        "errata: [{id: x, fact: f, reason: r, confidence: open, effect: name, proof: judgement, source: L1, BOUNDS}]",
        lambda device: [erratum.id for erratum in device.errata],
    ),
    "lookup rows": (
        "lookups: [{name: a, columns: [{name: c}], rows: [{cells: [x], BOUNDS}]}]",
        lambda device: [row.cells[0] for row in device.lookups[0].rows],
    ),
    "links": ("links: [{name: x, BOUNDS}]", lambda device: list(device.links)),
    "parts": (
        "links: [{name: a, request: [{name: x, role: body, BOUNDS}]}]",
        lambda device: [part.name for part in device.links["a"].request],
    ),
}


def devices(text: str) -> dict[str, Device]:
    """The device at each of its versions."""
    spec = gadget(text)
    versions = {version: spec.at(version) for version in spec.versions()}
    assert [codes(findings) for _, findings in versions.values()] == [[]] * len(versions)
    return {version: device for version, (device, _) in versions.items()}


def bounded(fact: str, bounds: str) -> str:
    return LINES + fact.replace(", BOUNDS", f", {bounds}" if bounds else "") + "\n"


@pytest.mark.parametrize(("bounds", "versions"), BOUNDS.items(), ids=BOUNDS)
def test_a_fact_is_valid_for_the_versions_within_its_bounds(bounds: str, versions: list[str]) -> None:
    devices_by_version = devices(bounded("limits: [{name: x, BOUNDS}]", bounds))
    assert [version for version, device in devices_by_version.items() if device.limits] == versions


@pytest.mark.parametrize("kind", FACTS)
def test_facts_of_every_kind_have_versions(kind: str) -> None:
    text, names = FACTS[kind]
    devices_by_version = devices(bounded(text, 'since: "1.5"'))
    assert {version: names(device) for version, device in devices_by_version.items()} == {
        "1.0": [],
        "1.5": ["x"],
        "2.0": ["x"],
    }


def test_a_name_may_have_different_meanings_in_different_versions() -> None:
    devices_by_version = devices(
        LINES
        + """
registers:
  - group: a
    rows:
      - {at: 1, name: speed, type: u8, until: "1.5"}
      - {at: 2, name: speed, type: u16, since: "2.0"}
"""
    )
    addresses = {version: device.groups[0].registers[0].address for version, device in devices_by_version.items()}
    assert addresses == {"1.0": 1, "1.5": 1, "2.0": 2}


def test_a_device_without_versions_has_one() -> None:
    assert gadget("").versions() == ["1"]


def test_a_device_none_of_whose_lines_builds_has_one_version_with_all_facts() -> None:
    text = LINES.replace("    builds: true\n", "") + 'limits: [{name: x, since: "2.0"}, {name: y, until: "1.0"}]\n'
    (device,) = devices(text).values()
    assert (device.version, [limit.name for limit in device.limits]) == ("1", ["x", "y"])


def test_a_version_has_its_own_documentation() -> None:
    member = "{id: '1', title: One, doc: First., inferred: So., source: 1 L2}"
    (line,) = devices(f"versions: [{{line: a, builds: true, members: [{member}]}}]\n")["1"].lines
    (version,) = line.versions
    assert (version.id, version.title, version.doc, version.inferred) == ("1", "One", "First.", "So.")
    assert [source.text() for source in version.sources] == ["1 L2"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('limits: [{name: x, since: «"1.6"»}]\n', "version_unknown"),
        ("limits: [{name: x, until: «V3»}]\n", "version_unknown"),
        ('limits: [{name: x, only: ["1.5", «"1.6"»]}]\n', "version_unknown"),
        ('registers: [{group: a, rows: [{at: 1, name: x, type: u8, since: «"3"»}]}]\n', "version_unknown"),
        ('enums: [{name: a, since: «"3"», members: [{name: b, value: 1}]}]\n', "version_unknown"),
    ],
)
def test_a_version_that_is_not_declared_is_a_finding(text: str, code: str) -> None:
    clean, start, end = unmarked(DEVICE + LINES + text)
    (finding,) = project(clean.removeprefix(DEVICE)).findings
    assert (finding.code, finding.span.start, finding.span.end) == (code, start, end)


def test_a_version_that_is_not_declared_has_a_hint() -> None:
    (finding,) = project(LINES + 'limits: [{name: x, since: "1.6"}]\n').findings
    assert finding.help == "did you mean `1.5`?"


@pytest.mark.parametrize(
    "text",
    [
        "versions: [{line: a, builds: true, members: [{id: '1'}, {id: «'1'»}]}]\n",
        "versions: [{line: a, members: [{id: '1'}]}, {line: b, members: [{id: «'1'»}]}]\n",
    ],
)
def test_versions_are_declared_once(text: str) -> None:
    clean, start, end = unmarked(DEVICE + text)
    (finding,) = project(clean.removeprefix(DEVICE)).findings
    assert (finding.code, finding.span.start, finding.span.end) == ("version_twice", start, end)


def test_keys_that_are_a_users_own_are_not_taken_for_versions() -> None:
    text = "examples: [{id: a, link: b, direction: request, frame: '00', values: {since: 5, until: on}}]\n"
    assert codes(project(text).findings) == []


def test_a_label_at_an_unquoted_version_says_what_is_wrong() -> None:
    clean, start, _ = unmarked(DEVICE + LINES + "limits: [{name: x, since: «1.50»}]\n")
    (finding,) = project(clean.removeprefix(DEVICE)).findings
    assert (finding.code, finding.span.start, pointed_at(finding.span)) == ("version_unknown", start, "1.50")


def test_a_line_may_only_be_like_one_that_has_outputs() -> None:
    text = """
versions:
  - {line: one, builds: true, members: [{id: "1.0"}]}
  - {line: two, members: [{id: "2.0"}]}
  - {line: three, like: oen, members: [{id: "3.0"}, {id: "3.1"}]}
  - {line: four, like: two, members: [{id: "4.0"}]}
"""
    findings = project(text).findings
    assert [(finding.code, finding.message.rpartition(" ")[2]) for finding in findings] == [
        ("version_unknown", "`oen`"),
        ("version_unknown", "`two`"),
    ]
