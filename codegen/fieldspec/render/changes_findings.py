"""Changes as findings, for the forms that code reviews take. What hurts nobody is left out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.changes.change import Effect
from fieldspec.diagnostics import Diagnostic, Label, Severity
from fieldspec.render.changes import Difference, Found, all_found, remark


def findings(differences: Sequence[Difference]) -> list[Diagnostic]:
    """A finding for each change that nothing accepts and that hurts somebody: breaking ones are errors.

    It stands in the new side where the fact is there, with the old place as its label, else in the old side.
    """
    return list(_findings(all_found(differences)))


def _findings(held: Sequence[Found]) -> Iterator[Diagnostic]:
    for found in held:
        change = found.change
        span = change.after or change.before
        if span is None or change.effect is Effect.DOCS:
            continue
        severity = Severity.ERROR if change.effect.breaking else Severity.WARNING
        labels = (Label(change.before, "before"),) if change.before is not None and change.after is not None else ()
        said = "; ".join(part for part in (f"{change.effect.value} at {change.path}", remark(found)) if part)
        yield Diagnostic(change.rule, change.message, span, labels, said, severity)
