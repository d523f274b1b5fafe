"""Wrong uses of verbs: one line that says what is wrong, exit code 2, and nothing that is silently left aside."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import read_devices_once
from fieldspec.cli import main
from layouts import TEST_SPECS

SPECS = str(Path(__file__).resolve().parent.parent / "specs")
WRITE = ["encode", "tc100", "write_registers", "station=1", "address=0x2014"]
LIVE = ["live", "tc100", "read", "alarm", "--port", "tcp://127.0.0.1:9"]
WATCH = ["live", "tc100", "watch", "alarm", "--port", "tcp://127.0.0.1:9"]


@pytest.fixture(autouse=True)
def devices_once(monkeypatch: pytest.MonkeyPatch) -> None:
    read_devices_once(monkeypatch)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ([*WRITE, "values=1,,3"], "values: `1,,3` has a comma without a value"),
        ([*WRITE, "values=,1"], "values: `,1` has a comma without a value"),
        ([*WRITE, "values=1,2,"], "values: `1,2,` has a comma without a value"),
        ([*WRITE, "values.0.x=1"], "values.0: one value is expected, and neither members nor a list"),
        (["encode", "tc100", "read_registers", "station.x=1"], "station: one value is expected"),
        (["encode", "tc100", "read_registers", "address=99999999999999999999999"], "has more than 64 bits"),
        (["encode", "tc100", "read_registers", "address="], "address: `` is not a number"),
        (["encode"], "the following arguments are required: DEVICE[@VERSION]; see: fieldspec encode --help"),
        (["show", "tc100", "alarm", "other"], "unrecognized arguments: other; see: fieldspec show --help"),
        (["show", ""], "there is no device without a name; choose from ck10, esc11, hiwin-e, tc100"),
        (["blame", "tc100", "motion_command"], "did you mean registers/motion_command? `fieldspec facts` lists"),
        (["blame", "tc100", "registers/motion_comand"], "did you mean registers/motion_command? `fieldspec facts`"),
        (["blame", "tc100", "nothing"], "tc100 has no fact nothing at 2.0; `fieldspec facts` lists all paths"),
        (["build", "--check", "--watch"], "use one of them"),
        (["shwo", "tc100"], "there is no command shwo; did you mean show?; see: fieldspec --help"),
        (["zzz"], "there is no command zzz; the nearest of 27 are "),
        (["show", "tc100@2.1"], "there is no version of tc100 2.1; did you mean 2.0?"),
        (["show", "tc100", "0x2F00"], "there is no item of tc100 at 0x2F00 (12032); the nearest are "),
        (["show", "tc100", "alrm"], "did you mean alarm?"),
        (["show", "tc100", "speed"], "did you mean jog_speed or "),
        (["show", "tc100", "201E"], "there is no item of tc100 201E; did you mean 0x201E?"),
        (["decode", "tc100", "zz"], "there are no bytes in it; write its bytes in hexadecimal, such as 01 03 10 00"),
        (["diff", "tc100@2.0", "nope"], "no git revision nope; write DEVICE@VERSION, a folder of specs, or a revision"),
        (["simulate", "tc100", "--websocket", "x"], "argument --websocket: x is not a whole number from 0 on"),
        (["audit", "tc100", "--evidence", SPECS], "has no unit.yaml; write one with model, firmware and serial_number"),
        (["show", "tc100", "qqq"], "there is no item of tc100 qqq; the nearest of "),
        (["live", "tc100", "raed"], "there is no command raed; did you mean read?; see: fieldspec live --help"),
        (["live", "tc100", "find", "alarm", "--port", "x"], "find takes no names; restrict it with --link"),
        (["live", "tc100", "find"], "say where to look: --port /dev/ttyUSB0"),
        (["live", "tc100", "find", "--link", "usb", "--port", "/dev/none"], "no link of tc100 reads over /dev/none"),
        (
            ["live", "tc100", "read", "--parity", "mark"],
            "there is no value of --parity mark; choose from even, none, odd",
        ),
        (["live", "tc100", "write", "motion_speed", "--dry-run"], "has no value; write motion_speed=VALUE"),
        (["live", "tc100", "write", "points[1].speed", "--dry-run"], "has no value; write points[1].speed=VALUE"),
        (["live", "tc100", "write", "points[1]=5", "--dry-run"], "write one of them, such as points[1].mode=5"),
        (["encode", "tc100", "write", "motion_sped=5"], "there is no register motion_sped; did you mean motion_speed?"),
        (["encode", "tc100", "write"], "name what to write, as in NAME=10.5mm; `fieldspec show tc100` lists the names"),
        (["encode", "tc100", "write", "alarm=1"], "can only be read"),
        (["encode", "tc100", "write", "motion_speed=500%"], "out_of_range"),
        (["encode", "tc100", "write", "station=x", "motion_speed=5%"], "is not a unit address; write a number"),
        (["encode", "tc100", "write", "motion_speed=5%", "--direction", "response"], "name the message to encode"),
        (["decode", "tc100", ""], "this is not a frame: it has no bytes"),
        (["decode", "tc100", "  "], "this is not a frame: it has no bytes"),
        (
            ["decode", "tc100", SPECS],
            f"it is a folder: decode the files in it with fieldspec decode tc100 {SPECS} --to",
        ),
        (["simulate", "tc100", "--control", "--view"], "use one of them"),
        (["simulate", "tc100", "--rate", "0"], "argument --rate: 0 is not more than 0"),
        (["simulate", "tc100", "--rate", "nan"], "argument --rate: nan is not a number"),
        (["simulate", "tc100", "--baud", "0"], "argument --baud: 0 is not a whole number from 1 on"),
        ([*LIVE, "--timeout", "0"], "argument --timeout: 0 is not more than 0"),
        ([*LIVE, "--timeout", "inf"], "argument --timeout: inf is not a number"),
        ([*LIVE, "--retries", "-1"], "argument --retries: -1 is not a whole number from 0 on"),
        ([*LIVE, "--pause", "-0.5"], "argument --pause: -0.5 is less than 0"),
        ([*WATCH, "--count", "0"], "argument --count: 0 is not a whole number from 1 on"),
        ([*WATCH, "--every", "x"], "argument --every: x is not a number"),
        ([*LIVE, "--table", "points"], "--table has no effect on read, only on points download, points"),
        ([*LIVE, "--every", "0.5"], "--every has no effect on read, only on watch"),
        ([*LIVE, "--every", "0"], "--every has no effect on read, only on watch"),
        ([*WATCH, "--dry-run"], "--dry-run has no effect on watch, only on write, points upload and restore"),
        (["live", "tc100", "points", "download", "x.csv", "--yes"], "--yes has no effect on points download"),
        (["live", "tc100", "backup", "x.csv", "--any-version"], "--any-version has no effect on backup"),
        (["live", "tc100", "write", "alarm=0", "--format", "json"], "--format has no effect on write"),
        (["live", "tc100", "read", "--port", "/dev/none"], "cannot open /dev/none: No such file or directory\n"),
        (["new", "version", "tc100", "9.9", "--protocol", "modbus"], "--protocol has no effect on a new version"),
        (["new", "device", "pump", "--protocol", "modbus", "--line", "x"], "--line has no effect on a new device"),
        (["check", "tc10"], "there is no device tc10; did you mean tc100?"),
        (["check", "tc100", "--format", "yaml"], "there is no value of --format yaml; choose from "),
        (["build", "--to", "pyhton"], "did you mean python?"),
        (["build", "--to", ""], "--to names no output; the outputs are python, c, js,"),
        (["diff", "tc100@2.0", "tc100@9.9"], "there is no version of tc100 9.9"),
        (["decode", "tc100", "01 03 10 00 00 01 80 C"], "this is not a frame: at byte 7, `C` is one digit of two"),
        (["decode", "tc100", "01 03", "--link", "usb"], "there is no link usb; "),
        (["decode", "tc100", "01 03", "--direction", "up"], "there is no direction up; "),
        (["decode", "tc100", "01 03", "--message", "read_register"], "did you mean read_registers?"),
        (["encode", "tc100", "read_registres", "station=1"], "did you mean read_registers?"),
        (["encode", "tc100", "read_registers", "station=1", "adress=5"], "did you mean address?"),
        (["encode", "tc100", "read_registers", "station"], "station is not of the form NAME=VALUE"),
        (["encode", "tc100", "read_registers", "station=1", "station=2"], "station has two values"),
        (["encode", "esc11", "move_relative", "address=0", "distance=20kg", "speed=50%"], "20kg"),
        (["encode", "esc11", "move_relative", "address=0", "distance=20mm", "speed=500"], "out_of_range"),
        (["encode", "hiwin-e", "telegram_999"], "there is no message telegram_999; did you mean "),
        (
            ["encode", "tc100", "write", "motion_command=hom"],
            "`hom` is not a member of motion_command; did you mean homing?",
        ),
        (
            ["encode", "tc100", "write", "motion_command=zzz"],
            "`zzz` is not a member of motion_command; it has relative_move, ",
        ),
        (["show", "tc100", "99999999"], "there is no item of tc100 "),
        (["facts", "tc100", "--format", "xlsx"], "there is no value of --format xlsx; choose from csv, json"),
        (["matrix", "tc10"], "did you mean tc100?"),
        (["versions", "tc10"], "did you mean tc100?"),
        (["export", "tc100", "--to", "out.pdf"], "pdf"),
        (["compare", "tc100", "missing.csv"], "missing.csv"),
        (["audit", "tc100", "--table", "ledgr"], "did you mean ledger?"),
        (["audit", "tc100", "--format", "csv"], "--table"),
        (["audit", "tc100", "--sign", "8.2"], "add a name or a role, such as --by"),
        (["audit", "tc100", "--manual", "missing.txt"], "missing.txt"),
        (["audit", "tc100", "--record"], "--record needs the text of the manual: --manual FILE --record"),
        (["audit", "tc100", "--baseline", "none.json"], "--baseline goes with --evidence FOLDER"),
        (["simulate", "tc100", "--port", "usb=pty"], "there is no link usb"),
        (["simulate", "tc100", "--baud", "1234"], "ascii has no --baud 1234; choose from 9600, 19200, "),
        (["simulate", "tc100", "--port", "rtu=pty", "--baud", "1234"], "rtu has no --baud 1234; choose from 9600, "),
        (["simulate", "esc11", "--data-bits", "5"], "has no --data-bits 5; choose from 8"),
        (["simulate", "tc100", "--unit", "500"], "unit address"),
        (["simulate", "tc100", "--fault", "no_answr=0.1"], "there is no fault `no_answr`; choose from no_answer, "),
        (["simulate", "tc100", "--fault", "no_answer=2"], "0 to 1"),
        (["simulate", "tc100", "--dump", "missing.csv"], "missing.csv"),
        (["live", "tc100"], "the following arguments are required: VERB; see: fieldspec live --help"),
        (["live", "tc100", "read", "alarm"], "say where the device is: --port /dev/ttyUSB0"),
        (["live", "tc100", "read", "alarm", "--port", "tcp://127.0.0.1"], "write it as tcp://HOST:PORT"),
        (
            ["live", "tc100", "read", "alarm", "--port", "http://127.0.0.1:9"],
            "http://127.0.0.1:9 is not a port; write one of ",
        ),
        ([*LIVE, "--unit", "999"], "the unit address 999 is not in "),
        ([*LIVE, "--link", "tpc"], "there is no link tpc"),
        (["scan", "tc100"], "--port"),
        (["new"], "required: {device,version,schema}"),
        (["new", "devcie", "x"], "did you mean device?"),
        (["new", "device", "x", "--protocol", "can_bus"], "there is no protocol can_bus; did you mean can?"),
        (
            ["new", "device", "x"],
            "or a kind of frame where there is none: packet, text, escapes, status, bytes, can, telegram",
        ),
        (["devices", "x"], "unrecognized arguments: x; see: fieldspec devices --help"),
        (["decode", "01 03 10 00"], "name the device before the frame: fieldspec decode DEVICE '01 03 10 00'"),
        (["decode", "tc100", "O1 03 10 00"], "`O1` is not a byte in hexadecimal digits"),
        (["decode", "tc100", "01 03 1O 00"], "`1O` is not a byte in hexadecimal digits"),
        (["decode", "tc100", "missing.log"], "if it is a path, there is no file missing.log"),
        (["decode", "TC100", "01 03"], "did you mean tc100?"),
        (["decode", "tc-100", "01 03"], "did you mean tc100?"),
        (["encode", "tc100", "motion_speed=50%"], "a register is written by its name: write NAME=VALUE"),
        (["encode", "esc11", "speed=50%"], "name the message; esc11 has 40 of them; `fieldspec show` lists them"),
        (["encode", "tc100", "read", "motion_speed"], "did you mean read_registers?"),
        (["encode", "tc100", "write", "motion_speed=fast"], "`fast` is not a number; give a count, or with its unit %"),
        (["encode", "tc100", "write", "motion_speed=50mm"], "`50mm` is not a number; give a count, or with its unit %"),
        (["encode", "tc100", "write", "motion_speed=-5%"], "out_of_range: motion_speed is -5, not in 0..100"),
        (["encode", "tc100", "write", "motion_speed", "50%"], "has no value; write motion_speed=VALUE"),
        (["encode", "tc100", "write", "points[300].speed=5%"], "points has the elements 1 to 127"),
        (["encode", "esc11", "move_relative", "station=1", "distance=2mm"], "there is no field station; choose from"),
        (["encode", "esc11", "move_relative", "distance=2mm", "speed=5%"], "address is not given"),
        (["live", "tc100", "read", "points[300]", "--port", "/dev/none"], "points has the elements 1 to 127"),
        (["live", "tc100", "read", "points[3].torque", "--port", "/dev/none"], "there is no register points[3].torque"),
        (["live", "tc100", "read", "alarm", "--port", f"{SPECS}/fieldspec.schema.json"], "it is a file, not a port"),
        (["live", "tc100", "read", "alarm", "--port", "tcp://127.0.0.1:99999"], "Port out of range 0-65535"),
        (["live", "tc100", "read", "alarm", "--port", "/dev/none", "--unit", "99"], "is not in 1..16"),
        (["live", "tc100", "home", "--port", "/dev/none"], "there is no command home; choose from backup, compare"),
        (["live", "tc100", "write", "servo=on", "--dry-run"], "it has servo_on, servo_off"),
        (["live", "tc100", "write", "target_position=10mm", "--dry-run"], "`10mm` is not a number; give a count"),
        (["live", "tc100", "restore", "--port", "/dev/none"], "name the file of a backup"),
        (["live", "tc100", "points", "--port", "/dev/none"], "`points download FILE` or `points upload FILE`"),
        (["live", "ck10@9", "read", "alarm", "--port", "/dev/none"], "there is no version of ck10 9; choose from 1"),
        (["simulate", "tc100", "--port", "ascii"], "--port ascii has no place; write --port ascii=pty"),
        (["simulate", "tc100", "--port", "rtu:pty"], "--port rtu:pty has no place; write --port rtu=pty"),
        (["simulate", "tc100", "--port", "tcp://127.0.0.1"], "write it as tcp://HOST:PORT"),
        (["simulate", "tc100", "--fault", "no_answer"], "write it as KIND=PROBABILITY, as in no_answer=0.01"),
        (["simulate", "tc100", "--faults", f"{SPECS}/tc100/device.yaml"], "this line is not JSON; write it as {"),
        (["simulate", "tc100", "--message", "5"], "tc100 exchanges nothing cyclically"),
        (["check", "tc100@2.0"], "check judges all versions of a device; write tc100, without @2.0"),
        (["check", "specs/tc100/enums.yaml"], "did you mean tc100?"),
        (["matrix", "tc100@2.0"], "the matrix shows all versions; leave out @2.0"),
        (["build", "--to", "C"], "there is no output C; did you mean c?"),
        (["build", "tc100", "esc12"], "did you mean esc11?"),
        (["diff", "tc100@2.0", "esc11@1.17"], "tc100 and esc11 are different devices"),
        (["diff", "tc100@2.0", "tc100@V1", "--fail-on", "all"], "choose from any, behaviour, breaking"),
        (["layout", "hiwin-e", "111", "--target", "S7"], "there is no target S7; did you mean s7?"),
        (["new", "version", "tc100", "2 1"], "use letters and digits, joined by single dots, hyphens or underscores"),
        (["new", "version", "tc100", "2.1", "--based-on", "9"], "there is no version of tc100 9; choose from 2.0"),
        (["new", "device", "My Pump", "--protocol", "modbus"], "use lower-case words joined by single hyphens or"),
        (["audit", "tc100", "--table", "sve"], "there is no table sve; did you mean save?"),
        (["audit", "tc100", "--out", "page.html"], "--out writes a page or a table; give --format html"),
        (["compare", "tc100", SPECS], "it is a folder, not a regular file"),
        (["docs", "--port", "99999"], "--port 99999 is not a port; use 0 to 65535"),
    ],
)
def test_a_wrong_use_is_one_line(
    arguments: list[str],
    expected: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([*arguments, "--specs", SPECS]) == 2
    output = capsys.readouterr()
    assert output.out == ""
    assert expected in output.err
    assert output.err.count("\n") == 1
    assert not list(tmp_path.iterdir())


MISSING = ("--port", "/dev/none")
"""A port that cannot be opened: whatever is judged without the device is judged before it."""


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (("read", "alrm"), "did you mean alarm?"),
        (("watch", "alrm"), "did you mean alarm?"),
        (("watch",), "name what to watch"),
        (("write", "alarm=1"), "can only be read"),
        (("write", "motion_sped=5%"), "did you mean motion_speed?"),
        (("write", "motion_speed=500%"), "out_of_range"),
        (("scan", "0x10..1"), "is not an address range"),
        (("dump",), "name one file to write"),
        (("dump", "file/dump.csv"), "cannot write file"),
        (("backup", "file/backup.csv"), "cannot write file"),
        (("points", "download", "file/points.csv"), "cannot write file"),
        (("points", "download", "points.pdf"), "points.pdf"),
        (("restore", "missing.csv"), "missing.csv"),
        (("points", "upload", "missing.csv"), "missing.csv"),
        (("compare", "missing.csv"), "missing.csv"),
        (("points", "download", "points.csv", "--table", "pionts"), "did you mean points?"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_live_judges_its_arguments_before_it_opens_the_port(
    arguments: tuple[str, ...],
    expected: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("file").touch()
    assert main(["live", "tc100", *arguments, *MISSING, "--specs", SPECS]) == 2
    output = capsys.readouterr().err
    assert (expected in output, output.count("\n")) == (True, 1), output


def test_a_scan_judges_its_ranges_before_it_opens_the_port(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["scan", "tc100", "0x10..1", *MISSING, "--specs", SPECS]) == 2
    assert "is not an address range" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "option"),
    [
        (["build"], "--out"),
        (["docs"], "--out"),
        (["export", "tc100"], "--out"),
        (["audit", "tc100"], "--out"),
        (["audit", "tc100"], "--manual"),
        (["audit", "tc100"], "--dump"),
        (["audit", "tc100"], "--captures"),
        (["audit", "tc100"], "--evidence"),
        (["decode", "tc100", "log.txt", "--to", "csv"], "--out"),
        (["redact", "tc100", "log.txt"], "--out"),
        (["simulate", "tc100"], "--dump"),
        (["simulate", "tc100"], "--record"),
        (["simulate", "tc100"], "--faults"),
        (["lsp"], "--manuals"),
        (["check"], "--specs"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, list) else value,
)
def test_an_empty_path_is_refused_by_the_name_of_its_option(
    arguments: list[str],
    option: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([*arguments, option, ""]) == 2
    assert capsys.readouterr().err.startswith(f"fieldspec: {option} is empty; name a ")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("values", ["1,2,3", "1, 2,3", "1 2 3", " 1 ,2 , 3 "])
def test_the_items_of_a_list_are_separated_by_commas_or_blanks(values: str, capsys: pytest.CaptureFixture[str]) -> None:
    command = ["encode", "tc100", "read_registers", "--direction", "response", "station=1", f"values={values}"]
    assert main([*command, "--link", "rtu", "--format", "hex", "--specs", SPECS]) == 0
    assert capsys.readouterr().out.startswith("01 03 06 00 01 00 02 00 03 ")


@pytest.mark.parametrize("name", ["1", "0001", "2"])
def test_a_number_that_may_be_an_address_or_a_printed_one_names_no_register(
    name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    command = ["live", "station", "write", f"{name}=1", "--port", "tcp://127.0.0.1:9", "--link", "tcp", "--dry-run"]
    assert main([*command, "--specs", str(TEST_SPECS)]) == 2
    number = int(name)
    expected = f"{name} may be the address 0x{number:04X} or the number that the manual prints for 0x{number - 1:04X}"
    assert expected in capsys.readouterr().err


def test_a_number_beyond_the_space_of_coils_is_no_number_of_a_coil(capsys: pytest.CaptureFixture[str]) -> None:
    command = ["live", "station", "write", "258=1", "--port", "tcp://127.0.0.1:9", "--link", "tcp", "--dry-run"]
    assert main([*command, "--specs", str(TEST_SPECS)]) == 2
    assert "there is no register 258;" in capsys.readouterr().err


def test_an_empty_table_of_the_audit_says_that_it_has_no_rows(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["audit", "tc100", "--table", "save", "--specs", SPECS]) == 0
    assert capsys.readouterr().err == "the table save has no rows\n"
