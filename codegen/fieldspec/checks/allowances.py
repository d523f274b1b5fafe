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

    def spans(self) -> list[Span]:
        """Where the fact stands, and the values of its keys, some of which may come from elsewhere."""
        return [self.fact.place.whole, *self.fact.place.spans.values()]


def covered(finding: Diagnostic, allowed: list[Span]) -> bool:
    """Whether a finding has its place, or a label, within one of some spans."""
    spans = [finding.span, *(label.span for label in finding.labels)]
    return any(_within(span, outer) for span in spans for outer in allowed)


def allowances(device: Device, check: str = "") -> Iterator[Allowance]:
    """All allowances of a device, or those for one check."""
    for fact in facts(device):
        if fact.allowed:
            for allowed in fact.allowed:
                if not check or allowed == check:
                    yield Allowance(fact, allowed)


def _within(span: Span, outer: Span) -> bool:
    return span.file is outer.file and outer.start <= span.start and span.end <= outer.end
