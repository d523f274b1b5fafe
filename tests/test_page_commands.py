"""Every command of every page runs in a project, and prints the lines that the page shows below it."""

from __future__ import annotations

import io
import re
import shlex
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from bounded import HANGING
from captures.conversations import USER_0, pcapng
from command_line import SPECS, TEST_SPECS
from external_tools import require_tool
from fieldspec import cli
from fieldspec.command.console.usage import UsageError
from fieldspec.tools.carriers.pages import PageServer
from test_add_a_device import PAGE as GUIDE
from test_add_a_device import RIGHT, WRONG, code_blocks, files

README = SPECS.parent / "README.md"
ELSEWHERE = {
    "add-a-device": "test_add_a_device.py",
    "add-a-protocol": "test_add_a_protocol.py",
    "command-line": "test_guides.py",
    "live": "device/test_console_blocks.py",
    "simulate": "device/test_console_blocks.py",
    "unit": "device/test_console_blocks.py",
    "versions": "test_versions_example.py",
}
"""The pages whose commands need more than a folder, such as a device or a story, with the tests that run them."""

DEVICE_VERBS = ("live", "scan", "simulate")
"""The commands that need a device, or last; the tests of devices run those of the blocks."""

DAMAGED = "80 CB"
"""The end of the only frame whose decoding ends with exit code 1: the tutorial explains its wrong checksum."""

ANY = "gizmo"
"""The device of a page that names none."""

LISTS = TYPED, _ = ("list-from-the-plc.csv", "list-from-the-vendor.xlsx")
"""The lists of the device that pages name. The first one is also what is typed."""

REQUEST, RESPONSE = "01 03 10 05 00 01 90 CB", "01 03 02 00 00 B8 44"

_OUTPUT = re.compile(r"\n\n```text\n(?!fieldspec )(.*?)^```$", re.DOTALL | re.MULTILINE)
_FENCE = re.compile(r"^```([^\n]*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
_INLINE = re.compile(r"`(fieldspec [a-z]+ [^`\n]+)`")
_PROGRAMS = ("awk", "echo", "fieldspec", "head", "tshark")
_OPERATOR = re.compile(r" (\|\||[<>|]) ")
_OUTPUT_FILE = re.compile(r"(?:--out|--to(?= \S+\.yaml)) (\S+)")
_PLACEHOLDER = re.compile(r"\b(?:[A-Z]|[A-Z]{2,}(?!~))\b(?!\d)")


class Command(NamedTuple):
    """A command of a page, and the lines that the page shows below it."""

    line: str
    output: tuple[str, ...] = ()


def commands(text: str) -> Iterator[Command]:
    """The commands of a page, each once: first the whole ones within sentences, which build what the blocks need."""
    lines = [line for line in _INLINE.findall(_FENCE.sub("", text)) if not _PLACEHOLDER.search(line)]
    yield from (Command(line) for line in dict.fromkeys(lines) if is_whole(line))
    fences = [(*match.groups(), text[match.end() :]) for match in _FENCE.finditer(text)]
    for language, block, after in fences:
        match = _OUTPUT.match(after) if language == "sh" else None
        output = match[1].splitlines() if match else ()
        for part in block.split("$ ")[1:] if language == "console" else ():
            line, *output = part.rstrip("\n").split("\n")
            yield Command(line, tuple(output))
        for line in block.splitlines() if language in ("sh", "text", "") else ():
            if line.startswith(_PROGRAMS):
                # A remark follows a command after some spaces.
                yield Command(re.split(" {2,}", line)[0], tuple(output))


def is_whole(line: str) -> bool:
    """Whether a command has all arguments; a sentence may name only a command or an option."""
    try:
        cli._parser().parse_args(shlex.split(line)[1:])
    except (SystemExit, UsageError):
        return False
    return True


def is_run_here(line: str) -> bool:
    program, verb, *_ = (*line.split(), "")
    return program in _PROGRAMS and (verb not in DEVICE_VERBS or "--dry-run" in line)


PAGES = {
    path.stem: [own for own in commands(path.read_text("utf-8")) if is_run_here(own.line)]
    for path in (README, *sorted(README.parent.glob("docs/*.md")))
    if path.stem not in ELSEWHERE
}


class Scene:
    """A project with the files that the pages name: captures, logs, dumps, lists, a manual and a history."""

    def __init__(self, folder: Path, page: str, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder, self.monkeypatch = folder, monkeypatch
        text = "\n".join(own.line for own in PAGES[page])
        lists = [path for path in LISTS if path in text or ("import -" in text and path == TYPED)]
        named = {name for name in ("ck10", "esc11", "hiwin-e", "tc100") if name in text}
        if lists or "DEVICE" in text:
            named.add("tc100")
        for name in (*named, "protocols"):
            shutil.copytree(SPECS / name, folder / "specs" / name)
        if not named:
            shutil.copytree(TEST_SPECS / ANY, folder / "specs" / ANY)
        shutil.copy(SPECS.parent / "fieldspec.yaml", folder)
        self.has_lifter = page == "audit"
        if self.has_lifter:
            self.write_lifter()
        self.write_traffic()
        for path in lists:
            assert self.run(f"fieldspec export tc100 --to {path[-4:].strip('.')} --out {path}") == 0
        if "diff main" in text:
            self.commit()

    def write_lifter(self) -> None:
        """The device of the guide, with its manual."""
        (self.folder / "specs/lifter").mkdir()
        for path, text in files().items():
            (self.folder / path).write_text(text.replace(WRONG, RIGHT), "utf-8")
        (manual, *_) = code_blocks("text", GUIDE.read_text("utf-8"))
        (self.folder / "lifter.txt").write_text(manual, "utf-8", newline="\n")

    def write_traffic(self) -> None:
        """A read of the alarm in a capture and in logs, and dumps of the device."""
        (self.folder / "monday").mkdir()
        for name in ("monday/morning.log", "tuesday.log"):
            (self.folder / name).write_text(f"10:00:00.000 > {REQUEST}\n10:00:00.020 < {RESPONSE}\n", "utf-8")
        (self.folder / "line3.pcapng").write_bytes(pcapng(map(bytes.fromhex, (REQUEST, RESPONSE)), USER_0))
        unit = self.folder / "units/bench"
        unit.mkdir(parents=True)
        (unit / "unit.yaml").write_text('model: TC100\nfirmware: "2.0"\nserial_number: redacted\n', "utf-8")
        (unit / "rest.csv").write_text("address,value\n0x1005,0\n0x1009,0\n", "utf-8")
        (self.folder / "read.csv").write_text("Reg.,remark,value\n1006,,0\n", "utf-8")

    def commit(self) -> None:
        """A history of four commits on `main`."""
        git = ["git", "-c", "user.name=a", "-c", "user.email=a@example.com"]
        subprocess.run([*git, "init", "--quiet", "--initial-branch", "main"], check=True)
        subprocess.run([*git, "add", "specs"], check=True)
        for number in range(4):
            subprocess.run([*git, "commit", "--quiet", "--allow-empty", "-m", str(number)], check=True)

    def run(self, line: str) -> int:
        """Runs a command in this process, or a line of other programs by the shell."""
        if not line.startswith("fieldspec "):
            for name in re.findall(r"(?:^|\| )(\w+)", line):
                require_tool(name)
            line = line.replace("lua_script:", "lua_script:generated/wireshark/")
            return subprocess.run(["sh", "-c", line], timeout=HANGING).returncode
        line, operator, *_ = (*_OPERATOR.split(line, maxsplit=1), "")
        words = [self.replaced(word, line) for word in shlex.split(line)[1:]]
        typed = Path(TYPED).read_bytes() if "-" in words else b""
        self.monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(typed)))
        code = cli.main([*words, "--port", "0"] if words == ["docs"] else words)
        return 0 if operator == "||" else code

    def replaced(self, word: str, line: str) -> str:
        """An argument, with the device and the file of this project for `DEVICE` and `FILE`."""
        if word == "DEVICE":
            # The device of the guide is small; only sections of the other one are signed.
            return "lifter" if self.has_lifter and "--sign" not in line else "tc100"
        if word == "FILE":
            return "lifter.txt" if "--manual" in line else "read.csv"
        return word


def interrupted(server: PageServer) -> None:
    """Ends the server of the documentation, as a person does who has read it."""
    raise KeyboardInterrupt


@pytest.mark.parametrize("page", [name for name, own in PAGES.items() if own])
def test_the_commands_of_a_page_run_and_print_what_it_shows(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")
    monkeypatch.setattr("webbrowser.open", lambda address: True)
    monkeypatch.setattr("fieldspec.tools.carriers.pages.PageServer.serve", interrupted)
    scene = Scene(tmp_path, page, monkeypatch)
    for line, output in PAGES[page]:
        capsys.readouterr()
        code = scene.run(line)
        printed = "".join(capsys.readouterr())
        assert code == (1 if DAMAGED in line else 0), f"{line} ends with {code}: {printed}"
        for name in _OUTPUT_FILE.findall(line):
            assert (tmp_path / name).exists(), line
        assert [own for own in output if own.strip() not in printed] == [], f"{line} prints {printed}"


@pytest.mark.parametrize(("page", "test"), ELSEWHERE.items())
def test_the_other_pages_are_run_by_tests_that_read_them(page: str, test: str) -> None:
    assert re.search(rf"\b{page}\b", (Path(__file__).parent / test).read_text("utf-8"))
