"""What a shell gives a verb: pipes that nobody reads to their end, streams that are closed, a folder that vanished."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from command_line import SPECS

pytestmark = pytest.mark.skipif(os.name != "posix", reason="folders in use cannot be removed, and sh is needed")
DEADLINE = 60


def shell(script: str, folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Runs a script of sh in a folder; `$run` is the command, `$1` and so on are the arguments."""
    environment = {**os.environ, "run": f"{sys.executable} -m fieldspec"}
    environment.pop("PYTHONUNBUFFERED", None)
    return subprocess.run(
        ["sh", "-c", script, "sh", *arguments],
        cwd=folder,
        env=environment,
        capture_output=True,
        encoding="utf-8",
        timeout=DEADLINE,
    )


CODES = """{ $run %s; echo $? > code; } | %s > /dev/null; cat code"""
UNREAD_READERS = ("true", "head -n 1")
"""Programs that end before a verb has written what follows."""


def wrong_devices(folder: Path, count: int) -> Path:
    """A folder with devices that each have findings."""
    for number in range(count):
        path = folder / f"specs/pump{number}/device.yaml"
        path.parent.mkdir(parents=True)
        path.write_text(f"device: {{id: pump{number}}}\n", "utf-8")
    return folder / "specs"


@pytest.mark.parametrize("reader", UNREAD_READERS)
def test_findings_that_fit_into_a_pipe_which_nobody_reads_end_with_their_code(reader: str, tmp_path: Path) -> None:
    specs = wrong_devices(tmp_path, 1)
    assert shell(CODES % (f"check --specs {specs}", reader), tmp_path).stdout == "1\n"


@pytest.mark.parametrize("reader", UNREAD_READERS)
def test_findings_that_do_not_fit_into_a_pipe_which_nobody_reads_end_with_the_code_of_a_closed_pipe(
    reader: str, tmp_path: Path
) -> None:
    specs = wrong_devices(tmp_path, 400)
    ran = shell(CODES % (f"check --format json --specs {specs}", reader), tmp_path)
    assert (ran.stdout, ran.stderr) == ("141\n", "")


def test_breaking_changes_fail_although_only_their_first_line_is_read(tmp_path: Path) -> None:
    script = CODES % (f"diff tc100@2.0 tc100@before-2.0 --fail-on breaking --specs {SPECS}", "head -n 1")
    assert shell(script, tmp_path).stdout == "1\n"


def test_a_result_without_findings_that_was_complete_stays_a_success(tmp_path: Path) -> None:
    assert shell(CODES % (f"devices --specs {SPECS}", "true"), tmp_path).stdout == "0\n"


def test_wrong_use_whose_message_nobody_reads_keeps_its_code(tmp_path: Path) -> None:
    ran = shell(CODES % (f"check nobody --specs {SPECS} 2>&1", "true"), tmp_path)
    assert (ran.stdout, ran.stderr) == ("2\n", "")


@pytest.mark.parametrize(
    ("closed", "note"), [(">&-", "not in the list"), ("2>&-", ""), (">&- 2>&-", ""), (">&- 2>&- <&-", "")]
)
def test_a_verb_runs_with_closed_streams(closed: str, note: str, tmp_path: Path) -> None:
    ran = shell(f"$run export tc100 --specs {SPECS} --out list.csv {closed}", tmp_path)
    assert (ran.returncode, ran.stderr.partition(":")[0]) == (0, note)
    assert len((tmp_path / "list.csv").read_text("utf-8").splitlines()) > 50


VANISHED = 'mkdir gone && cd gone && rmdir ../gone && $run "$@"'
WRITING = (
    ("build", "tc100", "--to", "c", "--out", "generated"),
    ("audit", "tc100", "--format", "html", "--out", "audit"),
    ("audit", "tc100", "--table", "ledger", "--format", "xlsx", "--out", "ledger.xlsx"),
    ("export", "tc100", "--out", "list.csv"),
)


@pytest.mark.parametrize("arguments", WRITING, ids=" ".join)
def test_a_verb_in_a_folder_that_vanished_says_what_it_cannot_write(arguments: tuple[str, ...], tmp_path: Path) -> None:
    ran = shell(VANISHED, tmp_path, *arguments, "--specs", str(SPECS))
    assert (ran.returncode, ran.stdout) == (2, "")
    assert re.fullmatch("fieldspec: (cannot write .*: No such file or directory.*|the current folder .*)\n", ran.stderr)


@pytest.mark.parametrize("arguments", [("check",), ("check", "tc100", "--specs", str(SPECS))], ids=len)
def test_a_folder_that_vanished_is_named_as_the_reason(arguments: tuple[str, ...], tmp_path: Path) -> None:
    ran = shell(VANISHED, tmp_path, *arguments)
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr == "fieldspec: the current folder no longer exists; change to another one\n"


@pytest.mark.parametrize("arguments", WRITING, ids=" ".join)
@pytest.mark.skipif(sys.platform != "linux", reason="/proc is where nobody can create a folder, not even root")
def test_a_folder_that_cannot_be_created_ends_a_verb(arguments: tuple[str, ...], tmp_path: Path) -> None:
    ran = shell('$run "$@"', tmp_path, *arguments[:-1], "/proc/nothing/here/list", "--specs", str(SPECS))
    assert (ran.returncode, ran.stdout) == (2, "")
    assert "cannot write /proc/nothing" in ran.stderr
