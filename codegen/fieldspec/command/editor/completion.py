"""What can stand in place of the word that is typed: keys of the language, names of facts, words, addresses, paths."""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.command import rules
from fieldspec.command.editor.free_addresses import free_addresses
from fieldspec.command.editor.typed_word import MARK, TypedWord
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.language.behaviour.part import AXIS_PROPERTIES
from fieldspec.language.checks.finding import hexadecimal
from fieldspec.language.model.codecs import ChecksumCodec, NumberCodec, installed
from fieldspec.language.model.task import ACTIONS
from fieldspec.language.model.units import standard_units
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.findings import PROTOCOLS
from fieldspec.language.reading.meanings import VALUED, VALUES, Meanings, value_of
from fieldspec.language.reading.nodes import LISTS, Mapping, Node, Scalar, Sequence, children, find, identity, mappings
from fieldspec.language.reading.references import ASKED, HOLDERS, IN_USE, INNER, REFERENCES, named_facts
from fieldspec.language.schema import Schema, described, referred, resolved
from fieldspec.language.schema.manual import key_text

MOST = 2000
"""How many suggestions are made: no editor shows more."""

_PATH = re.compile(r"\bpaths? of\b")
"""The words in the description of a key that takes paths."""


@dataclass(frozen=True, slots=True)
class Suggestion:
    """A text that can stand in place of a word: of which `kind`, a `detail` about it, and its documentation."""

    text: str
    kind: str
    detail: str = ""
    documentation: str = ""


def suggestions(word: TypedWord) -> list[Suggestion]:
    """All texts that can stand in place of a word, the likeliest first, each once."""
    results = _keys(word) if word.is_key else _values(word)
    unique = {suggestion.text: suggestion for suggestion in reversed([*results]) if suggestion.text != MARK}
    return [*reversed(unique.values())][:MOST]


def _keys(word: TypedWord) -> Iterator[Suggestion]:
    place = word.place
    mapping = place.nodes[-1]
    present = mapping.values if isinstance(mapping, Mapping) else {}
    end = "" if word.has_colon else ": "
    last = str(place.keys[-1]) if place.keys else ""
    holder = place.nodes[-2] if len(place.nodes) > 1 else mapping
    if last == "allow":
        for rule in (*rules.all_rules(), *rules.installed_rules()):
            if rule.stage == "checks" and rule.code not in present:
                yield Suggestion(rule.code + end, "rule", documentation=rule.what)
    elif last in _OF_KEYS and isinstance(holder, Mapping):
        for key in holder.values:
            if key not in (*present, last):
                yield Suggestion(key + end, "key")
    elif not {*VALUES}.isdisjoint(place.keys):
        for field in fields(word):
            if (name := identity(field)) and name not in present:
                yield _named(field, name + end, "field")
    if (part := place.part()) is None:
        return
    if part is referred("#/$defs/behaviour_condition"):
        for spec in place.specs:
            yield from (replace(signal, text=signal.text + end) for signal in _signals(spec, word.before))
    required = part.get("required", ())
    for key in sorted(part.get("properties", {}), key=lambda key: key not in required):  # in the order of the language
        if key not in present:
            detail = "needed" if key in required else ""
            yield Suggestion(key + end, "key", detail, key_text(part, key))


_DEPTH_OF_RECORDS = len(("records", 0, "same_as"))
_OF_KEYS = ("inferred", "standard")
"""Mappings whose keys are the keys of the enclosing fact."""


def _values(word: TypedWord) -> Iterator[Suggestion]:
    place = word.place
    key = next((key for key in reversed(place.keys) if isinstance(key, str)), "")
    part = place.part() or {}
    if "/" not in word.before:
        yield from _numbers(word, key)
        yield from _words(part)
        yield from _of_the_fact(word, key)
        for spec in place.specs:
            yield from _names(spec, key)
            if part is referred("#/$defs/unit"):
                yield from _units(spec)
        if key == "space" and place.keys[0] == "parameters":
            sets = (value_of(parameter_set, "space") for spec in place.specs for parameter_set in _sets(spec))
            yield from (Suggestion(space.text, "space") for space in sets if isinstance(space, Scalar))
        if key == "protocol":
            paths = (path.split("/") for path in place.project.memory.files)
            yield from (Suggestion(name[:-5], "protocol") for folder, *_, name in paths if folder == PROTOCOLS)
        if key == "codec":
            kind = ChecksumCodec if "algorithm" in place.keys else NumberCodec
            yield from (Suggestion(name, "codec") for name, own in installed().items() if isinstance(own.codec, kind))
        if key == "proof":
            yield from (Suggestion(rule.code, "rule", documentation=rule.what) for rule in rules.all_rules())
        if key == "rule":
            yield from (Suggestion(rule.code, "rule", documentation=rule.what) for rule in rules.change_rules())
        if key == "line" and place.keys[0] == "overlay":
            lines = (line for spec in place.specs for line in mappings(spec.tree.values.get("versions")))
            yield from (_named(line, identity(line) or MARK, "line") for line in lines)
        yield from (_named(item, identity(item) or MARK, kind) for item, kind in meanings(word, key))
        yield from (Suggestion(state, "state") for state in states(word, key))
        if key == "enter":
            yield from (machine for spec in place.specs for machine in _machines(spec, ""))
    if part is referred("#/$defs/behaviour_signal"):
        for spec in place.specs:
            yield from _signals(spec, word.before)
    elif place.keys[0] == "tasks" and key in ACTIONS:
        yield from _words(referred("#/$defs/role")) if "/" not in word.before else ()
        for spec in place.specs:
            yield from _paths(spec, word.before)
    elif _PATH.search(_description(word)) or "/" in word.before:
        for spec in place.specs:
            yield from _paths(spec, word.before)


def _description(word: TypedWord) -> str:
    """The description of the key whose value is the word, or whose list contains the word."""
    place = word.place
    holder = replace(place, nodes=place.nodes[:-1], keys=place.keys[:-1])
    return described((holder if isinstance(place.nodes[-2], Sequence) else place).part() or {})


def _words(part: Schema) -> Iterator[Suggestion]:
    """The words that the language has for a value."""
    texts = part.get("enumDescriptions", [""] * len(part.get("enum", ())))
    for text, documentation in zip(part.get("enum", ()), texts, strict=True):
        yield Suggestion(str(text), "word", documentation=documentation)
    types = part.get("type", ())
    if "boolean" in ((types,) if isinstance(types, str) else types):
        yield from (Suggestion(text, "word") for text in ("true", "false"))
    for keyword in ("then", "else"):
        if keyword in part:
            yield from _words(resolved(part[keyword]))
    for keyword in ("anyOf", "oneOf"):
        for choice in part.get(keyword, ()):
            yield from _words(resolved(choice))


def _names(spec: DeviceSpec, key: str) -> Iterator[Suggestion]:
    """The names of the facts that a key refers to."""
    tree = spec.tree_at(spec.versions()[-1])
    for section, section_keys in REFERENCES.items():
        if key in section_keys:
            for name, fact in named_facts(tree.values.get(section, tree)).items():
                if not _HEADS.isdisjoint(fact.values):
                    yield _named(fact, name, section)


_HEADS = frozenset(("name", "id"))
"""Keys of facts that are named; groups and lines have other names, which no key refers to."""


def _of_the_fact(word: TypedWord, key: str) -> Iterator[Suggestion]:
    """The names of the parts of a fact, under the keys that name such."""
    nodes, keys = word.place.nodes, word.place.keys
    if key == "same_as" and keys[0] == "records" and len(keys) == _DEPTH_OF_RECORDS:
        for spec in word.place.specs:
            records = spec.tree_at(spec.versions()[-1]).values.get("records")
            yield from (_named(item, identity(item) or MARK, "records") for item in mappings(records))
    elif key in INNER and keys[0] in HOLDERS and len(nodes) > 2:
        for part_key in ASKED:
            for item in mappings(value_of(nodes[2], part_key)):
                if (name := identity(item)) and item is not nodes[-2]:
                    yield _named(item, name, "part")


def _named(fact: Mapping, text: str, kind: str) -> Suggestion:
    texts = (fact.values.get(key) for key in ("label", "title", "doc"))
    detail = next((node.text for node in texts if isinstance(node, Scalar)), "")
    return Suggestion(text, kind, detail)


def _sets(spec: DeviceSpec) -> Iterator[Mapping]:
    yield from mappings(spec.tree_at(spec.versions()[-1]).values.get("parameters"))


def _units(spec: DeviceSpec) -> Iterator[Suggestion]:
    tree = spec.tree_at(spec.versions()[-1])
    for declared in mappings(tree.values.get("units")):
        if isinstance(symbol := declared.values.get("symbol"), Scalar):
            yield _named(declared, symbol.text, "unit")
    used = {node.text for key, node in _scalars(tree) if key == "unit"}
    for unit in sorted(standard_units().values(), key=lambda unit: unit.symbol not in used):
        yield Suggestion(unit.symbol, "unit", unit.title)


def _scalars(node: Node) -> Iterator[tuple[str | int, Scalar]]:
    for key, child in children(node):
        if isinstance(child, Scalar):
            yield key, child
        else:
            yield from _scalars(child)


def _numbers(word: TypedWord, key: str) -> Iterator[Suggestion]:
    """The next number after that of the item before; for an address, those that are free."""
    nodes, keys = word.place.nodes, word.place.keys
    if len(nodes) < 3:
        return
    items, number = nodes[-3], keys[-2]
    neighbours: tuple[Node, ...] = ()
    added = value_of(items, "in") if number == "item" else None
    if isinstance(items, Sequence) and isinstance(number, int):
        neighbours = (*items.items[number - 1 : number], *items.items[number + 1 : number + 2])
    elif isinstance(added, Scalar):
        groups = (find(spec.tree_at(spec.versions()[-1]), added.text) for spec in word.place.specs)
        neighbours = tuple(row for group in groups for row in [*mappings(value_of(group, "rows"))][-1:])
    else:
        return
    last_number = _integer(value_of(neighbours[0], key)) if neighbours else None
    section = added.text.partition("/")[0] if isinstance(added, Scalar) else keys[0]
    if key in ("at", "base") and section in ("registers", "tables"):
        for spec in word.place.specs:
            for address in free_addresses(spec, _space(word), last_number, identity(nodes[-2]) or MARK):
                yield Suggestion(hexadecimal(address), "address", "free")
    elif last_number is not None and (word.place.part() or {}).get("type") == "integer":
        yield Suggestion(str(last_number + 1), "number", "the next one")


def _space(word: TypedWord) -> str:
    spaces = (value_of(node, "space") for node in reversed(word.place.nodes))
    return next((space.text for space in spaces if isinstance(space, Scalar)), "")


def _integer(node: Node | None) -> int | None:
    try:
        return int(node.text, 0) if isinstance(node, Scalar) else None
    except ValueError:
        return None


def _signals(spec: DeviceSpec, before: str) -> Iterator[Suggestion]:
    """What rules of behaviours look at: states of machines, roles, and paths."""
    if "/" not in before:
        yield from _words(referred("#/$defs/role"))
    yield from _machines(spec, "state/")
    yield from (Suggestion(f"axis/{name}", "axis") for name in AXIS_PROPERTIES)
    for record in mappings(spec.tree_at(spec.versions()[-1]).values.get("records")):
        for field in mappings(record.values.get("fields")):
            yield _named(field, f"element/{identity(field)}", "field")
    yield from _paths(spec, before)


def _machines(spec: DeviceSpec, start: str) -> Iterator[Suggestion]:
    for machine in mappings(spec.tree_at(spec.versions()[-1]).values.get("behaviour")):
        if (name := identity(machine)) and "machine" in machine.values:
            yield _named(machine, start + name, "state machine")


def _paths(spec: DeviceSpec, before: str) -> Iterator[Suggestion]:
    """The paths of facts, by one step more than the word has before the pointer."""
    tree = spec.tree_at(spec.versions()[-1])
    start, slash, _ = before.rpartition("/")
    if not slash:
        yield from (Suggestion(section, "section") for section in tree.values)
        return
    if before.startswith(IN_USE):
        for message in named_facts(tree.values.get("messages", tree)):
            for path in _paths(spec, f"messages/{message}/{before.removeprefix(IN_USE)}"):
                yield replace(path, text=IN_USE + path.text.split("/", 2)[-1])
        return
    section, _, inner = start.partition("/")
    if not inner:
        for name, fact in named_facts(tree.values.get(section, tree)).items():
            yield _named(fact, f"{start}/{name}", section)
        return
    fact_node, meanings = find(tree, f"{section}/{inner.partition('/')[0]}"), Meanings(tree)
    for step in inner.split("/")[1:]:
        fact_node = meanings.step(fact_node, step)
    yield from (_named(part, f"{start}/{identity(part)}", "part") for part in meanings.parts(fact_node))
    for key, child in children(fact_node) if fact_node is not None else ():
        if isinstance(fact_node, Mapping) and not isinstance(child, Scalar):
            yield Suggestion(f"{start}/{key}", "key")
            for item in mappings(child) if key in LISTS else ():
                if inner_name := identity(item):
                    yield _named(item, f"{start}/{inner_name}", str(key))
        elif isinstance(child, Mapping):
            yield _named(child, f"{start}/{identity(child) or key}", "item")


def fields(word: TypedWord) -> Iterator[Mapping]:
    """The fields of what the word is in: of the message and the link of an example or a step, or of a record there."""
    nodes, keys = word.place.nodes, word.place.keys
    number = next((number for number, key in enumerate(keys) if key in VALUES), None)
    if number is None:
        return
    inner = [key for key in keys[number + 1 :] if isinstance(key, str)]
    if not word.is_key:
        inner = inner[:-1]
    for device_meanings in _meanings(word):
        items = [*device_meanings.fields(nodes[number], nodes[number - 1])]
        for key in inner:
            items = [part for item in items if identity(item) == key for part in device_meanings.parts(item)]
        yield from items


def meanings(word: TypedWord, key: str) -> Iterator[tuple[Mapping, str]]:
    """The members, states, bits and special values of what a value is given for."""
    nodes, keys = word.place.nodes, word.place.keys
    holder = nodes[-3] if isinstance(nodes[-2], Sequence) else nodes[-2]
    for device_meanings in _meanings(word):
        facts: list[Mapping] = []
        if "values" in keys:
            facts = [field for field in fields(word) if identity(field) == key]
        elif "if" in keys:
            facts = device_meanings.facts(key)
        elif keys[0] in ("tasks", "behaviour"):
            targets = (value_of(holder, action) for action, valued in VALUED.items() if valued == key)
            facts = [
                fact for target in targets if isinstance(target, Scalar) for fact in device_meanings.facts(target.text)
            ]
        for fact in facts:
            yield from device_meanings.values(fact)


def states(word: TypedWord, key: str) -> Iterator[str]:
    """The states of the machine that a value is for."""
    if key == "state":
        machine = value_of(word.place.nodes[-2], "enter")
        name = machine.text if isinstance(machine, Scalar) else ""
    else:
        name = key.removeprefix("state/") if key.startswith("state/") else ""
    for device_meanings in _meanings(word) if name else ():
        yield from (state.text for state in device_meanings.states(name))


def _meanings(word: TypedWord) -> Iterator[Meanings]:
    """What names mean at the newest version of each device."""
    for spec in word.place.specs:
        yield Meanings(spec.tree_at(spec.versions()[-1]))
