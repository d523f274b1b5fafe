"""Reads JSON after bounding its values and levels: a short text can ask for more memory than there is."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any

from fieldspec.tools.lists.sheet import ListError

DEEPEST = 16
MOST_VALUES = 2_000_000

_SIGN = re.compile(r'["\\\[\]{},]')
_LONGEST_BY_HAND = 1 << 22
"""The characters of a text that people write, with comments and with commas before closing brackets."""

_COMMENT = re.compile(r'("(?:[^"\\]|\\.)*"?)|//[^\n]*|/\*.*?(?:\*/|\Z)', re.DOTALL)
_LAST_COMMA = re.compile(r'("(?:[^"\\]|\\.)*"?)|,(?=\s*[\]}])', re.DOTALL)


def json_data(text: str, pairs: Callable[[list[tuple[str, Any]]], Any] | None = None) -> Any:
    """The data of a JSON text, which may have comments, and commas before closing brackets. `pairs` builds an object
    from its pairs. Raises ListError."""
    try:
        return _data(text, pairs)
    except ListError:
        if len(text) > _LONGEST_BY_HAND:
            raise
        return _data(_LAST_COMMA.sub(_in_text, _COMMENT.sub(_in_text, text)), pairs)


def _in_text(match: re.Match[str]) -> str:
    """A text in quotes as it is; blanks for anything else, with its lines."""
    return match[1] or re.sub(r"[^\n]", " ", match[0])


def _data(text: str, pairs: Callable[[list[tuple[str, Any]]], Any] | None) -> Any:
    _count(text)
    try:
        return json.loads(text, object_pairs_hook=pairs, strict=False)
    except json.JSONDecodeError as error:
        raise ListError(f"begins like JSON but is not JSON: line {error.lineno}, {error.msg}") from None
    except (ValueError, RecursionError):
        raise ListError("begins like JSON but is not JSON") from None


def _count(text: str) -> None:
    """Raises ListError for a text with too many values or levels."""
    depth = values = escaped = 0
    is_text = False
    for match in _SIGN.finditer(text):
        sign, position = match[0], match.start()
        if position < escaped:
            continue
        if sign == "\\":
            escaped = position + 2
        elif sign == '"':
            is_text = not is_text
        elif is_text:
            continue
        elif sign == ",":
            values += 1
        elif sign in "[{":
            depth += 1
            values += 1
        else:
            depth -= 1
        if depth > DEEPEST:
            raise ListError(f"is JSON that is nested more than {DEEPEST} levels deep; a list of registers is not")
        if values > MOST_VALUES:
            raise ListError(f"is JSON with more than {MOST_VALUES} values; a list of registers has fewer")
