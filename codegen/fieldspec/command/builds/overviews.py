"""The output files that summarize all devices, such as the index of the documentation."""

from __future__ import annotations

import json

from fieldspec.command.builds.freshness import (
    LARGEST_OUTPUT,
    BuildRequest,
    BuildResult,
    EarlierBuild,
    Hashes,
    Manifest,
    digest,
)
from fieldspec.command.files.placement import Staging
from fieldspec.command.files.regular_file import content

_INPUT = ""
"""The key of the hash of what the files were made of, beside the hashes of the files."""


def stage_overviews(
    build_request: BuildRequest, result: BuildResult, before: Manifest, earlier: EarlierBuild, staging: Staging | None
) -> Hashes:
    """The hashes of these files. Those that differ from the files in place are staged and added to the stale ones.

    Devices outside of this build are taken from the manifest, if their files are unchanged. Without `staging`, nothing
    is staged; files that are made of stale ones are then taken to be as they are. Raises UsageError.
    """
    hashes: Hashes = {}
    for name in build_request.outputs:
        inputs = _inputs(name, build_request, result, before, earlier)
        now = digest(json.dumps(sorted(inputs.items())).encode())
        recorded = dict(earlier.shared.get(_record(name), {}))
        if recorded.pop(_INPUT, None) != now or earlier.unchanged(recorded) is None:
            recorded = _staged(name, inputs, result, before, earlier, staging)
        result.shared[_record(name)] = {_INPUT: now, **recorded}
        hashes |= recorded
    return hashes


def _record(name: str) -> str:
    """The name of the record of an output's overview, next to the records of outputs."""
    return f"{name} overview"


def _inputs(
    name: str, build_request: BuildRequest, result: BuildResult, before: Manifest, earlier: EarlierBuild
) -> Hashes:
    """The hashes of the files of an output, of all devices."""
    earlier_files = before.remaining(build_request, result) if build_request.whole else before.files
    inputs = {
        path: expected
        for path, expected in earlier_files.items()
        if path.startswith(f"{name}/") and earlier.hash_of(path) == expected and not _is_on_top(name, path)
    }
    for device, built in result.devices.items():
        inputs = {path: expected for path, expected in inputs.items() if not path.startswith(f"{name}/{device}/")}
        inputs |= built.outputs.get(name, {})
    return inputs


def _is_on_top(name: str, path: str) -> bool:
    return path.rpartition("/")[0] == name


def _staged(
    name: str,
    inputs: Hashes,
    result: BuildResult,
    before: Manifest,
    earlier: EarlierBuild,
    staging: Staging | None,
) -> Hashes:
    from fieldspec.command import pipeline

    stale = frozenset(result.stale)
    if staging is None and not stale.isdisjoint(inputs):
        shared = result.shared.get(name, {})
        return {
            path: expected
            for path, expected in before.files.items()
            if _is_on_top(name, path) and path not in shared and path not in inputs
        }

    def current(path: str) -> bytes:
        if staging is not None and path in stale:
            return staging.staged(path)
        return content(earlier.out / path, LARGEST_OUTPUT)

    contents = pipeline.overview(name, inputs, current)
    hashes = {path: digest(data) for path, data in contents.items()}
    for path, data in contents.items():
        if earlier.hash_of(path) != hashes[path]:
            result.stale.append(path)
            if staging is not None:
                staging.write(path, data)
    return hashes
