"""The facts that are not on the wire by themselves: look-up tables, limits, tasks, notes, examples, versions."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from fieldspec.facts.row import Kept, Row, of_fact, row
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.device import Device
from fieldspec.model.lookup import Lookup
from fieldspec.model.provenance import COMPUTED, INFERRED
from fieldspec.model.task import Task, argument_text, value_text


def texts(layout: DeviceLayout, kept: Kept) -> Iterator[Row]:
    """The rows of look-up tables, limits, tasks, notes, examples and versions."""
    device = layout.device
    for lookup in device.lookups:
        yield from kept.rows(lookup, partial(_lookup, lookup))
    yield from _limits(device)
    for task in device.tasks:
        yield from _task(task)
    for note in device.notes:
        yield row("note", note.place.path, note.sources, name=note.name, label=note.title)
        for one in note.statements:
            yield row("statement", one.place.path, one.sources, name=one.subject, ranges=one.says, label=one.text)
    yield from _examples(layout)
    yield from _versions(device)


def _lookup(lookup: Lookup) -> Iterator[Row]:
    yield from of_fact("lookup", lookup)
    for number, line in enumerate(lookup.rows):
        first = line.cells[0] if line.cells else None
        cells: Row = {
            "name": f"{lookup.name}_{number + 1}",
            "label": " | ".join("" if cell is None else str(cell) for cell in line.cells),
            "code": first if isinstance(first, int) and not isinstance(first, bool) else None,
        }
        yield row(lookup.kind, line.place.path, line.sources or lookup.sources, **cells)


def _limits(device: Device) -> Iterator[Row]:
    for limit in device.limits:
        low = limit.low if limit.value is None else limit.value
        high = limit.high if limit.value is None else limit.value
        yield from of_fact(limit.kind, limit, unit=limit.unit, min=low, max=high, ranges=limit.text)


def _task(task: Task) -> Iterator[Row]:
    """A task, and a row for each of its steps: what is done, with what, and the value or the argument."""
    yield from of_fact("task", task, label=task.open or task.not_applicable or task.label, ranges=task.kind)
    for number, step in enumerate(task.steps):
        value = argument_text(step.argument) if step.argument else step.value
        cells: Row = {
            "number": number + 1,
            "name": step.action,
            "label": step.target,
            "ranges": None if value is None else value_text(value),
            "position": step.timeout,
        }
        yield row("step", step.place.path, step.sources, **cells)
        for field, content in (
            *step.values.items(),
            *((key, argument_text(name)) for key, name in step.arguments.items()),
        ):
            yield row("step_value", f"{step.place.path}/{field}", step.sources, name=field, ranges=value_text(content))


def _examples(layout: DeviceLayout) -> Iterator[Row]:
    for example in layout.device.examples.values():
        laid = layout.messages.get(example.message)
        code = laid.message.code if laid else None
        cells: Row = {
            "code": laid.message.number if laid and code is None else code,
            "bytes": len(example.frame),
            "name": example.id,
            "printed_name": example.frame.hex(" ").upper(),
            "label": example.title,
            "direction": example.direction,
        }
        if example.origin == COMPUTED:
            cells.update(provenance=COMPUTED, evidence=" ".join(example.notes))
        yield row("example", example.place.path, example.sources, **cells)


def _versions(device: Device) -> Iterator[Row]:
    for line in device.lines:
        for version in line.versions:
            path = f"versions/{line.name}/{version.id}"
            cells: Row = {"name": version.id, "label": version.title}
            if version.inferred:
                cells.update(provenance=INFERRED, evidence=version.inferred)
            yield row("version", path, version.sources, **cells)
