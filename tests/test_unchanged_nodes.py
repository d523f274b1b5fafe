"""A device that is read again consists of the nodes of its last reading, at the places that they have now."""

from __future__ import annotations

import random
from pathlib import Path
from typing import Any

import pytest

from example_counts import FACTOR
from fieldspec.foundation.source import Span
from fieldspec.language.checks.facts import facts
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.reading.memory import Memory
from fieldspec.language.reading.nodes import Node, Scalar, Sequence
from fieldspec.language.reading.project import Project, read
from spec_edits import EDITS, Files

ROOT = Path(__file__).resolve().parent
REAL = ROOT.parent / "specs"
FOLDERS = [(REAL, ("hiwin-e",)), (ROOT / "specs", ("widget", "gizmo", "wattmeter"))]


def sound_files(folder: Path, devices: tuple[str, ...]) -> Files:
    paths = sorted(path for device in ("protocols", *devices) for path in (folder / device).rglob("*.yaml"))
    return {path.relative_to(folder).as_posix(): path.read_text("utf-8") for path in paths}


def project(files: Files, memory: Memory | None = None) -> Project:
    return read({path: text.encode() for path, text in files.items()}, memory=memory)


def place(span: Span) -> tuple[str, str, int, int]:
    return span.file.path, span.file.text, span.start, span.end


def as_data(node: Node) -> Any:
    """A tree as plain data, with all places."""
    if isinstance(node, Scalar):
        return place(node.span), node.text, node.quoted, node.value, type(node.value)
    if isinstance(node, Sequence):
        return place(node.span), [as_data(item) for item in node.items]
    keys = {key: place(node.holder(key).span) for key in node.values}
    return place(node.span), keys, [(key, as_data(value)) for key, value in node.values.items()]


def places(device: Device) -> list[Any]:
    """The places of all facts of a device and of their keys."""
    return [
        (fact.place.path, place(fact.place.whole), {key: place(span) for key, span in fact.place.spans.items()})
        for fact in facts(device)
    ]


def described(findings: list[Diagnostic]) -> list[Any]:
    return [(finding.code, finding.message, place(finding.span)) for finding in findings]


@pytest.mark.parametrize(("folder", "devices"), FOLDERS)
def test_after_random_edits_a_device_has_the_tree_and_the_places_of_its_texts(
    folder: Path, devices: tuple[str, ...]
) -> None:
    choose, memory, files = random.Random(1), Memory(strict=True), sound_files(folder, devices)
    project(files, memory)
    for _ in range(2 * FACTOR):
        path = choose.choice([*files])
        text = choose.choice(EDITS)(files[path], choose)
        anew, again = project({**files, path: text}), project({**files, path: text}, memory)
        assert described(again.findings) == described(anew.findings)
        for device, spec in anew.devices.items():
            for version in spec.versions()[-2:]:
                assert as_data(again.devices[device].tree_at(version)) == as_data(spec.tree_at(version))
                model, findings = again.devices[device].at(version)
                assert described(findings) == described(spec.at(version)[1])
                assert places(model) == places(spec.at(version)[0])
        if not anew.findings:
            files = {**files, path: text}


def test_messages_that_are_joined_with_a_protocol_are_the_same_objects_after_a_change_elsewhere() -> None:
    files, memory = sound_files(REAL, ("tc100",)), Memory(strict=True)

    def messages() -> dict[str, object]:
        spec = project(files, memory).devices["tc100"]
        return {**spec.at(spec.versions()[-1])[0].messages}

    before = messages()
    files["tc100/device.yaml"] = f"# A remark.\n{files['tc100/device.yaml']}"
    after = messages()
    assert [name for name in before if before[name] is not after[name]] == []
