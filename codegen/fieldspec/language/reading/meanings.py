"""What names in a tree mean after the facts that a path finds: bits, fields of records, roles, and named values."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.reading.frames import FRAME
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, children, find, identity, mappings

VALUES = ("values", "arguments")
"""Mappings whose keys are fields of a frame."""
VALUED = {"write": "value", "wait": "value", "show": "value", "initial": "value", "record": "value", "set": "to"}
"""The keys with which steps and actions name a signal, and the key of its value."""
_WITH_ROLES = ("registers", "parameters", "messages", "signals", "links", "flags")
_BEHIND = {"flags": ("flags", "bits"), "record": ("records", "fields")}
"""The sections of facts that other facts name, and the lists of parts that they share."""
_NAMED = (("enum", "enums", "members"), ("flags", "flags", "bits"), ("flags", "flags", "states"))
"""By what a fact names: the section of it, and a list of the values that have names."""


class Meanings:
    """What names mean in the tree of a version."""

    def __init__(self, tree: Mapping) -> None:
        self.tree = tree
        self._roles: dict[str, list[Mapping]] | None = None

    def step(self, node: Node | None, step: str) -> Node | None:
        """The node that a step of a path leads to: below a node, or in the flags or the record that it names.

        In overlays a `frame` stands for both directions; it leads to the parts of the request.
        """
        known = find(node, step) if node is not None else None
        if known is None and step == FRAME:
            known = value_of(node, "request")
        if known is None:
            known = next((item for item in self.parts(node) if identity(item) == step), None)
        return known

    def parts(self, node: Node | None) -> Iterator[Mapping]:
        """The bits and fields that a fact has because of what it names."""
        for key, (section, parts) in _BEHIND.items():
            if isinstance(name := value_of(node, key), Scalar):
                yield from mappings(find(self.tree, f"{section}/{name.text}/{parts}"))

    def values(self, fact: Node | None) -> Iterator[tuple[Mapping, str]]:
        """The members, bits, states and special values of a fact, each with what it is."""
        for key, section, kind in _NAMED:
            if isinstance(name := value_of(fact, key), Scalar):
                yield from ((item, kind) for item in mappings(find(self.tree, f"{section}/{name.text}/{kind}")))
        yield from ((special, "special value") for special in mappings(value_of(fact, "sentinels")))

    def facts(self, name: str) -> list[Mapping]:
        """The facts that a step or an action means by a path or a role."""
        path = name.partition("[")[0]
        if "/" not in path:
            return self.with_role(path)
        section, *steps = path.split("/")
        node = find(self.tree, f"{section}/{steps[0]}")
        for step in steps[1:]:
            node = self.step(node, step)
        return [node] if isinstance(node, Mapping) else []

    def states(self, machine: str) -> Iterator[Scalar]:
        """The names of the states of a machine, which stand in its list and state nothing else."""
        machine_list = find(self.tree, f"behaviour/{machine}/machine")
        yield from (
            (node for _, node in children(machine_list) if isinstance(node, Scalar)) if machine_list is not None else ()
        )

    def with_role(self, role: str) -> list[Mapping]:
        """The facts that have a role."""
        if self._roles is None:
            self._roles = {}
            for section in _WITH_ROLES:
                for fact in _below(self.tree.values.get(section)):
                    roles = fact.values.get("roles")
                    for known in roles.items if isinstance(roles, Sequence) else (roles,):
                        if isinstance(known, Scalar):
                            self._roles.setdefault(known.text, []).append(fact)
        return self._roles.get(role, [])

    def fields(self, holder: Node, above: Node | None) -> Iterator[Mapping]:
        """The fields of the `values` or `arguments` of an example, a step, an action or their printed form.

        The `holder` has the `values`, and `above` has the path of the fact whose printed value it is.
        """
        fact = value_of(above, "fact")
        example = find(self.tree, fact.text) if isinstance(fact, Scalar) else None
        texts = {key: node.text for key, node in children(example or holder) if isinstance(node, Scalar)}
        direction, link = texts.get("direction", "request"), texts.get("link")
        for path in (f"messages/{texts.get('message')}/{direction}", f"links/{link}/{direction}"):
            yield from mappings(find(self.tree, path))
        if "exception_response" in texts:
            yield from self.parts(find(self.tree, f"links/{link}/exception_response"))
        for message in self.facts(texts["send"]) if "send" in texts else ():
            yield from mappings(message.values.get(direction))
        collection = find(self.tree, f"behaviour/{texts.get('append')}/collection")
        if isinstance(collection, Scalar):
            yield from mappings(find(self.tree, f"records/{collection.text}/fields"))


def _below(node: Node | None) -> Iterator[Mapping]:
    if isinstance(node, Mapping):
        yield node
    for _, child in children(node) if node is not None else ():
        yield from _below(child)


def value_of(node: Node | None, key: str) -> Node | None:
    """The value of a key of a node; None where there is none."""
    return node.values.get(key) if isinstance(node, Mapping) else None
