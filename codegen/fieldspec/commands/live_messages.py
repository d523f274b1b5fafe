"""The verbs of `fieldspec live` for devices without registers: their parameters, and what their responses say."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Sequence

from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands.live_output import confirmed, meaning_of, number_of
from fieldspec.commands.terminal import print_blocks
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.live.client import Client, NoAnswerError, RefusedError
from fieldspec.live.messages import (
    ParameterAssignment,
    Signal,
    SignalReading,
    named_signals,
    parameter_assignment,
    parameter_request,
    read_signals,
    signals,
    write_parameter,
)
from fieldspec.live.writing import WriteError
from fieldspec.render.blocks import Line, Table
from fieldspec.simulator.clock import SystemClock

if TYPE_CHECKING:
    from fieldspec.reading.project import DeviceSpec


def _chosen(client: Client, names: Sequence[str]) -> list[Signal]:
    """What names mean; everything without names. Raises UsageError."""
    known = list(signals(client.layout, client.frames.link))
    result: dict[str, Signal] = {}
    for name in names:
        own = named_signals(client.layout, known, name)
        if not own:
            raise unknown("value", name, [signal.path for signal in known])
        result |= {signal.path: signal for signal in own}
    return list(result.values()) if names else known


def _read(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    return _print(list(read_signals(client, _chosen(client, arguments.arguments))), arguments.format)


def _watch(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    if not arguments.arguments:
        raise UsageError("name what to watch")
    chosen, clock = _chosen(client, arguments.arguments), SystemClock()
    before: dict[str, SignalReading] = {}
    rounds = 0
    while not arguments.count or rounds < arguments.count:
        values = [value for value in read_signals(client, chosen) if before.get(value.signal.path) != value]
        before |= {value.signal.path: value for value in values}
        if values:
            _print(values, arguments.format)
        rounds += 1
        if not arguments.count or rounds < arguments.count:
            clock.sleep(arguments.every)
    return 0


def _print(values: Sequence[SignalReading], form: str) -> int:
    """Prints values as a table or as JSON: exit code 1 where the device refused one."""
    if form == "json":
        rows = [
            {
                "name": value.signal.path,
                "number": value.signal.wire_number,
                "value": None if value.decoded is None else _json(value.decoded.number),
                "meaning": meaning_of(value.decoded, value.refusal),
                "refused": value.refusal or None,
            }
            for value in values
        ]
        print(json.dumps(rows, ensure_ascii=False, indent=1), flush=True)
    else:
        table = tuple(
            (
                value.signal.path,
                "" if value.signal.wire_number is None else str(value.signal.wire_number),
                number_of(value.decoded),
                meaning_of(value.decoded, value.refusal),
            )
            for value in values
        )
        print_blocks([Table(("name", "number", "value", "meaning"), table)])
        sys.stdout.flush()
    return int(any(value.refusal for value in values))


def _json(number: object) -> object:
    return number.hex() if isinstance(number, bytes) else number


def _assignments(client: Client, texts: Sequence[str]) -> list[ParameterAssignment]:
    """What `NAME=VALUE` asks for, all judged before anything is written. Raises UsageError."""
    if not texts:
        raise UsageError("name what to write, as in NAME=VALUE")
    chosen = []
    for text in texts:
        name, mark, value = text.partition("=")
        own = _chosen(client, [name])
        if not mark or len(own) != 1:
            raise UsageError(f"`{text}` names {len(own)} values; write NAME=VALUE with the name of one")
        try:
            chosen.append(parameter_assignment(client.layout, client.frames.link, own[0], value))
        except WriteError as error:
            raise UsageError(str(error)) from None
    return chosen


def _write(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    chosen = _assignments(client, arguments.arguments)
    for item in chosen:
        for hazard in item.hazards:
            print(f"{item.signal.path}: {hazard}", file=sys.stderr)
    try:
        frames = [parameter_request(client, item)[2] for item in chosen]
    except WriteError as error:
        raise UsageError(str(error)) from None
    if arguments.dry_run:
        for item, frame in zip(chosen, frames, strict=True):
            print(f"{item.signal.path}: {frame.hex(' ').upper()}")
        return 0
    if any(item.hazards for item in chosen) and not confirmed(arguments):
        return 1
    code = 0
    for at, item in enumerate(chosen):
        path = item.signal.path
        before = ", ".join(other.signal.path for other in chosen[:at]) or "nothing"
        try:
            now = write_parameter(client, item)
        except RefusedError as error:
            print(f"fieldspec: {path} is not written: {error}; written before it: {before}", file=sys.stderr)
            return 1
        except NoAnswerError as error:
            print(f"fieldspec: {path} may be written or not: {error}; written before it: {before}", file=sys.stderr)
            return 1
        holds = now.decoded is not None and now.decoded.number == item.raw
        what = f"{number_of(now.decoded)} {meaning_of(now.decoded, now.refusal)}".strip()
        print_blocks([Line(f"{path}: {what}" if holds else f"{path}: the device holds {what}")])
        code = code or int(not holds)
    return code


VERBS: dict[str, Callable[[Client, DeviceSpec, argparse.Namespace], int]] = {
    "read": _read,
    "watch": _watch,
    "write": _write,
}
"""The verbs that make sense without addresses."""
