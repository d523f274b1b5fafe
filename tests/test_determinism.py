"""The same specs give the same bytes, whatever the hash seed, locale, time zone, folder, umask or order of names."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from example_counts import FACTOR

SPECS = Path(__file__).resolve().parent.parent / "specs"
DEVICES = ("esc11", "protocols")

SETTINGS: dict[str, Mapping[str, str]] = {
    "hash seed": {"PYTHONHASHSEED": "4242"},
    "locale": {"LC_ALL": "tr_TR.UTF-8", "LANG": "tr_TR.UTF-8", "PYTHONUTF8": "0"},
    "no locale": {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
    "time zone": {"TZ": "Pacific/Kiritimati"},
    "optimized": {"PYTHONOPTIMIZE": "2"},
    "epoch": {"SOURCE_DATE_EPOCH": "1"},
    "umask": {"UMASK": "077"},
    "order of names": {"REVERSED": "1"},
    "width of the terminal": {"COLUMNS": "20", "LINES": "5"},
}
# A build takes seconds: the usual tests change many settings at once, those of the nights one at a time.
FIRST: Mapping[str, str] = {"PYTHONHASHSEED": "0"}
TRIED = SETTINGS
if FACTOR == 1:
    # The locale forbids some of the others.
    FIRST = {**FIRST, **SETTINGS["locale"]}
    TRIED = {"all others": {k: v for name in SETTINGS if name != "locale" for k, v in SETTINGS[name].items()}}
RUN = """
import os, sys
os.umask(int(os.environ.get("UMASK", "022"), 8))
if "REVERSED" in os.environ:
    listdir, scandir = os.listdir, os.scandir
    class Reversed(list):
        def __enter__(self): return self
        def __exit__(self, *raised): pass
        def close(self): pass
        def __next__(self):
            if not self: raise StopIteration
            return self.pop(0)
    os.listdir = lambda *given: listdir(*given)[::-1]
    os.scandir = lambda *given: Reversed(list(scandir(*given))[::-1])
from fieldspec.cli import main
sys.exit(main())
"""


def built(folder: Path, setting: Mapping[str, str]) -> dict[str, bytes]:
    """All outputs of a device, built in their own folder."""
    for device in DEVICES:
        shutil.copytree(SPECS / device, folder / "specs" / device)
    environment = {**os.environ, "FIELDSPEC_CACHE": str(folder / "cache"), **setting}
    done = subprocess.run(
        [sys.executable, "-c", RUN, "build"], cwd=folder, env=environment, capture_output=True, check=False
    )
    assert done.returncode == 0, done.stdout.decode() + done.stderr.decode()
    out = folder / "generated"
    return {path.relative_to(out).as_posix(): path.read_bytes() for path in out.rglob("*") if path.is_file()}


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    return built(tmp_path_factory.mktemp("a"), FIRST)


@pytest.mark.parametrize("name", TRIED)
def test_outputs_are_the_same_bytes(name: str, expected: dict[str, bytes], tmp_path: Path) -> None:
    outputs = built(tmp_path / "a longer name with blanks, ä", TRIED[name])
    assert sorted(outputs) == sorted(expected)
    assert [path for path in outputs if outputs[path] != expected[path]] == []


def test_the_same_names_are_allowed_to_differ_by_a_letter_whatever_the_hash_seed(tmp_path: Path) -> None:
    # The third name differs by a letter from each of the others.
    text = "Address,Name,Type\n1,overVoltag,u16\n2,verVoltage,u16\n3,overVoltage,u16\n"
    (tmp_path / "list.csv").write_text(text, "utf-8")
    command = [sys.executable, "-m", "fieldspec", "import", "list.csv", "--to", "-"]
    seeds = {seed: {**os.environ, "PYTHONHASHSEED": seed} for seed in map(str, range(1, 6))}
    runs = [subprocess.run(command, cwd=tmp_path, env=seed, capture_output=True, check=True) for seed in seeds.values()]
    assert len({run.stdout for run in runs}) == 1
