"""Tells by its first lines in which format of another program a text is."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TypeAlias

from fieldspec.tools.lists.formats import esphome, solarman
from fieldspec.tools.lists.formats.object_dictionary import SIGNS, object_dictionary
from fieldspec.tools.lists.formats.yaml_items import tree
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.sheet import Sheet

Reader: TypeAlias = Callable[[str], tuple[Sheet, Listing] | None]
"""What reads a text; None if it is of another format after all."""

_LOOKED_AT = 1 << 16
_YAML = re.compile(r"^parameters\s*:|^[\s-]*platform\s*:\s*\w+_controller\b|^[\s-]*server_registers\s*:", re.MULTILINE)


def _yaml(text: str) -> tuple[Sheet, Listing] | None:
    node = tree(text)
    lines = text.count("\n") + 1
    if solarman.is_definition(node):
        return solarman.definition(node, lines)
    return esphome.configuration(node, lines) if esphome.is_configuration(node) else None


_SIGNS: tuple[tuple[re.Pattern[str], Reader], ...] = ((SIGNS, object_dictionary), (_YAML, _yaml))


def formatted_list(text: str) -> tuple[Sheet, Listing] | None:
    """The list in the format of another program; None for a table, and JSON of any other kind. Raises ListError."""
    head = text[:_LOOKED_AT]
    for sign, reader in _SIGNS:
        if sign.search(head) and (result := reader(text)) is not None:
            return result
    return None
