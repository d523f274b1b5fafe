"""`fieldspec live write`: values by name, judged and confirmed before the first one is sent."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from fieldspec.carriers.carrier import CarrierError
from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands.live_output import can_ask, confirmed, meaning, number
from fieldspec.commands.streams import print_error, print_line, print_note
from fieldspec.commands.terminal import print_blocks
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.live.access import differs
from fieldspec.live.client import Client, NoAnswerError, RefusedError
from fieldspec.live.states import active_states
from fieldspec.live.writing import WriteError
from fieldspec.render.blocks import Line

if TYPE_CHECKING:
    from fieldspec.live.access import Access, Assignment


def write_values(client: Client, access: Access, arguments: argparse.Namespace) -> int:
    """Writes what `NAME=VALUE` asks for. Exit code 1 where the device does not hold it then. Raises UsageError."""
    chosen = _assignments(access, arguments.arguments)
    frames = _frames(client, access, chosen)
    for item in chosen:
        for hazard in item.hazards:
            print_note(f"{item.path}: {hazard}")
    if arguments.dry_run:
        for names, frame in frames:
            print_line(f"{names}: {frame.hex(' ').upper()}")
        return 0
    if any(item.hazards for item in chosen):
        if can_ask(arguments):
            for state in active_states(access, client):
                print_note(state)
        if not confirmed(arguments):
            return 1
    code = 0
    for index, item in enumerate(chosen):
        is_sent = any(other.sent == item.sent for other in chosen[:index])
        reason, holds = _outcome(client, access, item, is_sent)
        if reason:
            before = ", ".join(other.path for other in chosen[:index]) or "nothing"
            print_error(f"{item.path} {reason}; written before it: {before}")
            return 1
        code = code or int(not holds)
    return code


def _assignments(access: Access, texts: Sequence[str]) -> list[Assignment]:
    """What `NAME=VALUE` asks for, all judged before anything is written. Raises UsageError."""
    if not texts:
        raise UsageError("name what to write, as in target_position=10.5mm")
    chosen = []
    for text in texts:
        name, mark, value = text.partition("=")
        own = access.named(name)
        if not own and (reason := access.reason_unread(name)):
            raise UsageError(reason)
        if not own:
            raise unknown(access.what, name, [access.path(item) for item in access.items()])
        if not mark or len(own) != 1:
            raise UsageError(f"`{text}` names {len(own)} values; write NAME=VALUE with the name of one")
        try:
            chosen.append(access.assignment(own[0], value))
        except WriteError as error:
            raise UsageError(str(error)) from None
    chosen, problems = access.together(chosen)
    if problems:
        raise UsageError("; ".join(dict.fromkeys(problems.values())))
    return chosen


def _frames(client: Client, access: Access, chosen: Sequence[Assignment]) -> list[tuple[str, bytes]]:
    """The frames that write values, each with the names of these. Raises UsageError."""
    names: dict[object, list[Assignment]] = {}
    for item in chosen:
        names.setdefault(item.sent, []).append(item)
    try:
        return [(", ".join(item.path for item in own), access.frame(client, own[0])) for own in names.values()]
    except WriteError as error:
        raise UsageError(str(error)) from None


def _outcome(client: Client, access: Access, item: Assignment, is_sent: bool) -> tuple[str, bool]:
    """Writes a value, reads it back and prints it: why it failed, or empty, and whether the device holds the value.

    One that `is_sent` was written with another one, with which it shares a word.
    """
    try:
        if not is_sent:
            access.write(client, item)
    except RefusedError as error:
        if error.is_known:
            return f"is not written: {error}", False
        return f"may be written or not: {error}, which the spec does not list", False
    except (NoAnswerError, CarrierError) as error:
        return f"may be written or not: {error}", False
    try:
        now = access.read_back(client, item)
    except (NoAnswerError, CarrierError) as error:
        return f"is written, and was not read back: {error}", False
    if now is None:
        print_blocks([Line(f"{item.path}: sent; it cannot be read back")])
        return "", True
    if differs(item, now):
        print_blocks([Line(f"{item.path}: the device holds {number(now) or now.refusal} {meaning(now)}")])
        return "", False
    print_blocks([Line(f"{item.path}: {number(now)} {meaning(now)}".rstrip())])
    return "", True
