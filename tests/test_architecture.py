"""The walk of docs/architecture.md is true: functions exist, quotations are in the outputs, searches succeed."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PACKAGE = ROOT / "codegen" / "fieldspec"
TEXT = (ROOT / "docs" / "architecture.md").read_text("utf-8")
WALK = TEXT.partition("\n## Follow one register\n")[2].partition("\n## ")[0]
STEPS = re.findall(r"^\| [\w ,]+ \| `([\w/.]+)` \| `(\w+)` \|", WALK, re.MULTILINE)
SEARCHES = re.findall(r"^\| `.+` \| `grep -rn '(.+)' ([\w/]+)` \|", WALK, re.MULTILINE)
QUOTED = {
    "yaml": (ROOT / "specs" / "tc100" / "registers-motion.yaml",),
    "c": sorted((ROOT / "generated" / "c").glob("tc100_v2_0*.h")),
    "python": (ROOT / "generated" / "python" / "fieldspec_devices" / "tc100" / "v2_0.py",),
    "html": (ROOT / "generated" / "docs" / "tc100" / "2.0.html",),
}


def test_the_walk_has_steps_and_searches() -> None:
    assert len(STEPS) > 10
    assert len(SEARCHES) > 5


@pytest.mark.parametrize(("path", "function"), STEPS, ids=["-".join(step) for step in STEPS])
def test_a_step_names_a_function_of_its_file(path: str, function: str) -> None:
    assert re.search(rf"^ *def {function}\(", (PACKAGE / path).read_text("utf-8"), re.MULTILINE)


@pytest.mark.parametrize(("words", "folder"), SEARCHES, ids=[words for words, _ in SEARCHES])
def test_a_search_leads_to_the_code(words: str, folder: str) -> None:
    files = [path for path in (PACKAGE / folder).rglob("*") if path.suffix in (".py", ".j2", ".h")]
    assert any(words in path.read_text("utf-8") for path in files)


@pytest.mark.parametrize("language", QUOTED)
def test_quotations_are_in_the_outputs(language: str) -> None:
    lines = WALK.partition(f"```{language}\n")[2].partition("```")[0].splitlines()
    assert lines
    text = "".join(path.read_text("utf-8") for path in QUOTED[language])
    assert [line for line in lines if line not in text] == []
