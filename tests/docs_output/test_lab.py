"""The frame lab explains and builds frames in a browser, from files, by the keyboard, and asks for nothing else."""

from __future__ import annotations

import json
import re
from collections import Counter
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from docs_output.lab import cells, open_lab, requested, text_of, wait_for
from external_tools import NODE_TOOLS, without
from fieldspec.targets.docs.lab import lab_script

AXE = NODE_TOOLS.parent / "axe-core" / "axe.min.js"
HOMING = "01 06 20 1E 00 03 A2 0D"
READ = "01 03 10 00 00 01 80 CA"
RESPONSIVE = 3000
"""Milliseconds without an answer to a key, on a machine that does much else; reading the whole log takes longer."""
ANSWER = "01 03 02 00 00 B8 44"


def test_a_frame_in_the_address_is_explained_field_by_field(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "tc100", version="2.0", frames=HOMING, direction="request")
    assert text_of(browser, "frame-title").startswith("write_register request, rtu: Write one register")
    assert [row[:3] for row in cells(browser)] == [
        ["0", "01", "station"],
        ["1", "06", "function"],
        ["2", "20 1E", "address"],
        ["4", "00 03", "value"],
        ["6", "A2 0D", "crc"],
    ]
    assert cells(browser)[4][7] == "right"
    ((address, _, register, *_, source),) = cells(browser, "registers")
    assert (address, register, source.split("\n")[0]) == (
        "0x201E",
        "motion_command",
        "8.2 L1624 erratum point-without-command",
    )
    assert "Example rtu-homing" in text_of(browser, "notes")


@pytest.mark.parametrize(
    ("device", "version", "message", "frame", "raw"),
    [
        ("tc100", "2.0", "", HOMING, "1 0x06 0x201E 3 -"),
        ("esc11", "1.17", "", "09 00 16 D0 07 00 00 32 28", "9 0 0x16 2000 50 -"),
        ("hiwin-e", "2.14.4", "read_parameter", "01 01 00 01 10 00 30 00 00 00", "1 0x01 0 1 16 0 0x3000 0"),
        ("hiwin-e", "2.14.4", "telegram_3", "01 01 00 01 21 00 00 00 00 00", "0x0101 73984 0x0000 0x0000"),
    ],
)
def test_raw_values_have_the_base_in_which_the_command_line_prints_them(
    browser: webdriver.Chrome, folder: Path, device: str, version: str, message: str, frame: str, raw: str
) -> None:
    direction = "received" if message == "telegram_3" else "request"
    open_lab(browser, folder, device, version=version, frames=frame, direction=direction, message=message)
    assert " ".join(row[4] or "-" for row in cells(browser)) == raw


def test_a_field_leads_to_its_fact(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "tc100", version="2.0", frames=HOMING)
    browser.find_element(By.CSS_SELECTOR, "#registers a").click()
    assert browser.current_url.endswith("tc100/2.0.html#registers/motion_command")
    assert browser.find_element(By.CSS_SELECTOR, "tr:target").is_displayed()


def test_the_page_loads_its_own_files_alone_and_reports_no_error(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get_log("browser")
    open_lab(browser, folder, "hiwin-e", version="2.14.4", frames="04 7F 00 00", direction="sent")
    requested(browser)
    browser.refresh()
    wait_for(browser, 1)
    own = {
        url.partition("#")[0].rpartition("/")[2]
        for url in requested(browser)
        if not url.startswith(("data:", "chrome:"))
    }
    assert own == {"lab.html", "lab.js", "search.js", "lab-2.14.4.js"}
    assert browser.get_log("browser") == []


def test_fields_and_bytes_are_highlighted_both_ways(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "tc100", version="2.0", frames=HOMING)
    lit = "return [...document.querySelectorAll('#bytes .lit')].map((byte) => byte.textContent).join(' ')"
    browser.execute_script("document.querySelectorAll('#rows tbody tr')[2].focus()")
    assert browser.execute_script(lit) == "20 1E"
    browser.execute_script("document.querySelectorAll('#bytes li')[7].click()")
    names = browser.find_elements(By.CSS_SELECTOR, "#rows tr.lit th")
    assert [name.text for name in names] == ["crc"]


def test_a_damaged_frame_is_explained_up_to_its_fault(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "tc100", version="2.0", frames="01 06 20 1E 00", direction="request", link="rtu")
    assert "refused" in text_of(browser, "frame-title")
    assert "are missing for" in text_of(browser, "faults")
    assert cells(browser)[2][2] == "address"


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("nonsense", "Line 1 is not a frame: there are no bytes in it"),
        ("01 0G", "Line 1 is not a frame: `0G` is not a byte in hexadecimal digits"),
        ("01 " * 4000, "Line 1 is not a frame: it has 8192 characters or more"),
    ],
    ids=["nonsense", "a wrong digit", "too long"],
)
def test_what_is_no_frame_is_reported(browser: webdriver.Chrome, folder: Path, text: str, why: str) -> None:
    open_lab(browser, folder, "tc100", 0)
    browser.execute_script("document.getElementById('frames').value = arguments[0]", text)
    browser.find_element(By.ID, "frames").send_keys(" ")
    wait_for(browser, 1)
    assert text_of(browser, "input-fault") == why


def test_a_log_pairs_requests_and_responses(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "tc100", 4, version="2.0", frames=f"TX: {READ}\nRX: {ANSWER}\nhello\n{ANSWER[:-1]}5\n")
    assert text_of(browser, "log-status") == "4 frames in 4 lines, 2 with faults"
    browser.find_element(By.ID, "log-list").send_keys(Keys.ARROW_DOWN)
    assert text_of(browser, "remarks") == "this answers the request in line 1"
    assert cells(browser, "registers")[0][0] == "0x1000"
    browser.find_element(By.ID, "faults-only").click()
    assert len(browser.find_elements(By.CSS_SELECTOR, "#log-rows li")) == 2


def test_a_log_of_100_000_lines_stays_responsive(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "tc100", 0)
    script = """
        const box = document.getElementById("frames");
        box.value = `TX: ${arguments[0]}\\nRX: ${arguments[1]}\\n`.repeat(50000);
        window.longest = 0;
        let last = performance.now();
        window.beat = setInterval(() => {
            window.longest = Math.max(window.longest, performance.now() - last);
            last = performance.now();
        }, 10);
        const begin = () => { last = performance.now(); window.longest = 0; box.dispatchEvent(new Event("input")); };
        requestAnimationFrame(() => setTimeout(begin));  // when the browser has drawn the text"""
    browser.execute_script(script, READ, ANSWER)
    WebDriverWait(browser, 60).until(lambda _: "in 100000 lines" in text_of(browser, "log-status"))
    browser.find_element(By.ID, "log-list").send_keys(Keys.ARROW_DOWN)
    assert "this answers" in text_of(browser, "remarks")
    read = int(text_of(browser, "log-status").split()[0])
    WebDriverWait(browser, 60).until(lambda _: int(text_of(browser, "log-status").split()[0]) > read)
    assert browser.execute_script("return window.longest") < RESPONSIVE
    browser.find_element(By.ID, "clear").click()
    wait_for(browser, 0)


def test_a_frame_is_explained_at_once_however_slow_the_machine_is(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "ck10", 0)
    script = """
        let now = performance.now();
        performance.now = () => { now += 1000; return now; };
        const choose = document.getElementById("example");
        choose.selectedIndex = 1;
        choose.dispatchEvent(new Event("change"));
        return !document.getElementById("explanation").hidden;"""
    assert browser.execute_script(script)


def test_an_edited_field_gives_the_bytes(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "esc11", version="1.17", frames="09 00 16 D0 07 00 00 32 28", direction="request")
    box = browser.find_element(By.CSS_SELECTOR, "#fields input[data-path=distance]")
    assert box.get_attribute("value") == "20.00 mm"
    box.clear()
    box.send_keys("21.00 mm")
    assert text_of(browser, "built") == "09 00 16 34 08 00 00 32 8D"
    assert browser.find_element(By.ID, "frames").get_attribute("value") == "09 00 16 34 08 00 00 32 8D"
    box.clear()
    box.send_keys("1 km")
    assert "distance" in text_of(browser, "build-fault")


def test_a_message_is_built_from_the_form_by_the_keyboard(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "tc100", 0)
    choice = browser.find_element(By.ID, "build-message")
    choice.send_keys("write_register")
    choice.send_keys(Keys.TAB, Keys.TAB)
    address = browser.switch_to.active_element
    address.clear()
    address.send_keys("motion_command", Keys.TAB)
    value = browser.switch_to.active_element
    value.clear()
    value.send_keys("homing")
    assert text_of(browser, "built") == HOMING
    assert cells(browser, "registers")[0][6] == "homing 原點復歸"


def test_the_address_says_everything_that_is_entered(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(
        browser, folder, "tc100", version="before-2.0", frames=ANSWER, request=READ, link="rtu", direction="response"
    )
    address = browser.current_url
    explanation = text_of(browser, "explanation")
    browser.get("about:blank")
    browser.get(address)
    wait_for(browser, 1)
    assert (browser.current_url, text_of(browser, "explanation")) == (address, explanation)


@pytest.mark.parametrize(
    ("state", "remark"),
    [
        ({"version": "9.9"}, "There is no version 9.9 here; this is the newest one."),
        ({"version": "2.0", "message": "no_such"}, "This version does not have the message no_such of the address."),
    ],
)
def test_what_is_gone_from_a_link_is_reported(
    browser: webdriver.Chrome, folder: Path, state: dict[str, str], remark: str
) -> None:
    open_lab(browser, folder, "tc100", frames=HOMING, **state)
    assert text_of(browser, "address-remark") == remark
    assert cells(browser)[0][2] == "station"


def test_without_a_clipboard_the_text_is_there_to_be_copied(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "tc100", frames=HOMING)
    forbid = (
        "Object.defineProperty(navigator, 'clipboard', { value: { writeText: () => Promise.reject(new Error()) } })"
    )
    browser.execute_script(forbid)
    browser.find_element(By.ID, "copy").click()
    WebDriverWait(browser, 5).until(lambda _: browser.find_element(By.ID, "copy-text").is_displayed())
    assert browser.find_element(By.ID, "copy-text").get_attribute("value") == HOMING


def test_hostile_texts_stay_texts(browser: webdriver.Chrome, folder: Path) -> None:
    open_lab(browser, folder, "hostile", 0)
    examples = browser.execute_script(
        "return [...document.getElementById('example').options].map(({ value }) => value)"
    )
    choose = """
        const box = document.getElementById("example");
        box.value = arguments[0];
        box.dispatchEvent(new Event("change"));"""
    for example in examples[1:]:
        browser.execute_script(choose, example)
        wait_for(browser, 1)
        assert cells(browser)
    scripts = browser.execute_script("return [...document.scripts].map((script) => script.getAttribute('src'))")
    assert scripts == ["../search.js", "../lab.js", "lab-1.js"]
    assert browser.get_log("browser") == []


def test_no_name_of_the_script_is_declared_twice() -> None:
    names = re.findall(r"^(?:async )?(?:function\*?|class|const|let) (\w+)", lab_script(), re.MULTILINE)
    assert [name for name, count in Counter(names).items() if count > 1] == []
    assert not re.search(r"^(?:import|export)\b", lab_script(), re.MULTILINE)


def test_without_javascript_the_page_names_the_verbs(browser: webdriver.Chrome, folder: Path) -> None:
    browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
    try:
        browser.get("about:blank")
        browser.get((folder / "tc100" / "lab.html").as_uri())
        assert "fieldspec decode tc100" in browser.find_element(By.TAG_NAME, "main").text
        assert not browser.find_element(By.ID, "lab").is_displayed()
    finally:
        browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": False})


@pytest.mark.proof(3)
@pytest.mark.parametrize(
    ("state", "count"),
    [({}, 0), ({"frames": HOMING}, 1), ({"frames": f"{READ}\n{ANSWER}\nx\n"}, 3)],
    ids=["empty", "a frame", "a log"],
)
@pytest.mark.parametrize(("width", "scheme"), [(1400, "light"), (390, "dark")])
def test_axe_finds_no_violation(
    browser: webdriver.Chrome, folder: Path, state: dict[str, str], count: int, width: int, scheme: str
) -> None:
    if not AXE.exists():
        without("axe-core")
    media = {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
    metrics = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", media)
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
    try:
        open_lab(browser, folder, "tc100", count, **state)
        browser.execute_script(AXE.read_text("utf-8"))
        script = "const done = arguments[0]; axe.run().then(result => done(JSON.stringify(result.violations)))"
        violations = json.loads(browser.execute_async_script(script))
        assert [(violation["id"], violation["nodes"][0]["html"]) for violation in violations] == []
        script = "return document.documentElement.scrollWidth <= document.documentElement.clientWidth"
        assert browser.execute_script(script)
    finally:
        browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
