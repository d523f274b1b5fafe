"""What an import says of a list: what was used, what was not, and what was assumed."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from command_line import CommandLine


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> CommandLine:
    (tmp_path / "specs").mkdir()
    return CommandLine(capsys, monkeypatch, tmp_path / "specs")


PARTLY = "Address,Name,Type,Colour\n10,speed,U16,red\ntbd,torque,U16,blue\n"
WHOLE = "Address,Name,Type\n0x10,speed,U16\n0x11,torque,I16\n"


def test_a_strict_import_refuses_what_is_not_used(run: CommandLine) -> None:
    path = run.folder / "lifter" / "device.yaml"
    ran = run("import", "-", "--to", str(path), "--strict", stdin=PARTLY.encode())
    assert (ran.code, ran.out) == (2, "")
    assert "row 3, Address `tbd`: is not an address; columns not used: Colour" in ran.err
    assert not path.parent.exists()
    assert run("import", "-", "--to", str(path), "--strict", stdin=WHOLE.encode()).code == 0


def test_what_was_taken_is_said_on_the_other_stream_where_the_spec_is_printed(run: CommandLine) -> None:
    ran = run("import", "-", "--to", "-", "--preview", "1", stdin=PARTLY.encode())
    assert yaml.safe_load(ran.out)["device"]["id"] == "device"
    assert ran.err.splitlines() == [
        "standard output: 1 register, addresses read as decimal",
        "columns used: address, name, type",
        "columns not used: Colour",
        "rows: 1 of 2 used (50 %)",
        "not used: row 3, Address `tbd`: is not an address",
        "assumed: addresses: decimal (digits without a mark; --base hex decides)",
        "assumed: address space: registers (the list does not say it; --space decides)",
        "row 2: speed: registers 0x000A, u16, 1 words",
    ]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--column", "colour=D"), "colour"),
        (("--column", "scale"), "--column scale names no column; write scale=HEADING, a letter or a number"),
        (("--protocol", "pigeon"), "pigeon"),
    ],
)
def test_an_option_that_names_nothing_is_wrong_use(options: tuple[str, ...], message: str, run: CommandLine) -> None:
    ran = run("import", "-", "--to", "-", *options, stdin=WHOLE.encode())
    assert (ran.code, ran.out) == (2, "")
    assert message in ran.err


SPACES = "Addr,FC,Name,Type,Order\n0,4,heat,INT16,\n0,3/6,setpoint,U32,CDAB\n0,1/5,run,BOOL,\n0,2,door,BOOL,\n"


def test_an_imported_device_builds_and_has_frames(run: CommandLine, tmp_path: Path) -> None:
    path = run.folder / "lifter" / "device.yaml"
    assert run("import", "-", "--to", str(path), stdin=SPACES.encode()).code == 0
    assert run("build", "lifter", "--out", str(tmp_path / "out"), "--to", "python,c,vectors").code == 0
    ran = run(
        "encode", "lifter", "read_input_registers", "address=0", "word_count=1", "--link", "rtu", "--format", "hex"
    )
    assert ran.code == 2  # the unit address is the user's
    assert "station" in ran.err


def test_an_import_without_a_protocol_says_that_it_has_no_frames(run: CommandLine) -> None:
    ran = run("import", "-", "--to", "-", "--protocol", "none", stdin=WHOLE.encode())
    assert ran.code == 0
    assert "uses:" not in ran.out
    assert "# The list has no frames: add `uses` or `links`, as `fieldspec new device` shows.\n" in ran.out
