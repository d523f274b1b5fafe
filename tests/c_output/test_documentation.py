"""The code in the documentation of the C headers compiles without a warning and does what the text says."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from compilers import compiled

from fieldspec.targets.c.backend import files
from layouts import SPECS, newest

TEXT = (Path(__file__).resolve().parent.parent.parent / "docs" / "c.md").read_text("utf-8")
PROGRAMS = re.findall(r"```c\n(.*?)```", TEXT, re.DOTALL)


@pytest.mark.parametrize("compiler", ["gcc", "sanitized"])
@pytest.mark.parametrize("program", PROGRAMS, ids=[text.splitlines()[0].split('"')[1] for text in PROGRAMS])
def test_a_program_of_the_documentation_runs(program: str, compiler: str, tmp_path: Path) -> None:
    for device in ("tc100", "hiwin-e"):
        for path, text in files([newest(SPECS, device)]).items():
            (tmp_path / path).write_text(text, encoding="utf-8", newline="\n")
    (tmp_path / "program.c").write_text(program, encoding="utf-8")
    compilation = compiled(compiler, tmp_path / "program.c", tmp_path / "program")
    assert subprocess.run([str(compilation)], check=False).returncode == 0
