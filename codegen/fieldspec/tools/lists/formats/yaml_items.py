"""Reads YAML of other programs: its tags are left out, as nothing of a list is in them."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping as Map
from decimal import Decimal

from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence
from fieldspec.language.reading.yaml_reader import decoded, parsed
from fieldspec.tools.lists.formats.format_rows import decimal
from fieldspec.tools.lists.sheet import ListError

_TAG = re.compile(r"(?m)(?<=[:\-\[,{?] )![A-Za-z_]*|^![A-Za-z_]+")

_ALIAS = re.compile(r"(?m)(?<=: )\*([A-Za-z_]\w*)(?=[ \t]*(?:#.*)?$)")
"""A reference to a value, which a part of a file may lack."""


def tree(text: str) -> Node:
    """The tree of a file. Raises ListError."""
    bare = _TAG.sub(lambda match: " " * len(match[0]), text)
    bare = _ALIAS.sub(lambda match: match[0] if f"&{match[1]}" in text else f" {match[1]}", bare)
    file, problems = decoded("", bare.encode("utf-8", "replace"))
    node: Node | None = None
    if not problems:
        node, problems = parsed(file)
    if problems or node is None:
        place = f" in line {problems[0].span.position()[0]}" if problems else ""
        raise ListError(f"is not YAML{place}: {problems[0].message if problems else 'it is empty'}")
    return node


def line_of(node: Node) -> int:
    """The line of a node, from 1."""
    return node.span.position()[0]


def items(node: Node | None) -> list[Node]:
    """The items of a list; a mapping is a list of one."""
    if isinstance(node, Sequence):
        return list(node.items)
    return [node] if isinstance(node, Mapping) else []


def text_of(node: Node | None) -> str:
    """The text of a scalar; empty for none, and for what is not one."""
    if not isinstance(node, Scalar) or (not node.quoted and node.text in ("~", "null")):
        return ""
    return node.text.strip()


def number_of(node: Node | None) -> Decimal | None:
    """The number of a scalar; None if it is not a number."""
    return decimal(text_of(node))


def whole_of(node: Node | None) -> int | None:
    """The whole number of a scalar; None if it is not a whole number."""
    number = number_of(node)
    return int(number) if number is not None and number == number.to_integral_value() else None


def numbers_of(node: Node | None) -> list[int] | None:
    """The whole numbers of a list, or of one scalar; None if one of them is not a whole number."""
    nodes = node.items if isinstance(node, Sequence) else [node]
    numbers = [number for node in nodes if (number := whole_of(node)) is not None]
    return numbers if len(numbers) == len(nodes) else None


def cells_of(mapping: Mapping) -> Map[str, str]:
    """The keys of a mapping with their texts; lists and mappings as JSON."""
    return {
        key: json.dumps(data_of(node), ensure_ascii=False) if not isinstance(node, Scalar) else text_of(node)
        for key, node in mapping.values.items()
    }


def data_of(node: Node) -> object:
    """The data of a tree, whose scalars are texts."""
    if isinstance(node, Mapping):
        return {key: data_of(inner) for key, inner in node.values.items()}
    return [data_of(item) for item in node.items] if isinstance(node, Sequence) else text_of(node)
