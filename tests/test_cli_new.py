"""The files of `fieldspec new` pass the check, and it overwrites nothing."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from command_line import SPECS
from fieldspec.cli import main
from fieldspec.command.sources.layout_cache import layout
from fieldspec.command.verbs.new import SHAPES


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the protocols and one device that has versions."""
    specs = tmp_path / "specs"
    for name in ("protocols", "tc100"):
        shutil.copytree(SPECS / name, specs / name)
    return specs


def run(folder: Path, *words: str) -> int:
    return main([*words, "--specs", str(folder)])


@pytest.mark.parametrize("protocol", ["modbus", *SHAPES])
def test_a_new_device_passes_the_check(protocol: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(folder, "new", "device", "my-drive", "--protocol", protocol) == 0
    assert capsys.readouterr().out == (
        f"{folder}/fieldspec.schema.json\n{folder}/fieldspec.project.schema.json\n"
        f"{folder.parent}/fieldspec.yaml\n{folder}/my-drive/device.yaml\n"
    )
    assert run(folder, "check", "my-drive") == 0
    assert capsys.readouterr().out == "no findings in my-drive\n"


def test_a_new_version_passes_the_check_and_changes_nothing(folder: Path) -> None:
    assert run(folder, "new", "version", "tc100", "2.1", "--based-on", "2.0") == 0
    assert run(folder, "check", "tc100") == 0
    old, new = (layout(str(folder), f"tc100@{version}") for version in ("2.0", "2.1"))
    assert old.identity == new.identity


def test_a_new_version_is_based_on_the_newest_by_default(folder: Path) -> None:
    assert run(folder, "new", "version", "tc100", "2.1") == 0
    assert 'based_on: "2.0"' in (folder / "tc100/versions/2.1.yaml").read_text("utf-8")


def test_a_version_of_another_line_follows_the_last_one_of_that_line(folder: Path) -> None:
    assert run(folder, "new", "version", "tc100", "V3", "--based-on", "2.0", "--line", "hardware") == 0
    assert 'after: "V2"' in (folder / "tc100/versions/V3.yaml").read_text("utf-8")
    assert run(folder, "check", "tc100") == 0


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (("device", "tc100", "--protocol", "modbus"), "already exists"),
        (("device", "x", "--protocol", "modbuss"), "there is no protocol modbuss; did you mean modbus?"),
        (("device",), "name the device; see: fieldspec new device --help"),
        (("schema", "tc100"), "--name has no effect on a new schema; leave it out"),
        (("schema", "--protocol", "modbus"), "--protocol has no effect on a new schema; leave it out"),
        (("device", "x"), "name the protocol with --protocol: "),
        (("device", "My Drive", "--protocol", "packet"), "My Drive is not a valid name of a device"),
        (("device", "../x", "--protocol", "packet"), "../x is not a valid name of a device"),
        (("device", "x", "1.0", "--protocol", "packet"), "a new device has no version yet"),
        (("version", "tc100"), "name the version"),
        (("version", "tc100", "2.0"), "tc100 already has a version 2.0"),
        (("version", "tc100", "2.1", "--based-on", "1.9"), "there is no version of tc100 1.9"),
        (("version", "tc100", "2.1", "--line", "software"), "there is no line of versions of tc100 software"),
        (("version", "tc100", "../2.1"), "../2.1 is not a valid name of a version"),
        (("version", "nothing", "2.1"), "there is no device nothing"),
    ],
)
def test_what_cannot_be_written_is_wrong_use_and_nothing_is_written(
    words: tuple[str, ...], text: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = sorted(folder.rglob("*"))
    assert run(folder, "new", *words) == 2
    assert text in capsys.readouterr().err
    assert sorted(folder.rglob("*")) == before


@pytest.mark.parametrize("named", [False, True])
def test_a_device_is_new_where_there_are_no_specs_yet(
    named: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("FIELDSPEC_SPECS", raising=False)
    option, folder = (["--specs", "mine"], "mine") if named else ([], "specs")
    assert main(["new", "device", "my_meter", "--protocol", "modbus", *option]) == 0
    assert f"{folder}/my_meter/device.yaml" in capsys.readouterr().out
    assert main(["check", *option]) == 0


def test_the_schema_for_editors_is_written_beside_the_devices_and_kept(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    schema = folder / "fieldspec.schema.json"
    project = folder / "fieldspec.project.schema.json", folder.parent / "fieldspec.yaml"
    expected = SPECS.joinpath("fieldspec.schema.json").read_bytes()
    for words, printed in (
        (("device", "one", "--protocol", "packet"), [schema, *project, folder / "one/device.yaml"]),
        (("device", "two", "--protocol", "packet"), [folder / "two/device.yaml"]),
        (("schema",), []),
    ):
        assert run(folder, "new", *words) == 0
        assert capsys.readouterr().out.splitlines() == [str(path) for path in printed]
        assert schema.read_bytes() == expected
    schema.write_text("{}\n", "utf-8")
    assert run(folder, "new", "schema") == 0
    assert (capsys.readouterr().out, schema.read_bytes()) == (f"{schema}\n", expected)


@pytest.mark.parametrize(
    "line",
    ["", "# yaml-language-server: $schema=../../codegen/fieldspec/schema/spec.schema.json\n", "# $schema=nowhere\n"],
)
def test_no_verb_reads_the_line_for_editors(line: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = folder / "tc100" / "device.yaml"
    _, _, rest = file.read_text("utf-8").partition("\n")
    file.write_text(line + rest, "utf-8")
    assert run(folder, "check", "tc100") == 0
    assert capsys.readouterr().out == "no findings in tc100\n"


def test_an_empty_folder_here_gets_the_new_device(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder.parent / "project" / "specs").mkdir(parents=True)
    monkeypatch.chdir(folder.parent / "project")
    assert main(["check", "my-drive"]) == 2
    assert f"these are the specs of {folder}, as specs here has no device" in capsys.readouterr().err
    assert main(["new", "device", "my-drive", "--protocol", "packet"]) == 0
    assert Path("specs/my-drive/device.yaml").is_file()
    assert not (folder / "my-drive").exists()
    assert main(["check", "my-drive"]) == 0


def test_an_unknown_protocol_of_a_spec_gets_the_name_of_an_installed_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    specs = tmp_path / "specs"
    assert run(specs, "new", "device", "my-drive", "--protocol", "modbus") == 0
    (specs / "protocols" / "modbus.yaml").unlink()
    file = specs / "my-drive" / "device.yaml"
    file.write_text(file.read_text("utf-8").replace("protocol: modbus", "protocol: modbuss"), "utf-8")
    capsys.readouterr()
    assert run(specs, "check", "my-drive") == 1
    assert "did you mean `modbus`?" in capsys.readouterr().out
