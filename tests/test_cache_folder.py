"""The cache removes nothing but its own files, and makes again what is not in the form that it has written."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from command_line import TEST_SPECS
from fieldspec.cli import main
from fieldspec.command.builds import freshness
from fieldspec.command.files import cache_folder, storage
from fieldspec.command.packages import plugins
from fieldspec.command.sources import layout_cache
from proofs import share

KINDS = ("builds", "devices", "plugins", "sound", "spellings", "templates")
SIGNATURE = "Signature: 8a477f597d28d172789f06886806bc55"
"""As https://bford.info/cachedir/ prints it."""


@pytest.fixture(autouse=True)
def fresh(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache_folder, "_refused", set())
    monkeypatch.setattr(cache_folder, "MOST", 2)
    monkeypatch.setattr(plugins, "_known", {})


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def show(device: str = "widget") -> None:
    assert main(["show", device, "--specs", str(TEST_SPECS)]) == 0


def build(out: Path, output: str = "vectors") -> None:
    freshness._at_start.clear()
    assert main(["build", "widget", "--to", output, "--specs", str(TEST_SPECS), "--out", str(out)]) == 0


def run_verbs(out: Path) -> None:
    """Runs verbs that write into each folder of the cache."""
    for device in ("widget", "gadget", "gizmo"):
        show(device)
    build(out, "python")


def letters(folder: Path) -> dict[Path, bytes]:
    """Files of a user in a folder, with names that no cache writes."""
    folder.mkdir(parents=True, exist_ok=True)
    names = ("device.html.j2", "letter.txt", "0" * 31, "g" * 32, "a b.new", "abc.new", f"{'0' * 32}.new.txt")
    for name in names:
        (folder / name).write_bytes(name.encode())
    return {folder / name: name.encode() for name in names}


def files(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_a_new_cache_carries_the_tag_that_backups_know(cache: Path, tmp_path: Path) -> None:
    run_verbs(tmp_path / "out")
    assert (cache / "CACHEDIR.TAG").read_text("utf-8").splitlines()[0] == SIGNATURE
    assert sorted(path.name for path in cache.iterdir() if path.is_dir()) == [*KINDS]


def test_a_project_that_is_named_as_the_cache_stays_as_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    project = tmp_path / "project"
    before = {path: text for kind in KINDS for path, text in letters(project / kind).items()}
    monkeypatch.chdir(project)
    monkeypatch.setenv("FIELDSPEC_CACHE", ".")
    run_verbs(tmp_path / "out")
    assert files(project) == before
    reason = "it has files and no CACHEDIR.TAG of fieldspec"
    text = f"fieldspec: nothing is cached in .: {reason}; set FIELDSPEC_CACHE to a folder that is empty or new\n"
    assert capsys.readouterr().err == text


def test_the_tag_of_another_program_is_not_that_of_the_cache(cache: Path, tmp_path: Path) -> None:
    cache.mkdir()
    (cache / "CACHEDIR.TAG").write_text(f"{SIGNATURE}\n# a folder of another program\n", "utf-8")
    before = letters(cache / "devices") | files(cache)
    run_verbs(tmp_path / "out")
    assert files(cache) == before


def test_a_folder_that_another_process_begins_at_the_same_time_is_used(
    cache: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lock = storage.lock

    def begun_by_another(path: str, patient: bool = True) -> int:
        if path == str(cache):
            monkeypatch.setattr(storage, "lock", lock)
            cache_folder.store("devices", "a", b"x")
        return lock(path, patient=patient)

    monkeypatch.setattr(storage, "lock", begun_by_another)
    cache_folder.store("devices", "b", b"y")
    assert capsys.readouterr().err == ""
    assert [cache_folder.cached("devices", name) for name in "ab"] == [b"x", b"y"]


@pytest.mark.proof(3)
@pytest.mark.parametrize("kind", KINDS)
def test_files_with_other_names_stay_where_they_are(kind: str, cache: Path, tmp_path: Path) -> None:
    run_verbs(tmp_path / "out")
    mine = letters(cache / kind)
    for number in range(5):
        cache_folder.store(kind, str(number), b"x")
    after = files(cache / kind)
    assert {path: after.get(path) for path in mine} == mine
    assert len(after.keys() - mine.keys()) == 2


def test_what_a_killed_process_has_left_is_removed(cache: Path) -> None:
    cache_folder.store("devices", "a", b"x")
    left = cache / "devices" / f"{'0' * 32}.new"
    left.write_bytes(b"half")
    cache_folder.store("devices", "b", b"x")
    assert not left.exists()


@pytest.mark.skipif(os.name != "posix", reason="this system has no such links")
@pytest.mark.parametrize("linked", ["", "/", *KINDS])
def test_a_link_is_refused(
    linked: str, cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any
) -> None:
    before = letters(tmp_path / "letters")
    if linked in KINDS:
        run_verbs(tmp_path / "out")
        shutil.rmtree(cache / linked)
        (cache / linked).symlink_to(tmp_path / "letters")
    else:
        cache.symlink_to(tmp_path / "letters")
        monkeypatch.setenv("FIELDSPEC_CACHE", f"{cache}{linked}")
    capsys.readouterr()
    for number in range(4):
        cache_folder.store(linked.strip("/") or "devices", str(number), b"x")
    assert files(tmp_path / "letters") == before
    (text,) = capsys.readouterr().err.splitlines()
    assert text.startswith(f"fieldspec: nothing is cached in {cache}")
    assert ": it is a link; " in text


@pytest.mark.skipif(os.name != "posix", reason="this system has no such owners")
def test_the_folder_of_another_user_is_refused(cache: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    cache.mkdir()
    monkeypatch.setattr(os, "geteuid", lambda: cache.stat().st_uid + 1)
    cache_folder.store("devices", "a", b"x")
    assert list(cache.iterdir()) == []
    assert "it belongs to another user" in capsys.readouterr().err


def test_the_cache_of_an_earlier_fieldspec_goes_on(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("FIELDSPEC_CACHE")
    for variable in ("HOME", "XDG_CACHE_HOME", "LOCALAPPDATA", "USERPROFILE"):
        monkeypatch.setenv(variable, str(tmp_path))
    folder = Path(cache_folder.folder())
    (folder / "devices").mkdir(parents=True)
    cache_folder.store("devices", "a", b"x")
    assert cache_folder.cached("devices", "a") == b"x"
    assert (folder / "CACHEDIR.TAG").is_file()


@pytest.mark.parametrize(
    ("platform", "variables", "place"),
    [
        ("linux", {}, "/people/a/.cache/fieldspec"),
        ("linux", {"XDG_CACHE_HOME": "/caches"}, "/caches/fieldspec"),
        ("win32", {}, "/people/a/AppData/Local/fieldspec/cache"),
        ("win32", {"LOCALAPPDATA": "/local"}, "/local/fieldspec/cache"),
        ("win32", {"FIELDSPEC_CACHE": "/cache/"}, "/cache"),
    ],
)
def test_the_folder_is_where_the_system_keeps_caches(
    platform: str, variables: dict[str, str], place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.platform", platform)
    for variable in ("FIELDSPEC_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(variable, raising=False)
    for variable, text in {"HOME": "/people/a", "USERPROFILE": "/people/a", **variables}.items():
        monkeypatch.setenv(variable, text)
    assert Path(cache_folder.folder()) == Path(place)


SHAPES = (
    b"",
    b"[]",
    b"{}",
    b"null",
    b"1",
    b'"a"',
    b"[[]]",
    b"[1]",
    b'[["a"]]',
    b'["abcde"]',
    b'[["a", "b", "c", "d", 5]]',
    b"\xff",
    b"[" * 100_000,
    b"[[],[]]",
    b'[["fieldspec.language.model.device:Device"],[]]\n[1]',
    b'[["fieldspec.language.model.nothing:Nothing"],[]]\n[1]',
    b'[["os:system"],[]]\n[1]',
)
CHANGES: dict[str, Callable[[Any], Any]] = {
    "specs": lambda data: {**data, "specs": [1]},
    "a hash": lambda data: {**data, "specs": {"a": 1}},
    "shared": lambda data: {**data, "shared": {"a": [1]}},
    "devices": lambda data: {**data, "devices": ["widget"]},
    "a device": lambda data: {**data, "devices": {"widget": 1}},
    "keys of a device": lambda data: {**data, "devices": {"widget": {"inputs": {}, "colour": 1}}},
    "outputs": lambda data: {**data, "devices": {"widget": {**data["devices"]["widget"], "outputs": {"c": 1}}}},
}


def spoil(cache: Path, kind: str, spoilt: Callable[[bytes], bytes]) -> dict[Path, bytes]:
    """Gives each entry of a folder another content with the right checksum; the contents before."""
    before = files(cache / kind)
    for path, content in before.items():
        other = spoilt(content.partition(b"\n")[2])
        path.write_bytes(cache_folder.checksum(other).encode() + b"\n" + other)
    assert before
    return before


@pytest.mark.proof
@pytest.mark.parametrize(
    ("kind", "verb"), [("builds", build), ("devices", lambda out: show()), ("plugins", build)], ids=["b", "d", "p"]
)
def test_an_entry_of_the_wrong_shape_is_made_again(
    kind: str, verb: Callable[[Path], None], cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any
) -> None:
    verb(tmp_path / "out")
    for shape in share(SHAPES, 3):
        before = spoil(cache, kind, lambda content, shape=shape: shape)  # type: ignore[misc]
        monkeypatch.setattr(plugins, "_known", {})
        verb(tmp_path / "out")
        assert files(cache / kind) == before, shape[:60]
    assert [line for line in capsys.readouterr().err.split("\n") if line and "is up to date" not in line] == []


def test_the_record_of_a_build_with_a_part_of_the_wrong_shape_is_made_again(cache: Path, tmp_path: Path) -> None:
    build(tmp_path / "out")
    for name, change in CHANGES.items():
        before = spoil(cache, "builds", lambda content, change=change: json.dumps(change(json.loads(content))).encode())  # type: ignore[misc]
        build(tmp_path / "out")
        assert files(cache / "builds") == before, name


def test_a_cached_device_of_which_any_line_was_changed_is_made_again(cache: Path) -> None:
    show()
    (content,) = files(cache / layout_cache.KIND).values()
    for line in range(2, content.count(b"\n"), 100):

        def changed(lines: bytes, line: int = line) -> bytes:
            parts = lines.split(b"\n")
            parts[line - 1] = b"[]"
            return b"\n".join(parts)

        before = spoil(cache, layout_cache.KIND, changed)
        show()
        assert files(cache / layout_cache.KIND) == before
