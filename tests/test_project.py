"""The files of the project itself: pins, documentation, package."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import zipfile
from importlib.metadata import version
from pathlib import Path

import pytest

import fieldspec
from external_tools import require_tool

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parent.parent
PINS = ROOT / "requirements" / "dev.txt"
LOCK = ROOT / "tests" / "tools" / "package-lock.json"
ARCHITECTURE = ROOT / "docs" / "architecture.md"
# It begins with a character, so that the beginnings of matches are found without trying each place.
MACHINE_PATH = re.compile(rb"/(?<![\w.~-]/)(?:work|root|home/\w+|Users/\w+)/")
PINNED = re.compile(r"[\w.-]+==[\w.]+ .*--hash=sha256:[0-9a-f]{64}")
IN_WHEEL = {
    "codegen/fieldspec": "fieldspec",
    "specs": "fieldspec/_specs",
    "generated/python/fieldspec_devices": "fieldspec_devices",
}


def normalised(requirement: str) -> str:
    """The name of the package in a requirement, normalized as registries do."""
    match = re.match(r"[\w.-]+", requirement)
    assert match, requirement
    return re.sub(r"[-_.]+", "-", match[0]).lower()


@pytest.fixture(scope="module")
def dependencies() -> set[str]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    groups = [project["dependencies"], *project["optional-dependencies"].values()]
    return {normalised(requirement) for group in groups for requirement in group}


@pytest.fixture(scope="module")
def pins() -> list[str]:
    """The pinned requirements, each on one line with its hashes."""
    lines = PINS.read_text("utf-8").replace("\\\n", "").splitlines()
    return [line for line in lines if line.strip() and not line.lstrip().startswith("#")]


def test_no_tracked_file_names_a_path_of_one_machine() -> None:
    git = require_tool("git")
    listing = subprocess.run([git, "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True, text=True)
    files = [ROOT / name for name in listing.stdout.split("\0") if name]
    assert files
    assert [file for file in files if file.is_file() and MACHINE_PATH.search(file.read_bytes())] == []


def test_pins_name_no_registry() -> None:
    assert "://" not in PINS.read_text("utf-8")


def test_every_pin_has_a_version_and_hashes(pins: list[str]) -> None:
    assert [pin for pin in pins if not PINNED.match(pin)] == []


def test_every_dependency_is_pinned(dependencies: set[str], pins: list[str]) -> None:
    assert dependencies - {normalised(pin) for pin in pins} == set()


def test_lock_of_node_tools_has_hashes_and_names_no_registry() -> None:
    packages = json.loads(LOCK.read_text("utf-8"))["packages"]
    tools = {name: package for name, package in packages.items() if name}
    assert tools
    assert [name for name, tool in tools.items() if "resolved" in tool or "integrity" not in tool] == []


def test_architecture_gives_every_dependency_a_line(dependencies: set[str]) -> None:
    text = ARCHITECTURE.read_text("utf-8")
    named = {normalised(word) for word in re.findall(r"`([\w.-]+)`", text)}
    assert dependencies - named == set()


def test_version_is_written_once() -> None:
    assert version("fieldspec") == fieldspec.__version__


def test_wheel_contains_the_compiler_the_specs_and_the_codecs(tmp_path: Path) -> None:
    build = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", str(tmp_path)]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    names = set(zipfile.ZipFile(wheel).namelist())
    for folder, inside in IN_WHEEL.items():
        files = [path.relative_to(ROOT / folder) for path in (ROOT / folder).rglob("*") if path.is_file()]
        wanted = {f"{inside}/{file.as_posix()}" for file in files if "__pycache__" not in file.parts}
        assert wanted, f"{folder} is empty"
        assert wanted - names == set()
