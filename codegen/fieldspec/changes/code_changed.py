"""A message has another code, or, where it carries none, another number.

Why: old programs send, and understand, another message than they mean.

Example: `code: 0x2F` that becomes `code: 0x30`.

Cure: Where the old spec was wrong, accept the change with that reason; else give the new version a number of its
own.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.comparing import Comparison
from fieldspec.changes.finding import change, named, turned
from fieldspec.changes.spelling import hexadecimal
from fieldspec.model.message import Message


def code_changed(both: Comparison) -> Iterator[Change]:
    for pair in both.of(Message):
        if pair.old.code != pair.new.code:
            old, new = hexadecimal(pair.old.code), hexadecimal(pair.new.code)
            text = f"{named(pair.new)}: {turned('the code', old, new)}"
            yield change("code_changed", Effect.WIRE, pair, "code", text, old, new)
        if pair.old.number != pair.new.number:
            effect = Effect.WIRE if pair.new.code is None else Effect.DOCS
            text = f"{named(pair.new)}: {turned('the number', pair.old.number, pair.new.number)}"
            yield change("code_changed", effect, pair, "number", text, pair.old.number, pair.new.number)
