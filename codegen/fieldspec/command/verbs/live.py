"""`fieldspec live`: the verbs that talk to a device."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from fieldspec.codec.reference.records import CodecError
from fieldspec.command.console.streams import print_document, print_error, print_note
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files.storage import require_writable, write
from fieldspec.command.live.connection import access_of, begin, connected, unsent
from fieldspec.command.live.finding import find_device, ways_on
from fieldspec.command.live.output import print_values, progress
from fieldspec.command.live.transfer import TRANSFERS, transfer_values
from fieldspec.command.live.writing import write_values
from fieldspec.command.sources import specs
from fieldspec.command.verbs.scan import scan_device
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.tools.live.access import find
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError
from fieldspec.tools.live.firmware import firmware_of
from fieldspec.tools.simulator.clock import SystemClock

if TYPE_CHECKING:
    from fieldspec.language.reading.device_spec import DeviceSpec
    from fieldspec.tools.live.access import Access, DumpRow, Item, Reading


def run(arguments: argparse.Namespace) -> int:
    """Carries out one verb. Exit code 1 where the device refuses something or does not answer. Raises UsageError."""
    _refuse_options(arguments)
    spec, version = specs.sound_at(arguments.specs, arguments.device)
    layout = specs.layout_of(spec, version)
    if arguments.verb_of_device == "find":
        return find_device(layout, arguments)
    try:
        with connected(layout, arguments) as client:
            return _carried_out(client, spec, arguments)
    except CodecError as error:
        raise unsent(error) from None


def _verb(arguments: argparse.Namespace) -> str:
    """The verb, with the direction of points."""
    verb = str(arguments.verb_of_device)
    direction = arguments.arguments[0] if arguments.arguments else ""
    return f"{verb} {direction}" if verb == "points" and direction in ("upload", "download") else verb


def _refuse_options(arguments: argparse.Namespace) -> None:
    """Raises UsageError for an option that has no effect on the verb."""
    verb = _verb(arguments)
    for option, verbs in _OPTIONS.items():
        value = getattr(arguments, option)
        is_default = value is None or value is False or value == "text"
        if not is_default and verb not in verbs and verb != "points":
            *first_verbs, last = verbs
            own = f"{', '.join(first_verbs)} and {last}" if first_verbs else last
            raise UsageError(f"--{option.replace('_', '-')} has no effect on {verb}, only on {own}; leave it out")


def _carried_out(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    try:
        return VERBS[arguments.verb_of_device](client, access_of(client), spec, arguments)
    except RefusedError as error:
        text = str(error)
    except NoAnswerError as error:
        unit = f"unit {client.unit_address} on " if client.head else ""
        text = f"{error} from {unit}{client.frames.link.name}"
        print_error(f"{client.layout.device.id}: {text}")
        for line in ways_on(client, arguments):
            print_note(line)
        return 1
    print_error(f"{client.layout.device.id}: {text}")
    return 1


def _begins(client: Client, spec: DeviceSpec, arguments: argparse.Namespace) -> bool:
    """Opens the port. False for a verb that writes to a device with a different firmware, which is then told."""
    begin(client, arguments)
    return _verb(arguments) not in _WRITING or _fits(client, spec, arguments.any_version)


def _fits(client: Client, spec: DeviceSpec, any_version: bool) -> bool:
    """Whether the device has the firmware that the spec is for, as far as the device tells it. Says why not."""
    layout = client.layout
    firmware = firmware_of(client, spec.versions())
    own = layout.device.version
    if not firmware.doubt and not firmware.version:
        return True
    if firmware.version and specs.layout_of(spec, firmware.version).identity == layout.identity:
        return True
    known = f"is {firmware.version}" if firmware.version else f"is not in the spec: {firmware.doubt}"
    text = f"the firmware {firmware.text} of the device {known}, and the verb is for {own}"
    if not firmware.text:
        text = f"{firmware.doubt}, and the verb is for {own}"
    if any_version or not firmware.is_asked:
        print_note(f"{layout.device.id}: {text}")
        return True
    advice = f"say {layout.device.id}@{firmware.version}" if firmware.version else "see what the manual says of it"
    print_error(f"{text}; nothing is written: {advice}, or --any-version")
    return False


def chosen_items(access: Access, names: Sequence[str]) -> list[Item]:
    """The items that names mean. Raises UsageError."""
    result, missing = find(access, names)
    reason = next((text for name in missing if (text := access.reason_unread(name))), "")
    if reason:
        raise UsageError(reason)
    if missing:
        raise unknown(access.what, missing[0], [access.path(item) for item in access.items()])
    return result


def _read(client: Client, access: Access, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    items = chosen_items(access, arguments.arguments) if arguments.arguments else access.harmless()
    remarks = access.remarks(arguments.arguments)
    if not items:
        raise UsageError("; ".join(["name what to read", *remarks]))
    begin(client, arguments)
    with progress(access.size(items), "reading") as done:
        values = list(access.read(client, items, done))
    for text in remarks:
        print_note(f"{client.layout.device.id}: {text}")
    return print_values(access, values, arguments.format)


def _watch(client: Client, access: Access, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    """Prints values whenever they change."""
    if not arguments.arguments:
        raise UsageError("name what to watch, such as a register or a role")
    items, clock = chosen_items(access, arguments.arguments), SystemClock()
    before: dict[str, tuple[object, ...]] = {}
    rounds = 0
    begin(client, arguments)
    while not arguments.count or rounds < arguments.count:
        values = [value for value in access.read(client, items) if before.get(value.path) != _seen(value)]
        before |= {value.path: _seen(value) for value in values}
        if values:
            print_values(access, values, arguments.format)
        rounds += 1
        if not arguments.count or rounds < arguments.count:
            clock.sleep(0.5 if arguments.every is None else arguments.every)
    return 0


def _seen(value: Reading) -> tuple[object, ...]:
    return value.words, value.refusal


def _dump(client: Client, access: Access, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    """Writes everything that can be read to a file that `audit --dump` and `simulate --dump` read."""
    if len(arguments.arguments) != 1:
        raise UsageError("name one file to write, or - for standard output")
    items, path = access.harmless(), arguments.arguments[0]
    if path != "-":
        require_writable(Path(path))
    begin(client, arguments)
    with progress(access.size(items), "reading") as done:
        values = list(access.read(client, items, done))
    rows = access.dump_rows(items, values)
    text = dump_text(rows)
    if path == "-":
        print_document(text)
    else:
        write(Path(path), text.encode("utf-8"))
    refused = [value.path for value in values if value.refusal and not value.is_absent]
    note = f", {len(refused)} values refused: {', '.join(refused[:5])}" if refused else ""
    print_note(f"{len(rows)} {access.rows_text}{note}")
    return int(bool(refused))


def dump_text(rows: Sequence[DumpRow]) -> str:
    """The text of a dump; it has a column for the space where there are several."""
    has_spaces = len({row.space for row in rows}) > 1
    head = "space,address,value" if has_spaces else "address,value"
    lines = [f"{f'{row.space},' * has_spaces}0x{row.address:04X},{row.value}" for row in rows]
    return "".join(f"{line}\n" for line in (head, *lines))


def _write(client: Client, access: Access, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    return write_values(client, access, arguments, partial(_begins, client, spec, arguments))


def _scan(client: Client, access: Access, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    return scan_device(client, spec, arguments)


def _transfer(client: Client, access: Access, spec: DeviceSpec, arguments: argparse.Namespace) -> int:
    return transfer_values(client, access, arguments, partial(_begins, client, spec, arguments))


_WRITING = ("write", "points upload", "restore")

_OPTIONS = {
    "every": ("watch",),
    "count": ("watch",),
    "dry_run": _WRITING,
    "yes": _WRITING,
    "table": ("points download", "points upload", "compare"),
    "any_version": (*_WRITING, "compare"),
    "format": ("find", "read", "watch", "scan", "compare"),
}
"""The verbs on which an option has an effect; the other options are for all of them."""

VERBS: dict[str, Callable[[Client, Access, DeviceSpec, argparse.Namespace], int]] = {
    "read": _read,
    "write": _write,
    "watch": _watch,
    "dump": _dump,
    "scan": _scan,
    **dict.fromkeys(TRANSFERS, _transfer),
}
