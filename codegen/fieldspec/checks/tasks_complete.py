"""A device that has tasks answers each task of the schema: with steps, with a reason why it has none, or with the
question that the manual leaves open.

Why: what nobody has asked looks as if it were not there. "How do I run a stored point?" must have an answer, or the
manual has none, and then the spec says so.

Example: a section `tasks` without an entry for `save`.

Cure: Add a task with `steps`, `not_applicable` or `open`.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import enumeration, finding
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.schema import schema


def tasks_complete(device: Device) -> Iterator[Diagnostic]:
    if not device.tasks:
        return
    answered = {task.kind for task in device.tasks}
    missing = [kind for kind in schema()["$defs"]["task_kind"]["enum"] if kind not in answered]
    if missing:
        text = f"nothing says how {device.name} does {enumeration(missing)}"
        help = "add a task with `steps`, `not_applicable` or `open` for each"
        yield finding("tasks_complete", device.tasks[0].place, "task", text, help)
