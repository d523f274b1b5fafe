"""The unit of all or none is the device: one with errors keeps its files, and the others are written."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from fieldspec.cli import main
from fieldspec.command.builds import workers

SPECS = Path(__file__).resolve().parent / "specs"
ESCAPED = "counter"
"""A device that dissectors and controllers cannot express."""
ERRORS = {
    "reading": ("name: Gizmo", "naem: Gizmo"),
    "checks": ("type: i16, unit: rpm", "type: i16, range: 0..70000, unit: rpm"),
    "identifier": ("id: gizmo", "id: gadget"),
}
"""Errors that are found while the files are read, and by a check, and one that takes the name of another device."""
PROTOCOL = """
protocol: {id: words, title: Words, doc: A word that devices share.}
enums:
  - {name: shared_word, source: 1 L1, members: [{value: 0, name: off}, {value: 1, name: on}]}
"""
USE = "\nuses: [{protocol: words}]\n"


class Bench:
    """A copy of made-up devices, and a folder of outputs."""

    def __init__(self, folder: Path, *devices: str) -> None:
        self.specs, self.out = folder / "specs", folder / "out"
        for device in devices:
            shutil.copytree(SPECS / device, self.specs / device)
        self.folder = folder

    def build(self, *more: str) -> int:
        return main(["build", "--specs", str(self.specs), "--out", str(self.out), *more])

    def device(self, name: str) -> Path:
        return self.specs / name / "device.yaml"

    def replace(self, name: str, old: str, new: str) -> None:
        text = self.device(name).read_text("utf-8")
        assert old in text
        self.device(name).write_text(text.replace(old, new, 1), encoding="utf-8")

    def add(self, name: str, text: str) -> None:
        with self.device(name).open("a", encoding="utf-8") as file:
            file.write(text)

    def texts(self, part: str = "") -> dict[str, bytes]:
        """The files of outputs whose paths have a part, without the manifest."""
        return {
            path.relative_to(self.out).as_posix(): path.read_bytes()
            for path in self.out.rglob("*")
            if path.is_file() and path.name != "manifest.json" and part in path.as_posix().removeprefix(str(self.out))
        }

    @property
    def manifest(self) -> dict[str, Any]:
        data: dict[str, Any] = json.loads((self.out / "manifest.json").read_text("utf-8"))
        return data


@pytest.fixture(params=["one process", "several processes"])
def bench(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Bench:
    """Two devices, built by this process alone, or by more processes than there are devices."""
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    if request.param == "several processes":
        monkeypatch.setattr(workers, "WORTH_IT", 0)
        monkeypatch.setattr(workers, "_processors", lambda: 3)
    return Bench(tmp_path, "gadget", "gizmo")


@pytest.mark.proof(3)
@pytest.mark.parametrize("error", ERRORS)
def test_a_device_with_an_error_keeps_its_files_and_the_others_are_written(
    bench: Bench, error: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert bench.build("--to", "vectors,c") == 0
    before = bench.texts("gizmo")
    bench.replace("gizmo", *ERRORS[error])
    bench.replace("gadget", "name: Gadget", "name: Gidget")
    capsys.readouterr()
    for _ in range(2):
        assert bench.build("--to", "vectors,c") == 1
        captured = capsys.readouterr()
        assert "error[" in captured.out
        assert "the files of gizmo stay as they are, and the manifest lists them as stale" in captured.err
        assert bench.texts("gizmo") == before
        assert all(b"Gidget" in text for path, text in bench.texts("gadget").items() if path.endswith(".h"))
        assert bench.manifest["stale"] == sorted(before)


def test_files_are_stale_until_their_device_is_built_again(bench: Bench) -> None:
    assert bench.build("--to", "vectors,c") == 0
    built = bench.manifest
    bench.replace("gizmo", *ERRORS["checks"])
    assert bench.build("--to", "vectors,c") == 1
    assert bench.manifest == {**built, "stale": sorted(bench.texts("gizmo"))}
    bench.replace("gizmo", *reversed(ERRORS["checks"]))
    assert bench.build("--to", "vectors") == 0
    assert bench.manifest["stale"] == sorted(bench.texts("c/gizmo"))
    assert bench.build("--to", "vectors,c") == 0
    assert bench.manifest == built


def test_a_check_lists_the_files_of_a_device_with_errors(bench: Bench, capsys: pytest.CaptureFixture[str]) -> None:
    assert bench.build("--to", "vectors") == 0
    bench.replace("gizmo", *ERRORS["checks"])
    before = bench.texts()
    capsys.readouterr()
    assert bench.build("--to", "vectors", "--check") == 1
    out = capsys.readouterr().out
    assert "not fresh: vectors/gizmo.json (its spec has errors)\n" in out
    assert "gadget" not in out.partition("error")[0]
    assert bench.texts() == before


def test_where_no_device_is_right_nothing_is_written(bench: Bench, capsys: pytest.CaptureFixture[str]) -> None:
    bench.replace("gizmo", *ERRORS["checks"])
    assert bench.build("gizmo", "--to", "vectors,python") == 1
    assert "fieldspec: nothing is written\n" in capsys.readouterr().err
    assert not bench.out.exists()


@pytest.mark.parametrize(("old", "new"), [("value: 1", "value: 0"), ("title: Words", "titel: Words")])
def test_an_error_in_a_protocol_concerns_the_devices_that_use_it(bench: Bench, old: str, new: str) -> None:
    (bench.specs / "protocols").mkdir()
    protocol = bench.specs / "protocols/words.yaml"
    protocol.write_text(PROTOCOL, encoding="utf-8")
    bench.add("gadget", USE)
    assert bench.build("--to", "c") == 0
    protocol.write_text(PROTOCOL.replace(old, new), encoding="utf-8")
    bench.replace("gizmo", "name: Gizmo", "name: Gimmick")
    assert bench.build("--to", "c") == 1
    assert bench.manifest["stale"] == sorted(bench.texts("c/gadget"))
    assert b"Gimmick" in bench.texts()["c/gizmo.h"]


def test_an_error_in_a_protocol_that_no_device_uses_stops_none(bench: Bench) -> None:
    (bench.specs / "protocols").mkdir()
    (bench.specs / "protocols/words.yaml").write_text("protocol: {id: other, title: A, doc: B.}\n", encoding="utf-8")
    assert bench.build("--to", "vectors") == 1
    assert bench.texts().keys() == {"vectors/gadget.json", "vectors/gizmo.json"}
    assert "stale" not in bench.manifest


def test_of_two_devices_whose_names_are_one_in_code_neither_is_written(bench: Bench) -> None:
    for name in ("twin-a", "twin_a"):
        shutil.copytree(SPECS / "gizmo", bench.specs / name)
        bench.replace(name, "id: gizmo", f"id: {name}")
    assert bench.build("--to", "vectors") == 1
    assert bench.texts().keys() == {"vectors/gadget.json", "vectors/gizmo.json"}


def test_the_index_of_all_devices_keeps_one_with_errors(bench: Bench) -> None:
    assert bench.build("--to", "docs") == 0
    before = bench.texts("docs/README.md")
    bench.replace("gizmo", *ERRORS["checks"])
    bench.add("gadget", "# A comment.\n")
    assert bench.build("--to", "docs") == 1
    assert bench.texts("docs/README.md") == before


def test_an_index_of_a_manual_that_cannot_be_read_concerns_its_device(
    bench: Bench, capsys: pytest.CaptureFixture[str]
) -> None:
    (bench.specs / "gizmo/manual.index").write_bytes(b"\xff")
    assert bench.build("--to", "docs") == 1
    assert "cannot read gizmo/manual.index: it is not UTF-8" in capsys.readouterr().err
    assert bench.texts("docs/gadget")
    assert not bench.texts("docs/gizmo")


def test_files_of_a_removed_device_go_while_another_one_has_errors(bench: Bench) -> None:
    assert bench.build("--to", "vectors") == 0
    shutil.rmtree(bench.specs / "gadget")
    bench.replace("gizmo", *ERRORS["checks"])
    assert bench.build("--to", "vectors") == 1
    assert bench.texts().keys() == {"vectors/gizmo.json"}


def test_an_output_that_cannot_express_a_device_is_left_out_with_one_warning(
    bench: Bench, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(SPECS / ESCAPED, bench.specs / ESCAPED)
    for _ in range(2):
        assert bench.build("--to", "vectors") == 0
        capsys.readouterr()
        assert bench.build() == 0
        out = capsys.readouterr().out
        assert "error[" not in out
        left_out = [line for line in out.splitlines() if f"left out for {ESCAPED}" in line]
        assert (
            len(left_out)
            == len(set(left_out))
            == out.count("warning[wireshark_frames_unescaped]") + out.count("warning[plc_frames_supported]")
        )
        outputs = {folder.name for folder in bench.out.iterdir() if [*folder.rglob(f"*{ESCAPED}*")]}
        assert not outputs & {"wireshark", "st", "scl", "iec", "plcopen", "twincat"}
        assert {"python", "c", "js", "docs", "vectors"} <= outputs
        assert bench.texts("st/gizmo")


def test_an_output_that_is_named_must_express_the_device(bench: Bench, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copytree(SPECS / ESCAPED, bench.specs / ESCAPED)
    assert bench.build("--to", "vectors,st") == 1
    captured = capsys.readouterr()
    assert "error[plc_frames_supported]" in captured.out
    assert bench.texts(ESCAPED) == {}
    assert bench.texts("st/gizmo")
