"""Records that somebody has compared sections of the manual with the spec: `fieldspec audit DEVICE --sign SECTION`."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterable, Mapping
from pathlib import Path

from fieldspec.audit.review import FILE, State, is_day, review_entry, states
from fieldspec.audit.sources import section_order
from fieldspec.commands import regular_file, specs
from fieldspec.commands.storing import alone, replace
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.facts import of_versions
from fieldspec.layout.device import DeviceLayout
from fieldspec.reading.findings import LARGEST_FILE
from fieldspec.reading.project import DeviceSpec, read

ALL = "all"
_HEAD = "# yaml-language-server: $schema=../../codegen/fieldspec/schema/spec.schema.json\n"


def sign(arguments: argparse.Namespace, spec: DeviceSpec, layouts: Iterable[DeviceLayout]) -> int:
    """Appends an entry to the reviews of a device. Raises UsageError, and writes nothing, where that cannot be done."""
    if not arguments.by or not arguments.by.strip():
        raise UsageError('--sign needs to know who has compared it; give a name or a role, as in --by "second reader"')
    today = time.strftime("%Y-%m-%d")
    day = arguments.on or today
    if not is_day(day):
        raise UsageError(f"--on {day} is no day; write it as in 2026-01-31")
    if day > today:
        raise UsageError(f"--on {day} is still to come, as today is {today}; give the day of the comparison")
    held = list(layouts)
    signed = _picked(states(of_versions(held)), arguments.sign)
    manual = held[-1].device.manual
    entry = review_entry(spec, signed, arguments.by.strip(), day, manual.sha256, manual.edition, arguments.how or "")
    folder = specs.writable(arguments.specs)
    path = folder / spec.id / FILE
    with alone(path.parent):  # from reading to writing, so that no entry of another process is lost
        text = (_before(path) or f"{_HEAD}reviews:\n") + entry
        _must_be_sound(folder, spec.id, text)
        replace(path, text.encode("utf-8"))
    count = sum(len(state.digests) for state in signed.values())
    print(f"{specs.relative_path(path)}: {len(signed)} sections with {count} facts, by {arguments.by.strip()} on {day}")
    return 0


def _picked(now: Mapping[str, State], name: str) -> dict[str, State]:
    """The sections that a name means: one, a chapter with all of its sections, or all of them."""
    if name == ALL:
        return {section: now[section] for section in sorted(now, key=section_order)}
    found = [section for section in now if section == name or section.startswith(f"{name}.")]
    if not found:
        raise unknown("section of the manual that facts cite", name, sorted(now, key=section_order))
    return {section: now[section] for section in sorted(found, key=section_order)}


def _before(path: Path) -> str:
    """What the file has; it must end with the list of reviews, so that an entry can follow."""
    try:
        text = regular_file.content(path, LARGEST_FILE).decode("utf-8")
    except FileNotFoundError:
        return ""
    except OSError as error:
        raise UsageError(f"cannot read {path}: {error.strerror}") from None
    except UnicodeError:
        raise UsageError(f"{path} is not UTF-8; nothing was changed") from None
    return text if not text or text.endswith("\n") else text + "\n"


def _must_be_sound(folder: Path, device: str, text: str) -> None:
    """Reads the spec with the new file before anything is written."""
    files = specs.files(folder, frozenset([device]))
    files[f"{device}/{FILE}"] = text.encode("utf-8")
    if read(files, frozenset([device])).findings:
        raise UsageError(
            f"an entry cannot follow in {device}/{FILE}, which must end with the list `reviews`; nothing was written"
        )
