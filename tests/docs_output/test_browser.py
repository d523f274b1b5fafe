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
