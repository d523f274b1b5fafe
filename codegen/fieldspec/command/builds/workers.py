"""Checks devices and builds their outputs, on all processors where that pays off.

Processes are forked after the specs are read; they send back findings and hashes, and write files themselves.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.observation import observed_layout
from fieldspec.command import pipeline
from fieldspec.command.builds import spelling_cache
from fieldspec.command.builds.freshness import Hashes, digest, file_digest
from fieldspec.command.builds.remembered_outputs import RememberedOutput
from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.placement import Staging
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, field, replace
from fieldspec.foundation.names import stem
from fieldspec.language.diagnostics import Diagnostic, has_errors
from fieldspec.language.model.choice import Choice, VersionChoice
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import Project
from fieldspec.targets import BUILT_IN, OUTPUTS
from fieldspec.targets.pieces import Pieces, using_pieces
from fieldspec.targets.usages import Spellings, using
from fieldspec.tools.proofs.running import Outcome, outcome

if TYPE_CHECKING:
    from fieldspec.command.builds.remembered_outputs import BuildMemory
    from fieldspec.tools.audit.manual_lines import ManualIndex

DOCUMENTATION = "docs"
"""The output that contains audits, where all versions of a device are built."""

WORTH_IT = 200_000
"""The least bytes of specs for which starting processes pays off."""


@dataclass(frozen=True, slots=True)
class Task:
    """A device, the versions to build (none: all), whether to check it first, and the outputs to build.

    `judged` are the outputs whose refusals are computed, including outputs that are not rebuilt. Where they are
    `required`, one that cannot express the device keeps the others from being built; else it is left out. `manual` is
    the index of its manual, for the audit in its documentation. `choice` is that of the project file; the versions are
    built instead of the chosen ones, or in addition to them if the task `adds`. `key` is that under which its spellings
    are in the cache, empty where they are not; `spellings` are the spellings of another process, and `lends` is true if
    another process needs the spellings of this task.
    """

    device: str
    versions: frozenset[str]
    check: bool
    outputs: tuple[str, ...]
    judged: tuple[str, ...] = ()
    required: bool = False
    manual: ManualIndex | None = None
    choice: Choice = Choice()
    key: str = ""
    spellings: Spellings = field(default_factory=dict)
    lends: bool = False
    adds: bool = False

    def chosen(self, output: str, layouts: Sequence[DeviceLayout]) -> list[DeviceLayout]:
        """The layouts of the versions of a device that an output has; at least that of the newest."""
        chosen = _chosen(self.choice.of(output).versions, layouts)
        return [layout for layout in layouts if layout in chosen or layout.device.version in self.versions] or [
            layouts[-1]
        ]


@dataclass(frozen=True, slots=True)
class TaskResult:
    """The findings of a device, the identities of its versions, and its files; only findings after errors.

    `hashes` has all files by output; `stale` has the paths of those that differ from the files in place. `refusals` has
    what each output cannot express, and `spellings` what another task needs.
    """

    device: str
    findings: list[Diagnostic]
    identities: Hashes
    hashes: dict[str, Hashes]
    stale: list[str]
    refusals: Mapping[str, Sequence[Diagnostic]] = field(default_factory=dict)
    spellings: Spellings = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Work:
    """What all tasks share: the project, the folder of outputs, and the staging folder, None to write nothing.

    `known` has the outcomes of checks that have run already. With a `memory`, all is built in this process.
    """

    project: Project
    out: Path
    beside: Staging | None
    known: Mapping[str, Outcome] = field(default_factory=dict)
    memory: BuildMemory | None = None


def task_results(work: Work, tasks: Sequence[Task], size: int) -> list[TaskResult]:
    """The results of tasks in any order. `size` is that of the specs, in bytes.

    Each processor takes one device at a time. Where there are more processors than devices, all devices are checked
    first, and then each processor takes outputs of a device, the documentation last, which needs the spellings of the
    others. Raises UsageError if an installed package fails.
    """
    required = {task.device: task.required for task in tasks}
    return [
        replace(
            done,
            findings=[
                *done.findings,
                *pipeline.merged_refusals(done.device, done.refusals, required[done.device]),
            ],
        )
        for done in _separate_results(work, tasks, size)
    ]


def _separate_results(work: Work, tasks: Sequence[Task], size: int) -> list[TaskResult]:
    """The results of tasks, whose findings do not include the outputs' findings."""
    devices = work.project.devices
    tasks = sorted(tasks, key=lambda task: -_size(devices[task.device]))  # the last one to finish has little to do
    processes = _processors()
    if work.memory is not None or processes < 2 or not tasks or size < WORTH_IT or sys.platform != "linux":
        return [task_result(work, task) for task in tasks]
    if len(tasks) >= processes:
        return _in_processes(work, tasks, processes)
    known = {task.device: outcome(devices[task.device]) for task in tasks if task.check}
    checked = [TaskResult(task.device, known[task.device].findings if task.check else [], {}, {}, []) for task in tasks]
    broken = {done.device for done in checked if has_errors(done.findings)}
    single = [
        replace(task, check=False, outputs=tuple(name for name in names if name in task.outputs), judged=names)
        for task in tasks
        if task.device not in broken
        for names in _families(task.judged)
    ]
    work = replace(work, known=known)
    spelling = {task.device for task in single if any(OUTPUTS[name].has_usages for name in task.outputs)}
    last = [task for task in single if DOCUMENTATION in task.outputs and task.device in spelling]
    lending = {task.device for task in last}
    first = [replace(task, lends=task.device in lending) for task in single if task not in last]
    parts = _in_processes(work, first, processes)
    lent: dict[str, Spellings] = {}
    for part in parts:
        lent.setdefault(part.device, {}).update(part.spellings)
    parts += _in_processes(work, [replace(task, spellings=lent[task.device]) for task in last], processes)
    return [_joined(done, [part for part in parts if part.device == done.device]) for done in checked]


def _in_processes(work: Work, tasks: Sequence[Task], processes: int) -> list[TaskResult]:
    if not tasks:
        return []
    from concurrent.futures import ProcessPoolExecutor
    from concurrent.futures.process import BrokenProcessPool
    from multiprocessing import get_context

    ends = [*os.pipe()]
    try:
        number = min(processes, len(tasks))
        try:
            pool = ProcessPoolExecutor(number, get_context("fork"), _start, (work, ends[0], ends[1]))
        except OSError:  # the system has no semaphores
            return [task_result(work, task) for task in tasks]
        with pool:
            try:
                return list(pool.map(_result_at_hand, tasks))
            except KeyboardInterrupt:
                os.close(ends.pop())  # ends the other processes at once
                raise
    except BrokenProcessPool:
        raise UsageError("a process of the build was killed, perhaps for want of memory; nothing was changed") from None
    finally:
        for end in ends:
            os.close(end)


def _families(names: Sequence[str]) -> list[tuple[str, ...]]:
    """The outputs that one process builds, the slowest first."""
    families: dict[str, list[str]] = {}
    for name in sorted(names, key=lambda name: name != DOCUMENTATION):
        families.setdefault(OUTPUTS[name].family or name, []).append(name)
    return [*map(tuple, families.values())]


def _size(spec: DeviceSpec) -> int:
    """An estimate of the work that a device needs."""
    return len(spec.files) * len(spec.versions())


def _joined(done: TaskResult, parts: list[TaskResult]) -> TaskResult:
    findings, identities, hashes, stale = [*done.findings], dict(done.identities), dict(done.hashes), [*done.stale]
    refusals = {name: refused for part in parts for name, refused in part.refusals.items()}
    for part in parts:
        findings += part.findings
        identities |= part.identities
        hashes |= part.hashes
        stale += part.stale
    return TaskResult(done.device, findings, identities, hashes, stale, refusals)


def _processors() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def task_result(work: Work, task: Task) -> TaskResult:
    """The result of a task."""
    spec = work.project.devices[task.device]
    ran = outcome(spec) if task.check else work.known.get(task.device)
    findings = [*ran.findings] if ran is not None and task.check else []
    if has_errors(findings) or not task.judged:
        return TaskResult(task.device, findings, {}, {}, [])
    layouts = pipeline.layouts(spec, ran)
    if task.versions and not task.adds:
        layouts = [layout for layout in layouts if layout.device.version in task.versions]
        task = replace(task, choice=Choice())
    with_blocks = [replace(layout, blocks=task.choice.blocks) for layout in layouts]
    chosen = {
        name: task.chosen(name, with_blocks if OUTPUTS[name].has_blocks else layouts)
        for name in {*task.judged, *task.outputs}
    }
    request = task.versions, task.adds, task.choice
    remembered = _remembered(work, task, request, chosen)
    if work.memory is not None:
        chosen = _observed(chosen)
    refusals = {name: OUTPUTS[name].refusals(chosen[name]) if name not in remembered else [] for name in task.judged}
    refusing = {name for name, refused in refusals.items() if has_errors(refused)}
    if (refusing and task.required) or not task.outputs:
        return TaskResult(task.device, findings, {}, {}, [], refusals)
    identities = {
        f"{spec.id}@{version}": layout.identity
        for layout in layouts
        for version in (layout.device.version, *layout.equal_versions)
    }
    hashes: dict[str, Hashes] = {}
    stale: list[str] = []
    is_documented = DOCUMENTATION in task.outputs
    spellings = {**(spelling_cache.stored(task.key) if is_documented else {}), **task.spellings}
    known = {name: {*versions} for name, versions in spellings.items()}
    pieces = Pieces() if len(layouts) > 1 else None  # versions share facts, too
    if work.memory is not None:
        pieces = work.memory.pieces
        spellings |= {name: dict(output.spellings) for name, output in remembered.items()}
    is_asked = task.key or task.lends or DOCUMENTATION in task.judged
    with using(spellings if is_asked or is_documented else None), using_pieces(pieces):
        for name in sorted(task.outputs, key=lambda name: name == DOCUMENTATION):  # the last, as it asks the others
            if name in refusing:
                hashes[name] = {}
                continue
            if name in remembered:
                hashes[name] = remembered[name].hashes
                continue
            if name == DOCUMENTATION and (task.adds or not task.versions):
                from fieldspec.command.rendering.audit_html import LINK, pages
                from fieldspec.targets.docs.backend import fact_links

                files = pipeline.output(name, chosen[name], (LINK,))
                files |= pages(spec, layouts, task.manual, fact_links(chosen[name][-1], files), ran)
            else:
                files = pipeline.output(name, chosen[name])
                files = _without_tests(name, files, task, chosen[name])
            hashes[name] = stage_changes(work, files, stale)
            if work.memory is not None and _is_observed(name) and not refusals.get(name):
                rows = dict(spellings.get(name, {}))
                work.memory.outputs.remember(spec.id, name, request, chosen[name], hashes[name], rows)
    spelling_cache.store(task.key, {name: rows for name, rows in spellings.items() if {*rows} - known.get(name, set())})
    return TaskResult(task.device, findings, identities, hashes, stale, refusals, spellings if task.lends else {})


def _is_observed(output: str) -> bool:
    """Whether an output follows from its layouts alone. The documentation asks the other outputs for code."""
    return output in BUILT_IN and output != DOCUMENTATION


def _remembered(
    work: Work, task: Task, request: object, chosen: Mapping[str, Sequence[DeviceLayout]]
) -> dict[str, RememberedOutput]:
    """The outputs of a task that would be as they are, if they were built again."""
    if work.memory is None:
        return {}
    hash_of = partial(file_digest, work.out)
    outputs = {
        name: work.memory.outputs.unchanged(task.device, name, request, chosen[name], hash_of)
        for name in task.outputs
        if _is_observed(name)
    }
    return {name: output for name, output in outputs.items() if output is not None}


def _observed(chosen: Mapping[str, list[DeviceLayout]]) -> dict[str, list[DeviceLayout]]:
    """Layouts for each output that know what it reads. Outputs of a family, which share results, share them."""
    families: dict[str, ByIdentity[DeviceLayout, DeviceLayout]] = {}
    layouts = {**chosen}
    for name in filter(_is_observed, chosen):
        of_family = families.setdefault(OUTPUTS[name].family or name, ByIdentity())
        layouts[name] = [of_family.get_or_compute(layout, observed_layout) for layout in chosen[name]]
    return layouts


def _chosen(choice: VersionChoice, layouts: Sequence[DeviceLayout]) -> list[DeviceLayout]:
    """The layouts of chosen versions. The newest version of a line is there under its own name, or equal to one."""
    newest = {line.versions[-1].id for layout in layouts[-1:] for line in layout.device.lines if line.versions}
    newest |= {layouts[-1].device.version}
    return [layout for layout in layouts if choice.includes(layout.device.version, newest)]


def _without_tests(name: str, files: dict[str, bytes], task: Task, layouts: Sequence[DeviceLayout]) -> dict[str, bytes]:
    """The files of an output without the tests of versions that are neither chosen nor named."""
    tested = {layout.device.version for layout in _chosen(task.choice.of(name).tests, layouts)} | task.versions
    without = {layout.device.version for layout in layouts} - tested
    stems = [stem(layout.device.id, version) for layout in layouts[-1:] for version in without]
    left_out = {f"{name}/{own}{ending}" for own in stems for ending in OUTPUTS[name].test_endings}
    return {path: content for path, content in files.items() if path not in left_out}


def stage_changes(work: Work, files: Mapping[str, bytes], stale: list[str]) -> Hashes:
    """The hashes of some files. Those that differ from the files in place are staged and added to `stale`."""
    hashes = {path: digest(content) for path, content in files.items()}
    for path, content in files.items():
        if file_digest(work.out, path) != hashes[path]:
            stale.append(path)
            if work.beside is not None:
                work.beside.write(path, content)
    return hashes


_work_at_hand: Work


def _start(work: Work, reading: int, writing: int) -> None:
    """Initializes a process that ends with its parent: only the parent has the writing end of the pipe."""
    import signal
    from threading import Thread

    global _work_at_hand
    _work_at_hand = work
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent gets it too
    os.close(writing)
    Thread(target=_end_with_parent, args=(reading,), daemon=True).start()


def _end_with_parent(reading: int) -> None:
    """Waits until the writing end of a pipe is closed, then ends the process."""
    os.read(reading, 1)
    os._exit(1)


def _result_at_hand(task: Task) -> TaskResult:
    return task_result(_work_at_hand, task)
