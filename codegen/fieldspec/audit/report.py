"""The audit of a device as a table of contents."""

from __future__ import annotations

from collections.abc import Callable

from fieldspec.audit.detection import detection
from fieldspec.audit.ledger import ledger
from fieldspec.audit.section import Report, Section
from fieldspec.audit.subject import Subject

PARTS: tuple[Callable[[Subject], Section], ...] = (
    ledger,
    detection,
)
"""One function a section, in the order of the report."""


def report(subject: Subject) -> Report:
    """The audit of a device at one version."""
    device = subject.device
    sections = tuple(part(subject) for part in PARTS)
    return Report(device.id, device.name, device.version, subject.layout.identity, sections)
