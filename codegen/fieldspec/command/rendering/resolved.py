"""The tree of a spec as YAML, with a comment after each value that says where it is from."""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.foundation.line_text import visible_text
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence

# Words and ranges need no quotes; what YAML takes for something else than text is not a word.
_WORD = re.compile(r"(?!(?i:y|n|yes|no|on|off|true|false|null)$)[A-Za-z_][\w ()/.-]*(?<! )")
_RANGE = re.compile(r"-?\w+\.\.-?\w+")
_WIDTH = 72


def resolved(tree: Mapping) -> str:
    """The tree in block style, with lists of scalars on one line."""
    return "".join(f"{line}\n" for line in _mapping(tree, ""))


def _mapping(node: Mapping, indent: str) -> Iterator[str]:
    for key, value in node.values.items():
        yield from _entry(f"{indent}{key}:", value, f"{indent}  ")


def _entry(start: str, value: Node, indent: str) -> Iterator[str]:
    """A key, or the dash of an item, with its value."""
    if isinstance(value, Scalar):
        yield _line_with_place(f"{start} {_scalar(value)}", value)
    elif isinstance(value, Sequence) and all(isinstance(item, Scalar) for item in value.items):
        items = ", ".join(_scalar(item) for item in value.items if isinstance(item, Scalar))
        yield _line_with_place(f"{start} [{items}]", value)
    elif isinstance(value, Mapping) and not value.values:
        yield _line_with_place(f"{start} {{}}", value)
    elif isinstance(value, Mapping):
        yield start
        yield from _mapping(value, indent)
    else:
        yield start
        for item in value.items:
            yield from _item(item, indent)


def _item(item: Node, indent: str) -> Iterator[str]:
    if not isinstance(item, Mapping) or not item.values:
        yield from _entry(f"{indent}-", item, f"{indent}  ")
        return
    lines = list(_mapping(item, f"{indent}  "))
    yield f"{indent}- {lines[0][len(indent) + 2 :]}"
    yield from lines[1:]


def _line_with_place(text: str, node: Node) -> str:
    return f"{text:<{_WIDTH}}  # {visible_text(node.span.file.path)}:{node.span.position()[0]}"


def _scalar(node: Scalar) -> str:
    """A scalar in a form that YAML reads as the same value."""
    if isinstance(node.value, bool):
        return "true" if node.value else "false"
    if node.value is None:
        return "~"
    if not isinstance(node.value, str):
        return node.text
    text = node.value
    if (_WORD.fullmatch(text) and text.isascii()) or _RANGE.fullmatch(text):
        return text
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + "".join(char if char.isprintable() else f"\\U{ord(char):08X}" for char in escaped) + '"'
