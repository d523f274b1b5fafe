"""What the pages about word-based controllers and operator panels say is true of what is built."""

from __future__ import annotations

import csv
import io
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from fieldspec.command.pipeline import layouts, load, outputs
from fieldspec.targets.kv.dialect import KV
from fieldspec.targets.kv.word_map import COLUMNS
from layouts import SPECS, newest

ROOT = Path(__file__).resolve().parent.parent
TEXT = "".join((ROOT / "docs" / name).read_text("utf-8") for name in ("plc-kv.md", "plc-panels.md"))


def section(title: str) -> str:
    """A section by its heading, with the sections below it."""
    level, _ = re.findall(rf"^(#+) ({re.escape(title)}.*)$", TEXT, re.MULTILINE)[0]
    after = re.split(rf"^{level} {re.escape(title)}.*$", TEXT, maxsplit=1, flags=re.MULTILINE)[1]
    return re.split(rf"^#{{1,{len(level)}}} ", after, maxsplit=1, flags=re.MULTILINE)[0]


def rows(text: str) -> list[list[str]]:
    """The rows of all tables in a text."""
    result = [line.strip("|").split(" | ") for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in row] for row in result if not set("".join(row)) <= set("-|")]


KV_TEXT = section("KEYENCE KV")
HMI_TEXT = section("Operator panels")
COMMANDS = [
    line
    for text in (KV_TEXT, HMI_TEXT)
    for block in re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
    for line in block.splitlines()
]


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the outputs of two devices."""
    folder = tmp_path_factory.mktemp("plc_docs")
    files = {path.relative_to(SPECS).as_posix(): path.read_bytes() for path in SPECS.rglob("*.yaml")}
    devices = [layouts(spec) for name, spec in load(files).devices.items() if name in ("esc11", "tc100")]
    for path, content in outputs(devices, ["kv", "hmi"]).items():
        place = folder / "generated" / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(content)
    (folder / "specs").symlink_to(SPECS)
    return folder


def ran(command: str, folder: Path) -> str:
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    result = subprocess.run(
        ["sh", "-e", "-c", command], cwd=folder, env={**os.environ, "PATH": path}, capture_output=True, encoding="utf-8"
    )
    assert (result.returncode, result.stderr) == (0, "")
    return result.stdout


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_runs(command: str, built: Path) -> None:
    out = ran(command, built)
    assert bool(out.strip()) == (">" not in command)


def words(built: Path) -> dict[str, dict[str, str]]:
    text = (built / "generated/kv/esc11_v1_17_words.csv").read_text("utf-8").lstrip("\ufeff")
    reader = csv.DictReader(io.StringIO(text, newline=""))
    return {row["device"]: row for row in reader if row["device"] and not row["type"].startswith("bit")}


def test_the_columns_of_the_word_map_are_those_that_are_described() -> None:
    described = [name for row in rows(section("The word map")) for name in re.findall(r"`(\w+)`", row[0])]
    assert sorted(described) == sorted(COLUMNS)


def test_the_words_of_the_example_are_the_frame_of_the_manual(built: Path) -> None:
    value = words(built)
    table = [row for row in rows(section("Example: the ESC11 grips, from")) if re.match("`DM", row[0])]
    assert [value[row[0].strip("`")]["name"] for row in table] == [row[2].split("`")[1] for row in table]
    frame = newest(SPECS, "esc11").device.examples["grip-close-request"].frame
    assert bytes(int(row[1]) for row in table) == frame
    assert sum(frame[:-1]) & 255 == frame[-1]
    for row in table:
        fixed = value[row[0].strip("`")]["fixed"]
        assert fixed in ("", row[1])


def test_the_words_of_the_response_are_where_the_example_says(built: Path) -> None:
    value = words(built)
    text = section("Example: the ESC11 grips, from")
    named = ["DM11140", "DM11141", "DM11142", "DM11143"]
    assert set(re.findall(r"DM1114[0-9]", text)) == set(named)
    assert [value[name]["name"] for name in named] == ["length", "address", "status", "checksum"]
    assert {value[name]["area"] for name in named} == {"grip_close response"}
    assert value["DM11140"]["fixed"] == "4"
    flags = newest(SPECS, "esc11").device.flags["communication_status"]
    assert [(bit.first, bit.name) for bit in flags.bits if bit.first in (0, 5, 6)] == [
        (0, "executing"),
        (5, "command_error"),
        (6, "alarm"),
    ]


def test_the_command_prints_the_words_of_the_example(built: Path) -> None:
    (command,) = (line for line in COMMANDS if line.startswith("fieldspec encode"))
    table = [row for row in rows(section("Example: the ESC11 grips, from")) if re.match("`DM", row[0])]
    assert bytes.fromhex(ran(command, built)) == bytes(int(row[1]) for row in table)


def test_moved_comments_are_the_same_comments_elsewhere(built: Path) -> None:
    moves = [line for line in COMMANDS if line.startswith("awk")]
    for line in moves:
        ran(line, built)
    original = list(csv.reader((built / "generated/kv/esc11_v1_17_comments.csv").open(encoding="ascii", newline="")))
    moved = list(csv.reader((built / "comments_15000.csv").open(encoding="ascii", newline="")))
    extended = list(csv.reader((built / "comments_em.csv").open(encoding="ascii", newline="")))
    assert [(f"DM{int(device[2:]) + 5000}", text) for device, text in original] == [tuple(row) for row in moved]
    assert [(f"EM{device[2:]}", text) for device, text in original] == [tuple(row) for row in extended]
    assert (built / "comments_15000.csv").read_bytes().endswith(b"\r\n")


def test_the_documented_base_and_width_are_those_of_the_dialect() -> None:
    assert f"begin at **{KV.device(KV.base)}**" in KV_TEXT
    assert f"at most {KV.width} characters" in KV_TEXT
    assert KV.step == 10
    assert KV.low_word_first


def test_files_that_are_named_are_built(built: Path) -> None:
    result = {path.relative_to(built).as_posix() for path in (built / "generated").rglob("*.*")}
    endings = [
        *re.findall(r"`[\w/]*(?:DEVICE_VERSION|\.\.\.)(_\w+\.\w+)`", KV_TEXT + HMI_TEXT),
        "_tia_panel_en_us_zh_tw.xlsx",
    ]
    assert len(endings) > 6
    for ending in endings:
        assert any(path.endswith(ending) for path in result), ending


def test_the_register_on_the_panel_holds_the_codes_of_the_list() -> None:
    layout = newest(SPECS, "tc100")
    (address,) = re.findall(r"of the TC100, register (0x[0-9A-F]+)", HMI_TEXT)
    (register,) = (register for register in layout.device.registers() if register.address == int(address, 16))
    assert register.value.enum == "alarm_code"
    assert "`tc100_alarm_code`" in HMI_TEXT
