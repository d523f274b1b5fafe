"""Pages are valid, accessible, whole by themselves, and say everything that the spec says."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterator
from itertools import pairwise
from xml.etree.ElementTree import Element

import html5lib
import pytest

from docs_output.documented import anchors, documentation, resolved, tree, visible_text, with_ending
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.fact import Fact
from fieldspec.targets.docs import lab
from fieldspec.targets.docs.backend import files
from fieldspec.targets.docs.site import SCRIPTS
from layouts import SPECS, TEST_SPECS, all_layouts, layouts, newest

PAGES = with_ending(".html")
# The scope of a module has all tests of a page run after each other, and in one process, which parses it once.
LAYOUTS = {f"{layout.device.id}/{layout.device.version}.html": layout for layout in all_layouts()}
TEXTS = ("printed_name", "label", "doc", "title", "zero", "one", "when", "problem", "cause", "rule", "text")


def pieces(node: Element) -> Iterator[tuple[object, ...]]:
    """The elements of a tree as data: names, attributes and texts; blanks alone are left out.

    Parsers differ in how they write an attribute without a value, and names of SVG.
    """
    for element in node.iter():
        name = element.tag.rpartition("}")[2].lower() if isinstance(element.tag, str) else ""
        values = {key.lower(): "" if value == key else value for key, value in element.attrib.items()}
        yield name, values, len(element), (element.text or "").strip(), (element.tail or "").strip()


def text_of(node: Element) -> str:
    return visible_text("".join(node.itertext()))


def visible(path: str) -> str:
    body = tree(path).find("body")
    assert body is not None
    return text_of(body)


def strings(node: object) -> Iterator[str]:
    """The texts that a model holds for its readers."""
    if isinstance(node, tuple | list):
        for item in node:
            yield from strings(item)
    elif isinstance(node, dict):
        yield from strings(list(node.values()))
    elif dataclasses.is_dataclass(node) and not isinstance(node, type):
        for field in dataclasses.fields(node):
            text = getattr(node, field.name)
            if isinstance(text, str) and field.name in TEXTS:
                yield text
            elif field.name in ("notes", "remedies"):
                yield from (text if all(isinstance(item, str) for item in text) else strings(text))
            elif field.name not in ("place", "restated", "examples", "errata", "lines", "sources"):
                yield from strings(text)


def facts(layout: DeviceLayout) -> Iterator[Fact]:
    """The facts that have an anchor of their own: not the separators, which a record states once."""
    device = layout.device
    yield from device.registers()
    for holder in (device.links, device.messages, device.tables, device.parameters, device.enums, device.flags):
        yield from holder.values()
    for enum in device.enums.values():
        yield from enum.members
    for word in device.flags.values():
        yield from word.bits
    for record in device.records.values():
        yield from record.stated_fields
    for message in device.messages.values():
        yield from (*message.request.stated_fields, *message.response.stated_fields)
    yield from device.limits
    yield from device.lookups


@pytest.mark.proof(20)
@pytest.mark.parametrize("path", PAGES, scope="module")
def test_a_page_is_valid_html_and_has_the_tree_that_other_tests_look_at(path: str) -> None:
    # By the book: any error of syntax raises.
    strict = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(documentation()[path])
    assert strict.tag == "html"
    assert list(pieces(strict)) == list(pieces(tree(path)))


@pytest.mark.parametrize("path", PAGES, scope="module")
def test_a_page_says_its_language(path: str) -> None:
    assert tree(path).get("lang") == "en"


@pytest.mark.parametrize("path", PAGES, scope="module")
def test_an_anchor_is_there_once(path: str) -> None:
    assert [anchor for anchor, count in anchors(path).items() if count > 1] == []


@pytest.mark.parametrize("path", PAGES, scope="module")
def test_links_lead_to_anchors_and_pages_that_are_there(path: str) -> None:
    for node in tree(path).iter("a"):
        page, _, anchor = (node.get("href") or "").partition("#")
        target = resolved(path, page) if page else path
        assert target in PAGES, page
        if anchor and "=" not in anchor:  # with values it is the state of a page
            assert anchor in anchors(target), node.get("href")


@pytest.mark.parametrize("path", PAGES, scope="module")
def test_a_page_needs_no_other_file_but_scripts(path: str) -> None:
    loading = [
        (node.tag, name, resolved(path, value))
        for node in tree(path).iter()
        for name, value in node.attrib.items()
        if name in ("src", "srcset", "data", "action")
    ]
    names = lab.SCRIPTS if path.endswith("/lab.html") else SCRIPTS
    assert loading == [("script", "src", name) for name in names]
    assert [node.attrib["href"].partition(":")[0] for node in tree(path).iter("link")] == ["data"]
    style = "".join(node.text or "" for node in tree(path).iter("style"))
    assert "url(" not in style
    assert "@import" not in style


@pytest.mark.parametrize("path", PAGES, scope="module")
def test_headings_are_in_order(path: str) -> None:
    levels = [int(node.tag[1]) for node in tree(path).iter() if re.fullmatch("h[1-6]", str(node.tag))]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(later <= earlier + 1 for earlier, later in pairwise(levels))
    assert all(text_of(node) for node in tree(path).iter() if re.fullmatch("h[1-6]", str(node.tag)))


@pytest.mark.parametrize("path", PAGES, scope="module")
def test_tables_have_captions_and_headers_with_scopes(path: str) -> None:
    for table in tree(path).iter("table"):
        caption = table.find("caption")
        assert caption is not None
        assert text_of(caption)
        headers = list(table.iter("th"))
        assert headers
        assert {node.get("scope") for node in headers} <= {"col", "row"}
        width = sum(int(node.get("colspan", "1")) for node in table.findall("./thead/tr/th"))
        for row in table.findall("./tbody/tr"):
            assert sum(int(cell.get("colspan", "1")) for cell in row) == width


@pytest.mark.parametrize("path", LAYOUTS, scope="module")
def test_every_fact_has_its_anchor(path: str) -> None:
    missing = [fact.place.path for fact in facts(LAYOUTS[path]) if fact.place.path not in anchors(path)]
    assert missing == []


@pytest.mark.parametrize("path", LAYOUTS, scope="module")
def test_every_text_of_a_spec_is_on_its_page(path: str) -> None:
    page = visible(path)
    missing = {text for text in strings(LAYOUTS[path].device) if visible_text(text) not in page}
    assert missing == set()


@pytest.mark.parametrize("path", LAYOUTS, scope="module")
def test_examples_and_errata_are_on_the_page(path: str) -> None:
    device = LAYOUTS[path].device
    assert {f"examples/{name}" for name in device.examples} <= set(anchors(path))
    assert {f"errata/{erratum.id}" for erratum in device.errata} <= set(anchors(path))
    page = visible(path)
    assert [erratum.reason for erratum in device.errata if visible_text(erratum.reason) not in page] == []


@pytest.mark.parametrize("path", LAYOUTS, scope="module")
def test_a_page_carries_the_identity(path: str) -> None:
    (meta,) = [node for node in tree(path).iter("meta") if node.get("name") == "fieldspec-identity"]
    assert meta.get("content") == LAYOUTS[path].identity


def test_texts_of_a_spec_make_no_elements() -> None:
    page = tree("hostile/1.html")
    assert [node.text for node in page.iter("script")] == [None] * len(SCRIPTS)
    assert [node.tag for node in page.iter() if node.tag in ("img", "b", "iframe")] == []


def test_labels_are_marked_with_their_language() -> None:
    page = tree("tc100/2.0.html")
    labels = [*page.iter("i")]
    assert labels
    assert {node.get("lang") for node in labels} == {"zh-Hant"}


def test_a_misprinted_frame_stands_beside_the_right_one() -> None:
    device = newest(SPECS, "esc11").device
    (erratum,) = [erratum for erratum in device.errata if erratum.id == "excite-request-checksum"]
    (section,) = [node for node in tree("esc11/1.17.html").iter("section") if node.get("id") == erratum.fact]
    strips = section.find("dl")
    assert strips is not None
    lines = {text_of(div).split(" ", 1)[0]: text_of(div) for div in strips}
    assert lines["printed05"].endswith(str(erratum.printed["frame"])[3:])
    assert [text_of(mark) for mark in strips.iter("mark")] == ["17", "37"]


def test_what_is_not_printed_is_shown_as_unknown() -> None:
    (row,) = [node for node in tree("widget/2.0.html").iter("tr") if node.get("id") == "registers/unknown_access"]
    assert "unknown" in {text_of(cell) for cell in row.iter("td")}


def test_what_is_inferred_is_marked_with_the_reason() -> None:
    register = newest(SPECS, "tc100").device.register("servo")
    assert register is not None
    page = tree("tc100/2.0.html")
    (row,) = [node for node in page.iter("tr") if node.get("id") == register.place.path]
    marks = [link.get("href", "")[1:] for link in row.iter("a") if link.find("sup") is not None]
    notes = {node.get("id"): text_of(node) for node in page.iter("li") if node.get("id")}
    assert len(marks) == len(register.inferred) > 0
    for reason in register.inferred.values():
        assert any(visible_text(reason) in notes[mark] for mark in marks)


def test_a_word_is_drawn_with_a_box_for_each_bit() -> None:
    (section,) = [node for node in tree("widget/2.0.html").iter("section") if node.get("id") == "flags/status"]
    (drawn,) = [table for table in section.iter("table") if table.get("class") == "bits"]
    assert [text_of(node) for node in drawn.iter("th")] == [str(bit) for bit in range(15, -1, -1)]
    boxes = [(int(cell.get("colspan", "1")), text_of(cell)) for cell in drawn.iter("td")]
    assert (2, "level") in boxes
    assert (4, "lap") in boxes
    assert sum(width for width, _ in boxes) == 16


def test_the_list_of_versions_leads_to_all_of_them() -> None:
    main = tree("widget/index.html").find("body/main")
    assert main is not None
    links = [node.get("href") for node in main.iter("a") if ".html" in node.get("href", "")]
    assert links == ["2.0.html", "changes.html#versions/2.0", "before-2.0.html"]


def test_the_same_specs_give_the_same_pages() -> None:
    versions = layouts(TEST_SPECS)["widget"]
    assert files(versions) == files(versions)
