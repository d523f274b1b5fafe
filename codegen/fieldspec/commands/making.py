"""What a build makes: of every device what is not fresh any more, and nothing else."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from fieldspec.classes import dataclass, replace
from fieldspec.commands import sources
from fieldspec.commands.fresh import Built, Earlier, Hashes, devices_in
from fieldspec.commands.sources import INDEX
from fieldspec.commands.usage import UsageError
from fieldspec.source import Refused

if TYPE_CHECKING:
    from fieldspec.audit.manual_lines import ManualIndex
    from fieldspec.commands.placing import Beside
    from fieldspec.diagnostics import Diagnostic


TEMPLATES = "templates"
"""The kind of entries of the cache that are compiled templates."""


@dataclass(frozen=True, slots=True)
class BuildRequest:
    """What is to be built: outputs, and devices with their versions, no version for all; no device for all."""

    outputs: tuple[str, ...]
    devices: dict[str, frozenset[str]]

    @property
    def whole(self) -> bool:
        """Whether all devices are built, so that the files of others can be removed."""
        return not self.devices

    @property
    def picked(self) -> bool:
        """Whether devices are built at some of their versions only."""
        return any(self.devices.values())


@dataclass(frozen=True, slots=True)
class BuildResult:
    """What a build has found, the devices as they are now, and the files that were not as they should be.

    `shared` are the files that belong to no device. `quiet` says that nothing at all was found in the files.
    """

    findings: list[Diagnostic]
    devices: dict[str, Built]
    shared: dict[str, Hashes]
    stale: list[str]
    quiet: bool


@dataclass(frozen=True, slots=True)
class _Plan:
    """What is done for a device: whether it is checked, which outputs are made, and which are kept as they are."""

    check: bool
    outputs: tuple[str, ...]
    reused: dict[str, Hashes]


def build_result(
    wanted: BuildRequest, path: str, files: Mapping[str, bytes], earlier: Earlier, beside: Beside | None = None
) -> BuildResult:
    """Makes what must be made of some spec files; nothing where something is found that stops a build.

    What is not the same as what lies there is written `beside` it.
    """
    plans = {device: _plan(device, wanted, earlier) for device in sorted(wanted.devices) or devices_in(files)}
    kept = {name: earlier.unspoilt(earlier.shared.get(name)) for name in wanted.outputs}
    shared = {name: held for name, held in kept.items() if held is not None}
    stale = frozenset(device for device, plan in plans.items() if plan.check or plan.outputs)
    everything = wanted.whole and not earlier.confined()
    if not stale and not everything and len(shared) == len(wanted.outputs):
        return BuildResult([], {device: earlier.devices[device] for device in plans}, shared, [], True)
    return _anew(wanted, plans, shared, frozenset() if everything else stale, path, files, earlier, beside)


def _plan(device: str, wanted: BuildRequest, earlier: Earlier) -> _Plan:
    if earlier.changed(device):
        return _Plan(True, wanted.outputs, {})
    before = earlier.devices[device]
    held = {name: earlier.unspoilt(files) for name, files in before.outputs.items()}
    kept = {name: files for name, files in held.items() if files is not None}
    return _Plan(before.warned, tuple(name for name in wanted.outputs if name not in kept), kept)


def _anew(
    wanted: BuildRequest,
    plans: Mapping[str, _Plan],
    shared: Mapping[str, Hashes],
    only: frozenset[str],
    path: str,
    files: Mapping[str, bytes],
    earlier: Earlier,
    beside: Beside | None,
) -> BuildResult:
    """Reads the specs, of all devices or of `only` some, and makes what the plans say."""
    from fieldspec import pipeline
    from fieldspec.backends import templates
    from fieldspec.commands import caching, specs
    from fieldspec.commands.working import DOCUMENTATION, Task, Work, carried_out, settled
    from fieldspec.diagnostics import has_errors, in_order
    from fieldspec.reading.project import read

    if earlier.trusted:
        templates.use_cache(partial(caching.cached, TEMPLATES), partial(caching.store, TEMPLATES))
    project = read(files, only)  # without the folder, which outputs must not depend on
    outputs = not has_errors(project.findings)
    tasks = []
    for spec in project.devices.values():
        plan = plans.get(spec.id, _Plan(True, (), {}))
        versions = frozenset(specs.picked(spec, version) for version in wanted.devices.get(spec.id, ()))
        if plan.check or plan.outputs:
            manual = _manual(spec.id, files) if DOCUMENTATION in plan.outputs else None
            tasks.append(Task(spec.id, versions, plan.check, plan.outputs if outputs else (), manual))
    lacking = [name for name in wanted.outputs if name not in shared] if outputs else []
    common = {name: pipeline.shared(name) for name in lacking}  # before processes are forked, which then know them
    work = Work(project, earlier.out, beside)
    done = {one.device: one for one in carried_out(work, tasks, sum(map(len, files.values())))}
    found = in_order([*project.findings, *(finding for one in done.values() for finding in one.findings)])
    shown = _from_here(found, sources.relative_path(path))
    if has_errors(found):
        return BuildResult(shown, {}, {}, [], False)
    stale = [path for one in done.values() for path in one.stale]
    hashes = {name: settled(work, held, stale) for name, held in common.items()}
    marked = {finding.span.file.path for finding in found}
    devices = {}
    for device, plan in plans.items():
        if device not in done:
            devices[device] = earlier.devices[device]
            continue
        files_read = project.devices[device].files | ({f"{device}/{INDEX}"} & files.keys())
        one = done[device]
        devices[device] = Built(
            {file: earlier.now[file] for file in sorted(files_read)},
            one.identities or earlier.devices[device].identities,
            not marked.isdisjoint(files_read),
            {**plan.reused, **one.hashes},
        )
    return BuildResult(shown, devices, {**shared, **hashes}, stale, not found)


def _from_here(found: Iterable[Diagnostic], folder: str) -> list[Diagnostic]:
    """Findings that show the files below the folder of the specs as they are found from here."""
    from fieldspec.source import SourceFile, Span

    files: dict[str, SourceFile] = {}

    def moved(span: Span) -> Span:
        file = span.file
        if file.path not in files:
            files[file.path] = SourceFile(f"{folder}/{file.path}" if folder else file.path, file.text)
        return Span(files[file.path], span.start, span.end)

    return [
        replace(one, span=moved(one.span), labels=tuple(replace(label, span=moved(label.span)) for label in one.labels))
        for one in found
    ]


def _manual(device: str, files: Mapping[str, bytes]) -> ManualIndex | None:
    """The index of a device's manual, where there is one among its files."""
    from fieldspec.audit.manual_lines import ManualError, parsed

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
