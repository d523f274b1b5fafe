"""The changes from version to version, and the list of a device's versions."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from itertools import pairwise

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.html_text import clean
from fieldspec.language.changes.acceptances import ComparedVersions, JudgedChange, judged_changes
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.model.device import Version
from fieldspec.targets import PageLink
from fieldspec.targets.docs.context import cited
from fieldspec.targets.docs.device import version_title
from fieldspec.targets.docs.document import (
    Block,
    Cell,
    Document,
    Facts,
    Line,
    Paragraph,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    innermost,
    styled,
    table,
    text_piece,
)

NAME = "changes"
"""The page's name, without its ending. No version takes it from the page: see `page_name`."""

COLUMNS = (
    TableColumn("Change", "wide", unbroken=True),
    TableColumn("Fact", unbroken=True),
    TableColumn("Remarks"),
)

MEANINGS = {
    Effect.WIRE: (
        "On the wire",
        "Bytes have a different meaning. Programs for the older version do not work correctly with the newer one.",
    ),
    Effect.SOURCE: (
        "In the source code",
        "Generated names or types change. Programs must be changed before they compile.",
    ),
    Effect.BEHAVIOUR: ("In behaviour", "Limits, defaults or access change, or something is new."),
    Effect.DOCS: ("In the documentation", "Only texts for people change. No program is affected."),
}
_TARGETS = {"python": "Python", "c": "C", "plc": "PLC"}


@dataclass(frozen=True, slots=True)
class Step:
    """A version, the one before it on its line, and what has changed between them, the gravest first."""

    old: DeviceLayout
    new: DeviceLayout
    changes: tuple[JudgedChange, ...]

    def counts(self) -> str:
        """`2 on the wire, 1 in behaviour`"""
        effect_counts = (
            (sum(change.change.effect is effect for change in self.changes), MEANINGS[effect][0]) for effect in Effect
        )
        return (
            ", ".join(f"{count} {title[:1].lower()}{title[1:]}" for count, title in effect_counts if count) or "nothing"
        )


def steps(layouts: Sequence[DeviceLayout]) -> list[Step]:
    """The steps between neighbours on each line that has outputs, the oldest first."""
    by_version = {layout.device.version: layout for layout in layouts}
    line_steps = []
    for line in layouts[-1].device.lines if layouts else ():
        line_layouts = [by_version[version.id] for version in line.versions if line.builds and version.id in by_version]
        line_steps += [_step(old, new) for old, new in pairwise(line_layouts)]
    return line_steps


def _step(old: DeviceLayout, new: DeviceLayout) -> Step:
    from fieldspec.language.changes.table import changes  # with all rules, for which a device of one version has no use

    compared = ComparedVersions(old.device, new.device, changes(old.device, new.device), step=True)
    return Step(old, new, tuple(judged_changes(compared)))


def page_name(version: str) -> str:
    """The name of a version's page; those that other pages of the device have get an underscore after them."""
    return f"{version}_" if version.lower() in (NAME, "index", "readme", "lab") else version


def changed(device_steps: Sequence[Step], ending: str, anchors: dict[str, frozenset[str]]) -> Document:
    """The page, the newest version first. `ending` is that of the versions' pages, `anchors` what is on them."""
    newest = device_steps[-1].new
    device = newest.device
    sections = tuple(_section(step, ending, anchors) for step in reversed(device_steps))
    return Document(
        clean(f"{device.name}: changes from version to version"),
        clean(device.title),
        newest.identity,
        device.manual.language,
        ((text_piece("all versions", f"{'index' if ending == '.html' else 'README'}{ending}"),),),
        sections,
    )


def _section(step: Step, ending: str, anchors: dict[str, frozenset[str]]) -> Section:
    new, old = step.new, step.old
    title = f"{version_title(new.device)}, after {old.device.version}"
    pages = _Pages(step, ending, anchors)
    inner = (_effect(step, effect, pages) for effect in Effect)
    return Section(
        _anchor(new.device.version),
        (text_piece(title),),
        tuple(_head(step, pages)),
        tuple(section for section in inner if section is not None),
    )


def _anchor(version: str) -> str:
    return f"versions/{version}"


def link(version: str, ending: str) -> str:
    """The link to the section of a page with the changes of a version."""
    return f"{NAME}{ending}#{_anchor(version)}"


def _head(step: Step, pages: _Pages) -> Iterator[Block]:
    version = next(
        (
            version
            for line in step.new.device.lines
            for version in line.versions
            if version.id == step.new.device.version
        ),
        None,
    )
    if version is not None:
        for text in (version.title, version.doc):
            if text:
                yield Paragraph((text_piece(text),))
    if not step.changes:
        yield Paragraph((text_piece("Nothing has changed."),))
    same = step.old.identity == step.new.identity
    identities: Line = (code(step.old.identity), text_piece(" and "), code(step.new.identity))
    yield Facts(
        (
            ("From", ((text_piece(step.old.device.version, pages.page(step.old)),),)),
            ("To", ((text_piece(step.new.device.version, pages.page(step.new)),),)),
            ("Identity", ((code(step.new.identity), text_piece(" in both")) if same else identities,)),
        )
    )


def _effect(step: Step, effect: Effect, pages: _Pages) -> Section | None:
    rows = [_change_row(change, pages) for change in step.changes if change.change.effect is effect]
    if not rows:
        return None
    title, meaning = MEANINGS[effect]
    caption = f"{title}: {step.old.device.version} to {step.new.device.version}"
    anchor = f"{_anchor(step.new.device.version)}/{effect.value}"
    return Section(
        anchor, (text_piece(title),), (Paragraph((text_piece(meaning),)), table(caption, COLUMNS, rows, heading=0))
    )


def _change_row(judged_change: JudgedChange, pages: _Pages) -> TableRow:
    change = judged_change.change
    remarks: list[Line] = []
    if change.outputs:
        remarks.append((text_piece(f"in {', '.join(_TARGETS.get(name, name) for name in change.outputs)}"),))
    if change.reason:
        remarks.append((styled("reason: ", "strong"), text_piece(change.reason)))
    if judged_change.accepted is not None:
        remarks.append((styled("accepted: ", "strong"), text_piece(judged_change.accepted.reason)))
    return TableRow((cell(change.message), cell(code(change.path, pages.fact(change))), cell(*remarks)))


@dataclass(frozen=True, slots=True)
class _Pages:
    """The pages of the two versions of a step, for links to them."""

    step: Step
    ending: str
    anchors: dict[str, frozenset[str]]

    def page(self, layout: DeviceLayout) -> str:
        """The file name of the page of a version."""
        return f"{page_name(layout.device.version)}{self.ending}"

    def fact(self, change: Change) -> str:
        """The place of a fact on the page of the newer version, or of the older one if it is gone."""
        layout = self.step.old if change.after is None and change.before is not None else self.step.new
        known: Container[str] = self.anchors[layout.device.version]
        anchor = innermost(change.path, known)
        return f"{self.page(layout)}#{anchor}" if anchor else self.page(layout)


VERSION_COLUMNS = (
    TableColumn("Version", unbroken=True),
    TableColumn("Description", "wide"),
    TableColumn("Registers", "number"),
    TableColumn("Messages", "number"),
    TableColumn("Parameters", "number"),
    TableColumn("Example frames", "number"),
    TableColumn("Changed since the previous version"),
    TableColumn("Identity", unbroken=True),
    TableColumn("Source", "source"),
)


def versions(
    layouts: Sequence[DeviceLayout], device_steps: Sequence[Step], ending: str, links: Sequence[PageLink] = ()
) -> Document:
    """The versions, the newest first, and the steps between them; `ending` is that of the pages to which they lead.

    `links` lead to other pages of the device.
    """
    newest = layouts[-1]
    device = newest.device
    known = {version.id: version for line in device.lines for version in line.versions}
    came_by = {step.new.device.version: step for step in device_steps}
    rows = []
    for layout in reversed(layouts):
        version = layout.device.version
        rows.append(_version_row(layout, known.get(version), came_by.get(version), ending))
    blocks = [Paragraph((text_piece(device.doc),))] if device.doc else []
    section = Section(
        "versions", (text_piece("Versions"),), (*blocks, table("Versions, the newest first", VERSION_COLUMNS, rows))
    )
    summary = tuple((text_piece(link.text, link.file),) for link in links)
    return Document(
        clean(device.name), clean(device.title), newest.identity, device.manual.language, summary, (section,)
    )


def _version_row(layout: DeviceLayout, version: Version | None, step: Step | None, ending: str) -> TableRow:
    device = layout.device
    doc: list[Line] = []
    if version is not None:
        doc = [(text_piece(text),) for text in (version.title, version.doc) if text]
        if version.inferred:
            doc.append((styled("inferred: ", "strong"), text_piece(version.inferred)))
    if layout.equal_versions:
        doc.append((text_piece(f"The same holds for {', '.join(layout.equal_versions)}."),))
    return TableRow(
        (
            cell(text_piece(version_title(device), f"{page_name(device.version)}{ending}")),
            cell(*doc),
            _count(sum(register.count for register in device.registers())),
            _count(len(device.messages)),
            _count(sum(len(parameter_set.parameters) for parameter_set in device.parameters.values())),
            _count(len(device.examples)),
            cell(text_piece(step.counts(), link(device.version, ending)) if step is not None else ()),
            cell(code(layout.identity)),
            cell(cited(version.sources) if version else ()),
        )
    )


def _count(number: int) -> Cell:
    return cell(str(number)) if number else Cell()
