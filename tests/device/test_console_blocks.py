"""The console blocks of the guides on devices do what they say: each command runs, and prints what the guide prints.

Places are other ones in each run. A device at `/dev/ttyUSB0` is a simulated one here.
"""

from __future__ import annotations

import io
import re
import shlex
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from bounded import HANGING
from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.testing import simulation
from simulators import SPECS, parts_of

DOCS = Path(__file__).resolve().parents[2] / "docs"
_CONSOLE = re.compile(r"```console\n(.*?)```", re.DOTALL)
_JSON = re.compile(r"```json\n(.*?)```", re.DOTALL)
_PLACES = re.compile(r"/dev/pts/[0-9]+|(?<=127\.0\.0\.1:)[0-9]+|(?<=key=)[\w-]+")
_REAL = "/dev/ttyUSB0"

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo-terminals of this kind")


def commands(page: str) -> Iterator[tuple[str, list[str]]]:
    """The commands of a guide in order, each with the lines that it prints."""
    for block in _CONSOLE.findall((DOCS / page).read_text("utf-8")):
        for text in block.split("$ ")[1:]:
            line, *output = text.rstrip("\n").split("\n")
            yield line, output


class _Terminal(io.StringIO):
    """The input of somebody who sits at a terminal."""

    def isatty(self) -> bool:
        return True


class Session:
    """Runs the commands of a guide. A device that a command starts or needs goes on until the next one starts."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
        self.monkeypatch, self.capsys = monkeypatch, capsys
        self.device: subprocess.Popen[str] | None = None
        self.served = ExitStack()
        self.places: dict[str, str] = {}
        self.variables: dict[str, str] = {}

    def run(self, line: str, count: int = 0) -> str:
        """What a command prints; of one that goes on, so many lines, but one at the least."""
        for name, value in self.variables.items():
            line = line.replace(f"${name}", value)
        words = shlex.split(line)
        if words[0] == "export":
            name, _, value = words[1].partition("=")
            self.variables[name] = value
            return ""
        if words[:2] == ["fieldspec", "simulate"] and "--assumptions" not in words:
            return self.simulate(words[2:], count)
        if _REAL in words:
            # Only the search meets a device whose settings are not those of the factory.
            self.serve(words[2])
            words[words.index(_REAL)] = "socket://127.0.0.1:5020"
        words = [
            self.places.get(word, word).replace("127.0.0.1:5020", self.places.get("127.0.0.1:5020", ""))
            for word in words
        ]
        if words[0] != "fieldspec":
            command = [require_tool(words[0]), *words[1:]]
            return subprocess.run(command, capture_output=True, text=True, check=True, timeout=HANGING).stdout
        if "watch" in words:
            return self.interrupted([*words[1:], "--specs", SPECS])
        if "<" in words:
            self.monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(Path(words[-1]).read_bytes())))
            words = words[: words.index("<")]
        else:
            self.monkeypatch.setattr("sys.stdin", _Terminal("y\n"))
        self.capsys.readouterr()
        # A comparison that found differences ends with 1.
        assert main([*words[1:], "--specs", SPECS]) in ((0, 1) if "--dry-run" in words else (0,))
        return "".join(self.capsys.readouterr())

    def simulate(self, words: list[str], count: int = 1) -> str:
        """Starts a device; its places stand for those that the guide prints."""
        self.end()
        words = [word.replace(":5020", ":0") for word in words]
        words = ["0" if word == "8765" else word for word in words]
        command = [sys.executable, "-m", "fieldspec", "simulate", *words, "--specs", SPECS]
        self.device = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        assert self.device.stderr is not None
        lines = [self.device.stderr.readline() for _ in range(max(count, 1))]
        places = [line.split(": ")[1].strip() for line in lines if ": " in line]
        self.places = {"/dev/pts/4": places[0], "127.0.0.1:5020": places[0].removeprefix("tcp://")}
        return "".join(lines)

    def serve(self, device: str) -> None:
        """Serves a device in this process, in place of a real one."""
        self.end()
        link = parts_of(device)[0].device.default_link
        served = simulation(device, ports={link: "tcp://127.0.0.1:0"}, folder=SPECS)
        place = self.served.enter_context(served).place
        self.places = {"127.0.0.1:5020": place.removeprefix("tcp://")}

    def interrupted(self, words: list[str]) -> str:
        """What a verb prints until somebody interrupts it."""
        process = subprocess.Popen([sys.executable, "-m", "fieldspec", *words], stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        first = process.stdout.readline() + process.stdout.readline()
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=HANGING)
        return first

    def end(self) -> None:
        """Ends the device."""
        self.served.close()
        if self.device is not None:
            self.device.kill()
            self.device.communicate()


@pytest.fixture
def session(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Iterator[Session]:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")
    running = Session(monkeypatch, capsys)
    yield running
    running.end()


def assert_prints(printed: str, expected: list[str], line: str) -> None:
    """Each line of the guide is printed, whatever the places and the blanks between columns."""

    def words(text: str) -> str:
        return " ".join(_PLACES.sub("…", text).split())

    for want in expected:
        assert words(want.removesuffix("[y/N] y")) in words(printed), f"{line} prints {printed}"


def test_the_commands_of_the_guide_on_real_devices_run(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    # The socket stands for a serial line.
    monkeypatch.setattr("fieldspec.command.live.connection.has_line_settings", lambda place: True)
    for line, expected in commands("live.md"):
        if "find" in line:  # which takes minutes here; its own tests have it
            continue
        if "--dry-run" in line:  # what the guide asks its readers to do before it
            points = Path("points.csv")
            text = points.read_text("utf-8")
            changed = re.sub(r"(?m)^(tc100,2\.0,points,3,\w+,0 pulse,)100 %", r"\g<1>40 %", text)
            assert changed != text
            points.write_text(changed, "utf-8")
        assert_prints(session.run(line, len(expected)), expected, line)


@pytest.mark.parametrize("page", ["unit.md", "plc.md"])
def test_the_commands_of_a_door_run(page: str, session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("fieldspec.command.live.connection.has_line_settings", lambda place: True)
    for line, expected in commands(page):
        if "find" not in line:  # which takes minutes here; its own tests have it
            assert_prints(session.run(line, len(expected)), expected, line)


def test_the_commands_of_the_guide_on_simulated_devices_run(session: Session) -> None:
    script = _JSON.findall((DOCS / "simulate.md").read_text("utf-8"))[0]
    Path("script.jsonl").write_text(script, "utf-8")
    for line, expected in commands("simulate.md"):
        if line.startswith("pip "):
            continue
        if line.startswith("fieldspec decode"):
            session.run("fieldspec live tc100 read alarm_code --port /dev/pts/4")
            assert "read_registers" in session.run(line)
            continue
        assert_prints(session.run(line, len(expected)), expected, line)
