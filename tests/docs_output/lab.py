"""The frame lab in a browser, for its tests: a frame or a log in the address, and what the page says."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

_SETTLED = """
    const { ready, frames } = document.getElementById("lab").dataset;
    return Boolean(ready) && frames === arguments[0];"""


def open_lab(browser: webdriver.Chrome, folder: Path, device: str, count: int = 1, **state: str) -> None:
    """Opens the lab of a device with a state in its address, and waits until it has read so many frames."""
    browser.get("about:blank")
    browser.get(f"{(folder / device / 'lab.html').as_uri()}#{urlencode(state)}")
    wait_for(browser, count)


def wait_for(browser: webdriver.Chrome, count: int) -> None:
    WebDriverWait(browser, 20).until(lambda driver: driver.execute_script(_SETTLED, str(count)))


def text_of(browser: webdriver.Chrome, name: str) -> str:
    return browser.find_element(By.ID, name).text


def cells(browser: webdriver.Chrome, table: str = "rows") -> list[list[str]]:
    """The texts of a table of the explanation, row by row."""
    script = """
        const rows = document.querySelectorAll(`#${arguments[0]} tbody tr`);
        return [...rows].map((row) => [...row.cells].map((cell) => cell.innerText.trim()));"""
    result: list[list[str]] = browser.execute_script(script, table)
    return result


def requested(browser: webdriver.Chrome) -> list[Any]:
    """The addresses that the browser has asked for since the last call."""
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    return [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
