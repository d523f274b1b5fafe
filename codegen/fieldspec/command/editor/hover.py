"""The hover text of a position: a key as in the language manual, a fact as in `show`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from fieldspec.codec.explain.readings import FrameOptions, OpenRequest, read_frame, remarks_on
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command import rules
from fieldspec.command.editor.cursor import Cursor
from fieldspec.command.editor.index import meant
from fieldspec.command.editor.manual_links import SOURCE, cited_lines, manual_of
from fieldspec.command.editor.projects import EditedProject
from fieldspec.command.editor.quantities import quantity
from fieldspec.command.rendering import explanation_text, item_blocks
from fieldspec.command.rendering.blocks import Block, Line, bare_text
from fieldspec.command.rendering.item import Item, fact_of, items
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.line_text import visible_text
from fieldspec.language.model.texts import Example
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping, Scalar, children
from fieldspec.language.reading.references import used_by
from fieldspec.language.schema.manual import key_text

_Place = tuple[str, int, int]

_BY_PLACE: ByIdentity[DeviceLayout, dict[_Place, list[Item]]] = ByIdentity(limit=50)
"""The items of a layout by the places that state them: several, where a row stands for a series."""
_USERS: ByIdentity[Mapping, dict[str, list[str]]] = ByIdentity(limit=50)
MOST_ITEMS = 4
"""How many items of one row are shown."""


def hover(place: Cursor) -> str | None:
    """Markdown about what is at a place; None where there is nothing to be said of it."""
    if place.key is not None:
        part = place.part() or {}
        rule = rules.rule(place.key) if place.keys[-1:] == ("allow",) else None
        if place.key in part.get("properties", {}):
            return key_text(part, place.key)
        if rule is not None or not meant(place):
            return rule.what if rule is not None else None
    number = f"{code(known)}\n" if (known := quantity(place)) else ""
    return "\n".join(filter(None, (_cited(place), number, _stated(place)))) or None


def _cited(place: Cursor) -> str:
    """The lines of the manual that a source cites."""
    if place.scalar is None or place.keys[-1:] != (SOURCE,):
        return ""
    for spec in place.specs:
        path = manual_of(place.project, spec)
        lines = [*cited_lines(path, place.scalar)] if path is not None else []
        if path is not None and lines:
            return f"{code(path.name)}\n\n{fenced(map(Line, map(visible_text, lines)))}"
    return ""


def _stated(place: Cursor) -> str | None:
    """The facts that a place states, or names."""
    for node in (*(fact.stated for fact in meant(place)), *reversed(place.nodes)):
        if not isinstance(node, Mapping):
            continue
        # A copy of a row is stated by the values that are its own.
        scalars = (child for _, child in children(node) if isinstance(child, Scalar))
        for span in (node.span, *(child.span for child in scalars)):
            if text := _facts(place, (span.file.path, span.start, span.end)):
                return text
    return None


def _facts(place: Cursor, fact_place: _Place) -> str | None:
    """The items that a place states, at the newest version that has them."""
    for spec in place.specs:
        for version in reversed(spec.versions()):
            layout = place.project.layout(spec, version)
            stated = items_at(layout, fact_place) if layout is not None else []
            if layout is not None and stated:
                return "\n".join(_item(place.project, spec, version, layout, item) for item in stated[:MOST_ITEMS])
    return None


def items_at(layout: DeviceLayout, fact_place: _Place) -> list[Item]:
    """The items of a layout that a place states."""
    return _BY_PLACE.get_or_compute(layout, _by_place).get(fact_place, [])


def _by_place(layout: DeviceLayout) -> dict[_Place, list[Item]]:
    by_place: dict[_Place, list[Item]] = {}
    for item in items(layout):
        span = fact_of(item).place.whole
        by_place.setdefault((span.file.path, span.start, span.end), []).append(item)
    return by_place


def _item(project: EditedProject, spec: DeviceSpec, version: str, layout: DeviceLayout, item: Item) -> str:
    """An item as `show` has it; an example also as `decode` explains it."""
    fact = fact_of(item)
    path = fact.place.path
    users = _USERS.get_or_compute(spec.tree_at(version), used_by)
    visible = item_blocks.blocks(layout, item, users=users.get(path, ()))
    text = f"{code(f'{spec.id}@{version} {path}')}\n\n{fenced(visible)}"
    if isinstance(fact, Example) and fact.link in layout.links:
        text += f"\n{fenced(explained(layout, fact))}"
    if other := [*_differing(project, spec, version, layout, item)]:
        text += f"\ndiffers in {', '.join(map(code, other))}\n"
    return text


def explained(layout: DeviceLayout, example: Example) -> Iterator[Block]:
    """An example as `decode` explains it, which is told its link, direction, message and request."""
    request = layout.device.examples.get(example.reply_to)
    open_request = None
    if request is not None and example.direction == "response":
        reading = read_frame(layout, request.frame, FrameOptions(((example.link, "request"),), example.message))
        open_request = OpenRequest(reading.explanation, True)
    options = FrameOptions(((example.link, example.direction),), example.message)
    reading = read_frame(layout, example.frame, options, open_request=open_request)
    yield from explanation_text.whole_blocks(layout, reading, remarks_on(layout, reading, 0, options))


def _differing(
    project: EditedProject, spec: DeviceSpec, version: str, layout: DeviceLayout, item: Item
) -> Iterator[str]:
    """The other versions that have the item with another text."""
    path = fact_of(item).place.path
    text = _text(item_blocks.blocks(layout, item))
    for other in spec.versions():
        if other == version or (earlier := project.layout(spec, other)) is None:
            continue
        counterparts = [counterpart for counterpart in items(earlier) if fact_of(counterpart).place.path == path]
        if any(_text(item_blocks.blocks(earlier, counterpart)) != text for counterpart in counterparts):
            yield other


def _text(blocks: Iterable[Block]) -> str:
    return "".join(map(bare_text, blocks))


def fenced(blocks: Iterable[Block]) -> str:
    """Blocks as a block of code in Markdown, which nothing in them ends."""
    text = _text(blocks)
    fence = "`" * max(3, *(len(run) + 1 for run in re.findall("`+", text)), 0)
    return f"{fence}text\n{text}{fence}\n"


def code(text: str) -> str:
    """A text of a spec as code in a line of Markdown, which nothing in it ends."""
    visible = visible_text(text)
    ticks = "`" * max(1, *(len(run) + 1 for run in re.findall("`+", visible)), 0)
    blank = " " if len(ticks) > 1 else ""
    return f"{ticks}{blank}{visible}{blank}{ticks}"
