"""The texts of the program are in plain English: findings, messages, help, and the documentation in the code.

The pages are judged too, by `test_docs_pages.py`: the rules, the descriptions of keys and `--help` are among them.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

from compiler_modules import PACKAGE, nodes
from english_patterns import hits

ROOT = Path(__file__).resolve().parent.parent
Nodes = tuple[ast.AST, ...]
FINDINGS = (*ROOT.glob("tests/cases/*/*/expected.txt"), *ROOT.glob("tests/changes/*/expected.txt"))


def _docstrings(module: Nodes) -> Iterator[ast.Constant]:
    """The docstrings of a module, its classes, functions and values."""
    for node in module:
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            yield node.value


def _messages(module: Nodes) -> Iterator[str]:
    """The texts of a module that are no docstrings, each as a whole; a value in a text is one letter."""
    others = set(_docstrings(module))
    for node in module:
        if isinstance(node, ast.JoinedStr):
            others.update(part for part in node.values if isinstance(part, ast.Constant))
            yield "".join(str(part.value) if isinstance(part, ast.Constant) else "`x`" for part in node.values)
    for node in module:
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and node not in others:
            yield node.value


def _modules(folder: Path) -> Iterator[tuple[str, Nodes]]:
    for path in sorted(folder.rglob("*.py")):
        yield str(path.relative_to(PACKAGE)), nodes(path)


def test_findings_are_in_plain_english() -> None:
    assert [f"{path}:{hit}" for path in FINDINGS for hit in hits(path.read_text("utf-8"))] == []


def test_messages_are_in_plain_english() -> None:
    """Every text with several words that the compiler prints or writes."""
    texts = ((path, text) for path, module in _modules(PACKAGE) for text in _messages(module) if " " in text)
    assert [f"{path}: {text[:60]!r}: {hit}" for path, text in texts for hit in hits(text)] == []


@pytest.mark.parametrize("folder", ["codec", "command", "foundation", "language", "targets", "tools"])
def test_docstrings_are_in_plain_english(folder: str) -> None:
    modules = _modules(PACKAGE / folder)
    docstrings = ((path, str(text.value)) for path, module in modules for text in _docstrings(module))
    all_hits = [f"{path}: {hit}" for path, text in docstrings for hit in hits(text)]
    assert all_hits == []
