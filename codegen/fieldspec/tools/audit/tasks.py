"""The section about tasks: what people do with the device, and what the manual leaves open about it."""

from __future__ import annotations

from fieldspec.language.model.task import OF_GRIPPERS, Task, step_text
from fieldspec.language.schema import schema
from fieldspec.tools.audit.section import Cell, Figure, Section, SectionTable, Subject

STEPS, NOT_APPLICABLE, OPEN, MISSING = "steps", "not applicable", "open question", "missing"
_INTRODUCTION = (
    "What people do with the device. Each task has the steps that the manual prints, a reason why the device has no "
    "such task, or the question that the manual leaves open."
)


def tasks(subject: Subject) -> Section:
    """The section with the answers of the spec to all tasks of the schema; gripper tasks only if it has them."""
    device = subject.device
    stated = {task.kind for task in device.tasks}
    all_kinds: list[str] = schema()["$defs"]["task_kind"]["enum"]
    kinds = [kind for kind in all_kinds if kind in stated or kind not in OF_GRIPPERS]
    rows: list[tuple[Cell, ...]] = []
    states: list[str] = []
    for kind in kinds:
        answers = [task for task in device.tasks if task.kind == kind]
        for task in answers:
            states.append(_standing(task))
            source = task.sources[0] if task.sources else None
            rows.append((kind, task.name, states[-1], task.open or task.not_applicable, source, task.place["name"]))
        if not answers:
            states.append(MISSING)
            rows.append((kind, "", MISSING, "the spec does not say how it is done", None, None))
    marks = {STEPS: "good", NOT_APPLICABLE: "", OPEN: "warning", MISSING: "bad"}
    steps = [
        (task.name, number, step_text(step), step.sources[0] if step.sources else None, step.place[step.action])
        for task in device.tasks
        for number, step in enumerate(task.steps, 1)
    ]
    answer_count = len(kinds) - states.count(MISSING)
    figures = (
        Figure(
            "tasks that the spec answers",
            answer_count,
            len(kinds),
            answer_count == len(kinds) if device.tasks else None,
        ),
        Figure("ways to perform a task, with steps that the manual prints", states.count(STEPS)),
        Figure("tasks with a question that the manual leaves open", states.count(OPEN)),
    )
    tables = (
        SectionTable(
            "tasks",
            "Tasks",
            ("task", "way", "answer", "why", "source", "spec"),
            tuple(rows),
            tuple(marks[state] for state in states),
        ),
        SectionTable("steps", "Steps", ("way", "step", "what", "source", "spec"), tuple(steps), detail=True),
    )
    return Section("tasks", "Tasks", (_INTRODUCTION,), figures, tables, questions=states.count(OPEN))


def _standing(task: Task) -> str:
    if task.steps:
        return STEPS
    return OPEN if task.open else NOT_APPLICABLE
