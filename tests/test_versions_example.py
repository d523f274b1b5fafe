"""The pages on versions are true: their example is carried out on a copy of the specs."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest
import yaml

from external_tools import require_tool

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "versions.md"
EXAMPLE = PAGE.read_text("utf-8")
TEXT = EXAMPLE + PAGE.with_name("version-reference.md").read_text("utf-8")

CHANGING = re.compile(r":\d+:\d+|(?<=`)[0-9a-f]{16}(?=`)|^ *\d+(?= files,)|(?<=files, )\d+")
Block = tuple[str, str, str]
"""The last line of text above a block, the language of the block, and the block."""


def blocks(text: str) -> list[Block]:
    blocks = re.findall(r"([^\n]+)\n\n```(\w+)\n(.*?)```", text, re.DOTALL)
    return [(before, kind, text) for before, kind, text in blocks]


def runs(block: str) -> Iterator[tuple[str, str]]:
    """Commands with the output below them."""
    for part in block.split("$ fieldspec ")[1:]:
        command, _, output = part.partition("\n")
        yield command, output


class RunResult(NamedTuple):
    """The exit code and the output of a command."""

    code: int
    out: str


class Project:
    """A folder with the specs, in which the example is carried out."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for name in ("protocols", "tc100"):
            shutil.copytree(ROOT / "specs" / name, folder / "specs" / name)
        shutil.copy(ROOT / "specs" / "fieldspec.schema.json", folder / "specs")
        self.differing: list[tuple[str, str, str]] = []
        self.codes: list[tuple[str, int]] = []

    def run(self, command: str) -> RunResult:
        words = [sys.executable, "-m", "fieldspec", *shlex.split(command)]
        done = subprocess.run(words, cwd=self.folder, capture_output=True, encoding="utf-8")
        assert done.stderr == ""
        return RunResult(done.returncode, done.stdout)

    def follow(self, before: str, kind: str, block: str) -> None:
        """Carries out a block of the page."""
        path = re.match(r"`((?:specs|generated)/[\w./-]+)`", before)
        if kind == "yaml" and path:
            file = self.folder / path[1]
            previous = file.read_text("utf-8") + "\n" if before.endswith("continues") else ""
            file.write_text(previous + block, "utf-8")
        elif kind == "markdown" and path:
            self.compare(before, block, (self.folder / path[1]).read_text("utf-8"))
        elif kind == "text":
            wrong = re.search(r"with `was: (\S+)`", before)
            file = self.folder / "specs/tc100/versions/2.1.yaml"
            right = file.read_text("utf-8") if file.exists() else ""
            if wrong:
                file.write_text(re.sub(r"was: 1\.\.\d+", f"was: {wrong[1]}", right), "utf-8")
            for command, output in runs(block):
                done = self.run(command)
                self.codes.append((command, done.code))
                self.compare(command, output, done.out)
            if wrong:
                file.write_text(right, "utf-8")

    def compare(self, what: str, output: str, expected: str) -> None:
        """What is shown must be there in the same order; a line of dots stands for what is left out.

        Lines, columns, identities and numbers of files may differ: they change with what the example is not about.
        """
        left_out = r"(?:.*\n)*?"
        output, expected = (CHANGING.sub("#", text) for text in (output, expected))
        pattern = "".join(left_out if line == "..." else re.escape(line) + r" *\n" for line in output.splitlines())
        if not re.fullmatch(pattern, expected):
            self.differing.append((what, output, expected))


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Project:
    """The folder after the whole example."""
    walkthrough = Project(tmp_path_factory.mktemp("versions"))
    for before, kind, block in blocks(EXAMPLE):
        walkthrough.follow(before, kind, block)
    return walkthrough


def test_the_example_says_what_its_commands_print(project: Project) -> None:
    assert len(project.codes) >= 8
    assert project.differing == []


def test_the_change_fails_until_it_is_accepted(project: Project) -> None:
    assert [code for command, code in project.codes if "--fail-on" in command] == [1, 0]
    assert [code for command, code in project.codes if command == "check tc100"] == [0, 1, 0, 0]


def test_the_python_of_the_example_runs(project: Project) -> None:
    (code,) = (block for _, kind, block in blocks(EXAMPLE) if kind == "python")
    environment = {**os.environ, "PYTHONPATH": str(project.folder / "generated" / "python")}
    subprocess.run([sys.executable, "-c", code], env=environment, check=True)


def test_the_c_of_the_example_compiles(project: Project) -> None:
    (code,) = (block for _, kind, block in blocks(EXAMPLE) if kind == "c")
    source = project.folder / "program.c"
    source.write_text(code + "\nchar held[sizeof TC100_VERSION == 4 ? 1 : -1];\n", "utf-8")
    flags = ["-std=c99", "-fsyntax-only", "-I", str(project.folder / "generated" / "c")]
    subprocess.run([require_tool("gcc"), *flags, str(source)], check=True)


@pytest.mark.parametrize(
    "command", [line for _, kind, text in blocks(TEXT) if kind == "sh" for line in text.splitlines()]
)
def test_a_command_runs(command: str) -> None:
    words = [sys.executable, "-m", "fieldspec", *shlex.split(command)[1:]]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.strip()


def test_the_hooks_and_the_inputs_of_the_page_exist() -> None:
    documents: list[Any] = [yaml.safe_load(block) for _, kind, block in blocks(TEXT) if kind == "yaml"]
    (hooks,) = (block["repos"][0]["hooks"] for block in documents if "repos" in block)
    known = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text("utf-8"))
    assert [hook["id"] for hook in hooks] == [hook["id"] for hook in known]
    inputs = yaml.safe_load((ROOT / "action.yml").read_text("utf-8"))["inputs"]
    (job,) = (block["jobs"]["specs"] for block in documents if block and "jobs" in block)
    assert {key for step in job["steps"] if step.get("uses") == "./" for key in step["with"]} <= set(inputs)
    assert re.findall(r"^\| `([\w-]+)` \|", TEXT, re.MULTILINE) == list(inputs)


def test_no_block_of_the_page_is_skipped() -> None:
    assert 2 * len(blocks(TEXT)) == len(re.findall(r"^```", TEXT, re.MULTILINE))


def test_every_file_that_the_page_links_to_exists() -> None:
    for path in re.findall(r"\]\(([\w-]+\.md)", TEXT):
        assert (PAGE.parent / path).exists(), path
