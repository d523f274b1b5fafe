"""Finds the programs that judge outputs: compilers, browsers, language servers."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import NoReturn

import pytest

NODE_TOOLS = Path(__file__).parent / "tools" / "node_modules" / ".bin"


def require_tool(name: str) -> str:
    """The path of a program; without it the test is skipped, or fails in CI, where every judge must speak."""
    path = shutil.which(name) or shutil.which(name, path=str(NODE_TOOLS))
    return path if path is not None else without(name)


def without(name: str, missing: str = "") -> NoReturn:
    """Skips a test that lacks something, or lets it fail in CI. `missing` says more than that it is not installed."""
    missing = missing or f"{name} is not installed; .ci/run shows which packages the tests need"
    if os.environ.get("CI"):
        pytest.fail(missing)
    pytest.skip(missing)
