"""The door for other packages: `fieldspec.extension` is all that they import, and it is typed, documented and light."""

from __future__ import annotations

import ast
import inspect
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import fieldspec.extension as door

ROOT = Path(__file__).resolve().parent.parent
EXAMPLE = ROOT / "tests" / "example_package" / "src"
PAGE = ROOT / "docs" / "extend.md"
PAGES = sorted([*(ROOT / "docs").glob("*.md"), *ROOT.glob("*.md")])
PUBLIC = {"extension", "testing"}
"""The modules that people import."""
SCHEMAS = {"schema.json", "project.schema.json"}
NOT_MODULES = SCHEMAS | {"outputs", "checks", "codecs", "protocols", "yaml", "vsix", "manuals", "program"}
"""What else follows the name and a point: groups of entry points, the project file, and the files of the schemas."""
ROWS = re.findall(r"^\| (`.+`) \| .+ \| (.*)\|$", PAGE.read_text("utf-8"), re.MULTILINE)


def modules(text: str) -> set[str]:
    """The modules of fieldspec that some Python imports."""
    nodes = [*ast.walk(ast.parse(text))]
    names = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    names |= {str(node.module) for node in nodes if isinstance(node, ast.ImportFrom)}
    return {name for name in names if name.partition(".")[0] == "fieldspec"}


@pytest.mark.parametrize("path", sorted(EXAMPLE.rglob("*.py")), ids=lambda path: path.stem)
def test_the_example_imports_nothing_of_fieldspec_but_the_door(path: Path) -> None:
    assert modules(path.read_text("utf-8")) <= {"fieldspec.extension"}


def test_the_page_lists_every_name_of_the_door_and_no_other() -> None:
    names = [name for cell, _ in ROWS for name in re.findall(r"`(\w+)`", cell)]
    assert sorted(names) == sorted(door.__all__)


def test_what_the_page_says_of_a_name_is_there() -> None:
    missing = []
    for cell, members in ROWS:
        first = re.findall(r"`(\w+)`", cell)[0]
        for path in re.findall(r"`([\w.]+)(?:\(\))?`", members):
            owner, _, member = path.rpartition(".")
            if not hasattr(getattr(door, owner or first), member):
                missing.append(path)
    assert missing == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pages_name_no_module_that_may_move(page: Path) -> None:
    text = re.sub(r"<!--.*?-->|https?://\S+", "", page.read_text("utf-8"), flags=re.DOTALL)
    assert set(re.findall(r"\bfieldspec\.([a-z_]+(?:\.\w+)*)", text)) <= PUBLIC | NOT_MODULES


def test_every_class_and_function_of_the_door_has_a_docstring() -> None:
    named = {name: getattr(door, name) for name in door.__all__}
    objects = {name: value for name, value in named.items() if inspect.isclass(value) or inspect.isfunction(value)}
    assert {*named} - {*objects} == {"Cell", "Check", "Encoding", "Files", "LEAVE_OUT"}
    assert [name for name, value in objects.items() if not inspect.getdoc(value)] == []


LIBRARIES = {"yaml", "jsonschema_rs", "jinja2", "construct", "openpyxl", "xlsxwriter", "rich", "argparse"}


def new_modules(before: str) -> set[str]:
    """The modules that the import of the door adds to those that other imports have loaded."""
    code = f"import json, sys{before}; old = {{*sys.modules}}; import fieldspec.extension; "
    code += "print(json.dumps([*({*sys.modules} - old)]))"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return {*json.loads(ran.stdout)}


def test_the_door_loads_no_library() -> None:
    assert {name for name in new_modules("") if name.partition(".")[0] in LIBRARIES} == set()


def test_a_verb_that_uses_a_package_loads_nothing_more_for_the_door() -> None:
    assert new_modules(", fieldspec.command.packages.plugin_loading, fieldspec.language.checks.table") == {
        "fieldspec.extension"
    }


MISTAKES = """from fieldspec.extension import Device, DeviceLayout, Diagnostic, Files, finding
def check(device: Device) -> list[Diagnostic]:
    device.regs
    device.id = "other"
    finding("code", device.place, "name", "text")
    return [finding("code", device.id, "name", "text", "help")]
def files(layout: DeviceLayout) -> Files:
    return {"path": layout.registers[0].words}
"""
WRONG_LINES = [3, 4, 5, 6, 8]


Judged = set[tuple[str, int]]
"""The files and lines of findings."""


@pytest.fixture(scope="module")
def judged(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the example and with wrong uses, each of which a type checker looks at in one run."""
    folder = tmp_path_factory.mktemp("judged")
    shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("__pycache__"), dirs_exist_ok=True)
    (folder / "wrong.py").write_text(MISTAKES, "utf-8")
    return folder


@pytest.fixture(scope="module")
def by_mypy(judged: Path) -> Judged:
    """What mypy finds, which sees fieldspec as it sees an installed package."""
    command = [sys.executable, "-m", "mypy", "--strict", "--python-version=3.10", "--config-file=", "."]
    done = subprocess.run(command, cwd=judged, capture_output=True, text=True, check=False)
    assert re.search(r"checked \d+ source files", done.stdout)
    return {(path, int(line)) for path, line in re.findall(r"^(.+?):(\d+): error:", done.stdout, re.MULTILINE)}


@pytest.fixture(scope="module")
def by_pyright(judged: Path) -> Judged:
    """The same of pyright."""
    settings = {"typeCheckingMode": "strict", "pythonVersion": "3.10", "reportMissingModuleSource": False}
    (judged / "pyrightconfig.json").write_text(json.dumps(settings), "utf-8")
    options = ["--outputjson", "--project", str(judged), "--pythonpath", sys.executable]
    command = [sys.executable, "-m", "pyright", *options]
    done = subprocess.run(command, cwd=judged, capture_output=True, text=True, check=False)
    report = json.loads(done.stdout)
    assert report["summary"]["filesAnalyzed"] == len([*judged.rglob("*.py")])
    findings: list[dict[str, Any]] = report["generalDiagnostics"]
    return {(Path(own["file"]).relative_to(judged).as_posix(), own["range"]["start"]["line"] + 1) for own in findings}


@pytest.mark.parametrize("checker", ["by_mypy", "by_pyright"])
def test_a_type_checker_finds_wrong_uses_of_the_door_and_nothing_in_the_example(
    checker: str, request: pytest.FixtureRequest
) -> None:
    findings: Judged = request.getfixturevalue(checker)
    assert sorted(findings) == [("wrong.py", line) for line in WRONG_LINES]
