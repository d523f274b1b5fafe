"""A build makes only what is out of date, and what it reuses is equal to what it would make."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import ClassVar

import pytest

from fieldspec.cli import main
from fieldspec.command import pipeline
from fieldspec.command.builds import freshness, workers
from fieldspec.command.files import cache_folder

SPECS = Path(__file__).resolve().parent / "specs"
OUTPUTS = "vectors,c"
PROTOCOL = """
protocol: {id: words, title: Words, doc: A word that devices share.}
enums:
  - {name: shared_word, source: 1 L1, members: [{value: 0, name: off}, {value: 1, name: on}]}
"""
USE = "\nuses: [{protocol: words}]\n"


class Place:
    """A copy of made-up specs, a folder of outputs, and a note of which outputs of which devices are made.

    What the first build makes is the same in each test, and made once.
    """

    first: ClassVar[dict[str, dict[str, bytes]]] = {}

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.specs, self.out = folder / "specs", folder / "out"
        for name in ("gadget", "gizmo", "glider-x"):
            shutil.copytree(SPECS / name, self.specs / name)
        (self.specs / "protocols").mkdir()
        (self.specs / "protocols/words.yaml").write_text(PROTOCOL, encoding="utf-8")
        self.spec.write_text(self.spec.read_text("utf-8") + USE, encoding="utf-8")
        self.made: list[str] = []
        self.is_first = True
        self.devices = ["gadget", "gizmo", "glider-x"]
        output_stage = pipeline.output

        def noted(
            name: str, versions: list[pipeline.DeviceLayout], links: Sequence[pipeline.PageLink] = ()
        ) -> dict[str, bytes]:
            key = f"{versions[0].device.id} {name}"
            self.made.append(key)
            if not self.is_first:
                return output_stage(name, versions, links)
            if key not in self.first:
                self.first[key] = output_stage(name, versions, links)
            return self.first[key]

        monkeypatch.setattr(pipeline, "output", noted)
        monkeypatch.setattr(workers, "WORTH_IT", 10**9)  # within this process, where the notes are
        monkeypatch.setenv("FIELDSPEC_CACHE", str(folder / "cache"))

    def build(self, *more: str, to: str = OUTPUTS, out: Path | None = None) -> int:
        """Builds, with a fresh note, and a compiler that is looked at anew."""
        self.made.clear()
        freshness._at_start.clear()
        return main(["build", "--specs", str(self.specs), "--out", str(out or self.out), "--to", to, *more])

    def texts(self, out: Path | None = None) -> dict[str, bytes]:
        folder = out or self.out
        return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}

    def times(self) -> dict[Path, int]:
        return {path: path.stat().st_mtime_ns for path in self.out.rglob("*") if path.is_file()}

    def of(self, *devices: str, to: str = OUTPUTS) -> list[str]:
        return sorted(f"{device} {name}" for device in devices for name in to.split(","))

    def forgets(self, path: str) -> None:
        """Takes a file away, and out of the manifest."""
        (self.out / path).unlink()
        manifest = json.loads(self.manifest.read_text("utf-8"))
        del manifest["files"][path]
        self.manifest.write_text(json.dumps(manifest), encoding="utf-8")

    def wrote(self, path: str, content: bytes) -> None:
        """Puts a content into a file, as if it had been made like that."""
        (self.out / path).write_bytes(content)
        manifest = json.loads(self.manifest.read_text("utf-8"))
        manifest["files"][path] = freshness.digest(content)
        self.manifest.write_text(json.dumps(manifest), encoding="utf-8")

    @property
    def spec(self) -> Path:
        """A file of the first device."""
        return self.specs / "gadget" / "device.yaml"

    @property
    def manifest(self) -> Path:
        """What a build says of itself."""
        return self.out / "manifest.json"

    @property
    def record(self) -> Path:
        """The note of the last build."""
        (path,) = Path(cache_folder.folder(), freshness.KIND).iterdir()
        return path


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Place:
    """Specs that are built already."""
    workplace = Place(tmp_path, monkeypatch)
    assert workplace.build() == 0
    assert sorted(workplace.made) == workplace.of(*workplace.devices)
    workplace.is_first = False
    return workplace


def replaced(path: Path, old: str, new: str) -> None:
    text = path.read_text("utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")


def test_where_nothing_has_changed_nothing_is_made_or_written(
    place: Place, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    before = place.times()
    monkeypatch.delattr(pipeline, "findings")  # whoever checks a device, fails
    capsys.readouterr()
    assert place.build() == 0
    assert place.made == []
    assert place.times() == before
    assert " 0 written, 0 removed" in capsys.readouterr().out


def test_only_the_outputs_of_a_device_that_has_changed_are_made(place: Place) -> None:
    place.spec.write_text(place.spec.read_text("utf-8") + "# Another comment.\n", encoding="utf-8")
    before = place.times()
    assert place.build() == 0
    assert sorted(place.made) == place.of("gadget")
    after = place.times()
    assert [path for path in after if after[path] != before[path]] == [place.manifest]


def test_a_change_of_a_protocol_concerns_the_devices_that_use_it(place: Place) -> None:
    with (place.specs / "protocols/words.yaml").open("a", encoding="utf-8") as file:
        file.write("# Another comment.\n")
    assert place.build() == 0
    assert sorted(place.made) == place.of("gadget")


def test_a_new_file_and_a_removed_one_are_changes_of_a_device(place: Place) -> None:
    expected = place.texts()
    more = place.spec.with_name("more.yaml")
    more.write_text("enums:\n  - {name: more, source: 1 L1, members: [{value: 0, name: none}]}\n", encoding="utf-8")
    assert place.build() == 0
    assert sorted(place.made) == place.of("gadget")
    assert place.texts() != expected
    more.unlink()
    assert place.build() == 0
    assert sorted(place.made) == place.of("gadget")
    assert place.texts() == expected


def test_a_new_device_and_a_removed_one_concern_no_other(place: Place) -> None:
    expected = place.texts()
    shutil.rmtree(place.specs / "gizmo")
    assert place.build() == 0
    assert place.made == []
    assert not any("gizmo" in path for path in place.texts())
    shutil.copytree(SPECS / "gizmo", place.specs / "gizmo")
    assert place.build() == 0
    assert sorted(place.made) == place.of("gizmo")
    assert place.texts() == expected


def test_what_is_found_in_a_file_that_no_device_uses_fails_every_build(place: Place) -> None:
    (place.specs / "protocols/more.yaml").write_text("protocol: {id: other, title: A, doc: B.}\n", encoding="utf-8")
    for _ in range(2):
        assert place.build() == 1
        assert place.made == []


@pytest.mark.parametrize("spoil", [lambda path: path.unlink(), lambda path: path.write_bytes(b"changed by hand")])
def test_a_file_that_is_not_as_it_was_built_is_made_again(place: Place, spoil: Callable[[Path], None]) -> None:
    before = place.texts()
    path = min((place.out / "c").glob("gadget*.h"))
    spoil(path)
    assert place.build() == 0
    assert place.made == ["gadget c"]
    assert place.texts() == before


def test_with_another_compiler_everything_is_made(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache_folder, "identity", lambda: "another")
    assert place.build() == 0
    assert sorted(place.made) == place.of(*place.devices)
    assert place.build() == 0
    assert place.made == []


def test_a_compiler_that_changes_while_it_runs_notes_nothing(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    before = place.record.read_bytes()
    turns = iter(range(100))
    monkeypatch.setattr(cache_folder, "state", lambda parts: str(next(turns)))
    replaced(place.spec, "name: Gadget", "name: Gidget")
    assert place.build() == 0
    assert sorted(place.made) == place.of("gadget")
    assert place.record.read_bytes() == before


def test_the_compiler_is_every_file_of_it_and_its_libraries(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    names = {Path(path).name for path in cache_folder._files(cache_folder._PACKAGE)}
    assert {"cli.py", "page.html.j2", "page.css", "spec.schema.json", "_frames.py"} <= names
    assert not any(name.endswith(".pyc") for name in names)
    assert all("info" in cache_folder._version(*library) for library in cache_folder.LIBRARIES.items())
    first = cache_folder.identity()
    monkeypatch.setattr(cache_folder, "_version", lambda module, distribution: "2.0")
    assert cache_folder.identity() != first


@pytest.mark.proof(2)
@pytest.mark.parametrize(
    "spoilt",
    [
        lambda text: b"",
        lambda text: text[: len(text) // 2],
        lambda text: text.replace(b'"warned":false', b'"warned":true', 1),
        lambda text: b"\xff\xfe" + text,
        lambda text: b"{}",
    ],
    ids=["empty", "half written", "changed by hand", "not text", "another form"],
)
def test_a_note_that_is_not_whole_is_as_none(place: Place, spoilt: Callable[[bytes], bytes]) -> None:
    before = place.texts()
    place.record.write_bytes(spoilt(place.record.read_bytes()))
    assert place.build() == 0
    assert sorted(place.made) == place.of(*place.devices)
    assert place.texts() == before


@pytest.mark.parametrize("text", ["", '{"files": {', "[]", '{"files": {}, "identities": {}}'])
def test_a_manifest_that_is_not_whole_is_written_again(place: Place, text: str) -> None:
    before = place.texts()
    (place.out / "manifest.json").write_text(text, encoding="utf-8")
    assert place.build() == 0
    assert place.made == []
    assert place.texts() == before


def test_another_output_is_made_beside_those_that_are_fresh(place: Place) -> None:
    assert place.build(to="vectors,c,python") == 0
    assert sorted(place.made) == place.of(*place.devices, to="python")
    assert place.build(to="vectors") == 0
    assert place.made == []
    assert place.build(to="vectors,c,python") == 0
    assert place.made == []


def test_another_folder_has_a_note_of_its_own(place: Place, tmp_path: Path) -> None:
    other = tmp_path / "other"
    assert place.build(out=other) == 0
    assert sorted(place.made) == place.of(*place.devices)
    assert place.texts(other) == place.texts()


def test_outputs_do_not_depend_on_where_the_specs_lie(
    place: Place, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert place.build(to="docs,vectors,c") == 0
    monkeypatch.chdir(place.specs.parent)
    assert place.build("--no-cache", to="docs,vectors,c", out=tmp_path / "here") == 0
    assert place.texts(tmp_path / "here") == place.texts()


def test_one_device_is_built_without_the_others(place: Place) -> None:
    first, second = place.devices[:2]
    for device in (first, second):
        with (place.specs / device / "device.yaml").open("a", encoding="utf-8") as file:
            file.write("# Another comment.\n")
    assert place.build(first) == 0
    assert sorted(place.made) == place.of(first)
    assert place.build() == 0
    assert sorted(place.made) == place.of(second)


def test_one_version_is_always_made_and_nothing_is_noted(place: Place) -> None:
    before = place.texts()
    assert place.build("gizmo@1") == 0
    assert sorted(place.made) == place.of("gizmo")
    assert place.build() == 0
    assert place.texts() == before


@pytest.mark.parametrize("option", ["--check", "--no-cache"])
def test_a_check_and_a_build_without_the_cache_do_all_the_work(place: Place, option: str) -> None:
    assert place.build(option) == 0
    assert sorted(place.made) == place.of(*place.devices)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda place: replaced(place.spec, "name: Gadget", "name: Gidget"), "changed: gadget/device.yaml"),
        (
            lambda place: replaced(place.specs / "protocols/words.yaml", "name: on", "name: up"),
            "changed: protocols/words.yaml",
        ),
        (lambda place: (place.out / "c/gadget.h").unlink(), "it is missing"),
        (lambda place: (place.out / "c/gadget.h").write_text("other", "utf-8"), "it was edited"),
        (lambda place: place.forgets("c/gadget.h"), "it is new"),
        (lambda place: place.wrote("c/gadget.h", b"by another compiler"), "another version of the compiler wrote it"),
    ],
    ids=["spec", "protocol", "missing", "changed", "new", "compiler"],
)
def test_a_check_says_why_a_file_is_not_fresh(
    place: Place, capsys: pytest.CaptureFixture[str], change: Callable[[Place], object], reason: str
) -> None:
    change(place)
    capsys.readouterr()
    assert place.build("--check") == 1
    assert f"not fresh: c/gadget.h ({reason})\n" in capsys.readouterr().out


def test_the_manifest_of_a_part_does_not_speak_for_the_rest(place: Place, capsys: pytest.CaptureFixture[str]) -> None:
    replaced(place.spec, "name: Gadget", "name: Gidget")
    assert place.build(to="vectors") == 0
    capsys.readouterr()
    assert place.build("--check") == 1
    assert "not fresh: c/gadget.h (changed: gadget/device.yaml)\n" in capsys.readouterr().out


def test_after_findings_the_old_note_holds_for_the_old_specs(place: Place) -> None:
    whole = place.spec.read_bytes()
    replaced(place.spec, "device:", "devise:")
    before = place.texts()
    assert place.build() == 1
    assert place.made == []
    assert place.texts() != before, "the manifest says what is stale"
    place.spec.write_bytes(whole)
    assert place.build() == 0
    assert place.made == []
    assert place.texts() == before


@pytest.mark.parametrize("option", ["--check", "--no-cache"])
def test_nothing_is_left_of_a_device_that_is_not_written(place: Place, tmp_path: Path, option: str) -> None:
    replaced(place.spec, "unit: mm", "unit: rev")  # which an example contradicts
    assert place.build(option, "gadget", out=tmp_path / "new" / "out") == 1
    assert not (tmp_path / "new").exists()
    before = sorted(place.out.rglob("*"))
    assert place.build(option) == 1
    assert "glider-x c" in place.made
    assert sorted(place.out.rglob("*")) == before


def test_without_a_folder_to_keep_notes_in_all_is_made(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FIELDSPEC_CACHE", str(place.spec / "no folder"))
    for _ in range(2):
        assert place.build() == 0
        assert sorted(place.made) == place.of(*place.devices)


def test_processes_make_what_one_makes(place: Place, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "WORTH_IT", 0)
    monkeypatch.setattr(workers, "_processors", lambda: 3)
    assert place.build("--no-cache", out=tmp_path / "all") == 0
    assert place.texts(tmp_path / "all") == place.texts()
    for device in place.devices:
        assert place.build("--no-cache", device, out=tmp_path / "each") == 0
    shared = {path: text for path, text in place.texts(tmp_path / "each").items() if path != "manifest.json"}
    assert shared.items() <= place.texts().items()
    replaced(place.spec, "device:", "devise:")
    assert place.build() == 1


def test_caches_are_data_that_nobody_executes(place: Place) -> None:
    digest, _, text = place.record.read_bytes().partition(b"\n")
    assert cache_folder.checksum(text).encode() == digest
    assert json.loads(text)["compiler"] == cache_folder.identity()
    assert oct(place.record.stat().st_mode & 0o177) == "0o0"


def test_only_the_newest_notes_are_kept(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache_folder, "MOST", 3)
    for number in range(5):
        cache_folder.store("test", str(number), b"%d" % number)
        os.utime(cache_folder._path("test", str(number)), ns=(number, number))
    assert [cache_folder.cached("test", str(number)) for number in range(5)] == [None, None, b"2", b"3", b"4"]
