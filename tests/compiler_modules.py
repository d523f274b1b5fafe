"""The modules of the compiler as trees, and what they import."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

PACKAGE = Path(__file__).parent.parent / "codegen" / "fieldspec"

# Python that is copied into an output is a text like any other, not a module of the compiler.
GENERATED = "runtime"
MODULES = sorted(path for path in PACKAGE.rglob("*.py") if GENERATED not in path.parts)


def inside(path: Path) -> str:
    return path.relative_to(PACKAGE).as_posix()


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text("utf-8"))


@cache
def nodes(path: Path) -> tuple[ast.AST, ...]:
    """All nodes of the tree of a module. To walk through a tree takes longer than to parse it."""
    return tuple(ast.walk(tree(path)))


def module_name(path: Path) -> str:
    """`fieldspec.language.model.device`, and `fieldspec.language` for the module of a folder."""
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts).removesuffix(".__init__")


NAMES = {module_name(path): path for path in MODULES}


@cache
def imported(path: Path) -> frozenset[str]:
    """The modules that a module imports, wherever in it and whatever for; those of a folder by their own names."""
    return frozenset(_imported(path))


def _imported(path: Path) -> Iterator[str]:
    for node in nodes(path):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{inside(path)} imports by a relative path"
            assert node.module
            modules = {f"{node.module}.{alias.name}" for alias in node.names} & NAMES.keys()
            yield from modules
            if len(modules) < len(node.names):
                yield node.module
