"""`fieldspec build`: writes the outputs, all or nothing."""

from __future__ import annotations

import argparse
import errno
import hashlib
import json
import os
import sys
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from fieldspec.commands import specs
from fieldspec.commands.output import on_terminal, print_findings
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.diagnostics import has_errors
from fieldspec.layout.device import DeviceLayout

MANIFEST = "manifest.json"


def run(arguments: argparse.Namespace) -> int:
    """Builds, or with `--check` tells what a build would change. Exit code 1 for findings and stale files."""
    from fieldspec import pipeline

    wanted = [specs.split(text) for text in arguments.devices]
    names = _outputs(arguments.to)
    project = specs.project(arguments.specs, frozenset(device for device, _ in wanted))
    with _progress(f"checking {len(project.devices)} devices"):
        found = pipeline.checked(project)
    if found:
        print_findings(found, "text", "")
    if has_errors(found):
        return 1
    devices: list[list[DeviceLayout]] = []
    for device, spec in sorted(project.devices.items()):
        named = [version for name, version in wanted if name == device] or [""]
        picked = {specs.picked(spec, version) for version in named if version}
        layouts = pipeline.layouts(spec)
        devices.append([laid for laid in layouts if "" in named or laid.device.version in picked])
    with _progress(f"writing {', '.join(names)}"):
        made = pipeline.outputs(devices, names)
    out = Path(arguments.out)
    before = _manifest(out)
    whole = not arguments.devices
    gone = _gone(before, made, names) if whole else []
    identities = {} if whole else dict(before["identities"])
    for laid in (laid for some in devices for laid in some):
        identities |= {f"{laid.device.id}@{version}": laid.identity for version in (laid.device.version, *laid.twins)}
    wanted_files = {**made, MANIFEST: _renewed(before, made, gone, identities)}
    stale = sorted(path for path, content in wanted_files.items() if _differs(out / path, content))
    if arguments.check:
        return _report(stale, gone)
    if stale or gone:
        _write(out, {path: wanted_files[path] for path in stale}, gone)
    print(f"{len(made)} files, {len(set(stale) - {MANIFEST})} written, {len(gone)} removed")
    return 0


def _outputs(text: str | None) -> list[str]:
    from fieldspec.backends import OUTPUTS

    if text is None:
        return list(OUTPUTS)
    names = [name for name in text.split(",") if name]
    for name in names:
        if name not in OUTPUTS:
            raise unknown("output", name, OUTPUTS)
    if not names:
        raise UsageError(f"--to names no output; there are {', '.join(OUTPUTS)}")
    return names


@contextmanager
def _progress(text: str) -> Iterator[None]:
    """Says on a terminal what is being done."""
    if not (on_terminal() and sys.stderr.isatty()):
        yield
        return
    from rich.console import Console

    with Console(stderr=True).status(text):
        yield


def _manifest(out: Path) -> dict[str, dict[str, str]]:
    """What the last build wrote: hashes of files by path, and identities of devices."""
    try:
        held = json.loads((out / MANIFEST).read_text("utf-8"))
        return {"files": dict(held["files"]), "identities": dict(held["identities"])}
    except (OSError, ValueError, KeyError, TypeError):
        return {"files": {}, "identities": {}}


def _differs(path: Path, content: bytes) -> bool:
    try:
        return path.read_bytes() != content
    except OSError:
        return True


def _gone(before: Mapping[str, Mapping[str, str]], made: Mapping[str, bytes], names: list[str]) -> list[str]:
    """Files of an earlier build that the outputs being built no longer produce."""
    ours = (path for path in before["files"] if path.partition("/")[0] in names and path not in made)
    return sorted(path for path in ours if ".." not in path.split("/"))


def _report(stale: list[str], gone: list[str]) -> int:
    for path in stale:
        print(f"not fresh: {path}")
    for path in gone:
        print(f"no longer produced: {path}")
    if not stale and not gone:
        print("everything is fresh")
        return 0
    print("build again with: fieldspec build")
    return 1


def _renewed(
    before: Mapping[str, Mapping[str, str]], made: Mapping[str, bytes], gone: list[str], identities: Mapping[str, str]
) -> bytes:
    files = {path: digest for path, digest in before["files"].items() if path not in gone}
    files |= {path: hashlib.sha256(content).hexdigest() for path, content in made.items()}
    data = {"identities": dict(sorted(identities.items())), "files": dict(sorted(files.items()))}
    return f"{json.dumps(data, indent=1)}\n".encode()


def _write(out: Path, files: Mapping[str, bytes], gone: list[str]) -> None:
    """Writes all files beside their folder first, then moves them into place; on failure nothing has changed."""
    made = _missing(out)
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=".fieldspec-", dir=out) as beside:
            new, old = Path(beside, "new"), Path(beside, "old")
            for path, content in files.items():
                target = new / path
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content)
            _move(out, new, old, list(files), gone)
    except OSError as error:
        for folder in made:
            with suppress(OSError):
                folder.rmdir()
        place = error.filename or out
        raise UsageError(f"cannot write {place}: {error.strerror}; nothing was changed") from None


def _move(out: Path, new: Path, old: Path, paths: list[str], gone: list[str]) -> None:
    """Moves new files into place, keeping what was there until all are moved."""
    kept: list[str] = []
    placed: list[str] = []
    made: list[Path] = []
    try:
        for path in [*paths, *gone]:
            target = out / path
            if target.is_dir():
                raise IsADirectoryError(errno.EISDIR, "a folder is in the way", str(target))
            if target.exists():
                (old / path).parent.mkdir(parents=True, exist_ok=True)
                os.replace(target, old / path)
                kept.append(path)
            if path not in gone:
                made = [*_missing(target.parent), *made]
                target.parent.mkdir(parents=True, exist_ok=True)
                os.replace(new / path, target)
                placed.append(path)
    except BaseException:  # an interrupt, too, leaves what was there
        for path in placed:
            (out / path).unlink(missing_ok=True)
        for path in kept:
            os.replace(old / path, out / path)
        for folder in made:
            with suppress(OSError):
                folder.rmdir()
        raise
    for path in gone:
        _remove_empty(out, (out / path).parent)


def _missing(folder: Path) -> list[Path]:
    """The folders that must be made for a folder to be there, the innermost first."""
    return [above for above in (folder, *folder.parents) if not above.exists()]


def _remove_empty(out: Path, folder: Path) -> None:
    while folder != out and folder.is_dir() and not any(folder.iterdir()):
        folder.rmdir()
        folder = folder.parent
