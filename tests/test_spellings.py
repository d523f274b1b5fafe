"""How facts are spelled in each output is asked once: by whoever builds the output, or else by the documentation."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.command.builds import freshness, spelling_cache, workers
from fieldspec.command.files import cache_folder

SPECS = Path(__file__).resolve().parent / "specs"
DEVICE = "gizmo"
SPELLING = {
    "c": ("fieldspec.targets.c.backend", "declare_register"),
    "js": ("fieldspec.targets.js.module", "declare_register"),
    "python": ("fieldspec.targets.python.registers", "register_view"),
}
"""What is called once for each register where an output decides on its names."""


class Place:
    """A copy of a small spec, and how often each output was asked for the names of its registers."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.specs, self.out = folder / "specs", folder / "out"
        shutil.copytree(SPECS / DEVICE, self.specs / DEVICE)
        self.asked: Counter[str] = Counter()
        for output, (module, function) in SPELLING.items():
            self._count(monkeypatch, output, import_module(module), function)
        monkeypatch.setattr(workers, "WORTH_IT", 10**9)  # within this process, where the counts are
        monkeypatch.setenv("FIELDSPEC_CACHE", str(folder / "cache"))

    def _count(self, monkeypatch: pytest.MonkeyPatch, output: str, module: Any, function: str) -> None:
        original: Callable[..., object] = getattr(module, function)

        def noted(*arguments: object) -> object:
            self.asked[output] += 1
            return original(*arguments)

        monkeypatch.setattr(module, function, noted)

    def build(self, to: str, *more: str, out: str = "out") -> dict[str, bytes]:
        """Builds, counting anew, and returns what is in the folder."""
        self.asked.clear()
        freshness._at_start.clear()
        folder = self.out.with_name(out)
        assert main(["build", "--specs", str(self.specs), "--out", str(folder), "--to", to, *more]) == 0
        return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    @property
    def spec(self) -> Path:
        """The main file of the device."""
        return self.specs / DEVICE / "device.yaml"

    @property
    def entries(self) -> list[Path]:
        """The files of the cache with spellings."""
        return [*Path(cache_folder.folder(), spelling_cache.KIND).iterdir()]


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Place:
    return Place(tmp_path, monkeypatch)


def docs(texts: dict[str, bytes]) -> dict[str, bytes]:
    return {path: text for path, text in texts.items() if path.startswith("docs/")}


@pytest.mark.parametrize("output", SPELLING)
def test_an_output_that_is_built_beside_the_documentation_is_asked_once(place: Place, output: str) -> None:
    place.build(output)
    alone = place.asked[output]
    assert alone
    place.build(f"{output},docs", "--no-cache")
    assert place.asked[output] == alone


def test_the_documentation_asks_no_output_that_was_built_before(place: Place) -> None:
    place.build(",".join(SPELLING))
    place.build("docs")
    assert place.asked == {}


def test_the_documentation_that_is_built_again_asks_no_output(place: Place) -> None:
    place.build("docs")
    shutil.rmtree(place.out)
    place.build("docs")
    assert place.asked == {}


def test_spellings_that_were_kept_give_the_same_documentation(place: Place) -> None:
    place.build(",".join(SPELLING))
    cached = place.build("docs", out="cached")
    assert docs(cached) == docs(place.build("docs", "--no-cache", out="anew"))


def test_spellings_of_another_spec_are_not_used(place: Place) -> None:
    place.build(",".join(SPELLING))
    place.spec.write_text(place.spec.read_text("utf-8").replace("name: speed", "name: velocity"), encoding="utf-8")
    cached = place.build("docs", out="cached")
    assert docs(cached) == docs(place.build("docs", "--no-cache", out="anew"))


WRONG_ENTRIES = (
    b"",
    b"[]",
    b"{}",
    b"[[], 1]",
    b'[[], {"1.0": 3}]',
    b'[["t"], {"1.0": [["a", 1]]}]',
    b'[[3], {"1.0": [["a", 0]]}]',
    b"\xff",
)


@pytest.mark.parametrize("content", WRONG_ENTRIES)
def test_an_entry_of_another_shape_is_made_again(place: Place, content: bytes) -> None:
    place.build(",".join(SPELLING))
    for path in place.entries:
        path.write_bytes(cache_folder.checksum(content).encode() + b"\n" + content)
    cached = place.build("docs", out="cached")
    assert docs(cached) == docs(place.build("docs", "--no-cache", out="anew"))


def test_without_a_cache_nothing_is_kept(place: Place) -> None:
    place.build("c,docs", "--no-cache")
    assert not Path(cache_folder.folder(), spelling_cache.KIND).exists()
