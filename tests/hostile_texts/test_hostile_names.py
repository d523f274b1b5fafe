"""Whatever a file, a folder, an argument or a variable is called, its name is only read, and nothing acts on it."""

from __future__ import annotations

import csv
import io
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path, PureWindowsPath
from typing import Any
from urllib.parse import unquote
from xml.etree import ElementTree

import pytest
import yaml

from command_line import TEST_SPECS, RunResult
from external_tools import require_tool
from fieldspec.cli import main
from fieldspec.command.files import cache_folder
from fieldspec.foundation.line_text import visible_text
from fieldspec.foundation.names import folded
from fieldspec.foundation.reserved import file_name_fault
from fieldspec.language.reading.project import read
from fieldspec.targets import OUTPUTS
from hostile_texts import fuzz
from hostile_texts.filled_specs import filled_files, layouts, spec
from hostile_texts.names import NAMES, acting, random_names, workflow_commands

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="other systems refuse most of these names")
ALL = (*NAMES, *random_names(5, 12))
GADGET = TEST_SPECS / "gadget"


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Any:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(cache_folder, "_refused", set())

    def called(*words: str) -> RunResult:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO()))
        code = main(words)
        return RunResult(code, *capsys.readouterr())

    return called


def harmless(result: RunResult) -> None:
    """Judges an output in which no command is meant."""
    assert result.code in (0, 1, 2)
    for text in (result.out, result.err):
        assert acting(text) == set()
        assert workflow_commands(text) == []


def refused(result: RunResult) -> None:
    """Judges wrong use: one line."""
    assert (result.code, result.out) == (2, "")
    assert result.err.startswith("fieldspec: ")
    assert result.err.count("\n") == 1
    harmless(result)


def specs_with(folder: Path, path: str, content: bytes | None = None) -> Path:
    """A folder with a good device, and one file more, or one device more."""
    shutil.copytree(GADGET, folder / "gadget")
    shutil.copytree(TEST_SPECS / "protocols", folder / "protocols")
    target = folder / path
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes((GADGET / "device.yaml").read_bytes() if content is None else content)
    return folder


PLACES = ("{}/device.yaml", "gadget/{}.yaml", "gadget/versions/{}.yaml", "protocols/{}.yaml")
FORMATS = ("text", "json", "sarif", "junit", "github")


@pytest.mark.proof(11)
@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("name", NAMES, ids=ascii)
def test_the_name_of_a_spec_file_is_only_read_in_every_format(name: str, place: str, run: Any, tmp_path: Path) -> None:
    specs_with(tmp_path / "specs", place.format(name))
    results = {form: run("check", "--specs", "specs", "--format", form) for form in FORMATS}
    assert {result.code for result in results.values()} == {1}
    harmless(results["text"])
    findings = json.loads(results["json"].out)
    assert "file_name_portable" in {finding["code"] for finding in findings}
    paths = {finding["file"] for finding in findings}
    assert place.format(name) in {path.removeprefix("specs/") for path in paths}
    uris = [
        result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        for result in json.loads(results["sarif"].out)["runs"][0]["results"]
    ]
    assert {unquote(uri, errors="surrogateescape") for uri in uris} == paths
    cases = ElementTree.fromstring(results["junit"].out).findall("testcase")
    assert {case.get("classname") for case in cases} == set(map(visible_text, paths))
    assert [set() for _ in results] == [acting(result.out + result.err) for result in results.values()]
    commands = workflow_commands(results["github"].out)
    assert {command["title"] for _, command, _ in commands} == {finding["code"] for finding in findings}
    assert [command["file"] for _, command, _ in commands] == [visible_text(finding["file"]) for finding in findings]


@pytest.mark.parametrize("name", ALL, ids=ascii)
def test_the_folder_in_which_a_verb_runs_is_only_read(name: str, run: Any, tmp_path: Path) -> None:
    """A finding of a spec in the current folder begins with the name of the device's folder."""
    folder = specs_with(tmp_path / "specs", f"{name}/device.yaml")
    os.chdir(folder)
    result = run("check", "--specs", ".")
    harmless(result)
    assert result.code == 1


ARGUMENTS = (
    ("build", "{}"),
    ("build", "gadget", "--to", "{}"),
    ("build", "gadget", "--to", "vectors", "--out", "file/{}"),
    ("check", "{}"),
    ("check", "--format", "{}"),
    ("show", "{}"),
    ("show", "gadget@{}"),
    ("show", "gadget", "{}"),
    ("layout", "gadget", "{}", "--target", "c"),
    ("layout", "gadget", "cycle", "--target", "{}"),
    ("facts", "{}"),
    ("decode", "gadget", "00", "--link", "{}"),
    ("decode", "gadget", "{}", "--to", "csv", "--out", "tables"),
    ("decode", "gadget", "capture", "--to", "csv", "--out", "file/{}"),
    ("encode", "gadget", "{}"),
    ("encode", "gadget", "read_registers", "{}=1"),
    ("encode", "gadget", "read_registers", "--{}", "1"),
    ("export", "gadget", "--out", "file/{}"),
    ("compare", "gadget", "{}"),
    ("import", "{}", "--to", "-"),
    ("import", "list.csv", "--to", "{}"),
    ("import", "list.csv", "--to", "{}/device.yaml"),
    ("audit", "gadget", "--manual", "{}"),
    ("audit", "gadget", "--dump", "{}"),
    ("audit", "gadget", "--table", "{}"),
    ("audit", "gadget", "--captures", "{}"),
    ("versions", "{}"),
    ("resolve", "gadget@{}"),
    ("blame", "gadget", "{}"),
    ("new", "device", "{}"),
    ("new", "device", "pump", "--protocol", "{}"),
    ("new", "version", "gadget", "{}"),
    ("new", "version", "gadget", "9", "--based-on", "{}"),
    ("matrix", "{}"),
    ("rule", "{}"),
    ("diff", "{}", "gadget"),
    ("diff", "gadget", "{}"),
    ("diff", "HEAD:{}", "gadget"),
    ("redact", "gadget", "{}", "--out", "redacted"),
    ("live", "gadget", "read", "--url", "{}"),
    ("scan", "gadget", "--url", "{}"),
    ("devices", "--specs", "{}"),
    ("{}",),
    ("devices", "{}"),
    ("devices", "--{}"),
    ("completion", "{}"),
)


@pytest.mark.proof(12)
@pytest.mark.parametrize("words", ARGUMENTS, ids=" ".join)
def test_a_name_in_an_argument_is_only_read(words: tuple[str, ...], run: Any, tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"")
    (tmp_path / "capture").write_bytes(b"")
    (tmp_path / "list.csv").write_bytes(b"Address,Name\n0x10,speed\n")
    specs = () if words[0] in ("rule", "completion", "{}") or "--specs" in words else ("--specs", str(TEST_SPECS))
    for name in (*NAMES, *random_names(len(words), 2)):
        refused(run(*(word.format(name) if "{}" in word else word for word in words), *specs))


FILES = (
    ("compare", "gadget", "{}"),
    ("import", "{}", "--to", "-"),
    ("audit", "gadget", "--dump", "{}"),
    ("audit", "gadget", "--manual", "{}"),
    ("audit", "gadget", "--captures", "{}"),
    ("audit", "gadget", "--captures", "{}", "--table", "readings", "--format", "json"),
    *(
        ("decode", "gadget", "{}", "--to", form, "--out", f"{form} tables")
        for form in ("csv", "jsonl", "parquet", "arrow")
    ),
    ("redact", "gadget", "{}", "--out", "redacted"),
)
LOG = b"01 03 10 00 00 01 80 CA\n01 03 02 00 05 78 47\n"


@pytest.mark.proof(8)
@pytest.mark.parametrize("words", FILES, ids=" ".join)
@pytest.mark.parametrize("content", [b"", b"\xff\xfe\x00", b"Address,Name\n0x10,speed\n0x10,torque\n", LOG], ids=len)
def test_the_name_of_a_file_that_is_read_is_only_read(
    words: tuple[str, ...], content: bytes, run: Any, tmp_path: Path
) -> None:
    for name in NAMES:
        path = tmp_path / "inputs" / name
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(content)
        for file in (f"inputs/{name}", "inputs"):
            harmless(run(*(word.replace("{}", file) for word in words), "--specs", str(TEST_SPECS)))
        path.unlink()


@pytest.mark.parametrize(
    "variable", ["FIELDSPEC_SPECS", "FIELDSPEC_CACHE", "XDG_CACHE_HOME", "HOME", "COLUMNS", "TERM"]
)
def test_a_name_in_a_variable_is_only_read(
    variable: str, run: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("FIELDSPEC_SPECS", str(TEST_SPECS))
    if variable != "FIELDSPEC_CACHE":
        monkeypatch.delenv("FIELDSPEC_CACHE")
    for name in NAMES:
        (tmp_path / "cache" / name).mkdir(parents=True)
        (tmp_path / "cache" / name / "letter").write_bytes(b"")
        for value in (name, f"{tmp_path}/cache/{name}"):
            monkeypatch.setenv(variable, value)
            harmless(run("show", "gadget"))


def test_outputs_in_a_folder_of_any_name_are_written(run: Any, tmp_path: Path) -> None:
    for name in NAMES:
        out = tmp_path / name
        result = run("build", "gadget", "--to", "vectors", "--out", str(out), "--specs", str(TEST_SPECS))
        harmless(result)
        assert (result.code, (out / "vectors/gadget.json").is_file()) == (0, True)
        (out / "vectors" / "gadget.json").write_bytes(b"")
        harmless(run("build", "gadget", "--to", "vectors", "--out", str(out), "--check", "--specs", str(TEST_SPECS)))


def test_names_of_files_in_a_revision_are_only_read(run: Any, tmp_path: Path) -> None:
    folder = specs_with(tmp_path / "specs", "gadget/more.yaml", b"notes: []\n")
    git = [require_tool("git"), "-C", str(tmp_path), "-c", "user.name=n", "-c", "user.email=e@e"]
    subprocess.run([*git, "init", "--quiet"], check=True)
    for name in NAMES:
        path = folder / "gadget" / f"{name}.yaml"
        path.write_bytes(b"wrong: 1\n")
        subprocess.run([*git, "add", "--all"], check=True)
        subprocess.run([*git, "commit", "--quiet", "--message", "x"], check=True)
        refused(run("diff", "HEAD", "specs"))
        path.unlink()


SCRIPT = Path(__file__).parent.parent.parent / ".ci" / "review"


def reviewed(tmp_path: Path, **environment: str) -> subprocess.CompletedProcess[bytes]:
    """What the script of the action does with some inputs, in a repository of specs without findings."""
    specs_with(tmp_path / "specs", "gadget/more.yaml", b"notes: []\n")
    (tmp_path / "bin").mkdir()
    program = tmp_path / "bin" / "fieldspec"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m fieldspec "$@"\n', "utf-8")
    program.chmod(0o755)
    git = [require_tool("git"), "-C", str(tmp_path), "-c", "user.name=n", "-c", "user.email=e@e"]
    for words in (("init", "--quiet"), ("add", "specs"), ("commit", "--quiet", "--message", "x")):
        subprocess.run([*git, *words], check=True)
    inputs = {**os.environ, "PATH": f"{tmp_path}/bin:{os.environ['PATH']}", "BASE": "HEAD", **environment}
    ran = subprocess.run(["bash", str(SCRIPT)], cwd=tmp_path, env=inputs, capture_output=True, check=False)
    log = (ran.stdout + ran.stderr).decode("utf-8", "surrogateescape")
    assert acting(log) == set()
    assert [command for command in workflow_commands(log) if command[2] == "pwned"] == []
    return ran


@pytest.mark.proof(4)
@pytest.mark.parametrize("variable", ["SPECS", "BASE", "HEAD", "FAIL_ON"])
@pytest.mark.parametrize("name", NAMES[:4:3], ids=ascii)
def test_an_input_of_the_action_is_only_read(variable: str, name: str, tmp_path: Path) -> None:
    assert reviewed(tmp_path, **{variable: name}).returncode == 2


@pytest.mark.parametrize("name", ["--output=x", "-x", "$(id)", "+refs/heads/*:refs/heads/*"])
def test_a_base_that_looks_like_an_option_or_a_reference_is_only_read(name: str, tmp_path: Path) -> None:
    assert reviewed(tmp_path, BASE=name).returncode == 2
    heads = subprocess.run(["git", "-C", str(tmp_path), "branch", "--all"], capture_output=True, check=True).stdout
    assert len(heads.splitlines()) == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == [".git", "bin", "specs"]


@pytest.mark.proof(2)
@pytest.mark.parametrize("name", [*NAMES[:4:3], "--output=x", "$(id)"], ids=ascii)
def test_findings_are_written_into_a_folder_of_any_name(name: str, tmp_path: Path) -> None:
    assert reviewed(tmp_path, SARIF=name).returncode == 0
    folder = tmp_path / name
    assert sorted(path.name for path in folder.iterdir()) == ["check.sarif", "diff.sarif"]
    assert all(json.loads(path.read_bytes())["version"] == "2.1.0" for path in folder.iterdir())


DATA = (
    ("facts", "{device}"),
    ("facts", "{device}", "--format", "json"),
    ("matrix", "{device}", "--format", "csv"),
    ("matrix", "{device}", "--format", "html", "--all"),
    ("export", "{device}", "--to", "json"),
    ("resolve", "{device}"),
    ("versions", "{device}"),
    ("devices",),
    ("audit", "{device}"),
    ("audit", "{device}", "--format", "html"),
    ("audit", "{device}", "--format", "json"),
    *(("diff", "5", "6", "--format", form) for form in ("text", "html", "markdown", "json", "sarif")),
)


@pytest.mark.parametrize("words", DATA, ids=" ".join)
def test_texts_of_a_spec_are_only_read_in_every_format_that_a_verb_prints(
    words: tuple[str, ...], run: Any, tmp_path: Path
) -> None:
    for seed in (5, 6):
        for path, content in filled_files("gadget", seed, str).items():
            target = tmp_path / str(seed) / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
    result = run(*(word.format(device="gadget") for word in words), "--specs", "5")
    assert (result.err.partition(":")[0], bool(result.out)) == ("not in the list" if "export" in words else "", True)
    assert acting(result.out + result.err) == set()
    if "html" not in words:  # which is for browsers
        assert [command for command in workflow_commands(result.out) if command[2].startswith("pwned")] == []


def test_facts_as_csv_have_the_rows_of_the_json(run: Any, tmp_path: Path) -> None:
    table = list(csv.DictReader(io.StringIO(run("facts", "gadget", "--specs", str(TEST_SPECS)).out)))
    objects = json.loads(run("facts", "gadget", "--format", "json", "--specs", str(TEST_SPECS)).out)
    assert [row["path"] for row in table] == [fact["path"] for fact in objects]


@pytest.mark.parametrize("device", ["hostile", "gizmo", "glider-x"])
def test_outputs_have_names_that_every_system_can_have_and_texts_that_are_only_read(device: str) -> None:
    outputs = fuzz.outputs_of(layouts(spec(device, 7)), tuple(OUTPUTS))
    assert {step: fault for path in outputs for step in path.split("/") if (fault := file_name_fault(step))} == {}
    assert len({folded(path) for path in outputs}) == len(outputs)
    for path, content in outputs.items():
        if not path.endswith(".xlsx"):
            text = content.decode().replace("\r\n", "\n").replace("\t", " ")
            assert acting(text.removeprefix("\ufeff")) == set(), path


WINDOWS = [
    *("con", "CON", "prn", "aux", "nul", "com1", "com9", "lpt1", "lpt9", "con.yaml", "aux.tar.gz", "nul .txt"),
    *("a.", "a ", "a:b", "a*b", "a?b", 'a"b', "a<b", "a>b", "a|b", "a\\b", "a\tb", "a\x01b", "conin$", "conout$"),
]


@pytest.mark.parametrize("name", WINDOWS, ids=ascii)
def test_a_name_that_windows_cannot_have_is_refused(name: str) -> None:
    assert file_name_fault(name) != ""


@pytest.mark.parametrize(
    "name", ["console", "com", "com10", "lpt", "auxiliary", "v2_0.html", "a b", "伺服.yaml", ".x", "é"]
)
def test_a_name_that_every_system_can_have_is_none_of_windows_devices(name: str) -> None:
    assert (file_name_fault(name), PureWindowsPath(name).is_reserved()) == ("", False)


@pytest.mark.parametrize("name", [name for name in WINDOWS if PureWindowsPath(name).is_reserved()], ids=ascii)
@pytest.mark.parametrize("verb", [("new", "device", "{}", "--protocol", "packet"), ("new", "version", "gadget", "{}")])
def test_no_verb_creates_what_windows_cannot_have(verb: tuple[str, ...], name: str, run: Any, tmp_path: Path) -> None:
    specs_with(tmp_path / "specs", "gadget/more.yaml", b"notes: []\n")
    refused(run(*(word.format(name) for word in verb), "--specs", "specs"))


@pytest.mark.parametrize("name", ["con", "aux", "nul", "com1", "lpt9", "aux.1"])
def test_a_device_or_a_version_that_windows_cannot_have_is_refused(name: str) -> None:
    device = yaml.safe_load((GADGET / "device.yaml").read_bytes())
    device["device"]["id"] = name
    codes = {finding.code for finding in read({f"{name}/device.yaml": yaml.safe_dump(device).encode()}).findings}
    assert "file_name_portable" in codes


def test_files_that_differ_in_capital_letters_alone_are_refused() -> None:
    content = (GADGET / "device.yaml").read_bytes()
    files = {f"gadget/{name}.yaml": b"notes: []\n" for name in ("motion", "Motion", "caf\u00e9", "cafe\u0301")}
    codes = [finding.code for finding in read({"gadget/device.yaml": content, **files}).findings]
    assert codes.count("file_name_portable") == 2
