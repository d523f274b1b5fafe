"""Tells by its first lines in which format of another program a text is."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TypeAlias

from fieldspec.tools.lists.formats import object_dictionary
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.sheet import Sheet

Reader: TypeAlias = Callable[[str], tuple[Sheet, Listing]]

_LOOKED_AT = 1 << 16

_SIGNS: tuple[tuple[re.Pattern[str], Reader], ...] = ((object_dictionary.SIGNS, object_dictionary.object_dictionary),)


def format_of(text: str) -> Reader | None:
    """What reads a text in the format of another program; None for a table or JSON of any other kind."""
    head = text[:_LOOKED_AT]
    return next((reader for sign, reader in _SIGNS if sign.search(head)), None)
