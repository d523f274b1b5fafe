"""The committed files under generated/ are the outputs of the specs."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from fieldspec.cli import main

ROOT = Path(__file__).resolve().parent.parent


def test_the_committed_outputs_are_fresh(capsys: pytest.CaptureFixture[str]) -> None:
    code = main(["build", "--check", "--specs", str(ROOT / "specs"), "--out", str(ROOT / "generated")])
    assert (code, capsys.readouterr().out) == (0, "everything is fresh\n")


def test_the_specs_of_all_devices_have_no_findings(capsys: pytest.CaptureFixture[str]) -> None:
    code = main(["check", "--specs", str(ROOT / "specs")])
    assert code == 0, capsys.readouterr().out


def test_no_file_lies_under_generated_that_the_manifest_does_not_list() -> None:
    manifest = json.loads((ROOT / "generated" / "manifest.json").read_text("utf-8"))
    paths = {
        path.relative_to(ROOT / "generated").as_posix() for path in (ROOT / "generated").rglob("*") if path.is_file()
    }
    extra = {path for path in paths if not path.endswith(".pyc")} - set(manifest["files"]) - {"manifest.json"}
    assert not extra


def test_a_version_that_is_not_committed_can_be_built(tmp_path: Path) -> None:
    path = "st/tc100_before_2_0.st"
    assert not (ROOT / "generated" / path).exists()
    options = ["--specs", str(ROOT / "specs"), "--out", str(tmp_path), "--to", "st,docs"]
    assert main(["build", "tc100@before-2.0", *options]) == 0
    assert (tmp_path / path).is_file()
    assert (tmp_path / "docs/tc100/before-2.0.html").is_file()


def test_the_committed_outputs_stay_small() -> None:
    paths = (path for path in (ROOT / "generated").rglob("*") if path.is_file() and path.suffix != ".pyc")
    assert sum(path.stat().st_size for path in paths) <= 38 << 20
