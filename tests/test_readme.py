"""The README names what exists, and the code of the pages on programs works as described."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from external_tools import require_tool

ROOT = Path(__file__).resolve().parent.parent
TEXT = (ROOT / "README.md").read_text("utf-8")


PROGRAM, PYTHON, CLIENT = (
    (ROOT / "docs" / name).read_text("utf-8") for name in ("program.md", "python.md", "client.md")
)


def blocks(language: str, text: str = TEXT) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", text, re.DOTALL)


def test_two_commands_are_enough_to_start_with() -> None:
    first, second = blocks("sh")[0].splitlines()
    assert (first, second.split()[:2]) == ("make", ["fieldspec", "decode"])


@pytest.mark.parametrize("code", [code for text in (PROGRAM, PYTHON, CLIENT) for code in blocks("python", text)])
def test_the_python_code_runs(code: str) -> None:
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "generated" / "python")}
    result = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr


@pytest.mark.parametrize("code", blocks("c", PROGRAM))
def test_the_c_code_compiles_and_writes_the_frame_of_the_manual(code: str, tmp_path: Path) -> None:
    source, program = tmp_path / "readme.c", tmp_path / "readme"
    source.write_text(code, encoding="utf-8")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-I", str(ROOT / "generated" / "c")]
    subprocess.run([require_tool("gcc"), *flags, "-o", str(program), str(source)], check=True)
    result = subprocess.run([str(program)], capture_output=True, text=True, check=True)
    assert result.stdout == "09 00 16 D0 07 00 00 32 28 "


def test_every_file_that_it_names_exists() -> None:
    for path in re.findall(r"\]\(([^)]+)\)|`(generated/\w+)`", TEXT):
        assert (ROOT / "".join(path)).exists(), path
