"""Joins the trees of several files: of a device, and of the protocols that it uses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from fieldspec.language.diagnostics import Diagnostic, Label
from fieldspec.language.reading.findings import near
from fieldspec.language.reading.nodes import Mapping, Node, Scalar, Sequence, identity
from fieldspec.language.reading.yaml_reader import key_span

_NO_DIGITS = str.maketrans("", "", "0123456789")

_DEVICE_SECTIONS = ("device", "protocol", "uses", "versions")


def joined(files: list[Mapping]) -> tuple[Mapping, list[Diagnostic]]:
    """One tree of all files: the items of lists follow each other, every other section occurs once."""
    whole = files[0]
    findings: list[Diagnostic] = []
    for tree in files[1:]:
        for key, value in tree.values.items():
            existing = whole.values.get(key)
            if isinstance(existing, Sequence) and isinstance(value, Sequence):
                whole = whole.with_value(key, _concatenated(existing, value))
            elif existing is None:
                whole = whole.with_entry(key, value, tree)
            else:
                first = Label(key_span(whole, key), "the first one")
                text = f"the section `{key}` is in two files of the device"
                findings.append(Diagnostic("section_twice", text, key_span(tree, key), (first,), "remove one of them"))
    return whole, findings


def _concatenated(first: Sequence, second: Sequence) -> Sequence:
    return Sequence(first.file, first.start, first.end, first.items + second.items)


def merged_over(device: Mapping, protocol: Mapping, use: Mapping) -> tuple[Mapping, list[Diagnostic]]:
    """The device's tree with the items that it uses of a protocol; where both have an item, the device's keys win."""
    findings: list[Diagnostic] = []
    for section, base in protocol.values.items():
        if section in _DEVICE_SECTIONS or not isinstance(base, Sequence):
            continue
        chosen, missing = _chosen(base, use.values.get(section), section)
        findings += missing
        messages = protocol.values.get("messages")
        if section == "records" and "messages" in use.values and isinstance(messages, Sequence):
            used, _ = _chosen(messages, use.values["messages"], "messages")
            chosen = used_records(protocol, chosen, used, device)
        own = device.values.get(section)
        if own is not None and section in ("links", "messages", "records"):
            findings += _misspelt(chosen, own)
        value = chosen if own is None else _merged(chosen, own)
        if section in device.values:
            device = device.with_value(section, value)
        else:
            device = device.with_entry(section, value, protocol)
    return device, findings


def _chosen(base: Sequence, names: Node | None, section: str) -> tuple[Sequence, list[Diagnostic]]:
    """The items of a section whose names are listed, or all where nothing is listed."""
    if not isinstance(names, Sequence):
        return base, []
    by_name = {identity(item): item for item in base.items}
    findings = []
    items = []
    for name in names.items:
        if isinstance(name, Scalar) and name.text not in by_name:
            text = f"the protocol has no {section[:-1]} `{name.text}`"
            hint = near(name.text, [known for known in by_name if known is not None])
            findings.append(Diagnostic("references_resolve", text, name.span, help=hint))
        elif isinstance(name, Scalar):
            items.append(by_name[name.text])
    return Sequence(base.file, base.start, base.end, tuple(items)), findings


def _merged(base: Node, override: Node) -> Node:
    """`base` overridden by `override`: mappings by key, lists of named items by name, everything else as a whole."""
    if isinstance(base, Mapping) and isinstance(override, Mapping):
        base = _without_standards(base, override)
        values, keys = dict(base.values), {key: base.holder(key) for key in base.values}
        for key, value in override.values.items():
            existing = base.values.get(key)
            values[key] = value if existing is None else _merged(existing, value)
            if key == "rows" and isinstance(existing, Sequence) and isinstance(value, Sequence):
                values[key] = rows_in_order(values[key], existing, value)
            keys[key] = override.holder(key)
        return Mapping(override.file, override.start, override.end, values, keys)
    if isinstance(base, Sequence) and isinstance(override, Sequence) and _has_names(base) and _has_names(override):
        extra = {identity(item): item for item in override.items}
        items = [_merged(item, extra.pop(identity(item), item)) for item in base.items]
        return Sequence(override.file, override.start, override.end, (*items, *extra.values()))
    return override


def _misspelt(base: Node, override: Node, is_inside: bool = False) -> Iterator[Diagnostic]:
    """The parts and fields that an entry adds to the protocol's under names that are almost theirs."""
    if isinstance(base, Mapping) and isinstance(override, Mapping):
        for key, value in override.values.items():
            existing = base.values.get(key)
            if existing is not None:
                yield from _misspelt(existing, value, True)
    elif isinstance(base, Sequence) and isinstance(override, Sequence) and _has_names(base) and _has_names(override):
        entries = {identity(item): item for item in base.items}
        free = [name for name in entries if name is not None and name not in map(identity, override.items)]
        for item in override.items:
            name = identity(item) or ""
            if name in entries:
                yield from _misspelt(entries[name], item, True)
            elif is_inside and (like := _similar_name(name, free)) and isinstance(item, Mapping):
                text = f"`{name}` is not a name of the protocol here, and would be added after its names"
                help = f"did you mean `{like}`? Another one needs a name that is less like it"
                yield Diagnostic("references_resolve", text, item.values.get("name", item).span, help=help)


def _similar_name(name: str, known: list[str]) -> str:
    """The known name that is almost a name, and does not differ by a number alone; empty where there is none."""
    from difflib import get_close_matches

    letters = name.translate(_NO_DIGITS)
    candidates = [other for other in known if other.translate(_NO_DIGITS) != letters]
    return next(iter(get_close_matches(name, candidates, 1, 0.8)), "")


def _without_standards(base: Mapping, override: Mapping) -> Mapping:
    """An entry without the clauses of standards for the keys that `override` states itself."""
    standards = base.values.get("standard")
    if not isinstance(standards, Mapping):
        return base
    for key, clause in standards.values.items():
        if isinstance(clause, Mapping) and key in override.values:
            standards = standards.without(key)
    return base.with_value("standard", standards) if standards.values else base.without("standard")


def _has_names(sequence: Sequence) -> bool:
    return bool(sequence.items) and all(identity(item) is not None for item in sequence.items)


def rows_in_order(merged: Node, base: Sequence, override: Sequence) -> Node:
    """Merged rows with each row that `base` does not have after the row of `base` that it follows in `override`."""
    assert isinstance(merged, Sequence)
    if any(identity(item) is None for item in (*base.items, *override.items)):
        return merged
    known = {identity(item) for item in base.items}
    following: dict[str, list[Node]] = {}
    last: str | None = None
    for item in override.items:
        name = identity(item)
        if name in known:
            last = name
        elif last is not None:
            following.setdefault(last, []).append(item)
    moved = {identity(item) for items in following.values() for item in items}
    rows: list[Node] = []
    for item in merged.items:
        if identity(item) not in moved:
            rows += [item, *following.get(identity(item) or "", ())]
    return Sequence(merged.file, merged.start, merged.end, tuple(rows))


def used_records(protocol: Mapping, records: Sequence, messages: Sequence, device: Mapping) -> Sequence:
    """The records without those that only other messages of the protocol have.

    `messages` are the chosen ones. A record stays if the device has an entry of it, or names it.
    """
    all_messages = protocol.values.get("messages")
    chosen = {identity(message) for message in messages.items}
    other_messages = [message for message in _items(all_messages) if identity(message) not in chosen]
    by_name = {identity(record): record for record in records.items}
    sections = (own for key, own in protocol.values.items() if key not in ("messages", "records"))
    entries = {identity(record) for record in _items(device.values.get("records"))}
    needed_names = _with_inner({*_names((*sections, *messages.items, device)), *entries}, by_name)
    unneeded = _with_inner(_names(other_messages), by_name) - needed_names
    items = tuple(record for record in records.items if identity(record) not in unneeded)
    return Sequence(records.file, records.start, records.end, items)


def _items(node: Node | None) -> tuple[Node, ...]:
    return node.items if isinstance(node, Sequence) else ()


def _with_inner(names: set[str | None], records: dict[str | None, Node]) -> set[str | None]:
    """Names of records and of the records in them."""
    reached: set[str | None] = set()
    waiting = names
    while waiting:
        reached |= waiting
        waiting = _names(records[name] for name in waiting if name in records) - reached
    return reached


def _names(nodes: Iterable[Node]) -> set[str | None]:
    """The names under `record` anywhere in some nodes."""
    names: set[str | None] = set()
    waiting = [*nodes]
    while waiting:
        node = waiting.pop()
        if isinstance(node, Mapping):
            name = node.values.get("record")
            if isinstance(name, Scalar):
                names.add(name.text)
            waiting += node.values.values()
        elif isinstance(node, Sequence):
            waiting += node.items
    return names
