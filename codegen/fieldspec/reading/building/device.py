"""The device as a whole."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.model.device import Device, Manual, Version, VersionLine
from fieldspec.model.register import RegisterGroup
from fieldspec.reading.building import links, records, registers, signals, texts, words
from fieldspec.reading.building.context import Entry
from fieldspec.reading.building.keeping import Kept, listed
from fieldspec.reading.nodes import Mapping, Scalar, Sequence

Noun = TypeVar("Noun")


def built(tree: Mapping, version: str, kept: Kept | None = None) -> tuple[Device, list[Diagnostic]]:
    """The model of a device's tree at one version, and what keeps it from being complete.

    `kept` has what was built of other versions of the device, and gets what is built here.
    """
    kept = {} if kept is None else kept
    found: list[Diagnostic] = []
    root = Entry(tree, "", found)
    head = root.entry("device")
    if head is None:
        raise ValueError("a device's tree has the section `device`")
    placed = _by_name(root, "signals", signals.signal, kept)
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
            enums=_by_name(root, "enums", words.enum, kept),
            flags=_by_name(root, "flags", words.flags, kept),
            groups=_groups(root, kept),
            tables=_by_name(root, "tables", registers.table, kept),
            parameters=_by_name(root, "parameters", lambda entry: registers.parameter_set(entry, kept), kept),
            signals=placed,
            conversions=_by_name(root, "conversions", lambda entry: signals.conversion(entry, types), {}),
            lookups=tuple(_by_name(root, "lookups", texts.lookup, kept).values()),
            limits=tuple(_by_name(root, "limits", texts.limit, kept).values()),
            notes=tuple(_by_name(root, "notes", texts.note, kept).values()),
            examples=_by_name(root, "examples", texts.example, kept, "id"),
            errata=tuple(_by_name(root, "errata", texts.erratum, kept, "id").values()),
            accepts=tuple(texts.acceptance(entry) for entry in root.named("accepts", "accepts")),
        ),
        found,
    )


def _by_name(
    root: Entry, section: str, build: Callable[[Entry], Noun], kept: Kept, name: str = "name"
) -> dict[str, Noun]:
    """The nouns of a section by name; a name that is taken is a finding. What is the same node is the same noun."""
    whole = root.own.get(section)
    wholes, same = kept.setdefault((section, "whole"), {}), kept.setdefault(section, {})
    known = wholes.get(id(whole))
    if known is not None:
        return cast("dict[str, Noun]", known[1])
    nouns: dict[str, Noun] = {}
    first: dict[str, Mapping] = {}
    quiet = len(root.found)
    for number, item in enumerate(whole.items if isinstance(whole, Sequence) else ()):
        if not isinstance(item, Mapping):
            continue
        held = item.values.get(name)
        key = held.value if isinstance(held, Scalar) and isinstance(held.value, str) else ""
        before = same.get(id(item))
        if before is not None and key not in nouns:
            first[key], nouns[key] = item, cast("Noun", before[1])
            continue
        entry = Entry(item, f"{section}/{held.text if isinstance(held, Scalar) else number}", root.found)
        if key in nouns:
            label = Label(Entry(first[key], "", []).span(name), "the first one")
            text = f"`{section}` has two entries named `{key}`"
            entry.refuse("duplicate_name", name, text, "give one of them another name", label)
            continue
        first[key] = item
        before_it = len(root.found)
        nouns[key] = build(entry)
        if len(root.found) == before_it:  # a finding is for every version
            same[id(item)] = item, nouns[key]
    if len(root.found) == quiet:
        wholes[id(whole)] = whole, nouns
    return nouns


def _groups(root: Entry, kept: Kept) -> tuple[RegisterGroup, ...]:
    same = kept.setdefault("registers", {})
    return listed(root, "registers", "registers", "group", None, same, lambda entry: registers.group(entry, kept))


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
    return VersionLine(entry.text("line"), entry.text("title"), entry.flag("builds"), members)
