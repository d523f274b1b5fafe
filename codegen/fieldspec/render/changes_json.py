"""Changes as JSON: a list of comparisons, each with its changes."""

from __future__ import annotations

import json
from collections.abc import Sequence

from fieldspec.render.changes import AcceptedChange, Difference
from fieldspec.source import Span


def rendered(differences: Sequence[Difference]) -> str:
    """The JSON text; lines and columns count from 1. `accepted` is null where nothing accepts a change."""
    data = [
        {"old": difference.old, "new": difference.new, "changes": [_change(entry) for entry in difference.changes]}
        for difference in differences
    ]
    return json.dumps(data, ensure_ascii=False, indent=1) + "\n"


def _change(entry: AcceptedChange) -> dict[str, object]:
    change, accepted = entry.change, entry.accepted
    return {
        "rule": change.rule,
        "class": change.effect.value,
        "breaking": change.effect.breaking,
        "kind": change.what,
        "path": change.path,
        "message": change.message,
        "old": change.old,
        "new": change.new,
        "before": _place(change.before),
        "after": _place(change.after),
        "outputs": list(change.outputs),
        "versions": list(entry.versions),
        "reason": change.reason or None,
        "accepted": {"reason": accepted.reason, "date": accepted.date} if accepted else None,
    }


def _place(span: Span | None) -> dict[str, object] | None:
    if span is None:
        return None
    line, column = span.position()
    return {"file": span.file.path, "line": line, "column": column}
