"""Frames that are the same both ways: what a link states once under `frame`, its request and its response have."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import replace
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, mappings
from fieldspec.language.reading.renamed_paths import with_text
from fieldspec.language.reading.yaml_reader import key_span

FRAME = "frame"
_DIRECTIONS = ("request", "response")
_BY_KEY = ("inferred", "standard")
"""The keys of a link whose own keys are keys of the link."""


def with_directions(tree: Mapping) -> tuple[Mapping, list[Diagnostic]]:
    """The tree of a device or protocol with the parts under `frame` in both directions, where they are stated."""
    links = tree.values.get("links")
    if not isinstance(links, Sequence):
        return tree, []
    items = tuple(_link(link) for link in mappings(links))
    return tree.with_value("links", replace(links, items=items)), [*_stated_twice([*mappings(links)])]


def overlay_with_directions(overlay: Mapping) -> tuple[Mapping, list[Diagnostic]]:
    """An overlay whose entries about a `frame` are entries about both directions."""
    findings: list[Diagnostic] = []
    for key in ("changes", "removes", "adds", "renames"):
        entries = overlay.values.get(key)
        if isinstance(entries, Sequence):
            items = tuple(new for entry in mappings(entries) for new in _entries(entry, findings))
            overlay = overlay.with_value(key, replace(entries, items=items))
    return overlay, findings


def _entries(entry: Mapping, findings: list[Diagnostic]) -> Iterator[Mapping]:
    """The entries of an overlay that one of them stands for."""
    key = "in" if "in" in entry.values else "fact"
    path = entry.values[key]
    steps = path.text.split("/") if isinstance(path, Scalar) else []
    if steps[:1] != ["links"]:
        yield entry
    elif steps[2:3] == [FRAME]:
        for direction in _DIRECTIONS:
            yield entry.with_value(key, with_text(path, "/".join((*steps[:2], direction, *steps[3:]))))
    else:
        for holder in ("set", "item"):
            inner = entry.values.get(holder)
            if isinstance(inner, Mapping) and len(steps) == (2 if holder == "set" else 1):
                findings += _stated_twice([inner])
                entry = entry.with_value(holder, _link(inner))
        yield entry


def _link(link: Mapping) -> Mapping:
    """A link, or what is changed of one, with `request` and `response` in place of `frame`."""
    for key in _BY_KEY:
        inner = link.values.get(key)
        if isinstance(inner, Mapping) and FRAME in inner.values:
            link = link.with_value(key, _divided(inner))
    return _divided(link)


def _divided(holder: Mapping) -> Mapping:
    """A mapping with the value of `frame` under both directions, whose keys are reported at that value."""
    value = holder.values.get(FRAME)
    if value is None:
        return holder
    values: dict[str, Node] = {}
    for key, own in holder.values.items():
        values |= dict.fromkeys(_DIRECTIONS, value) if key == FRAME else {key: own}
    places = {key: Scalar(value.file, value.start, value.end, key, False, key) for key in _DIRECTIONS}
    return replace(holder, values=values, keys={**holder.keys, **places})


def _stated_twice(links: list[Mapping]) -> Iterator[Diagnostic]:
    """A finding for each link that states both directions at once and one of them again."""
    for link in links:
        direction = next((key for key in _DIRECTIONS if key in link.values), None)
        if FRAME in link.values and direction is not None:
            text = f"`frame` states the parts of both directions, and `{direction}` states them again"
            help = "remove `frame` where they differ, or remove `request` and `response`"
            yield Diagnostic("wrong_form", text, key_span(link, direction), help=help)
