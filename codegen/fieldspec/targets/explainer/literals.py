"""Data as literals of JavaScript, in ASCII, which also stand safely within HTML."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence

from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.targets.pieces import content_piece

if TYPE_CHECKING:
    from typing import TypeAlias


class Code(str):
    """An expression of JavaScript, which stands among data as it is."""

    __slots__ = ()


Data: TypeAlias = "bool | int | float | str | Sequence[Data] | Mapping[str, Data] | None"

EXACT = 2**53 - 1
"""Whole numbers up to this one are exact as numbers of JavaScript; all others are bigints."""


def literal(data: Data) -> str:
    """The literal of some data, in one line. Whole numbers that a number does not hold exactly are bigints."""
    if isinstance(data, Code):
        return data
    if isinstance(data, str):
        return json.dumps(data).replace("</", "<\\/").replace("<!--", "<\\u0021--")
    if isinstance(data, Mapping):
        return f"{{{', '.join(f'{_key(key)}: {literal(value)}' for key, value in data.items())}}}"
    if isinstance(data, Sequence):
        return f"[{', '.join(map(literal, data))}]"
    if isinstance(data, int) and not isinstance(data, bool) and abs(data) > EXACT:
        return f"{data}n"
    return json.dumps(data)


def _key(name: str) -> str:
    """A property; in brackets, so that no name sets the prototype of the object."""
    return f'["{name}"]' if name == "__proto__" else literal(name)


def lines(data: Mapping[str, Data], depth: int, indent: int = 0) -> str:
    """The literal of some data with a line for each entry, down to a depth, so that versions of it compare well."""
    margin = " " * (indent + 1)
    rows = []
    for key, value in data.items():
        if depth > 1 and isinstance(value, Mapping) and value:
            text = lines(value, depth - 1, indent + 1)
        elif depth > 1 and isinstance(value, list) and value:
            inner = "".join(f"{margin} {_item(item)},\n" for item in value)
            text = f"[\n{inner}{margin}]"
        else:
            text = _item(value)
        rows.append(f"{margin}{_key(key)}: {text},\n")
    return f"{{\n{''.join(rows)}{' ' * indent}}}"


def _item(data: Data) -> str:
    """The literal of what has a line of its own, which versions and saves share."""
    return content_piece("literal of JavaScript", data, (), lambda: literal(data))
