"""Fills forms: texts with a place for everything that is worked out, `${name}`.

A form has no loops, so that no library is loaded for it. What is repeated is written before, and stands in one place,
as one text or as many, so that a text of megabytes is put together once.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent.parent
_PLACE = re.compile(r"\$\{(\w+)\}")


def filled(form: str, **texts: str | Iterable[str]) -> str:
    """The text of a form, given by its path in the package. Raises KeyError for a place that nothing is given for."""
    pieces: list[str] = []
    for number, piece in enumerate(_PLACE.split(text(form))):
        content = texts[piece] if number % 2 else piece
        pieces += [content] if isinstance(content, str) else content
    return "".join(pieces)


@cache
def text(path: str) -> str:
    """The text of a file that stands in an output as it is, by its path in the package."""
    return _PACKAGE.joinpath(path).read_text("utf-8")
