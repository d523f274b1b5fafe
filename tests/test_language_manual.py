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
from fieldspec.language.schema.manual import anchor, pages, parts

DOCS = Path(__file__).parent.parent / "docs"
SPECS = DOCS.parent / "specs"
PAGES = pages()
ALL = "".join(PAGES.values())
CORE = PAGES["language"]
BLOCKS = re.findall(r"```yaml\n(.*?)```", ALL, re.DOTALL)
MOST_WORDS_OF_THE_CORE = 3000


def headings(text: str) -> list[str]:
    return re.findall(r"^#+ (.+)$", text, re.MULTILINE)


@pytest.mark.parametrize("page", PAGES)
def test_manual_is_fresh(page: str, accept: bool) -> None:
    path = DOCS / f"{page}.md"
    if accept:
        path.write_text(PAGES[page], "utf-8", newline="\n")
    assert path.read_text("utf-8") == PAGES[page]


def test_the_core_is_one_page() -> None:
    assert len(CORE.split()) <= MOST_WORDS_OF_THE_CORE
    assert len(re.findall(r"^\| `", CORE, re.MULTILINE)) >= 110


def test_each_section_of_the_core_has_one_example() -> None:
    sections = re.split(r"^## ", CORE, flags=re.MULTILINE)[1:]
    assert [section.count("```yaml") for section in sections] == [1] * len(sections)


def test_a_key_of_the_core_has_the_first_sentence_of_its_description() -> None:
    keys = re.findall(r"^\| `(\w+)` \| (.*) \|$", CORE, re.MULTILINE)
    assert [key for key, sentence in keys if f" {sentence}" not in ALL.replace(CORE, "") or sentence[-1] != "."] == []


def test_every_part_of_the_schema_has_one_section() -> None:
    sections = [heading for heading in headings(ALL) if heading in parts()]
    assert sorted(sections) == sorted(parts())


def test_every_key_is_in_the_manual() -> None:
    for name, part in parts().items():
        section = ALL.partition(f"\n### {name}\n")[2].partition("\n#")[0]
        for key, inner in part.get("properties", {}).items():
            shared = re.match(r"#/\$defs/(fact|value)/properties/", inner.get("$ref", ""))
            expected = f"#{shared[1]})" if shared else f"| `{key}` |"
            assert expected in section, f"{name}.{key}"


def test_headings_have_anchors_of_their_own() -> None:
    anchors = [anchor(heading) for heading in headings(ALL)]
    assert sorted(anchors) == sorted(set(anchors))


def test_links_lead_to_headings() -> None:
    anchors = {(page, anchor(heading)) for page in PAGES for heading in headings(PAGES[page])}
    for path in (*DOCS.glob("*.md"), DOCS.parent / "README.md"):
        links = re.findall(r"\]\((?:(?:docs/)?(language[a-z-]*)\.md)?#([^)]*)\)", path.read_text("utf-8"))
        pages_of_links = {(page or path.stem, heading) for page, heading in links}
        assert {link for link in pages_of_links if link[0] in PAGES} <= anchors


def test_required_keys_are_marked() -> None:
    section = ALL.partition("\n### erratum\n")[2].partition("\n#")[0]
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
    text = CORE.partition("\n## The core\n")[2]
    device = re.findall(r"```yaml\n(.*?)```", text, re.DOTALL)[0]
    files = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in (SPECS / "protocols").glob("*.yaml")}
    project = read({**files, "valve/device.yaml": device.encode()})
    assert [finding.message for finding in checked(project)] == []
    assert list(project.devices) == ["valve"]
