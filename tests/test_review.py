"""The files for pre-commit and for GitHub use existing verbs and options, and do what they describe."""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
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
    assert program == "fieldspec"
    assert parser().parse_args(words).verb == words[0]
    assert hook["language"] == "python"
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
        words = shlex.split(line.replace('"${limit[@]}"', "--fail-on breaking"))
        assert parser().parse_args(words[1:]).verb in ("check", "diff")


class Repository:
    """A git repository with the specs of one device, in which the script is run."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for name in ("protocols", "tc100"):
            shutil.copytree(ROOT / "specs" / name, folder / "specs" / name)
        (folder / "bin").mkdir()
        program = folder / "bin" / "fieldspec"
        program.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -m fieldspec "$@"\n', "utf-8")
        program.chmod(0o755)
        self.git("init", "--quiet")
        self.git("add", "specs")
        self.git("-c", "user.name=n", "-c", "user.email=e@e", "commit", "--quiet", "--message", "specs")

    def git(self, *words: str) -> None:
        subprocess.run([require_tool("git"), *words], cwd=self.folder, check=True, capture_output=True)

    def change(self, old: str, new: str) -> None:
        """Changes the file of the parameters."""
        path = self.folder / "specs" / "tc100" / "registers-parameters.yaml"
        text = path.read_text("utf-8")
        assert old in text
        path.write_text(text.replace(old, new, 1), "utf-8")

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


def test_nothing_is_reported_where_nothing_has_changed(repository: Repository) -> None:
    done = repository.review(BASE="HEAD", SARIF="out")
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    for name in ("check", "diff"):
        sarif = json.loads((repository.folder / "out" / f"{name}.sarif").read_text("utf-8"))
        assert sarif["runs"][0]["results"] == []


def test_a_breaking_change_is_annotated_and_fails(repository: Repository) -> None:
    repository.change("position_correction_speed_limit", "correction_speed_limit")
    summary = repository.folder / "summary.md"
    done = repository.review(BASE="HEAD", SARIF="out", GITHUB_STEP_SUMMARY=str(summary))
    assert done.returncode == 1, done.stderr
    (line,) = [line for line in done.stdout.splitlines() if line.startswith("::error")]
    assert "file=specs/tc100/registers-parameters.yaml" in line
    assert "renamed" in line
    sarif = json.loads((repository.folder / "out" / "diff.sarif").read_text("utf-8"))
    assert [entry["ruleId"] for entry in sarif["runs"][0]["results"]] == ["renamed"]
    assert "renamed" in summary.read_text("utf-8")


def test_no_change_fails_the_review_unless_an_option_says_so(repository: Repository) -> None:
    repository.change("position_correction_speed_limit", "correction_speed_limit")
    assert repository.review(BASE="HEAD", FAIL_ON="none").returncode == 0
    assert repository.review(BASE="HEAD", FAIL_ON="any").returncode == 1


def test_without_a_base_the_specs_are_checked_and_nothing_is_compared(repository: Repository) -> None:
    done = repository.review(BASE="0" * 40)
    assert (done.returncode, done.stdout) == (0, "there is nothing to compare with\n")


def test_a_base_that_does_not_exist_is_reported_and_fails(repository: Repository) -> None:
    done = repository.review(BASE="nowhere")
    assert done.returncode == 2
    assert "nowhere" in done.stderr
