"""The search of the site finds things by all their names and numbers, in a browser, by the keyboard alone."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from docs_output.documented import documentation
from fieldspec.targets.docs.search_index import NAME, parsed

SOON = 100
"""Milliseconds from the last key to the results."""

FACTS = [
    # an address, in hexadecimal, as the manual prints it, in decimal, and by its digits alone
    ("tc100/2.0.html", "0x201E", "#registers/motion_command"),
    ("tc100/2.0.html", "201Eh", "#registers/motion_command"),
    ("tc100/2.0.html", "8222", "#registers/motion_command"),
    ("tc100/2.0.html", "201e", "#registers/motion_command"),
    ("ck10/1.html", "0x7E6", "#registers/push_mode"),
    # an address in the fourth element of a table, and in the middle of one
    ("tc100/2.0.html", "0x9044", "#records/point/torque_limit"),
    ("ck10/1.html", "0x4E43", "#records/point/low_speed"),
    # a name, its beginning, its words, the name of the manual, a label in the manual's language
    ("tc100/2.0.html", "motion_command", "#registers/motion_command"),
    ("tc100/2.0.html", "motion com", "#registers/motion_command"),
    ("tc100/2.0.html", "MovType", "#registers/motion_command"),
    ("esc11/1.17.html", "过负荷", "#enums/alarm_code/overload"),
    ("tc100/2.0.html", "移動類型", "#registers/motion_command"),
    # an alarm by its number, its display code, and a word of its remedy
    ("tc100/2.0.html", "alarm 12", "#enums/alarm_code/motor_disconnected"),
    ("hiwin-e/2.14.4.html", "al.410", "#enums/alarm_code/undervoltage"),
    ("tc100/2.0.html", "motor wiring", "#enums/alarm_code/motor_disconnected"),
    # a command code, a telegram, a word of a telegram, a parameter
    ("esc11/1.17.html", "command 0x17", "#messages/move_absolute"),
    ("hiwin-e/2.14.4.html", "telegram 111", "#messages/telegram_111"),
    ("hiwin-e/2.14.4.html", "111 override", "#messages/telegram_111/request/velocity_override"),
    ("hiwin-e/2.14.4.html", "0x3067", "#parameters/drive_parameters/analog_output_1_voltage"),
    # a bit by its number and by its mask
    ("ck10/1.html", "motion status bit 11", "#flags/motion_status/overload"),
    ("ck10/1.html", "0x00000800", "#flags/motion_status/overload"),
    # an alarm by its number goes before other codes with it, and a typing error is read as the nearest name
    ("tc100/2.0.html", "alarm 3", "#enums/alarm_code/overspeed"),
    ("tc100/2.0.html", "motoin_comand", "#registers/motion_command"),
    ("esc11/1.17.html", "overlaod", "#enums/alarm_code/overload"),
    # a frame is for the lab
    ("tc100/2.0.html", "01 06 20 1E 00 03 A2 0D", "lab.html#version=2.0&frames=01+06+20+1E+00+03+A2+0D"),
    ("tc100/2.0.html", "0106201E0003A20D", "lab.html#version=2.0&frames=0106201E0003A20D"),
    ("index.html", "01 06 20 1E 00 03 A2 0D", "axis/lab.html#frames=01+06+20+1E+00+03+A2+0D"),
    # anything on any device
    ("index.html", "0x7E6", "ck10/1.html#registers/push_mode"),
    ("index.html", "tc100 alarm 12", "tc100/2.0.html#enums/alarm_code/motor_disconnected"),
]


def status(browser: webdriver.Chrome) -> str:
    """What the page says of the results."""
    return browser.find_element(By.ID, "found").text


def links(browser: webdriver.Chrome) -> list[str]:
    """Where the results lead, the first one first."""
    script = "return [...document.querySelectorAll('#results a')].map(link => link.getAttribute('href'))"
    result: list[str] = browser.execute_script(script)
    return result


def search(browser: webdriver.Chrome, page: Path, text: str) -> list[str]:
    """The results of a text that is typed into the box of a page, once all data is there."""
    browser.get("about:blank")
    browser.get(page.as_uri())
    return search_again(browser, text)


def search_again(browser: webdriver.Chrome, text: str) -> list[str]:
    """The results of a text that is typed into the empty box of the page that is open."""
    browser.execute_script("""
        const box = document.getElementById("query");
        box.blur(); box.value = ""; box.dispatchEvent(new Event("input"));""")
    browser.find_element(By.TAG_NAME, "body").send_keys("/")
    box = browser.switch_to.active_element
    assert box.get_attribute("id") == "query"
    box.send_keys(text)
    WebDriverWait(browser, 10).until(lambda _: (text := status(browser)) and "so far" not in text)
    return links(browser)


@pytest.mark.proof(7)
@pytest.mark.parametrize(("path", "text", "link"), sorted(FACTS))
def test_a_fact_is_the_first_result_of_its_names_and_numbers(
    browser: webdriver.Chrome, folder: Path, path: str, text: str, link: str
) -> None:
    page = folder / path
    is_open = browser.current_url == page.as_uri()
    assert (search_again(browser, text) if is_open else search(browser, page, text))[:1] == [link]


@pytest.mark.proof(2)
@pytest.mark.parametrize("text", ["e", "0x3067", "the position of the motor", "no such thing at all"])
@pytest.mark.parametrize("path", ["hiwin-e/2.14.4.html", "index.html"])
def test_results_are_there_before_anybody_notices(
    browser: webdriver.Chrome, folder: Path, path: str, text: str
) -> None:
    search(browser, folder / path, text)
    script = """
        const box = document.getElementById("query"), results = document.getElementById("results");
        return [1, 2, 3, 4, 5].map(() => {
            const start = performance.now();
            box.dispatchEvent(new Event("input"));
            results.getBoundingClientRect();
            return performance.now() - start;
        });"""
    assert min(browser.execute_script(script)) < SOON


def test_exact_numbers_stand_before_beginnings_words_and_texts(browser: webdriver.Chrome, folder: Path) -> None:
    page = (folder / "widget/2.0.html").as_uri()
    browser.get(page)
    script = """
        fieldspecSearch.add({
            id: "x", name: "X", language: "", pages: [["2.0", "2.0", ""]],
            groups: [["registers", "S", "registers", [
                [0, "text", "", "see zzyzx there"], [0, "my_zzyzx"], [0, "zzyzx_first"], [0, "key", "zzyzx"]
            ]]]
        });"""
    add = f"Object.defineProperty(document, 'currentScript', {{value: document.scripts[0]}}); {script}"
    browser.execute_script(add)
    browser.find_element(By.ID, "query").send_keys("zzyzx")
    names = [link.rpartition("/")[2] for link in links(browser)]
    assert names == ["key", "zzyzx_first", "my_zzyzx", "text"]


def test_arrows_and_enter_lead_to_a_fact_and_escape_ends_the_search(browser: webdriver.Chrome, folder: Path) -> None:
    search(browser, folder / "servo/1.html", "limit")
    wanted = links(browser)
    browser.switch_to.active_element.send_keys(Keys.ARROW_DOWN)
    browser.switch_to.active_element.send_keys(Keys.ARROW_DOWN)
    assert browser.switch_to.active_element.get_attribute("href").endswith(wanted[1])
    browser.switch_to.active_element.send_keys(Keys.ARROW_UP)
    browser.switch_to.active_element.send_keys(Keys.ENTER)
    assert browser.current_url.endswith(wanted[0])
    WebDriverWait(browser, 5).until(lambda _: browser.switch_to.active_element.get_attribute("id") == wanted[0][1:])
    assert links(browser) == []
    search_again(browser, "limit")
    browser.switch_to.active_element.send_keys(Keys.ESCAPE)
    assert links(browser) == []
    assert browser.switch_to.active_element.get_attribute("value") == ""


def test_enter_in_the_box_opens_the_first_result(browser: webdriver.Chrome, folder: Path) -> None:
    search(browser, folder / "index.html", "compliance_margins")
    browser.switch_to.active_element.send_keys(Keys.ENTER)
    WebDriverWait(browser, 10).until(
        lambda _: browser.current_url.endswith("servo/1.html#registers/compliance_margins")
    )


def test_a_fact_of_another_version_leads_to_that(browser: webdriver.Chrome, folder: Path) -> None:
    (link,) = search(browser, folder / "esc11/before-1.17.html", "reset alarm clears")[:1] or [""]
    everything = search_again(browser, "reset_alarm")
    assert "1.17.html#messages/reset_alarm" in everything, link
    assert browser.find_element(By.CSS_SELECTOR, "#results .badge").text == "only 1.17"


def test_a_link_to_a_fact_that_is_gone_searches_for_it(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get("about:blank")
    browser.get((folder / "servo/1.html").as_uri() + "#registers/gone/max_torque")
    WebDriverWait(browser, 10).until(lambda _: links(browser))
    assert links(browser)[0] == "#registers/max_torque"


def test_labels_stay_texts(browser: webdriver.Chrome, folder: Path) -> None:
    search(browser, folder / "hostile/1.html", "onerror")
    assert "<img src=x onerror=alert(1)>" in browser.find_element(By.ID, "results").text
    assert browser.execute_script("return document.querySelectorAll('img, b').length") == 0
    assert browser.get_log("browser") == []


def test_no_request_leaves_the_folder(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get_log("performance")
    search(browser, folder / "index.html", "overload")
    events = [json.loads(entry["message"])["message"] for entry in browser.get_log("performance")]
    asked = [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
    assert [url for url in asked if not url.startswith((f"{folder.as_uri()}/", "data:", "about:", "chrome:"))] == []
    assert browser.get_log("browser") == []


def test_pages_forbid_themselves_what_they_do_not_need(browser: webdriver.Chrome, folder: Path) -> None:
    browser.get((folder / "gadget/1.html").as_uri())
    script = "document.body.append(Object.assign(document.createElement('script'), {textContent: 'window.ran = 1'}))"
    browser.execute_script(script)
    assert browser.execute_script("return window.ran") is None
    assert "Content Security Policy" in str(browser.get_log("browser"))


def test_the_box_is_hidden_without_scripts(browser: webdriver.Chrome, folder: Path) -> None:
    browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": True})
    try:
        browser.get((folder / "gadget/1.html").as_uri())
        assert not browser.find_element(By.ID, "query").is_displayed()
        assert browser.find_element(By.TAG_NAME, "main").is_displayed()
    finally:
        browser.execute_cdp_cmd("Emulation.setScriptExecutionDisabled", {"value": False})


@pytest.mark.parametrize("path", [path for path in documentation() if path.endswith(NAME)])
def test_every_link_of_the_search_leads_to_an_anchor(path: str) -> None:
    data = parsed(documentation()[path])
    folder = path.partition("/")[0]
    anchors = {
        page: set(re.findall(r' id="([^"]+)"', documentation()[f"{folder}/{page}.html"]))
        for page, *_ in data["pages"]  # type: ignore[attr-defined]
    }
    every = (1 << len(anchors)) - 1
    for _, _, start, rows in data["groups"]:  # type: ignore[attr-defined]
        for end, names, _, _, versions in ((*row, *("", "", 0)[len(row) - 2 :]) for row in rows):
            anchor = "/".join(part for part in (start, names.partition("\n")[0] if end == 0 else end) if part)
            for bit, page in enumerate(anchors):
                if (versions or every) >> bit & 1:
                    assert anchor in anchors[page], (page, anchor)
