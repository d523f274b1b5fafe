"""Databases of CAN messages become devices whose codec decodes what the library cantools encodes."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any, TypeAlias

import cantools
import pytest
from hypothesis import given
from hypothesis import strategies as st

from command_line import CommandLine
from fieldspec.cli import main
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.frames import codec
from layouts import newest

DATABASE = """\
VERSION ""
NS_ :
BS_:
BU_: Drive Host

BO_ 256 Motion: 8 Drive
 SG_ Speed : 0|16@1- (0.25,0) [0|0] "rpm" Host
 SG_ Temperature : 16|10@1+ (0.5,-40) [-40|400] "degC" Host
 SG_ Enabled : 26|1@1+ (1,0) [0|1] "" Host
 SG_ Mode : 27|3@1+ (1,0) [0|7] "" Host
 SG_ Position : 32|32@1- (0.001,0) [0|0] "mm" Host

BO_ 2566844672 Brake: 7 Drive
 SG_ Pressure : 7|5@0+ (1,0) [0|31] "bar" Host
 SG_ Force : 2|13@0- (0.1,0) [0|0] "N" Host
 SG_ Wear : 31|16@0+ (1,0) [0|65535] "" Host

BO_ 257 Target: 6 Host
 SG_ Setpoint : 7|24@0- (1,0) [0|0] "" Drive
 SG_ Gain : 24|16@1+ (1,0) [0|0] "" Drive

BO_ 258 Real: 8 Drive
 SG_ Torque : 0|32@1- (1,0) [0|0] "Nm" Host
 SG_ Small : 39|32@0- (2,0) [0|0] "" Host

BO_ 259 Selected: 4 Drive
 SG_ Page M : 0|8@1+ (1,0) [0|0] "" Host
 SG_ Current m0 : 8|16@1+ (1,0) [0|0] "A" Host
 SG_ Voltage m1 : 8|16@1+ (1,0) [0|0] "V" Host
 SG_ Always : 24|8@1+ (1,0) [0|0] "" Host

BO_ 260 Mixed: 4 Drive
 SG_ Left : 4|8@1+ (1,0) [0|0] "" Host
 SG_ Right : 3|8@0+ (1,0) [0|0] "" Host
 SG_ Rest : 24|8@1+ (1,0) [0|0] "" Host

BO_ 261 Overlapping: 2 Drive
 SG_ First : 0|8@1+ (1,0) [0|0] "" Host
 SG_ Second : 4|8@1+ (1,0) [0|0] "" Host

BO_ 262 Elsewhere: 1 Host
 SG_ Other : 0|8@1+ (1,0) [0|0] "" Nobody

BO_ 263 Empty: 0 Drive

CM_ BO_ 256 "Where the axis is.";
CM_ SG_ 256 Speed "Speed of the shaft.";
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 10000;
BA_DEF_ SG_ "Kind" STRING ;
BA_DEF_DEF_ "GenMsgCycleTime" 0;
BA_DEF_DEF_ "Kind" "";
BA_ "GenMsgCycleTime" BO_ 256 20;
BA_ "Kind" SG_ 256 Speed "fast";
VAL_ 256 Mode 0 "Off" 1 "On" 5 "Fault state" ;
VAL_ 256 Enabled 0 "No" 1 "Yes" ;
SIG_VALTYPE_ 258 Torque : 1;
SIG_VALTYPE_ 258 Small : 1;
"""
MESSAGES = cantools.database.load_string(DATABASE, "dbc", strict=False)
TAKEN = {"Motion": "response", "Brake": "response", "Target": "request", "Real": "response"}
REFUSED = {
    "Current": "is multiplexed: it is there where Page is 0",
    "Voltage": "is multiplexed: it is there where Page is 1",
    "Left": "shares bytes with signals in the other byte order",
    "Right": "shares bytes with signals in the other byte order",
    "Second": "overlaps First, which is taken",
    "Elsewhere": "is neither sent nor received by Drive",
    "Other": "belongs to a message that is not taken",
}


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    (tmp_path / "specs").mkdir()
    return CommandLine(capsys, monkeypatch, tmp_path / "specs")


def import_text(run: CommandLine, text: str, *options: str) -> str:
    """The report of an import that succeeds, and whose spec passes the check."""
    ran = run("import", "-", "--to", str(run.folder / "drive" / "device.yaml"), *options, stdin=text.encode())
    assert (ran.code, ran.err) == (0, "")
    assert run("check", "drive").code == 0
    return ran.out


Decoding: TypeAlias = Callable[[str, bytes], dict[str, Fraction]]
"""The signals of a message in their units, from its data."""


@pytest.fixture(scope="module")
def decoded(tmp_path_factory: pytest.TempPathFactory) -> Decoding:
    folder = tmp_path_factory.mktemp("drive")
    file, specs = folder / "drive.dbc", folder / "specs"
    specs.mkdir()
    file.write_text(DATABASE, "utf-8")
    assert main(["import", str(file), "--to", str(specs / "drive" / "device.yaml"), "--specs", str(specs)]) == 0
    layout = newest(specs, "drive")
    links = codec(layout).links
    return lambda name, data: signals(layout, links, name, data)


def signals(layout: DeviceLayout, links: dict[str, Any], name: str, data: bytes) -> dict[str, Fraction]:
    """What the reference decodes of a frame: fields, and the numbers in words, each in its unit."""
    message, direction = MESSAGES.get_message_by_name(name), TAKEN[name]
    link = "extended" if message.is_extended_frame else "standard"
    identifier = message.frame_id | (1 << 31 if message.is_extended_frame else 0)
    frame = identifier.to_bytes(4, "big") + bytes([len(data), 0, 0, 0]) + data
    values = links[link].decode(frame, direction).values
    result = {}
    for field in getattr(layout.device.messages[name.lower()], direction).fields:
        if field.reserved or field.value is None:
            continue
        if field.value.flags:
            for bit in layout.device.flags[field.value.flags].bits:
                count = values[field.name] >> bit.first & ((1 << (bit.last - bit.first + 1)) - 1)
                if bit.signed and count >> (bit.last - bit.first):
                    count -= 1 << (bit.last - bit.first + 1)
                result[bit.name] = in_unit(bit.as_value, count)
        else:
            result[field.name] = in_unit(field.value, values[field.name])
    return result


def in_unit(value: Any, count: Any) -> Fraction:
    return Fraction(count) * Fraction(value.scale) + Fraction(value.offset)


@pytest.mark.parametrize("name", [name for name in TAKEN if name != "Real"])
@given(data=st.binary(min_size=8, max_size=8))
def test_the_numbers_of_a_message_are_those_of_the_library(name: str, data: bytes, decoded: Decoding) -> None:
    message = MESSAGES.get_message_by_name(name)
    data = data[: message.length]
    counts = message.decode(data, scaling=False, decode_choices=False)
    own = decoded(name, data)
    assert own.keys() == {key.lower() for key in counts}
    for signal in message.signals:
        scale, offset = Fraction(str(signal.scale)), Fraction(str(signal.offset))
        assert own[signal.name.lower()] == int(counts[signal.name]) * scale + offset, signal.name


@given(numbers=st.tuples(st.floats(width=32, allow_nan=False, allow_infinity=False), st.integers(-1000, 1000)))
def test_real_numbers_are_those_of_the_library(numbers: tuple[float, int], decoded: Decoding) -> None:
    torque, small = numbers
    data = MESSAGES.get_message_by_name("Real").encode({"Torque": torque, "Small": small * 2}, strict=False)
    assert decoded("Real", bytes(data))["torque"] == Fraction(torque)


def test_what_is_not_taken_is_named_with_its_line(run: CommandLine) -> None:
    report = import_text(run, DATABASE)
    lines = DATABASE.splitlines()
    refused = dict(re.findall(r"^not used: row (\d+): (.*)$", report, re.MULTILINE))
    expected = {
        str(next(n for n, line in enumerate(lines, 1) if re.search(rf"_ (?:\d+ )?{name}\b", line))): reason
        for name, reason in REFUSED.items()
    }
    assert refused.keys() == expected.keys()
    assert {row: refused[row][: len(expected[row])] for row in refused} == expected
    assert "columns not used: Kind" in report
    assert "assumed: node: Drive (it sends 7 messages, more than any other node; --node decides)" in report


@pytest.mark.parametrize(
    ("database", "taken", "reason"),
    [
        ('BO_ 1 A: 2 B\n SG_ C : 0|8@1+ (1,0) [0|0] "" D\n SG_ E : 8|16@1+ (1,0) [0|0] "" D\n', "c", "does not fit"),
        ('BO_ 1 A: 2 B\n SG_ C : 0|8@1+ (1,0) [0|0] "" D\n SG_ 1E : 8|8@1+ (1,0) [0|0] "" D\n', "c", "`1E`: breaks"),
        (
            'BO_ 1 A: 2 B\n SG_ DI_FLOW_REQ : 0|8@1+ (1,0) [0|0] "" D\n SG_ F : 8|8@1+ (1,0) [0|0] "" D\n'
            'VAL_ 1 F 0 "DIS_FLOW_REQ" ;\nVAL_ 1 DI_FLOW_REQ 0 "DI_FLOW_REQS" ;\n',
            "di_flow_req",
            "",
        ),
    ],
)
def test_one_signal_refuses_no_others(database: str, taken: str, reason: str, run: CommandLine) -> None:
    report = import_text(run, f'VERSION ""\nBU_: B D\n\n{database}')
    assert re.findall(r"^not used: row \d+(?:, Name)?:? (.*)$", report, re.MULTILINE)[1:] == []
    assert reason in report
    assert ("not used: row" in report) is bool(reason)
    fields = newest(run.folder, "drive").device.messages["a"].response.fields
    assert taken in str(fields) + str(newest(run.folder, "drive").device.flags)


def test_names_of_numbers_of_a_quantity_are_noted(run: CommandLine) -> None:
    signals = ' SG_ C : 0|4@1+ (1,0) [0|0] "" D\n SG_ E : 4|4@1+ (0.5,0) [0|0] "V" D\n'
    report = import_text(run, f'VERSION ""\nBU_: B D\n\nBO_ 1 A: 1 B\n{signals}VAL_ 1 E 15 "SNA" ;\n')
    assert "rows: 3 of 3 used (100 %)" in report
    assert "Values in the list: 15 SNA." in (run.folder / "drive" / "device.yaml").read_text("utf-8")


def test_identifiers_of_more_than_11_bits_are_wide_without_their_mark(run: CommandLine) -> None:
    text = (
        'VERSION ""\nBU_: B D\n\nBO_ 441800714 A: 1 B\n SG_ C : 0|8@1+ (1,0) [0|0] "" D\nVAL_ 441800714 C 0 "Off" ;\n'
    )
    report = import_text(run, text)
    assert "assumed: identifiers: 29 bits" in report
    message = newest(run.folder, "drive").device.messages["a"]
    assert (message.code, message.links) == (441800714, ("extended",))


def test_values_units_bounds_and_comments_are_in_the_spec(run: CommandLine) -> None:
    import_text(run, DATABASE)
    device = newest(run.folder, "drive").device
    word = next(field.value for field in device.messages["motion"].response.fields if field.value and field.value.flags)
    bits = {bit.name: bit for bit in device.flags[word.flags].bits}
    members = [(member.value, member.printed_name or member.name) for member in device.enums[bits["mode"].enum].members]
    assert members == [(0, "Off"), (1, "On"), (5, "Fault state")]
    assert (bits["enabled"].zero, bits["enabled"].one) == ("No", "Yes")
    assert (bits["temperature"].unit, bits["temperature"].ranges.high) == ("°C", 880)
    text = (run.folder / "drive" / "device.yaml").read_text("utf-8")
    assert "Comment in the list: Speed of the shaft." in text
    assert "Cycle time in the list: 20 ms." in text


def test_another_node_has_the_messages_in_the_other_direction(run: CommandLine) -> None:
    import_text(run, DATABASE, "--node", "Host")
    messages = newest(run.folder, "drive").device.messages
    assert (messages["motion"].is_requested, messages["target"].is_requested) == (True, False)


def test_a_node_that_is_not_there_is_refused_with_those_that_are(run: CommandLine) -> None:
    ran = run("import", "-", "--to", "drive.yaml", "--node", "Car", stdin=DATABASE.encode())
    assert (ran.code, ran.err) == (2, "fieldspec: - has no node Car; choose from Drive, Host, Nobody\n")


def test_the_bytes_that_no_signal_is_in_have_no_meaning(run: CommandLine) -> None:
    import_text(run, DATABASE)
    fields = newest(run.folder, "drive").device.messages["brake"].response.fields
    assert [(field.name, field.reserved) for field in fields] == [
        ("word_0", False),
        ("wear", False),
        ("unused_5", True),
    ]


def test_without_the_library_the_refusal_names_the_extra(run: CommandLine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cantools", None)
    ran = run("import", "-", "--to", "drive.yaml", stdin=DATABASE.encode())
    assert (ran.code, ran.err.count("\n")) == (2, 1)
    assert "pip install 'fieldspec[lists]'" in ran.err


@pytest.mark.parametrize(
    "text",
    [
        'VERSION "',
        'VERSION ""\nBO_ 1 A: 8 B\n SG_ C : 0|0@1+ (1,0) [0|0] "" D\n',
        'VERSION ""\nBO_ 1 A: 8 B\n SG_ C : 0|65@1+ (1,0) [0|0] "" D\n',
        'VERSION ""\nBO_ 99999999999 A: 8 B\n SG_ C : 0|8@1+ (1,0) [0|0] "" D\n',
        'VERSION ""\nBO_ 1 A: 8 B\n SG_ C : 0|8@1+ (0,0) [0|0] "" D\n',
        'VERSION ""\nBO_ 1 A: 8 B\n SG_ C : 0|8@1+ (1e999,0) [0|0] "" D\n',
        'VERSION ""\nBO_ 1 A: 8 B\n' + "(" * 10000,
    ],
)
def test_a_damaged_database_is_one_clean_error(run: CommandLine, text: str) -> None:
    ran = run("import", "-", "--to", str(run.folder / "drive" / "device.yaml"), "--strict", stdin=text.encode())
    assert (ran.code, ran.out, ran.err.count("\n")) == (2, "", 1)
