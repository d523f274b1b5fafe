"""The device as a whole."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from fieldspec.diagnostics import Diagnostic, Label
from fieldspec.model.device import Device, Manual, Version, VersionLine
from fieldspec.reading.building import links, records, registers, signals, texts, words
from fieldspec.reading.building.context import Entry
from fieldspec.reading.building.keeping import Kept
from fieldspec.reading.nodes import Mapping

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
    placed = _by_name(root, "signals", signals.signal)
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
            links=_by_name(root, "links", links.link),
            messages=_by_name(root, "messages", records.message),
            records=_by_name(root, "records", records.record),
            enums=_by_name(root, "enums", words.enum),
            flags=_by_name(root, "flags", words.flags),
            groups=tuple(registers.group(entry, kept) for entry in root.named("registers", "registers", name="group")),
            tables=_by_name(root, "tables", registers.table),
            parameters=_by_name(root, "parameters", lambda entry: registers.parameter_set(entry, kept)),
            signals=placed,
            conversions=_by_name(root, "conversions", lambda entry: signals.conversion(entry, types)),
            lookups=tuple(_by_name(root, "lookups", texts.lookup).values()),
            limits=tuple(_by_name(root, "limits", texts.limit).values()),
            notes=tuple(_by_name(root, "notes", texts.note).values()),
            examples=_by_name(root, "examples", texts.example, "id"),
            errata=tuple(_by_name(root, "errata", texts.erratum, "id").values()),
            accepts=tuple(texts.acceptance(entry) for entry in root.named("accepts", "accepts")),
        ),
        found,
    )


def _by_name(root: Entry, section: str, build: Callable[[Entry], Noun], name: str = "name") -> dict[str, Noun]:
    """The nouns of a section by name; a name that is taken is a finding."""
    nouns: dict[str, Noun] = {}
    first: dict[str, Entry] = {}
    for entry in root.named(section, section, name=name):
        key = entry.text(name)
        if key in nouns:
            label = Label(first[key].span(name), "the first one")
            text = f"`{section}` has two entries named `{key}`"
            entry.refuse("duplicate_name", name, text, "give one of them another name", label)
            continue
        first[key] = entry
        nouns[key] = build(entry)
    return nouns


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
