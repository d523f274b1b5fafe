"""The device as a whole."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar, cast

from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import replace
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic, Label, are_in_place
from fieldspec.language.model.address_space import WORDS, AddressSpace
from fieldspec.language.model.device import Detection, Device, Manual, Version, VersionLine
from fieldspec.language.model.fact import Place
from fieldspec.language.model.machines import StateMachine
from fieldspec.language.model.registers import RegisterGroup
from fieldspec.language.model.texts import Erratum, Note
from fieldspec.language.reading.building import enums, links, machines, records, registers, tasks, texts, values
from fieldspec.language.reading.building.context import Entry, Reused, reused_items
from fieldspec.language.reading.nodes import Mapping, Scalar, mappings, with_number_of_row

Item = TypeVar("Item")


def built(tree: Mapping, version: str, reused: Reused | None = None) -> tuple[Device, list[Diagnostic]]:
    """The model of a device's tree at one version, and the findings that keep it from being complete.

    `reused` has the objects of other versions of the device, and receives the objects of this version. Raises
    ValueError for a tree without the section `device`.
    """
    reused = {} if reused is None else reused
    findings: list[Diagnostic] = []
    root = Entry(tree, "", findings)
    head = root.entry("device")
    if head is None:
        raise ValueError("a device's tree has the section `device`")
    signals = _by_name(root, "signals", values.signal, reused)
    spaces = _by_name(root, "spaces", registers.address_space, reused)
    types = {name: signal.value.type.name for name, signal in signals.items()}
    return (
        head.built(
            Device,
            version=version,
            place=_place(head, reused),
            manual=_manual(head),
            lines=_lines(root, reused),
            links=_by_name(root, "links", lambda entry: links.link(entry, reused), reused),
            messages=_by_name(root, "messages", lambda entry: records.message(entry, reused), reused),
            records=_by_name(root, "records", lambda entry: records.record(entry, reused), reused),
            enums=_by_name(root, "enums", enums.enum, reused),
            flags=_by_name(root, "flags", enums.flags, reused),
            units=_by_name(root, "units", texts.declared_unit, reused),
            spaces=spaces,
            groups=_groups(root, spaces, reused),
            tables=_by_name(root, "tables", registers.table, reused),
            parameters=_by_name(root, "parameters", lambda entry: registers.parameter_set(entry, reused), reused),
            signals=signals,
            conversions=_by_name(
                root, "conversions", lambda entry: values.conversion(entry, types), reused, "name", *types.items()
            ),
            lookups=tuple(_by_name(root, "lookups", texts.lookup, reused).values()),
            limits=tuple(_by_name(root, "limits", texts.limit, reused).values()),
            tasks=tuple(_by_name(root, "tasks", tasks.task, reused).values()),
            notes=tuple(_with_rows(tree, note) for note in _by_name(root, "notes", texts.note, reused).values()),
            examples=_by_name(root, "examples", texts.example, reused, "id"),
            errata=tuple(
                _with_row(tree, erratum) for erratum in _by_name(root, "errata", texts.erratum, reused, "id").values()
            ),
            accepts=tuple(texts.acceptance(entry) for entry in root.named("accepts", "accepts")),
            machines=_machines(root, reused),
            stated_changes=tuple(texts.stated_change(entry) for entry in root.named("changes", "changes")),
        ),
        findings,
    )


def _place(head: Entry, reused: Reused) -> Place:
    same = reused.setdefault("place", ByIdentity())
    return cast("Place", same.get_or_compute(head.stated, lambda _: head.place()))


def _with_row(tree: Mapping, erratum: Erratum) -> Erratum:
    """An erratum about a row that it may name by a cell."""
    fact = with_number_of_row(tree, erratum.fact)
    return erratum if fact == erratum.fact else replace(erratum, fact=fact)


def _with_rows(tree: Mapping, note: Note) -> Note:
    """A note about rows that it may name by a cell."""
    paths = tuple(with_number_of_row(tree, path) for path in note.about)
    return note if paths == note.about else replace(note, about=paths)


def _by_name(
    root: Entry,
    section: str,
    build: Callable[[Entry], Item],
    reused: Reused,
    name: str = "name",
    *dependencies: object,
) -> dict[str, Item]:
    """The objects of a section by name. A name that occurs twice is a finding; the same node gives the same object.

    They depend on `dependencies` too.
    """
    sequence = root.own.get(section)
    sections = reused.setdefault((section, "whole", *dependencies), ByIdentity())
    same = reused.setdefault((section, *dependencies), ByIdentity())
    if sequence in sections:
        items, findings = cast("tuple[dict[str, Item], list[Diagnostic]]", sections[sequence])
        if are_in_place(findings):
            root.findings += findings
            return items
    items = {}
    first: dict[str, Mapping] = {}
    before = len(root.findings)
    for item in mappings(sequence):
        key = _scalar_text(item, name)
        if key in items:
            label = Label(_span(first[key], name), "the first one")
            text = f"`{section}` has two entries named `{key}`"
            help = "rename one of them"
            root.findings.append(Diagnostic("duplicate_name", text, _span(item, name), (label,), help))
        elif item in same:
            first[key], items[key] = item, cast("Item", same[item])
        else:
            quiet = len(root.findings)
            first[key], items[key] = item, build(Entry(item, f"{section}/{key}", root.findings))
            if len(root.findings) == quiet:  # a finding is for every version
                same[item] = items[key]
    sections[sequence] = items, root.findings[before:]
    return items


def _scalar_text(item: Mapping, key: str) -> str:
    scalar = item.values.get(key)
    return scalar.text if isinstance(scalar, Scalar) else ""


def _span(item: Mapping, name: str) -> Span:
    return Entry(item, "", []).span(name)


def _machines(root: Entry, reused: Reused) -> tuple[StateMachine, ...]:
    same = reused.setdefault("machines", ByIdentity())
    behaviour = root.own.get("behaviour")
    return cast("tuple[StateMachine, ...]", same.get_or_compute(behaviour, lambda _: machines.state_machines(root)))


def _groups(root: Entry, spaces: dict[str, AddressSpace], reused: Reused) -> tuple[RegisterGroup, ...]:
    sizes = {name: space.unit_size for name, space in spaces.items()}
    sizes.setdefault("", next(iter(sizes.values()), WORDS.unit_size))
    same = reused.setdefault(("registers", *sizes.items()), ByIdentity())
    return reused_items(
        root, "registers", "registers", "group", None, same, lambda entry: registers.group(entry, sizes, reused)
    )


def _manual(head: Entry) -> Manual:
    entry = head.entry("manual")
    if entry is None:
        return Manual()
    return entry.built(Manual)


def _lines(root: Entry, reused: Reused) -> tuple[VersionLine, ...]:
    same = reused.setdefault("versions", ByIdentity())
    return reused_items(root, "versions", "versions", "line", None, same, _line)


def _line(entry: Entry) -> VersionLine:
    members = tuple(
        inner.built(Version, detected_as=inner.scalars("detected_as")) for inner in entry.entries("members", "id")
    )
    return entry.built(
        VersionLine, name=entry.text("line"), versions=members, detected_by=_detection(entry.entry("detected_by"))
    )


def _detection(entry: Entry | None) -> Detection | None:
    if entry is None:
        return None
    return entry.built(Detection)
