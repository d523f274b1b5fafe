"""Names follow docs/naming.md: a word that it forbids is in no name of the compiler, its tests or its outputs."""

from __future__ import annotations

import ast
import io
import json
import keyword
import re
import tokenize
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from compiler_modules import PACKAGE, nodes

ROOT = Path(__file__).parent.parent
GLOSSARY = "".join((ROOT / "docs" / name).read_text("utf-8") for name in ("glossary.md", "naming.md"))
SCHEMA = PACKAGE / "language" / "schema" / "spec.schema.json"
OUTSIDE = {"node_modules", ".venv", "__pycache__"}


def forbidden() -> frozenset[str]:
    """The words of the first column of the table of forbidden words."""
    section = GLOSSARY.partition("## Forbidden words")[2].partition("Some libraries")[0]
    return frozenset(re.findall(r"^\| `(\w+)` \|", section, re.MULTILINE))


def exempt() -> frozenset[str]:
    """The names that are not ours to choose."""
    section = GLOSSARY.partition("Some libraries")[2].partition("\n## ")[0]
    return frozenset(re.findall(r"^\| `(\w+)` \|", section, re.MULTILINE))


def bare_words() -> frozenset[str]:
    """The words that are not whole names inside functions: those in the first column of their table."""
    section = GLOSSARY.partition("## Bare words inside functions")[2]
    rows = re.findall(r"^\| (`.*?) \|", section, re.MULTILINE)
    return frozenset(word for row in rows for word in re.findall(r"`(\w+)`", row))


FORBIDDEN = forbidden()
EXEMPT = exempt()
BARE = bare_words()


def words(name: str) -> set[str]:
    """The words of an identifier, parted at underscores and capitals."""
    return set(re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower().split("_"))


def names(nodes: Iterable[ast.AST]) -> Iterator[tuple[int, str]]:
    """The names that some nodes of Python bind, with their lines."""
    for node in nodes:
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            if not node.name.startswith("test_"):
                yield node.lineno, node.name
        elif isinstance(node, ast.ClassDef):
            yield node.lineno, node.name
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            if node.id not in EXEMPT or not is_attribute(node):
                yield node.lineno, node.id
        elif isinstance(node, ast.arg):
            if node.arg != "frozen":  # the argument of `dataclass`, which `classes` has too
                yield node.lineno, node.arg
        elif isinstance(node, ast.alias):
            yield from ((node.lineno, name) for name in (node.asname or "",) if name)
        elif isinstance(node, ast.ExceptHandler | ast.MatchAs | ast.MatchStar) and node.name:
            yield node.lineno, node.name


def is_attribute(node: ast.Name) -> bool:
    """Whether a name is stored at the indentation of a class body, as an attribute of a class of data."""
    return node.col_offset == 4 and node.id == "one"


def is_wrong(name: str) -> bool:
    return bool(words(name) & FORBIDDEN)


def folder(path: Path) -> str:
    """The folder under which a file is counted: that of the compiler, of tests, or the first one below the root."""
    if PACKAGE in path.parents:
        parts = path.relative_to(PACKAGE).parts
        return "/".join(parts[: min(2, len(parts) - 1)] or parts[:1])
    parts = path.relative_to(ROOT).parts[:-1]
    return "/".join(parts[:2] if parts[0] == "tests" else parts[:1])


def python_files() -> list[Path]:
    return sorted(
        path
        for base in ("codegen", "tests", "benchmarks")
        for path in (ROOT / base).rglob("*.py")
        if not OUTSIDE & set(path.relative_to(ROOT).parts)
    )


def files_by_folder() -> dict[str, list[Path]]:
    """All Python files by the folder under which they are counted."""
    files: dict[str, list[Path]] = {}
    for path in python_files():
        files.setdefault(folder(path), []).append(path)
    return files


FILES = files_by_folder()


def wrong_names(path: Path) -> list[str]:
    """The places of names with a forbidden word in a file, its own name included."""
    place = path.relative_to(ROOT).as_posix()
    own = not path.stem.startswith("test_") and is_wrong(path.stem)
    places = [f"{place}: the name of the file"] if own else []
    return places + [f"{place}:{line}: {name}" for line, name in names(nodes(path)) if is_wrong(name)]


def test_the_glossary_forbids_words() -> None:
    assert len(FORBIDDEN) > 20
    assert {"one", "frozen"} == EXEMPT


def code_names() -> set[str]:
    """The names in the column `code` of the tables of concepts."""
    rows = [row.split("|") for row in GLOSSARY.partition("## Forbidden words")[0].splitlines() if row.startswith("|")]
    return {part for row in rows for name in re.findall(r"`([\w.]+)`", row[2]) for part in name.split(".")}


def test_names_of_code_are_in_the_compiler() -> None:
    expected = code_names()
    assert {"DeviceLayout", "FrameLayout", "Register"} <= expected
    every = (node for path in PACKAGE.rglob("*.py") for node in nodes(path))
    compiler = {getattr(node, name, None) for node in every for name in ("id", "attr", "name", "arg")}
    assert expected - compiler == set()


@pytest.mark.parametrize("name", sorted(FILES))
def test_names_follow_the_glossary(name: str) -> None:
    wrong = [place for path in FILES[name] for place in wrong_names(path)]
    assert wrong == [], "\n".join(wrong)


def names_inside(path: Path) -> Iterator[tuple[int, str]]:
    """The names that the functions of a file bind: parameters, local values and inner functions, with their lines."""
    seen: set[tuple[int, str]] = set()
    for function in nodes(path):
        if isinstance(function, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            body = [function.body] if isinstance(function, ast.Lambda) else function.body
            for part in (function.args, *body):
                seen |= set(names(ast.walk(part)))
    yield from sorted(seen)


def bare_names(name: str) -> list[str]:
    """The places in a folder of the compiler of names inside functions that are a bare word."""
    files = [path for path in FILES[name] if PACKAGE in path.parents]
    return [
        f"{path.relative_to(ROOT).as_posix()}:{line}: {bound}"
        for path in files
        for line, bound in names_inside(path)
        if bound.strip("_") in BARE
    ]


COMPILER = sorted(name for name in FILES if any(PACKAGE in path.parents for path in FILES[name]))


@pytest.mark.parametrize("name", COMPILER)
def test_names_inside_functions_say_what_they_are(name: str) -> None:
    assert {"at", "most", "should"} <= BARE
    wrong = bare_names(name)
    assert wrong == [], "\n".join(wrong)


def keys(schema: object) -> Iterator[str]:
    """All keys that a part of the schema declares."""
    if isinstance(schema, dict):
        yield from schema.get("properties", {}) if isinstance(schema.get("properties"), dict) else ()
        for part in schema.values():
            yield from keys(part)
    elif isinstance(schema, list):
        for part in schema:
            yield from keys(part)


def test_keys_of_specs_follow_the_glossary() -> None:
    declared = set(keys(json.loads(SCHEMA.read_text("utf-8"))))
    assert len(declared) > 100
    assert sorted(key for key in declared - EXEMPT if is_wrong(key)) == []


def generated_names() -> Iterator[tuple[str, str]]:
    """The names in the runtime of the generated Python, which every user of it reads."""
    for path in sorted((PACKAGE / "foundation" / "runtime").glob("*.py")):
        for token in tokenize.generate_tokens(io.StringIO(path.read_text("utf-8")).readline):
            if token.type == tokenize.NAME and not keyword.iskeyword(token.string):
                yield path.name, token.string


def test_public_names_of_generated_code_follow_the_glossary() -> None:
    assert sorted({(path, name) for path, name in generated_names() if is_wrong(name)}) == []


TEXT = """
def held_value(given: int) -> int:
    for one in [given]:
        kept = one
    return kept
"""


def test_a_forbidden_word_is_seen_in_a_name(tmp_path: Path) -> None:
    path = tmp_path / "module.py"
    path.write_text(TEXT, "utf-8")
    assert {name for _, name in names(nodes(path)) if is_wrong(name)} == {"held_value", "given", "one", "kept"}
