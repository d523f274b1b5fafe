"""Facts without bytes: lookup tables, limits, tasks, notes, examples, and errata beside the facts that they correct."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import COMPUTED, INFERRED
from fieldspec.language.model.task import Task, argument_text, stated_text, value_text
from fieldspec.language.model.texts import Lookup
from fieldspec.tools.facts.row import FactRow, SharedRows, of_fact, row


def texts(layout: DeviceLayout, shared: SharedRows) -> Iterator[FactRow]:
    """The rows of tables to look up, limits, notes, examples and versions."""
    device = layout.device
    for lookup in device.lookups:
        yield from shared.rows(lookup, partial(_lookup, lookup))
    yield from _limits(device)
    for task in device.tasks:
        yield from _task(task)
    for note in device.notes:
        yield row("note", note.place.path, note.sources, name=note.name, label=note.title)
        for statement in note.statements:
            cells: FactRow = {"name": statement.subject, "ranges": statement.says, "label": statement.text}
            yield row("statement", statement.place.path, statement.sources, **cells)
    yield from _examples(layout)
    yield from _versions(device)


def _lookup(lookup: Lookup) -> Iterator[FactRow]:
    yield from of_fact("lookup", lookup)
    for number, line in enumerate(lookup.rows):
        first = line.cells[0] if line.cells else None
        cells: FactRow = {
            "name": f"{lookup.name}_{number + 1}",
            "label": " | ".join("" if cell is None else str(cell) for cell in line.cells),
            "code": first if isinstance(first, int) and not isinstance(first, bool) else None,
        }
        yield row(lookup.kind, line.place.path, line.sources or lookup.sources, **cells)


def _limits(device: Device) -> Iterator[FactRow]:
    for limit in device.limits:
        low = limit.low if limit.value is None else limit.value
        high = limit.high if limit.value is None else limit.value
        yield from of_fact(limit.kind, limit, unit=limit.unit, min=low, max=high, ranges=limit.text)


def _task(task: Task) -> Iterator[FactRow]:
    """A task, and a row for each of its steps: what is done, with what, and the value or the argument."""
    yield from of_fact("task", task, label=task.open or task.not_applicable or task.label, ranges=task.kind)
    for number, step in enumerate(task.steps):
        cells: FactRow = {
            "number": number + 1,
            "name": step.action,
            "label": step.target,
            "ranges": stated_text(step) or None,
            "position": step.timeout,
        }
        yield row("step", step.place.path, step.sources, **cells)
        arguments = {field: argument_text(name) for field, name in step.arguments.items()}
        for key, contents in (("values", step.values), ("arguments", arguments)):
            for field, content in contents.items():
                path = f"{step.place.path}/{key}/{field}"
                yield row("step_value", path, step.sources, name=field, ranges=value_text(content))


def _examples(layout: DeviceLayout) -> Iterator[FactRow]:
    for example in layout.device.examples.values():
        message = layout.messages.get(example.message)
        code = message.message.printed_code(example.direction) if message else None
        cells: FactRow = {
            "code": message.message.number if message and code is None else code,
            "bytes": len(example.frame),
            "name": example.id,
            "printed_name": example.frame.hex(" ").upper(),
            "label": example.title,
            "direction": example.direction,
        }
        if example.origin == COMPUTED:
            cells.update(provenance=COMPUTED, evidence=" ".join(example.notes))
        yield row("example", example.place.path, example.sources, **cells)


def _versions(device: Device) -> Iterator[FactRow]:
    for line in device.lines:
        if line.detected_by is not None:
            detection = line.detected_by
            cells: FactRow = {"name": detection.fact, "label": line.title}
            if detection.inferred:
                cells.update(provenance=INFERRED, evidence=detection.inferred)
            yield row("detection", f"versions/{line.name}/detected_by", detection.sources, **cells)
        for version in line.versions:
            path = f"versions/{line.name}/{version.id}"
            cells = {"name": version.id, "label": version.title}
            if version.inferred:
                cells.update(provenance=INFERRED, evidence=version.inferred)
            yield row("version", path, version.sources, **cells)


def with_errata(device: Device, rows: list[FactRow]) -> list[FactRow]:
    """The rows with every erratum at the innermost fact that it is about.

    A fact without a row, because this version does not have it, gets one of the kind `fact`.
    """
    by_path: dict[str, int] = {}
    for number, fact_row in enumerate(rows):
        by_path.setdefault(str(fact_row["path"]), number)
    for erratum in device.errata:
        path = erratum.fact
        while path and path not in by_path:
            path = path.rpartition("/")[0]
        if path not in by_path:
            path = erratum.fact
            by_path[path] = len(rows)
            rows.append(row("fact", path, erratum.sources, name=path.rpartition("/")[2]))
        fact_row = rows[by_path[path]]
        ids, before = fact_row["errata"], fact_row["printed"]
        assert isinstance(ids, list)
        added: FactRow = {"errata": [*ids, erratum.id]}
        if erratum.printed:
            added["printed"] = {**(before if isinstance(before, dict) else {}), **erratum.printed}
        rows[by_path[path]] = {**fact_row, **added}  # other versions may share the row
    return rows
