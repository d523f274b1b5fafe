"""How a device that does not answer is found: other links, line settings and unit addresses."""

from __future__ import annotations

import argparse
import shlex
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing
from typing import Any

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.reference.records import CodecError
from fieldspec.command.console.streams import print_error, print_json, print_note
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.console.usage import UsageError
from fieldspec.command.live.connection import (
    access_of,
    client_at,
    fixed_values,
    line_settings,
    links_that_read,
    opened,
    opening_objection,
    unsent,
)
from fieldspec.command.live.output import progress
from fieldspec.command.rendering.blocks import Table
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.tools.carriers.carrier import CarrierError
from fieldspec.tools.carriers.terminals import has_line_settings
from fieldspec.tools.live.client import Client, NoAnswerError, RefusedError
from fieldspec.tools.simulator.simulation import usual_unit_address

if TYPE_CHECKING:
    from fieldspec.tools.live.access import Access, Item

_TIMEOUT = 0.3
"""The seconds that each attempt waits: most attempts get no answer."""


@dataclass(frozen=True, slots=True)
class Setting:
    """A link with the settings of its line; they are None where the place has none."""

    link: LinkLayout
    baud: int | None = None
    data_bits: int | None = None
    parity: str | None = None

    def applied(self, arguments: argparse.Namespace, unit: int | None) -> argparse.Namespace:
        """The arguments of an attempt with this setting."""
        own = {"link": self.link.name, "baud": self.baud, "data_bits": self.data_bits, "parity": self.parity}
        once = {"unit": unit, "retries": 0, "timeout": arguments.timeout or _TIMEOUT, "format": "json"}
        return argparse.Namespace(**{**vars(arguments), **own, **once})

    def options(self, unit: int | None) -> str:
        """The options of the command line that choose this setting."""
        chosen = {
            "link": self.link.name,
            "baud": self.baud,
            "data-bits": self.data_bits,
            "parity": self.parity,
            "unit": unit,
        }
        return " ".join(f"--{name} {value}" for name, value in chosen.items() if value is not None)


@dataclass(frozen=True, slots=True)
class AnsweringUnit:
    """A unit that answers with a setting; `answer` is what was read, or the exception response."""

    setting: Setting
    unit: int | None
    answer: str


def settings(layout: DeviceLayout, arguments: argparse.Namespace) -> Iterator[Setting]:
    """The settings that a device can have at a place, those that its spec states first. Options restrict them."""
    names = [arguments.link] if arguments.link else list(dict.fromkeys((layout.device.default_link, *layout.links)))
    known = links_that_read(layout)
    for name in names:
        link = layout.links.get(name)
        if link is None or name not in known or opening_objection(link, arguments.port):
            continue
        serial = link.link.serial
        if not has_line_settings(arguments.port):
            yield Setting(link)
        elif serial is not None:
            for baud in _choices(arguments.baud, serial.factory_baud, serial.baud):
                for bits in _choices(arguments.data_bits, serial.factory_data_bits, serial.data_bits):
                    for parity in _choices(arguments.parity, serial.factory_parity, serial.parity):
                        yield Setting(link, baud, bits, parity)
        elif not link.link.ports:
            yield Setting(link, arguments.baud or 9600, arguments.data_bits or 8, arguments.parity or "none")


def _choices(requested: object, factory: object, known: Sequence[object]) -> list[Any]:
    """The requested value alone, or the factory setting and then the others."""
    return [requested] if requested is not None else list(dict.fromkeys((factory, *known)))


def units(link: LinkLayout, arguments: argparse.Namespace, usual: int) -> list[int | None]:
    """The unit addresses to try on a link, the usual one first; None alone for requests without an address."""
    if link.request.role("unit_address") is None:
        return [None]
    if arguments.unit is not None:
        return [arguments.unit]
    addresses = link.link.unit_addresses
    ranges = addresses.ranges.intervals if addresses is not None and addresses.ranges is not None else ((1, 247),)
    other_units = [number for low, high in ranges for number in range(low, high + 1)]
    broadcast = addresses.broadcast if addresses is not None else None
    return [usual, *(number for number in other_units if number not in (usual, broadcast))]


def find_device(layout: DeviceLayout, arguments: argparse.Namespace) -> int:
    """Tries all settings and says what answers: exit code 1 if nothing does. Raises UsageError."""
    if arguments.arguments:
        raise UsageError("find takes no names; restrict it with --link, --baud, --data-bits, --parity or --unit")
    if not arguments.port:
        raise UsageError("say where to look: --port /dev/ttyUSB0, socket://HOST:PORT or tcp://HOST:PORT")
    tried = list(settings(layout, arguments))
    if not tried:
        raise UsageError(f"no link of {layout.device.id} reads over {arguments.port}; `fieldspec show` lists the links")
    usual = usual_unit_address(layout)
    first = [(setting, units(setting.link, arguments, usual)[:1]) for setting in tried]
    rest = [(setting, other_units) for setting in tried if (other_units := units(setting.link, arguments, usual)[1:])]
    count = sum(len(numbers) for _, numbers in (*first, *rest))
    seconds = count * (arguments.timeout or _TIMEOUT)
    print_note(f"{layout.device.id}: {count} attempts, about {seconds:.0f} s without an answer; each only reads")
    answering_units: list[AnsweringUnit] = []
    reads: dict[str, tuple[Access, Item]] = {}
    try:
        with progress(count, "looking") as done:
            for setting, numbers in (*first, *rest):
                answering_units = list(_answers(layout, arguments, setting, numbers, reads, done))
                if answering_units:
                    known = {own.unit for own in answering_units}
                    other_units = [
                        unit for unit in units(setting.link, arguments, usual) if unit not in (known | set(numbers))
                    ]
                    answering_units += _answers(layout, arguments, setting, other_units, reads, done)
                    break
    except CarrierError as error:
        raise UsageError(str(error)) from None
    except CodecError as error:
        raise unsent(error) from None
    return _print(layout, arguments, answering_units, count)


def _answers(
    layout: DeviceLayout,
    arguments: argparse.Namespace,
    setting: Setting,
    numbers: Sequence[int | None],
    reads: dict[str, tuple[Access, Item]],
    done: Callable[[int], None],
) -> Iterator[AnsweringUnit]:
    """The units that answer with a setting. `reads` has a read without an effect for each link that was tried."""
    if not numbers:
        return
    own = setting.applied(arguments, None)
    fixed = fixed_values(layout, setting.link, own)
    with closing(opened(setting.link, own)) as carrier:
        client = client_at(layout, setting.link, own, carrier, fixed)
        if setting.link.name not in reads:
            access = access_of(client)
            reads[setting.link.name] = access, _harmless_item(client, access)
        for unit in numbers:
            client = client_at(layout, setting.link, setting.applied(arguments, unit), carrier, fixed)
            answer = _answer(client, *reads[setting.link.name])
            done(1)
            if answer:
                yield AnsweringUnit(setting, unit, answer)


def _harmless_item(client: Client, access: Access) -> Item:
    """A value that is read without an effect. Raises UsageError where the spec shows none."""
    item = next(iter(access.harmless()), None)
    if item is None:
        raise UsageError(
            f"the spec shows no read without an effect on {client.frames.link.name}: read a value by its name, with "
            f"`fieldspec live {client.layout.device.id} read NAME`"
        )
    return item


def _answer(client: Client, access: Access, item: Item) -> str:
    """The answer to one read; empty without one."""
    try:
        value = next(iter(access.read(client, [item])))
    except NoAnswerError:
        return ""
    except RefusedError as error:
        return str(error)
    return f"{value.path}: {value.refusal or (value.decoded.text if value.decoded is not None else '')}"


def _print(
    layout: DeviceLayout, arguments: argparse.Namespace, answering_units: Sequence[AnsweringUnit], count: int
) -> int:
    rows = [
        {
            "link": own.setting.link.name,
            "baud": own.setting.baud,
            "data_bits": own.setting.data_bits,
            "parity": own.setting.parity,
            "unit": own.unit,
            "answer": own.answer,
        }
        for own in answering_units
    ]
    if arguments.format == "json":
        print_json(rows, indent=1)
        return int(not rows)
    if not rows:
        print_error(
            f"{layout.device.id}: no answer to {count} attempts at {arguments.port}; check the power, the adapter and "
            "the wiring (A and B exchanged?), or try a longer --timeout"
        )
        return 1
    used = [name for name in rows[0] if any(row[name] is not None for row in rows)]
    table = tuple(tuple("" if row[name] is None else str(row[name]) for name in used) for row in rows)
    print_blocks([Table(tuple(name.replace("_", " ") for name in used), table)])
    print_note(
        f"use it: {_command(layout, arguments, 'read', answering_units[0].setting.options(answering_units[0].unit))}"
    )
    return 0


def _command(layout: DeviceLayout, arguments: argparse.Namespace, verb: str, options: str = "") -> str:
    names = " ".join(map(shlex.quote, arguments.arguments)) if verb == arguments.verb_of_device else ""
    port = f"--port {shlex.quote(arguments.port)}" if arguments.port else ""
    return " ".join(filter(None, ("fieldspec live", layout.device.id, verb, names, port, options)))


def ways_on(client: Client, arguments: argparse.Namespace) -> Iterator[str]:
    """The other settings that a device can have which does not answer, and the commands that try them."""
    layout, link = client.layout, client.frames.link
    free = argparse.Namespace(**{**vars(arguments), "link": None, "baud": None, "data_bits": None, "parity": None})
    other_links = [setting for setting in settings(layout, free) if setting.link.name != link.name]
    serial = link.link.serial if has_line_settings(arguments.port) else None
    text = []
    names = list(dict.fromkeys(setting.link.name for setting in other_links))
    if names:
        text.append(f"link {_either(names)}")
    if serial is not None:
        used = line_settings(link, arguments)
        for values, own, unit in (
            (serial.baud, used.baud, "{} baud"),
            (serial.data_bits, used.data_bits, "{} data bits"),
            (serial.parity, used.parity, "parity {}"),
        ):
            different = [str(value) for value in values if value != own]
            text += [unit.format(_either(different))] if different else []
    addresses = link.link.unit_addresses
    if client.head and addresses is not None and addresses.ranges is not None:
        text.append(f"unit address {addresses.ranges.text()}")
    if text:
        yield f"{layout.device.id} can also be set to: {'; '.join(text)}"
    if names:
        yield f"try: {_command(layout, arguments, arguments.verb_of_device, f'--link {names[0]}')}"
    yield f"try all settings: {_command(layout, arguments, 'find')}"


def _either(names: Sequence[str]) -> str:
    """`a`, `a or b`, `a, b or c`"""
    *before, last = names
    return f"{', '.join(before)} or {last}" if before else last
