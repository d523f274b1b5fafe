"""The device as a whole."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.model.device import Device, Manual, Version, VersionLine
from fieldspec.model.registers import RegisterGroup
from fieldspec.reading.building import enums, links, records, registers, tasks, texts, values
from fieldspec.reading.building.context import Entry, Reused, reused_items
from fieldspec.reading.nodes import Mapping, Scalar, mappings
from fieldspec.source import Span

Item = TypeVar("Item")


def built(tree: Mapping, version: str, kept: Reused | None = None) -> tuple[Device, list[Diagnostic]]:
    """The model of a device's tree at one version, and what keeps it from being complete.

    `kept` has what was built of other versions of the device, and gets what is built here.
    """
    kept = {} if kept is None else kept
    found: list[Diagnostic] = []
    root = Entry(tree, "", found)
    head = root.entry("device")
    if head is None:
        raise ValueError("a device's tree has the section `device`")
    placed = _by_name(root, "signals", values.signal, kept)
    types = {name: one.value.type.name for name, one in placed.items()}
    return (
        Device(
            id=head.text("id"),
            version=version,
            place=head.place(),
            name=head.text("name"),
            vendor=head.text("vendor"),
            title=head.text("title"),
            doc=head.text("doc"),
            manual=_manual(head),
            lines=tuple(_line(entry) for entry in root.entries("versions", "line")),
            links=_by_name(root, "links", links.link, kept),
            messages=_by_name(root, "messages", lambda entry: records.message(entry, kept), kept),
            records=_by_name(root, "records", lambda entry: records.record(entry, kept), kept),
            enums=_by_name(root, "enums", enums.enum, kept),
            flags=_by_name(root, "flags", enums.flags, kept),
            spaces=_by_name(root, "spaces", registers.address_space, kept),
            groups=_groups(root, kept),
            tables=_by_name(root, "tables", registers.table, kept),
            parameters=_by_name(root, "parameters", lambda entry: registers.parameter_set(entry, kept), kept),
            signals=placed,
            conversions=_by_name(root, "conversions", lambda entry: values.conversion(entry, types), {}),
            lookups=tuple(_by_name(root, "lookups", texts.lookup, kept).values()),
            limits=tuple(_by_name(root, "limits", texts.limit, kept).values()),
            tasks=tuple(_by_name(root, "tasks", tasks.task, kept).values()),
            notes=tuple(_by_name(root, "notes", texts.note, kept).values()),
            examples=_by_name(root, "examples", texts.example, kept, "id"),
            errata=tuple(_by_name(root, "errata", texts.erratum, kept, "id").values()),
            accepts=tuple(texts.acceptance(entry) for entry in root.named("accepts", "accepts")),
        ),
        found,
    )


def _by_name(
    root: Entry, section: str, build: Callable[[Entry], Item], kept: Reused, name: str = "name"
) -> dict[str, Item]:
    """The nouns of a section by name; a name that is taken is a finding. What is the same node is the same noun."""
    held = root.own.get(section)
    sections, same = kept.setdefault((section, "whole"), {}), kept.setdefault(section, {})
    if id(held) in sections:
        return cast("dict[str, Item]", sections[id(held)][1])
    nouns: dict[str, Item] = {}
    first: dict[str, Mapping] = {}
    before = len(root.found)
    for item in mappings(held):
        key = _text(item, name)
        known = same.get(id(item))
        if key in nouns:
            label = Label(_span(first[key], name), "the first one")
            text = f"`{section}` has two entries named `{key}`"
            help = "give one of them another name"
            root.found.append(Diagnostic("duplicate_name", text, _span(item, name), (label,), help))
        elif known is not None:
            first[key], nouns[key] = item, cast("Item", known[1])
        else:
            quiet = len(root.found)
            first[key], nouns[key] = item, build(Entry(item, f"{section}/{key}", root.found))
            if len(root.found) == quiet:  # a finding is for every version
                same[id(item)] = item, nouns[key]
    if len(root.found) == before:
        sections[id(held)] = held, nouns
    return nouns


def _text(item: Mapping, key: str) -> str:
    held = item.values.get(key)
    return held.text if isinstance(held, Scalar) else ""


def _span(item: Mapping, name: str) -> Span:
    return Entry(item, "", []).span(name)


def _groups(root: Entry, kept: Reused) -> tuple[RegisterGroup, ...]:
    same = kept.setdefault("registers", {})
    return reused_items(root, "registers", "registers", "group", None, same, lambda entry: registers.group(entry, kept))


def _manual(head: Entry) -> Manual:
    entry = head.entry("manual")
    if entry is None:
        return Manual("", "", "", "", "", 0)
    return Manual(
        title=entry.text("title"),
        edition=entry.text("edition"),
        language=entry.text("language"),
        file=entry.text("file"),
        sha256=entry.text("sha256"),
        lines=entry.integer("lines") or 0,
    )


def _line(entry: Entry) -> VersionLine:
    members = tuple(
        Version(inner.text("id"), inner.text("title"), inner.text("doc"), inner.text("inferred"), inner.sources)
        for inner in entry.entries("members", "id")
    )
    return VersionLine(
        entry.text("line"),
        entry.text("title"),
        entry.flag("builds"),
        entry.text("like"),
        entry.text("inferred"),
        members,
    )
