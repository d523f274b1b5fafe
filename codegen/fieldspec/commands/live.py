"""`fieldspec live`: the verbs that talk to a device, and how it is reached."""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from fieldspec.carriers.carrier import Carrier, CarrierError
from fieldspec.carriers.sockets import Connection, Datagrams
from fieldspec.carriers.terminals import SerialPort
from fieldspec.classes import TYPE_CHECKING
from fieldspec.commands import live_messages, specs
from fieldspec.commands.live_output import can_ask, confirmed, meaning, number, print_values, progress
from fieldspec.commands.live_transfer import TRANSFERS, transfer_values
from fieldspec.commands.terminal import print_blocks
from fieldspec.commands.usage import UsageError, unknown
from fieldspec.explain.registers import Occupant
from fieldspec.layout.device import DeviceLayout
from fieldspec.live.client import Client, NoAnswerError, RefusedError, Timing
from fieldspec.live.firmware import firmware_of
from fieldspec.live.messages import link_of, signals
from fieldspec.live.reading import all_occupants, blocks, read
from fieldspec.live.scanning import compared, scan, usual_ranges
from fieldspec.live.states import active_states
from fieldspec.live.writing import (
    Assignment,
    WriteError,
    assignment,
    differs,
    find,
    read_back,
    request_frame,
    write,
)
from fieldspec.render.blocks import Line, Table
from fieldspec.simulator.clock import SystemClock
from fieldspec.simulator.simulation import settings_of

if TYPE_CHECKING:
    from fieldspec.reading.project import DeviceSpec

_RANGE = re.compile(r"(0x[0-9A-Fa-f]{1,4}|[0-9]{1,5})(?:\.\.(0x[0-9A-Fa-f]{1,4}|[0-9]{1,5}))?")


def run(arguments: argparse.Namespace) -> int:
    """Carries out one verb. Exit code 1 where the device refuses something or does not answer. Raises UsageError."""
    spec, version = specs.spec_at(arguments.specs, arguments.device)
    layout = specs.layout_of(spec, version)
    verbs = VERBS if has_registers(layout) else live_messages.VERBS
    if arguments.verb_of_device not in verbs:
        known = ", ".join(verbs)
        raise UsageError(
            f"`{arguments.verb_of_device}` needs registers, and {layout.device.id} has none; it has {known}"
        )
    dry = arguments.dry_run and arguments.verb_of_device == "write"
    try:
        carrier: Carrier = _Nothing() if dry else _opened(layout, arguments)
        try:
            client = _client(layout, arguments, carrier)
            if not dry and _writes(arguments) and not _fits(client, spec, arguments.any_version):
                return 1
            return verbs[arguments.verb_of_device](client, spec, arguments)
        finally:
            carrier.close()
    except CarrierError as error:
        raise UsageError(str(error)) from None
    except (NoAnswerError, RefusedError) as error:
        print(f"fieldspec: {layout.device.id}: {error}", file=sys.stderr)
        return 1


def _writes(arguments: argparse.Namespace) -> bool:
    """Whether a verb changes something in the device."""
    verb = arguments.verb_of_device
    return verb in ("write", "restore") or (verb == "points" and arguments.arguments[:1] == ["upload"])


def _fits(client: Client, spec: DeviceSpec, any_version: bool) -> bool:
    """Whether the device has the firmware that the spec is for, as far as the device tells it. Says why not."""
    layout = client.layout
    firmware = firmware_of(client, spec.versions())
    if not firmware.text:
        if firmware.doubt:
            print(f"{layout.device.id}: {firmware.doubt}", file=sys.stderr)
        return True
    own = layout.device.version
    if firmware.version and specs.layout_of(spec, firmware.version).identity == layout.identity:
        return True
    known = f"is {firmware.version}" if firmware.version else f"is none of the spec: {firmware.doubt}"
    text = f"the firmware {firmware.text} of the device {known}, and the verb is for {own}"
    if any_version:
        print(f"{layout.device.id}: {text}", file=sys.stderr)
        return True
    advice = f"say {layout.device.id}@{firmware.version}" if firmware.version else "see what the manual says of it"
    print(f"fieldspec: {text}; nothing is written: {advice}, or --any-version", file=sys.stderr)
    return False


def has_registers(layout: DeviceLayout) -> bool:
    """Whether messages read or write registers."""
    device = layout.device
    return any(device.register_access(message) or device.bit_access(message) for message in device.messages.values())


class _Nothing:
    """The carrier of a dry run: nothing is sent."""

    name, datagrams = "nothing", False

    def read(self, seconds: float) -> bytes:
        """Nothing."""
        return b""

    def write(self, data: bytes) -> None:
        """Sends nothing."""

    def close(self) -> None:
        """Ends it."""


def _link(layout: DeviceLayout, arguments: argparse.Namespace) -> str:
    if arguments.link and arguments.link not in layout.links:
        raise unknown("link", arguments.link, layout.links)
    if has_registers(layout):
        return str(arguments.link or next(iter(layout.links)))
    chosen = layout.links[arguments.link] if arguments.link else link_of(layout)
    if chosen is None or not any(True for _ in signals(layout, chosen)):
        name = chosen.name if chosen is not None else layout.device.id
        raise UsageError(
            f"nothing on {name} only asks: what is exchanged cyclically is for a program, such as the generated client"
        )
    return chosen.name


def _opened(layout: DeviceLayout, arguments: argparse.Namespace) -> Carrier:
    place = arguments.port
    if not place:
        raise UsageError("say where the device is: --port /dev/ttyUSB0, socket://HOST:PORT, tcp://HOST:PORT")
    if place.startswith("tcp://"):
        return Connection.opened(place)
    if place.startswith("udp://"):
        return Datagrams(place, server=False)
    return SerialPort(place, settings_of(layout.links[_link(layout, arguments)].link, arguments.baud, arguments.parity))


def _client(layout: DeviceLayout, arguments: argparse.Namespace, carrier: Carrier) -> Client:
    link = layout.links[_link(layout, arguments)].link
    addresses = link.unit_addresses
    unit = arguments.unit
    if addresses is not None and addresses.ranges is not None:
        unit = addresses.ranges.low if unit is None else unit
        if unit not in addresses.ranges:
            raise UsageError(f"the unit address {unit} is not in {addresses.ranges.text()}")
    settings = settings_of(link, arguments.baud, arguments.parity)
    pause = arguments.pause
    if pause is None:
        printed = float(link.silence_milliseconds or 0) / 1000
        pause = max(printed, settings.seconds(float(link.silence_characters or 0)))
    timing = Timing(arguments.timeout, pause, arguments.retries)

    def trace(direction: str, frame: bytes) -> None:
        print(f"{direction} {frame.hex(' ').upper()}", file=sys.stderr)

    return Client(layout, link.name, carrier, unit or 0, timing, trace=trace if arguments.trace else None)


def _chosen(layout: DeviceLayout, names: Sequence[str]) -> list[tuple[str, Occupant]]:
    """What names mean. Raises UsageError."""
    known = list(all_occupants(layout))
    result, missing = find(names, known)
    if missing:
        raise unknown("register", missing[0], [occupant.path for _, occupant in known])
    return result


def _readable(layout: DeviceLayout) -> list[tuple[str, Occupant]]:
    """Everything that the read plan reads."""
    every = [pair for pair in all_occupants(layout) if not pair[1].reserved]
    planned = [block for block in blocks(layout, every) if len(block.occupants) > 1 or _is_harmless(block.occupants[0])]
    return [(block.space, occupant) for block in planned for occupant in block.occupants]


def _is_harmless(occupant: Occupant) -> bool:
    handling = getattr(occupant.fact, "handling", None)
    return occupant.access in ("ro", "rw") and not (handling is not None and handling.clears_on_read)


def _read(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    chosen = _chosen(client.layout, arguments.arguments) if arguments.arguments else _readable(client.layout)
    plan = blocks(client.layout, chosen)
    with progress(sum(block.words for block in plan), "reading") as done:
        values = list(read(client, plan, done))
    return print_values(values, arguments.format)


def _watch(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    """Prints values whenever they change."""
    if not arguments.arguments:
        raise UsageError("name what to watch, such as a register or a role")
    plan = blocks(client.layout, _chosen(client.layout, arguments.arguments))
    clock = SystemClock()
    before: dict[str, tuple[int, ...]] = {}
    rounds = 0
    while not arguments.count or rounds < arguments.count:
        values = [value for value in read(client, plan) if before.get(value.occupant.path) != value.words]
        before |= {value.occupant.path: value.words for value in values}
        if values:
            print_values(values, arguments.format)
        rounds += 1
        if not arguments.count or rounds < arguments.count:
            clock.sleep(arguments.every)
    return 0


def _dump(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    """Writes all words that can be read to a file that `audit --dump` and `simulate --dump` read."""
    if len(arguments.arguments) != 1:
        raise UsageError("name one file to write, or - for standard output")
    plan = blocks(client.layout, _readable(client.layout))
    with progress(sum(block.words for block in plan), "reading") as done:
        values = [(block.space, value) for block in plan for value in read(client, [block], done)]
    words = {}
    for space, value in values:
        for offset, word in enumerate(value.words):
            words[space, value.occupant.address + offset] = word
    several = client.layout.device.several_spaces
    head = "space,address,value" if several else "address,value"
    rows = [f"{f'{space},' * several}0x{address:04X},{words[space, address]}" for space, address in sorted(words)]
    text = "".join(f"{line}\n" for line in [head, *rows])
    if arguments.arguments[0] == "-":
        print(text, end="")
    else:
        try:
            Path(arguments.arguments[0]).write_text(text, "utf-8", newline="\n")
        except OSError as error:
            raise UsageError(f"cannot write {arguments.arguments[0]}: {error.strerror}") from None
    refused = [value.occupant.path for _, value in values if value.refusal]
    note = f", {len(refused)} values refused: {', '.join(refused[:5])}" if refused else ""
    print(f"{len(words)} words{note}", file=sys.stderr)
    return int(bool(refused))


def _assignments(client: Client, texts: Sequence[str]) -> list[Assignment]:
    """What `NAME=VALUE` asks for, all judged before anything is written. Raises UsageError."""
    if not texts:
        raise UsageError("name what to write, as in target_position=10.5mm")
    chosen = []
    for text in texts:
        name, mark, value = text.partition("=")
        own = _chosen(client.layout, [name])
        if not mark or len(own) != 1:
            raise UsageError(f"`{text}` names {len(own)} values; write NAME=VALUE with the name of one")
        try:
            chosen.append(assignment(client.layout, *own[0], value))
        except WriteError as error:
            raise UsageError(str(error)) from None
    return chosen


def _write(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    chosen = _assignments(client, arguments.arguments)
    for item in chosen:
        for hazard in item.hazards:
            print(f"{item.occupant.path}: {hazard}", file=sys.stderr)
    if any(item.hazards for item in chosen) and not arguments.dry_run and can_ask(arguments):
        for state in active_states(client):
            print(state, file=sys.stderr)
    if arguments.dry_run:
        for item in chosen:
            print(f"{item.occupant.path}: {_frame(client, item)}")
        return 0
    if any(item.hazards for item in chosen) and not confirmed(arguments):
        return 1
    code = 0
    for at, item in enumerate(chosen):
        reason, holds = _outcome(client, item)
        if reason:
            before = ", ".join(other.occupant.path for other in chosen[:at]) or "nothing"
            print(f"fieldspec: {item.occupant.path} {reason}; written before it: {before}", file=sys.stderr)
            return 1
        code = code or int(not holds)
    return code


def _frame(client: Client, item: Assignment) -> str:
    """The frame that writes a value, in hexadecimal. Raises UsageError."""
    try:
        return request_frame(client, item)[2].hex(" ").upper()
    except WriteError as error:
        raise UsageError(str(error)) from None


def _outcome(client: Client, item: Assignment) -> tuple[str, bool]:
    """Writes a value, reads it back and prints it: why it failed, or empty, and whether the device holds the value."""
    path = item.occupant.path
    try:
        write(client, item)
        now = read_back(client, item)
    except RefusedError as error:
        return f"is not written: {error}", False
    except NoAnswerError as error:
        return f"may be written or not: {error}", False
    if now is None:
        print_blocks([Line(f"{path}: sent; it cannot be read back")])
        return "", True
    if differs(item, now):
        print_blocks([Line(f"{path}: the device holds {number(now) or now.refusal} {meaning(now)}")])
        return "", False
    print_blocks([Line(f"{path}: {number(now)} {meaning(now)}".rstrip())])
    return "", True


def _scan(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    """Says what answers, and which version of the device it looks like."""
    layout = client.layout
    space = layout.device.space_name("")
    ranges = [_range(text) for text in arguments.arguments] or usual_ranges(layout, space)
    with progress(sum(map(len, ranges)), "scanning") as done:
        result = scan(client, space, ranges, done)
    versions = [compared(specs.layout_of(spec, version), result) for version in spec.versions()]
    own = next(item for item in versions if item.version == layout.device.version)
    unknown_rows = tuple((f"0x{a:04X}", f"0x{b:04X}", str(b - a + 1)) for a, b in own.unknown)
    alike = [item.version for item in versions if item.differences == min(other.differences for other in versions)]
    if arguments.format == "json":
        data = {
            "space": space,
            "words": {f"0x{address:04X}": result.words[address] for address in sorted(result.words)},
            "refused": [f"0x{address:04X}" for address in sorted(result.asked - result.words.keys())],
            "answering": len(result.words),
            "asked": len(result.asked),
            "unknown": [list(pair) for pair in own.unknown],
            "silent": list(own.silent),
            "versions": {item.version: item.differences for item in versions},
            "looks_like": alike,
        }
        print(json.dumps(data, indent=1))
        return 0
    blocks_of_text: list[Line | Table] = [Line(f"{len(result.words)} of {len(result.asked)} addresses answer")]
    if unknown_rows:
        blocks_of_text += [
            Line("These answer, and the spec does not have them:", "bold"),
            Table(("first", "last", "words"), unknown_rows),
        ]
    if own.silent:
        blocks_of_text += [Line("The spec has these, and they do not answer:", "bold"), Line(", ".join(own.silent))]
    if len(versions) > 1:
        blocks_of_text.append(Line(f"This unit looks like {' or '.join(alike)}."))
    print_blocks(blocks_of_text)
    return 0


def _range(text: str) -> range:
    match = _RANGE.fullmatch(text)
    first, last = (int(match[1], 0), int(match[2] or match[1], 0)) if match else (1, 0)
    if not 0 <= first <= last <= 0xFFFF:
        raise UsageError(f"`{text}` is no range of addresses; write it as 0x1000..0x10FF")
    return range(first, last + 1)


VERBS: dict[str, Callable[[Client, DeviceSpec, argparse.Namespace], int]] = {
    "read": _read,
    "write": _write,
    "watch": _watch,
    "dump": _dump,
    "scan": _scan,
    **dict.fromkeys(TRANSFERS, transfer_values),
}
