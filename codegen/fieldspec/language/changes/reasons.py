"""The statements of version overlays between two versions of a device: reasons of changes, and renames."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.device import Device


@dataclass(frozen=True, slots=True)
class Reasons:
    """The reasons by path in the new version, and the new paths of renamed facts by their old ones."""

    by_path: Mapping[str, tuple[str, ...]]
    renames: Mapping[str, str]

    def of(self, path: str) -> str:
        """The reasons that are stated of the fact at a path, or else of the nearest fact that contains it."""
        while path:
            if path in self.by_path:
                return " ".join(self.by_path[path])
            path = path.rpartition("/")[0]
        return ""


def stated_reasons(old: Device, new: Device) -> Reasons:
    """The statements of the overlays from the old version to the new version; empty if no overlays connect them."""
    known = {entry.place.whole for entry in old.stated_changes}
    if not known <= {entry.place.whole for entry in new.stated_changes}:
        return Reasons({}, {})
    by_path: dict[str, tuple[str, ...]] = {}
    renames: dict[str, str] = {}
    for entry in new.stated_changes:
        if entry.place.whole in known:
            continue
        path, reason = entry.new_path, (entry.reason,) if entry.reason else ()
        if entry.to:
            by_path = {_moved(own, entry.path, path): reasons for own, reasons in by_path.items()}
            renames = {before: _moved(own, entry.path, path) for before, own in renames.items()}
            if path not in renames.values():
                renames[entry.path] = path
        by_path[path] = (*by_path.get(path, ()), *reason)
    return Reasons(by_path, renames)


def _moved(path: str, old: str, new: str) -> str:
    """A path after the fact at `old`, which it may be in, has the path `new`."""
    return new + path[len(old) :] if path == old or path.startswith(f"{old}/") else path
