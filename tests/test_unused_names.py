"""What a module of the compiler defines is used: by the module, by another one, or by name, with the reason."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterable, Iterator

from compiler_modules import MODULES, inside, nodes, tree

USED_ELSEWHERE = {
    "add_live": "cli.py joins the name of each verb after `add_`",
    "add_mcp": "cli.py joins the name of each verb after `add_`",
    "add_redact": "cli.py joins the name of each verb after `add_`",
    "add_simulate": "cli.py joins the name of each verb after `add_`",
    **dict.fromkeys(
        ("Framing", "count_of_quantity", "printed_number", "special_number", "state_name"),
        "the judges of random devices ask the reference",
    ),
    "changes_page": "a test writes docs/changes.md with it and keeps it fresh",
}


def defined(module: ast.Module) -> Iterator[tuple[str, ast.stmt]]:
    """The names that a module defines, with their definitions."""
    for node in module.body:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield node.name, node
        elif isinstance(node, (ast.Assign, ast.AnnAssign)):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            yield from (
                (name.id, node) for target in targets for name in ast.walk(target) if isinstance(name, ast.Name)
            )


def read(part: Iterable[ast.AST]) -> Counter[str]:
    """How often each name is read."""
    return Counter(node.id for node in part if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load))


def named_from_outside(modules: Iterable[ast.AST]) -> set[str]:
    """The names that modules import, read as attributes, or have in a text, as lazy imports of the command line do."""
    names: set[str] = set()
    for node in modules:
        if isinstance(node, ast.ImportFrom):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.Attribute):
            names.add(node.attr)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and re.fullmatch(r"\w+", node.value):
            names.add(node.value)
    return names


def test_every_name_that_a_module_defines_is_used() -> None:
    outside = named_from_outside(node for path in MODULES for node in nodes(path))
    unused = set()
    for path in MODULES:
        reads = read(nodes(path))
        for name, definition in defined(tree(path)):
            if name not in outside and not name.startswith("__") and reads[name] == read(ast.walk(definition))[name]:
                unused.add((name, inside(path)))
    assert {(name, path) for name, path in unused if name not in USED_ELSEWHERE} == set()
    assert USED_ELSEWHERE.keys() - {name for name, _ in unused} == set()
