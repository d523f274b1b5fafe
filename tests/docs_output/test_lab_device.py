"""The frame lab talks to a simulated device over a WebSocket, and to a serial port of the browser."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect
from websockets.typing import Origin

from docs_output.documented import documentation
from docs_output.lab import cells, open_lab, text_of, wait_for
from fieldspec.targets.docs.lab import request_data
from layouts import SPECS, TEST_SPECS, newest

READ = "01 03 10 00 00 01 80 CA"
HOMING = "01 06 20 1E 00 03 A2 0D"
ANSWER = [0x01, 0x03, 0x02, 0x00, 0x00, 0xB8, 0x44]
DOUBLE = Path(__file__).with_name("serial_double.js")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site with the pages of one device alone."""
    root = tmp_path_factory.mktemp("docs")
    for path, text in documentation().items():
        if path.rpartition("/")[0] in ("", "tc100"):
            (root / path).parent.mkdir(exist_ok=True)
            (root / path).write_text(text, encoding="utf-8")
    return root


@dataclass
class Simulated:
    """A device that `fieldspec simulate` serves to browsers."""

    process: subprocess.Popen[str]
    addresses: dict[str, str]

    def command(self, **command: Any) -> Any:
        """The answer to a command on standard input."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps(command) + "\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())


@pytest.fixture(scope="module")
def device() -> Iterator[Simulated]:
    command = [sys.executable, "-m", "fieldspec", "simulate", "tc100", "--websocket", "0", "--control"]
    pipe = subprocess.PIPE
    process = subprocess.Popen(
        [*command, "--specs", str(SPECS)], stdin=pipe, stdout=pipe, stderr=pipe, text=True, encoding="utf-8"
    )
    assert process.stderr is not None
    places = [process.stderr.readline().strip().partition(", ")[2].partition(": ") for _ in ("rtu", "ascii")]
    yield Simulated(process, {link: address for link, _, address in places})
    process.kill()
    process.communicate()


def click(browser: webdriver.Chrome, name: str) -> None:
    browser.find_element(By.ID, name).click()


def enter(browser: webdriver.Chrome, name: str, text: str) -> None:
    box = browser.find_element(By.ID, name)
    box.clear()
    box.send_keys(text)


def connected(browser: webdriver.Chrome, folder: Path, address: str, frames: str = READ) -> None:
    """Opens the lab with a request and connects it to a simulated device."""
    open_lab(browser, folder, "tc100", version="2.0", frames=frames, direction="request")
    enter(browser, "patience", "30000")
    enter(browser, "socket-address", address)
    click(browser, "connect")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "connection").startswith("Connected"))


def send(browser: webdriver.Chrome) -> None:
    """Sends the request, and waits for what becomes of it."""
    script = "return document.getElementById('send').dataset.count ?? '0'"
    before = browser.execute_script(script)
    click(browser, "send")
    WebDriverWait(browser, 40).until(lambda _: browser.execute_script(script) != before)


def test_a_read_is_answered_and_explained(browser: webdriver.Chrome, folder: Path, device: Simulated) -> None:
    browser.get_log("browser")
    connected(browser, folder, device.addresses["rtu"])
    assert text_of(browser, "send-remark") == "read_registers only reads."
    send(browser)
    assert text_of(browser, "frame-title").startswith("read_registers response, rtu")
    assert cells(browser, "registers")[0][2] == "action_status"
    assert text_of(browser, "traffic-lines") == f"TX: {READ}\nRX: 01 03 02 00 00 B8 44"
    browser.execute_script("document.getElementById('known-direction').value = 'request'")
    click(browser, "traffic-log")
    wait_for(browser, 2)
    assert browser.find_element(By.ID, "known-direction").get_attribute("value") == ""
    click(browser, "connect")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "connect") == "Connect")
    assert browser.get_log("browser") == []


def test_a_write_waits_for_the_switch_and_names_its_hazards(
    browser: webdriver.Chrome, folder: Path, device: Simulated
) -> None:
    connected(browser, folder, device.addresses["rtu"], HOMING)
    assert not browser.find_element(By.ID, "send").is_enabled()
    assert text_of(browser, "hazards").split("\n") == [
        "motion_command: writing it starts something",
        "motion_command: the manual does not say that it can be written",
    ]
    click(browser, "allow-writes")
    send(browser)
    assert text_of(browser, "frame-title").startswith("write_register response")
    assert device.command(get=["axis/moving"])["values"] == {"axis/moving": True}
    click(browser, "connect")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "connect") == "Connect")
    assert not browser.find_element(By.ID, "allow-writes").is_selected()
    device.command(power="cycle")


@pytest.mark.proof(2)
@pytest.mark.parametrize(
    ("address", "entry", "reason"),
    [
        ("motion_speed", "100000", "not in 0..100"),
        ("motion_speed", "101", "not in 0..100"),
        ("motion_speed", "fast", "fast"),
        ("motion_speed", "", "value"),
        ("motion_sped", "50", "motion_sped"),
    ],
)
def test_nothing_is_sent_while_an_entry_is_refused(
    browser: webdriver.Chrome, folder: Path, device: Simulated, address: str, entry: str, reason: str
) -> None:
    connected(browser, folder, device.addresses["rtu"], HOMING)
    click(browser, "allow-writes")
    for path, text in (("address", address), ("value", entry)):
        box = browser.find_element(By.CSS_SELECTOR, f"#fields [data-path='{path}']")
        box.send_keys(Keys.CONTROL, "a")
        box.send_keys(Keys.BACKSPACE, text)
    assert reason in text_of(browser, "build-fault")
    assert not browser.find_element(By.ID, "send").is_enabled()
    assert text_of(browser, "send-remark") == "What is entered in the form makes no frame, so nothing is sent."
    for path, text in (("address", "motion_speed"), ("value", "50")):
        box = browser.find_element(By.CSS_SELECTOR, f"#fields [data-path='{path}']")
        box.send_keys(Keys.CONTROL, "a")
        box.send_keys(Keys.BACKSPACE, text)
    assert text_of(browser, "built") == "01 06 20 14 00 32 43 DB"
    assert browser.find_element(By.ID, "send").is_enabled()
    click(browser, "connect")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "connect") == "Connect")


@pytest.mark.proof(3)
@pytest.mark.parametrize(
    ("fault", "text"),
    [
        ("no_answer", "No answer within 2000 ms."),
        ("wrong_checksum", "No valid answer within 2000 ms, but 7 bytes: wrong_checksum."),
        ("truncated", "No valid answer within 2000 ms"),
        ("wrong_unit", "The answer does not fit the request."),
        ("exception", "The device refuses the request."),
        ("connection_lost", "The simulator has closed the connection."),
    ],
)
def test_what_goes_wrong_is_shown(
    browser: webdriver.Chrome, folder: Path, device: Simulated, fault: str, text: str
) -> None:
    connected(browser, folder, device.addresses["rtu"])
    enter(browser, "patience", "2000")
    reason = {"reason": "value_invalid"} if fault == "exception" else {}
    assert device.command(fault=fault, **reason)["ok"]
    send(browser)
    assert text_of(browser, "exchange-fault").startswith(text)
    assert text_of(browser, "connect") == ("Connect" if fault == "connection_lost" else "Disconnect")


def test_a_request_of_another_link_is_not_sent(browser: webdriver.Chrome, folder: Path, device: Simulated) -> None:
    connected(browser, folder, device.addresses["ascii"])
    assert text_of(browser, "send-remark") == ("The request is one of the link rtu, and the connection is to ascii.")
    assert not browser.find_element(By.ID, "send").is_enabled()
    enter(browser, "frames", r":010310000001EB\r\n")
    browser.execute_script("document.getElementById('known-direction').value = 'request'")
    WebDriverWait(browser, 40).until(lambda _: browser.find_element(By.ID, "send").is_enabled())
    send(browser)
    assert text_of(browser, "frame-title").startswith("read_registers response, ascii")


@pytest.mark.parametrize(
    ("address", "text"),
    [
        ("ws://example.com/rtu", "The address begins with ws://127.0.0.1"),
        ("ws://127.0.0.1:1/rtu?key=x", "No response from this address."),
    ],
)
def test_an_address_without_a_simulator_is_refused(
    browser: webdriver.Chrome, folder: Path, address: str, text: str
) -> None:
    open_lab(browser, folder, "tc100", frames=READ)
    enter(browser, "socket-address", address)
    click(browser, "connect")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "exchange-fault").startswith(text))
    assert text_of(browser, "connection") == "Not connected."


@pytest.mark.parametrize("origin", [None, "null", "http://localhost:8080", "http://127.0.0.1:1"])
def test_pages_of_this_machine_may_connect(device: Simulated, origin: str | None) -> None:
    with connect(device.addresses["rtu"], origin=Origin(origin) if origin else None) as socket:
        socket.send(bytes.fromhex(READ))
        assert socket.recv(timeout=5) == bytes(ANSWER)


@pytest.mark.parametrize(
    ("end", "origin", "status"),
    [
        ("", "https://example.com", 403),
        ("", "http://localhost.example.com", 403),
        ("x", "null", 403),
        ("&link=rtu", "null", 101),
    ],
)
def test_other_pages_and_wrong_keys_are_refused(device: Simulated, end: str, origin: str, status: int) -> None:
    try:
        with connect(device.addresses["rtu"] + end, origin=Origin(origin)):
            have = 101
    except InvalidStatus as error:
        have = error.response.status_code
    assert have == status


def test_a_link_that_the_device_does_not_have_is_refused(device: Simulated) -> None:
    with pytest.raises(InvalidStatus) as raised:
        connect(device.addresses["rtu"].replace("/rtu", "/serial"))
    assert (raised.value.response.status_code, raised.value.response.body) == (404, b"The links are rtu, ascii.\n")


@pytest.fixture
def serial(browser: webdriver.Chrome) -> Iterator[None]:
    """A serial port in each page, which is no real one."""
    source = {"source": DOUBLE.read_text("utf-8")}
    script = browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", source)["identifier"]
    yield
    browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", {"identifier": script})


def test_a_serial_port_is_opened_as_the_manual_says_and_answers_in_pieces(
    browser: webdriver.Chrome, folder: Path, serial: None
) -> None:
    open_lab(browser, folder, "tc100", version="2.0", frames=READ, direction="request")
    browser.execute_script("document.getElementById('carrier').value = 'serial'")
    browser.execute_script("document.getElementById('carrier').dispatchEvent(new Event('change'))")
    click(browser, "connect")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "connection") == "Connected to the serial port.")
    settings = {"baudRate": 19200, "dataBits": 8, "parity": "none", "stopBits": 1, "bufferSize": 4096}
    assert browser.execute_script("return plug.opened") == settings
    browser.execute_script("plug.answers.push(arguments[0])", ANSWER)
    send(browser)
    assert browser.execute_script("return plug.sent") == [list(bytes.fromhex(READ))]
    assert text_of(browser, "traffic-lines").endswith("RX: 01 03 02 00 00 B8 44")
    browser.execute_script("plug.disturb()")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "exchange-fault") == "On the line: a parity error")
    browser.execute_script("plug.stray([0, 255]); plug.answers.push(arguments[0])", ANSWER)
    send(browser)
    assert text_of(browser, "exchange-fault") == "2 unrequested bytes came before."
    browser.execute_script("plug.remove()")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "connection") == "The serial port is gone.")
    click(browser, "connect")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "connection") == "Connected to the serial port.")
    click(browser, "connect")
    WebDriverWait(browser, 40).until(lambda _: text_of(browser, "connection") == "Not connected.")
    assert browser.execute_script("return plug.closed") is True


def test_only_the_lab_may_connect_and_only_to_this_machine(folder: Path) -> None:
    pages = {page.name: page.read_text("utf-8") for page in folder.glob("tc100/*.html")}
    assert len(pages) > 2
    assert [name for name, text in pages.items() if "connect-src" in text] == ["lab.html"]
    assert '; connect-src ws://localhost:* ws://127.0.0.1:*"' in pages["lab.html"]


def test_requests_that_only_read_are_known_by_the_spec() -> None:
    reads = request_data(newest(SPECS, "esc11"))["reads"]
    assert isinstance(reads, dict)
    names = reads["serial"]
    assert isinstance(names, list)
    assert {"read_current_position", "read_parameter"} < set(names)
    assert not {"stop", "move_to_point", "write_parameter", "clear_points"} & set(names)
    assert request_data(newest(SPECS, "hiwin-e"))["reads"] == {"cyclic": [], "parameter_channel": ["read_parameter"]}
    assert request_data(newest(TEST_SPECS, "station"))["reads"]["rtu"]  # type: ignore[index,call-overload]
