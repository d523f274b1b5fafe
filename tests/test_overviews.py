"""The index of all devices follows the devices that are built."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from command_line import SPECS, TEST_SPECS
from fieldspec.cli import main


def test_the_index_has_the_devices_that_are_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    specs, out = tmp_path / "specs", tmp_path / "out"
    for name in ("gadget", "gizmo"):
        shutil.copytree(TEST_SPECS / name, specs / name)
    shutil.copytree(SPECS / "protocols", specs / "protocols")
    index = out / "docs/index.html"

    def build(*arguments: str) -> int:
        return main(["build", *arguments, "--to", "docs", "--specs", str(specs), "--out", str(out)])

    def devices() -> list[str]:
        text = index.read_text("utf-8")
        return [name for name in ("gadget", "gizmo") if f'href="{name}/index.html"' in text]

    assert (build("gadget"), devices()) == (0, ["gadget"])
    assert (build("gizmo"), devices()) == (0, ["gadget", "gizmo"])
    assert build("--check") == 0, capsys.readouterr().out
    index.write_text("edited", encoding="utf-8")
    capsys.readouterr()
    assert build("--check") == 1
    assert "not fresh: docs/index.html (it was edited)" in capsys.readouterr().out
    assert (build(), devices()) == (0, ["gadget", "gizmo"])
    shutil.rmtree(specs / "gizmo")
    assert (build(), devices()) == (0, ["gadget"])
    assert build("--check") == 0
