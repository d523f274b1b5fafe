"""From a source to the line of the manual that it cites, where the text of the manual is beside the project."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from fieldspec.command.editor.projects import EditedProject
from fieldspec.command.files import regular_file
from fieldspec.foundation.source import Span
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, children, find
from fieldspec.language.reading.references import unquoted

SOURCE = "source"
"""The key that cites lines of the manual."""

_LINES = re.compile(r"(?:L|, )(?P<first>[0-9]{1,6})(?:-(?P<last>[0-9]{1,6}))?")
_MOST_BYTES = 32 << 20
_MOST_LINES = 12
"""How many lines of a citation are shown."""


def manual_of(project: EditedProject, spec: DeviceSpec) -> Path | None:
    """The text of the manual of a device; None where it is not in the folder of manuals, and nowhere else."""
    name = find(spec.tree, "device/manual/file")
    if not isinstance(name, Scalar) or Path(name.text).name != name.text or "\0" in name.text:
        return None
    folder = project.manual_folder.resolve()
    path = (folder / name.text).resolve()
    return path if path.parent == folder and path.is_file() else None


def citations(scalar: Scalar) -> Iterator[tuple[Span, int, int]]:
    """The intervals of lines that a source cites, each with the part of its text."""
    place = unquoted(scalar)
    text = place.file.text[place.start : place.end]
    for interval in _LINES.finditer(text):
        first = int(interval["first"])
        start = place.start + interval.start() + (interval[0][0] == ",") * len(", ")
        yield Span(place.file, start, place.start + interval.end()), first, int(interval["last"] or first)


def sources(node: Node) -> Iterator[Scalar]:
    """The sources below a node of a document, each once: not those that an alias repeats."""
    for key, child in children(node):
        if not node.start <= child.start <= child.end <= node.end:
            continue
        if not isinstance(child, Scalar):
            yield from sources(child)
        elif key == SOURCE and isinstance(node, Mapping):
            yield child


def cited_lines(path: Path, scalar: Scalar) -> Iterator[str]:
    """The lines of a manual that a source cites, with their numbers."""
    try:
        lines = _text(path, path.stat().st_mtime_ns)
    except OSError:
        return
    numbers = [number for _, first, last in citations(scalar) for number in range(first, min(last, len(lines)) + 1)]
    for number in numbers[:_MOST_LINES]:
        if 0 < number <= len(lines):
            yield f"{number:>6}  {lines[number - 1]}"
    if len(numbers) > _MOST_LINES:
        yield f"        and {len(numbers) - _MOST_LINES} more lines"


@lru_cache(maxsize=8)
def _text(path: Path, _modified: int) -> list[str]:
    """The lines of a text, as it was when it was modified last."""
    try:
        return regular_file.content(path, _MOST_BYTES).decode("utf-8", "replace").split("\n")
    except (OSError, regular_file.SizeError):
        return []
