"""`fieldspec build`: writes the outputs, all or nothing, and makes only those anew whose inputs have changed."""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from fieldspec.commands import placing, sources
from fieldspec.commands.fresh import Earlier, Hashes, digest
from fieldspec.commands.making import Made, Wanted, made
from fieldspec.commands.usage import UsageError, unknown

MANIFEST = "manifest.json"


def run(arguments: argparse.Namespace) -> int:
    """Builds, or with `--check` tells what a build would change. Exit code 1 for findings and stale files."""
    if arguments.watch:
        from fieldspec.commands.watching import run as watch

        return watch(arguments)
    return build(arguments)


def build(arguments: argparse.Namespace) -> int:
    """Builds once."""
    wanted = Wanted(_outputs(arguments.to), _devices(arguments.devices))
    path, files = sources.of_devices(arguments.specs, frozenset(wanted.devices))
    out = Path(arguments.out)
    earlier = Earlier(out, files, trusted=not (arguments.check or arguments.no_cache or wanted.picked))
    result = made(wanted, path, files, earlier)
    if result.found:
        from fieldspec.commands.output import print_findings
        from fieldspec.diagnostics import has_errors

        print_findings(result.found, "text", "")
        if has_errors(result.found):
            return 1
    before = _manifest(out)
    hashes = _hashes(wanted, result)
    gone = _gone(before, hashes, wanted.outputs) if wanted.whole else []
    manifest = _renewed(before, wanted, result, hashes, gone)
    contents = {**result.contents, MANIFEST: manifest}
    stale = sorted(path for path, content in contents.items() if earlier.hash_of(path) != digest(content))
    if arguments.check:
        return _report(stale, gone)
    if stale or gone:
        placing.place(out, {path: contents[path] for path in stale}, gone)
    if not wanted.picked:
        earlier.keep(result.devices, result.shared, wanted.whole, result.quiet)
    print(f"{len(hashes)} files, {len(set(stale) - {MANIFEST})} written, {len(gone)} removed")
    return 0


def _outputs(text: str | None) -> tuple[str, ...]:
    from fieldspec.backends import OUTPUTS

    if text is None:
        return tuple(OUTPUTS)
    names = tuple(name for name in text.split(",") if name)
    for name in names:
        if name not in OUTPUTS:
            raise unknown("output", name, OUTPUTS)
    if not names:
        raise UsageError(f"--to names no output; there are {', '.join(OUTPUTS)}")
    return names


def _devices(texts: Sequence[str]) -> dict[str, frozenset[str]]:
    """The versions that are asked for, by device; none where all are, as a device without a version asks for them."""
    pairs = [sources.split(text) for text in texts]
    named = {device: {version for name, version in pairs if name == device} for device, _ in pairs}
    return {device: frozenset() if "" in versions else frozenset(versions) for device, versions in named.items()}


def _hashes(wanted: Wanted, result: Made) -> Hashes:
    """The hashes of all files of the outputs that are built, whether they were made anew or not."""
    holders = [result.shared, *(device.outputs for device in result.devices.values())]
    return {path: one for held in holders for name in wanted.outputs for path, one in held.get(name, {}).items()}


def _manifest(out: Path) -> dict[str, dict[str, str]]:
    """What the last build wrote: hashes of files by path, and identities of devices."""
    try:
        held = json.loads((out / MANIFEST).read_text("utf-8"))
        return {"files": dict(held["files"]), "identities": dict(held["identities"])}
    except (OSError, ValueError, KeyError, TypeError):
        return {"files": {}, "identities": {}}


def _gone(before: Mapping[str, Mapping[str, str]], hashes: Hashes, names: Sequence[str]) -> list[str]:
    """Files of an earlier build that the outputs being built no longer produce."""
    ours = (path for path in before["files"] if path.partition("/")[0] in names and path not in hashes)
    return sorted(path for path in ours if ".." not in path.split("/"))


def _renewed(
    before: Mapping[str, Mapping[str, str]], wanted: Wanted, result: Made, hashes: Hashes, gone: Sequence[str]
) -> bytes:
    identities = {} if wanted.whole else dict(before["identities"])
    for device in result.devices.values():
        identities |= device.identities
    files = {path: one for path, one in before["files"].items() if path not in gone} | hashes
    data = {"identities": dict(sorted(identities.items())), "files": dict(sorted(files.items()))}
    return (json.dumps(data, indent=1) + "\n").encode("utf-8")


def _report(stale: Sequence[str], gone: Sequence[str]) -> int:
    for path in stale:
        print(f"not fresh: {path}")
    for path in gone:
        print(f"no longer produced: {path}")
    if not stale and not gone:
        print("everything is fresh")
        return 0
    print("build again with: fieldspec build")
    return 1
