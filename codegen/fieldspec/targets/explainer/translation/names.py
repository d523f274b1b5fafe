"""The names and the types of translated modules."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

_RESERVED = {"arguments", "default", "function", "new", "var", "switch", "this", "delete", "typeof", "package"}
"""Words that cannot be names in JavaScript."""


class Untranslatable(Exception):
    """A construct that has no translation."""

    def __init__(self, module: str, node: ast.AST, reason: str) -> None:
        super().__init__(f"{module}.py:{getattr(node, 'lineno', 0)}: {reason}")


def camel(name: str) -> str:
    """A name with capitals in place of `_`, which stays where it is the first character."""
    head, tail = name[: len(name) - len(name.lstrip("_"))], name.lstrip("_")
    if tail.isupper():
        return name
    result = head + re.sub(r"_+([a-z0-9])", lambda match: match[1].upper(), tail)
    return f"{result}_" if result in _RESERVED else result


class Names:
    """What all translated modules declare: the types of attributes and of results, and the fields of data classes.

    Names of functions end with `()`. A type is empty where names that are alike have several.
    """

    def __init__(self, modules: dict[str, ast.Module]) -> None:
        self.modules = modules
        self.types: dict[str, str] = {}
        self.data_classes: dict[str, tuple[str, ...]] = {}
        for tree in modules.values():
            for node in ast.walk(tree):
                if isinstance(node, ast.FunctionDef) and node.returns is not None:
                    self._add_type(node.name if node.decorator_list else f"{node.name}()", node.returns)
                elif isinstance(node, ast.ClassDef):
                    fields = [statement for statement in node.body if isinstance(statement, ast.AnnAssign)]
                    for field in fields:
                        self._add_type(ast.unparse(field.target), field.annotation)
                    if is_data_class(node):
                        self.data_classes[node.name] = tuple(ast.unparse(field.target) for field in fields)

    def _add_type(self, name: str, annotation: ast.expr) -> None:
        text = ast.unparse(annotation)
        self.types[name] = text if self.types.get(name, text) == text else ""


def is_data_class(node: ast.ClassDef) -> bool:
    """Whether a class has the decorator of data classes."""
    return any("dataclass" in ast.unparse(decorator) for decorator in node.decorator_list)


def declared(tree: ast.Module) -> Iterator[str]:
    """The names that a module declares."""
    for node in tree.body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            yield node.name
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            for target in node.targets if isinstance(node, ast.Assign) else [node.target]:
                yield from (inner.id for inner in ast.walk(target) if isinstance(inner, ast.Name))
