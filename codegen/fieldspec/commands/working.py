"""Checks devices and makes their outputs, on all processors where that is worth it.

A process is forked with the project that is read already, and sends back findings and files.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from fieldspec import pipeline
from fieldspec.audit.manual_index import ManualIndex
from fieldspec.classes import dataclass, replace
from fieldspec.diagnostics import Diagnostic, has_errors
from fieldspec.proofs.running import outcome
from fieldspec.reading.project import DeviceSpec, Project

DOCUMENTATION = "docs"
"""The output that audits are a part of, where all versions of a device are built."""

WORTH_IT = 200_000
"""Bytes of specs that take longer than starting processes."""


@dataclass(frozen=True, slots=True)
class Task:
    """A device of which some versions get outputs, all where none is named, and whether it is checked first.

    `manual` is the index of its manual, for its audit, which is a part of its documentation.
    """

    device: str
    versions: frozenset[str]
    check: bool
    outputs: tuple[str, ...]
    manual: ManualIndex | None = None


@dataclass(frozen=True, slots=True)
class Done:
    """What is found in a device, the identities of its versions, and its files by output; nothing after errors."""

    device: str
    found: list[Diagnostic]
    identities: dict[str, str]
    outputs: dict[str, dict[str, bytes]]

    @property
    def files(self) -> dict[str, bytes]:
        """All files by path."""
        return {path: content for held in self.outputs.values() for path, content in held.items()}


def carried_out(project: Project, tasks: Sequence[Task], size: int) -> list[Done]:
    """The results of tasks in any order. `size` is that of the specs, in bytes."""
    tasks = sorted(tasks, key=lambda task: -_work(project.devices[task.device]))  # who is left alone has a small one
    processes = min(_processors(), sum(len(task.outputs) or 1 for task in tasks))
    if processes < 2 or size < WORTH_IT or sys.platform != "linux":
        return [carry_out(project, task) for task in tasks]
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    try:
        pool = ProcessPoolExecutor(processes, get_context("fork"), _start, (project,))
    except OSError:  # the system has no semaphores for us
        return [carry_out(project, task) for task in tasks]
    with pool:
        if len(tasks) >= processes:
            return list(pool.map(_carry_out, tasks))
        checked = list(pool.map(_carry_out, [replace(task, outputs=()) for task in tasks]))
        if any(has_errors(done.found) for done in checked):
            return checked
        single = [replace(task, check=False, outputs=(name,)) for task in tasks for name in task.outputs]
        parts = list(pool.map(_carry_out, single))
    return [_joined(done, [part for part in parts if part.device == done.device]) for done in checked]


def _work(spec: DeviceSpec) -> int:
    """About how much there is to do for a device."""
    return len(spec.files) * len(spec.versions())


def _joined(done: Done, parts: list[Done]) -> Done:
    found, identities, outputs = list(done.found), dict(done.identities), dict(done.outputs)
    for part in parts:
        found += part.found
        identities |= part.identities
        outputs |= part.outputs
    return Done(done.device, found, identities, outputs)


def _processors() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def carry_out(project: Project, task: Task) -> Done:
    """The result of one task."""
    spec = project.devices[task.device]
    ran = outcome(spec) if task.check else None
    found = ran.findings if ran is not None else []
    if has_errors(found) or not task.outputs:
        return Done(task.device, found, {}, {})
    layouts = [laid for laid in pipeline.layouts(spec) if not task.versions or laid.device.version in task.versions]
    found += pipeline.refusals(layouts, task.outputs)
    if has_errors(found):
        return Done(task.device, found, {}, {})
    identities = {
        f"{spec.id}@{version}": laid.identity for laid in layouts for version in (laid.device.version, *laid.twins)
    }
    outputs = {name: pipeline.output(name, layouts) for name in task.outputs}
    if DOCUMENTATION in outputs and not task.versions:
        from fieldspec.render.audit_pages import pages

        outputs[DOCUMENTATION] |= pages(spec, layouts, task.manual, outputs[DOCUMENTATION], ran)
    return Done(task.device, found, identities, outputs)


_project: Project


def _start(project: Project) -> None:
    global _project
    _project = project


def _carry_out(task: Task) -> Done:
    return carry_out(_project, task)
