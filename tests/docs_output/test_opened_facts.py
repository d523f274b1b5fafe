"""Facts open in a browser: bits, quantities, values, code and versions; frames are strips; versions are compared."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from docs_output.axe import screen, violations
from docs_output.documented import documentation
from docs_output.usage_rows import usages
from fieldspec.targets.docs.fact_index import NAME, parsed

ANSWERS = [
    # which word of telegram 111 holds the override, and what is 100 %
    ("hiwin-e/2.14.4.html", "111 override", ["Word 5 of 111", "16384\n0x4000\n100 %"]),
    # what is 0x7E6, and what may I write
    (
        "ck10/1.html",
        "0x7E6",
        ["It stops when it meets the workpiece.", "write_request(ck10.PUSH_MODE, ck10.PushMode.STOP)"],
    ),
    # the words of a number of 32 bits, at their addresses
    ("tc100/2.0.html", "0x2002", ["Word 1 of 2, at 0x2002", "bits 31 to 24", "Word 2 of 2, at 0x2003"]),
    # a bit of a word of a telegram
    ("hiwin-e/2.14.4.html", "status_word_1_positioning 2", ["Layout of status_word_1_positioning"]),
    # a bit within its word
    ("ck10/1.html", "motion status bit 11", ["Layout of motion_status"]),
]


def open_page(browser: webdriver.Chrome, page: Path, anchor: str = "") -> None:
    browser.get("about:blank")
    browser.get(f"{page.as_uri()}{anchor}")


def opened(browser: webdriver.Chrome) -> str:
    """The text of the fact that is open, once its data is there."""
    WebDriverWait(browser, 10).until(lambda _: browser.find_elements(By.CSS_SELECTOR, ".fact > *"))
    script = "return [...document.querySelectorAll('.fact')].map(fact => fact.innerText).join('\\n')"
    return re.sub(r"\s*[\t\n]\s*", "\n", browser.execute_script(script))


@pytest.mark.proof(2)
@pytest.mark.parametrize(("path", "question", "texts"), ANSWERS, ids=[question for _, question, _ in ANSWERS])
def test_the_first_result_of_a_question_opens_the_answer(
    browser: webdriver.Chrome, folder: Path, path: str, question: str, texts: list[str]
) -> None:
    open_page(browser, folder / path)
    browser.find_element(By.TAG_NAME, "body").send_keys("/")
    box = browser.switch_to.active_element
    box.send_keys(question)
    status = browser.find_element(By.ID, "found")
    WebDriverWait(browser, 10).until(lambda _: status.text and "so far" not in status.text)
    box.send_keys(Keys.ENTER)
    answer = opened(browser)
    assert [text for text in texts if text not in answer] == []
    assert browser.get_log("browser") == []


def test_a_row_opens_and_closes_by_the_keyboard(browser: webdriver.Chrome, folder: Path) -> None:
    open_page(browser, folder / "servo/1.html", "#registers")
    opener = WebDriverWait(browser, 5).until(lambda _: browser.find_element(By.CSS_SELECTOR, ".opener"))
    opener.send_keys(Keys.ENTER)
    assert opener.get_attribute("aria-expanded") == "true"
    assert opened(browser)
    opener.send_keys(Keys.SPACE)
    assert browser.find_elements(By.CLASS_NAME, "fact") == []


def test_code_can_be_chosen_by_language_and_stays_chosen(browser: webdriver.Chrome, folder: Path) -> None:
    open_page(browser, folder / "tc100/2.0.html", "#registers/motion_command")
    opened(browser)
    browser.find_element(By.XPATH, "//button[text()='Structured Text']").click()
    (text,) = usages("st", "tc100")[1]["registers/motion_command"]
    assert browser.find_element(By.CSS_SELECTOR, ".fact pre").text == text.strip()
    browser.execute_script("location.hash = '#registers/motion_speed'")
    blocks = WebDriverWait(browser, 5).until(lambda _: browser.find_elements(By.CSS_SELECTOR, ".fact pre")[1:])
    assert "FB_Tc100_WriteMotion" in browser.find_elements(By.CSS_SELECTOR, ".fact pre")[-1].text, blocks


def test_code_is_selected_where_the_clipboard_is_forbidden(browser: webdriver.Chrome, folder: Path) -> None:
    open_page(browser, folder / "tc100/2.0.html", "#registers/motion_command")
    opened(browser)
    browser.execute_script("navigator.clipboard.writeText = () => Promise.reject(new Error('forbidden'))")
    copier = browser.find_element(By.XPATH, "//button[text()='Copy']")
    copier.click()
    WebDriverWait(browser, 5).until(lambda _: copier.text == "Selected")
    assert "write_request" in browser.execute_script("return String(getSelection())")


def test_an_open_fact_stays_below_its_row(browser: webdriver.Chrome, folder: Path) -> None:
    open_page(browser, folder / "servo/1.html", "#registers/max_torque")
    opened(browser)
    script = """
        const row = document.getElementById("registers/max_torque"), block = row.closest("section");
        [...block.querySelectorAll("thead button")].find(button => button.textContent === "Name").click();
        const follows = row.nextElementSibling.classList.contains("opened");
        const filter = block.querySelector(".tools input");
        filter.value = "no such row"; filter.dispatchEvent(new Event("input"));
        return [follows, row.nextElementSibling.hidden];"""
    WebDriverWait(browser, 5).until(lambda _: browser.find_elements(By.CSS_SELECTOR, "#registers thead button"))
    assert browser.execute_script(script) == [True, True]


def test_request_and_response_are_strips_whose_parts_lead_to_their_rows(
    browser: webdriver.Chrome, folder: Path
) -> None:
    open_page(browser, folder / "esc11/1.17.html", "#messages/move_absolute")
    strips = WebDriverWait(browser, 5).until(
        lambda _: browser.find_elements(By.CSS_SELECTOR, "[id='messages/move_absolute'] .strip")
    )
    assert len(strips) == 2
    assert [part.text.split("\n") for part in strips[0].find_elements(By.CLASS_NAME, "part")][:2] == [
        ["0", "length"],
        ["1", "address"],
    ]
    links = strips[0].find_elements(By.TAG_NAME, "a")
    assert {link.get_attribute("href").partition("#")[2].rpartition("/")[0] for link in links} >= {
        "messages/move_absolute/request"
    }


def test_two_versions_are_compared_inline(browser: webdriver.Chrome, folder: Path) -> None:
    open_page(browser, folder / "hiwin-e/2.14.4.html")
    menu = browser.find_element(By.ID, "versions")
    browser.execute_script("arguments[0].value = '3'; arguments[0].dispatchEvent(new Event('change'))", menu)
    WebDriverWait(browser, 5).until(lambda _: browser.find_elements(By.ID, "differences"))
    steps = parsed(documentation()[f"hiwin-e/{NAME}"])["steps"]
    messages = [row[2] for step in steps for row in step[2]]  # type: ignore[attr-defined]
    rows = browser.find_elements(By.CSS_SELECTOR, "#differences tbody tr")
    assert len(rows) == len(messages) > 10
    marks = browser.execute_script("return [...document.querySelectorAll('.difference')].map(mark => mark.textContent)")
    assert len(marks) > 5
    assert all(mark.partition(": ")[2] in messages for mark in marks)
    browser.execute_script("arguments[0].value = ''; arguments[0].dispatchEvent(new Event('change'))", menu)
    assert browser.find_elements(By.CSS_SELECTOR, ".difference, #differences") == []


def test_hostile_texts_stay_texts_in_open_facts(browser: webdriver.Chrome, folder: Path) -> None:
    open_page(browser, folder / "hostile/1.html", "#registers")
    openers = WebDriverWait(browser, 5).until(lambda _: browser.find_elements(By.CSS_SELECTOR, ".opener"))
    for opener in openers:
        browser.execute_script("arguments[0].click()", opener)
    opened(browser)
    assert browser.execute_script("return document.querySelectorAll('main img, main b, main script').length") == 0
    assert browser.get_log("browser") == []


@pytest.mark.proof(1)
@pytest.mark.parametrize(
    ("anchor", "width", "scheme"),
    [("registers/input_1_function", 1400, "light"), ("messages/telegram_3/response/status", 390, "dark")],
)
def test_axe_finds_no_violation_in_an_open_fact(
    browser: webdriver.Chrome, folder: Path, anchor: str, width: int, scheme: str
) -> None:
    with screen(browser, width, scheme):
        open_page(browser, folder / "glider-x/1.1.html", f"#{anchor}")
        opened(browser)
        assert violations(browser, f"#{anchor.partition('/')[0]}") == []
