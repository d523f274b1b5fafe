"""`fieldspec live points`, `backup`, `restore` and `compare`: lists of values from a device and to it."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands import list_files, storage
from fieldspec.commands.journal_file import JournalFile
from fieldspec.commands.live_output import confirmed, progress
from fieldspec.commands.terminal import print_blocks
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.explain.registers import Occupant
from fieldspec.layout.device import DeviceLayout
from fieldspec.lists.sheet import ListError, Sheet, letters
from fieldspec.live.client import Client
from fieldspec.live.list_reading import ListFinding, entries
from fieldspec.live.reading import Reading, blocks, read, reading
from fieldspec.live.states import active_states
from fieldspec.live.transfer import Change, TransferError, changes, transfer
from fieldspec.live.value_files import file_content, file_sheet, suffix
from fieldspec.live.value_lists import INDEX, NAME, cell, elements, left_out, settings, settings_list, table_list
from fieldspec.live.writing import Assignment, WriteError, request_frame
from fieldspec.render.blocks import Line, Table

if TYPE_CHECKING:
    from fieldspec.reading.project import DeviceSpec

TRANSFERS = ("points", "backup", "restore", "compare")
"""The verbs of this file."""

_USES = {
    "points": "say `points download FILE` or `points upload FILE`",
    "backup": "name one file to write, such as settings.csv",
    "restore": "name the file of a backup",
    "compare": "name the file of a backup or of points",
}


def transfer_values(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    """Carries out one of the verbs. Exit code 1 for findings, differences and failures. Raises UsageError."""
    verb, words = arguments.verb_of_device, list(arguments.arguments)
    if verb == "points":
        verb = words.pop(0) if words and words[0] in ("download", "upload") else ""
    if not verb or len(words) != 1 or words[0] == "-":
        raise UsageError(_USES[arguments.verb_of_device])
    if arguments.table and arguments.table not in client.layout.tables:
        raise unknown("table", arguments.table, client.layout.tables)
    path = Path(words[0])
    try:
        suffix(path.name)
        if verb in ("download", "backup"):
            return _save(client, path, verb, arguments)
        content = list_files.content(words[0])
        sheet = file_sheet(path.name, content)
    except ListError as error:
        raise UsageError(f"{words[0]} {error}") from None
    if {"restore": INDEX, "upload": NAME}.get(verb) in sheet.rows[0].cells:
        other = "points upload" if verb == "restore" else "restore"
        raise UsageError(f"{words[0]} is a list for `{other}`, by its headings")
    wanted, findings = entries(client.layout, sheet, arguments.table or "", arguments.any_version)
    if findings:
        _print_findings(words[0], sheet, findings)
        return 1
    if verb == "compare":
        return _compare(client, wanted, arguments)
    return _Upload(client, path, content, arguments).run(wanted)


def _print_findings(name: str, sheet: Sheet, findings: Sequence[ListFinding]) -> None:
    """One line for each finding, with its cell in a table, and its line or item elsewhere."""
    form = suffix(name)
    for finding in findings:
        place = f"{letters(finding.column)}{finding.row}" if finding.column else f"{finding.row}"
        if form in (".yaml", ".yml"):
            place = str(finding.row or 1)
        elif form == ".json":
            place = f"item {finding.row - 1}" if finding.row > 1 else "keys"
        print(f"{name}:{place}: {finding.text}", file=sys.stderr)
    print(f"{len(findings)} finding{'s' * (len(findings) > 1)}; nothing was written", file=sys.stderr)


def _save(client: Client, path: Path, verb: str, arguments: argparse.Namespace) -> int:
    """Reads values into a file, which is replaced all or nothing."""
    layout = client.layout
    table = _table(layout, arguments) if verb == "download" else ""
    chosen = elements(layout, table) if table else settings(layout)
    for text in left_out(layout, table) if table else ():
        print(f"left out: {text}", file=sys.stderr)
    if not chosen:
        raise UsageError(f"{layout.device.id} has no values that can be both read and written")
    values = _read_all(client, chosen)
    content = file_content(path.name, table_list(layout, table, values) if table else settings_list(layout, values))
    storage.write(path, content)
    refused = [value.occupant.path for value in values if value.refusal]
    note = f", {len(refused)} refused: {', '.join(refused[:5])}" if refused else ""
    print(f"{len(values) - len(refused)} values{note}", file=sys.stderr)
    return int(bool(refused))


def _table(layout: DeviceLayout, arguments: argparse.Namespace) -> str:
    if arguments.table:
        return str(arguments.table)
    if len(layout.tables) != 1:
        have = f"choose one with --table: {', '.join(layout.tables)}" if layout.tables else "it has none"
        raise UsageError(f"which record table of {layout.device.id}? {have}")
    return next(iter(layout.tables))


def _read_all(client: Client, chosen: Sequence[tuple[str, Occupant]]) -> list[Reading]:
    """Values in the order in which they are asked for."""
    plan = blocks(client.layout, chosen)
    with progress(sum(block.words for block in plan), "reading") as done:
        values = {value.occupant.path: value for value in read(client, plan, done)}
    return [values[occupant.path] for _, occupant in chosen]


def _differences(client: Client, wanted: Sequence[Assignment]) -> list[Change]:
    with progress(sum(item.occupant.words for item in wanted), "comparing") as done:
        return changes(client, wanted, done)


def _compare(client: Client, wanted: Sequence[Assignment], arguments: argparse.Namespace) -> int:
    plan = _differences(client, wanted)
    if arguments.format == "json":
        print(json.dumps([_row(client.layout, change) for change in plan], ensure_ascii=False, indent=1))
    else:
        _print_plan(client, plan, False)
        print_blocks([Line(f"{len(plan)} of {len(wanted)} values differ")])
    return int(bool(plan))


def _row(layout: DeviceLayout, change: Change) -> dict[str, object]:
    now, new = _texts(layout, change)
    return {"name": change.path, "address": change.chosen.occupant.address, "device": now, "file": new}


def _texts(layout: DeviceLayout, change: Change) -> tuple[str, str]:
    """What the device has, and what the file has."""
    new = reading(layout, change.chosen.space, change.chosen.occupant, change.chosen.words)
    now = f"refused: {change.before.refusal}" if change.before.refusal else str(cell(layout, change.before))
    return now, str(cell(layout, new))


def _print_plan(client: Client, plan: Sequence[Change], frames: bool) -> None:
    if not plan:
        return
    head: tuple[str, ...] = ("name", "device", "file")
    rows: list[tuple[str, ...]] = [(change.path, *_texts(client.layout, change)) for change in plan]
    if frames:
        head += ("frame",)
        sent = [request_frame(client, change.chosen)[2] for change in plan]
        rows = [(*row, frame.hex(" ").upper()) for row, frame in zip(rows, sent, strict=True)]
    print_blocks([Table(head, tuple(rows))])
    sys.stdout.flush()


class _Upload:
    """Writes a list to a device: plan, question, verified writes with a journal, and a last comparison."""

    def __init__(self, client: Client, path: Path, content: bytes, arguments: argparse.Namespace) -> None:
        self.client, self.path, self.arguments = client, path, arguments
        device = client.layout.device
        unit = {"device": device.id, "unit": client.unit_address}
        self.journal = JournalFile(path, content, unit)
        self.verified: list[str] = []
        self.open = ""

    def run(self, wanted: Sequence[Assignment]) -> int:
        """The exit code."""
        plan = _differences(self.client, wanted)
        self._print_earlier(wanted, plan)
        try:
            _print_plan(self.client, plan, self.arguments.dry_run)
        except WriteError as error:
            raise UsageError(str(error)) from None
        print(f"{len(plan)} of {len(wanted)} values differ", file=sys.stderr)
        if self.arguments.dry_run:
            return 0
        if not plan:
            self.journal.remove()
            return 0
        for hazard in sorted({hazard for change in plan for hazard in change.chosen.hazards}):
            own = [change.path for change in plan if hazard in change.chosen.hazards]
            more = f" and {len(own) - 3} more" if len(own) > 3 else ""
            print(f"{', '.join(own[:3])}{more}: {hazard}", file=sys.stderr)
        for text in active_states(self.client):
            print(text, file=sys.stderr)
        if not confirmed(self.arguments):
            return 1
        return self._write(wanted, plan)

    def _write(self, wanted: Sequence[Assignment], plan: Sequence[Change]) -> int:
        try:
            with progress(len(plan), "writing") as done:

                def after(change: Change) -> None:
                    self.journal.verify(change)
                    self.verified.append(change.path)
                    self.open = ""
                    done(1)

                transfer(self.client, plan, self._before, after)
        except TransferError as error:
            print(f"fieldspec: {error}", file=sys.stderr)
            self._print_state(plan, "" if error.uncertain else self.open)
            return 1
        except BaseException:
            self._print_state(plan)
            raise
        finally:
            self.journal.close()
        rest = _differences(self.client, wanted)
        self.journal.remove()
        print(f"{len(plan)} value{'s' * (len(plan) > 1)} written and verified", file=sys.stderr)
        if rest:
            print(f"{len(rest)} of {len(wanted)} values differ again: writing others has changed them", file=sys.stderr)
            _print_plan(self.client, rest, False)
        return int(bool(rest))

    def _before(self, change: Change) -> None:
        self.journal.begin(change)
        self.open = change.path

    def _print_state(self, plan: Sequence[Change], settled: str = "") -> None:
        """What is written after a break; `settled` is a path of which the state is known."""
        print(f"written and verified: {_names(self.verified)}", file=sys.stderr)
        if self.open and self.open != settled:
            print(f"may be written or not: {self.open}", file=sys.stderr)
        rest = [change.path for change in plan if change.path not in self.verified and change.path != self.open]
        rest += [self.open] if settled else []
        print(f"not as the file says: {_names(rest)}", file=sys.stderr)
        print(f"{self.journal.path} has this state; the same command continues", file=sys.stderr)

    def _print_earlier(self, wanted: Sequence[Assignment], plan: Sequence[Change]) -> None:
        """What an earlier run, which did not end, has left."""
        state = self.journal.state
        if state is None:
            return
        print(f"an earlier run was interrupted; it has written and verified: {_names(state.verified)}", file=sys.stderr)
        if state.digest != self.journal.digest:
            print("the file has changed since then", file=sys.stderr)
        if not state.path:
            return
        own = next((item for item in wanted if item.occupant.path == state.path), None)
        if own is None:
            print(f"it may have written {state.path}, which the file no longer has", file=sys.stderr)
            return
        present = next((change.before.words for change in plan if change.path == state.path), own.words)
        has = {state.before: "what it had before", state.after: "what was to be written"}.get(present, "neither value")
        print(f"it was writing {state.path}, which has {has}", file=sys.stderr)


def _names(paths: Sequence[str]) -> str:
    """Some paths, with the number of all of them."""
    if not paths:
        return "nothing"
    if len(paths) <= 6:
        return ", ".join(paths)
    return f"{len(paths)} values, {paths[0]} to {paths[-1]}"
