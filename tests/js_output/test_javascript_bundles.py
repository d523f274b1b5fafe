"""A bundler drops what a program does not use of a generated module."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from external_tools import require_tool
from js_output.javascript import package

PROGRAMS = {
    "one record": ("import { Telegram111Response as used } from './hiwin-e/v2_14_4.js'; console.log(used);", 8_000),
    "one register": ("import { MOTION_COMMAND as used } from './tc100/v2_0.js'; console.log(used);", 4_000),
    "one enum": ("import { AlarmCode as used } from './tc100/v2_0.js'; console.log(used);", 1_000),
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_bundle_has_only_what_is_used(name: str, tmp_path: Path) -> None:
    program, most = PROGRAMS[name]
    bundle = tmp_path / "bundle.js"
    command = [require_tool("esbuild"), "--bundle", "--minify", "--format=esm", f"--outfile={bundle}"]
    subprocess.run(command, cwd=package(), input=program, text=True, check=True, capture_output=True)
    assert bundle.stat().st_size < most
