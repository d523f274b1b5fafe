"""The manual of the language is fresh, complete and linked, and its examples are legal."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from fieldspec.command.pipeline import checked
from fieldspec.language.reading.project import read
from fieldspec.language.reading.scalars import typed
from fieldspec.language.reading.yaml_reader import decoded, parsed
from fieldspec.language.schema import schema
from fieldspec.language.schema.manual import anchor, manual, parts

MANUAL = Path(__file__).parent.parent / "docs" / "language.md"
SPECS = MANUAL.parent.parent / "specs"
BLOCKS = re.findall(r"```yaml\n(.*?)```", manual(), re.DOTALL)


def headings(text: str) -> list[str]:
    return re.findall(r"^#+ (.+)$", text, re.MULTILINE)


def test_manual_is_fresh(accept: bool) -> None:
    if accept:
        MANUAL.parent.mkdir(exist_ok=True)
        MANUAL.write_text(manual(), "utf-8", newline="\n")
    assert MANUAL.read_text("utf-8") == manual()


def test_every_part_of_the_schema_has_one_section() -> None:
    sections = [heading for heading in headings(manual()) if heading in parts()]
    assert sorted(sections) == sorted(parts())


def test_every_key_is_in_the_manual() -> None:
    for name, part in parts().items():
        section = manual().partition(f"\n### {name}\n")[2].partition("\n#")[0]
        for key, inner in part.get("properties", {}).items():
            shared = re.match(r"#/\$defs/(fact|value)/properties/", inner.get("$ref", ""))
            expected = f"[{shared[1]}](#{shared[1]})" if shared else f"| `{key}` |"
            assert expected in section, f"{name}.{key}"


def test_headings_have_anchors_of_their_own() -> None:
    anchors = [anchor(heading) for heading in headings(manual())]
    assert sorted(anchors) == sorted(set(anchors))


def test_links_lead_to_headings() -> None:
    anchors = {anchor(heading) for heading in headings(manual())}
    assert set(re.findall(r"\]\(#([^)]*)\)", manual())) <= anchors


def test_required_keys_are_marked() -> None:
    section = manual().partition("\n### erratum\n")[2].partition("\n#")[0]
    marked = re.findall(r"^\| `(\w+)` \|[^|]*\| yes \|", section, re.MULTILINE)
    assert sorted(marked) == sorted(schema()["$defs"]["erratum"]["required"])


@pytest.mark.parametrize("block", BLOCKS)
def test_examples_of_the_manual_are_legal(block: str) -> None:
    file, findings = decoded("language.md", block.encode())
    assert not findings
    node, findings = parsed(file)
    assert not findings
    if node is None:
        assert all(line.startswith("#") for line in block.splitlines())
    else:
        assert typed(node)[1] == []


def test_the_device_of_the_core_is_complete() -> None:
    text = manual().partition("\n## The core\n")[2]
    device = re.findall(r"```yaml\n(.*?)```", text, re.DOTALL)[0]
    files = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in (SPECS / "protocols").glob("*.yaml")}
    project = read({**files, "valve/device.yaml": device.encode()})
    assert [finding.message for finding in checked(project)] == []
    assert list(project.devices) == ["valve"]
