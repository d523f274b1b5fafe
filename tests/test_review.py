"""The files for pre-commit and for GitHub use existing verbs and options, and do what they describe."""

from __future__ import annotations

import importlib.metadata
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest
import yaml

from external_tools import require_tool
from fieldspec.cli import parser

ROOT = Path(__file__).parent.parent
HOOKS: list[dict[str, Any]] = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text("utf-8"))
ACTION: dict[str, Any] = yaml.safe_load((ROOT / "action.yml").read_text("utf-8"))
REVIEW = (ROOT / ".ci" / "review").read_text("utf-8")


@pytest.mark.parametrize("hook", HOOKS, ids=lambda hook: hook["id"])
def test_a_hook_calls_a_verb_with_options_that_it_has(hook: dict[str, Any]) -> None:
    program, *words = [*shlex.split(hook["entry"]), *hook.get("args", ())]
    assert (ROOT / program).name == "hook"
    assert os.access(ROOT / program, os.X_OK)
    assert parser().parse_args(words).verb == words[0]
    assert hook["language"] == "script"
    assert not hook["pass_filenames"]


def test_every_verb_that_judges_files_before_a_commit_has_a_hook() -> None:
    assert [hook["id"] for hook in HOOKS] == ["fieldspec-check", "fieldspec-build", "fieldspec-diff"]
    assert all(re.search(hook["files"], "specs/tc100/device.yaml") for hook in HOOKS)
    assert not any(re.search(hook["files"], "README.md") for hook in HOOKS)


def test_the_action_is_a_composite_one_whose_steps_say_their_shell() -> None:
    assert ACTION["runs"]["using"] == "composite"
    steps = ACTION["runs"]["steps"]
    assert all(step["shell"] == "bash" and step["run"] for step in steps)
    passed = re.findall(r"\$\{\{ inputs\.([\w-]+) \}\}", (ROOT / "action.yml").read_text("utf-8"))
    assert set(passed) == set(ACTION["inputs"])
    assert not any("${{" in step["run"] for step in steps)  # texts of others reach a shell only through its variables


def test_every_input_has_a_description_and_a_default() -> None:
    assert all(option["description"] and "default" in option for option in ACTION["inputs"].values())


def test_the_script_calls_verbs_with_options_that_they_have() -> None:
    lines = [line.strip().partition(" >")[0] for line in REVIEW.splitlines() if line.strip().startswith("fieldspec ")]
    assert len(lines) == 5
    for line in lines:
        words = shlex.split(line.replace('"${limit[@]}"', "--fail-on=breaking"))
        assert parser().parse_args(words[1:]).verb in ("check", "diff")


class Repository:
    """A git repository with the specs of one small device, in which the script is run."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for name in ("protocols", "gizmo"):
            shutil.copytree(ROOT / "tests" / "specs" / name, folder / "specs" / name)
        (folder / "bin").mkdir()
        program = folder / "bin" / "fieldspec"
        program.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m fieldspec "$@"\n', "utf-8")
        program.chmod(0o755)
        self.git("init", "--quiet")
        self.git("add", "specs")
        self.git("-c", "user.name=n", "-c", "user.email=e@e", "commit", "--quiet", "--message", "specs")

    def git(self, *words: str) -> None:
        subprocess.run([require_tool("git"), *words], cwd=self.folder, check=True, capture_output=True)

    def rename(self) -> None:
        """Gives a register another name."""
        path = self.folder / "specs" / "gizmo" / "device.yaml"
        text = path.read_text("utf-8")
        assert "name: speed," in text
        path.write_text(text.replace("name: speed,", "name: velocity,", 1), "utf-8")

    def review(self, **inputs: str) -> subprocess.CompletedProcess[str]:
        """Runs the script with some variables."""
        path = f"{self.folder / 'bin'}{os.pathsep}{os.environ['PATH']}"
        clean = {name: value for name, value in os.environ.items() if not name.startswith(("GITHUB_", "GIT_"))}
        return subprocess.run(
            [require_tool("bash"), ROOT / ".ci" / "review"],
            cwd=self.folder,
            env={**clean, "PATH": path, **inputs},
            capture_output=True,
            text=True,
            encoding="utf-8",
        )


@pytest.fixture
def repository(tmp_path: Path) -> Repository:
    return Repository(tmp_path)


def test_nothing_is_reported_where_nothing_has_changed_and_a_folder_may_begin_with_a_dash(
    repository: Repository,
) -> None:
    done = repository.review(BASE="HEAD", SARIF="-out")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    for name in ("check", "diff"):
        sarif = json.loads((repository.folder / "-out" / f"{name}.sarif").read_text("utf-8"))
        assert sarif["runs"][0]["results"] == []


def test_a_breaking_change_is_annotated_and_fails(repository: Repository) -> None:
    repository.rename()
    summary = repository.folder / "summary.md"
    done = repository.review(BASE="HEAD", SARIF="out", GITHUB_STEP_SUMMARY=str(summary))
    assert done.returncode == 1, done.stderr
    (line,) = [line for line in done.stdout.splitlines() if line.startswith("::error")]
    assert "file=specs/gizmo/device.yaml" in line
    assert "renamed" in line
    sarif = json.loads((repository.folder / "out" / "diff.sarif").read_text("utf-8"))
    assert [entry["ruleId"] for entry in sarif["runs"][0]["results"]] == ["renamed"]
    assert "renamed" in summary.read_text("utf-8")


def test_no_change_fails_the_review_unless_an_option_says_so(repository: Repository) -> None:
    repository.rename()
    assert repository.review(BASE="HEAD", FAIL_ON="none").returncode == 0
    assert repository.review(BASE="HEAD", FAIL_ON="any").returncode == 1


def test_without_a_base_the_specs_are_checked_and_nothing_is_compared(repository: Repository) -> None:
    done = repository.review(BASE="0" * 40)
    assert (done.returncode, done.stdout) == (0, "there is nothing to compare with\n")


def test_a_base_that_does_not_exist_is_reported_and_fails(repository: Repository) -> None:
    done = repository.review(BASE="nowhere")
    assert done.returncode == 2
    assert "nowhere" in done.stderr


@pytest.mark.proof(4)
@pytest.mark.parametrize(
    "inputs",
    [
        {"BASE": "--upload-pack=touch planted;"},
        {"BASE": "+HEAD:refs/heads/planted"},
        {"BASE": "HEAD:refs/heads/planted"},
        {"BASE": "--help"},
        {"BASE": "HEAD", "HEAD": "--help"},
        {"BASE": "HEAD", "HEAD": "--no-cache"},
        {"BASE": "HEAD", "SPECS": "--help"},
        {"BASE": "HEAD", "FAIL_ON": "--help"},
    ],
    ids=lambda inputs: " ".join(inputs.values()),
)
def test_no_input_is_an_option_or_writes_a_reference(
    repository: Repository, tmp_path_factory: pytest.TempPathFactory, inputs: dict[str, str]
) -> None:
    origin = tmp_path_factory.mktemp("origin")
    subprocess.run([require_tool("git"), "clone", "--quiet", repository.folder, origin], check=True)
    repository.git("remote", "add", "origin", str(origin))
    done = repository.review(**inputs)
    assert done.returncode == 2, (done.stdout, done.stderr)
    assert "usage:" not in done.stdout
    assert not (repository.folder / "planted").exists()
    assert not (repository.folder / ".git" / "refs" / "heads" / "planted").exists()


def test_a_base_that_only_the_origin_has_is_fetched(
    repository: Repository, tmp_path_factory: pytest.TempPathFactory
) -> None:
    origin = Repository(tmp_path_factory.mktemp("origin"))
    origin.git("-c", "user.name=n", "-c", "user.email=e@e", "commit", "--quiet", "--allow-empty", "--message", "more")
    commit = subprocess.run(
        [require_tool("git"), "rev-parse", "HEAD"], cwd=origin.folder, check=True, capture_output=True, text=True
    ).stdout.strip()
    repository.git("remote", "add", "origin", str(origin.folder))
    assert repository.review(BASE=commit).returncode == 0


PINS = (ROOT / "requirements" / "run.txt").read_text("utf-8")
PINNED = dict(re.findall(r"^([\w.-]+)==([\w.]+)", PINS, re.MULTILINE))


def test_what_reviews_and_hooks_install_is_pinned_as_for_development() -> None:
    development = dict(
        re.findall(r"^([\w.-]+)==([\w.]+)", (ROOT / "requirements" / "dev.txt").read_text("utf-8"), re.MULTILINE)
    )
    assert PINNED.items() <= development.items()
    wanted = [text for text in importlib.metadata.requires("fieldspec") or () if "extra" not in text]
    assert len(wanted) > 5
    assert {re.split(r"[<>=~;]", text)[0].lower() for text in [*wanted, "hatchling"]} <= PINNED.keys()


def wheel(folder: Path, name: str, version: str) -> None:
    """Writes a wheel with the name of another, as a registry that was broken into would have it."""
    stem = f"{name.replace('-', '_')}-{version}"
    with zipfile.ZipFile(folder / f"{stem}-py3-none-any.whl", "w") as file:
        file.writestr(f"{stem}.dist-info/METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")
        file.writestr(f"{stem}.dist-info/WHEEL", "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n")
        file.writestr(f"{stem}.dist-info/RECORD", "")


ACTION_INSTALLS = ["-c", ACTION["runs"]["steps"][0]["run"]]


@pytest.mark.parametrize("arguments", [ACTION_INSTALLS, [".ci/hook", "devices"]], ids=["action", "hook"])
def test_nothing_is_installed_that_has_another_hash(arguments: list[str], tmp_path: Path) -> None:
    packages, checkout = tmp_path / "packages", tmp_path / "checkout"
    packages.mkdir()
    for folder in (".ci", "requirements"):
        shutil.copytree(ROOT / folder, checkout / folder)
    for name, version in PINNED.items():
        wheel(packages, name, version)
    clean = {name: value for name, value in os.environ.items() if not name.startswith("PIP_")}
    places = {"ACTION": str(checkout), "RUNNER_TEMP": str(tmp_path)}
    index = {"PIP_NO_INDEX": "1", "PIP_FIND_LINKS": str(packages), "PIP_CONFIG_FILE": os.devnull}
    done = subprocess.run(
        [require_tool("bash"), *arguments],
        cwd=checkout,
        env={**clean, **places, **index, "PYTHON": sys.executable},
        capture_output=True,
        text=True,
        encoding="utf-8",
    )
    assert done.returncode != 0
    assert "DO NOT MATCH THE HASHES" in done.stderr, done.stderr
    assert not list(tmp_path.rglob("fieldspec*.dist-info"))
