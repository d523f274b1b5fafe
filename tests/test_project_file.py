"""The project file beside the specs says which outputs of which versions are written, and where."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import jsonschema
import pytest

from fieldspec.cli import main
from fieldspec.language.schema import ADDRESS, PROJECT_ADDRESS, project_schema
from fieldspec.targets import OUTPUTS
from test_build_each_device import Bench

ROOT = Path(__file__).resolve().parent.parent
OLD, NEW = "v1_0", "v1_1"
"""The versions of the device glider-x, as they stand in the names of files."""
SOURCES = (".scl", ".st", ".xml", ".TcPOU", ".udt", ".TcDUT", ".TcGVL")


@pytest.fixture
def bench(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Bench:
    """A device of one version and one of two."""
    monkeypatch.setenv("FIELDSPEC_CACHE", str(tmp_path / "cache"))
    monkeypatch.chdir(tmp_path)
    return Bench(tmp_path, "gizmo", "glider-x")


def state(bench: Bench, text: str) -> None:
    (bench.folder / "fieldspec.yaml").write_text(text, encoding="utf-8")


def build(bench: Bench, *more: str) -> int:
    """Builds without naming a folder."""
    return main(["build", "--specs", str(bench.specs), *more])


def paths(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_the_file_chooses_outputs_and_versions_and_the_folder(bench: Bench) -> None:
    state(
        bench,
        "folder: gen\nversions: newest\n"
        "outputs: {vectors: {versions: all}, wireshark: , c: {versions: all, tests: newest}}\n",
    )
    assert build(bench) == 0
    assert not (bench.folder / "generated").exists()
    built_paths = paths(bench.folder / "gen")
    assert {path.partition("/")[0] for path in built_paths} == {"vectors", "wireshark", "c", "manifest.json"}
    assert {path for path in built_paths if path.startswith("wireshark/glider")} == {f"wireshark/glider_x_{NEW}.lua"}
    vectors = json.loads((bench.folder / "gen/vectors/glider-x.json").read_text("utf-8"))
    assert len(vectors["identities"]) == 2
    assert {path for path in built_paths if path.startswith("c/glider")} == {
        "c/glider_x.h",
        f"c/glider_x_{NEW}.h",
        f"c/glider_x_{NEW}_constants.h",
        f"c/glider_x_{NEW}_selftest.c",
        f"c/glider_x_{NEW}_fuzz.c",
        f"c/glider_x_{OLD}.h",
        f"c/glider_x_{OLD}_constants.h",
    }
    assert build(bench, "--check") == 0


def test_a_single_device_has_its_own_choice(bench: Bench) -> None:
    state(
        bench,
        "outputs: {vectors: , wireshark: }\n"
        "devices:\n"
        '  glider-x: {folder: other, versions: ["1.0"], outputs: {wireshark: }}\n',
    )
    assert build(bench) == 0
    assert paths(bench.folder / "generated") == {"vectors/gizmo.json", "wireshark/gizmo_v1.lua", "manifest.json"}
    assert paths(bench.folder / "other") == {f"wireshark/glider_x_{OLD}.lua", "manifest.json"}


def test_a_change_of_the_file_writes_and_removes(bench: Bench, capsys: pytest.CaptureFixture[str]) -> None:
    state(bench, "outputs: {vectors: , wireshark: }\n")
    assert build(bench) == 0
    state(bench, "outputs: {wireshark: {versions: newest}}\n")
    capsys.readouterr()
    assert build(bench, "--check") == 1
    assert f"no longer produced: wireshark/glider_x_{OLD}.lua\n" in capsys.readouterr().out
    assert build(bench) == 0
    assert paths(bench.folder / "generated") == {
        "wireshark/gizmo_v1.lua",
        f"wireshark/glider_x_{NEW}.lua",
        "manifest.json",
    }
    (bench.folder / "fieldspec.yaml").unlink()
    assert build(bench) == 0
    assert {path.name for path in (bench.folder / "generated").iterdir() if path.is_dir()} == {*OUTPUTS}


def test_the_command_line_takes_the_place_of_the_file(bench: Bench) -> None:
    state(bench, "folder: gen\nversions: newest\noutputs: {vectors: }\n")
    assert build(bench, "--to", "wireshark", "--out", "here") == 0
    assert paths(bench.folder / "here") == {"wireshark/gizmo_v1.lua", f"wireshark/glider_x_{NEW}.lua", "manifest.json"}


def test_a_named_version_is_built_in_addition_to_the_chosen_ones(bench: Bench) -> None:
    state(bench, "outputs: {wireshark: , c: {versions: newest, tests: none}}\nversions: newest\n")
    assert build(bench, "glider-x@1.0") == 0
    assert paths(bench.folder / "generated") == {
        f"wireshark/glider_x_{OLD}.lua",
        f"wireshark/glider_x_{NEW}.lua",
        f"c/glider_x_{NEW}.h",
        f"c/glider_x_{NEW}_constants.h",
        f"c/glider_x_{OLD}.h",
        f"c/glider_x_{OLD}_constants.h",
        f"c/glider_x_{OLD}_selftest.c",
        f"c/glider_x_{OLD}_fuzz.c",
        "c/glider_x.h",
        "manifest.json",
    }
    header = (bench.folder / "generated/c/glider_x.h").read_text("utf-8")
    assert [version for version in (OLD, NEW) if f"glider_x_{version}.h" not in header] == []
    assert build(bench) == 0
    assert not [path for path in paths(bench.folder / "generated") if OLD in path]


def test_a_named_version_is_built_alone_into_a_named_folder(bench: Bench) -> None:
    state(bench, "outputs: {wireshark: }\nversions: newest\n")
    assert build(bench, "glider-x@1.0", "--out", "here") == 0
    assert paths(bench.folder / "here") == {f"wireshark/glider_x_{OLD}.lua", "manifest.json"}


WRONG = {
    "outputs: {vectros: }": ("fieldspec.yaml:1:11: error[unknown_word]: there is no output `vectros`", "`vectors`"),
    "output: {vectors: }": ("fieldspec.yaml:1:1: error[unknown_key]: there is no key `output` here", "`outputs`"),
    "versions: newst": ("fieldspec.yaml:1:11: error[unknown_word]: `versions` cannot be `newst`", "`newest`"),
    "devices: {glider: {}}": ("fieldspec.yaml:1:11: error[unknown_word]: there is no device `glider`", "`glider-x`"),
    "devices: {glider-x: {outputs: {pyton: }}}": ("there is no output `pyton`", "`python`"),
    "outputs: {vectors: {tests: all}}": ("fieldspec.yaml:1:21: error[unknown_key]", "only c has them"),
    "outputs: [vectors]": ("fieldspec.yaml:1:10: error[wrong_type]: `outputs` must be a mapping, not a list", ""),
    "a: b: c": ("fieldspec.yaml:1:", ""),
}


@pytest.mark.parametrize("text", WRONG)
def test_a_wrong_file_is_a_finding_and_nothing_is_written(
    bench: Bench, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    state(bench, f"{text}\n")
    assert build(bench) == 1
    built = capsys.readouterr()
    assert main(["check", "--specs", str(bench.specs)]) == 1
    for out in (built.out, capsys.readouterr().out):
        for part in WRONG[text]:
            assert part in out
    assert built.err == "fieldspec: nothing is written\n"
    assert not (bench.folder / "generated").exists()


@pytest.mark.parametrize("text", ["versions: [before-c]", "versions: newst", "outputs: {c: {versions: [before-c]}}"])
def test_a_version_that_a_device_does_not_have_stops_that_device(
    bench: Bench, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    state(bench, f"devices: {{glider-x: {{{text}}}}}\n")
    for _ in range(2):
        assert build(bench, "--to", "vectors") == 1
        captured = capsys.readouterr()
        assert "fieldspec.yaml:1:" in captured.out
        assert "error[unknown_word]" in captured.out
        assert paths(bench.folder / "generated") == {"vectors/gizmo.json", "manifest.json"}
    assert main(["check", "--specs", str(bench.specs)]) == 1


FIVE = (
    "devices: {tc100: {outputs: {OUTPUT: }, "
    "blocks: {tasks: [servo_on, home, move_absolute, stop, reset_alarm], links: [rtu]}}}"
)
BLOCKS = {"ServoOn", "Home", "MoveAbsolute", "Stop", "Halt", "ResetAlarm", "RtuClient", "Panel"}
ADAPTERS = {
    "scl": {"ModbusMaster", "Program"},
    "twincat": {"ModbusMaster"},
    "plcopen": {"SerialPort", "ModbusRequest"},
}
"""What serves the port of the device, and the ready program where it is a block too."""


@pytest.fixture
def motor(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Bench:
    """A device with tasks, of which a project needs five."""
    monkeypatch.chdir(tmp_path)
    bench = Bench(tmp_path)
    for name in ("tc100", "protocols"):
        shutil.copytree(ROOT / "specs" / name, bench.specs / name)
    return bench


@pytest.mark.proof(2)
@pytest.mark.parametrize("output", ["scl", "st", "twincat", "plcopen", "iec"])
def test_a_program_has_the_chosen_blocks_and_what_they_need(motor: Bench, output: str) -> None:
    state(motor, FIVE.replace("OUTPUT", output))
    assert build(motor, "tc100") == 0
    files = (path for path in (motor.folder / "generated" / output).rglob("*") if path.suffix in SOURCES)
    text = "\n".join(path.read_text("utf-8").removeprefix("\ufeff") for path in files)
    text = re.sub(r"\(\*.*?\*\)|<documentation>.*?</documentation>", "", re.sub(r"//[^\n]*", "", text), flags=re.S)
    function, block = ("", "") if output == "scl" else ("F_", "FB_")
    blocks = set(re.findall(rf"""(?:FUNCTION_BLOCK|pou name=|POU Name=)\s*"?{block}Tc100_(\w+)""", text))
    assert blocks == BLOCKS | ADAPTERS.get(output, set())
    declared = set(re.findall(rf"""(?:FUNCTION|name=|Name=)\s*"?({function}Tc100_\w+)""", text))
    called = set(re.findall(rf"\b{function}Tc100_\w+", text)) - {f"Tc100_{name}" for name in blocks}
    assert declared - {f"{function}Tc100_{name}" for name in blocks} == called
    assert "Ascii" not in text
    assert "JogSpeed" not in text


@pytest.mark.parametrize(
    ("blocks", "expected"),
    [
        ("registers: [motion_speed]", {"ReadMotion", "WriteMotion", "RtuClient", "AsciiClient"}),
        (
            "registers: [points], links: [ascii]",
            {"ReadPoint", "ReadPoints", "WritePoint", "WritePoints", "AsciiClient"},
        ),
        ("messages: [read_registers]", {"RtuReadRegisters", "AsciiReadRegisters"}),
    ],
)
def test_registers_and_messages_have_their_blocks(motor: Bench, blocks: str, expected: set[str]) -> None:
    state(motor, f"devices: {{tc100: {{outputs: {{iec: }}, blocks: {{{blocks}}}}}}}\n")
    assert build(motor, "tc100") == 0
    text = (motor.folder / "generated/iec/tc100_v2_0.st").read_text("utf-8")
    assert set(re.findall(r"FUNCTION_BLOCK FB_Tc100_(\w+)", text)) == expected


@pytest.mark.proof(1)
@pytest.mark.parametrize(
    ("device", "blocks", "expected"),
    [
        ("tc100", "tasks: [jog_negative, jog_positive], links: [rtu]", {"Jog", "RtuClient", "Panel"}),
        ("hiwin-e", "tasks: [home, jog_positive], messages: [telegram_111]", {"Home", "Jog", "Panel"}),
        ("esc11", "tasks: [grip, release]", {"Grip", "Release", "Panel"}),
    ],
)
def test_chosen_tasks_of_any_device_have_their_blocks_and_a_program(
    motor: Bench, device: str, blocks: str, expected: set[str]
) -> None:
    shutil.copytree(ROOT / "specs" / device, motor.specs / device, dirs_exist_ok=True)
    state(motor, f"devices: {{{device}: {{outputs: {{iec: }}, blocks: {{{blocks}}}}}}}\n")
    assert build(motor, device) == 0
    texts = [path.read_text("utf-8") for path in (motor.folder / "generated/iec").glob("*.st")]
    names = [
        name for text in texts for name in re.findall(r"FUNCTION_BLOCK FB_[A-Za-z0-9]+_(?:Telegram111)?(\w+)", text)
    ]
    assert set(names) == expected
    assert sum("\nPROGRAM PRG_" in text for text in texts) == 1


@pytest.mark.parametrize(("old", "new"), [("home", "hoem"), ("[rtu]", "[rut]"), ("tasks", "task"), ("OUTPUT", "kv")])
def test_a_wrong_choice_of_blocks_is_a_finding(
    motor: Bench, old: str, new: str, capsys: pytest.CaptureFixture[str]
) -> None:
    state(motor, FIVE.replace(old, new).replace("OUTPUT", "iec"))
    assert build(motor, "tc100") == 1
    assert "fieldspec.yaml:1:" in capsys.readouterr().out
    assert main(["check", "--specs", str(motor.specs)]) == 1


def test_an_empty_file_chooses_everything(bench: Bench) -> None:
    state(bench, "# Nothing yet.\n")
    assert build(bench, "--to", "vectors") == 0
    assert main(["check", "--specs", str(bench.specs)]) == 0


def test_a_new_device_brings_the_file_and_its_schema(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["new", "device", "pump", "--protocol", "packet"]) == 0
    text = (tmp_path / "fieldspec.yaml").read_text("utf-8")
    assert text.startswith(f"# yaml-language-server: $schema=specs/{PROJECT_ADDRESS}\n")
    assert json.loads((tmp_path / "specs" / PROJECT_ADDRESS).read_text("utf-8")) == project_schema()
    (tmp_path / "fieldspec.yaml").write_text("versions: newest\n", "utf-8")
    assert main(["new", "device", "motor", "--protocol", "packet"]) == 0
    assert (tmp_path / "fieldspec.yaml").read_text("utf-8") == "versions: newest\n"
    assert main(["build", "--to", "vectors"]) == 0


def test_the_schema_of_project_files_is_valid_and_beside_the_specs() -> None:
    jsonschema.Draft202012Validator.check_schema(project_schema())
    beside = (ROOT / "specs" / ADDRESS).with_name(PROJECT_ADDRESS)
    assert json.loads(beside.read_text("utf-8")) == project_schema()
