"""The page of an audit is valid, whole by itself, can be read without colours, and leads to where things are."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterator
from functools import cache
from importlib.resources import files as resources
from itertools import pairwise
from pathlib import Path
from xml.etree.ElementTree import Element

import html5lib
import pytest
from selenium import webdriver
from selenium.webdriver.chrome.service import Service

from audit.audit_pages import files, page, projects
from command_line import SPECS, TEST_SPECS, CommandLine
from external_tools import require_tool
from fieldspec.command.rendering.audit_html import rendered
from fieldspec.command.rendering.audit_map import maps
from fieldspec.foundation.classes import replace
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.model.fact import Citation
from fieldspec.targets.docs.backend import shared
from fieldspec.tools.audit.address_map import STATES, spaces_of
from fieldspec.tools.audit.section import Figure, Report, Section, SectionTable
from layouts import all_layouts, newest

DEVICES = ("esc11", "widget", "glider-x", "gizmo", "hostile")
STYLE = resources("fieldspec.command.rendering").joinpath("audit.css").read_text("utf-8")
SCRIPT, INDEX = "../search.js", "../index.html"
FLAGS = (
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--window-size=1400,1000",
)


@cache
def tree(device: str) -> Element:
    """The page, parsed by the book: any error of syntax raises."""
    parser = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False)
    root: Element = parser.parse(page(device))
    return root


@cache
def ids(text: str) -> set[str]:
    return set(re.findall(r'\bid="([^"]+)"', text))


@pytest.mark.parametrize("device", DEVICES)
def test_a_page_is_valid_and_every_anchor_is_there_once(device: str) -> None:
    anchors = Counter(node.get("id") for node in tree(device).iter() if node.get("id"))
    assert [name for name, count in anchors.items() if count > 1] == []


@pytest.mark.parametrize("device", DEVICES)
def test_links_lead_to_anchors_and_pages_that_are_there(device: str) -> None:
    for node in tree(device).iter("a"):
        name, _, anchor = (node.get("href") or "").partition("#")
        if name != INDEX:
            text = files(device)[f"docs/{device}/{name}"] if name else page(device)
            if anchor:
                assert anchor in ids(text), node.get("href")


@pytest.mark.parametrize("device", DEVICES)
def test_the_list_of_versions_leads_to_the_audit(device: str) -> None:
    assert 'href="audit.html"' in files(device)[f"docs/{device}/index.html"]
    assert "[audit](audit.html)" in files(device)[f"docs/{device}/README.md"]


@pytest.mark.parametrize("device", DEVICES)
def test_a_page_needs_no_other_file_but_that_of_the_search(device: str) -> None:
    loading = ("src", "srcset", "data", "onclick", "style")
    values = [node.get(name) for node in tree(device).iter() for name in loading if name in node.attrib]
    assert values == [SCRIPT]
    assert [node.attrib["href"].partition(":")[0] for node in tree(device).iter("link")] == ["data"]
    assert [node.text for node in tree(device).iter("script")] == [None]
    style = "".join(node.text or "" for node in tree(device).iter("style"))
    assert re.findall(r"url\((?!#)[^)]*\)|@import", style) == []


@pytest.mark.parametrize("device", DEVICES)
def test_headings_are_in_order(device: str) -> None:
    levels = [int(node.tag[1]) for node in tree(device).iter() if re.fullmatch("h[1-6]", str(node.tag))]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(later <= earlier + 1 for earlier, later in pairwise(levels))


@pytest.mark.parametrize("device", DEVICES)
def test_every_table_has_a_caption_and_heads_of_all_columns(device: str) -> None:
    for table in tree(device).iter("table"):
        caption = table.find("caption")
        assert caption is not None
        assert "".join(caption.itertext()).strip()
        heads = table.findall("thead/tr/th")
        assert all(head.get("scope") == "col" for head in heads)
        assert {len(row.findall("td")) for row in table.findall("tbody/tr")} == {len(heads)}


@pytest.mark.parametrize("device", DEVICES)
def test_every_drawing_says_in_words_what_it_shows(device: str) -> None:
    drawings = [node for node in tree(device).iter() if str(node.tag).endswith("svg") and node.get("role") == "img"]
    assert bool(drawings) is bool(spaces_of(newest(projects()[device][0], device)))
    for drawing in drawings:
        named = (drawing.get("aria-labelledby") or "").split()
        texts = {child.get("id"): "".join(child.itertext()) for child in drawing}
        assert len(named) == 2
        assert all(texts[name].strip() for name in named)


def test_what_stands_otherwise_is_told_by_a_sign_and_a_word_and_not_by_colour_alone() -> None:
    rows = [node for node in tree("esc11").iter("tr") if node.get("class") in ("good", "bad", "warning")]
    assert rows
    for row in rows:
        sign = "".join(row[0].itertext())
        assert re.fullmatch(r"[✓✗!](right|wrong|to be examined)", sign), sign


def test_every_state_of_an_address_has_a_look_of_its_own() -> None:
    looks = {state: re.search(rf"svg \.{state} {{ ([^}}]*) }}", STYLE) for state in STATES}
    assert all(looks.values())
    assert len({look[1] for look in looks.values() if look is not None}) == len(STATES)


def test_every_finding_leads_to_its_rule_its_file_and_its_section() -> None:
    findings = [node for node in tree("widget").iter("li") if (node.get("id") or "").startswith("finding-")]
    assert findings
    for node in findings:
        text = " ".join("".join(node.itertext()).split())
        assert re.search(r"(error|warning) [a-z_]+: .*specs/[\w./-]+:\d+.*See ", text), text
        assert any((link.get("href") or "").startswith("#") for link in node.iter("a"))


@pytest.mark.parametrize("layout", all_layouts(), ids=lambda layout: f"{layout.device.id}@{layout.device.version}")
def test_boxes_lie_within_their_drawing_and_not_on_each_other(layout) -> None:  # type: ignore[no-untyped-def]
    for drawn in maps(spaces_of(layout)):
        for drawing in drawn.drawings:
            taken: set[tuple[int, int]] = set()
            for box in drawing.boxes:
                assert box.x >= 0
                assert box.x + box.width <= drawing.width
                assert box.y + box.height <= drawing.height
                if drawing.anchor != "map-overview":
                    cells = {(x, box.y) for x in range(box.x, box.x + box.width, 10)}
                    assert not taken & cells, drawing.caption
                    taken |= cells


def test_a_name_breaks_before_an_underline_where_its_end_fits_and_loses_its_middle_where_two_lines_have_no_room() -> (
    None
):
    boxes = [
        box for drawn in maps(spaces_of(newest(SPECS, "tc100"))) for drawing in drawn.drawings for box in drawing.boxes
    ]
    lines = {box.title.partition(": ")[2].partition(",")[0]: box.lines for box in boxes}
    expected = {
        "near_zone": ("near_zone",),
        "in_position_zone": ("in_position", "_zone"),
        "torque_limit_press_distance": ("torque_limit_press", "_distance"),
        "pulse_rotation_direction": ("pulse_rot…", "…direction"),
        "pulse_input_form": ("pulse_inpu", "t_form"),
        "electronic_gear_numerator": ("electroni…", "…umerator"),
    }
    assert {name: lines[name] for name in expected} == expected


@pytest.mark.parametrize("layout", all_layouts(), ids=lambda layout: f"{layout.device.id}@{layout.device.version}")
def test_rows_that_are_one_are_followed_by_what_comes_behind_them(layout) -> None:  # type: ignore[no-untyped-def]
    for drawn in maps(spaces_of(layout)):
        for drawing in drawn.drawings:
            if drawing.anchor == "map-overview":
                continue
            starts = {mark.y: int(mark.text, 16) for mark in drawing.marks if re.fullmatch("0x[0-9A-F]+", mark.text)}
            folded = {
                box.y: int(re.match("to (0x[0-9A-F]+)", box.title)[1], 16)
                for box in drawing.boxes
                if box.title[:3] == "to "
            }
            for y, end in folded.items():
                behind = [at for at in sorted(starts) if at > y]
                assert [starts[at] for at in behind[1:2]] == [end + 1][: len(behind) - 1], drawing.caption


HOSTILE = "<script>alert(1)</script> \"' & </title></td>--> {{ 7 * 7 }} {% raw %} \x00\x1b \u202e*/ \\ \n zone"


def test_whatever_a_report_says_is_a_text() -> None:
    span = Span(SourceFile(HOSTILE, HOSTILE), 0, 3)
    cells = (HOSTILE, 5, span, Citation(HOSTILE, ((1, 2),)), None)
    table = SectionTable("table", HOSTILE, ("a", "b", HOSTILE, "d", "e"), (cells, cells), ("bad", ""))
    wrong = Diagnostic("some_rule", HOSTILE, span, (Label(span, HOSTILE),), HOSTILE)
    figures = (Figure(HOSTILE, 1, 2, True),)
    section = Section(
        "part", HOSTILE, (HOSTILE,), figures, (table, replace(table, detail=True, name="other")), (wrong,)
    )
    device = replace(newest(TEST_SPECS, "gizmo").device, name=HOSTILE, title=HOSTILE, vendor=HOSTILE)
    device = replace(device, manual=replace(device.manual, title=HOSTILE, edition=HOSTILE, file=HOSTILE))
    text = rendered(Report("x", HOSTILE, HOSTILE, HOSTILE, (section,)), device, {HOSTILE: f"a.html#{HOSTILE}"})
    page = html5lib.HTMLParser(strict=True, namespaceHTMLElements=False).parse(text)
    assert not list(page.iter("script"))
    assert not re.search(r"[\x00-\x08\x0b\x0c\x0e-\x1f]", text)
    text_of_page = "".join(page.itertext())
    assert text_of_page.count("<script>alert(1)</script>") == text_of_page.count("{{ 7 * 7 }}") > 30


def test_texts_of_a_hostile_spec_are_texts() -> None:
    text = page("hostile")
    body = "".join(tree("hostile").find("body").itertext())  # type: ignore[union-attr]
    assert text.count("<script") == 1
    assert not re.search(r"<(?:img|b|/td|/title)>?[^>]*onerror", text)
    assert "</script>" in body
    assert "{{" in body
    assert not re.search(r"[\x00-\x08\x0b\x0c\x0e-\x1f]", text)


def test_the_same_specs_give_the_same_page() -> None:
    assert files.__wrapped__("gizmo") == files("gizmo")


def test_a_page_is_printed_by_the_command(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    run = CommandLine(capsys, monkeypatch, TEST_SPECS)
    ran = run("audit", "gizmo", "--format", "html")
    path = tmp_path / "audit.html"
    assert run("audit", "gizmo", "--format", "html", "--out", str(path)).out == ""
    assert path.read_text("utf-8") == ran.out
    html5lib.HTMLParser(strict=True).parse(ran.out)


def test_a_page_is_of_the_whole_audit(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    ran = CommandLine(capsys, monkeypatch, SPECS)("audit", "esc11", "--format", "html", "--table", "ledger")
    assert (ran.code, ran.err[:43]) == (2, "fieldspec: html shows the whole audit; use ")


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[webdriver.Chrome]:
    options = webdriver.ChromeOptions()
    options.binary_location = require_tool("chromium")
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    with webdriver.Chrome(options=options, service=Service(require_tool("chromedriver"))) as driver:
        yield driver


@pytest.mark.parametrize("device", ["tc100", "hostile"])
def test_a_page_opens_without_errors_and_asks_for_its_script_alone(
    browser: webdriver.Chrome, tmp_path: Path, device: str
) -> None:
    path = tmp_path / device / "audit.html"
    path.parent.mkdir()
    path.write_text(page(device), encoding="utf-8")
    (tmp_path / "search.js").write_text(shared()["search.js"], encoding="utf-8")
    browser.get("about:blank")
    browser.get_log("performance")
    browser.get(path.as_uri())
    assert browser.get_log("browser") == []
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    asked = [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
    assert [url for url in asked if not url.startswith(("data:", path.as_uri()))] == [(tmp_path / "search.js").as_uri()]


def test_names_stay_within_their_boxes(browser: webdriver.Chrome, tmp_path: Path) -> None:
    path = tmp_path / "audit.html"
    path.write_text(page("hiwin-e"), encoding="utf-8")
    browser.get(path.as_uri())
    script = """
        return [...document.querySelectorAll('figure g')].filter(group => {
            const box = group.querySelector('rect').getBBox();
            return [...group.querySelectorAll('text')].some(text => {
                const held = text.getBBox();
                return held.x + held.width > box.x + box.width + 1 || held.y + held.height > box.y + box.height + 1;
            });
        }).map(group => group.textContent)"""
    assert browser.execute_script(script) == []
