"""The audit of a device as a table of contents."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.tools.audit.addresses import addresses, reads
from fieldspec.tools.audit.coverage import coverage
from fieldspec.tools.audit.detection import as_printed, detection, section
from fieldspec.tools.audit.hazards import access
from fieldspec.tools.audit.ledger import ledger
from fieldspec.tools.audit.review import sign_off
from fieldspec.tools.audit.section import Report, Section, Subject
from fieldspec.tools.audit.sources import sources
from fieldspec.tools.audit.statements import statements
from fieldspec.tools.audit.tasks import tasks

PARTS: tuple[Callable[[Subject], Section], ...] = (
    coverage,
    statements,
    ledger,
    detection,
    addresses,
    reads,
    access,
    tasks,
    sources,
    sign_off,
)
"""One function for each section, in the order of the report."""


def report(subject: Subject) -> Report:
    """The audit of a device at one version."""
    return _report(subject, tuple(part(subject) for part in PARTS))


def printed_report(subject: Subject) -> tuple[Report, tuple[Diagnostic, ...]]:
    """Blind detection as a report of one section, and its findings."""
    printed = as_printed(subject.spec, subject.proofs, thorough=True, known=subject.known)
    return _report(subject, (section(printed),)), printed.findings


def dump_report(layout: DeviceLayout, section: Section) -> Report:
    """A report with the section of a dump alone."""
    device = layout.device
    return Report(device.id, device.name, device.version, layout.identity, (section,))


def _report(subject: Subject, sections: tuple[Section, ...]) -> Report:
    device = subject.device
    return Report(device.id, device.name, device.version, subject.layout.identity, sections)
