"""The manifest of a build: what was written, by its hash, and of which bytes of specs it was made."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from fieldspec.classes import dataclass
from fieldspec.commands.fresh import LARGEST_OUTPUT, Earlier, Hashes
from fieldspec.commands.making import BuildRequest, BuildResult
from fieldspec.commands.regular_file import content

NAME = "manifest.json"
_NAMED = 3


@dataclass(frozen=True, slots=True)
class Manifest:
    """Identities of versions, hashes of spec files by device, and hashes of the files that were made of them."""

    identities: Hashes
    specs: dict[str, Hashes]
    files: Hashes

    def text(self) -> bytes:
        """The file."""
        specs = {device: dict(sorted(files.items())) for device, files in sorted(self.specs.items())}
        data = {
            "identities": dict(sorted(self.identities.items())),
            "specs": specs,
            "files": dict(sorted(self.files.items())),
        }
        return (json.dumps(data, indent=1) + "\n").encode("utf-8")

    def renewed(self, wanted: BuildRequest, result: BuildResult, hashes: Hashes, gone: Sequence[str]) -> Manifest:
        """The manifest after a build that has made or kept files with some hashes, and removes others."""
        identities = {} if wanted.whole else dict(self.identities)
        specs = {} if wanted.whole else dict(self.specs)
        for name, device in result.devices.items():
            identities |= device.identities
            specs[name] = device.inputs
        if wanted.picked or any(path.partition("/")[0] not in wanted.outputs for path in self.files):
            specs = self.specs  # some files are still of other specs
        files = {path: one for path, one in self.files.items() if path not in gone} | hashes
        return Manifest(identities, specs, files)

    def gone(self, hashes: Hashes, names: Sequence[str]) -> list[str]:
        """Files of an earlier build that the outputs being built no longer produce."""
        ours = (path for path in self.files if path.partition("/")[0] in names and path not in hashes)
        return sorted(path for path in ours if ".." not in path.split("/"))

    def reason(self, path: str, result: BuildResult, earlier: Earlier) -> str:
        """Why a file is not what a build would write."""
        if path not in self.files:
            return "it is new"
        if earlier.hash_of(path) is None:
            return "it is missing"
        if earlier.hash_of(path) != self.files[path]:
            return "it is not what was written"
        makers = [name for name, one in result.devices.items() if any(path in files for files in one.outputs.values())]
        for name in makers:
            before, now = self.specs.get(name, {}), result.devices[name].inputs
            changed = sorted(file for file in before.keys() | now.keys() if before.get(file) != now.get(file))
            if before and changed:
                more = f" and {len(changed) - _NAMED} more" if len(changed) > _NAMED else ""
                return f"changed: {', '.join(changed[:_NAMED])}{more}"
        return "another compiler has written it"


def read(out: Path) -> Manifest:
    """What the last build has left; nothing where it cannot be read."""
    try:
        held = json.loads(content(out / NAME, LARGEST_OUTPUT))
        specs = {device: dict(files) for device, files in held.get("specs", {}).items()}
        return Manifest(dict(held["identities"]), specs, dict(held["files"]))
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return Manifest({}, {}, {})
