"""The table of rules is complete: every code in the compiler is in it, and the documentation agrees with it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from compiler_modules import PACKAGE, nodes
from fieldspec.command import rules
from fieldspec.language.checks import table as checks

CHECKS = dict(checks.CHECKS)
PAGE = Path(__file__).parent.parent / "docs" / "checks.md"
GIVE_FINDINGS = ("because", "Diagnostic", "finding", "finding_of", "refuse", "_refuse")


def codes(path: Path) -> Iterator[str]:
    """The codes of the findings of a module: for a check its own name, for other modules the texts that reach the first
    argument of a call in `GIVE_FINDINGS`.
    """
    assigned: dict[str, list[ast.expr]] = {}
    for node in nodes(path):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            assigned.setdefault(node.targets[0].id, []).append(node.value)
    others = {node.name for node in nodes(path) if isinstance(node, ast.FunctionDef) and not takes_code(node)}
    for node in nodes(path):
        if isinstance(node, ast.Call) and node.args and called(node) in GIVE_FINDINGS and not is_other(node, others):
            yield from [path.stem] if path.stem in CHECKS else texts(node.args[0], assigned)


def is_other(node: ast.Call, others: set[str]) -> bool:
    """Whether a call is one of a function of the same module that only shares its name with those of findings."""
    return isinstance(node.func, ast.Name) and node.func.id in others


def takes_code(function: ast.FunctionDef) -> bool:
    """Whether the first argument of a function is the code of a rule; a function of the same name may be another."""
    names = [argument.arg for argument in function.args.args if argument.arg not in ("self", "cls")]
    return names[:1] == ["code"]


def called(node: ast.Call) -> str:
    """The name of the function that is called, without what it is an attribute of."""
    return node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")


def texts(node: ast.expr, assigned: dict[str, list[ast.expr]], depth: int = 3) -> Iterator[str]:
    """The texts that an expression may be, through names and tables of the module."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.Name) and depth:
        for value in assigned.get(node.id, ()):
            yield from texts(value, assigned, depth - 1)
    elif isinstance(node, ast.IfExp):
        yield from texts(node.body, assigned, depth)
        yield from texts(node.orelse, assigned, depth)
    elif isinstance(node, ast.Dict):
        for value in node.values:
            yield from texts(value, assigned, depth)
    elif isinstance(node, ast.Call) and called(node) == "get":
        yield from texts(node.args[1], assigned, depth)
        yield from texts(node.func.value, assigned, depth) if isinstance(node.func, ast.Attribute) else ()


@cache
def codes_by_name() -> dict[str, str]:
    """The codes of all modules of the compiler, with the name of a module that has it; `finding` leaves it empty."""
    return {code: path.name for path in sorted(PACKAGE.rglob("*.py")) for code in codes(path) if code}


def test_every_code_in_the_compiler_has_a_rule() -> None:
    codes_by_file = codes_by_name()
    assert len(codes_by_file) > 80
    assert {code: name for code, name in codes_by_file.items() if rules.rule(code) is None} == {}


def test_every_rule_has_code_that_reports_it() -> None:
    assert {rule.code for rule in rules.all_rules()} - codes_by_name().keys() == set()


def test_checks_are_listed_by_name() -> None:
    names = [name for name, _ in checks.CHECKS]
    assert names == sorted(set(names))
    assert [check.__name__ for _, check in checks.CHECKS] == names


def test_every_module_that_documents_a_check_is_in_the_table() -> None:
    in_table = {check.__module__ for _, check in checks.CHECKS} | {"fieldspec.language.checks.allowances_used"}
    documented = set()
    for path in (PACKAGE / "language" / "checks").glob("*.py"):
        text = ast.get_docstring(ast.parse(path.read_text("utf-8")))
        if text is not None and "Fix: " in text:
            documented.add(f"fieldspec.language.checks.{path.stem}")
    assert documented == in_table


def test_every_other_module_of_their_folder_is_used() -> None:
    # A check that is neither documented nor in the table would judge nothing, and nobody would notice.
    pattern = re.compile(r"from fieldspec\.language\.checks\.(\w+) import")
    used = {name for path in PACKAGE.rglob("*.py") for name in pattern.findall(path.read_text("utf-8"))}
    in_table = {name for name, _ in checks.CHECKS}
    modules = {path.stem for path in (PACKAGE / "language" / "checks").glob("*.py")}
    assert modules - used - in_table == {"__init__"}


def test_page_of_rules_is_fresh(accept: bool) -> None:
    if accept:
        PAGE.write_text(rules.page(), "utf-8", newline="\n")
    assert PAGE.read_text("utf-8") == rules.page()


def test_rules_say_something_in_every_part() -> None:
    for rule in rules.all_rules():
        assert min(map(len, (rule.what, rule.why, rule.example, rule.fix))) > 5, rule.code
        assert rule.what.endswith("."), rule.code
