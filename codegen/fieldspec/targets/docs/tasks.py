"""What people do with the device: a table of all tasks, and the steps of each."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.operand import Operands
from fieldspec.language.model.task import Step, Task, argument_text, stated_text, value_text
from fieldspec.targets.docs.context import Context, cited, fact_row, sources
from fieldspec.targets.docs.document import (
    Block,
    Facts,
    Line,
    Paragraph,
    Piece,
    Section,
    TableColumn,
    TableRow,
    cell,
    code,
    joined,
    styled,
    table,
    text_piece,
)
from fieldspec.targets.docs.sources import reasons

OVERVIEW = (
    TableColumn("Task", unbroken=True),
    TableColumn("How", "wide", unbroken=True),
    TableColumn("Source", "source"),
)
STEPS = (
    TableColumn("Step", "number", unbroken=True),
    TableColumn("Do", unbroken=True),
    TableColumn("With", unbroken=True),
    TableColumn("Value"),
    TableColumn("At most"),
    TableColumn("Meaning", "wide"),
    TableColumn("Source", "source"),
)
INTRODUCTION = (
    "The steps of each task, as the manual prints them. A task without steps states why the device has none, or "
    "which question the manual leaves open. Names in angle brackets are arguments of the task."
)


def tasks(context: Context) -> Section:
    """The section of all tasks of the device."""
    all_tasks = context.device.tasks
    if not all_tasks:
        return Section("tasks", (text_piece("Tasks"),))
    operands = Operands(context.device)
    overview = table("Tasks", OVERVIEW, [_overview(context, task) for task in all_tasks])
    inner = tuple(_task(context, task, operands) for task in all_tasks if task.steps)
    return Section("tasks", (text_piece("Tasks"),), (Paragraph((text_piece(INTRODUCTION),)), overview), inner)


def _overview(context: Context, task: Task) -> TableRow:
    path = task.place.path
    if task.steps:
        ways: Line = (text_piece(f"{len(task.steps)} steps" if len(task.steps) > 1 else "1 step", f"#{path}"),)
        if task.messages:
            ways = (*ways, text_piece(" with "), *joined((code(name, f"#messages/{name}"),) for name in task.messages))
        return TableRow((cell(code(task.name)), cell(ways), sources(task)))
    mark = styled("open question", "open") if task.open else styled("not applicable", "badge")
    text: Line = (mark, text_piece(f" {task.open or task.not_applicable}"))
    return fact_row(task, cell(code(task.name)), cell(text, *context.about(task)))


def _task(context: Context, task: Task, operands: Operands) -> Section:
    blocks: list[Block] = [Paragraph(line) for line in context.about(task)]
    facts: list[tuple[str, tuple[Line, ...]]] = []
    if task.messages:
        facts.append(("With", (joined((code(name, f"#messages/{name}"),) for name in task.messages),)))
    if task.direction:
        facts.append(("Direction", ((text_piece(task.direction),),)))
    if task.halt:
        facts.append(("Halt", ((text_piece("leaves the axis free for the next command"),),)))
    if facts:
        blocks.append(Facts(tuple(facts)))
    rows = [_step(number, step, task, operands) for number, step in enumerate(task.steps, 1)]
    blocks.append(table(f"Steps of {task.name}", STEPS, rows))
    blocks += [Paragraph(line, "note") for line in reasons(task.inferred)]
    return Section(task.place.path, (code(task.name),), tuple(blocks))


def _step(number: int, step: Step, task: Task, operands: Operands) -> TableRow:
    values: list[Line] = []
    stated = stated_text(step)
    if stated:
        values.append((text_piece(stated) if step.argument else code(stated),))
    values += [(code(name), text_piece(" = "), code(value_text(value))) for name, value in step.values.items()]
    values += [(code(name), text_piece(f" = {argument_text(argument)}")) for name, argument in step.arguments.items()]
    return TableRow(
        (
            cell(str(number)),
            cell(step.action),
            cell(*_targets(step, task, operands)),
            cell(*values),
            cell(code(step.timeout, f"#{step.timeout}")) if step.timeout else cell(),
            cell(step.doc),
            cell(cited(step.sources)),
        )
    )


def _targets(step: Step, task: Task, operands: Operands) -> Iterator[Line]:
    """The target of a step: the role, and its fact, in each message that differs."""
    if "/" not in step.target:
        yield (text_piece(step.target),)
    targets: set[Piece] = set()
    for message in task.messages or ("",):
        for operand in operands.target(step.target, message):
            target = code(_short(operand.path, message), f"#{operand.fact.place.path}")
            if target not in targets:
                targets.add(target)
                yield (target,)


def _short(path: str, message: str) -> str:
    """The path of an operand; in a message without the message, which the task names already."""
    return path.split("/", 3)[-1].replace("/", ".") if message else path
