"""The types of expressions, as far as annotations state them."""

from __future__ import annotations

import ast

from fieldspec.targets.explainer.translation.names import Names

_TRUTHS = ("is_", "has_", "can_", "needs_", "_is_", "_has_")
"""The beginnings of names of truth values."""
SAME = ("bool", "str", "int", "str | None")
"""The types whose values are true or false in both languages alike."""


class Types:
    """The types of expressions; `local` has the types of the names in a function."""

    def __init__(self, names: Names) -> None:
        self.names = names
        self.local: dict[str, str] = {}

    def of(self, node: ast.expr) -> str:
        """The annotated type of an expression; empty if it is not known."""
        match node:
            case ast.Constant():
                return type(node.value).__name__
            case ast.JoinedStr():
                return "str"
            case ast.Name(id=name) | ast.Attribute(attr=name) | ast.Call(func=ast.Attribute(attr=name)) if (
                name.startswith(_TRUTHS)
            ):
                return "bool"
            case ast.Name():
                return self.local.get(node.id, "")
            case ast.Attribute():
                return "str" if is_sentence(node) else self.names.types.get(node.attr, "")
            case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name)):
                if name in ("len", "min", "max", "int"):
                    return "int"
                if name in ("join", "format", "hex", "decode", "lower", "upper", "strip", "lstrip", "rstrip", "str"):
                    return "str"
                if name in ("any", "all", "isinstance", "bool", "startswith", "endswith", "issubset"):
                    return "bool"
                return self.names.types.get(f"{name}()", "")
            case ast.Compare():
                return "bool"
            case ast.UnaryOp(op=ast.Not()):
                return "bool"
            case ast.BoolOp():
                types = {self.of(value) for value in node.values}
                return types.pop() if len(types) == 1 else ""
            case ast.IfExp():
                kind = self.of(node.body)
                return kind if kind == self.of(node.orelse) else ""
            case _:
                return ""


def is_sentence(node: ast.Attribute) -> bool:
    """Whether an attribute is a sentence of `codec/explain/sentences.py`."""
    return isinstance(node.value, ast.Name) and node.value.id == "sentences" and node.attr.isupper()
