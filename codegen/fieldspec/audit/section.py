"""A section of an audit report, and the subject of the audit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeAlias

from fieldspec.audit.manual_lines import ManualIndex
from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic
from fieldspec.facts import FactRow
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.model.fact import Citation
from fieldspec.proofs.errata import Proof
from fieldspec.proofs.running import Outcome
from fieldspec.reading.project import DeviceSpec
from fieldspec.source import Span

Cell: TypeAlias = str | int | Span | Citation | None
"""A cell of a table: a text, a number, a place in a file, or a place in the manual."""


@dataclass(frozen=True, slots=True)
class Figure:
    """A number for the top of a report: how many of what, and of how many where there is a whole.

    `good` says whether the number is as it should be; None where it says nothing about good or bad.
    """

    what: str
    number: int
    whole: int | None = None
    good: bool | None = None


@dataclass(frozen=True, slots=True)
class SectionTable:
    """Cells by row, under a title. The name of a column is the key of its cells in data.

    `kinds` says of each row how it stands: `good`, `bad`, `warning`, or empty; there are none where all are plain.
    `detail` marks a long table, which a text for people leaves out unless it is asked for.
    """

    name: str
    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    kinds: tuple[str, ...] = ()
    detail: bool = False


@dataclass(frozen=True, slots=True)
class Section:
    """One part of the report. `name` is a word for data and links, `drawn` is what a renderer may draw of it.

    `questions` is how many questions of those that it lists the manual leaves open. They are no findings: nothing in
    the spec can be put right before somebody answers them.
    """

    name: str
    title: str
    says: tuple[str, ...] = ()
    figures: tuple[Figure, ...] = ()
    tables: tuple[SectionTable, ...] = ()
    findings: tuple[Diagnostic, ...] = ()
    drawn: object = None
    questions: int = 0


@dataclass(frozen=True, slots=True)
class Report:
    """The audit of a device: its sections, in the order in which people read them."""

    device: str
    title: str
    version: str
    identity: str
    sections: tuple[Section, ...]

    def findings(self) -> Iterator[Diagnostic]:
        """The findings of all sections."""
        for section in self.sections:
            yield from section.findings


@dataclass(frozen=True, slots=True)
class Subject:
    """A device at one version: its spec as written, its layout, and the proofs of its errata, those of all versions.

    `layouts` are those of all versions that are built, the oldest first, `facts` the rows of each of them. `recorded`
    is the index of the manual that stands beside the spec, `manual` that of the text at hand; either may be missing.
    `known` is what running everything on the device has given, where that has happened.
    """

    spec: DeviceSpec
    layout: DeviceLayout
    layouts: Sequence[DeviceLayout]
    facts: Sequence[Sequence[FactRow]]
    proofs: Sequence[Proof] = ()
    recorded: ManualIndex | None = None
    manual: ManualIndex | None = None
    known: Outcome | None = None

    @property
    def device(self) -> Device:
        """The model of the device."""
        return self.layout.device
