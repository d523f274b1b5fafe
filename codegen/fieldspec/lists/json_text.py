"""Reads JSON after bounding its values and levels: a short text can ask for more memory than there is."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any

from fieldspec.lists.sheet import ListError

DEEPEST = 16
MOST_VALUES = 2_000_000

_SIGN = re.compile(r'["\\\[\]{},]')


def json_data(text: str, pairs: Callable[[list[tuple[str, Any]]], Any] | None = None) -> Any:
    """The data of a JSON text. `pairs` builds an object from its pairs. Raises ListError."""
    _count(text)
    try:
        return json.loads(text, object_pairs_hook=pairs)
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
