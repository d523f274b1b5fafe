"""How a device is reached: its port, its link, its unit address and the times of an exchange."""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager

from fieldspec.codec.explain.hazards import is_bare
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.open_parts import open_parts
from fieldspec.codec.layout.values import MeaningError, Raw, raw_value
from fieldspec.codec.reference.records import CodecError, encoded_value
from fieldspec.command.console.streams import print_note
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.model.value import Value
from fieldspec.tools.carriers.carrier import Carrier, CarrierError, LineSettings
from fieldspec.tools.carriers.sockets import Connection, Datagrams
from fieldspec.tools.carriers.terminals import SerialPort, has_line_settings
from fieldspec.tools.live.client import Client, Timing
from fieldspec.tools.live.joint_access import JointAccess
from fieldspec.tools.live.left_out import reason_unread
from fieldspec.tools.live.messages import link_of, parameter_message, signals
from fieldspec.tools.live.parameter_access import ParameterAccess
from fieldspec.tools.live.register_access import RegisterAccess
from fieldspec.tools.simulator.parameters import count_field, part_of
from fieldspec.tools.simulator.simulation import can_objection, completed_place, settings_of, usual_unit_address

if TYPE_CHECKING:
    from fieldspec.tools.live.access import Access


_MOST_REASONS = 3
"""The reasons of one finding."""

_TIMEOUT = 1.0
"""The default response timeout in seconds."""


def has_registers(layout: DeviceLayout) -> bool:
    """Whether messages read or write registers."""
    device = layout.device
    return any(device.register_access(message) or device.bit_access(message) for message in device.messages.values())


def _reads_registers(layout: DeviceLayout, link: LinkLayout) -> bool:
    """Whether a message that is answered on a link reads registers or bits."""
    accesses = (
        layout.device.register_access(own.message) or layout.device.bit_access(own.message)
        for own in link.carried("response").values()
    )
    return any(access is not None and access.operation == "read" for access in accesses)


def links_that_read(layout: DeviceLayout) -> list[str]:
    """The names of the links over which values are read by name."""
    if has_registers(layout):
        return [name for name, link in layout.links.items() if _reads_registers(layout, link)]
    return [name for name, link in layout.links.items() if any(True for _ in signals(layout, link))]


def access_of(client: Client) -> Access:
    """What can be read and written by name over the link of a client: registers, parameters and messages."""
    layout, link = client.layout, client.frames.link
    if not has_registers(layout) or _has_signals_only(layout, link):
        return ParameterAccess(layout, link)
    registers, parameters = RegisterAccess(layout), ParameterAccess(layout, link)
    return JointAccess(registers, parameters) if parameters.items() else registers


def _has_signals_only(layout: DeviceLayout, link: LinkLayout) -> bool:
    """Whether messages of a link read parameters and other values, but no registers."""
    return not _reads_registers(layout, link) and any(True for _ in signals(layout, link))


@contextmanager
def connected(layout: DeviceLayout, arguments: argparse.Namespace) -> Iterator[Client]:
    """A client of the device. `begin` opens its port, after everything that needs no device. Raises UsageError."""
    link = layout.links[link_of_values(layout, arguments)]
    client = client_at(layout, link, arguments, _Unopened(), fixed_values(layout, link, arguments))
    try:
        yield client
    except CarrierError as error:
        raise UsageError(str(error)) from None
    finally:
        client.carrier.close()


def begin(client: Client, arguments: argparse.Namespace) -> None:
    """Opens `--port` for a client, and prints the settings. Raises UsageError and CarrierError."""
    link = client.frames.link
    client.connect(opened(link, arguments))
    if arguments.format == "text":
        print_note(settings_text(client.layout, link, arguments, client.unit_address))


class _Unopened:
    """The carrier before the port is opened: nothing is sent."""

    name, datagrams, keeps_pauses = "nothing", False, True

    def read(self, seconds: float) -> bytes:
        """No bytes."""
        return b""

    def write(self, data: bytes) -> None:
        """Sends nothing."""

    def close(self) -> None:
        """Closes nothing."""


def link_of_values(layout: DeviceLayout, arguments: argparse.Namespace) -> str:
    """The link over which values are read by name: the stated one, or the factory setting. Raises UsageError."""
    if arguments.link and arguments.link not in layout.links:
        raise unknown("link", arguments.link, layout.links)
    if has_registers(layout):
        suitable = links_that_read(layout)
        if not arguments.link:
            usual = layout.device.default_link
            return usual if usual in suitable or not suitable else suitable[0]
        if suitable and arguments.link not in suitable and not _has_signals_only(layout, layout.links[arguments.link]):
            raise UsageError(
                f"no message of {arguments.link} reads registers; say --link {' or --link '.join(suitable)}"
            )
        return str(arguments.link)
    chosen = layout.links[arguments.link] if arguments.link else link_of(layout)
    if chosen is None or not any(True for _ in signals(layout, chosen)):
        raise UsageError(_nothing_read(layout, [chosen] if chosen is not None else list(layout.links.values())))
    return chosen.name


def _nothing_read(layout: DeviceLayout, links: Sequence[LinkLayout]) -> str:
    """The reason why no value can be read by name on links."""
    name = links[0].name if len(links) == 1 else layout.device.id
    if all(map(is_bare, links)):
        return (
            f"nothing on {name} only asks: what is exchanged cyclically is for a program, such as the generated client"
        )
    reasons = [reason_unread(link, message) for link in links for message in link.exchanged]
    text = "; ".join([reason for reason in dict.fromkeys(reasons) if reason][:_MOST_REASONS])
    return f"nothing on {name} is read by name: {text or 'none of its messages is answered'}"


def _refuse_open_identifier(link: LinkLayout) -> None:
    """Raises UsageError for a link with a part of the identifier that nothing here can choose."""
    if link.open_identifier:
        text = f"the {link.open_identifier} in the identifier of requests on {link.name} is unknown"
        raise UsageError(f"{text}: they are for a program, such as one with the generated code")


def opening_objection(link: LinkLayout, place: str) -> str:
    """Why a link is not at a place; empty where it can be."""
    return can_objection(link, place) or (f"{link.name} has an open identifier" if link.open_identifier else "")


def opened(link: LinkLayout, arguments: argparse.Namespace) -> Carrier:
    """The carrier at `--port`. Raises UsageError and CarrierError."""
    place = arguments.port
    if not place:
        places = ", ".join(f"{protocol}://HOST" for protocol, _ in link.link.ports)
        places = places or "/dev/ttyUSB0, socket://HOST:PORT, tcp://HOST:PORT, can://socketcan/can0"
        raise UsageError(f"say where the device is: --port {places}")
    _refuse_open_identifier(link)
    wrong = can_objection(link, place)
    if wrong:
        raise UsageError(wrong)
    place = completed_place(link, place)
    if place.startswith("can://"):
        from fieldspec.tools.carriers.can_bus import CanBus

        return CanBus(place)
    if place.startswith("tcp://"):
        return Connection.opened(place)
    if place.startswith("udp://"):
        return Datagrams(place, server=False)
    return SerialPort(place, line_settings(link, arguments))


def line_settings(link: LinkLayout, arguments: argparse.Namespace) -> LineSettings:
    """The settings of a serial line: the requested ones, and the factory settings for the others."""
    return settings_of(link.link, arguments.baud, arguments.parity, arguments.data_bits)


def fixed_values(layout: DeviceLayout, link: LinkLayout, arguments: argparse.Namespace) -> dict[str, Raw]:
    """The values of `--with` for all requests, by name. Raises UsageError."""
    return dict(_fixed_value(layout, link, text) for text in arguments.fixed)


def client_at(
    layout: DeviceLayout,
    chosen: LinkLayout,
    arguments: argparse.Namespace,
    carrier: Carrier,
    fixed: Mapping[str, Raw],
) -> Client:
    """A client over a carrier, with the settings that are requested and the `fixed` values of all requests.

    Raises UsageError.
    """
    link = chosen.link
    unit = _unit_address(layout, chosen, arguments)
    settings = line_settings(chosen, arguments)
    pause = arguments.pause
    if pause is None:
        printed = float(link.silence_milliseconds or 0) / 1000
        pause = max(printed, settings.seconds(float(link.silence_characters or 0)))
    timing = Timing(arguments.timeout or _TIMEOUT, pause, arguments.retries)

    def trace(direction: str, frame: bytes) -> None:
        print_note(f"{direction} {frame.hex(' ').upper()}")

    return Client(layout, link.name, carrier, unit, timing, trace=trace if arguments.trace else None, fixed=fixed)


def _unit_address(layout: DeviceLayout, chosen: LinkLayout, arguments: argparse.Namespace) -> int:
    """The requested unit address, or the lowest of the link. Raises UsageError."""
    addresses, requested = chosen.link.unit_addresses, arguments.unit
    ranges = addresses.ranges if addresses is not None else None
    if chosen.request.role("unit_address") is None:
        if requested is not None:
            raise UsageError(f"requests on {chosen.name} have no unit address; leave out --unit")
        return usual_unit_address(layout)
    if requested is not None:
        if ranges is not None and requested not in ranges:
            raise UsageError(f"the unit address {requested} is not in {ranges.text()}")
        return int(requested)
    unit = usual_unit_address(layout)
    if ranges is not None and unit not in ranges:
        unit = ranges.low
    return unit


def settings_text(layout: DeviceLayout, link: LinkLayout, arguments: argparse.Namespace, unit: int) -> str:
    """The settings with which a device is reached: `DEVICE: link NAME, 19200 baud, ..., unit address 1`."""
    line = [line_settings(link, arguments).text] if arguments.port and has_line_settings(arguments.port) else []
    address = [f"unit address {unit}"] if link.request.role("unit_address") is not None else []
    return f"{layout.device.id}: {', '.join([f'link {link.name}', *line, *address])}"


def unit_address_text(unit: int) -> str:
    """The remark of a verb on the default unit address."""
    return f"unit address {unit}; --unit NUMBER chooses another"


def unit_address_option(layout: DeviceLayout, link: str | None, pairs: Sequence[str]) -> tuple[list[str], int | None]:
    """The assignments `NAME=VALUE` without that of the unit address of a link, and its value. Raises UsageError."""
    part = layout.links[link].request.role("unit_address") if link and link in layout.links else None
    own = [pair for pair in pairs if part is not None and pair.partition("=")[0] in (part.name, "unit")]
    rest = [pair for pair in pairs if pair not in own]
    if not own:
        return rest, None
    text = own[-1].partition("=")[2]
    if not text.isdecimal():
        raise UsageError(f"`{own[-1]}` is not a unit address; write a number, such as {own[-1].partition('=')[0]}=1")
    return rest, int(text)


def fixed_options(layout: DeviceLayout, link: str, pairs: Sequence[str]) -> tuple[list[str], list[str]]:
    """The assignments to values by name, then the assignments to what requests need and no spec states."""
    fields = {name for name in _open_fields(layout, layout.links[link]) if layout.device.register(name) is None}
    fixed = [pair for pair in pairs if pair.partition("=")[0] in fields]
    return [pair for pair in pairs if pair not in fixed], fixed


def _fixed_value(layout: DeviceLayout, link: LinkLayout, text: str) -> tuple[str, Raw]:
    """The name and the raw value of a field of requests, from `NAME=VALUE`. Raises UsageError."""
    name, equals, entered = text.partition("=")
    if not equals:
        raise UsageError(f"--with {text} has no value; write it as NAME=VALUE, such as axis=0")
    fields = _open_fields(layout, link)
    if name not in fields:
        raise unknown(f"open field of requests on {link.name}", name, fields)
    value = fields[name]
    try:
        return name, encoded_value(name, value, raw_value(layout.device, name, value, entered), layout.device)
    except (MeaningError, CodecError) as error:
        raise UsageError(f"{text}: {error}") from None


def _open_fields(layout: DeviceLayout, link: LinkLayout) -> dict[str, Value]:
    """What requests need that no spec states, by name: parts before the body, and fields of those for parameters."""
    messages = [
        parameter_message(link, parameter_set, operation)
        for parameter_set in layout.device.parameters.values()
        for operation in ("read", "write")
    ]
    requests = [message.request for message in messages if message is not None]
    parts = {part.part.name: part.part.value for part in open_parts(link) if part.numbering is None}
    fields = {
        field.name: field.value
        for request in requests
        for field in request.fields
        if field.value is not None
        and field.value.parameter is None
        and field.value.const is None
        and not (field.is_list or field.field.reserved or field.field.measures)
        and field is not request.selector
        and (part_of(request, "subindex") is None or field is not count_field(request))
    }
    return {**{name: value for name, value in parts.items() if value is not None}, **fields}


def unsent(error: CodecError) -> UsageError:
    """That a request lacks a value, or cannot carry one."""
    advice = "; add it with --with NAME=VALUE" if error.reason == "missing_value" else ""
    return UsageError(f"a request cannot be sent: {error}{advice}")
