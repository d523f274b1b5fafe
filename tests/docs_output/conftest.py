"""A browser, and the documentation of all devices as files, for the tests of the site."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.chrome.service import Service

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
    "--disable-extensions",
    "--disable-component-extensions-with-background-pages",
    # One process for all pages, which are files of one folder, and none in reserve for the next page.
    "--disable-features=SpareRendererForSitePerProcess,BackForwardCache,ProactivelySwapBrowsingInstance,"
    "IsolateOrigins,site-per-process",
    "--window-size=1400,1000",
)


@pytest.fixture(scope="session")
def only_browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[webdriver.Chrome]:
    options = webdriver.ChromeOptions()
    options.binary_location = require_tool("chromium")
    for flag in (*FLAGS, f"--user-data-dir={tmp_path_factory.mktemp('profile')}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    with webdriver.Chrome(options=options, service=Service(require_tool("chromedriver"))) as driver:
        driver.set_script_timeout(240)  # axe takes long on a busy machine
        yield driver


@pytest.fixture(scope="module")
def browser(only_browser: webdriver.Chrome) -> webdriver.Chrome:
    """The browser with nothing left of another module."""
    only_browser.get("about:blank")
    for kind in ("browser", "performance"):
        only_browser.get_log(kind)
    return only_browser


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("docs")
    for path, text in documentation().items():
        (root / path).parent.mkdir(exist_ok=True)
        (root / path).write_text(text, encoding="utf-8")
    return root
