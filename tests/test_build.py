"""Building: all or nothing of each device, only what changed, and nothing lost when it fails."""

from __future__ import annotations

import json
import os
import shutil
import time
from pathlib import Path

import pytest

from fieldspec.cli import main
from fieldspec.command.builds import freshness

SPECS = Path(__file__).resolve().parent.parent / "specs"


@pytest.fixture
def specs(tmp_path: Path) -> Path:
    """A copy of the specs of two devices that a test may change."""
    for name in ("esc11", "protocols", "tc100"):
        shutil.copytree(SPECS / name, tmp_path / "specs" / name)
    return tmp_path / "specs"


def build(specs: Path, out: Path, *more: str) -> int:
    return main(["build", "--specs", str(specs), "--out", str(out), *more])


def texts(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_a_build_writes_what_the_manifest_lists(specs: Path, tmp_path: Path) -> None:
    assert build(specs, tmp_path / "out", "--to", "vectors,c") == 0
    manifest = json.loads((tmp_path / "out/manifest.json").read_text("utf-8"))
    assert set(manifest["files"]) == set(texts(tmp_path / "out")) - {"manifest.json"}
    assert {"esc11@1.17", "tc100@2.0"} <= set(manifest["identities"])


def test_a_second_build_rewrites_nothing(specs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    build(specs, tmp_path / "out", "--to", "vectors")
    before = {path: path.stat().st_mtime_ns for path in (tmp_path / "out/vectors").iterdir()}
    capsys.readouterr()
    assert build(specs, tmp_path / "out", "--to", "vectors") == 0
    assert " 0 written" in capsys.readouterr().out
    assert before == {path: path.stat().st_mtime_ns for path in (tmp_path / "out/vectors").iterdir()}


def test_a_spec_with_findings_leaves_the_old_outputs(specs: Path, tmp_path: Path) -> None:
    build(specs, tmp_path / "out", "--to", "vectors")
    before = texts(tmp_path / "out/vectors")
    points = specs / "esc11/points.yaml"
    points.write_text(points.read_text("utf-8").replace("type: u8", "type: u9", 1), encoding="utf-8")
    assert build(specs, tmp_path / "out", "--to", "vectors") == 1
    assert texts(tmp_path / "out/vectors") == before


def test_a_folder_in_place_of_a_file_is_reported_and_nothing_changes(
    specs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    build(specs, out, "--to", "vectors", "esc11")
    before = texts(out)
    (out / "vectors/tc100.json/in-the-way").mkdir(parents=True)
    assert build(specs, out, "--to", "vectors") in (0, 2)
    if capsys.readouterr().err:
        assert texts(out) == before


def test_a_file_in_place_of_the_folder_is_wrong_use(
    specs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "out").write_text("not a folder", encoding="utf-8")
    assert build(specs, tmp_path / "out", "--to", "vectors") == 2
    assert "nothing was changed" in capsys.readouterr().err
    assert (tmp_path / "out").read_text("utf-8") == "not a folder"


def test_check_lists_the_files_that_are_not_fresh_and_writes_nothing(
    specs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    build(specs, tmp_path / "out", "--to", "vectors")
    (tmp_path / "out/vectors/esc11.json").write_text("changed by hand", encoding="utf-8")
    before = texts(tmp_path / "out")
    capsys.readouterr()
    assert build(specs, tmp_path / "out", "--to", "vectors", "--check") == 1
    assert "not fresh: vectors/esc11.json" in capsys.readouterr().out
    assert texts(tmp_path / "out") == before


def test_a_file_that_is_no_longer_produced_is_removed(specs: Path, tmp_path: Path) -> None:
    build(specs, tmp_path / "out", "--to", "vectors")
    shutil.rmtree(specs / "tc100")
    (tmp_path / "out/vectors/mine.txt").write_text("a file of somebody else", encoding="utf-8")
    assert build(specs, tmp_path / "out", "--to", "vectors") == 0
    left = {path.name for path in (tmp_path / "out/vectors").iterdir()}
    assert "tc100.json" not in left
    assert {"esc11.json", "mine.txt"} <= left


def test_one_version_of_one_device_can_be_built(specs: Path, tmp_path: Path) -> None:
    assert build(specs, tmp_path / "out", "--to", "c", "tc100@2.0") == 0
    ends = (".h", "_constants.h", "_fuzz.c", "_selftest.c")
    names = ["c/tc100.h", *(f"c/tc100_v2_0{end}" for end in ends), "manifest.json"]
    assert sorted(texts(tmp_path / "out")) == names


@pytest.mark.parametrize("arguments", [["--to", "pascal"], ["--to", ""], ["no_such_device"], ["tc100@9.9"]])
def test_an_unknown_device_version_or_output_is_wrong_use(arguments: list[str], specs: Path, tmp_path: Path) -> None:
    assert build(specs, tmp_path / "out", *arguments) == 2
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("settled", [freshness._SETTLED, -1])
def test_a_file_of_the_same_size_and_date_is_hashed_again_when_it_has_changed(
    settled: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(freshness, "_SETTLED", settled)
    path = tmp_path / "file"
    path.write_text("before", encoding="utf-8")
    status = path.stat()
    assert freshness.file_digest(tmp_path, "file") == freshness.digest(b"before")
    time.sleep(0.05)  # the clock of files is coarse
    path.write_text("behind", encoding="utf-8")
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))
    assert freshness.file_digest(tmp_path, "file") == freshness.digest(b"behind")


def test_a_file_that_has_not_changed_for_long_is_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("text", encoding="utf-8")
    monkeypatch.setattr(freshness, "_SETTLED", -1)
    hashed = freshness.file_digest(tmp_path, "file")
    monkeypatch.delattr(freshness, "content")  # whoever reads a file, fails
    assert freshness.file_digest(tmp_path, "file") == hashed
