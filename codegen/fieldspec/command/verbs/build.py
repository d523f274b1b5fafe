"""`fieldspec build`: writes the outputs whose inputs have changed, all or none of a device, once or with `--watch`."""

from __future__ import annotations

import argparse
import gc
import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path

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
from fieldspec.command.console.streams import print_error, print_line
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files.placement import Staging
from fieldspec.command.packages.plugins import package_hashes
from fieldspec.command.sources import spec_files


def run(arguments: argparse.Namespace) -> int:
    """Builds, or with `--check` lists what a build would change. Exit code 1 for findings and stale files.

    Raises UsageError.
    """
    if arguments.watch and arguments.check:
        raise UsageError("--check writes nothing and --watch builds: use one of them")
    if arguments.watch:
        return watch(arguments)
    return build(arguments)


def build(arguments: argparse.Namespace) -> int:
    """Builds once. Raises UsageError."""
    anew = arguments.check or arguments.no_cache
    build_request = BuildRequest(_outputs(arguments.to, anew), _devices(arguments.devices), arguments.to is not None)
    packages = package_hashes(anew)
    output_folder = Path(arguments.out)
    with Staging(output_folder, look=arguments.check) as staging:
        path, files = spec_files.of_devices(arguments.specs, frozenset(build_request.devices))
        earlier = EarlierBuild(output_folder, files, packages, trusted=not (anew or build_request.picked))
        result = build_result(build_request, path, files, earlier, None if arguments.check else staging)
        if result.findings:
            from fieldspec.command.console.terminal import print_findings

            print_findings(result.findings, "text", "")
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
        removed = before.gone(hashes | remaining_files, build_request.outputs) if can_remove else []
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
    return 1 if failed else 0


def _has_errors(result: BuildResult) -> bool:
    """Whether a build has found any error. The module of findings is not imported where there is none."""
    if not result.findings:
        return False
    from fieldspec.language.diagnostics import has_errors

    return has_errors(result.findings)


def _outputs(text: str | None, anew: bool) -> tuple[str, ...]:
    from fieldspec.command.packages.plugin_loading import load_outputs
    from fieldspec.targets import OUTPUTS

    load_outputs(anew)
    if text is None:
        return tuple(OUTPUTS)
    names = tuple(name for name in text.split(",") if name)
    for name in names:
        if name not in OUTPUTS:
            raise unknown("output", name, OUTPUTS)
    if not names:
        raise UsageError(f"--to names no output; the outputs are {', '.join(OUTPUTS)}")
    return names


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
    """Builds, then waits for a spec to change, until interrupted. Raises UsageError if the first build does."""
    path = spec_files.folder(arguments.specs)
    built: State | None = None
    while True:
        now = _state(path)
        if now != built:
            time.sleep(SETTLED)
            if _state(path) == now:
                _build(arguments, first=built is None)
                built = now
        else:
            time.sleep(PAUSE)


def _build(arguments: argparse.Namespace, first: bool) -> None:
    """Builds once. Wrong use may be corrected while we wait, except in the first build."""
    start = time.perf_counter()
    try:
        code = build(arguments)
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
    """The time and size of every spec file."""
    state = {}
    for folder, _, names in os.walk(path):
        for name in names:
            if name.endswith(".yaml") and not name.startswith("."):
                try:
                    status = os.stat(os.path.join(folder, name))
                except OSError:
                    continue  # it has gone in the meantime
                state[os.path.join(folder, name)] = status.st_mtime_ns, status.st_size
    return state
