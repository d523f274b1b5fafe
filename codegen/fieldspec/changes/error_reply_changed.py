"""A refusal is marked by another bit of the code, or has another record.

Why: programs take a refusal for an answer, or misread its reason.

Example: `error: {flag: 0x80}` that becomes `error: {flag: 0x40}`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.changes.spelling import hexadecimal
from fieldspec.model.link import ErrorReply, Link


def error_reply_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Link):
        old, new = _said(both, pair.old.error, True), _said(both, pair.new.error, False)
        if old != new:
            text = f"{named(pair.new)}: {turned('the reply that refuses', old, new)}"
            yield change("error_reply_changed", Effect.WIRE, pair, "error", text, old, new)


def _said(both: Comparison, error: ErrorReply | None, before: bool) -> str:
    if error is None:
        return ""
    record = both.renamed_to("records", error.record) if before else error.record
    return f"bit {hexadecimal(error.flag)} and the record {record or 'without fields'}"
