"""What the facts of a device allow: which check may fail at them, and why."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.walking import facts
from fieldspec.classes import dataclass
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.fact import Fact
from fieldspec.source import Span


@dataclass(frozen=True, slots=True, eq=False)
class Allowance:
    """That a check may fail at a fact and at everything that the fact holds."""

    fact: Fact
    check: str

    def covers(self, finding: Diagnostic) -> bool:
        """Whether a finding of the check has its place, or a label, at the fact."""
        spans = [finding.span, *(label.span for label in finding.labels)]
        own = [self.fact.place.whole, *self.fact.place.spans.values()]
        return any(_within(span, outer) for span in spans for outer in own)


def allowances(device: Device) -> Iterator[Allowance]:
    """All allowances of a device."""
    for fact in facts(device):
        for check in fact.allowed:
            yield Allowance(fact, check)


def _within(span: Span, outer: Span) -> bool:
    return span.file is outer.file and outer.start <= span.start and span.end <= outer.end
