"""Every rule of changes has a folder `changes/<rule>` with an old spec, a new one, and the changes between them.

`old/*.yaml` and `new/*.yaml` are files of one device, as are `device.yaml` beside all folders, and `common.yaml` in a
folder, which both sides have. `expected.txt` holds all changes that are found.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import pytest

from fieldspec.command import rules
from fieldspec.command.rendering.changes import places
from fieldspec.foundation.line_text import visible_text
from fieldspec.language.changes import rules as functions_of_rules
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.table import RULES, changes
from fieldspec.language.model.device import Device
from fieldspec.language.reading.project import read

CASES = Path(__file__).parent / "changes"
FOLDERS = sorted(path for path in CASES.iterdir() if path.is_dir())
PAGE = Path(__file__).parent.parent / "docs" / "changes.md"


@cache
def devices(folder: Path) -> tuple[Device, Device]:
    """The old and the new device of a folder."""
    device_models = []
    for side in ("old", "new"):
        files = {"gadget/device.yaml": CASES / "device.yaml", "gadget/common.yaml": folder / "common.yaml"}
        files |= {f"gadget/{side}_{path.name}": path for path in sorted((folder / side).glob("*.yaml"))}
        project = read({path: file.read_bytes() for path, file in files.items() if file.exists()})
        assert [finding.message for finding in project.findings] == []
        spec = project.devices["gadget"]
        device, findings = spec.at(spec.versions()[-1])
        assert [finding.message for finding in findings] == []
        device_models.append(device)
    return device_models[0], device_models[1]


def concise(changes: Iterable[Change]) -> str:
    """A short form: class, rule, path and message; then the values, the places and the outputs."""
    text = ""
    for change in changes:
        text += visible_text(f"{change.effect.value} {change.rule} {change.path}: {change.message}") + "\n"
        values = f"{change.old or '-'} -> {change.new or '-'}"
        outputs = f"; {', '.join(change.outputs)}" if change.outputs else ""
        text += visible_text(f"  {values}; {places(change)}{outputs}") + "\n"
    return text


def changes_of(folder: Path) -> list[Change]:
    return changes(*devices(folder))


def name(folder: Path) -> str:
    return folder.name


@pytest.mark.parametrize("folder", FOLDERS, ids=name)
def test_the_changes_between_two_specs_are_found(folder: Path, accept: bool) -> None:
    text = concise(changes_of(folder))
    expected = folder / "expected.txt"
    if accept:
        expected.write_text(text, "utf-8", newline="\n")
    assert text == expected.read_text("utf-8")


@pytest.mark.parametrize(
    ("rule", "effects"), [(code, effects) for code, _, effects in RULES], ids=lambda param: str(param)
)
def test_every_rule_has_a_folder_that_shows_each_of_its_classes(rule: str, effects: tuple[Effect, ...]) -> None:
    assert {change.effect for change in changes_of(CASES / rule) if change.rule == rule} == set(effects)


def test_every_folder_belongs_to_a_rule() -> None:
    assert {folder.name for folder in FOLDERS} == {code for code, _, _ in RULES}


@pytest.mark.parametrize("folder", FOLDERS, ids=name)
def test_a_spec_does_not_differ_from_itself(folder: Path) -> None:
    assert [changes(side, side) for side in devices(folder)] == [[], []]


@pytest.mark.parametrize("folder", FOLDERS, ids=name)
def test_every_change_has_values_places_and_a_class_of_its_rule(folder: Path) -> None:
    effects = {code: class_effects for code, _, class_effects in RULES}
    for change in changes_of(folder):
        assert change.effect in effects[change.rule]
        assert change.old != change.new
        if change.what not in ("line of versions", "version"):
            assert (change.before, change.after) != (None, None)
        assert change.path
        assert not change.path.startswith("/")
        if change.effect is Effect.SOURCE:
            assert change.outputs


def test_rules_are_listed_by_name() -> None:
    names = [code for code, _, _ in RULES]
    assert names == sorted(set(names))
    assert [rule.__name__ for _, rule, _ in RULES] == names


def test_every_function_that_documents_a_rule_is_in_the_table() -> None:
    folder = Path(functions_of_rules.__file__).parent
    functions = [node for path in folder.glob("*.py") for node in ast.parse(path.read_text("utf-8")).body]
    documented = {
        node.name
        for node in functions
        if isinstance(node, ast.FunctionDef) and "\nFix: " in (ast.get_docstring(node) or "")
    }
    assert documented == {code for code, _, _ in RULES}


def test_names_of_changes_are_no_names_of_findings() -> None:
    assert {rule.code for rule in rules.all_rules()} & {code for code, _, _ in RULES} == set()


def test_page_of_changes_is_fresh(accept: bool) -> None:
    if accept:
        PAGE.write_text(rules.changes_page(), "utf-8", newline="\n")
    assert PAGE.read_text("utf-8") == rules.changes_page()


def test_rules_of_changes_say_something_in_every_part() -> None:
    for rule in rules.change_rules():
        assert min(map(len, (rule.what, rule.why, rule.example, rule.fix))) > 5, rule.code
        assert rule.what.endswith("."), rule.code
