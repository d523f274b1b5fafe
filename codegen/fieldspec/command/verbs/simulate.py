"""`fieldspec simulate`: a device made from its spec, on serial ports, CAN buses, networks and WebSockets."""

from __future__ import annotations

import argparse
import gc
import json
import sys
import threading
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.console.streams import print_error, print_json, print_note
from fieldspec.command.console.usage import UsageError, unknown
from fieldspec.command.files import list_files
from fieldspec.command.live.connection import unit_address_text
from fieldspec.command.rendering.blocks import Line, Table
from fieldspec.command.sources import specs
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.behaviour.part import ASSUMED, NOT_MODELLED, STANDINGS
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.language.model.link import Link
from fieldspec.language.model.record import Message
from fieldspec.tools.carriers.carrier import CarrierError, LineSettings
from fieldspec.tools.lists.dump import dump, dump_sheet
from fieldspec.tools.lists.list_file import content_sheet
from fieldspec.tools.lists.sheet import ListError
from fieldspec.tools.simulator.clock import SystemClock
from fieldspec.tools.simulator.control import CommandError, carried_out
from fieldspec.tools.simulator.faults import KINDS, Fault, FaultError, fault_of
from fieldspec.tools.simulator.reported_version import reported_version
from fieldspec.tools.simulator.server import Server
from fieldspec.tools.simulator.simulation import (
    Simulation,
    can_objection,
    settings_of,
    stated_place,
    usual_unit_address,
)

if TYPE_CHECKING:
    from typing import Any, TextIO

    from fieldspec.language.behaviour.part import Behaviour, Part


def run(arguments: argparse.Namespace) -> int:
    """Serves a device until it is interrupted. Raises UsageError."""
    if arguments.view and arguments.control:
        raise UsageError("--view and --control both use the terminal: use one of them")
    spec, version = specs.sound_at(arguments.specs, arguments.device)
    layout = specs.layout_of(spec, version)
    behaviour = behaviour_of(spec.tree_at(version))
    if arguments.assumptions:
        _print_assumptions(layout, behaviour)
        return 0
    if not layout.links:
        raise UsageError(f"{arguments.device} has no link, so there is nothing to serve")
    places = list(_places(layout, arguments.port)) if arguments.port or arguments.websocket is None else []
    settings = {link: _line_settings(layout.links[link].link, arguments) for link, _ in places}
    simulation = Simulation(
        layout,
        behaviour,
        unit_address=_unit_address(layout, arguments.unit),
        message=_message(layout, arguments.message),
        clock=SystemClock(arguments.rate),
        faults=list(_faults(arguments)),
        seed=arguments.seed,
    )
    report_silence(simulation.server)
    gc.freeze()
    gc.enable()  # a device may be served for long; what there is now stays
    if arguments.dump:
        _seed(simulation, arguments.dump)
    recording: TextIO | None = None
    try:
        if arguments.record:
            recording = Path(arguments.record).open("w", encoding="utf-8", newline="\n")  # noqa: SIM115
            simulation.listeners.append(_Recorder(recording).write)
        for link, place in places:
            name = _served(simulation, link, place, settings[link], is_stated=bool(arguments.port))
            print_note(f"{layout.device.id} {layout.device.version}, {link}: {name}")
        if arguments.websocket is not None:
            for link, name in _serve_browsers(simulation, arguments.websocket).items():
                print_note(f"{layout.device.id} {layout.device.version}, {link}: {name}")
        if arguments.unit is None and _has_unit_address(layout):
            print_note(unit_address_text(simulation.server.unit_address))
        if arguments.message is None and len(_cyclic_messages(layout)) > 1:
            print_note(f"message {simulation.message}; --message NAME chooses another")
        if arguments.view:
            from fieldspec.command.serving.simulation_view import show

            show(simulation)
        elif arguments.control:
            _control(simulation)
        else:
            threading.Event().wait()
    except CarrierError as error:
        raise UsageError(str(error)) from None
    except OSError as error:
        raise UsageError(f"cannot write {arguments.record}: {error.strerror}") from None
    finally:
        simulation.close()
        if recording is not None:
            recording.close()
    return 0


def _line_settings(link: Link, arguments: argparse.Namespace) -> LineSettings:
    """The settings of a serial line. Raises UsageError for a setting that the device does not have."""
    if link.serial is not None:
        serial = link.serial
        for option, number, choices in (
            ("baud", arguments.baud, serial.baud),
            ("parity", arguments.parity, serial.parity),
            ("data-bits", arguments.data_bits, serial.data_bits),
        ):
            if number is not None and choices and number not in choices:
                raise UsageError(f"{link.name} has no --{option} {number}; choose from {', '.join(map(str, choices))}")
    return settings_of(link, arguments.baud, arguments.parity, arguments.data_bits)


def _served(simulation: Simulation, link: str, place: str, settings: LineSettings, is_stated: bool) -> str:
    """Serves a link, and returns the place that others open. Raises UsageError and CarrierError."""
    try:
        return simulation.serve(link, place, settings)
    except CarrierError as error:
        if is_stated:
            raise
        host = place.rpartition(":")[0]
        raise UsageError(f"{error}; name another place, such as --port {link}={host}:0 for a free port") from None


def _serve_browsers(simulation: Simulation, port: int) -> dict[str, str]:
    """The addresses of the links. Raises UsageError and CarrierError."""
    try:
        return simulation.serve_browsers(port)
    except ModuleNotFoundError:
        raise UsageError("--websocket needs more packages: pip install 'fieldspec[live]'") from None


def _places(layout: DeviceLayout, ports: list[str] | None) -> Iterator[tuple[str, str]]:
    """The links that are served, each with its place. Raises UsageError."""
    if not ports:
        links = list(layout.links.values())
        # One serial line at a time, as on the device; what is not a serial line has no other to disturb.
        usual = layout.links[layout.device.default_link]
        serial = next((link for link in (usual, *links) if link.link.serial is not None), None)
        bus = next((link for link in links if link.link.is_can), None)
        if bus is not None and serial is None:
            raise UsageError(f"say on which bus {bus.name} is: --port {bus.name}=can://socketcan/can0")
        for link in [serial] if serial is not None else links:
            yield link.name, stated_place(link)
        return
    for port in ports:
        name, mark, place = port.partition("=")
        scheme, colon, _ = port.partition("://")
        if colon and scheme in layout.links and scheme != layout.device.default_link:
            raise UsageError(f"--port {port} names no link; write --port {scheme}={port}")
        if not colon and port.partition(":")[0] in layout.links:
            raise UsageError(f"--port {port} has no place; write --port {port.partition(':')[0]}=pty")
        if not mark or "://" in name:
            name, place = layout.device.default_link, port
        if name not in layout.links:
            raise unknown("link", name, layout.links)
        wrong = can_objection(layout.links[name], place)
        if wrong:
            raise UsageError(wrong)
        spoken = layout.links[name].link
        if place.startswith("udp://") and spoken.serial is not None and "udp" not in dict(spoken.ports):
            raise UsageError(f"the link {name} is a serial line; use pty, a serial port, or tcp://HOST:PORT")
        yield name, place


def _unit_address(layout: DeviceLayout, unit: int | None) -> int:
    """The unit address: the requested address, or the first that the device can have. Raises UsageError."""
    if unit is None:
        return usual_unit_address(layout)
    if not _has_unit_address(layout):
        raise UsageError(f"frames of {layout.device.id} have no unit address; leave out --unit")
    known = [link.unit_addresses.ranges for link in layout.device.links.values() if link.unit_addresses is not None]
    stated = [ranges for ranges in known if ranges is not None]
    if stated and not any(unit in ranges for ranges in stated):
        raise UsageError(f"the unit address {unit} is not in {stated[0].text()}")
    return unit


def _has_unit_address(layout: DeviceLayout) -> bool:
    """Whether the requests of a link name the unit that they are for."""
    return any(link.request.role("unit_address") is not None for link in layout.links.values())


def _cyclic_messages(layout: DeviceLayout) -> list[Message]:
    return [message for message in layout.device.messages.values() if message.number is not None]


def _message(layout: DeviceLayout, name: str | None) -> str:
    """The message in use on links whose frames do not name it. Raises UsageError."""
    cyclic = _cyclic_messages(layout)
    if name is None:
        return cyclic[0].name if cyclic else ""
    if not cyclic:
        raise UsageError(
            f"{layout.device.id} exchanges nothing cyclically, so --message has nothing to choose: leave it out"
        )
    for message in cyclic:
        if name in (message.name, str(message.number)):
            if message.supplements:
                raise UsageError(
                    f"{message.name} only supplements others; name one of {', '.join(message.supplements)}"
                )
            return message.name
    raise unknown("cyclic message", name, [message.name for message in cyclic])


def _faults(arguments: argparse.Namespace) -> Iterator[Fault]:
    """The faults of the options. Raises UsageError."""
    for text in arguments.fault or ():
        kind, _, chance = text.partition("=")
        try:
            yield fault_of({"fault": kind, "probability": float(chance or "nan")})
        except ValueError as error:
            if isinstance(error, FaultError) and chance:
                raise UsageError(f"--fault {text}: {error}") from None
            raise UsageError(f"--fault {text}: write it as KIND=PROBABILITY, as in {next(iter(KINDS))}=0.01") from None
    if not arguments.faults:
        return
    try:
        lines = Path(arguments.faults).read_text("utf-8").splitlines()
    except (OSError, UnicodeError) as error:
        raise UsageError(f"cannot read {arguments.faults}: {error}") from None
    for number, line in enumerate(lines, 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        try:
            data = json.loads(line)
            if not isinstance(data, dict):
                raise FaultError("a fault is a JSON object")
            yield fault_of(data)
        except json.JSONDecodeError:
            example = f'{{"fault": "{next(iter(KINDS))}", "probability": 0.01}}'
            raise UsageError(f"{arguments.faults}:{number}: this line is not JSON; write it as {example}") from None
        except ValueError as error:
            raise UsageError(f"{arguments.faults}:{number}: {error}") from None


def _seed(simulation: Simulation, name: str) -> None:
    """Writes the values of a dump to the device."""
    from fieldspec.tools.simulator.seeding import seed

    data = list_files.content(name)
    try:
        rows = dump(dump_sheet(data) or content_sheet(data), {})
    except ListError as error:
        raise UsageError(f"{name} {error}") from None
    count, unused = seed(simulation.engine, rows)
    print_note(f"{count} words from {name}" + (f", {unused} without a register" if unused else ""))


def _print_assumptions(layout: DeviceLayout, behaviour: Behaviour) -> None:
    from fieldspec.command.console.terminal import print_blocks

    reported = reported_version(layout, behaviour)
    if not behaviour.parts:
        text = f"{layout.device.id} has no behaviour: it answers with what is written, and nothing happens over time."
        if any(link.link.exception_response is not None for link in layout.links.values()):
            text += " It is silent where it refuses a request: no `refuse` says with which exception it answers."
        print_blocks([Line(text if reported is None else f"{text} At delivery, {reported.text}.")])
        return
    rows = [(part.name, part.standing, _source_text(part), _standing_text(part)) for part in behaviour.statements()]
    if reported is not None:
        rows.insert(0, ("version", ASSUMED, "", reported.text))
    stated = Counter(part.standing for part in behaviour.parts if part.sources)
    counts = ", ".join(f"{stated[standing]} {standing}" for standing in STANDINGS)
    unstated = sum(not part.sources for part in behaviour.parts)
    text = f"{stated.total()} statements of the manual: {counts}. {unstated} parts are about what it does not state."
    print_blocks(
        [Line(text), Table(("part", "standing", "manual", "what is assumed, or left out and why"), tuple(rows))]
    )


def _source_text(part: Part) -> str:
    return "; ".join(source.text() for source in part.sources) or part.standard


def _standing_text(part: Part) -> str:
    return f"{part.subject} {part['reason']}" if part.standing == NOT_MODELLED else part.assumed


def _control(simulation: Simulation) -> None:
    """Carries out commands from standard input, a JSON object in each line, until it ends."""
    for line in sys.stdin:
        if not line.strip():
            continue
        try:
            command: Any = json.loads(line)
            if not isinstance(command, dict):
                raise CommandError("a command is a JSON object")
            result = carried_out(simulation, command)
        except (CommandError, ValueError) as error:
            result = {"ok": False, "error": str(error)}
        print_json(result)
        sys.stdout.flush()


def report_silence(server: Server) -> None:
    """Prints why a device is silent where it should answer: each reason once, and no more than a screen takes."""
    printed: set[str] = set()

    def complain(reason: str) -> None:
        if reason not in printed and len(printed) < _MOST_REASONS:
            printed.add(reason)
            print_error(reason)

    server.complain = complain


_MOST_REASONS = 100


class _Recorder:
    """Writes traffic as lines that `fieldspec decode` reads: the time, the direction, the bytes, and a comment."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._lock = threading.Lock()

    def write(self, now: float, link: str, direction: str, data: bytes, text: str) -> None:
        """Writes a line with a frame."""
        if data:
            with self._lock:
                comment = text.replace("\n", " ").replace("#", "")
                self._stream.write(f"{now:.6f} {direction} {data.hex(' ').upper()}  # {link}: {comment}\n")
                self._stream.flush()
