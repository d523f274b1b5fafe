"""The page on adding a protocol is true: its files are checked, and its commands print what the page shows."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGE = ROOT / "docs" / "add-a-protocol.md"
RUN = "$ fieldspec "


def sessions() -> list[str]:
    """The commands of the page with what they print."""
    return re.findall(r"```console\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with the files of the page."""
    folder = tmp_path_factory.mktemp("project")
    shutil.copytree(ROOT / "specs" / "protocols", folder / "specs" / "protocols")
    blocks = re.findall(r"^`(specs/[\w./-]+)`\n\n```yaml\n(.*?)```", PAGE.read_text("utf-8"), re.DOTALL | re.MULTILINE)
    assert len(blocks) == 3
    for path, text in blocks:
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_text(text, "utf-8")
    return folder


@pytest.mark.parametrize("place", range(len(sessions())))
def test_a_command_prints_what_the_page_shows(folder: Path, accept: bool, place: int) -> None:
    session = sessions()[place]
    command = session.splitlines()[0]
    words = re.findall(r'"([^"]*)"|(\S+)', command.removeprefix(RUN))
    ran = subprocess.run(
        [sys.executable, "-m", "fieldspec", *(quoted or bare for quoted, bare in words)],
        cwd=folder,
        capture_output=True,
        encoding="utf-8",
    )
    assert (ran.returncode, ran.stderr) == (0, "")
    if accept:
        page = PAGE.read_text("utf-8")
        printed = f"```console\n{command}\n{ran.stdout}```"
        PAGE.write_text(page.replace(f"```console\n{session}```", printed, 1), "utf-8", newline="\n")
    assert sessions()[place] == f"{command}\n{ran.stdout}"
