"""What axe-core finds on the page that a browser shows, at a width and in a colour scheme."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from selenium import webdriver

from external_tools import NODE_TOOLS, without

AXE = NODE_TOOLS.parent / "axe-core" / "axe.min.js"


@contextmanager
def screen(browser: webdriver.Chrome, width: int, scheme: str) -> Iterator[None]:
    """A screen of a width, in a colour scheme."""
    metrics = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    media = {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", media)
    try:
        yield
    finally:
        browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})


def violations(browser: webdriver.Chrome, inside: str = "body") -> list[dict[str, Any]]:
    """The violations within the elements of a selector."""
    if not AXE.exists():
        without("axe-core")
    browser.execute_script(AXE.read_text("utf-8"))
    script = "const done = arguments[1]; axe.run(arguments[0]).then(result => done(JSON.stringify(result.violations)))"
    result: list[dict[str, Any]] = json.loads(browser.execute_async_script(script, inside))
    return result
