"""Every piece of code in the pages about JavaScript and programs works as described."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from external_tools import require_tool

ROOT = Path(__file__).resolve().parents[2]
PAGES = ("javascript.md", "program.md")
BLOCKS = [
    block
    for page in PAGES
    for block in re.findall(r"```js\n(.*?)```", (ROOT / "docs" / page).read_text("utf-8"), re.DOTALL)
]


@pytest.mark.parametrize("code", BLOCKS, ids=[f"block{number}" for number in range(len(BLOCKS))])
def test_the_code_runs(code: str, tmp_path: Path) -> None:
    shutil.copytree(ROOT / "generated" / "js", tmp_path / "node_modules" / "fieldspec-devices")
    (tmp_path / "page.mjs").write_text(code, "utf-8")
    run = subprocess.run([require_tool("node"), "page.mjs"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (run.returncode, run.stderr) == (0, "")
