"""Finds the programs that judge outputs: compilers, browsers, language servers."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import NoReturn

import pytest

NODE_TOOLS = Path(__file__).parent / "tools" / "node_modules" / ".bin"


def require_tool(name: str) -> str:
    """The path of a program. If it is missing, the test is skipped, or fails in CI, where every tool is needed."""
    path = shutil.which(name) or shutil.which(name, path=str(NODE_TOOLS))
    return path if path is not None else without(name)


def without(name: str, missing: str = "") -> NoReturn:
    """Skips the test, or fails it in CI. `missing` is the message if "not installed" is not the reason."""
    missing = missing or f"{name} is not installed; .ci/run shows which packages the tests need"
    if os.environ.get("CI"):
        pytest.fail(missing)
    pytest.skip(missing)
