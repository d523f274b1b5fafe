"""`fieldspec build`: writes the outputs whose inputs have changed, all or none of a device, once or with `--watch`."""

from __future__ import annotations

import argparse
import gc
import os
import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from fieldspec.command.builds.building import build_result
from fieldspec.command.builds.freshness import (
    MANIFEST,
    BuildRequest,
    BuildResult,
    EarlierBuild,
    Hashes,
    digest,
    read_manifest,
)
from fieldspec.command.builds.overviews import stage_overviews
from fieldspec.command.console.streams import print_error, print_line, print_note
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files.placement import Staging
from fieldspec.command.packages.plugins import package_hashes
from fieldspec.command.sources import spec_files
from fieldspec.command.sources.project_choices import project_choices
from fieldspec.foundation.classes import replace
from fieldspec.language.model.choice import PROJECT_FILE
from fieldspec.language.reading.findings import PROTOCOLS

if TYPE_CHECKING:
    from fieldspec.command.builds.remembered_outputs import BuildMemory
    from fieldspec.language.diagnostics import Diagnostic


def run(arguments: argparse.Namespace) -> int:
    """Builds, or with `--check` lists what a build would change. Exit code 1 for findings and stale files.

    Raises UsageError.
    """
    if arguments.watch and arguments.check:
        raise UsageError("--check writes nothing and --watch builds: use one of them")
    if arguments.watch:
        return watch(arguments)
    return build(arguments)


def build(arguments: argparse.Namespace, memory: BuildMemory | None = None) -> int:
    """Builds once, into each folder that the project file names, with the `memory` of the last time.

    Raises UsageError.
    """
    anew = arguments.check or arguments.no_cache
    all_outputs, requested_outputs = _outputs(arguments.to, anew)
    requested = _devices(arguments.devices)
    path, files = spec_files.of_devices(arguments.specs, frozenset(requested))
    if memory is not None:
        memory.reading.forget_others(files)
    project = project_choices(path)
    if findings := project.unknown_names(spec_files.devices(path)):
        _print_findings(findings)
        print_error("nothing is written")
        return 1
    folders: dict[str, list[str]] = {}
    for device in sorted(requested) or spec_files.devices(path):
        folders.setdefault(arguments.out or project.folder(device), []).append(device)
    codes = []
    for folder, devices in folders.items():
        versions = {device: requested[device] for device in devices if requested}
        outputs = requested_outputs or all_outputs
        request = BuildRequest(outputs, versions, bool(requested_outputs), project, adds=not arguments.out)
        chosen = {name for device in devices for name in request.outputs_of(device)}
        request = replace(request, outputs=tuple(name for name in request.outputs if name in chosen))
        among = {name: data for name, data in files.items() if name.partition("/")[0] in {*devices, PROTOCOLS}}
        codes.append(_build_into(Path(folder), request, (path, among), arguments, outputs, memory))
    return max(codes)


def _build_into(
    output_folder: Path,
    build_request: BuildRequest,
    specs: tuple[str, Mapping[str, bytes]],
    arguments: argparse.Namespace,
    replaced_outputs: Sequence[str],
    memory: BuildMemory | None,
) -> int:
    """Builds once into one folder, from the folder of the specs and their files. Raises UsageError.

    Files of `replaced_outputs` that are no longer made are removed.
    """
    path, files = specs
    anew = arguments.check or arguments.no_cache
    packages = package_hashes(anew)
    with Staging(output_folder, look=arguments.check) as staging:
        trusted = not (anew or build_request.picked)
        earlier = EarlierBuild(output_folder, files, packages, trusted, build_request.project.data)
        result = build_result(build_request, path, files, earlier, None if arguments.check else staging, memory)
        if result.findings:
            _print_findings(result.findings)
        failed = bool(result.broken) or _has_errors(result)
        before = read_manifest(output_folder)
        if result.broken and not (result.devices or before.remaining(build_request, result)):
            print_error("nothing is written")
            return 1
        hashes = _hashes(build_request, result)
        hashes |= stage_overviews(build_request, result, before, earlier, None if arguments.check else staging)
        remaining_files = before.remaining(build_request, result)
        # An older manifest does not say whose the files are.
        can_remove = build_request.whole and bool(before.owned or not result.broken)
        removed = before.gone(hashes | remaining_files, replaced_outputs) if can_remove else []
        now = before.renewed(build_request, result, hashes, removed, packages).text()
        stale = sorted([*result.stale, *([MANIFEST] if earlier.hash_of(MANIFEST) != digest(now) else [])])
        if arguments.check:
            reasons = {path: before.reason(path, result, earlier, packages) for path in stale}
            reasons |= dict.fromkeys(remaining_files, "its spec has errors")
            return _report(sorted(reasons.items()), removed, staging.unfinished, failed)
        if stale or removed:
            staging.write(MANIFEST, now)
            staging.place(stale, removed)
        if not build_request.picked:
            earlier.keep(result, build_request.whole)
    if result.broken:
        print_error(
            f"the files of {', '.join(result.broken)} stay as they are"
            + (", and the manifest lists them as stale" if remaining_files else "")
        )
    print_line(f"{len(hashes)} files, {len(result.stale)} written, {len(removed)} removed")
    if hashes and not result.stale and not removed and not arguments.watch:
        folders = ", ".join(sorted({path.partition("/")[0] for path in hashes if "/" in path}))
        print_note(f"{output_folder} is up to date: {folders}")
    return 1 if failed else 0


def _print_findings(findings: list[Diagnostic]) -> None:
    from fieldspec.command.console.terminal import print_findings

    print_findings(findings, "text", "")


def _has_errors(result: BuildResult) -> bool:
    """Whether a build has found any error. The module of findings is not imported where there is none."""
    if not result.findings:
        return False
    from fieldspec.language.diagnostics import has_errors

    return has_errors(result.findings)


def _outputs(text: str | None, anew: bool) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """All outputs, and those that the option names; none where it is not given."""
    from fieldspec.command.packages.plugin_loading import load_outputs
    from fieldspec.targets import OUTPUTS

    load_outputs(anew)
    if text is None:
        return tuple(OUTPUTS), ()
    names = tuple(name for name in text.split(",") if name)
    for name in names:
        if name not in OUTPUTS:
            raise unknown("output", name, OUTPUTS)
    if not names:
        raise UsageError(f"--to names no output; the outputs are {', '.join(OUTPUTS)}")
    return tuple(OUTPUTS), names


def _devices(texts: Sequence[str]) -> dict[str, frozenset[str]]:
    """The requested versions by device; no version means all of them."""
    pairs = [spec_files.split(text) for text in texts]
    versions_of = {device: {version for name, version in pairs if name == device} for device, _ in pairs}
    return {device: frozenset() if "" in versions else frozenset(versions) for device, versions in versions_of.items()}


def _hashes(build_request: BuildRequest, result: BuildResult) -> Hashes:
    """The hashes of all files of the requested outputs, rebuilt or not. Raises UsageError for a file of two."""
    from fieldspec.command.packages.plugin_loading import refuse_same_files

    devices = {device: built.outputs for device, built in result.devices.items()}
    for name in build_request.outputs:
        owners = {"no device": result.shared, **devices}
        refuse_same_files(name, ((owner, outputs.get(name, ())) for owner, outputs in owners.items()))
    holders = [result.shared, *devices.values()]
    return {
        path: digest
        for hashes_by_output in holders
        for name in build_request.outputs
        for path, digest in hashes_by_output.get(name, {}).items()
    }


def _report(stale: Sequence[tuple[str, str]], removed: Sequence[str], unfinished: Sequence[str], failed: bool) -> int:
    for text in unfinished:
        print_line(text)
    for path, reason in stale:
        print_line(f"not fresh: {path}" + (f" ({reason})" if path != MANIFEST else ""))
    for path in removed:
        print_line(f"no longer produced: {path}")
    if not (stale or removed or unfinished or failed):
        print_line("everything is fresh")
        return 0
    print_line("build again with: fieldspec build")
    return 1


PAUSE = 0.05
"""Seconds between two looks at the files."""
SETTLED = 0.02
"""Seconds without a change after which a file counts as completely written."""

State = dict[str, tuple[int, int]]


def watch(arguments: argparse.Namespace) -> int:
    """Builds, then waits for a spec to change, until interrupted. Raises UsageError if the first build does.

    Without `--no-cache`, the process remembers what it has read.
    """
    from fieldspec.command.builds.remembered_outputs import BuildMemory

    memory = None if arguments.no_cache else BuildMemory()
    path = spec_files.folder(arguments.specs)
    built: State | None = None
    while True:
        now = _state(path)
        if now != built:
            time.sleep(SETTLED)
            if _state(path) == now:
                _build(arguments, memory, first=built is None)
                built = now
        else:
            time.sleep(PAUSE)


def _build(arguments: argparse.Namespace, memory: BuildMemory | None, first: bool) -> None:
    """Builds once. Wrong use may be corrected while we wait, except in the first build."""
    start = time.perf_counter()
    try:
        code = build(arguments, memory)
    except UsageError as error:
        if first:
            raise
        print_error(error)
        code = 2
    done = ("built", "built without what has errors", "not built")[code]
    print_line(f"{done} in {time.perf_counter() - start:.2f} s, waiting for a spec to change")
    sys.stdout.flush()
    gc.collect()  # nobody else does, and this runs for long
    if first:
        from fieldspec.targets.templates import prepare

        prepare()


def _state(path: str) -> State:
    """The time and size of every spec file, and of the project file beside them."""
    state = {}
    with suppress(OSError):
        status = os.stat(os.path.join(os.path.dirname(os.path.abspath(path)), PROJECT_FILE))
        state[PROJECT_FILE] = status.st_mtime_ns, status.st_size
    for folder, _, names in os.walk(path):
        for name in names:
            if name.endswith(".yaml") and not name.startswith("."):
                try:
                    status = os.stat(os.path.join(folder, name))
                except OSError:
                    continue  # it has gone in the meantime
                state[os.path.join(folder, name)] = status.st_mtime_ns, status.st_size
    return state
