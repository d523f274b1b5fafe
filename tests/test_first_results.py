"""Each way in of the README, as a newcomer types it in a fresh copy of the repository, ends in its result.

The other tests of the pages run their blocks; these follow what the commands print, also where a device or a manual is
not as the page has it.
"""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from bounded import HANGING
from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.testing import simulation
from test_add_a_device import RIGHT, WRONG, code_blocks, files

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
FOLDERS = ("specs", "generated/c", "generated/js", "fieldspec.yaml")


@pytest.fixture
def clone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the files that a clone has, of those that the ways in need."""
    command = [require_tool("git"), "ls-files", "-z", *FOLDERS]
    listing = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout
    for name in filter(None, listing.split("\0")):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    monkeypatch.chdir(tmp_path)
    return tmp_path


class Newcomer:
    """Types commands and reads what they print."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self.capsys = capsys

    def types(self, line: str, code: int = 0) -> str:
        """The output of a command that ends with a code."""
        self.capsys.readouterr()
        assert main(shlex.split(line)[1:]) == code, line
        return "".join(self.capsys.readouterr())

    def follows(self, advice: str, printed: str) -> str:
        """The output of the command that a line of another command's output proposes."""
        (line,) = re.findall(rf"^{advice}: (fieldspec .*)$", printed, re.MULTILINE)
        return self.types(line)


@pytest.fixture
def newcomer(capsys: pytest.CaptureFixture[str]) -> Newcomer:
    return Newcomer(capsys)


def saved_programs(page: str, folder: Path) -> Iterator[list[str]]:
    """The commands of a page, with its named programs in a folder."""
    text = (DOCS / page).read_text("utf-8")
    for name, program in re.findall(r"^`([\w.]+)`\n\n```\w+\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        (folder / name).write_text(program, "utf-8")
    for block in re.findall(r"^```console\n(.*?)^```$", text, re.DOTALL | re.MULTILINE):
        yield block.splitlines()


def test_the_programs_of_a_programmer_print_the_frame_that_the_page_shows(clone: Path) -> None:
    for lines in saved_programs("program.md", clone):
        commands = [shlex.split(line.removeprefix("$ ")) for line in lines if line.startswith("$ ")]
        printed = ""
        for program, *words in commands:
            command = [program if program.startswith("./") else require_tool(program), *words]
            command += ["--offline", "--no-audit"] if program == "npm" else []
            result = subprocess.run(command, cwd=clone, capture_output=True, text=True, timeout=HANGING, check=True)
            printed = result.stdout
        assert printed.strip() == lines[-1]


def test_a_client_reaches_a_device_that_is_not_as_delivered() -> None:
    from fieldspec_devices import transports
    from fieldspec_devices.tc100 import client

    with simulation("tc100", ports={"rtu": "tcp://127.0.0.1:0"}, unit_address=3, folder=str(ROOT / "specs")) as device:
        host, _, port = device.place.removeprefix("tcp://").rpartition(":")
        with transports.tcp(host, int(port)) as transport:
            assert client.Client(transport, link="rtu", unit_address=3).read_alarm() == 0


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo-terminals of this kind")
def test_a_device_that_is_not_as_delivered_is_found_by_following_what_is_printed(
    clone: Path, newcomer: Newcomer
) -> None:
    with simulation("tc100", ports={"rtu": "pty"}, unit_address=2) as device:
        printed = newcomer.types(f"fieldspec live tc100 read alarm --port {device.place} --timeout 0.1", 1)
        assert "no answer from unit 1 on ascii" in printed
        search = re.findall(r"^try all settings: (.*)$", printed, re.MULTILINE)[0]
        printed = newcomer.follows("use it", newcomer.types(f"{search} --timeout 0.1"))
    assert re.search(r"^alarm +0x1005 +0 +no_alarm$", printed, re.MULTILINE)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo-terminals of this kind")
def test_an_engineer_sets_a_new_device_to_the_link_of_the_program(clone: Path, newcomer: Newcomer) -> None:
    page = (DOCS / "plc-codesys.md").read_text("utf-8")
    (line,) = re.findall(r"`(fieldspec live tc100 [^`]*protocol=modbus_rtu)`", page)
    with simulation("tc100") as device:
        assert "protocol: 1 modbus_rtu" in newcomer.types(f"{line.replace('COM3', device.place)} --yes")


def test_an_engineer_gets_the_files_that_the_page_names(clone: Path, newcomer: Newcomer) -> None:
    newcomer.types("fieldspec build tc100 --to plcopen,st,iec")
    names = re.findall(r"`((?:plcopen|st|iec)/tc100\w+\.\w+)`", (DOCS / "plc.md").read_text("utf-8"))
    assert len(names) == 5
    assert [name for name in names if not (clone / "generated" / name).exists()] == []


VERSIONS = """\
versions:
  - {line: firmware, builds: true, members: [{id: "3", inferred: The manual names no firmware; its edition is 3.}]}
"""
OVERLAY = """\
overlay: {id: "4", line: firmware, based_on: "3", inferred: Edition 4 of the manual describes it.}
changes:
  - fact: registers/speed
    set: {range: {was: 1..100, is: 1..80}}
    reason: Line 10 of edition 4 prints 1 to 80 %.
adds:
  - in: registers/control
    item: {at: 0x0204, name: current, type: u16, checked: {words: 1}, access: ro, scale: 0.1, unit: A}
    reason: Line 12 of edition 4 prints it.
renames:
  - {fact: enums/mode/find_lower_end, to: reference, reason: Line 11 of edition 4 calls it so.}
"""
ACCEPTANCE = """\
accepts:
  - {rule: renamed, path: enums/mode/reference, reason: Programs are to use the new name., date: 2026-05-20}
"""


def test_a_changed_page_of_a_manual_becomes_a_version_that_ci_stops_until_it_is_accepted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, newcomer: Newcomer
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("specs/lifter").mkdir(parents=True)
    for name, text in files().items():
        Path(name).write_text(text.replace(WRONG, RIGHT), "utf-8")
    manual = code_blocks("text", (DOCS / "add-a-device.md").read_text("utf-8"))[0]
    Path("lifter.txt").write_text(manual, "utf-8", newline="\n")
    audit = re.search(
        r"`specs/lifter/audit.yaml`\n\n```yaml\n(.*?)```", (DOCS / "audit.md").read_text("utf-8"), re.DOTALL
    )
    assert audit is not None
    Path("specs/lifter/audit.yaml").write_text(audit[1], "utf-8")
    newcomer.types("fieldspec audit lifter --manual lifter.txt --record")

    lines = (
        manual.replace("100 %, default 120", "80 %, default 20").replace("find the lower end", "reference").split("\n")
    )
    lines.insert(11, "0204h    1      CURRENT R       motor current in 0.1 A")
    Path("edition-4.txt").write_text("\n".join(lines), "utf-8", newline="\n")
    printed = newcomer.types("fieldspec audit lifter --manual edition-4.txt", 1)
    assert "line 12 of the manual, section 4.2, prints `address` 0204" in printed
    assert "registers/speed cites 4.2 L10, where the manual does not print `range` 100" in printed

    device = Path("specs/lifter/device.yaml")
    assert "declare the first in its device.yaml: versions: [" in newcomer.types("fieldspec new version lifter 4", 2)
    device.write_text(device.read_text("utf-8").replace("\nuses:", f"\n{VERSIONS}\nuses:", 1), "utf-8")
    newcomer.types("fieldspec new version lifter 4")
    version = Path("specs/lifter/versions/4.yaml")
    version.write_text(OVERLAY, "utf-8")
    newcomer.types("fieldspec check lifter")
    assert "1 source, 2 behaviour" in newcomer.types("fieldspec diff lifter@3 lifter@4 --fail-on breaking", 1)
    version.write_text(OVERLAY + ACCEPTANCE, "utf-8")
    assert "2 behaviour, 1 accepted" in newcomer.types("fieldspec diff lifter@3 lifter@4 --fail-on breaking")
    newcomer.types("fieldspec audit lifter")
    newcomer.types("fieldspec build lifter --to python,docs")
    assert "the register current is new" in Path("generated/docs/lifter/changes.md").read_text("utf-8")
