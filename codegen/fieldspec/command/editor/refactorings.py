"""The refactorings of a place without a finding: an erratum, a new version, and the explanation of a frame."""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.codec.explain.lines import Unreadable, log_line
from fieldspec.codec.explain.readings import FrameOptions, read_frame, remarks_on
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference.frames import codec
from fieldspec.codec.reference.records import CodecError
from fieldspec.command.editor.cursor import Cursor
from fieldspec.command.editor.edits import (
    Edit,
    erratum_lines,
    holding_section,
    identifiers,
    new_name,
    source_text,
    stated_fact,
    with_item,
    with_key,
)
from fieldspec.command.editor.fixes import Action
from fieldspec.command.files import regular_file
from fieldspec.command.rendering import explanation_text
from fieldspec.command.rendering.blocks import bare_text
from fieldspec.foundation.source import SourceFile
from fieldspec.language.reading.findings import LARGEST_FILE, VERSIONS
from fieldspec.language.reading.memory import FileRead
from fieldspec.language.reading.nodes import (
    CHECKED,
    Mapping,
    Node,
    Scalar,
    Sequence,
    find,
    identity,
    node_at,
    with_checked_keys,
)
from fieldspec.language.reading.yaml_reader import parsed
from fieldspec.tools.proofs.examples import stated_values

_LEAST_BYTES = 3
_HEX = re.compile(r"(?<![0-9A-Za-z])[0-9A-Fa-f]{2}(?:[ ]?[0-9A-Fa-f]{2})+(?![0-9A-Za-z])")
_UNPRINTED = frozenset(("errata", "reviews", "accepts", "audit", "changes", "adds", "removes", "renames", "overlay"))
"""Sections that say nothing of what a manual prints."""


def refactorings(place: Cursor) -> Iterator[Action]:
    """What can be made of the value at a place."""
    is_checked = CHECKED in place.keys[-2:-1]
    holders = [node for node in place.nodes if isinstance(node, Mapping)][: -1 if is_checked else None]
    value, fact = place.scalar, holders[-1] if holders else None
    if fact is None or not identity(fact) or place.keys[0] in _UNPRINTED:
        return
    key = place.keys[-1]
    if value is not None and isinstance(key, str) and with_checked_keys(fact).values.get(key) is value:
        if (lines := erratum_lines(place, fact, key)) is not None:
            erratum = with_item(holding_section(place, "errata"), "errata", lines)
            yield Action(f"Add an erratum: the manual prints this `{key}`", (erratum,))
        yield from _renames(place, fact, value) if key == "name" else _of_versions(place, fact, key, value)
    yield from _since(place, fact)


def _of_versions(place: Cursor, fact: Mapping, key: str, value: Scalar) -> Iterator[Action]:
    """The value as a change of a version that has a file; what is saved stays as it is for the others."""
    known_fact, overlays = stated_fact(place, fact), [*_overlays(place)]
    if known_fact is None or not overlays:
        return
    path = f"{known_fact.place.path}/{CHECKED}" if CHECKED in place.keys[-2:-1] else known_fact.place.path
    current_text = source_text(value)
    saved_tree = _saved_tree(place)
    saved = (_text_of(find(saved_tree, path), key) if saved_tree is not None else None) or current_text
    for read_file in overlays:
        tree = read_file.tree
        name = find(tree, "overlay/id") if tree is not None else None
        if tree is None or not isinstance(name, Scalar):
            continue
        change = f"{key}: {{was: {saved}, is: {current_text}}}"
        entries = tree.values.get("changes")
        mappings = (
            (item for item in entries.items if isinstance(item, Mapping)) if isinstance(entries, Sequence) else ()
        )
        entry = next((item for item in mappings if _text_of(item, "fact") == path), None)
        changed = entry.values.get("set") if entry is not None else None
        if isinstance(changed, Mapping):
            if key in changed.values:
                continue
            added = with_key(changed, key, f"{{was: {saved}, is: {current_text}}}")
        else:
            added = with_item(read_file, "changes", [f"fact: {path}", f"set: {{{change}}}", 'reason: ""'])
        edits = (added,) if saved == current_text else (Edit(value.span, saved), added)
        yield Action(f"Move this `{key}` to version {name.text}", edits)


def _renames(place: Cursor, fact: Mapping, value: Scalar) -> Iterator[Action]:
    """The name as that of a version that has a file; what is saved stays the name for the others."""
    known_fact, overlays = stated_fact(place, fact), [*_overlays(place)]
    if known_fact is None or not overlays:
        return
    saved_tree = _saved_tree(place)
    try:
        saved = _text_of(node_at(saved_tree, [*place.keys[:-1]]), "name") if saved_tree is not None else None
    except (KeyError, IndexError, AttributeError):
        saved = None  # the list has become another one
    new_name, old_name = source_text(value), saved or source_text(value)
    path = f"{known_fact.place.path.rpartition('/')[0]}/{old_name}"
    for read_file in overlays:
        name = find(read_file.tree, "overlay/id") if read_file.tree is not None else None
        if isinstance(name, Scalar):
            lines = [f"fact: {path}", f"to: {new_name}", 'reason: ""']
            added = with_item(read_file, "renames", lines)
            edits = (added,) if old_name == new_name else (Edit(value.span, old_name), added)
            yield Action(f"Rename in version {name.text}, which the others do not have", edits)


def _overlays(place: Cursor) -> Iterator[FileRead]:
    for spec in place.specs:
        for path in sorted(spec.files):
            if path.split("/")[1] == VERSIONS:
                yield place.project.memory.files[path]


def _saved_tree(place: Cursor) -> Node | None:
    """The document as the file on the disk has it."""
    try:
        data = regular_file.content(place.project.path(place.read.file.path), LARGEST_FILE)
    except (OSError, regular_file.SizeError):
        return None
    return parsed(SourceFile(place.read.file.path, data.decode("utf-8", "replace")))[0]


def _text_of(node: Node | None, key: str) -> str | None:
    value = node.values.get(key) if isinstance(node, Mapping) else None
    return source_text(value) if isinstance(value, Scalar) else None


def _since(place: Cursor, fact: Mapping) -> Iterator[Action]:
    """The fact as one that the newest version is the first to have."""
    keys = (place.part() or {}).get("properties", {}) if place.scalar is None else {}
    if "since" not in keys or not {"since", "until", "only"}.isdisjoint(fact.values):
        return
    for spec in place.specs:
        *earlier, newest = spec.versions()
        if earlier:
            yield Action(f"Begin with version {newest}", (with_key(fact, "since", f'"{newest}"'),))


def frame_at(place: Cursor | None, file: SourceFile, start: int, end: int) -> bytes | None:
    """The bytes of a frame that are selected, or around the pointer; None where there are none."""
    text = file.text[start:end]
    if start == end:
        if place is not None and place.keys[-1:] == ("frame",) and place.scalar is not None:
            text = place.scalar.text
        else:
            first = file.text.rfind("\n", 0, start) + 1
            line = file.text[first:].partition("\n")[0]
            runs = (run for run in _HEX.finditer(line) if run.start() <= start - first <= run.end())
            text = next((run[0] for run in runs), "")
    try:
        frame_line = log_line(" ".join(text.split()), ())
    except Unreadable:
        return None
    return frame_line.frame if frame_line is not None and len(frame_line.frame) >= _LEAST_BYTES else None


def explained(layout: DeviceLayout, frame: bytes) -> str:
    """A frame as `decode` explains it."""
    options = FrameOptions()
    reading = read_frame(layout, frame, options)
    remarks = remarks_on(layout, reading, 0, options)
    return "".join(map(bare_text, explanation_text.whole_blocks(layout, reading, remarks)))


def example_of(place: Cursor, layout: DeviceLayout, frame: bytes) -> Action | None:
    """A frame as an example of the spec; None where it is not valid, or an example already."""
    if any(example.frame == frame for example in layout.device.examples.values()):
        return None
    reading = read_frame(layout, frame, FrameOptions())
    explanation = reading.explanation
    if reading.wrong or not explanation.message:
        return None
    message = layout.device.messages[explanation.message]
    try:
        decoded = codec(layout).links[explanation.link].decode(frame, explanation.direction, message.name)
    except CodecError:
        return None
    name = new_name(message.name.replace("_", "-"), {*identifiers(place, "examples")})
    lines = [
        f"id: {name}",
        f"title: {message.title or message.name.replace('_', ' ')}",
        f"link: {explanation.link}",
        f"direction: {explanation.direction}",
        f"message: {message.name}",
        *(["exception_response: true"] if decoded.error else []),
        f"frame: {frame.hex(' ').upper()}",
        f"values: {stated_values(layout, decoded)}",
        "origin: computed",
    ]
    edit = with_item(holding_section(place, "examples"), "examples", lines)
    return Action(f"Make an example of this frame: {message.name}", (edit,))
