"""What the values of an example or a step belong to: the fields of its frame, and what a value of theirs can mean."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.command.editor.typed_word import TypedWord
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, children, find, identity, mappings

VALUES = ("values", "arguments")
"""Mappings whose keys are fields of a frame."""


def fields(word: TypedWord) -> Iterator[Mapping]:
    """The fields of what the word is in: of the message and the link of an example or a step, or of a record there."""
    nodes, keys = word.place.nodes, word.place.keys
    number = next((number for number, key in enumerate(keys) if key in VALUES), None)
    if number is None:
        return
    inner = [key for key in keys[number + 1 :] if isinstance(key, str)]
    if not word.is_key:
        inner = inner[:-1]
    for spec in word.place.specs:
        tree = spec.tree_at(spec.versions()[-1])
        facts = [*_lists(tree, nodes[number], nodes[number - 1])]
        for key in inner:
            field = next((item for fact in facts for item in mappings(fact) if identity(item) == key), None)
            facts = [_of_record(tree, value_of(field, "record"))]
        yield from (item for fact in facts for item in mappings(fact))


def meanings(word: TypedWord, key: str) -> Iterator[tuple[Mapping, str]]:
    """The members, states, bits and special values of what a value is given for, in examples and steps."""
    nodes = word.place.nodes
    holder = nodes[-3] if isinstance(nodes[-2], Sequence) else nodes[-2]
    for spec in word.place.specs:
        tree = spec.tree_at(spec.versions()[-1])
        if "values" in word.place.keys:
            facts = [field for field in fields(word) if identity(field) == key]
        elif key == "value" and word.place.keys[0] == "tasks":
            targets = (value_of(holder, action) for action in ("write", "wait", "read"))
            facts = [fact for target in targets if isinstance(target, Scalar) for fact in _targets(tree, target.text)]
        else:
            return
        for fact in facts:
            for section, list_key in (("enums", "members"), ("flags", "bits"), ("flags", "states")):
                name = value_of(fact, section.removesuffix("s") if section == "enums" else section)
                whole = find(tree, f"{section}/{name.text}") if isinstance(name, Scalar) else None
                for item in mappings(value_of(whole, list_key)):
                    yield item, list_key
            for special in mappings(value_of(fact, "sentinels")):
                yield special, "special value"


def _targets(tree: Mapping, target: str) -> Iterator[Mapping]:
    """The facts that a step means by a path or a role."""
    if "/" in target:
        fact = find(tree, target)
        if isinstance(fact, Mapping):
            yield fact
        return
    for section in ("registers", "parameters", "messages", "signals"):
        for node in _below(tree.values.get(section)):
            roles = node.values.get("roles")
            texts = roles.items if isinstance(roles, Sequence) else (roles,)
            if any(isinstance(role, Scalar) and role.text == target for role in texts):
                yield node


def _below(node: Node | None) -> Iterator[Mapping]:
    if isinstance(node, Mapping):
        yield node
    for _, child in children(node) if node is not None else ():
        yield from _below(child)


def _lists(tree: Mapping, holder: Node, above: Node) -> Iterator[Node | None]:
    """The lists of the fields that an example, a step, an action of a behaviour or the print of an example gives."""
    fact = value_of(above, "fact")
    example = find(tree, fact.text) if isinstance(fact, Scalar) else None
    texts = {key: node.text for key, node in children(example or holder) if isinstance(node, Scalar)}
    direction = texts.get("direction", "request")
    yield find(tree, f"messages/{texts.get('message')}/{direction}")
    yield find(tree, f"links/{texts.get('link')}/{direction}")
    if "exception_response" in texts:
        yield _of_record(tree, value_of(find(tree, f"links/{texts.get('link')}/exception_response"), "record"))
    yield from (value_of(message, direction) for message in _targets(tree, texts.get("send", "")))
    collection = find(tree, f"behaviour/{texts.get('append') or texts.get('insert')}")
    yield _of_record(tree, value_of(collection, "collection"))


def _of_record(tree: Mapping, name: Node | None) -> Node | None:
    return find(tree, f"records/{name.text}/fields") if isinstance(name, Scalar) else None


def value_of(node: Node | None, key: str) -> Node | None:
    """The value of a key of a node; None where there is none."""
    return node.values.get(key) if isinstance(node, Mapping) else None
