"""A section of an audit report, and the subject of the audit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeAlias

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Citation
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.tools.audit.address_map import Space
from fieldspec.tools.audit.manual_lines import ManualIndex
from fieldspec.tools.facts import FactRow
from fieldspec.tools.proofs.errata import Proof
from fieldspec.tools.proofs.running import Outcome

Cell: TypeAlias = str | int | Span | Citation | None
"""A cell of a table: a text, a number, a place in a file, or a place in the manual. None is empty."""


@dataclass(frozen=True, slots=True)
class Figure:
    """A number for the top of a report: how many of what, and of how many in all, where that is known.

    `good` is whether the number is as it should be; None for a number that is neither good nor bad.
    """

    what: str
    number: int
    whole: int | None = None
    good: bool | None = None


@dataclass(frozen=True, slots=True)
class SectionTable:
    """Cells by row, under a title. The name of a column is the key of its cells in JSON.

    `kinds` has the mark of each row: `good`, `bad`, `warning`, or empty; without marks it is empty itself. `detail` is
    a long table, which a report in text form leaves out unless a user asks for everything.
    """

    name: str
    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    kinds: tuple[str, ...] = ()
    detail: bool = False


@dataclass(frozen=True, slots=True)
class Section:
    """A part of the report. `name` is its key in JSON and in links, `spaces` are the address maps to draw.

    `questions` is how many of its questions the manual leaves open. They are not findings: the spec cannot be corrected
    before they are answered.
    """

    name: str
    title: str
    paragraphs: tuple[str, ...] = ()
    figures: tuple[Figure, ...] = ()
    tables: tuple[SectionTable, ...] = ()
    findings: tuple[Diagnostic, ...] = ()
    spaces: tuple[Space, ...] = ()
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
    """The device of an audit at one version: its spec, its layout, and the proofs of the errata of all versions.

    `layouts` are the layouts of all built versions, the oldest first, `facts` the rows of each of them. `recorded` is
    the index of the manual in the folder of the spec, `manual` that of the text at hand; either may be missing. `known`
    is the outcome of all checks and proofs of the device, where they have run.
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
