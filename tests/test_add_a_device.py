"""The page on adding a device is true: its device is checked and built as the page says."""

from __future__ import annotations

import hashlib
import json
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from fieldspec.command.pipeline import checked
from spec_files import project

ROOT = Path(__file__).parent.parent
PAGE = ROOT / "docs" / "add-a-device.md"
AUDIT = ROOT / "docs" / "audit.md"
RECIPES = ROOT / "docs" / "spec-recipes.md"
PROJECT = ROOT / "docs" / "project-file.md"
RUN = "$ fieldspec "

WRONG, RIGHT = "default: 120, source", "default: 20, source"
"""The row as the manual prints it, and as it is with the erratum."""


def code_blocks(kind: str, text: str) -> list[str]:
    return re.findall(rf"```{kind}\n(.*?)```", text, re.DOTALL)


def files() -> dict[str, str]:
    """The files on the page and in the first audit, by the paths above them."""
    text = PAGE.read_text("utf-8") + AUDIT.read_text("utf-8")
    blocks = re.findall(r"^`(specs/lifter/[\w./-]+)`\n\n```yaml\n(.*?)```", text, re.DOTALL | re.MULTILINE)
    assert len(blocks) == 5
    return dict(blocks)


def project_file() -> str:
    """The project file on its page."""
    page = PROJECT.read_text("utf-8")
    (text,) = re.findall(r"^`fieldspec.yaml`\n\n```yaml\n(.*?)```", page, re.DOTALL | re.MULTILINE)
    return str(text)


def run(command: str, folder: Path) -> str:
    """The output of a command in a folder."""
    words = shlex.split(command.removeprefix(RUN))
    ran = subprocess.run([sys.executable, "-m", "fieldspec", *words], cwd=folder, capture_output=True, encoding="utf-8")
    assert ran.stderr == ""
    return ran.stdout


def test_the_project_is_started_as_the_page_says(tmp_path: Path) -> None:
    (command,) = code_blocks("sh", PAGE.read_text("utf-8"))
    words = [sys.executable, "-m", "fieldspec", *shlex.split(command)[1:]]
    subprocess.run(words, cwd=tmp_path, capture_output=True, check=True)
    assert {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.yaml")} >= {
        "fieldspec.yaml",
        "specs/lifter/device.yaml",
    }


def test_the_frames_of_the_page_are_right() -> None:
    (frames,) = (
        text for text in code_blocks("yaml", RECIPES.read_text("utf-8")) if text.startswith("links:\n  - name: bus")
    )
    assert [finding.message for finding in checked(project(frames))] == []


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A project with the device as it is without the erratum."""
    shutil.copytree(ROOT / "specs" / "protocols", tmp_path / "specs" / "protocols")
    (tmp_path / "specs" / "lifter").mkdir()
    for path, text in files().items():
        if not path.endswith("errata.yaml"):
            (tmp_path / path).write_text(text, "utf-8")
    (tmp_path / "fieldspec.yaml").write_text(project_file(), "utf-8")
    return tmp_path


@pytest.fixture
def mended(folder: Path) -> Path:
    """The same project with the erratum and the corrected row."""
    registers = folder / "specs" / "lifter" / "registers.yaml"
    text = registers.read_text("utf-8")
    assert WRONG in text
    registers.write_text(text.replace(WRONG, RIGHT), "utf-8")
    (folder / "specs" / "lifter" / "errata.yaml").write_text(files()["specs/lifter/errata.yaml"], "utf-8")
    return folder


def test_the_manual_of_the_page_is_the_one_that_its_device_names() -> None:
    (manual, *_) = code_blocks("text", PAGE.read_text("utf-8"))
    device = files()["specs/lifter/device.yaml"]
    assert f"sha256: {hashlib.sha256(manual.encode()).hexdigest()}\n" in device
    assert f"lines: {len(manual.splitlines())}\n" in device


def test_the_misprint_is_found_as_the_page_shows_it(folder: Path, accept: bool) -> None:
    page = PAGE.read_text("utf-8")
    first = code_blocks("console", page)[0]
    command = first.splitlines()[0]
    printed = f"{command}\n{run(command, folder)}"
    if accept:
        PAGE.write_text(page.replace(f"```console\n{first}```", f"```console\n{printed}```", 1), "utf-8", newline="\n")
    assert "default_within_range" in printed
    assert code_blocks("console", PAGE.read_text("utf-8"))[0] == printed


def test_the_mended_device_has_no_findings(mended: Path) -> None:
    (session,) = [block for block in code_blocks("console", PAGE.read_text("utf-8")) if "no findings" in block]
    command, _, printed = session.partition("\n")
    assert run(command, mended) == printed


def test_the_erratum_is_needed(mended: Path) -> None:
    registers = mended / "specs" / "lifter" / "registers.yaml"
    registers.write_text(registers.read_text("utf-8").replace(RIGHT, WRONG), "utf-8")
    assert "error[default_within_range]" in run("$ fieldspec check lifter", mended)


def test_the_mended_device_decodes_the_frame_of_its_manual(mended: Path, accept: bool) -> None:
    page = PAGE.read_text("utf-8")
    (block,) = [block for block in code_blocks("console", page) if "decode" in block]
    command = block.partition("\n")[0]
    page = page.replace(block, f"{command}\n{run(command, mended)}")
    if accept:
        PAGE.write_text(page, "utf-8", newline="\n")
    assert PAGE.read_text("utf-8") == page


def test_the_mended_device_is_built(mended: Path) -> None:
    (command,) = [block for block in code_blocks("console", PAGE.read_text("utf-8")) if "build" in block]
    run(command.strip(), mended)
    outputs = sorted(path.name for path in (mended / "generated").iterdir() if path.is_dir())
    assert outputs == ["docs", "python", "st", "vectors"]
    for output in outputs:
        named = [path for path in (mended / "generated" / output).rglob("*") if "lifter" in path.as_posix()]
        assert named, f"{output} has no file of the device"


def test_the_audit_of_the_mended_device_leaves_nothing(mended: Path, accept: bool) -> None:
    (mended / "lifter.txt").write_text(code_blocks("text", PAGE.read_text("utf-8"))[0], "utf-8", newline="\n")
    page = AUDIT.read_text("utf-8")
    blocks = [block for block in code_blocks("console", page) if "audit lifter" in block]
    for block in blocks:
        command = block.splitlines()[0]
        printed = f"{command}\n{run(command, mended)}"
        page = page.replace(f"```console\n{block}```", f"```console\n{printed}```", 1)
    if accept:
        AUDIT.write_text(page, "utf-8", newline="\n")
    assert AUDIT.read_text("utf-8") == page
    assert len(blocks) == 2
    result = json.loads(run("$ fieldspec audit lifter --format json", mended))
    assert result["sections"]["coverage"]["findings"] == []


def test_the_spec_with_coils_has_no_findings(folder: Path) -> None:
    (sections,) = (text for text in code_blocks("yaml", RECIPES.read_text("utf-8")) if "unit: bit" in text)
    head = files()["specs/lifter/device.yaml"].partition("uses:")[0]
    for path in (folder / "specs" / "lifter").glob("*.yaml"):
        path.unlink()
    (folder / "specs" / "lifter" / "device.yaml").write_text(head + sections, "utf-8")
    assert run("$ fieldspec check lifter", folder) == "no findings in lifter\n"
