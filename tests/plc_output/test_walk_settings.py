"""What programs and pages set is what devices are delivered with, and long enough for their longest frames."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from adapter_texts import CODESYS, SIEMENS, STRUCTURED, sources
from page import PAGES

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.controllers.statements.expressions import ArrayType
from fieldspec.targets.iec.backend import source
from layouts import SPECS, newest

Setting = tuple[int, str, int, int]
"""Bits per second, parity, data bits and stop bits."""
BITS_PER_BYTE = 11
"""Start, eight data, parity, stop."""
COE_RATES = {6: 9600, 7: 19200, 10: 115200}
COE_FRAMES = {3: "8N1", 4: "8E1", 5: "8O1"}
PORT_RATES = {6: 9600, 7: 19200}
PORT_PARITIES = {1: "none", 2: "even", 3: "odd"}
LOAD_PARITIES = {0: "none", 1: "odd", 2: "even"}
LETTERS = {"N": "none", "E": "even", "O": "odd"}


@cache
def page(name: str) -> str:
    """A page of the documentation in one line."""
    return " ".join(PAGES[name].split())


def layout(device: str) -> DeviceLayout:
    """The newest version of a device."""
    return newest(SPECS, device)


def member(device: str, register: str) -> str:
    """The name of the value with which a register is delivered."""
    value = next(item.register.value for item in layout(device).registers if item.name == register)
    assert value.enum is not None
    members = layout(device).device.enums[value.enum].members
    return next(item.name for item in members if item.value == value.default)


def delivered(device: str, link: str) -> Setting:
    """How a device is delivered: by its link, and where it has registers for that, by their defaults."""
    serial = layout(device).device.links[link].serial
    assert serial is not None
    names = {item.name for item in layout(device).registers}
    parity = member(device, "parity").removesuffix("_parity") if "parity" in names else serial.parity[0]
    rate = serial.default_baud or serial.baud[0]
    if "baud_rate" in names:
        assert str(rate) in member(device, "baud_rate")
    bits = 8 if "data_bits" in names else serial.data_bits[0]
    return rate, {"no": "none"}.get(parity, parity), bits, serial.stop_bits[0]


def searched(pattern: str, text: str) -> tuple[str, ...]:
    """The groups of a pattern that a text has."""
    match = re.search(pattern, text)
    assert match, pattern
    return match.groups()


def codesys(device: str) -> Setting:
    """What the program for CODESYS opens the port with."""
    program = CODESYS[f"PRG_{device}_SerialPort"]
    (rate,) = searched(r"udiBaudrate;\s*\S+ := (\d+)", program)
    (parity,) = searched(r"COM\.PARITY\.(\w+)", program)
    (size,) = searched(r"udiByteSize;\s*\S+ := (\d+)", program)
    stops = {"ONESTOPBIT": 1, "TWOSTOPBITS": 2}
    return int(rate), parity.lower(), int(size), stops[searched(r"STOPBIT\.(\w+)", program)[0]]


def comm_load(device: str) -> Setting:
    """What the adapter for Modbus_Master sets."""
    block = SIEMENS[f"{device}_ModbusMaster"]
    patterns = (r"baud .*:= (\d+)", r"parity .*:= (\d)", r"STOP_BITS := (\d)")
    rate, parity, stop = (searched(pattern, block)[0] for pattern in patterns)
    return int(rate), LOAD_PARITIES[int(parity)], 8, int(stop)


def port_config(device: str) -> Setting:
    """What the adapter for Send_P2P sets."""
    pattern = r"BAUD := (\d+), PARITY := (\d), DATABITS := (\d), STOPBITS := (\d), MODE := 4\)"
    rate, parity, data, stop = map(int, searched(pattern, SIEMENS[f"{device}_PointToPoint"]))
    return PORT_RATES[rate], PORT_PARITIES[parity], {1: 8, 2: 7}[data], stop


def terminal(text: str) -> Setting:
    """What a text says of the terminal EL6022, by the numbers of its objects; half duplex each time."""
    pattern = r"8000:11 = (\d+) \((\d+) bps\), 8000:15 = (\d) \((\w+)\), 8000:06 = TRUE \(half duplex\)"
    rate, rate_text, frame, frame_text = searched(pattern, text)
    assert (COE_RATES[int(rate)], COE_FRAMES[int(frame)]) == (int(rate_text), frame_text)
    return framed(rate_text, frame_text)


def framed(rate: str, frame: str) -> Setting:
    """A setting that is written as 9600 and 8E1."""
    return int(rate), LETTERS[frame[1]], int(frame[0]), int(frame[2])


LINKS = {"tc100": ("Tc100", "rtu"), "ck10": ("Ck10", "rtu"), "esc11": ("Esc11", "serial")}
"""The devices on lines: their names in programs, and the links that the programs use."""
PROGRAM_SETTINGS: dict[str, tuple[Callable[[], Setting], str]] = {
    **{f"CODESYS, {device}": (partial(codesys, name), device) for device, (name, _) in LINKS.items()},
    **{f"S7, {device}": (partial(comm_load, LINKS[device][0]), device) for device in ("tc100", "ck10")},
    "S7, esc11": (partial(port_config, "Esc11"), "esc11"),
}
"""The places of programs that set a line."""


@pytest.mark.parametrize("place", PROGRAM_SETTINGS)
def test_a_program_sets_the_line_as_the_device_is_delivered(place: str) -> None:
    setting, device = PROGRAM_SETTINGS[place]
    assert setting() == delivered(device, LINKS[device][1])


@pytest.mark.proof(5)
@pytest.mark.parametrize("house", ["codesys", "twincat", "siemens", "standard"])
@pytest.mark.parametrize("device", LINKS)
def test_a_comment_has_the_settings_with_which_the_device_is_delivered(house: str, device: str) -> None:
    addresses = layout(device).device.links[LINKS[device][1]].unit_addresses
    assert addresses is not None
    assert addresses.ranges is not None
    for item in sources(house, layout(device)):
        comment = " ".join(item.remarks)
        rate, frame, station = searched(r"Settings of [^:]*: (\d+) bps, (\w+), station (\d+)\.", comment)
        assert framed(rate, frame) == delivered(device, LINKS[device][1])
        assert int(station) == addresses.ranges.intervals[0][0]
        if house == "twincat":
            assert terminal(comment) == delivered(device, LINKS[device][1])


PARITIES = (("no parity", "none"), ("parity none", "none"), ("even parity", "even"), ("odd parity", "odd"))
NAMED = re.compile(r"TC100|CK10|ESC11")


def printed() -> list[tuple[str, str, str]]:
    """Every setting that a page prints: the page, the device that was named last before it, and the text after it."""
    settings = []
    for name in PAGES:
        text = page(name)
        for match in re.finditer(r"(\d{4,6}) (?:bps|baud)\b", text):
            device = NAMED.findall(text[: match.start()])[-1]
            settings.append((name, device.lower(), text[match.start() : match.start() + 90]))
    return settings


@pytest.mark.parametrize(("name", "device", "text"), printed())
def test_a_page_prints_the_settings_with_which_the_device_is_delivered(name: str, device: str, text: str) -> None:
    rate, parity, data, stop = delivered(device, LINKS[device][1])
    assert int(text.split()[0]) == rate
    printed_parity = next((value for words, value in PARITIES if words in text), parity)
    frame = re.search(r"\b[78][NEO][12]\b", text)
    stops, datas = re.search(r"(\d) stop bit", text), re.search(r"(\d) data bits", text)
    assert printed_parity == parity
    if frame is not None:
        assert framed(str(rate), frame[0]) == (rate, parity, data, stop)
    assert [int(settings[1]) for settings in (datas, stops) if settings] == [data] * bool(datas) + [stop] * bool(stops)


def test_the_pages_print_settings_for_each_device_on_a_line() -> None:
    assert {device for _, device, _ in printed()} == {*LINKS}


@pytest.mark.parametrize("device", ["esc11", "tc100"])
def test_a_page_sets_the_terminal_as_the_device_is_delivered(device: str) -> None:
    text = page("plc-twincat.md")
    (section,) = re.findall(rf"## {device.upper()}.*?(?=## |$)", text)
    assert terminal(section) == delivered(device, LINKS[device][1])


def test_a_command_that_the_walk_tells_to_write_is_a_value_of_the_register() -> None:
    text = page("plc-codesys.md")
    commands = set(re.findall(r"\b(protocol|save)=(\w+)", text))
    assert commands == {(name, item) for name, item in commands if item in members("tc100", name)}
    assert len(commands) == 3
    number, value = searched(r"Set parameter (\d+) to (\d), Modbus RTU", text)
    register = next(item.register for item in layout("ck10").registers if item.register.number == int(number))
    assert members("ck10", register.name)["modbus_rtu"] == int(value)


def members(device: str, register: str) -> dict[str, int]:
    """The names of the values of a register."""
    value = next(
        item.register.value for item in layout(device).registers if register in (item.name, *item.register.roles)
    )
    assert value.enum is not None
    return {item.name: item.value for item in layout(device).device.enums[value.enum].members}


def test_the_walk_says_how_a_tc100_is_delivered() -> None:
    text = page("plc-codesys.md")
    printed_values = dict(re.findall(r"(0x0A0\d) = (\d)", text))
    registers = {f"0x{item.address:04X}": item.register.value.default for item in layout("tc100").registers}
    assert {name: registers[name] for name in printed_values} == {
        name: int(value) for name, value in printed_values.items()
    }
    assert len(printed_values) == 3


def milliseconds(name: str, block: str) -> int:
    """The initial value of a time of an adapter."""
    return int(searched(rf"\b{name} : TIME := T#(\d+)ms", block)[0])


def on_the_line(device: str, link: str) -> int:
    """How long the longest frame of a device takes, in ms, as it is delivered."""
    frame = source(layout(device)).declared.world.frame
    assert isinstance(frame, ArrayType)
    return (frame.high + 1) * BITS_PER_BYTE * 1000 // delivered(device, link)[0] + 1


def timing(name: str) -> int:
    """A time that the manual of the ESC11 prints, in ms."""
    limit = next(limit for limit in layout("esc11").device.limits if limit.name == name)
    assert limit.unit == "ms"
    return int(limit.value or limit.high or 0)


def test_an_answer_that_the_adapter_for_twincat_awaits_may_begin_as_late_as_the_manual_says() -> None:
    longest = on_the_line("esc11", "serial")
    begin = milliseconds("Timeout", STRUCTURED["FB_Esc11_SerialPort"])
    assert begin >= longest + timing("response_timeout")


def test_an_answer_that_the_adapter_for_an_s7_awaits_may_be_the_longest_and_begin_as_late() -> None:
    longest = on_the_line("esc11", "serial")
    whole = milliseconds("timeout", SIEMENS["Esc11_PointToPoint"])
    assert whole >= longest + timing("response_timeout") + longest


def test_the_character_gap_of_an_s7_is_in_bit_times() -> None:
    bits, characters, each = searched(
        r"of (\d+) bit times end a message: (\d+) characters of (\d+) bits", page("plc-tia.md")
    )
    assert int(bits) == int(characters) * int(each)
    assert int(each) == BITS_PER_BYTE


@pytest.mark.parametrize("cycle", [5])
def test_a_read_of_codesys_lasts_longer_than_a_cycle_and_the_gap_longer_than_a_read(cycle: int) -> None:
    block = STRUCTURED["FB_Tc100_SerialPort"]
    (micros,) = searched(r"SIZEOF\(aBytes\), udiTimeOut := (\d+)\)", block)
    assert f"interval {cycle} ms" in page("plc-codesys.md")
    read = int(micros) / 1000
    # A read, a cycle in which its input falls, the cycle of its next edge, and that in which it has bytes.
    assert (read > cycle, milliseconds("Gap", block) > read + 3 * cycle) == (True, True)


def test_a_write_of_codesys_may_be_the_longest_at_the_lowest_rate() -> None:
    frame = source(layout("tc100")).declared.world.frame
    assert isinstance(frame, ArrayType)
    serial = layout("tc100").device.links["rtu"].serial
    assert serial is not None
    micros = max(int(value) for value in re.findall(r"udiTimeOut := (\d+)\)", STRUCTURED["FB_Tc100_SerialPort"]))
    assert micros > (frame.high + 1) * BITS_PER_BYTE * 1_000_000 / min(serial.baud)


def test_the_port_of_an_s7_knows_the_instance_of_its_master() -> None:
    call = searched(r"#instLoad\((REQ.*?)\);", " ".join(SIEMENS["Tc100_ModbusMaster"].split()))[0]
    assert "MB_DB := #instMaster.MB_DB" in call
