"""The generated JavaScript and the frame lab do in Chromium what Node and the compiler do, for every example frame."""

from __future__ import annotations

import json
import shutil
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from selenium import webdriver

from docs_output.lab import open_lab
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.tools.carriers.pages import PageServer
from js_output import javascript
from js_output.javascript import judged, package
from js_output.test_javascript_explanations import LAYOUTS, explained_by_python, jobs_of
from js_output.test_javascript_frames import job
from layouts import SPECS, TEST_SPECS, layouts

NEWEST = [versions[-1] for root in (SPECS, TEST_SPECS) for versions in layouts(root).values() if versions[-1].links]

JUDGE = """
    const done = arguments[arguments.length - 1];
    const run = async (jobs) => {
        const { judge } = await import("/judging.mjs");
        const results = [];
        for (const job of jobs) results.push({ id: job.id, ...judge(await import(job.module), job) });
        return JSON.stringify(results);
    };
    run(arguments[0]).then(done, (error) => done(JSON.stringify(error.stack)));"""

# Chooses each example, and takes what the page says of it; then the form makes the frame again.
READ_EXAMPLES = """
    const byId = (id) => document.getElementById(id);
    const choose = byId("example");
    return [...choose.options].filter(({ value }) => value).map(({ value }) => {
        choose.value = value;
        choose.dispatchEvent(new Event("change"));
        const explained = !byId("explanation").hidden;
        const rows = [...document.querySelectorAll("#rows tbody tr")].map((row) => ({
            offset: row.cells[0].textContent,
            raw: row.cells[1].querySelector("code").textContent,
            path: row.cells[2].textContent,
            value: row.cells[5].textContent,
            verdict: row.cells[7].textContent,
            source: [...row.cells[8].childNodes].find(({ nodeType }) => nodeType === Node.TEXT_NODE)?.data.trim() ?? "",
        }));
        const remarks = [...document.querySelectorAll("#remarks li")].map((item) => item.textContent);
        const field = document.querySelector("#fields input:not([type=checkbox])");
        field?.dispatchEvent(new Event("input", { bubbles: true }));
        return {
            id: value,
            explained,
            rows,
            remarks,
            hasField: Boolean(field),
            fault: byId("build-fault").textContent,
            built: byId("built").textContent,
        };
    });"""


@pytest.fixture(scope="module")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a page beside the generated modules, since browsers load no modules from files."""
    root = tmp_path_factory.mktemp("modules")
    shutil.copytree(package(), root / "devices")
    shutil.copy(Path(javascript.__file__).with_name("judging.mjs"), root)
    (root / "index.html").write_text("<!doctype html><title>modules</title>", "utf-8")
    server = PageServer(root, 0)
    thread = threading.Thread(target=server.serve, daemon=True)
    thread.start()
    yield server.address
    server.close()


def test_modules_read_every_example_in_a_browser_as_in_node(browser: webdriver.Chrome, address: str) -> None:
    jobs = [
        job(layout, example, 0, example.frame)
        for layout in LAYOUTS.values()
        for example in layout.device.examples.values()
    ]
    browser.get(address)
    folder = str(package())
    here = [{**row, "module": row["module"].replace(folder, "/devices")} for row in jobs]
    results = json.loads(browser.execute_async_script(JUDGE, here))
    assert results == judged(jobs)


def frames_of_lab(layout: DeviceLayout) -> dict[str, dict[str, Any]]:
    """What the compiler says of the examples of a device, as the lab reads them."""
    expected = {}
    for example in layout.device.examples.values():
        known = next(jobs_of(layout, example))
        expected[example.id] = explained_by_python(layout, known)
    return expected


@pytest.mark.proof(4)
@pytest.mark.parametrize("layout", NEWEST, ids=lambda layout: layout.device.id)
def test_the_lab_explains_and_builds_every_example(
    browser: webdriver.Chrome, folder: Path, layout: DeviceLayout
) -> None:
    open_lab(browser, folder, layout.device.id, 0)
    expected = frames_of_lab(layout)
    results = browser.execute_script(READ_EXAMPLES)
    assert [result["id"] for result in results] == list(expected)
    for result in results:
        want = expected[result["id"]]
        assert result["explained"]
        assert result["remarks"] == want["remarks"], result["id"]
        rows = [
            {
                "offset": row["can_place"] or str(row["offset"]),
                "raw": " ".join(row["raw"][at : at + 2] for at in range(0, len(row["raw"]), 2)),
                "path": row["path"] or row["doc"] or "surplus",
                "value": row["value"] or "",
                "verdict": (row["verdict"] or "").replace("wrong", "doubtful", row["reason"] == "out_of_range"),
                "source": row["source"] or "",
            }
            for row in want["rows"]
        ]
        assert result["rows"] == rows, result["id"]
        if result["hasField"] and not want["wrong"]:
            assert result["fault"] == "", result["id"]
            digits = result["built"].replace(" ", "")
            characters = result["built"].replace("\\r", "\r").replace("\\n", "\n").encode("latin-1").hex().upper()
            example = layout.device.examples[result["id"]]
            link = layout.links[example.link]
            if link.link.preamble is None:
                assert want["frame"] in (digits, characters), result["id"]
                continue
            # An example may have a longer preamble than the one that is sent.
            shape, frames = link.frame(example.direction), (bytes.fromhex(want["frame"]), bytes.fromhex(digits))
            assert len({frame[shape.surplus(frame) :] for frame in frames}) == 1, result["id"]
