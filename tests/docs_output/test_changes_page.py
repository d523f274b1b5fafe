"""The page that says what has changed from version to version, and the badges of facts that not every version has."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from functools import cache
from xml.etree.ElementTree import Element

import pytest

from docs_output.documented import tree, visible_text
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.texts import Acceptance
from fieldspec.language.reading.project import read
from fieldspec.targets.docs.backend import files
from fieldspec.targets.docs.changes import page_name, steps
from fieldspec.targets.docs.document import innermost
from layouts import TEST_SPECS, all_layouts, layout_at, layouts

LAYOUTS = {f"{layout.device.id}/{layout.device.version}.html": layout for layout in all_layouts()}

SPEC = """
device: {id: mill, name: Mill, vendor: Making, manual: {title: T, language: en, file: f, sha256: "%s", lines: 9}}
versions:
  - line: firmware
    builds: true
    members: [{id: "1.0", source: L1}, {id: changes, source: L1}, {id: "3.0", source: L1}]
registers:
  - group: all
    source: L1
    defaults: {access: rw}
    rows:
      - {name: speed, at: 1, type: u16, range: 0..9, doc: How fast., until: "1.0"}
      - {name: speed, at: 1, type: u16, range: 0..99, doc: How fast., since: changes}
      - {name: torque, at: 2, type: u16, until: changes}
""" % ("0" * 64)

ACCEPTS = """
accepts:
  - {rule: fact_removed, path: registers/torque, reason: Nobody <b>used</b> it., date: 2026-01-31, since: "3.0"}
"""


@cache
def elements(path: str) -> dict[str, Element]:
    """The elements of a page by their anchors."""
    return {value: node for node in tree(path).iter() if (value := node.get("id"))}


def text_of(node: Element) -> str:
    return visible_text("".join(node.itertext()))


def bounded(node: object) -> Iterator[tuple[str, str]]:
    """The paths of all facts that say for which versions they hold, each with what its badges say."""
    if isinstance(node, tuple | list):
        for item in node:
            yield from bounded(item)
    elif isinstance(node, dict):
        yield from bounded(list(node.values()))
    elif dataclasses.is_dataclass(node) and not isinstance(node, type | Acceptance):
        for key in ("since", "until", "only"):
            if value := getattr(node, key, ()):
                yield node.place.path, f"{key} {', '.join(value)}"  # type: ignore[attr-defined]
        for field in dataclasses.fields(node):
            if field.name != "place":
                yield from bounded(getattr(node, field.name))


@pytest.mark.parametrize("path", LAYOUTS)
def test_facts_that_not_all_versions_have_say_so_where_they_stand(path: str) -> None:
    known = elements(path)
    missing = [
        (fact, badge)
        for fact, badge in bounded(LAYOUTS[path].device)
        if badge not in text_of(known[innermost(fact, known)])
    ]
    assert missing == []


def test_there_are_badges_to_be_seen() -> None:
    assert sum(len(list(bounded(layout.device))) for layout in LAYOUTS.values()) > 30


def mill() -> list[DeviceLayout]:
    """A device of three versions."""
    spec = read({"mill/device.yaml": SPEC.encode()}).devices["mill"]
    return [layout_at(spec, version) for version in spec.versions()]


def test_each_version_is_compared_with_the_one_before_it() -> None:
    result = [(step.old.device.version, step.new.device.version) for step in steps(mill())]
    assert result == [("1.0", "changes"), ("changes", "3.0")]


def test_changes_stand_below_whom_they_concern() -> None:
    text = files(mill())["mill/changes.md"]
    newest, older = text.partition("## version changes, after 1.0")[::2]
    assert "### On the wire" in newest
    assert "torque" in newest.partition("### On the wire")[2]
    assert "### In behaviour" in older
    assert "0..99" in older
    assert "On the wire" not in older


def test_what_is_gone_leads_to_the_older_version_and_what_is_there_to_the_newer_one() -> None:
    page = files(mill())["mill/changes.html"]
    assert 'href="changes_.html#registers/torque"' in page
    assert 'href="changes_.html#registers/speed"' in page
    assert 'href="3.0.html#registers/' not in page


def test_a_version_with_the_name_of_another_page_gives_way() -> None:
    assert page_name("changes") == "changes_"
    assert page_name("2.0") == "2.0"
    assert {"mill/changes.html", "mill/changes_.html", "mill/3.0.md"} <= set(files(mill()))


def test_every_version_page_and_the_list_of_versions_lead_to_the_changes() -> None:
    texts = files(mill())
    for path in ("mill/3.0.html", "mill/index.html"):
        assert 'href="changes.html#versions/3.0"' in texts[path]
    assert "changes.md#versions/3.0" in texts["mill/README.md"]
    assert "changes.html" not in texts["mill/1.0.html"]


def test_the_identity_of_both_versions_is_on_the_page() -> None:
    text = files(mill())["mill/changes.md"]
    assert all(layout.identity in text for layout in mill())


def test_a_change_that_is_accepted_says_why() -> None:
    spec = read(
        {
            "mill/device.yaml": SPEC.encode(),
            "mill/accepts.yaml": ACCEPTS.encode(),
        }
    ).devices["mill"]
    page = files([layout_at(spec, version) for version in spec.versions()])["mill/changes.html"]
    assert "Nobody &lt;b&gt;used&lt;/b&gt; it." in page


def test_a_device_of_one_version_has_no_page_of_changes() -> None:
    assert not [path for path in files(layouts(TEST_SPECS)["gadget"]) if "changes" in path]


def test_examples_notes_and_errata_say_which_versions_have_them() -> None:
    known = elements("esc11/1.17.html")
    assert "Versions1.17" in text_of(known["examples/reset-alarm-request"])
    assert "Versionsall" in text_of(known["examples/read-points-request"])
    assert "only 1.17" in text_of(known["errata/reset-alarm-missing"])
    assert "only" not in text_of(known["errata/excite-request-checksum"])


def test_an_example_of_a_device_with_one_version_says_nothing_of_versions() -> None:
    known = elements("ck10/1.html")
    assert [anchor for anchor in known if anchor.startswith("examples/")]
    assert [anchor for anchor, node in known.items() if "Versionsall" in text_of(node)] == []
