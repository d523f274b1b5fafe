"""The modules of `codec/explain` that are translated, and where names of the others stand in JavaScript."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache

from fieldspec.targets.explainer.translation.expressions import Expressions
from fieldspec.targets.explainer.translation.names import Names, Untranslatable, camel, declared
from fieldspec.targets.explainer.translation.statements import Statements
from fieldspec.targets.explainer.translation.tables import FUNCTIONS
from fieldspec.targets.templates import text

TRANSLATED = (
    "lines", "frame_sizes", "recognition", "readings", "open_requests", "row", "explained_frame", "frame_rows", "body",
    "spans", "occupants", "registers", "parameters",
)  # fmt: skip
"""The modules of `codec/explain` that are translated."""

RUNTIME_MODULES = (
    "texts", "python", "interpreter", "links", "layouts", "device", "values", "percentages", "parameter_sets",
    "explanation",
)  # fmt: skip
"""The modules of the runtime that translated ones import from."""

_EXPORTED = re.compile(r"^export (?:function|class|const) (?:(\w+)|\[(.*?)\])", re.MULTILINE)


@cache
def _names() -> Names:
    return Names({name: ast.parse(text(f"codec/explain/{name}.py")) for name in TRANSLATED})


def _spelling(module: str, name: str) -> str:
    """What JavaScript calls a name of a module: a private one with the name of the module, as scripts are joined."""
    bare = name.lstrip("_")
    if name == bare:
        return name if name.isupper() else camel(name)
    if name.isupper():
        return f"{module.upper()}_{bare}"
    joined = f"{module}_{bare}"
    return camel(joined) if bare[0].islower() else f"{camel(module)[0].upper()}{camel(module)[1:]}{bare}"


@cache
def _homes() -> dict[str, str]:
    """The modules by the names that they export in JavaScript."""
    homes = {"SENTENCES": "sentences"}
    for module in RUNTIME_MODULES:
        for match in _EXPORTED.finditer(text(f"targets/explainer/runtime/{module}.js")):
            homes |= dict.fromkeys((match[1] or match[2]).split(", "), module)
    for module, tree in _names().modules.items():
        homes |= {_spelling(module, name): module for name in declared(tree) if not name.startswith("_")}
    return homes


def _imported(tree: ast.Module) -> Iterator[str]:
    for node in tree.body:
        if isinstance(node, ast.ImportFrom):
            yield from (alias.name for alias in node.names if alias.name not in (*FUNCTIONS, "replace"))


@cache
def translated(module: str) -> str:
    """The text of a module of `codec/explain` in JavaScript. Raises Untranslatable."""
    tree = _names().modules[module]
    own = {name: _spelling(module, name) for name in declared(tree)}
    expressions = Expressions(module, _names(), {**{name: camel(name) for name in _imported(tree)}, **own})
    statements = Statements(expressions)
    parts = ["\n".join(statements.top(node)) for node in tree.body]
    for number, node in enumerate(tree.body):
        if number and isinstance(node, ast.Expr):  # the comment of the constant before it
            parts[number - 1 : number + 1] = ["", parts[number - 1] and f"{parts[number]}\n{parts[number - 1]}"]
    body = "\n\n".join(part for part in parts if part)
    homes: dict[str, list[str]] = {}
    for name in sorted(expressions.used - set(own.values())):
        if name not in _homes():
            raise Untranslatable(module, tree, f"no module of JavaScript has {name}")
        homes.setdefault(_homes()[name], []).append(name)
    homes["python"] = ["py"]
    imports = [f'import {{ {", ".join(names)} }} from "./{home}.js";' for home, names in homes.items()]
    return "\n".join([*imports, "", body, ""])
