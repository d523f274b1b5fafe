"""What the walks and adapters set is what the devices are delivered with, and long enough for their longest frames."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from adapter_texts import DOCS, PROGRAMS, SIEMENS, STRUCTURED

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.controllers.statements.expressions import ArrayType
from fieldspec.targets.iec.backend import source
from layouts import SPECS, newest

Setting = tuple[int, str, int, int]
"""Bits per second, parity, data bits and stop bits."""
BITS_PER_BYTE = 11
"""Start, eight data, parity, stop."""
COE_RATES = {6: 9600, 7: 19200}
COE_FRAMES = {3: "8N1", 4: "8E1", 5: "8O1"}
PORT_RATES = {6: 9600, 7: 19200}
PORT_PARITIES = {1: "none", 2: "even", 3: "odd"}
LOAD_PARITIES = {0: "none", 1: "odd", 2: "even"}
LETTERS = {"N": "none", "E": "even", "O": "odd"}


@cache
def page(name: str) -> str:
    """A page of the documentation in one line."""
    return " ".join((DOCS / name).read_text("utf-8").split())


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


def codesys() -> Setting:
    """What PRG_SerialPort sets."""
    program = PROGRAMS["PRG_SerialPort"]
    (rate,) = searched(r"udiBaudrate;\s*\S+ := (\d+)", program)
    (parity,) = searched(r"COM\.PARITY\.(\w+)", program)
    (size,) = searched(r"udiByteSize;\s*\S+ := (\d+)", program)
    return int(rate), parity.lower(), int(size), {"ONESTOPBIT": 1}[searched(r"STOPBIT\.(\w+)", program)[0]]


def codesys_for_ck10() -> Setting:
    """What the table of the walk makes of it for a CK10."""
    before, after = searched(r"\| (\d+) baud \| (\d+) baud [^|]*; no parity and 1 stop bit too \|", page("plc.md"))
    assert int(before) == codesys()[0]
    return int(after), *codesys()[1:]


def comm_load() -> Setting:
    """What the adapter for Modbus_Master sets."""
    block = SIEMENS["Tc100ModbusMaster"]
    patterns = (r"baud .*:= (\d+)", r"parity .*:= (\d)", r"STOP_BITS := (\d)")
    rate, parity, stop = (searched(pattern, block)[0] for pattern in patterns)
    return int(rate), LOAD_PARITIES[int(parity)], 8, int(stop)


def port_config() -> Setting:
    """What the adapter for Send_P2P sets."""
    pattern = r"BAUD := (\d+), PARITY := (\d), DATABITS := (\d), STOPBITS := (\d), MODE := 4\)"
    rate, parity, data, stop = map(int, searched(pattern, SIEMENS["Esc11PointToPoint"]))
    return PORT_RATES[rate], PORT_PARITIES[parity], {1: 8, 2: 7}[data], stop


def terminal(name: str, number: int) -> Setting:
    """What a page says of the terminal EL6022, by the numbers of its objects; half duplex each time."""
    pattern = r"8000:11 = (\d) \((\d+) bps\), 8000:15 = (\d) \(`?(\w+)`?\), 8000:06 = TRUE \(half duplex\)"
    rate, rate_text, frame, frame_text = re.findall(pattern, page(name))[number]
    assert (COE_RATES[int(rate)], COE_FRAMES[int(frame)]) == (int(rate_text), frame_text)
    return int(rate_text), LETTERS[frame_text[1]], int(frame_text[0]), int(frame_text[2])


def printed(pattern: str, name: str) -> Callable[[], Setting]:
    """What a page says in words."""

    def setting() -> Setting:
        rate, data, parity, stop = searched(pattern, page(name))
        return int(rate), parity, int(data), int(stop)

    return setting


SETTINGS: dict[str, tuple[Callable[[], Setting], str, str]] = {
    "CODESYS, PRG_SerialPort": (codesys, "tc100", "rtu"),
    "CODESYS, the table for a CK10": (codesys_for_ck10, "ck10", "rtu"),
    "S7, Modbus_Comm_Load": (comm_load, "tc100", "rtu"),
    "S7, Port_Config": (port_config, "esc11", "serial"),
    "TwinCAT, the walk": (lambda: terminal("plc.md", 0), "esc11", "serial"),
    "TwinCAT, the example": (lambda: terminal("plc.md", 1), "esc11", "serial"),
    "TwinCAT, Modbus": (lambda: terminal("plc-adapters.md", 0), "tc100", "rtu"),
    "KEYENCE": (
        printed(r"port 2 of the unit \| (\d+) bps, (\d) data bits, (\w+) parity, (\d) stop bit", "plc.md"),
        *("esc11", "serial"),
    ),
    "S7, in words": (
        printed(r"ESC11, which has (\d+) bps, (\d) data bits, (\w+) parity, (\d) stop bit", "plc-adapters.md"),
        *("esc11", "serial"),
    ),
}


@pytest.mark.parametrize("place", SETTINGS)
def test_a_setting_is_that_with_which_the_device_is_delivered(place: str) -> None:
    setting, device, link = SETTINGS[place]
    assert setting() == delivered(device, link)


def test_the_walk_says_how_a_tc100_is_delivered() -> None:
    text = page("plc.md")
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
    begin = milliseconds("tTimeout", STRUCTURED["FB_Esc11SerialPort"])
    assert begin >= longest + timing("response_timeout")


def test_an_answer_that_the_adapter_for_an_s7_awaits_may_be_the_longest_and_begin_as_late() -> None:
    longest = on_the_line("esc11", "serial")
    whole = milliseconds("timeout", SIEMENS["Esc11PointToPoint"])
    assert whole >= longest + timing("response_timeout") + longest


def test_the_character_gap_of_an_s7_is_in_bit_times() -> None:
    bits, characters, each = searched(
        r"of (\d+) bit times, which are (\d+) characters of (\d+) bits", page("plc-adapters.md")
    )
    assert int(bits) == int(characters) * int(each)
    assert int(each) == BITS_PER_BYTE


@pytest.mark.parametrize("cycle", [5])
def test_a_read_of_codesys_lasts_longer_than_a_cycle_and_the_gap_longer_than_a_read(cycle: int) -> None:
    block = STRUCTURED["FB_Tc100SerialPort"]
    (micros,) = searched(r"SIZEOF\(aBytes\), udiTimeOut := (\d+)\)", block)
    assert f"interval {cycle} ms" in page("plc.md")
    read = int(micros) / 1000
    # A read, a cycle in which its input falls, the cycle of its next edge, and that in which it has bytes.
    assert (read > cycle, milliseconds("tGap", block) > read + 3 * cycle) == (True, True)


def test_a_write_of_codesys_may_be_the_longest_at_the_lowest_rate() -> None:
    frame = source(layout("tc100")).declared.world.frame
    assert isinstance(frame, ArrayType)
    serial = layout("tc100").device.links["rtu"].serial
    assert serial is not None
    micros = max(int(value) for value in re.findall(r"udiTimeOut := (\d+)\)", STRUCTURED["FB_Tc100SerialPort"]))
    assert micros > (frame.high + 1) * BITS_PER_BYTE * 1_000_000 / min(serial.baud)


def test_the_port_of_an_s7_knows_the_instance_of_its_master() -> None:
    call = searched(r"#load\((REQ.*?)\);", " ".join(SIEMENS["Tc100ModbusMaster"].split()))[0]
    assert "MB_DB := #master.MB_DB" in call
