"""Where the facts of a device are named and used: in all its files, at all its versions."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.command.editor.cursor import Cursor
from fieldspec.command.editor.projects import EditedProject
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass, field
from fieldspec.foundation.source import Span
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.findings import VERSIONS
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, children, find
from fieldspec.language.reading.references import PlaceInFile, Reference, place_in_file, references, unquoted

_IDENTITIES = ("name", "id", "group", "line")


@dataclass(frozen=True, slots=True)
class NamedFact:
    """A fact or a state: where it stands, its names, and the references to it, each once, by the places of these."""

    stated: Node
    names: dict[PlaceInFile, Scalar] = field(default_factory=dict)
    uses: dict[Span, Reference] = field(default_factory=dict)

    @property
    def spans(self) -> list[Span]:
        """The places of its names."""
        return [unquoted(name) for name in self.names.values()]

    @property
    def definition(self) -> list[Span]:
        """The name that stands at the fact itself, and not in the overlay that renames it."""
        first, last = self.stated.start, self.stated.end
        return [span for span in self.spans if first <= span.start <= span.end <= last][:1] or self.spans[:1]


@dataclass(frozen=True, slots=True)
class _Index:
    """The facts of a device by their places, and the places of those that a scalar means, by its parts."""

    facts: dict[PlaceInFile, NamedFact] = field(default_factory=dict)
    meant: dict[PlaceInFile, dict[Span, list[PlaceInFile]]] = field(default_factory=dict)

    def fact(self, node: Node) -> NamedFact:
        """The fact that a node states."""
        return self.facts.setdefault(place_in_file(node), NamedFact(node))

    def mean(self, node: Scalar, span: Span, name: str, fact: Node) -> None:
        """Notes that a part of a scalar means a fact. A name that comes from an expansion is in no text."""
        if _text(span) != name:
            return
        places = self.meant.setdefault(place_in_file(node), {}).setdefault(span, [])
        if (place := place_in_file(fact)) not in places:
            places.append(place)


_INDEXES: ByIdentity[DeviceSpec, _Index] = ByIdentity(limit=50)


def meant(place: Cursor) -> list[NamedFact]:
    """The facts that are named at a place, or that a name there refers to; in a protocol, the facts of each device."""
    node = place.scalar or place.key_scalar
    if node is None:
        return []
    results: dict[PlaceInFile, NamedFact] = {}
    for spec in place.specs:
        index = _INDEXES.get_or_compute(spec, lambda spec: _indexed(place.project, spec))
        parts = index.meant.get(place_in_file(node), {})
        under = [span for span in parts if span.start <= place.offset <= span.end] or [*parts][-1:]
        for fact_place in [fact_place for span in under for fact_place in parts[span]]:
            fact = index.facts[fact_place]
            named_fact = results.setdefault(fact_place, NamedFact(fact.stated))
            named_fact.names.update(fact.names)
            named_fact.uses.update(fact.uses)
    return [*results.values()]


def _indexed(project: EditedProject, spec: DeviceSpec) -> _Index:
    index = _Index()
    trees = [spec.tree_at(version) for version in spec.versions()]
    overlays = [*_overlays(project, spec)]
    for tree in trees:
        _names(tree, index)
    results = [reference for tree in trees for reference in references(tree)]
    results += (reference for base, overlay in overlays for reference in references(spec.tree_at(base), overlay))
    for reference in results:
        text = reference.scalar.text[reference.start : reference.end]
        index.mean(reference.scalar, reference.span, text, reference.target)
        # A role is not a name, and one that comes from an expansion is in no text.
        if _text(reference.span) in {_text(unquoted(name)) for name in index.fact(reference.target).names.values()}:
            index.fact(reference.target).uses.setdefault(reference.span, reference)
    return index


def _text(span: Span) -> str:
    return span.file.text[span.start : span.end]


def _overlays(project: EditedProject, spec: DeviceSpec) -> Iterator[tuple[str, Mapping]]:
    """The files of versions, with the version on which each is based."""
    for path in sorted(spec.files):
        tree = project.memory.files[path].tree if path.split("/")[1] == VERSIONS else None
        based_on = find(tree, "overlay/based_on") if tree is not None else None
        if tree is not None and isinstance(based_on, Scalar):
            yield based_on.text, tree


def _names(node: Node, index: _Index) -> None:
    """Notes the names of all facts of a tree: they are items of lists. States of machines are names alone."""
    for key, child in children(node):
        for state in child.items if key == "machine" and isinstance(child, Sequence) else ():
            if isinstance(state, Scalar):
                index.fact(state).names.setdefault(place_in_file(state), state)
                index.mean(state, unquoted(state), state.text, state)
        if isinstance(node, Sequence) and isinstance(child, Mapping):
            name = next((child.values[key] for key in _IDENTITIES if key in child.values), None)
            if isinstance(name, Scalar):
                index.fact(child).names.setdefault(place_in_file(name), name)
                index.mean(name, unquoted(name), name.text, child)
        if not isinstance(child, Scalar):
            _names(child, index)
