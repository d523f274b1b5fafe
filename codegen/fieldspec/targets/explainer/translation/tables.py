"""The operators, functions and methods of Python that are translated."""

from __future__ import annotations

import ast

OPERATORS: dict[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Mod: "%",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
}

RENAMED = {
    "lower": "toLowerCase",
    "upper": "toUpperCase",
    "append": "push",
    "replace": "replaceAll",
    "items": "entries",
    "index": "indexOf",
}
"""The methods of Python's types that JavaScript calls otherwise."""

METHODS = (
    "count", "decode", "encode", "endswith", "groups", "hex", "issubset", "join", "lstrip", "rstrip",
    "split", "startswith", "strip", "zfill",
)  # fmt: skip
"""The methods of Python's types that are functions of `py`."""

SAME_METHODS = ("get", "keys", "setdefault", "update", "values")
"""The methods of Python's types that dictionaries of `py` have, too."""

METHODS_OF_PYTHON = frozenset(name for kind in (str, bytes, list, dict, set, int) for name in dir(kind))

FUNCTIONS = (
    "all", "any", "bool", "bytes", "chr", "dict", "enumerate", "frozenset", "int", "islice", "list", "max",
    "min", "next", "range", "repr", "reversed", "sorted", "str", "sum", "tuple", "zip",
)  # fmt: skip
"""The functions of Python that `py` has, too."""

TYPES = {"int": "isWhole", "list": "isList"}
"""The functions of `py` that ask for a type of Python."""

OF_DATA = {"sources": "source", "printed_name": "printed"}
"""The attributes of facts that the data call otherwise."""

LEFT_OUT = ("__eq__", "__hash__", "clears_on_read", "handlings", "restart")
"""The methods that explanations in JavaScript do not need."""
