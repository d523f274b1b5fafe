"""A process that builds again and again remembers: what it writes and prints is what a build without memory does."""

from __future__ import annotations

import argparse
import random
import shutil
from pathlib import Path
from typing import Any

import pytest

from example_counts import FACTOR
from fieldspec.command.builds import workers
from fieldspec.command.builds.remembered_outputs import BuildMemory
from fieldspec.command.console.usage import UsageError
from fieldspec.command.verbs.build import build
from fieldspec.foundation.spreadsheet import Workbook
from fieldspec.language.reading import memory, project
from fieldspec.targets import Output
from spec_edits import Files, edited

SPECS = Path(__file__).resolve().parent / "specs"
DEVICES = ("widget", "gizmo", "wattmeter", "protocols")
"""Several files with a protocol and versions; anchors; versions in files of their own."""
OUTPUTS = "c,python,js,wireshark,docs"
EDITS = 4
NAME = "  name: Gizmo\n"


class Place:
    """A folder of specs, built with memory into one folder, and without into another."""

    def __init__(self, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
        self.specs, self.capsys = folder / "specs", capsys
        self.memory = BuildMemory()
        self.folders = {True: folder / "remembered", False: folder / "anew"}

    def write(self, files: Files) -> None:
        """Puts files in place of those of the folder."""
        shutil.rmtree(self.specs, ignore_errors=True)
        for path, text in files.items():
            (self.specs / path).parent.mkdir(parents=True, exist_ok=True)
            (self.specs / path).write_text(text, encoding="utf-8")

    def result(self, remembered: bool) -> tuple[dict[str, bytes], list[str]]:
        """What a build leaves in its folder, and what it ends with and prints."""
        folder = self.folders[remembered]
        arguments = argparse.Namespace(
            watch=True,
            check=False,
            no_cache=not remembered,
            to=OUTPUTS,
            devices=[],
            specs=str(self.specs),
            out=str(folder),
        )
        try:
            end = str(build(arguments, self.memory if remembered else None))
        except UsageError as error:
            end = str(error)
        printed = self.capsys.readouterr()
        files = {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}
        return files, [end, printed.out, printed.err]


def sound_files() -> Files:
    paths = sorted(path for device in DEVICES for path in (SPECS / device).rglob("*.yaml"))
    return {path.relative_to(SPECS).as_posix(): path.read_text("utf-8") for path in paths}


@pytest.mark.proof(1)
@pytest.mark.parametrize("seed", range(2))
def test_after_random_edits_memory_changes_neither_outputs_nor_findings(
    seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(workers, "WORTH_IT", 10**9)
    monkeypatch.setattr(project, "file_read", memory.file_read)  # as memory moves nodes that the tests share otherwise
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    place, choose = Place(tmp_path, capsys), random.Random(seed)
    files = sound = sound_files()
    for _ in range(EDITS * FACTOR):
        place.write(files)
        expected = place.result(remembered=False)
        assert place.result(remembered=True) == expected
        files = edited(files, sound, choose)


def test_outputs_that_have_not_read_what_has_changed_are_not_built_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    place, built_outputs, output_files = Place(tmp_path, capsys), [], Output.files

    def files(output: Output, *arguments: Any) -> dict[str, str | Workbook]:
        built_outputs.append(output.name)
        return output_files(output, *arguments)

    monkeypatch.setattr(Output, "files", files)
    sound = {path: text for path, text in sound_files().items() if path.startswith(("gizmo/", "protocols/"))}
    titled = {path: text.replace(NAME, f"{NAME}  title: A gimmick\n", 1) for path, text in sound.items()}
    place.write(sound)
    place.result(remembered=True)
    built_outputs.clear()
    place.write(titled)
    place.result(remembered=True)
    assert built_outputs == ["python", "js", "docs"]
    built_outputs.clear()
    next((place.folders[True] / "c").glob("gizmo*.h")).unlink()
    place.write(sound)
    place.result(remembered=True)
    assert built_outputs == ["c", "python", "js", "docs"]
