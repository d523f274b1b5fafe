"""Compiled devices are cached from one call to the next, and agree with the specs."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from enum import Enum
from pathlib import Path
from typing import Any

import pytest

from command_line import SPECS, TEST_SPECS
from fieldspec.cli import main
from fieldspec.command.files import cache_folder
from fieldspec.command.sources import layout_cache, spec_files
from fieldspec.command.sources.specs import layout_of
from fieldspec.foundation.classes import attributes, replace
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.checks.layout_conditions import LAYOUT_CONDITIONS
from fieldspec.language.model.attributes import descendants
from fieldspec.language.model.fact import Citation, Claim, Place
from fieldspec.language.reading import project
from layouts import newest

NOWHERE = Span(SourceFile("x", ""), 0, 0)
BROKEN = sorted(
    file.parent
    for check in (*LAYOUT_CONDITIONS, "lengths_hold", "bits_match_range", "sources_present")
    for file in Path(__file__).parent.joinpath("cases", check).glob("failing*/device.yaml")
)
DEVICES = [(folder, device) for folder in (SPECS, TEST_SPECS) for device in spec_files.devices(folder)]


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of compiled devices."""
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache" / layout_cache.KIND


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Specs that a test may change."""
    shutil.copytree(TEST_SPECS, tmp_path / "specs")
    return tmp_path / "specs"


def show(folder: Path, *options: str) -> int:
    return main(["show", "widget", "--specs", str(folder), *options])


def unread(monkeypatch: pytest.MonkeyPatch) -> None:
    """From here on, no spec can be read."""

    def read(*arguments: object) -> None:
        raise AssertionError("a spec is read")

    monkeypatch.setattr(project, "read", read)


def alike(left: Any, other: Any, met: set[tuple[int, int]]) -> bool:
    """Whether two objects are of the same class and have equal contents, at any depth."""
    if left is other or (id(left), id(other)) in met:
        return True
    met.add((id(left), id(other)))
    if isinstance(left, (tuple, list)) and type(left) is type(other):
        return len(left) == len(other) and all(alike(*pair, met) for pair in zip(left, other, strict=True))
    if isinstance(left, dict):
        return list(left) == list(other) and all(alike(left[key], other[key], met) for key in left)
    if isinstance(left, SourceFile):
        return (left.path, left.text) == (other.path, other.text)
    if isinstance(left, Place) and isinstance(other, Place):  # of what was read, it is told where it stands
        return alike((left.path, left.whole, left.spans), (other.path, other.whole, other.spans), set())
    if hasattr(type(left), "_fields") and not isinstance(left, Enum):
        values = [(getattr(left, name), getattr(other, name)) for name in attributes(type(left))]
        return type(left) is type(other) and all(alike(*pair, met) for pair in values)
    return type(left) is type(other) and bool(left == other)


@pytest.mark.proof(6)
@pytest.mark.parametrize(("folder", "device"), DEVICES, ids=[device for _, device in DEVICES])
def test_a_layout_read_from_the_cache_is_equal_to_the_original(folder: Path, device: str) -> None:
    files = spec_files.files(SPECS, frozenset([device])) | spec_files.files(folder, frozenset([device]))
    spec = project.read(files, frozenset([device])).devices[device]
    for version in {spec.versions()[0], spec.versions()[-1]}:
        layout = layout_of(spec, version)
        thawed = layout_cache.from_json(
            layout_cache.to_json(layout), lambda path: SourceFile(path, files[path].decode())
        )
        assert alike(thawed, layout, set())


def test_a_device_from_the_cache_is_walked_as_the_original(cache: Path) -> None:
    device = layout_cache.layout(str(TEST_SPECS), "wattmeter").device
    original = newest(TEST_SPECS, "wattmeter").device
    assert [item.__class__ for item in descendants(device)] == [type(item) for item in descendants(original)]


def test_an_object_that_is_not_yet_unpacked_is_equal_to_another_and_has_the_same_hash() -> None:
    citations = [(3, 17), (4, 20)]
    original = [Citation("8.2", (lines,)) for lines in citations]
    content = layout_cache.to_json(Claim(Place("x", NOWHERE, {}), tuple(original), {}))

    def new() -> tuple[Citation, ...]:
        citations: tuple[Citation, ...] = layout_cache.from_json(content, lambda path: NOWHERE.file).sources
        return citations

    assert new()[0] == original[0]
    assert original[0] == new()[0]
    assert new()[0] == new()[0] != new()[1]
    assert [*map(hash, new())] == [*map(hash, original)]
    assert replace(new()[0], section="9") == Citation("9", ((3, 17),))
    assert repr(new()[0]) == repr(original[0])
    with pytest.raises(AttributeError, match="Citation has no attribute colour"):
        _ = new()[0].colour  # type: ignore[attr-defined]


def test_the_second_call_reads_no_spec(cache: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    assert show(TEST_SPECS) == 0
    first = capsys.readouterr().out
    unread(monkeypatch)
    assert show(TEST_SPECS) == 0
    assert capsys.readouterr().out == first
    assert len(list(cache.iterdir())) == 1


def test_an_item_is_shown_without_those_that_are_not(cache: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any) -> None:
    arguments = ["show", "tc100", "registers/motion_command", "--specs", str(SPECS)]
    assert main(arguments) == 0
    first, rebuilt, parse = capsys.readouterr().out, [], layout_cache._parse_line
    monkeypatch.setattr(layout_cache, "_parse_line", lambda line: rebuilt.append(line) or parse(line))
    assert main(arguments) == 0
    assert capsys.readouterr().out == first
    assert len(rebuilt) < 300


def test_a_spec_that_has_changed_is_read_again(cache: Path, folder: Path, capsys: Any) -> None:
    assert show(folder) == 0
    before = capsys.readouterr().out
    file = folder / "widget" / "device.yaml"
    text = file.read_text("utf-8").replace("vendor: Nobody", "vendor: Someone")
    file.write_text(text, "utf-8", newline="\n")
    assert show(folder) == 0
    assert capsys.readouterr().out == before.replace("Nobody", "Someone")


def test_with_another_compiler_a_spec_is_read_again(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert show(TEST_SPECS) == 0
    monkeypatch.setattr(cache_folder, "state", lambda: "another")
    unread(monkeypatch)
    with pytest.raises(AssertionError, match="a spec is read"):
        show(TEST_SPECS)


def test_the_state_of_the_compiler_changes_with_each_of_its_files(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    package = tmp_path / "fieldspec"
    shutil.copytree(cache_folder._PACKAGE, package)
    monkeypatch.setattr(cache_folder, "_PACKAGE", str(package))
    states = {cache_folder.state()}
    for name in ("codec/layout/record.py", "language/schema/spec.schema.json", "foundation/source.py"):
        with (package / name).open("a", encoding="utf-8") as file:
            file.write("\n")
        states.add(cache_folder.state())
    assert len(states) == 4


def test_without_the_cache_nothing_is_read_from_it_or_stored(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert show(TEST_SPECS, "--no-cache") == 0
    assert not cache.exists()
    assert show(TEST_SPECS) == 0
    unread(monkeypatch)
    with pytest.raises(AssertionError, match="a spec is read"):
        show(TEST_SPECS, "--no-cache")


@pytest.mark.proof(3)
@pytest.mark.parametrize(
    "spoilt",
    [
        lambda text: b"",
        lambda text: text[: len(text) // 2],
        lambda text: text.replace(b"Widget", b"Gadget"),
        lambda text: b"\xff\xfe" + text,
        lambda text: b"%s\n%s" % (cache_folder.checksum(b"\xff").encode(), b"\xff"),
        lambda text: (
            b"%s\n%s" % (cache_folder.checksum(b'[["os:system"],[]]\n[1]').encode(), b'[["os:system"],[]]\n[1]')
        ),
    ],
    ids=["empty", "half written", "changed by hand", "not text", "no lines", "naming what it must not"],
)
def test_an_incomplete_compiled_device_is_ignored(cache: Path, capsys: Any, spoilt: Callable[[bytes], bytes]) -> None:
    assert show(TEST_SPECS) == 0
    before = capsys.readouterr().out
    (file,) = cache.iterdir()
    whole = file.read_bytes()
    file.write_bytes(spoilt(whole))
    assert show(TEST_SPECS) == 0
    assert capsys.readouterr().out == before
    assert file.read_bytes() == whole


@pytest.mark.skipif(os.name != "posix", reason="this system has no such rights")
@pytest.mark.parametrize("mode", [0o620, 0o602])
def test_a_compiled_device_that_others_can_write_to_is_ignored(
    cache: Path, monkeypatch: pytest.MonkeyPatch, mode: int
) -> None:
    assert show(TEST_SPECS) == 0
    (file,) = cache.iterdir()
    assert file.stat().st_mode & 0o777 == 0o600
    assert cache.stat().st_mode & 0o777 == 0o700
    file.chmod(mode)
    unread(monkeypatch)
    with pytest.raises(AssertionError, match="a spec is read"):
        show(TEST_SPECS)


def test_a_device_with_findings_is_not_cached(cache: Path, folder: Path) -> None:
    for path in folder.glob("widget/*.yaml"):
        path.write_text(path.read_text("utf-8").replace("type: u16", "type: u17"), "utf-8", newline="\n")
    assert show(folder) == 2
    assert not cache.exists()


def test_paths_are_shown_relative_to_the_current_folder(
    cache: Path, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def path() -> str:
        device = layout_cache.layout(str(folder), "widget").device
        return next(iter(device.records.values())).place.whole.file.path

    monkeypatch.chdir(folder.parent)
    near = path()
    monkeypatch.chdir(folder)
    assert near == f"specs/{path()}"


def test_a_compiled_device_is_loaded_without_the_modules_that_read_specs(cache: Path) -> None:
    code = (
        "import sys; from fieldspec.cli import main; main(sys.argv[1:]); "
        "print({'yaml', 'jsonschema_rs', 'construct', 'fieldspec.command.sources.specs'} & {*sys.modules})"
    )
    command = [sys.executable, "-c", code, "show", "widget", "--specs", str(TEST_SPECS)]
    first, second = (subprocess.run(command, capture_output=True, encoding="utf-8", check=True) for _ in range(2))
    assert "yaml" in first.stdout.splitlines()[-1]
    assert second.stdout.splitlines()[-1] == "set()"


@pytest.mark.proof(18)
@pytest.mark.parametrize("case", BROKEN, ids=[f"{case.parent.name}/{case.name}" for case in BROKEN])
def test_a_device_with_errors_is_wrong_use(cache: Path, tmp_path: Path, case: Path, capsys: Any) -> None:
    match = re.search(r"^ *(?:device: \{)? *id: ([a-z0-9_-]+)", (case / "device.yaml").read_text("utf-8"), re.MULTILINE)
    assert match is not None
    device, specs = match[1], ["--specs", str(tmp_path / "specs")]
    shutil.copytree(case, tmp_path / "specs" / device)
    assert main(["check", device, *specs]) == 1
    number = re.search(r"^[0-9]+ errors?", capsys.readouterr().out, re.MULTILINE)
    assert number is not None
    live = ["live", device, "read", "x", "--port", "tcp://127.0.0.1:9"]
    for line in (["show", device], ["decode", device, "01 02 03"], ["encode", device], ["simulate", device], live):
        assert main([*line, *specs]) == 2
        error = f"the spec of {device} has {number[0]}; see them with: fieldspec check {device}\n"
        assert capsys.readouterr().err == f"fieldspec: {error}"
    assert not cache.exists()
