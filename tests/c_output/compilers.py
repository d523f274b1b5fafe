"""Compiles generated C with the strictest flags of each compiler."""

from __future__ import annotations

import subprocess
from pathlib import Path

from external_tools import require_tool

STRICT = [
    *("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion"),
    *("-Wshadow", "-Wcast-qual", "-Wundef", "-Wcast-align", "-Werror"),
]
SANITIZED = ["clang", "-std=c99", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
"""Clang builds with sanitizers in half of the time of GCC."""
COMPILERS = {
    "gcc": ["gcc", "-std=c99", "-O1"],
    "clang": ["clang", "-std=c99"],
    "g++": ["g++", "-std=c++11", "-x", "c++"],
    # tcc knows none of the extensions of gcc.
    "tcc": ["tcc", "-std=c99"],
    "sanitized": SANITIZED,
}


def compiled(compiler: str, source: Path, target: Path, *more: str) -> Path:
    """Compiles a source into a program and returns its path. Raises AssertionError with the compiler's messages."""
    tool, *flags = COMPILERS[compiler]
    command = [require_tool(tool), *flags, *STRICT, *more, "-o", str(target), str(source)]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr[:4000]
    return target
