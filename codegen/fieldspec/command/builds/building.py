"""Plans a build and carries it out: of every device only the outputs that are out of date."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from fieldspec.command.builds.freshness import BuildRequest, BuildResult, Built, EarlierBuild, Hashes, devices_in
from fieldspec.command.console.streams import print_error
from fieldspec.command.console.usage import UsageError
from fieldspec.command.sources import spec_files
from fieldspec.command.sources.spec_files import INDEX
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.source import Refused
from fieldspec.language.model.choice import PROJECT_FILE

if TYPE_CHECKING:
    from fieldspec.command.builds.remembered_outputs import BuildMemory
    from fieldspec.command.files.placement import Staging
    from fieldspec.language.diagnostics import Diagnostic
    from fieldspec.tools.audit.manual_lines import ManualIndex


TEMPLATES = "templates"
"""The kind of entries of the cache that are compiled templates."""


@dataclass(frozen=True, slots=True)
class _Plan:
    """The plan of a build for a device: whether it is checked, which outputs are rebuilt, and which are reused."""

    check: bool
    outputs: tuple[str, ...]
    reused: dict[str, Hashes]


def build_result(
    build_request: BuildRequest,
    path: str,
    files: Mapping[str, bytes],
    earlier: EarlierBuild,
    staging: Staging | None = None,
    memory: BuildMemory | None = None,
) -> BuildResult:
    """Builds what is out of date, and nothing of devices with errors.

    Files that differ from the ones in place are written to `staging`. Repeated reads use the `memory` of the last read.
    Raises UsageError.
    """
    plans = {
        device: _plan(device, build_request, earlier) for device in sorted(build_request.devices) or devices_in(files)
    }
    reusable = {name: earlier.unchanged(earlier.shared.get(name)) for name in build_request.outputs}
    shared = {name: hashes for name, hashes in reusable.items() if hashes is not None}
    stale = frozenset(device for device, plan in plans.items() if plan.check or plan.outputs)
    everything = build_request.whole and not earlier.confined()
    if not stale and not everything and len(shared) == len(build_request.outputs):
        return BuildResult([], {device: earlier.devices[device] for device in plans}, shared, [], True)
    return _build_stale(
        build_request, plans, shared, frozenset() if everything else stale, path, files, earlier, staging, memory
    )


def _plan(device: str, build_request: BuildRequest, earlier: EarlierBuild) -> _Plan:
    outputs = build_request.outputs_of(device)
    if earlier.changed(device):
        return _Plan(True, outputs, {})
    before = earlier.devices[device]
    checked = {name: earlier.unchanged(files) for name, files in before.outputs.items()}
    reused = {name: files for name, files in checked.items() if files is not None}
    return _Plan(before.warned, tuple(name for name in outputs if name not in reused), reused)


def _build_stale(
    build_request: BuildRequest,
    plans: Mapping[str, _Plan],
    shared: Mapping[str, Hashes],
    only: frozenset[str],
    path: str,
    files: Mapping[str, bytes],
    earlier: EarlierBuild,
    staging: Staging | None,
    memory: BuildMemory | None,
) -> BuildResult:
    """Reads the specs, of all devices or of `only` some, and carries out the plans."""
    from fieldspec.command import pipeline
    from fieldspec.command.builds.workers import DOCUMENTATION, Task, Work, stage_changes, task_results
    from fieldspec.command.files import cache_folder
    from fieldspec.command.packages.plugin_loading import load_checks
    from fieldspec.command.sources import specs
    from fieldspec.language.diagnostics import has_errors, in_order
    from fieldspec.language.reading.project import read
    from fieldspec.targets import templates

    load_checks()
    if earlier.trusted and cache_folder.is_usable(TEMPLATES):
        templates.use_cache(partial(cache_folder.cached, TEMPLATES), partial(cache_folder.store, TEMPLATES))
    project = read(
        files, only, memory=memory.reading if memory is not None else None
    )  # without the folder, which outputs must not depend on
    refused = set(project.broken)
    misnamed = []

    tasks = []
    for spec in project.devices.values():
        plan = plans.get(spec.id, _Plan(True, (), {}))
        versions = frozenset(specs.picked(spec, version) for version in build_request.devices.get(spec.id, ()))
        if plan.check or plan.outputs:
            if unknown_parts := build_request.project.unknown_parts(spec):
                misnamed += unknown_parts
                refused.add(spec.id)
            manual = None
            if DOCUMENTATION in plan.outputs:
                try:
                    manual = _manual(spec.id, files)
                except UsageError as error:  # which is about this device alone
                    print_error(error)
                    refused.add(spec.id)
            wanted_outputs = (plan.outputs, build_request.outputs_of(spec.id)) if spec.id not in refused else ((), ())
            tasks.append(
                Task(
                    spec.id,
                    versions,
                    plan.check,
                    *wanted_outputs,
                    build_request.required,
                    manual,
                    build_request.project.choice(spec.id),
                    # A process that remembers keeps spellings itself.
                    earlier.key(spec.id, spec.files) if memory is None else "",
                    adds=build_request.adds,
                )
            )
    lacking = [name for name in build_request.outputs if name not in shared]
    common = {name: pipeline.shared(name) for name in lacking}  # before processes are forked, which then know them
    work = Work(project, earlier.out, staging, memory=memory)
    done = {result.device: result for result in task_results(work, tasks, sum(map(len, files.values())))}
    findings = in_order([*project.findings, *(finding for result in done.values() for finding in result.findings)])
    located = [*misnamed, *_from_here(findings, spec_files.relative_path(path), spec_files.origins(files))]
    refused |= {device for device, result in done.items() if has_errors(result.findings)}
    broken = tuple(device for device in plans if device in refused)
    if len(broken) == len(plans):
        return BuildResult(located, {}, {}, [], False, broken)
    stale = [path for device, result in done.items() if device not in refused for path in result.stale]
    hashes = {name: stage_changes(work, contents, stale) for name, contents in common.items()}
    marked = {finding.span.file.path for finding in findings}
    devices = {}
    for device, plan in plans.items():
        if device in refused:
            continue
        if device not in done:
            devices[device] = earlier.devices[device]
            continue
        files_read = project.devices[device].files | ({f"{device}/{INDEX}", PROJECT_FILE} & earlier.now.keys())
        result = done[device]
        # Warnings of outputs that were not asked for this time come again when they are.
        was_warned = bool(plan.reused.keys() - set(build_request.outputs)) and earlier.devices[device].warned
        devices[device] = Built(
            {file: earlier.now[file] for file in sorted(files_read)},
            result.identities or earlier.devices[device].identities,
            was_warned or not marked.isdisjoint(files_read),
            {**plan.reused, **result.hashes},
        )
    return BuildResult(located, devices, {**shared, **hashes}, stale, not findings, broken)


def _from_here(findings: Iterable[Diagnostic], folder: str, origins: Mapping[str, str]) -> list[Diagnostic]:
    """Findings that show the files by the paths by which they are found from here."""
    from fieldspec.foundation.source import SourceFile, Span

    files: dict[str, SourceFile] = {}

    def moved(span: Span) -> Span:
        file = span.file
        if file.path not in files:
            path = origins.get(file.path) or (f"{folder}/{file.path}" if folder else file.path)
            files[file.path] = SourceFile(path, file.text)
        return Span(files[file.path], span.start, span.end)

    return [
        replace(
            finding,
            span=moved(finding.span),
            labels=tuple(replace(label, span=moved(label.span)) for label in finding.labels),
        )
        for finding in findings
    ]


def _manual(device: str, files: Mapping[str, bytes]) -> ManualIndex | None:
    """The index of a device's manual, where there is one among its files."""
    from fieldspec.tools.audit.manual_lines import ManualError, parsed

    path = f"{device}/{INDEX}"
    if path not in files:
        return None
    if isinstance(refused := files[path], Refused):
        raise UsageError(f"cannot read {path}: {refused.decode()}; {refused.help}")
    try:
        return parsed(path, files[path].decode("utf-8").replace("\r\n", "\n"))
    except UnicodeDecodeError:
        raise UsageError(f"cannot read {path}: it is not UTF-8") from None
    except ManualError as error:
        raise UsageError(f"{path} {error}") from None
