"""Runs the command line within a test."""

from __future__ import annotations

import io
import json
import sys
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from fieldspec.cli import main
from fieldspec.command.sources import layout_cache, specs

SPECS = Path(__file__).resolve().parent.parent / "specs"
TEST_SPECS = Path(__file__).resolve().parent / "specs"


class RunResult(NamedTuple):
    """The exit code and the output of a run."""

    code: int
    out: str
    err: str

    @property
    def lines(self) -> list[str]:
        return self.out.splitlines()


class CommandLine:
    """Runs verbs on the specs of a folder. Each layout is read once and shared by all runs."""

    def __init__(self, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
        self.capsys, self.monkeypatch, self.folder = capsys, monkeypatch, folder
        monkeypatch.setattr(layout_cache, "layout", _layout)

    def __call__(self, *arguments: str, stdin: bytes = b"") -> RunResult:
        self.monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BufferedReader(io.BytesIO(stdin))))
        code = main([*arguments, "--specs", str(self.folder)])
        return RunResult(code, *self.capsys.readouterr())

    def json(self, *arguments: str, stdin: bytes = b"") -> Any:
        """The data that a verb prints as JSON."""
        return json.loads(self(*arguments, "--format", "json", stdin=stdin).out)


_layout, _sound_at = cache(layout_cache.layout), cache(specs.sound_at)


def read_devices_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Has verbs read each layout and each sound spec once. The specs of a folder must stay as they are."""
    monkeypatch.setattr(layout_cache, "layout", _layout)
    monkeypatch.setattr(specs, "sound_at", _sound_at)
