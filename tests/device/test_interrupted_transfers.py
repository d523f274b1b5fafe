"""Transfers that are killed, fail or meet a foreign journal at any step leave a known state, and can be resumed."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import warnings
from collections.abc import Callable
from pathlib import Path

import pytest

from bounded import HANGING
from fieldspec.command.files.journal_file import JournalFile
from fieldspec.testing import SimulatedDevice
from fieldspec.tools.live.client import Client
from fieldspec.tools.live.journal import journal_state
from point_lists import (
    WRITES,
    command,
    five_points,
    live,
    points_file,
    set_values,
    speeds,
    value_of,
    writes_of,
)


class Killed(BaseException):
    """The end of a process, as far as a test within it can have one."""


def interrupt() -> None:
    """Ends a run as far as a test within its process can."""
    raise Killed


def killed_at(step: int, monkeypatch: pytest.MonkeyPatch, end: Callable[[], None] = interrupt) -> Callable[[], int]:
    """Ends a run at its step: before or after each line of the journal, and before or after each request."""
    steps = [0]

    def stop() -> None:
        steps[0] += 1
        if steps[0] == step:
            end()

    def around(owner: type, name: str, relevant: Callable[..., bool]) -> None:
        original = getattr(owner, name)

        def stopping(self: object, *arguments: object) -> object:
            if not relevant(*arguments):
                return original(self, *arguments)
            stop()
            result = original(self, *arguments)
            stop()
            return result

        monkeypatch.setattr(owner, name, stopping)

    around(JournalFile, "begin", lambda change: True)
    around(JournalFile, "verify", lambda change: True)
    around(Client, "_answer", lambda message, frame: frame[1] in WRITES)
    return lambda: steps[0]


def test_an_upload_that_is_killed_at_any_step_is_resumed(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    path = points_file(tmp_path, "tc100,2.0,points,2,20 %,25 ms")
    delivered = {"points[2].speed": 100, "points[2].wait_time": 0}
    step, ended = 0, False
    while not ended:
        step += 1
        set_values(tc100, delivered)
        with pytest.MonkeyPatch.context() as patch:
            steps_of = killed_at(step, patch)
            try:
                assert live(tc100, "points", "upload", path, "--yes") == 0
                ended = True
            except Killed:
                assert "the same command continues" in capsys.readouterr().err
            assert steps_of() == step - ended
        journal = Path(f"{path}.journal")
        state = journal_state(journal.read_bytes()) if journal.exists() else None
        changed = {name for name, value in delivered.items() if value_of(tc100, name) != value}
        if state is not None:
            assert set(state.verified) <= changed <= {*state.verified, state.path}
        if not ended:
            writes = writes_of(tc100)
            assert live(tc100, "points", "upload", path, "--yes") == 0
            assert len(writes) == 2 - len(changed)
            tc100.simulation.listeners.pop()
        assert [value_of(tc100, name) for name in delivered] == [20, 25]
        assert not journal.exists()
    assert step == 2 * 6 + 1


@pytest.mark.proof(2)
@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs processes that can be forked")
@pytest.mark.parametrize("step", range(1, 13))
def test_a_process_that_is_killed_at_any_step_leaves_what_another_one_completes(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path, step: int
) -> None:
    path = points_file(tmp_path, "tc100,2.0,points,2,20 %,25 ms")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        child = os.fork()
    if not child:
        with pytest.MonkeyPatch.context() as patch:
            killed_at(step, patch, lambda: os.kill(os.getpid(), signal.SIGKILL))
            live(tc100, "points", "upload", path, "--yes")
        os._exit(0)
    _, status = os.waitpid(child, 0)
    assert os.WIFSIGNALED(status)
    journal = Path(f"{path}.journal")
    state = journal_state(journal.read_bytes()) if journal.exists() else None
    assert live(tc100, "points", "upload", path, "--yes") == 0
    error = capsys.readouterr().err
    if state is not None:
        assert "an earlier run was interrupted; it has written and verified: " in error
        if state.path:
            assert f"it was writing {state.path}, which has" in error
    assert [value_of(tc100, f"points[2].{name}") for name in ("speed", "wait_time")] == [20, 25]
    assert not journal.exists()


@pytest.mark.parametrize("number", [1, 4])
def test_a_process_that_is_killed_on_the_line_leaves_a_journal(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path, number: int
) -> None:
    path = five_points(tmp_path)
    writes: list[bytes] = []
    running: list[subprocess.Popen[bytes]] = []

    def kill(now: float, link: str, way: str, data: bytes, text: str) -> None:
        if way == "request" and data[1] in WRITES:
            writes.append(data)
            if len(writes) == number:
                running[0].send_signal(signal.SIGKILL)

    tc100.simulation.listeners.append(kill)
    running.append(
        subprocess.Popen([sys.executable, "-m", "fieldspec", *command(tc100, "points", "upload", path, "--yes")])
    )
    assert running[0].wait(HANGING) == -signal.SIGKILL
    state = journal_state(Path(f"{path}.journal").read_bytes())
    assert state is not None
    assert len(state.verified) == number - 1
    assert state.path
    assert live(tc100, "points", "upload", path, "--yes") == 0
    assert f"it was writing {state.path}, which has" in capsys.readouterr().err
    assert speeds(tc100) == [10, 20, 30, 40, 50]
    assert value_of(tc100, "points[2].wait_time") == 25


@pytest.mark.parametrize(
    ("fault", "details", "expected"),
    [
        ("exception", {"reason": "value_invalid"}, "acceleration_time is not written: exception 3"),
        ("no_answer", {"count": 0}, "may be written or not: acceleration_time"),
        (
            "stuck_bit",
            {"signal": "registers/acceleration_time", "value": 3},
            "was not accepted: the device has 3 instead",
        ),
        ("connection_lost", {}, "may be written or not: acceleration_time"),
    ],
)
def test_a_failed_upload_says_what_was_written(
    tc100: SimulatedDevice,
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    fault: str,
    details: dict[str, object],
    expected: str,
) -> None:
    def strike(now: float, link: str, way: str, data: bytes, text: str) -> None:
        if way == "response" and data[1] == 0x03 and data[3:5] == b"\x00\x0a":
            tc100.simulation.listeners.remove(strike)
            tc100.fault(fault, **details)

    path = str(tmp_path / "settings.csv")
    Path(path).write_text("Name,Value\nmotion_speed,10\nacceleration_time,500\nhoming_speed,7\n", "utf-8")
    tc100.simulation.listeners.append(strike)
    assert live(tc100, "restore", path, "--yes") == 1
    error = capsys.readouterr().err
    assert expected in error
    assert "written and verified: motion_speed\n" in error
    assert "homing_speed" in error.partition("not as the file says: ")[2]
    assert Path(f"{path}.journal").exists()


def test_a_lost_answer_is_settled_by_reading_back(tc100: SimulatedDevice, tmp_path: Path) -> None:
    def strike(now: float, link: str, way: str, data: bytes, text: str) -> None:
        if way == "response" and data[1] == 0x03 and data[3:5] == b"\x00\x0a":
            tc100.simulation.listeners.remove(strike)
            tc100.fault("truncated")

    tc100.simulation.listeners.append(strike)
    assert live(tc100, "points", "upload", five_points(tmp_path), "--yes") == 0
    assert speeds(tc100) == [10, 20, 30, 40, 50]


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        ("speed\n", "is not a journal; move it away"),
        (
            '{"journal": 1, "unit": {"device": "tc100", "unit": 2}, "digest": ""}\n',
            "an unfinished transfer to device tc100",
        ),
    ],
)
def test_a_foreign_journal_stops_an_upload(
    tc100: SimulatedDevice, capsys: pytest.CaptureFixture[str], tmp_path: Path, content: str, expected: str
) -> None:
    path = five_points(tmp_path)
    Path(f"{path}.journal").write_text(content, "utf-8")
    writes = writes_of(tc100)
    assert live(tc100, "points", "upload", path, "--yes") == 2
    assert expected in capsys.readouterr().err
    assert writes == []
