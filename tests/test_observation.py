"""An observed object is like the object that it observes, and knows which of its attributes have been read."""

from __future__ import annotations

from pathlib import Path

import pytest

from fieldspec.codec.layout import identity
from fieldspec.codec.layout.device import LAYOUT_ATTRIBUTES, device_layout
from fieldspec.command import pipeline
from fieldspec.command.sources.spec_files import with_protocols
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.observation import is_same, observed, read_attributes

SPECS = [
    path
    for folder in (Path(__file__).resolve().parent / "specs", Path(__file__).resolve().parent.parent / "specs")
    for path in sorted(folder.glob("*/device.yaml"))
]


@dataclass(frozen=True, slots=True)
class Part:
    name: str
    doc: str


@dataclass(frozen=True, slots=True)
class Whole:
    title: str
    doc: str
    parts: tuple[Part, ...]

    def names(self) -> list[str]:
        return [part.name for part in self.parts]


WHOLE = Whole("A", "B", (Part("c", "D"), Part("e", "F")))


def test_what_is_read_is_noted() -> None:
    whole = observed(WHOLE)
    assert (whole.title, whole.names(), isinstance(whole, Whole)) == ("A", ["c", "e"], True)
    assert read_attributes(whole) == {"title": "A", "parts": WHOLE.parts}


def test_a_changed_copy_reads_the_rest_of_the_observed_object() -> None:
    whole = observed(WHOLE)
    copy = replace(whole, title="Another")
    assert (copy.title, copy.doc, read_attributes(whole)) == ("Another", "B", {"doc": "B"})


@pytest.mark.parametrize(
    ("other", "expected"),
    [
        (WHOLE, True),
        (replace(WHOLE, doc="Another"), True),
        (replace(WHOLE, parts=(Part("c", "Another"), WHOLE.parts[1])), True),
        (replace(WHOLE, title="Another"), False),
        (replace(WHOLE, parts=(Part("another", "D"), WHOLE.parts[1])), False),
        (replace(WHOLE, parts=WHOLE.parts[:1]), False),
    ],
)
def test_an_object_is_the_same_if_all_that_was_read_is(other: Whole, expected: bool) -> None:
    whole = observed(WHOLE, (Part,))
    assert (whole.title, whole.names()) == ("A", ["c", "e"])
    assert is_same(whole, other) is expected


@dataclass(frozen=True, slots=True)
class Holder:
    first: Part
    parts: dict[str, Part]

    def names(self) -> list[str]:
        return [self.first.name, *(part.name for part in self.parts.values())]


HOLDER = Holder(Part("c", "D"), {"e": Part("e", "F")})


@pytest.mark.parametrize(
    ("other", "expected"),
    [
        (Holder(Part("c", "Another"), {"e": Part("e", "Another")}), True),
        (Holder(Part("another", "D"), HOLDER.parts), False),
        (Holder(HOLDER.first, {"e": Part("another", "F")}), False),
    ],
)
def test_objects_alone_and_in_dictionaries_are_observed_too(other: Holder, expected: bool) -> None:
    holder = observed(HOLDER, (Part,))
    assert holder.names() == ["c", "e"]
    assert is_same(holder, other) is expected


@pytest.mark.parametrize("path", SPECS, ids=lambda path: path.parent.name)
def test_a_layout_is_made_of_the_attributes_that_are_listed(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(identity, "identity", lambda *parts: "")
    folder, name = path.parent.parent, path.parent.name
    paths = [file for device in (name, "protocols") for file in (folder / device).rglob("*.yaml")]
    files = with_protocols({file.relative_to(folder).as_posix(): file.read_bytes() for file in paths})
    spec = next(iter(pipeline.load(files, frozenset([name])).devices.values()))
    device = observed(spec.at(spec.versions()[-1])[0])
    device_layout(device)
    assert read_attributes(device).keys() <= {*LAYOUT_ATTRIBUTES}
