"""`fieldspec live points`, `backup`, `restore` and `compare`: lists of values from a device and to it."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from fieldspec.command.console.streams import print_error, print_json, print_note
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import list_files, storage
from fieldspec.command.files.journal_file import JournalFile
from fieldspec.command.live.output import confirmed, progress
from fieldspec.command.rendering.blocks import Line, Table
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.tools.lists.sheet import ListError, Sheet, letters
from fieldspec.tools.live.client import Client
from fieldspec.tools.live.list_reading import ListFinding, entries
from fieldspec.tools.live.states import active_states
from fieldspec.tools.live.transfer import Change, TransferError, changes, transfer
from fieldspec.tools.live.value_files import file_content, file_sheet, suffix
from fieldspec.tools.live.value_lists import INDEX, NAME, cell, elements, left_out, settings, settings_list, table_list
from fieldspec.tools.live.writing import WriteError

if TYPE_CHECKING:
    from fieldspec.tools.live.access import Access, Assignment

TRANSFERS = ("points", "backup", "restore", "compare")
"""The verbs of this file."""

_USES = {
    "points": "say `points download FILE` or `points upload FILE`",
    "backup": "name one file to write, such as settings.csv",
    "restore": "name the file of a backup",
    "compare": "name the file of a backup or of points",
}


def transfer_values(
    client: Client, access: Access, arguments: argparse.Namespace, open_device: Callable[[], bool]
) -> int:
    """Carries out one of the verbs, after `open_device`. Exit code 1 for findings, differences and failures.

    Raises UsageError.
    """
    verb, words = arguments.verb_of_device, list(arguments.arguments)
    if verb == "points":
        verb = words.pop(0) if words and words[0] in ("download", "upload") else ""
    if not verb or len(words) != 1 or words[0] == "-":
        raise UsageError(_USES[arguments.verb_of_device])
    if arguments.verb_of_device == "points" and not client.layout.tables:
        raise UsageError(f"{client.layout.device.id} has no record table; `backup` and `restore` are for its settings")
    if arguments.table and arguments.table not in client.layout.tables:
        raise unknown("table", arguments.table, client.layout.tables)
    path = Path(words[0])
    try:
        suffix(path.name)
        if verb in ("download", "backup"):
            return _save(client, access, path, verb, arguments, open_device)
        content = list_files.content(words[0])
        sheet = file_sheet(path.name, content)
    except ListError as error:
        raise UsageError(f"{words[0]} {error}") from None
    if {"restore": INDEX, "upload": NAME}.get(verb) in sheet.rows[0].cells:
        other = "points upload" if verb == "restore" else "restore"
        raise UsageError(f"{words[0]} is a list for `{other}`, by its headings")
    assignments, findings = entries(access, sheet, arguments.table or "", arguments.any_version)
    if findings:
        _print_findings(words[0], sheet, findings)
        return 1
    if not open_device():
        return 1
    if verb == "compare":
        return _compare(client, access, assignments, arguments)
    return _Upload(client, access, path, content, arguments).run(assignments)


def _print_findings(name: str, sheet: Sheet, findings: Sequence[ListFinding]) -> None:
    """One line for each finding, with its cell in a table, and its line or item elsewhere."""
    form = suffix(name)
    for finding in findings:
        place = f"{letters(finding.column)}{finding.row}" if finding.column else f"{finding.row}"
        if form in (".yaml", ".yml"):
            place = str(finding.row or 1)
        elif form == ".json":
            place = f"item {finding.row - 1}" if finding.row > 1 else "keys"
        print_note(f"{name}:{place}: {finding.text}")
    print_note(f"{len(findings)} finding{'s' * (len(findings) > 1)}; nothing was written")


def _save(
    client: Client,
    access: Access,
    path: Path,
    verb: str,
    arguments: argparse.Namespace,
    open_device: Callable[[], bool],
) -> int:
    """Reads values into a file, which is replaced all or nothing."""
    table = _table(client, arguments) if verb == "download" else ""
    chosen = elements(access, table) if table else settings(access)
    for text in left_out(access, table) if table else ():
        print_note(f"left out: {text}")
    if not chosen:
        raise UsageError(f"{client.layout.device.id} has no values that can be both read and written")
    storage.require_writable(path)
    open_device()
    with progress(access.size(chosen), "reading") as done:
        values = [value for value in access.read(client, chosen, done) if not value.is_absent]
    content = file_content(path.name, table_list(access, table, values) if table else settings_list(access, values))
    storage.write(path, content)
    refused = [value.path for value in values if value.refusal]
    note = f", {len(refused)} refused: {', '.join(refused[:5])}" if refused else ""
    print_note(f"{len(values) - len(refused)} values{note}")
    return int(bool(refused))


def _table(client: Client, arguments: argparse.Namespace) -> str:
    tables = client.layout.tables
    if arguments.table:
        return str(arguments.table)
    if len(tables) != 1:
        choice = f"choose one with --table: {', '.join(tables)}"
        raise UsageError(f"which record table of {client.layout.device.id}? {choice}")
    return next(iter(tables))


def _differences(client: Client, access: Access, assignments: Sequence[Assignment]) -> list[Change]:
    with progress(access.size(access.item(chosen) for chosen in assignments), "comparing") as done:
        return changes(access, client, assignments, done)


def _compare(client: Client, access: Access, assignments: Sequence[Assignment], arguments: argparse.Namespace) -> int:
    plan = _differences(client, access, assignments)
    if arguments.format == "json":
        print_json([_change_row(access, change) for change in plan], indent=1)
    else:
        _print_plan(client, access, plan, False)
        print_blocks([Line(f"{len(plan)} of {len(assignments)} values differ")])
    return int(bool(plan))


def _change_row(access: Access, change: Change) -> dict[str, object]:
    now, new = _texts(access, change)
    before = change.before
    return {"name": change.path, access.heading(before): access.number(before), "device": now, "file": new}


def _texts(access: Access, change: Change) -> tuple[str, str]:
    """The texts of a value in the device and in the file."""
    now = f"refused: {change.before.refusal}" if change.before.refusal else str(cell(access, change.before))
    return now, str(cell(access, access.intended(change.chosen)))


def _print_plan(client: Client, access: Access, plan: Sequence[Change], frames: bool) -> None:
    if not plan:
        return
    head: tuple[str, ...] = ("name", "device", "file")
    rows: list[tuple[str, ...]] = [(change.path, *_texts(access, change)) for change in plan]
    if frames:
        head += ("frame",)
        sent_frames = [access.frame(client, change.chosen) for change in plan]
        rows = [(*row, frame.hex(" ").upper()) for row, frame in zip(rows, sent_frames, strict=True)]
    print_blocks([Table(head, tuple(rows))])
    sys.stdout.flush()


class _Upload:
    """Writes a list to a device: plan, question, verified writes with a journal, and a last comparison."""

    def __init__(
        self, client: Client, access: Access, path: Path, content: bytes, arguments: argparse.Namespace
    ) -> None:
        self.client, self.access, self.path, self.arguments = client, access, path, arguments
        device = client.layout.device
        unit = {"device": device.id, "unit": client.unit_address}
        self.journal = JournalFile(path, content, unit)
        self.verified: list[str] = []
        self.open = ""

    def run(self, assignments: Sequence[Assignment]) -> int:
        """Writes the values that differ. The exit code."""
        plan = _differences(self.client, self.access, assignments)
        self._print_earlier(assignments, plan)
        try:
            _print_plan(self.client, self.access, plan, self.arguments.dry_run)
        except WriteError as error:
            raise UsageError(str(error)) from None
        print_note(f"{len(plan)} of {len(assignments)} values differ")
        if self.arguments.dry_run:
            return 0
        if not plan:
            self.journal.remove()
            return 0
        for hazard in sorted({hazard for change in plan for hazard in change.chosen.hazards}):
            own = [change.path for change in plan if hazard in change.chosen.hazards]
            rest_text = f" and {len(own) - 3} more" if len(own) > 3 else ""
            print_note(f"{', '.join(own[:3])}{rest_text}: {hazard}")
        for text in active_states(self.access, self.client):
            print_note(text)
        if not confirmed(self.arguments):
            return 1
        return self._write(assignments, plan)

    def _write(self, assignments: Sequence[Assignment], plan: Sequence[Change]) -> int:
        try:
            with progress(len(plan), "writing") as done:

                def after(change: Change) -> None:
                    self.journal.verify(change)
                    self.verified.append(change.path)
                    self.open = ""
                    done(1)

                transfer(self.access, self.client, plan, self._before, after)
        except TransferError as error:
            print_error(error)
            self._print_state(plan, "" if error.uncertain else self.open)
            return 1
        except BaseException:
            self._print_state(plan)
            raise
        finally:
            self.journal.close()
        rest = _differences(self.client, self.access, assignments)
        self.journal.remove()
        print_note(f"{len(plan)} value{'s' * (len(plan) > 1)} written and verified")
        if rest:
            print_note(f"{len(rest)} of {len(assignments)} values differ again: writing others has changed them")
            _print_plan(self.client, self.access, rest, False)
        return int(bool(rest))

    def _before(self, change: Change) -> None:
        self.journal.begin(change)
        self.open = change.path

    def _print_state(self, plan: Sequence[Change], settled: str = "") -> None:
        """The values that are written after an interruption; `settled` is a path of which the state is known."""
        print_note(f"written and verified: {_names(self.verified)}")
        if self.open and self.open != settled:
            print_note(f"may be written or not: {self.open}")
        rest = [change.path for change in plan if change.path not in self.verified and change.path != self.open]
        rest += [self.open] if settled else []
        print_note(f"not as the file says: {_names(rest)}")
        print_note(f"{self.journal.path} has this state; the same command continues")

    def _print_earlier(self, assignments: Sequence[Assignment], plan: Sequence[Change]) -> None:
        """Prints what an earlier run, which was interrupted, has written and what it was writing."""
        state = self.journal.state
        if state is None:
            return
        print_note(f"an earlier run was interrupted; it has written and verified: {_names(state.verified)}")
        if state.digest != self.journal.digest:
            print_note("the file has changed since then")
        if not state.path:
            return
        own = next((item for item in assignments if item.path == state.path), None)
        if own is None:
            print_note(f"it may have written {state.path}, which the file no longer has")
            return
        present = next((change.before.words for change in plan if change.path == state.path), own.words)
        has = {state.before: "what it had before", state.after: "what was to be written"}.get(present, "neither value")
        print_note(f"it was writing {state.path}, which has {has}")


def _names(paths: Sequence[str]) -> str:
    """Some paths, with the number of all of them."""
    if not paths:
        return "nothing"
    if len(paths) <= 6:
        return ", ".join(paths)
    return f"{len(paths)} values, {paths[0]} to {paths[-1]}"
