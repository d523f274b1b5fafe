"""Tables of the site are sorted, filtered and copied; pages of the site have nothing that keeps people out."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.remote.webelement import WebElement
from selenium.webdriver.support.ui import Select, WebDriverWait

from docs_output.axe import screen, violations

ROWS = """
    return [...document.getElementById(arguments[0]).querySelector("tbody").rows]
        .filter(row => !row.hidden && !row.classList.contains("opened"))
        .map(row => row.id.split("/").slice(1).join("/"))"""


def opened(browser: webdriver.Chrome, page: Path, section: str) -> WebElement:
    """A section of a page on the screen, when its table has its tools."""
    browser.get("about:blank")
    browser.get(f"{page.as_uri()}#{section}")
    result = browser.find_element(By.ID, section)
    WebDriverWait(browser, 10).until(lambda _: result.find_elements(By.CSS_SELECTOR, ".tools button"))
    return result


def rows(browser: webdriver.Chrome, section: str) -> list[str]:
    """The rows that a section shows, by the ends of their ids."""
    result: list[str] = browser.execute_script(ROWS, section)
    return result


def registers(browser: webdriver.Chrome, section: str) -> list[str]:
    """The rows without those of elements, which follow the row of their register."""
    names = rows(browser, section)
    owners = [name for name in names if "/" not in name]
    groups = [name for owner in owners for name in names if name.partition("/")[0] == owner]
    assert names == groups
    return owners


def test_a_column_sorts_up_and_down_and_back_with_elements_below_their_register(
    browser: webdriver.Chrome, folder: Path
) -> None:
    section = opened(browser, folder / "servo/1.html", "registers/settings")
    before = registers(browser, "registers/settings")
    (heading,) = [cell for cell in section.find_elements(By.CSS_SELECTOR, "thead th") if cell.text == "Name"]
    heading.find_element(By.TAG_NAME, "button").click()
    assert registers(browser, "registers/settings") == sorted(before)
    assert heading.get_attribute("aria-sort") == "ascending"
    heading.find_element(By.TAG_NAME, "button").click()
    assert registers(browser, "registers/settings") == sorted(before, reverse=True)
    heading.find_element(By.TAG_NAME, "button").click()
    assert registers(browser, "registers/settings") == before
    assert heading.get_attribute("aria-sort") is None


def test_numbers_sort_as_numbers(browser: webdriver.Chrome, folder: Path) -> None:
    section = opened(browser, folder / "tc100/2.0.html", "enums/alarm_code")
    code = section.find_element(By.CSS_SELECTOR, "thead button")
    code.click()
    code.click()
    cells = section.find_elements(By.CSS_SELECTOR, "tbody td:first-child code")
    numbers = [int(cell.text) for cell in cells]
    assert numbers == sorted(numbers, reverse=True)
    assert max(numbers) > 9


def test_rows_are_filtered_by_words_and_by_access(browser: webdriver.Chrome, folder: Path) -> None:
    section = opened(browser, folder / "servo/1.html", "registers/settings")
    everything, count = rows(browser, "registers/settings"), len(registers(browser, "registers/settings"))
    section.find_element(By.CSS_SELECTOR, ".tools input").send_keys("ANGLE counter")
    assert set(rows(browser, "registers/settings")) < set(everything)
    assert "counterclockwise_angle_limit" in rows(browser, "registers/settings")
    assert section.find_element(By.CSS_SELECTOR, ".tools [role=status]").text.endswith(f"of {count} rows")
    browser.execute_script("location.hash = '#registers/goals'; location.hash = '#registers/id'")
    WebDriverWait(browser, 5).until(lambda _: rows(browser, "registers/settings") == everything)
    access = Select(section.find_element(By.CSS_SELECTOR, ".tools select"))
    choice = access.options[1].text
    access.select_by_visible_text(choice)
    assert set(rows(browser, "registers/settings")) < set(everything)


def test_rows_are_offered_as_csv_where_the_clipboard_is_forbidden(browser: webdriver.Chrome, folder: Path) -> None:
    section = opened(browser, folder / "hostile/1.html", "enums/none")
    browser.execute_script("navigator.clipboard.writeText = () => Promise.reject(new Error('forbidden'))")
    section.find_element(By.CSS_SELECTOR, ".tools button").click()
    WebDriverWait(browser, 5).until(lambda _: section.find_elements(By.TAG_NAME, "textarea"))
    field = section.find_element(By.TAG_NAME, "textarea")
    assert browser.switch_to.active_element == field
    text = str(field.get_attribute("value"))
    cells = [cell for row in csv.reader(io.StringIO(text)) for cell in row]
    assert "self; <img src=x onerror=alert(1)>" in cells
    assert not [cell for cell in cells if cell.startswith(("=", "+", "@"))]
    assert {len(row) for row in csv.reader(io.StringIO(text))} == {len(next(csv.reader(io.StringIO(text))))}


def test_nothing_is_cut_off_on_paper(browser: webdriver.Chrome, folder: Path) -> None:
    opened(browser, folder / "servo/1.html", "registers/settings")
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        script = "return [...document.querySelectorAll('.scroll')].map(block => getComputedStyle(block).overflowX)"
        assert set(browser.execute_script(script)) == {"visible"}
        assert not [tools for tools in browser.find_elements(By.CLASS_NAME, "tools") if tools.is_displayed()]
    finally:
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


@pytest.mark.proof(2)
@pytest.mark.parametrize(
    ("path", "width", "scheme"),
    [
        ("gadget/1.html", 1400, "light"),
        ("gadget/1.html", 390, "dark"),
        ("index.html", 820, "dark"),
        ("index.html", 390, "light"),
        ("widget/index.html", 390, "light"),
        ("widget/index.html", 1400, "dark"),
        ("widget/changes.html", 820, "light"),
        ("widget/changes.html", 390, "dark"),
    ],
)
def test_axe_finds_no_violation(browser: webdriver.Chrome, folder: Path, path: str, width: int, scheme: str) -> None:
    with screen(browser, width, scheme):
        browser.get("about:blank")
        browser.get((folder / path).as_uri())
        browser.find_element(By.ID, "query").send_keys("e")
        WebDriverWait(browser, 10).until(lambda _: browser.find_elements(By.CSS_SELECTOR, "#results a"))
        assert violations(browser) == []
