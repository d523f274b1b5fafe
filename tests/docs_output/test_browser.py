"""Pages work in a browser: no errors, nothing from the network, both colour schemes, and on paper."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

from docs_output.axe import screen, violations
from fieldspec.targets.docs.site import SCRIPTS
from proofs import IS_WHOLE


@pytest.mark.proof(3)
@pytest.mark.parametrize(
    "path", ["tc100/2.0.html", "esc11/1.17.html", "hostile/1.html", "widget/index.html", "index.html"]
)
def test_a_page_opens_without_errors_and_asks_for_its_scripts_alone(
    browser: webdriver.Chrome, folder: Path, path: str
) -> None:
    browser.get_log("performance")
    browser.get((folder / path).as_uri())
    assert browser.get_log("browser") == []
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    asked = [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
    of_the_page = {url for url in asked if not url.startswith(("data:", "chrome:"))}
    assert of_the_page == {(folder / name).as_uri() for name in (path, *SCRIPTS)}


@pytest.mark.parametrize(("scheme", "dark"), [("light", False), ("dark", True)])
def test_a_page_follows_the_colour_scheme(browser: webdriver.Chrome, folder: Path, scheme: str, dark: bool) -> None:
    media = {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", media)
    browser.get((folder / "gadget/1.html").as_uri())
    ground = browser.execute_script("return getComputedStyle(document.body).backgroundColor")
    text = browser.execute_script("return getComputedStyle(document.body).color")
    level = {name: sum(map(int, value[4:-1].split(","))) for name, value in (("ground", ground), ("text", text))}
    assert (level["ground"] < level["text"]) is dark


def test_hostile_texts_run_nothing(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get((folder / "hostile/1.html").as_uri())
    scripts = browser.execute_script("return [...document.scripts].map(script => script.getAttribute('src'))")
    assert scripts == [f"../{name}" for name in SCRIPTS]
    assert "<img src=x onerror=alert(1)>" in browser.find_element(By.TAG_NAME, "main").text


def test_a_page_can_be_printed(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get((folder / "gadget/1.html").as_uri())
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        assert not browser.find_element(By.TAG_NAME, "aside").is_displayed()
        assert browser.find_element(By.TAG_NAME, "main").is_displayed()
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


PHONE = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True}
GENERATED = Path(__file__).resolve().parents[2] / "generated" / "docs"


@pytest.mark.proof(3)
@pytest.mark.parametrize(
    "path",
    ["index.html", "tc100/2.0.html", "tc100/index.html", "tc100/lab.html", "tc100/audit.html", "hiwin-e/audit.html"],
)
def test_nothing_is_wider_than_a_phone(browser: webdriver.Chrome, path: str) -> None:
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", PHONE)
    try:
        browser.get((GENERATED / path).as_uri())
        assert browser.execute_script("return document.documentElement.scrollWidth") <= PHONE["width"]
        assert browser.get_log("browser") == []
    finally:
        browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


FEWER_FACTS = """
    const alike = "tbody > tr:nth-child(n + 7), main > section > section:nth-of-type(n + 5)";
    document.querySelectorAll(alike).forEach(fact => fact.remove());"""
"""Leaves some facts of each kind: axe takes long for thousands that are alike. A whole proof has all of them."""


@pytest.mark.proof(1)
@pytest.mark.parametrize(
    ("path", "scheme"),
    [
        *(("esc11/audit.html", scheme) for scheme in ("light", "dark")),
        *(("esc11/1.17.html", scheme) for scheme in ("dark", "light")),
    ],
)
def test_axe_finds_no_violation_on_a_page_of_a_device(browser: webdriver.Chrome, path: str, scheme: str) -> None:
    with screen(browser, 1400, scheme):
        browser.get("about:blank")
        browser.get((GENERATED / path).as_uri())
        if not IS_WHOLE:
            browser.execute_script(FEWER_FACTS)
        assert violations(browser) == []


def test_a_link_to_a_row_shows_the_row_below_the_names_of_its_columns(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get("about:blank")
    browser.get((folder / "tc100/2.0.html").as_uri() + "#registers/motion_command")
    script = """
        const row = document.getElementById("registers/motion_command"), head = row.closest("table").tHead;
        const place = (node) => node.getBoundingClientRect();
        return [place(head.rows[0].cells[0]).top, place(head.rows[0].cells[0]).bottom, place(row).top, innerHeight];"""
    top, bottom, row, height = browser.execute_script(script)
    assert -2 <= top < bottom <= row + 2 < height


def test_a_page_has_an_icon(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get((folder / "index.html").as_uri())
    script = """
        const icon = new Image(); icon.src = document.querySelector("link[rel=icon]").href;
        return icon.decode().then(() => icon.naturalWidth);"""
    assert browser.execute_script(script) > 0


@pytest.mark.proof(2)
@pytest.mark.parametrize("path", ["tc100/2.0.html", "ck10/1.html", "esc11/1.17.html", "hiwin-e/2.14.4.html"])
def test_a_page_is_not_out_of_sight(browser: webdriver.Chrome, path: str) -> None:
    browser.get("about:blank")
    browser.get((GENERATED / path).as_uri())
    height = browser.execute_script("return document.documentElement.scrollHeight")
    assert height < 60_000  # pixels; the page of the HIWIN E had 128,000


IS_VISIBLE = """
    const place = document.getElementById(arguments[0]).getBoundingClientRect();
    return place.height > 0 && place.top >= 0 && place.top < innerHeight;"""


CLOSE_ALL = """
    history.replaceState(null, "", location.pathname);
    document.querySelectorAll("details[open]").forEach(group => { group.open = false; });
    scrollTo(0, 0);"""


@pytest.mark.proof(1)
@pytest.mark.parametrize(
    ("path", "anchor"),
    [
        ("station/1.html", "messages/write_coils"),
        ("hiwin-e/2.14.4.html", "flags/status_word_1"),
        ("hiwin-e/2.14.4.html", "flags/status_word_1/alarm"),
        ("hiwin-e/2.14.4.html", "messages/telegram_111/request/mdi_velocity"),
    ],
)
def test_a_link_opens_the_group_of_its_target(browser: webdriver.Chrome, folder: Path, path: str, anchor: str) -> None:
    page = (folder / path).as_uri()
    browser.get("about:blank")
    browser.get(f"{page}#{anchor}")
    assert browser.execute_script(IS_VISIBLE, anchor)
    browser.execute_script(CLOSE_ALL)
    is_visible_before = browser.execute_script(IS_VISIBLE, anchor)
    browser.execute_script("location.hash = arguments[0]", anchor)
    WebDriverWait(browser, 10).until(lambda _: browser.execute_script(IS_VISIBLE, anchor))
    assert not is_visible_before


def test_a_click_opens_all_groups_of_a_section(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get("about:blank")
    browser.get((folder / "station/1.html").as_uri())
    messages = browser.find_element(By.ID, "messages")
    messages.find_element(By.CSS_SELECTOR, ":scope > .tools button").click()
    folds = messages.find_elements(By.CSS_SELECTOR, ":scope > section > details")
    assert {fold.get_attribute("open") for fold in folds} == {"true"}


def test_the_tables_of_an_example_open_at_a_click(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get("about:blank")
    browser.get(f"{(folder / 'esc11/1.17.html').as_uri()}#examples/move-relative-request")
    example = browser.find_element(By.ID, "examples/move-relative-request")
    summary = example.find_element(By.XPATH, ".//summary[text()='Byte by byte']")
    table = example.find_element(By.TAG_NAME, "table")
    before = table.is_displayed()
    browser.execute_script("arguments[0].click()", summary)
    assert (before, table.is_displayed()) == (False, True)
