"""Tells by its first lines in which format of another program a text is."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TypeAlias

from fieldspec.tools.lists.formats import can_database, esphome, object_dictionary, solarman, sunspec_model
from fieldspec.tools.lists.formats.yaml_items import tree
from fieldspec.tools.lists.listing import Listing
from fieldspec.tools.lists.sheet import ListError, Sheet

Reader: TypeAlias = Callable[[str, str], tuple[Sheet, Listing] | None]
"""What reads a text, as a node has it that the user names; None if it is of another format after all."""

_LOOKED_AT = 1 << 16
_YAML = re.compile(
    r"^parameters\s*:|^[ \t-]*platform\s*:\s*\w+_controller\b|^[ \t-]*server_registers\s*:", re.MULTILINE
)


_EXAMPLE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
"""An example in a document in Markdown."""


def _yaml(text: str, node: str) -> tuple[Sheet, Listing] | None:
    _without_nodes(node)
    root = tree(esphome.substituted(text))
    lines = text.count("\n") + 1
    if solarman.is_definition(root):
        return solarman.definition(root, lines)
    return esphome.configuration(root, lines) if esphome.is_configuration(root) else None


def _object_dictionary(text: str, node: str) -> tuple[Sheet, Listing]:
    _without_nodes(node)
    return object_dictionary.object_dictionary(text)


def _without_nodes(node: str) -> None:
    if node:
        raise ListError("has no nodes, so --node has no effect; leave it out")


_SIGNS: tuple[tuple[re.Pattern[str], Reader], ...] = (
    (object_dictionary.SIGNS, _object_dictionary),
    (can_database.SIGNS, can_database.can_database),
    (sunspec_model.SIGNS, sunspec_model.sunspec_model),
    (_YAML, _yaml),
)


def formatted_list(text: str, node: str) -> tuple[Sheet, Listing] | None:
    """The list in the format of another program; None for a table, and JSON of any other kind. Raises ListError."""
    head = _EXAMPLE.sub("", text)[:_LOOKED_AT]
    for sign, reader in _SIGNS:
        if sign.search(head) and (result := reader(text, node)) is not None:
            return result
    _without_nodes(node)
    return None
