"""What is read by people has changed: names as printed, labels, texts, notes, sources, and what the manual prints
twice.

Why: nobody is hurt. Texts stand in the documentation and in the comments of generated code.

Example: a `doc` in other words, or a `source` with another line.

Cure: None is needed.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison, Pair
from fieldspec.changes.documentation import TEXTS
from fieldspec.changes.finding import change, named
from fieldspec.changes.spelling import listed, spelled
from fieldspec.model.record import Field


def documentation_changed(both: Comparison) -> Iterator[Change]:
    for noun, texts in TEXTS.items():
        for pair in both.any_of(noun):
            held = [(key, *_followed(both, pair, key, get(pair.old), get(pair.new))) for key, get in texts.items()]
            differ = [(key, old, new) for key, old, new in held if old != new and not _told(both, pair, key)]
            if differ:
                keys = [key for key, _, _ in differ]
                text = f"{named(pair.new)} has another {listed([key.replace('_', ' ') for key in keys], len(keys))}"
                old, new = ("; ".join(_said(*each) for each in side) for side in _sides(differ))
                yield change("documentation_changed", Effect.DOCS, pair, keys[0], text, old, new)


_NAMES = {"same_as": "registers", "copy_of": "registers", "signal": "signals"}
_PATHS = ("about", "fact")
_OF_SIGNAL = ("printed_name", "label", "doc", "scale", "sentinels")


def _followed(both: Comparison, pair: Pair[Any], key: str, old: Any, new: Any) -> tuple[Any, Any]:
    """Two texts: the old one by new names, and both without what other rules tell."""
    if key in _NAMES:
        return both.renamed_to(_NAMES[key], old), new
    if key in _PATHS:
        return (both.renamed_path(old) if isinstance(old, str) else tuple(map(both.renamed_path, old))), new
    if key == "sentinels":
        shared = old.keys() & new.keys()
        return {one: old[one] for one in old if one in shared}, {one: new[one] for one in new if one in shared}
    if key == "scale" and not _same_scale(pair):
        return "", ""
    return old, new


def _same_scale(pair: Pair[Any]) -> bool:
    old, new = pair.old.value, pair.new.value
    return old is not None and new is not None and old.scale == new.scale


def _told(both: Comparison, pair: Pair[Any], key: str) -> bool:
    """Whether a signal tells what has changed at a field that takes its texts from there."""
    if not isinstance(pair.new, Field) or key not in _OF_SIGNAL:
        return False
    get = TEXTS[Field][key]
    old, new = both.old.signals.get(pair.old.signal), both.new.signals.get(pair.new.signal)
    return old is not None and new is not None and (get(old), get(new)) == (get(pair.old), get(pair.new))


def _sides(differ: list[tuple[str, Any, Any]]) -> tuple[list[tuple[str, Any]], list[tuple[str, Any]]]:
    """The keys with their old values, and with their new ones."""
    return [(key, old) for key, old, _ in differ], [(key, new) for key, _, new in differ]


def _said(key: str, held: Any) -> str:
    return f"{key}: {spelled(held)}"
