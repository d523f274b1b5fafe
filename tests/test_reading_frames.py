"""A frame that is the same both ways is stated once, and counts for the request and the response of its link."""

from __future__ import annotations

import pytest

from fieldspec.codec.layout.device import device_layout
from fieldspec.language.model.device import Device
from fieldspec.language.reading.nodes import Mapping
from fieldspec.language.reading.references import references
from fieldspec.language.reading.yaml_reader import decoded, parsed
from spec_files import codes, gadget, pointed_at, project

PARTS = "[{name: station, role: unit_address, type: u8}, {name: code, role: code, type: u8}, {name: body, role: body}]"
OTHER = "[{name: code, role: code, type: u8}, {name: body, role: body}]"
VERSIONS = 'versions: [{line: firmware, builds: true, members: [{id: "1.0"}]}]\n'


def link(keys: str) -> str:
    """A section with the only link of a device."""
    return f"links: [{{name: line, byte_order: big, {keys}}}]\n"


def protocol(keys: str) -> dict[str, str]:
    """The file of a protocol with this link."""
    return {"protocols_wire": "protocol: {id: wire, title: A protocol}\n" + link(keys)}


def device(text: str, overlay: str = "", **others: str) -> Device:
    """The model of a device, of the version that the overlay of another one gives."""
    head = 'overlay: {id: "2.0", line: firmware, based_on: "1.0"}\n'
    files = {"gadget_versions/2.0": head + overlay} if overlay else {}
    spec = gadget(text, **files, **others)
    model, findings = spec.at(spec.versions()[-1])
    assert codes(findings) == []
    return model


def names(model: Device) -> tuple[list[str], list[str]]:
    """The names of the parts of requests and of responses."""
    line = model.links["line"]
    return [part.name for part in line.request], [part.name for part in line.response]


WHOLE, SHORT = ["station", "code", "body"], ["code", "body"]
MARKED = [*SHORT, "mark"]


def test_a_device_is_the_same_with_both_directions_and_with_one_frame() -> None:
    stated_once, stated_twice = (
        device(link(keys)) for keys in (f"frame: {PARTS}", f"request: {PARTS}, response: {PARTS}")
    )
    assert names(stated_once) == (WHOLE, WHOLE)
    assert device_layout(stated_once).identity == device_layout(stated_twice).identity


def test_parts_have_their_place_at_the_frame() -> None:
    text = link(f"frame: {PARTS}, inferred: {{frame: The manual prints requests.}}")
    line = device(text).links["line"]
    assert pointed_at(line.place["response"]) == PARTS
    assert [part.place.path for part in line.response[:1]] == ["links/line/response/station"]
    assert line.inferred == dict.fromkeys(("request", "response"), "The manual prints requests.")


@pytest.mark.parametrize(
    ("of_protocol", "of_device", "expected"),
    [
        (f"frame: {PARTS}", "doc: A line.", (WHOLE, WHOLE)),
        (f"request: {OTHER}, response: {OTHER}", "frame: [{name: code}, {name: mark, type: u8}]", (MARKED, MARKED)),
        (f"request: {PARTS}", f"frame: {OTHER}", (WHOLE, SHORT)),
        (f"frame: {OTHER}", "request: [{name: code, doc: Of requests.}]", (SHORT, SHORT)),
    ],
)
def test_a_frame_and_the_directions_of_a_protocol_are_merged(
    of_protocol: str, of_device: str, expected: tuple[list[str], list[str]]
) -> None:
    text = "uses: [{protocol: wire}]\n" + link(of_device)
    assert names(device(text, **protocol(of_protocol))) == expected


@pytest.mark.parametrize(
    ("entries", "expected"),
    [
        (f"changes: [{{fact: links/line, set: {{frame: {{was: {PARTS}, is: {OTHER}}}}}, reason: New.}}]", SHORT),
        ("renames: [{fact: links/line/frame/station, to: unit, reason: New.}]", ["unit", "code", "body"]),
        ("removes: [{fact: links/line/frame/station, reason: Gone.}]", SHORT),
        (
            "adds: [{in: links/line/frame, after: code, item: {name: mark, type: u8}, reason: New.}]",
            ["station", "code", "mark", "body"],
        ),
    ],
    ids=["changes", "renames", "removes", "adds"],
)
@pytest.mark.parametrize("keys", [f"frame: {PARTS}", f"request: {PARTS}, response: {PARTS}"], ids=["one", "two"])
def test_an_overlay_names_the_frame_of_a_link(keys: str, entries: str, expected: list[str]) -> None:
    assert names(device(VERSIONS + link(keys), entries)) == (expected, expected)


def test_an_overlay_adds_a_link_with_a_frame() -> None:
    entries = f"adds: [{{in: links, item: {{name: bus, byte_order: big, frame: {PARTS}}}, reason: New.}}]"
    bus = device(VERSIONS + link(f"frame: {OTHER}"), entries).links["bus"]
    assert [part.name for part in bus.response] == WHOLE


def test_an_overlay_changes_one_direction_of_a_frame() -> None:
    entries = "renames: [{fact: links/line/response/station, to: unit, reason: New.}]"
    assert names(device(VERSIONS + link(f"frame: {PARTS}"), entries)) == (WHOLE, ["unit", "code", "body"])


def test_a_frame_beside_a_direction_is_a_finding_in_an_overlay_too() -> None:
    pair = f"{{was: {PARTS}, is: {OTHER}}}"
    entries = f"changes: [{{fact: links/line, set: {{frame: {pair}, request: {pair}}}, reason: New.}}]"
    head = 'overlay: {id: "2.0", line: firmware, based_on: "1.0"}\n'
    files = {"gadget_versions/2.0": head + entries}
    findings = project(VERSIONS + link(f"frame: {PARTS}"), **files).findings
    assert [(finding.code, pointed_at(finding.span)) for finding in findings] == [("wrong_form", "request")]


def test_a_path_of_an_overlay_through_a_frame_refers_to_its_parts() -> None:
    base = gadget(VERSIONS + link(f"frame: {PARTS}")).tree
    node, _ = parsed(decoded("2.0.yaml", b"renames: [{fact: links/line/frame/station, to: unit}]")[0])
    assert isinstance(node, Mapping)
    assert [pointed_at(reference.span) for reference in references(base, node)] == ["line", "station"]
