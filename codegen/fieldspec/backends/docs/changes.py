"""What has changed from version to version: one page a device, for its users."""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from itertools import pairwise

from fieldspec.backends.docs.anchors import innermost
from fieldspec.backends.docs.document import (
    Block,
    Column,
    Document,
    Facts,
    Line,
    Paragraph,
    Row,
    Section,
    cell,
    clean,
    code,
    plain,
    styled,
    table,
)
from fieldspec.backends.docs.identity import version_title
from fieldspec.changes.change import Change, Effect
from fieldspec.changes.judging import Compared, Judged, judged
from fieldspec.classes import dataclass
from fieldspec.layout.device import DeviceLayout

NAME = "changes"
"""The page's name, without its ending. No version takes it from the page: see `page_name`."""

COLUMNS = (
    Column("What has changed", "wide", kept=True),
    Column("Fact", kept=True),
    Column("Remarks"),
)
MEANINGS = {
    Effect.WIRE: (
        "On the wire",
        "Bytes mean something else. Programs for the older version do wrong with the newer one.",
    ),
    Effect.SOURCE: (
        "In the source code",
        "Generated names or types change. Programs must be changed before they compile.",
    ),
    Effect.BEHAVIOUR: ("In behaviour", "Limits, defaults or access change, or there is more than there was."),
    Effect.DOCS: ("In the documentation", "What people read. No program is concerned."),
}
_TARGETS = {"python": "Python", "c": "C", "plc": "PLC"}


@dataclass(frozen=True, slots=True)
class Step:
    """A version, the one before it on its line, and what has changed between them, the gravest first."""

    old: DeviceLayout
    new: DeviceLayout
    changes: tuple[Judged, ...]

    def counts(self) -> str:
        """`2 on the wire, 1 in behaviour`"""
        some = ((sum(one.change.effect is effect for one in self.changes), MEANINGS[effect][0]) for effect in Effect)
        return ", ".join(f"{count} {title[:1].lower()}{title[1:]}" for count, title in some if count) or "nothing"


def steps(layouts: Sequence[DeviceLayout]) -> list[Step]:
    """The steps between neighbours on each line that has outputs, the oldest first."""
    by_version = {layout.device.version: layout for layout in layouts}
    found = []
    for line in layouts[-1].device.lines if layouts else ():
        held = [by_version[version.id] for version in line.versions if line.builds and version.id in by_version]
        found += [_step(old, new) for old, new in pairwise(held)]
    return found


def _step(old: DeviceLayout, new: DeviceLayout) -> Step:
    from fieldspec.changes import changes  # with all rules, for which a device of one version has no use

    compared = Compared(old.device, new.device, changes(old.device, new.device), step=True)
    return Step(old, new, tuple(judged(compared)))


def page_name(version: str) -> str:
    """The name of a version's page; those that other pages of the device have get an underscore behind them."""
    return f"{version}_" if version.lower() in (NAME, "index", "readme") else version


def changed(held: Sequence[Step], ending: str, anchors: dict[str, frozenset[str]]) -> Document:
    """The page, the newest version first. `ending` is that of the versions' pages, `anchors` what is on them."""
    newest = held[-1].new
    device = newest.device
    sections = tuple(_section(step, ending, anchors) for step in reversed(held))
    return Document(
        clean(f"{device.name}: changes from version to version"),
        clean(device.title),
        newest.identity,
        device.manual.language,
        ((plain("all versions", f"{'index' if ending == '.html' else 'README'}{ending}"),),),
        sections,
    )


def _section(step: Step, ending: str, anchors: dict[str, frozenset[str]]) -> Section:
    new, old = step.new, step.old
    title = f"{version_title(new.device)}, after {old.device.version}"
    pages = _Pages(step, ending, anchors)
    inner = (_effect(step, effect, pages) for effect in Effect)
    return Section(
        _anchor(new.device.version),
        (plain(title),),
        tuple(_head(step, pages)),
        tuple(section for section in inner if section is not None),
    )


def _anchor(version: str) -> str:
    return f"versions/{version}"


def link(version: str, ending: str) -> str:
    """Where the page says what has changed with a version."""
    return f"{NAME}{ending}#{_anchor(version)}"


def _head(step: Step, pages: _Pages) -> Iterator[Block]:
    version = next(
        (one for line in step.new.device.lines for one in line.versions if one.id == step.new.device.version), None
    )
    if version is not None:
        for text in (version.title, version.doc):
            if text:
                yield Paragraph((plain(text),))
    if not step.changes:
        yield Paragraph((plain("Nothing has changed."),))
    same = step.old.identity == step.new.identity
    identities: Line = (code(step.old.identity), plain(" and "), code(step.new.identity))
    yield Facts(
        (
            ("From", ((plain(step.old.device.version, pages.page(step.old)),),)),
            ("To", ((plain(step.new.device.version, pages.page(step.new)),),)),
            ("Identity", ((code(step.new.identity), plain(" in both")) if same else identities,)),
        )
    )


def _effect(step: Step, effect: Effect, pages: _Pages) -> Section | None:
    rows = [_row(one, pages) for one in step.changes if one.change.effect is effect]
    if not rows:
        return None
    title, meaning = MEANINGS[effect]
    caption = f"{title}: {step.old.device.version} to {step.new.device.version}"
    anchor = f"{_anchor(step.new.device.version)}/{effect.value}"
    return Section(anchor, (plain(title),), (Paragraph((plain(meaning),)), table(caption, COLUMNS, rows, heading=0)))


def _row(held: Judged, pages: _Pages) -> Row:
    change = held.change
    remarks: list[Line] = []
    if change.outputs:
        remarks.append((plain(f"in {', '.join(_TARGETS.get(name, name) for name in change.outputs)}"),))
    if held.accepted is not None:
        remarks.append((styled("accepted: ", "strong"), plain(held.accepted.reason)))
    return Row((cell(change.message), cell(code(change.path, pages.fact(change))), cell(*remarks)))


@dataclass(frozen=True, slots=True)
class _Pages:
    """The pages of the two versions of a step, for links to them."""

    step: Step
    ending: str
    anchors: dict[str, frozenset[str]]

    def page(self, layout: DeviceLayout) -> str:
        """The page of a version."""
        return f"{page_name(layout.device.version)}{self.ending}"

    def fact(self, change: Change) -> str:
        """The place of a fact on the page of the newer version, or of the older one if it is gone."""
        layout = self.step.old if change.after is None and change.before is not None else self.step.new
        known: Container[str] = self.anchors[layout.device.version]
        anchor = innermost(change.path, known)
        return f"{self.page(layout)}#{anchor}" if anchor else self.page(layout)
