"""Pages work in a browser: no errors, nothing from the network, both colour schemes, and on paper."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By

from fieldspec.targets.docs.site import SCRIPTS


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
    browser.get((folder / "widget/2.0.html").as_uri())
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
    browser.get((folder / "widget/2.0.html").as_uri())
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        assert not browser.find_element(By.TAG_NAME, "aside").is_displayed()
        assert browser.find_element(By.TAG_NAME, "main").is_displayed()
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


PHONE = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True}
GENERATED = Path(__file__).resolve().parents[2] / "generated" / "docs"


@pytest.mark.parametrize(
    "path",
    ["index.html", "tc100/2.0.html", "tc100/index.html", "tc100/lab.html", "tc100/audit.html", "hiwin-e/audit.html"],
)
def test_nothing_is_wider_than_a_phone(browser: webdriver.Chrome, path: str) -> None:
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", PHONE)
    try:
        browser.get((GENERATED / path).as_uri())
        assert browser.execute_script("return document.documentElement.scrollWidth") <= PHONE["width"]
    finally:
        browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


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


@pytest.mark.parametrize("path", ["tc100/2.0.html", "ck10/1.html", "esc11/1.17.html", "hiwin-e/2.14.4.html"])
def test_no_group_of_a_page_is_out_of_sight(browser: webdriver.Chrome, path: str) -> None:
    browser.get((GENERATED / path).as_uri())
    script = "return [...document.querySelectorAll('main > section')].map(section => section.offsetHeight)"
    assert max(browser.execute_script(script)) < 45_000  # pixels; the examples of a TC100 had 57,000


def test_the_tables_of_an_example_open_at_a_click(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get((folder / "esc11/1.17.html").as_uri())
    example = browser.find_element(By.CSS_SELECTOR, "section[id^='examples/']")
    summary, table = (example.find_element(By.TAG_NAME, name) for name in ("summary", "table"))
    before = table.is_displayed()
    browser.execute_script("arguments[0].click()", summary)
    assert (before, table.is_displayed()) == (False, True)
