"""`build --watch` builds again at every save and keeps running when something is wrong."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from bounded import HANGING

SPECS = Path(__file__).resolve().parent / "specs"
WAITING = "waiting for a spec to change"


class Watch:
    """A build that watches a copy of a small spec."""

    def __init__(self, folder: Path) -> None:
        self.spec, self.out = folder / "specs/gizmo/device.yaml", folder / "out"
        shutil.copytree(SPECS / "gizmo", self.spec.parent)
        self.command = [
            sys.executable, "-m", "fieldspec.cli", "build", "--watch", "--to", "vectors,c",
            "--specs", str(folder / "specs"), "--out", str(self.out),
        ]  # fmt: skip
        self.process = subprocess.Popen(
            self.command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, encoding="utf-8"
        )

    def next_output(self) -> str:
        """The output up to the end of the next build."""
        assert self.process.stdout is not None
        lines = []
        for line in self.process.stdout:
            lines.append(line)
            if WAITING in line:
                return "".join(lines)
        raise AssertionError(f"it has ended: {''.join(lines)}")

    def save(self, text: str) -> None:
        """Saves the spec as editors do: beside it, then in its place."""
        beside = self.spec.with_name(".device.yaml.swp")
        beside.write_text(text, encoding="utf-8")
        os.replace(beside, self.spec)

    def texts(self) -> dict[str, bytes]:
        return {path.name: path.read_bytes() for path in self.out.rglob("*") if path.is_file()}


@pytest.fixture
def watch(tmp_path: Path) -> Iterator[Watch]:
    """A watch whose first build is done."""
    session = Watch(tmp_path)
    try:
        assert "built in" in session.next_output()
        yield session
    finally:
        session.process.kill()
        session.process.communicate()


def test_a_save_builds_again(watch: Watch) -> None:
    before = watch.texts()
    watch.save(watch.spec.read_text("utf-8").replace("name: Gizmo", "name: Gimmick"))
    assert "\nbuilt in" in watch.next_output()
    assert watch.texts() != before
    assert watch.texts().keys() == before.keys()


def test_a_broken_spec_shows_the_findings_and_keeps_the_outputs(watch: Watch) -> None:
    before, text = watch.texts(), watch.spec.read_text("utf-8")
    watch.save(text.replace("u16", "u17", 1))
    output = watch.next_output()
    assert "u17" in output
    assert "device.yaml:" in output
    assert "built without what has errors in" in output
    assert {**watch.texts(), "manifest.json": b""} == {**before, "manifest.json": b""}
    watch.save(text)
    assert "\nbuilt in" in watch.next_output()
    assert watch.texts() == before


def test_the_watch_waits_for_specs_that_are_gone(watch: Watch) -> None:
    text = watch.spec.read_text("utf-8")
    watch.spec.unlink()
    assert "contains no device" in watch.next_output()
    watch.save(text)
    assert "\nbuilt in" in watch.next_output()


@pytest.mark.skipif(sys.platform == "win32", reason="there is no such signal")
def test_an_interrupt_ends_the_watch(watch: Watch) -> None:
    watch.process.send_signal(signal.SIGINT)
    assert watch.process.wait(HANGING) == 130


def test_wrong_use_ends_the_watch_at_once(watch: Watch) -> None:
    ran = subprocess.run([*watch.command, "--to", "pascal"], capture_output=True, text=True, timeout=HANGING)
    assert ran.returncode == 2
    assert "there is no output pascal" in ran.stderr
