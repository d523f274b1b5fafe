"""The context of a position in a document: the enclosing nodes, and the part of the schema that describes them."""

from __future__ import annotations

from fieldspec.command.editor.positions import moved
from fieldspec.command.editor.projects import EditedProject
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.memory import FileRead
from fieldspec.language.reading.nodes import CHECKED, LISTS, Mapping, Node, Scalar, children, keys, node_at, schema_path
from fieldspec.language.reading.scalars import part_at
from fieldspec.language.reading.yaml_reader import key_spans
from fieldspec.language.schema import Schema, resolved


@dataclass(frozen=True, slots=True)
class Cursor:
    """A place in a document: the `nodes` that hold it, the tree of the file first, and the keys that lead to them.

    The place is an offset in the text of the nodes. `key_scalar` is the key of the last node that is there, if it is at
    one.
    """

    project: EditedProject
    read: FileRead
    offset: int
    nodes: tuple[Node, ...]
    keys: tuple[str | int, ...]
    key_scalar: Scalar | None

    @property
    def key(self) -> str | None:
        """The key at the place."""
        return self.key_scalar.text if self.key_scalar is not None else None

    @property
    def specs(self) -> list[DeviceSpec]:
        """The devices that the document belongs to."""
        return self.project.specs_with(self.read.file)

    @property
    def scalar(self) -> Scalar | None:
        """The value at the place, if it is one without values in it."""
        node = self.nodes[-1]
        return node if isinstance(node, Scalar) else None

    def part(self) -> Schema | None:
        """The part of the language that describes the last node; None where the language leaves it open."""
        steps_within_facts = [_within_fact(spec, self) for spec in self.specs]
        parts = (*map(self._part_of_fact, steps_within_facts), _part([*self.keys]))
        return next((part for part in parts if part is not None), None)

    def _part_of_fact(self, steps: list[str | int] | None) -> Schema | None:
        """The part of a fact that an entry refers to. A printed value of an erratum may be one that the fact checks."""
        part = _part(steps)
        if steps is None or self.keys[2] != "printed":
            return part
        if len(self.keys) > 3:
            return part or _part([*steps[:-1], CHECKED, steps[-1]])
        checked = (_part([*steps, CHECKED]) or {}).get("properties", {})
        return {**part, "properties": {**part.get("properties", {}), **checked}} if part is not None else None


def cursor(project: EditedProject, read: FileRead, offset: int) -> Cursor | None:
    """The context of an offset in a file; None where its text has no tree, or has changed there since it had one."""
    if read.tree is None:
        return None
    place = moved(Span(read.file, offset, offset), read.tree.file)
    if place is None:
        return None
    node: Node = read.tree
    nodes, path = [node], []
    while (step := _below(node, place.start)) is not None:
        key, node = step
        nodes.append(node)
        path.append(key)
    spans = key_spans(node) if isinstance(node, Mapping) else ()
    words = (Scalar(span.file, span.start, span.end, word, False) for word, span in spans)
    key_scalar = next((word for word in words if word.start <= place.start <= word.end), None)
    return Cursor(project, read, place.start, tuple(nodes), tuple(path), key_scalar)


def _below(node: Node, offset: int) -> tuple[str | int, Node] | None:
    """The child of a node that holds an offset, with its key. The content of an alias is at another place.

    A list or mapping may end where the next one begins, a value just before the pointer.
    """
    for key, child in children(node):
        end = child.end + 1 if isinstance(child, Scalar) else child.end
        if node.start <= child.start <= offset < end and child.end <= node.end:
            return key, child
    return None


def _part(steps: list[str | int] | None) -> Schema | None:
    if steps is None:
        return None
    try:
        return part_at(schema_path(steps))
    except KeyError:
        part = (_part(steps[:-1]) or {}).get("additionalProperties")  # of a mapping whose keys are names
        return resolved(part) if isinstance(part, dict) else None


def _within_fact(spec: DeviceSpec, place: Cursor) -> list[str | int] | None:
    """The keys that the keys of an entry refer to: of a fact that it changes or adds, or whose printed value it states.

    None for any other place.
    """
    entry = place.nodes[2] if len(place.nodes) > 2 else None
    if not isinstance(entry, Mapping) or len(place.keys) < 3:
        return None
    holder = entry.values.get({"set": "fact", "printed": "fact", "item": "in"}.get(str(place.keys[2]), ""))
    if not isinstance(holder, Scalar):
        return None
    inner = [*place.keys[3:]]
    if place.keys[2] == "set" and len(inner) == 1:
        return None  # what the value was and is
    for version in reversed(spec.versions()):
        steps = keys(spec.tree_at(version), holder.text)
        if steps is None:
            continue
        if place.keys[2] != "item":
            return [*steps, *inner[:1]]
        list_node = node_at(spec.tree_at(version), steps)
        lists = [key for key in LISTS if isinstance(list_node, Mapping) and key in list_node.values]
        return [*steps, *lists[:1], 0, *inner]
    return None
