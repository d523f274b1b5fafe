"""`fieldspec live write`: values by name, judged and confirmed before the first one is sent."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence

from fieldspec.codec.explain.entered import rounded
from fieldspec.command.console.streams import print_error, print_line, print_note
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.live.output import can_ask, confirmed, meaning, number
from fieldspec.command.rendering.blocks import Line
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.tools.carriers.carrier import CarrierError
from fieldspec.tools.live.access import differs
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError
from fieldspec.tools.live.states import active_states
from fieldspec.tools.live.writing import WriteError

if TYPE_CHECKING:
    from fieldspec.codec.layout.device import DeviceLayout
    from fieldspec.tools.live.access import Access, Assignment


def write_values(client: Client, access: Access, arguments: argparse.Namespace, open_device: Callable[[], bool]) -> int:
    """Writes what `NAME=VALUE` asks for, after `open_device`. Exit code 1 where it does not hold it then.

    Raises UsageError.
    """
    chosen = assignments(client.layout, access, arguments.arguments)
    frames = frames_of(client, access, chosen)
    for item in chosen:
        for hazard in item.hazards:
            print_note(f"{item.path}: {hazard}")
    if arguments.dry_run:
        for item in chosen:
            if register := access.address_register(item):
                print_note(
                    f"{item.path}: its table begins where {register} says; the frame is that for its usual address"
                )
        for names, frame in frames:
            print_line(f"{names}: {frame.hex(' ').upper()}")
        return 0
    if not open_device():
        return 1
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


def assignments(layout: DeviceLayout, access: Access, texts: Sequence[str]) -> list[Assignment]:
    """The values that `NAME=VALUE` requests, all checked before anything is written. Raises UsageError.

    A quantity between two counts is rounded as in the generated code, with a remark.
    """
    if not texts:
        raise UsageError(f"name what to write, as in NAME=10.5mm; `fieldspec show {layout.device.id}` lists the names")
    chosen = []
    for text in texts:
        name, mark, value = text.partition("=")
        own = access.named(name)
        if not own and (reason := access.reason_unread(name)):
            raise UsageError(reason)
        if not own:
            raise unknown(access.what, name, [access.path(item) for item in access.items()])
        if not mark:
            raise UsageError(f"`{text}` has no value; write {name}=VALUE")
        if len(own) != 1:
            first = access.path(own[0])
            raise UsageError(f"`{name}` is the name of {len(own)} values; write one of them, such as {first}={value}")
        nearest_count = rounded(layout.device, name, access.value(own[0]), value)
        if nearest_count is not None:
            count, remark = nearest_count
            print_note(remark)
            value = str(count)
        try:
            chosen.append(access.assignment(own[0], value))
        except WriteError as error:
            raise UsageError(str(error)) from None
    chosen, problems = access.together(chosen)
    if problems:
        raise UsageError("; ".join(dict.fromkeys(problems.values())))
    return chosen


def frames_of(client: Client, access: Access, chosen: Sequence[Assignment]) -> list[tuple[str, bytes]]:
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
