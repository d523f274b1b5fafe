"""The self-test of a C header as a judge: compiled with strict flags and sanitizers, and run."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from bounded import HANGING

sys.path.insert(0, str(Path(__file__).parent.parent / "c_output"))

from compilers import STRICT

from external_tools import require_tool
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.names import stem
from fieldspec.targets.c.backend import files
from random_devices.queries import Answer, Query


class Selftest:
    """Says nothing about queries; raises AssertionError where the header or its self-test is wrong."""

    def __init__(self, layout: DeviceLayout, folder: Path, number: int) -> None:
        self.program = folder / "selftest"
        for path, text in files([layout]).items():
            (folder / path).write_text(text, encoding="utf-8")
        source = folder / f"{stem(layout.device.id, layout.device.version)}_selftest.c"
        sanitized = ["-std=c99", "-fsanitize=address,undefined", "-fno-sanitize-recover=all", *STRICT]
        command = [require_tool("gcc"), *sanitized, "-o", str(self.program), str(source)]
        self._run(command, "gcc does not compile the self-test")
        pedantic = [require_tool("g++"), "-std=c++11", "-x", "c++", "-fsyntax-only", *STRICT, str(source)]
        self._run(pedantic, "g++ does not compile the self-test")

    def _run(self, command: list[str], what: str) -> None:
        result = subprocess.run(command, capture_output=True, text=True, check=False, timeout=HANGING)
        assert result.returncode == 0, f"{what}: {(result.stdout + result.stderr)[:1200]}"

    def answers(self, queries: list[Query]) -> list[Answer]:
        """Nothing about single queries."""
        self._run([str(self.program)], "the self-test fails")
        return [Answer(reason=None)] * len(queries)
