"""Pages work in a browser: no errors, nothing from the network, a filter, and both colour schemes."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from docs_output.documented import documentation
from external_tools import require_tool

FLAGS = (
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--window-size=1400,1000",
)


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[webdriver.Chrome]:
    options = webdriver.ChromeOptions()
    options.binary_location = require_tool("chromium")
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    with webdriver.Chrome(options=options, service=Service(require_tool("chromedriver"))) as driver:
        driver.get("about:blank")
        yield driver


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("docs")
    for path, text in documentation().items():
        (root / path).parent.mkdir(exist_ok=True)
        (root / path).write_text(text, encoding="utf-8")
    return root


def rows(browser: webdriver.Chrome) -> list[str]:
    """The ids of the rows that are to be seen."""
    script = "return [...document.querySelectorAll('tbody tr[id]')].filter(r => r.offsetParent).map(r => r.id)"
    result: list[str] = browser.execute_script(script)
    return result


def filtered(browser: webdriver.Chrome, folder: Path, path: str, text: str) -> list[str]:
    browser.get((folder / path).as_uri())
    browser.find_element(By.ID, "filter").send_keys(text)
    return rows(browser)


@pytest.mark.parametrize("path", ["tc100/2.0.html", "esc11/1.17.html", "hostile/1.html", "widget/index.html"])
def test_a_page_opens_without_errors_and_asks_for_nothing(browser: webdriver.Chrome, folder: Path, path: str) -> None:
    browser.get_log("performance")
    browser.get((folder / path).as_uri())
    assert browser.get_log("browser") == []
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    asked = [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
    of_the_page = {url for url in asked if not url.startswith(("data:", "chrome:"))}
    assert of_the_page == {(folder / path).as_uri()}


def test_the_filter_finds_a_register_by_its_address(browser: webdriver.Chrome, folder: Path) -> None:
    actual = filtered(browser, folder, "tc100/2.0.html", "0x2011")
    assert "registers/servo" in actual
    assert "registers/motion_command" not in actual
    assert browser.find_element(By.ID, "count").text.endswith("rows")


def test_the_filter_finds_an_alarm_by_its_label(browser: webdriver.Chrome, folder: Path) -> None:
    assert "enums/alarm_code/overload" in filtered(browser, folder, "esc11/1.17.html", "过负荷")


def test_the_filter_takes_words_in_any_order_and_case(browser: webdriver.Chrome, folder: Path) -> None:
    assert filtered(browser, folder, "widget/2.0.html", "WEIGHT overload") == ["enums/alarm/overload"]


def test_the_filter_hides_sections_and_contents_that_have_nothing(browser: webdriver.Chrome, folder: Path) -> None:
    filtered(browser, folder, "widget/2.0.html", "no such thing at all")
    assert not [element for element in browser.find_elements(By.TAG_NAME, "section") if element.is_displayed()]
    assert not [element for element in browser.find_elements(By.CSS_SELECTOR, "nav li") if element.is_displayed()]


def test_escape_shows_everything_again(browser: webdriver.Chrome, folder: Path) -> None:
    few = filtered(browser, folder, "widget/2.0.html", "overload")
    browser.find_element(By.ID, "filter").send_keys(Keys.ESCAPE)
    assert len(rows(browser)) > len(few) > 0
    assert browser.find_element(By.ID, "count").text == ""


def test_a_slash_leads_to_the_filter(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get((folder / "widget/2.0.html").as_uri())
    browser.find_element(By.TAG_NAME, "body").send_keys("/")
    assert browser.switch_to.active_element.get_attribute("id") == "filter"


def test_a_link_to_a_hidden_row_ends_the_filter(browser: webdriver.Chrome, folder: Path) -> None:
    filtered(browser, folder, "widget/2.0.html", "overload")
    browser.execute_script("location.hash = '#registers/lamp'")
    browser.execute_async_script("setTimeout(arguments[0], 50)")
    assert "registers/lamp" in rows(browser)


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
    assert browser.execute_script("return document.scripts.length") == 1
    assert "<img src=x onerror=alert(1)>" in browser.find_element(By.TAG_NAME, "main").text


def test_a_page_can_be_printed(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get((folder / "widget/2.0.html").as_uri())
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        assert not browser.find_element(By.TAG_NAME, "aside").is_displayed()
        assert browser.find_element(By.TAG_NAME, "main").is_displayed()
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
