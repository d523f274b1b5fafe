"""The findings in a spec, as data. Nothing here prints."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum

from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span


class Severity(Enum):
    """How bad a finding is. With an error, a build writes nothing of the device."""

    ERROR = "error"
    WARNING = "warning"


@dataclass(frozen=True, slots=True)
class Label:
    """Another place that takes part in a finding, and what it has to do with it."""

    span: Span
    text: str


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One finding. `code` is the name of its rule; `help` says what would make it right."""

    code: str
    message: str
    span: Span
    labels: tuple[Label, ...] = ()
    help: str = ""
    severity: Severity = Severity.ERROR

    def order(self) -> tuple[tuple[str, int, int], str, str]:
        """A key that sorts findings by place, then by rule."""
        return self.span.order(), self.code, self.message


LEAVE_OUT = "leave this output out for the device: name the others after --to"
"""The help of a finding that an output does not express a fact."""


def in_order(findings: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Findings by file and place, each once."""
    unique = {(d.code, d.message, d.span.file.path, d.span.start): d for d in findings}
    return sorted(unique.values(), key=Diagnostic.order)


def has_errors(findings: Iterable[Diagnostic]) -> bool:
    """Whether any finding is an error."""
    return any(d.severity is Severity.ERROR for d in findings)


def are_in_place(findings: Iterable[Diagnostic]) -> bool:
    """Whether no file that findings are in was read again after they were found."""
    spans = (span for finding in findings for span in (finding.span, *(label.span for label in finding.labels)))
    return not any(span.file.past for span in spans)
