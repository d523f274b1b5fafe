"""A device with tasks has an entry for every task of the schema: its steps, the reason why it does not apply,
or the question that the manual leaves open. Only the tasks of grippers may be left out.

Why: a missing task looks as if the device could not do it. "How do I run a stored point?" needs an answer,
and if the manual has none, the spec says so.

Example: a section `tasks` without an entry for `save`.

Fix: Add a task with `steps`, `not_applicable` or `open`.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, enumeration, finding
from fieldspec.language.model.device import Device
from fieldspec.language.model.task import OF_GRIPPERS
from fieldspec.language.schema import schema


def tasks_complete(device: Device) -> Findings:
    if not device.tasks:
        return
    present_kinds = {task.kind for task in device.tasks}
    expected = [kind for kind in schema()["$defs"]["task_kind"]["enum"] if kind not in OF_GRIPPERS]
    missing = [kind for kind in expected if kind not in present_kinds]
    if missing:
        text = f"{device.name} has no entry for the tasks {enumeration(missing)}"
        help = "add a task with `steps`, `not_applicable` or `open` for each"
        yield finding(device.tasks[0].place, "task", text, help)
