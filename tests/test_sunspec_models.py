"""Models of SunSpec in JSON become devices whose registers have what pysunspec2 reads of the same model.

The models are the public ones that pysunspec2 brings along.
"""

from __future__ import annotations

import json
import random
import re
from pathlib import Path
from typing import Any

import pytest
import sunspec2
from sunspec2.device import Model

from command_line import CommandLine
from fieldspec.codec.explain.values import number_of
from layouts import newest

FOLDER = Path(sunspec2.__file__).parent / "models" / "json"
GROUPLESS = (1, 103, 113, 121, 203, 305)
WHOLE = ("u", "i")


def text_of(number: int) -> str:
    return (FOLDER / f"model_{number}.json").read_text("utf-8")


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    (tmp_path / "specs").mkdir()
    return CommandLine(capsys, monkeypatch, tmp_path / "specs")


def import_text(run: CommandLine, text: str, *options: str) -> str:
    """The report of an import that succeeds, and whose spec passes the check."""
    ran = run("import", "-", "--to", str(run.folder / "meter" / "device.yaml"), *options, stdin=text.encode())
    assert (ran.code, ran.err) == (0, "")
    assert run("check", "meter").code == 0
    return ran.out


def model_of(number: int, data: bytes) -> Any:
    """The model as the library reads it, with data after its number and its length."""
    head = number.to_bytes(2, "big") + (len(data) // 2).to_bytes(2, "big")
    return Model(model_id=number, model_len=len(data) // 2, data=head + data)


@pytest.mark.parametrize("number", GROUPLESS)
def test_points_are_those_of_the_library(number: int, run: CommandLine) -> None:
    report = import_text(run, text_of(number))
    assert "not used: row" not in report
    size = sum(point["size"] for point in json.loads(text_of(number))["group"]["points"]) * 2
    data = random.Random(number).randbytes(size - 4)
    data = data.translate(bytes(byte & 0x7F for byte in range(256)))  # texts are of ASCII, and no number is absent
    model = model_of(number, data)
    whole = number.to_bytes(2, "big") + ((size - 4) // 2).to_bytes(2, "big") + data
    layout = newest(run.folder, "meter")
    registers = {own.address: own for own in layout.registers}
    assert registers.keys() == {point.offset for point in model.points.values()}
    for name, point in model.points.items():
        register = registers[point.offset]
        assert name in (register.register.printed_name, register.register.label)
        assert register.words == point.len, name
        assert register.register.access == {"RW": "rw"}.get(point.pdef.get("access", ""), "ro"), name
        value = register.register.value
        if value.type.name[0] in WHOLE:
            part = whole[point.offset * 2 : (point.offset + point.len) * 2]
            assert number_of(value, part, register.order, register.swapped) == point.value, name
        if isinstance(point.sf, str):
            exponent = next(own for own in layout.registers if own.register.name == value.scale_by)
            assert point.sf in (exponent.register.printed_name, exponent.register.label)


def test_a_group_that_repeats_is_a_table_with_its_first_element(run: CommandLine) -> None:
    report = import_text(run, text_of(160), "--offset", "-40069")
    model = model_of(160, bytes(8 * 2 + 2 * 20 * 2))
    table = newest(run.folder, "meter").tables["module"]
    first, second = model.groups["module"]
    assert table.table.base == 40069 + first.points["ID"].offset
    assert table.table.stride == second.points["ID"].offset - first.points["ID"].offset
    offsets = {field.field.printed_name or field.name: field.offset for field in table.record.fields}
    assert offsets == {name: (point.offset - first.points["ID"].offset) * 2 for name, point in first.points.items()}
    assert "assumed: repeats: module once (the model has it as often as the length of the model says)" in report


def test_points_behind_a_group_whose_number_is_open_are_named(run: CommandLine) -> None:
    model = {
        "id": 64999,
        "group": {
            "name": "made_up",
            "type": "group",
            "points": [
                {"name": "ID", "size": 1, "type": "uint16", "value": 64999},
                {"name": "N", "size": 1, "type": "count"},
            ],
            "groups": [
                {"name": "a", "count": "N", "points": [{"name": "X", "size": 1, "type": "int16"}]},
                {"name": "b", "count": 2, "points": [{"name": "Y", "size": 1, "type": "int16"}]},
            ],
        },
    }
    report = import_text(run, json.dumps(model))
    assert re.findall(r"^not used: row (\d+): (.*)$", report, re.MULTILINE) == [
        ("4", "follows a, which repeats as often as the device has it")
    ]


def test_names_of_values_and_of_points_that_are_alike_refuse_none(run: CommandLine) -> None:
    symbols = [{"name": name, "value": value} for value, name in enumerate(("VA_MAX_PCT", "VAR_MAX_PCT"))]
    points = [
        {"name": "Mode", "size": 1, "type": "enum16", "symbols": symbols},
        {"name": "Ramp", "size": 1, "type": "uint16", "units": " % WMax"},
    ]
    report = import_text(run, json.dumps({"id": 1, "group": {"name": "g", "type": "group", "points": points}}))
    assert "rows: 2 of 2 used (100 %)" in report


def test_values_bits_and_exponents_of_a_model_have_their_names(run: CommandLine) -> None:
    import_text(run, text_of(103))
    layout = newest(run.folder, "meter")
    registers = {own.register.printed_name: own.register for own in layout.registers}
    points = {point["name"]: point for point in json.loads(text_of(103))["group"]["points"]}
    members = layout.device.enums[registers["St"].value.enum].members
    assert [(member.value, member.printed_name or member.name) for member in members] == [
        (symbol["value"], symbol["name"]) for symbol in points["St"]["symbols"]
    ]
    bits = layout.device.flags[registers["Evt1"].value.flags].bits
    assert [(bit.first, bit.printed_name or bit.name) for bit in bits] == [
        (symbol["value"], symbol["name"]) for symbol in points["Evt1"]["symbols"]
    ]
    assert registers["ID"].value.const == 103
    absent = {own.name: own.value for own in registers["A_SF"].value.sentinels}
    assert (registers["A_SF"].value.ranges.low, absent) == (-10, {"not_implemented": -32768})


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ('{"group": {"points": [{"name": "a"}]}}', "has a point a whose size is not a number of registers"),
        ('{"group": {"points": [1]}}', "has a point that is not an object"),
        (
            '{"group": {"points": [{"name": "a", "size": 1, "type": "int7"}]}}',
            "has the type int7, which is not a SunSpec type",
        ),
        ('{"group": {"points": []}}', "has no object that can be a row of a list"),
        ('{"group": {"points": [{"name": "a", "size": 99999999, "type": "int16"}]}}', "is not a number of registers"),
        ('{"group": ' + '{"points": [], "groups": [' * 40, "is JSON that is nested more than 16 levels deep"),
        ('{"group": {"points": [', "begins like JSON but is not JSON"),
    ],
)
def test_a_damaged_model_is_one_clean_error(text: str, reason: str, run: CommandLine) -> None:
    ran = run("import", "-", "--to", str(run.folder / "meter" / "device.yaml"), stdin=text.encode())
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
    assert reason in ran.err
