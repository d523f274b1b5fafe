"""What the pages about controllers name is built, their commands run, and their examples parse."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from blark.parse import parse_source_code

sys.path.insert(0, str(Path(__file__).parent))

from page import PAGE, blocks

from layouts import SPECS


@pytest.mark.parametrize("block", blocks("iecst"))
def test_an_example_parses(block: str) -> None:
    result = parse_source_code(block)
    assert result.exception is None, (result.exception, block)


@pytest.mark.parametrize("block", blocks("python"))
def test_a_recipe_is_python(block: str) -> None:
    ast.parse(block)


@pytest.mark.parametrize("block", blocks("sh"))
def test_a_command_of_the_page_runs(block: str, built: Path) -> None:
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    result = subprocess.run(
        ["sh", "-e", "-c", block], cwd=built, env={**os.environ, "PATH": path}, capture_output=True, encoding="utf-8"
    )
    assert result.returncode == 0, result.stderr


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder where the first command of the page has run."""
    folder = tmp_path_factory.mktemp("plc_page")
    (folder / "specs").symlink_to(SPECS)
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    subprocess.run(["sh", "-e", "-c", blocks("sh")[0]], cwd=folder, env={**os.environ, "PATH": path}, check=True)
    return folder


def test_every_file_and_every_generated_name_of_the_page_is_built(built: Path) -> None:
    everything = "".join(
        path.read_text("utf-8").lstrip("\ufeff")
        for path in built.rglob("*")
        if path.suffix in (".st", ".scl", ".udt", ".db", ".xml", ".TcGVL", ".TcPOU")
    )
    names = set(re.findall(r"\b(?:F|FB|E|ST|GVL|PRG)_(?:Tc100|Esc11|HiwinE)\w+", PAGE))
    assert len(names) > 15
    assert {name for name in names if not re.search(rf"\b{name}\b", everything)} == set()
    for path in re.findall(r"`(?:generated/)?((?:plcopen|st|twincat|iec|scl|kv|hmi)/[\w./]+)`", PAGE):
        if "DEVICE" not in path:
            assert (built / "generated" / path).exists(), path
    for name in re.findall(r'"(hiwin_e_\w+\.(?:udt|db|scl))"', PAGE):
        assert (built / "generated" / "scl" / "hiwin_e_v2_14_4" / name).exists(), name
