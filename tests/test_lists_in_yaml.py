"""YAML of Solarman and ESPHome becomes devices that read the same quantities from the same registers.

The quantities are computed as the two programs compute them: by the sum of shifted registers, less the offset, times
the scale, and by numbers of the sizes and orders that the documentation of ESPHome has.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any, TypeAlias

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from command_line import CommandLine
from fieldspec.cli import main
from fieldspec.codec.explain.values import number_of
from fieldspec.codec.layout.device import DeviceLayout
from layouts import newest

DEFINITION = """\
# A made-up inverter
requests:
  - {start: 0x0000, end: 0x0040, mb_functioncode: 0x03}
  - {start: 0x0100, end: 0x0110, mb_functioncode: 0x04}
parameters:
  - group: solar
    items:
      - {name: PV Power, class: power, state_class: measurement, uom: W, rule: 1, registers: [0x0001], icon: "mdi:sun"}
      - {name: "Total Production", uom: kWh, scale: 0.1, rule: 3, registers: [0x0003, 0x0004], validation: {min: 0.1}}
      - {name: "Grid Power", uom: W, scale: 10, rule: 4, registers: [0x0008, 0x0007]}
      - {name: "Temperature", uom: "°C", scale: 0.1, offset: 1000, rule: 1, registers: [0x000A]}
      - {name: "Current", uom: A, scale: 0.01, rule: 2, registers: [0x0101], range: {min: -100, max: 100}}
      - {name: "Serial", rule: 5, registers: [0x0010, 0x0011, 0x0012]}
      - name: "Running Status"
        rule: 1
        scale: 1
        registers: [0x0014]
        lookup:
          - {key: 0, value: "Stand-by"}
          - {key: 2, value: "Normal"}
          - {key: 4, value: "FAULT"}
      - {name: "Level", uom: "%", scale: 0.5, rule: 1, mask: 0x0FF0, registers: [0x0016]}
      - {name: "Relay", rule: 1, mask: 0x8000, registers: [0x0016]}
      - {name: "Pump", rule: 1, bit: 3, registers: [0x0016]}
      - {name: Alarms, rule: 6, registers: [0x0018], lookup: [{bit: 0, value: Over voltage}, {bit: 3, value: Fan}]}
  - group: other
    items:
      - {name: "Version", rule: 7, registers: [0x001A]}
      - {name: "Split", rule: 3, scale: 1, registers: [0x0020, 0x0025]}
      - {name: "Sum", rule: 0, sensors: [{registers: [0x0001]}]}
      - {name: "Signs", rule: 1, mask: 0x8001, registers: [0x0026]}
"""
CONFIGURATION = """\
esphome: {name: meter}
wifi:
  password: !secret wifi
modbus_controller:
  - {id: unit, address: 0x1}
sensor:
  - platform: uptime
    name: Uptime
  - platform: modbus_controller
    name: Voltage
    id: voltage
    register_type: holding
    address: 0x10
    value_type: U_WORD
    unit_of_measurement: V
    filters:
      - multiply: 0.1
  - platform: modbus_controller
    name: Power
    register_type: read
    address: 0x20
    value_type: S_DWORD_R
    unit_of_measurement: W
    filters:
      - multiply: 0.5
      - offset: -40
  - platform: modbus_controller
    name: Frequency
    register_type: read
    address: 0x22
    value_type: FP32
    accuracy_decimals: 2
  - platform: modbus_controller
    name: Energy
    register_type: read
    address: 0x24
    value_type: U_QWORD
    lambda: |-
      return x / 10.0;
  - platform: modbus_controller
    name: Offset
    register_type: read
    address: 0x30
    offset: 4
    value_type: U_WORD
number:
  - platform: modbus_controller
    name: Set voltage
    address: 0x10
    value_type: U_WORD
    multiply: 10
  - platform: modbus_controller
    name: Limit
    address: 0x11
    value_type: S_WORD
    multiply: 100
    min_value: -5
    max_value: 5
binary_sensor:
  - {platform: modbus_controller, name: Door, register_type: holding, address: 0x12, bitmask: 0x80}
  - {platform: modbus_controller, name: Input, register_type: discrete_input, address: 3}
switch:
  - {platform: modbus_controller, name: Pump, register_type: coil, address: 0x15}
select:
  - platform: modbus_controller
    name: Mode
    address: 0x13
    value_type: U_WORD
    optionsmap: {"Off": 0, "Heat": 1, "Cool": 5}
text_sensor:
  - platform: modbus_controller
    name: Label
    register_type: holding
    address: 0x40
    register_count: 3
    response_size: 6
  - {platform: modbus_controller, name: Nothing, address: 0x50, register_count: 3}
"""


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    (tmp_path / "specs").mkdir()
    return CommandLine(capsys, monkeypatch, tmp_path / "specs")


def import_text(run: CommandLine, text: str) -> str:
    """The report of an import that succeeds, and whose spec passes the check."""
    ran = run("import", "-", "--to", str(run.folder / "meter" / "device.yaml"), stdin=text.encode())
    assert (ran.code, ran.err) == (0, "")
    assert run("check", "meter").code == 0
    return ran.out


Reading: TypeAlias = Callable[[str, dict[int, int]], Fraction]
"""What a register says, or some bits of it, from the words at addresses, in its unit."""


@pytest.fixture(scope="module")
def inverter(tmp_path_factory: pytest.TempPathFactory) -> Reading:
    return reading(of_file(tmp_path_factory.mktemp("inverter"), DEFINITION))


@pytest.fixture(scope="module")
def meter(tmp_path_factory: pytest.TempPathFactory) -> Reading:
    return reading(of_file(tmp_path_factory.mktemp("meter"), CONFIGURATION))


def of_file(folder: Path, text: str) -> DeviceLayout:
    """The device that is imported of a file."""
    file, specs = folder / "list.yaml", folder / "specs"
    specs.mkdir()
    file.write_text(text, "utf-8")
    assert main(["import", str(file), "--to", str(specs / "meter" / "device.yaml"), "--specs", str(specs)]) == 0
    return newest(specs, "meter")


def reading(layout: DeviceLayout) -> Reading:
    registers = {own.register.name: own for own in layout.registers}

    def quantity(name: str, words: dict[int, int]) -> Fraction:
        register = registers.get(name)
        if register is None:
            return bits(layout, name, words)
        data = b"".join(words[register.address + n].to_bytes(2, "big") for n in range(register.words))
        raw = number_of(register.register.value, data, register.order, register.swapped)
        return in_unit(register.register.value, raw)

    return quantity


def bits(layout: DeviceLayout, name: str, words: dict[int, int]) -> Fraction:
    for register in layout.registers:
        flags = layout.device.flags.get(register.register.value.flags)
        for bit in flags.bits if flags is not None else ():
            if bit.name == name:
                raw = words[register.register.address] >> bit.first & ((1 << (bit.last - bit.first + 1)) - 1)
                return in_unit(bit.as_value, raw)
    raise KeyError(name)


def in_unit(value: Any, raw: Any) -> Fraction:
    return Fraction(raw) * Fraction(value.scale) + Fraction(value.offset)


def of_solarman(item: dict[str, Any], words: dict[int, int]) -> Fraction:
    """A quantity as the program computes it."""
    count = sum(words[register] << 16 * place for place, register in enumerate(item["registers"]))
    size = 16 * len(item["registers"])
    if item["rule"] in (2, 4) and count >> (size - 1):
        count -= 1 << size
    if "mask" in item:
        mask = item["mask"]
        count = (count & mask) // (mask & -mask)
    if "bit" in item:
        count = count >> item["bit"] & 1
    return (count - Fraction(item.get("offset", 0))) * Fraction(str(item.get("scale", 1)))


WORDS = st.lists(st.integers(0, 0xFFFF), min_size=0x120, max_size=0x120).map(lambda words: dict(enumerate(words)))


@given(words=WORDS)
def test_a_definition_reads_what_the_program_reads(inverter: Reading, words: dict[int, int]) -> None:
    items = yaml.safe_load(DEFINITION)["parameters"][0]["items"]
    numbers = {item["name"]: item for item in items if item["rule"] < 5}
    assert len(numbers) == 9
    for name, item in numbers.items():
        snake = name.lower().replace(" ", "_")
        assert inverter(snake, words) == of_solarman(item, words), name


def test_texts_values_and_bits_of_a_definition_have_their_names(run: CommandLine) -> None:
    import_text(run, DEFINITION)
    layout = newest(run.folder, "meter")
    device, by_name = layout.device, {own.register.name: own.register for own in layout.registers}
    assert (by_name["serial"].value.type.name, by_name["serial"].width) == ("text", 3)
    members = device.enums[by_name["running_status"].value.enum].members
    assert [(member.value, member.printed_name or member.name) for member in members] == [
        (0, "Stand-by"),
        (2, "Normal"),
        (4, "FAULT"),
    ]
    alarms = device.flags[by_name["alarms"].value.flags].bits
    assert [(bit.first, bit.name) for bit in alarms] == [(0, "over_voltage"), (3, "fan")]
    assert by_name["current"].space == "input_registers"
    ranges = by_name["current"].value.ranges
    assert (ranges.low, ranges.high) == (-10000, 10000)


def test_what_a_definition_has_beside_registers_is_named(run: CommandLine) -> None:
    report = import_text(run, DEFINITION)
    refused = dict(re.findall(r"^not used: row (\d+), \w+ `.*?`: (.*)$", report, re.MULTILINE))
    lines = DEFINITION.splitlines()
    expected = {
        "Version": "is a version in nibbles, which a register does not have as a type",
        "Split": "has registers that are not consecutive",
        "Sum": "has no registers: it is computed from other items",
    }
    by_line = {
        next(str(n) for n, line in enumerate(lines, 1) if f'"{name}"' in line): text for name, text in expected.items()
    }
    assert refused == by_line
    assert "columns not used: class, state_class, icon, sensors" in report
    text = (run.folder / "meter" / "device.yaml").read_text("utf-8")
    assert "Validation in the list: min 0.1." in text
    assert "Mask in the list: 0x8001." in text


@given(words=WORDS)
def test_a_configuration_reads_what_the_program_reads(meter: Reading, words: dict[int, int]) -> None:
    def data(address: int, count: int) -> bytes:
        return b"".join(words[address + n].to_bytes(2, "big") for n in range(count))

    low, high = data(0x20, 1), data(0x21, 1)
    assert meter("voltage", words) == Fraction(words[0x10], 10)
    assert meter("power", words) == Fraction(struct.unpack(">i", high + low)[0], 2) - 40
    assert meter("energy", words) == struct.unpack(">Q", data(0x24, 4))[0]
    assert meter("offset", words) == words[0x32]
    assert meter("limit", words) == Fraction(struct.unpack(">h", data(0x11, 1))[0], 100)
    assert meter("door", words) == words[0x12] >> 7 & 1


def test_a_real_number_of_a_configuration_is_one(meter: Reading) -> None:
    words = dict(zip((0x22, 0x23), struct.unpack(">2H", struct.pack(">f", 49.5)), strict=True))
    assert meter("frequency", words) == Decimal("49.5")


def test_entities_of_a_configuration_have_their_spaces_accesses_and_values(run: CommandLine) -> None:
    import_text(run, CONFIGURATION)
    layout = newest(run.folder, "meter")
    device, by_name = layout.device, {own.register.name: own.register for own in layout.registers}
    places = {name: (own.space or "registers", own.address, own.access) for name, own in by_name.items()}
    assert places["voltage"] == ("registers", 0x10, "rw")
    assert places["input"] == ("discrete_inputs", 3, "ro")
    assert places["pump"] == ("coils", 0x15, "rw")
    assert places["mode"] == ("registers", 0x13, "rw")
    members = device.enums[by_name["mode"].value.enum].members
    assert [(member.value, member.printed_name or member.name) for member in members] == [
        (0, "Off"),
        (1, "Heat"),
        (5, "Cool"),
    ]
    ranges = by_name["limit"].value.ranges
    assert (ranges.low, ranges.high) == (-500, 500)
    assert (by_name["label"].value.type.name, by_name["label"].width) == ("text", 3)


def test_what_a_configuration_has_beside_registers_is_named(run: CommandLine) -> None:
    report = import_text(run, CONFIGURATION)
    lines = CONFIGURATION.splitlines()
    refused = dict(re.findall(r"^not used: row (\d+)(?:, \w+ `.*?`)?: (.*)$", report, re.MULTILINE))
    # The line of an entity is that of its first key.
    second = lines.index("    name: Set voltage")
    first = lines.index("    name: Voltage")
    nothing = next(n for n, line in enumerate(lines, 1) if "Nothing" in line)
    assert refused == {
        str(second): f"is what the object in line {first} is; together they say the access",
        str(nothing): "is not stated",
    }
    assert "lambda in the list: return x / 10.0;." in (run.folder / "meter" / "device.yaml").read_text("utf-8")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("parameters:\n - group: a\n   items: [&a [*a]]\n", "is not YAML in line 3"),
        ("parameters:\n - group: a\n   items: [{name: b\n", "is not YAML in line"),
        ("parameters:\n\t- group: a\n", "is not YAML in line 2"),
        ("parameters:\n - group: a\n   items: [1, 2]\n", "has no object that can be taken: row 1: is not an item"),
        ("parameters:\n - group: a\n   items: []\n", "has no object that can be a row of a list"),
        (
            "parameters:\n - {group: a, items: [{name: b, rule: 1, registers: [99999999999]}]}\n",
            "cannot be read as decimal",
        ),
        ("parameters: " + "[" * 3000, "is not YAML in line 1"),
        ("sensors:\n  speed: [fast, slow]\n", "is YAML of no program that is known but not a list of objects"),
    ],
)
def test_damaged_yaml_is_one_clean_error(run: CommandLine, text: str, reason: str) -> None:
    ran = run("import", "-", "--to", str(run.folder / "meter" / "device.yaml"), stdin=text.encode())
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert reason in ran.err


def test_an_option_that_says_what_a_definition_says_itself_is_refused(run: CommandLine) -> None:
    ran = run("import", "-", "--to", "meter.yaml", "--base", "hex", stdin=DEFINITION.encode())
    assert (ran.code, ran.err) == (2, "fieldspec: - says that itself, so --base has no effect; leave it out\n")
