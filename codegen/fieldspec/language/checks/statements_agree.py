"""The statements of a manual about one subject agree: nothing is `always` in one place and `sometimes` or
`never` in another.

Why: `the device always answers` on one page and `it does not answer` on another leave the author of a driver
with a timeout that is either a fault or normal.

Example: `{subject: reply, says: always, source: 6 L10}` and `{subject: reply, says: never, source: 7 L20}`.

Fix: State the correct fact in both places, and write an erratum for the place that prints something else.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Statement


def statements_agree(device: Device) -> Findings:
    first: dict[str, Statement] = {}
    for note in device.notes:
        for statement in note.statements:
            before = first.setdefault(statement.subject, statement)
            if before.says != statement.says:
                text = f"{statement.subject} is `{before.says}` in one place, but `{statement.says}` in another"
                related_label = label(before.place, "says", "the first one")
                help = "state the correct fact, and write an erratum for the place that prints something else"
                yield finding(statement.place, "says", text, help, related_label)
