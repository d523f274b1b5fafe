"""The programs of the tutorial run, the guides name commands that exist, and the site has all pages."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from bounded import HANGING
from command_line_page import page
from fieldspec import cli

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
TUTORIAL = (DOCS / "tutorial.md").read_text("utf-8")
COMMAND_LINE = DOCS / "command-line.md"
BLOCKS = re.findall(r"```(\w+)\n(.*?)```", TUTORIAL, re.DOTALL)
COMMANDS = sorted(
    {
        (path.name, re.split(r" (?:[<>|]|\|\|) ", line.removeprefix("$ "))[0])
        for path in DOCS.glob("*.md")
        for language, block in re.findall(r"```(\w+)\n(.*?)```", path.read_text("utf-8"), re.DOTALL)
        if language in ("sh", "console")
        for line in block.splitlines()
        if re.match(r"(?:\$ )?fieldspec ", line)
    }
)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pseudo-terminals of this kind")
def test_the_programs_of_the_tutorial_run() -> None:
    programs = [text for language, text in BLOCKS if language == "python"]
    assert len(programs) == 2
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "generated" / "python")}
    for program in programs:
        result = subprocess.run(
            [sys.executable, "-c", program], cwd=ROOT, env=environment, capture_output=True, text=True, timeout=HANGING
        )
        assert result.returncode == 0, result.stderr


@pytest.mark.parametrize(("page", "command"), COMMANDS, ids=[f"{name}-{command}" for name, command in COMMANDS])
def test_a_command_of_a_guide_has_arguments_that_exist(page: str, command: str) -> None:
    cli._parser().parse_args(shlex.split(command)[1:])


def test_the_page_on_the_command_line_is_fresh(accept: bool) -> None:
    if accept:
        COMMAND_LINE.write_text(page(), "utf-8", newline="\n")
    assert COMMAND_LINE.read_text("utf-8") == page()


def test_the_index_leads_to_every_page() -> None:
    index = (DOCS / "index.md").read_text("utf-8")
    pages = {path.stem for path in DOCS.glob("*.md")} - {"index"}
    trees = re.findall(r"```\{toctree\}\n(.*?)```", index, re.DOTALL)
    entries = [line for tree in trees for line in tree.splitlines() if line and not line.startswith(":")]
    assert sorted(entries) == sorted(pages)
    assert {Path(link).stem for link in re.findall(r"\]\(([\w-]+\.md)\)", index)} == pages
