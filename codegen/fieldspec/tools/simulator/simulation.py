"""A simulated device on its carriers, each served by a thread."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.foundation.classes import TYPE_CHECKING
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.language.model.link import Link
from fieldspec.tools.carriers.carrier import Carrier, CarrierError, LineSettings
from fieldspec.tools.carriers.sockets import Datagrams, Listener
from fieldspec.tools.carriers.terminals import PseudoTerminal, SerialPort
from fieldspec.tools.simulator import codecs
from fieldspec.tools.simulator.bare_requests import bare_decoder, has_bare_requests
from fieldspec.tools.simulator.clock import Clock, SystemClock
from fieldspec.tools.simulator.engine import Engine
from fieldspec.tools.simulator.faults import Fault, Faults, hold, is_lasting
from fieldspec.tools.simulator.line import Line, Sending, timing
from fieldspec.tools.simulator.server import Server

if TYPE_CHECKING:
    from types import ModuleType

LEAST_SILENCE = 0.02
"""The seconds of silence that end a frame at the least: pseudo-terminals and networks do not keep shorter ones."""

PATIENCE = 5.0
"""The seconds without a byte after which a part of a frame is dropped on a network, which may be slow."""

NETWORK_PAUSE = 0.3
"""The seconds that a network may take to send lost bytes again. Shorter pauses over a network prove nothing."""

TrafficListener = Callable[[float, str, str, bytes, str], None]


class Simulation:
    """A simulated device. `message` names the cyclic message in use, or is empty."""

    def __init__(
        self,
        layout: DeviceLayout,
        behaviour: Behaviour,
        *,
        unit_address: int = 1,
        message: str = "",
        clock: Clock | None = None,
        faults: Iterable[Fault] = (),
        seed: int = 0,
    ) -> None:
        self.layout, self.behaviour, self.message = layout, behaviour, message
        self.clock: Clock = clock or SystemClock()
        self.started = self.clock.now()
        self.engine = Engine(layout, behaviour, message)
        self._module: ModuleType = codecs.device_module(layout)
        decoders = {
            name: bare_decoder(codecs.link_codec(self._module, name), link)
            for name, link in layout.links.items()
            if has_bare_requests(link)
        }
        self.server = Server(self.engine, unit_address, decoders)
        self.faults = Faults((), seed)
        self.listeners: list[TrafficListener] = []
        self.lock = threading.RLock()
        self.places: list[tuple[str, str]] = []
        """The links, each with the place where it is served."""
        self._threads: list[threading.Thread] = []
        self._closers: list[Callable[[], None]] = []
        self._releases: list[Callable[[], None]] = []
        self._ended = threading.Event()
        for fault in faults:
            self.add_fault(fault)

    def now(self) -> float:
        """The seconds since the simulation began."""
        return self.clock.now() - self.started

    def advance(self) -> None:
        """Brings the device to the present time."""
        with self.lock:
            self.engine.advance(self.now())

    def add_fault(self, fault: Fault) -> None:
        """Adds a fault. Raises FaultError for one that this device cannot have."""
        with self.lock:
            if is_lasting(fault):
                hold(self.server, fault)
            else:
                self.faults.add(fault)

    def line(self, link: str, framed: bool = True) -> Line:
        """A new connection to a link. Datagrams are not `framed`: each is a frame."""

        def framing() -> codecs.Framer | None:
            return codecs.framer(self._module, link, "request") if framed else None

        return Line(self.server, link, framing, self.faults, self._tell, self.message)

    def _tell(self, now: float, link: str, direction: str, data: bytes, text: str) -> None:
        for listener in self.listeners:
            listener(now, link, direction, data, text)

    def serve(self, link: str, place: str, settings: LineSettings) -> str:
        """Serves a link at a place: `pty`, `tcp://HOST:PORT`, `udp://HOST:PORT`, a serial port, a CAN bus.

        An address without a port has the one that the spec states. Returns the place that others open. Raises
        CarrierError.
        """
        place = completed_place(self.layout.links[link], place)
        wrong = can_objection(self.layout.links[link], place)
        if wrong:
            raise CarrierError(wrong)
        if place.startswith("tcp://"):
            listener = Listener(place)
            name = listener.name
            self._closers.append(listener.close)
            self._start(lambda: self._accept(link, listener, settings))
        else:
            carrier = self._carrier(place, settings)
            name = carrier.name
            self._closers.append(carrier.close)
            self._start(lambda: self._run(link, carrier, settings))
        self.places.append((link, name))
        return name

    def serve_browsers(self, port: int) -> dict[str, str]:
        """Serves all links to browsers on this machine; 0 chooses a port. Returns the address of each link.

        Raises CarrierError.
        """
        from fieldspec.tools.carriers.web import WebServer

        links = self.layout.links
        datagrams = {name: link.link.is_can or usual_place(link).startswith("udp://") for name, link in links.items()}
        settings = {name: settings_of(link.link) for name, link in links.items()}
        server = WebServer(port, datagrams, lambda link, carrier: self._run(link, carrier, settings[link]))
        self._closers.append(server.close)
        addresses = {name: server.address(name) for name in links}
        self.places += addresses.items()
        return addresses

    def _carrier(self, place: str, settings: LineSettings) -> Carrier:
        if place == "pty":
            terminal = PseudoTerminal()
            self._releases.append(terminal.release)
            return terminal
        if place.startswith("can://"):
            from fieldspec.tools.carriers.can_bus import CanBus

            return CanBus(place)
        return Datagrams(place, server=True) if place.startswith("udp://") else SerialPort(place, settings)

    def _start(self, work: Callable[[], None]) -> None:
        thread = threading.Thread(target=work, daemon=True)
        self._threads.append(thread)
        thread.start()

    def _accept(self, link: str, listener: Listener, settings: LineSettings) -> None:
        try:
            while not self._ended.is_set():
                connection = listener.accept()
                if connection is not None:
                    self._closers.append(connection.close)
                    self._start(lambda connection=connection: self._run(link, connection, settings))  # type: ignore[misc]
        except CarrierError:
            return

    def _run(self, link: str, carrier: Carrier, settings: LineSettings) -> None:
        """Serves a carrier until it ends."""
        line = self.line(link, framed=not carrier.datagrams)
        silence = self.silence(link, settings)
        waited = 0.0
        try:
            while not self._ended.is_set():
                seconds = silence if line.waiting else 0.2
                data = carrier.read(seconds)
                waited = 0.0 if data else waited + seconds
                with self.lock:
                    if data:
                        sendings = list(line.feed(self.now(), data))
                    else:
                        ended = carrier.keeps_pauses or waited >= self._patience(line, silence)
                        sendings = list((line.idle if ended else line.pause)(self.now()))
                for sending in sendings:
                    self._send(carrier, sending)
        except CarrierError:
            pass
        finally:
            carrier.close()

    def _patience(self, line: Line, silence: float) -> float:
        """The seconds without a byte after which the bytes so far are dropped on a network.

        A pause that the behaviour states is kept there too, and the rest of a damaged frame is not awaited.
        """
        is_known = line.is_damaged or timing(self.server, "receive_gap")
        return max(silence, NETWORK_PAUSE) if is_known else PATIENCE

    def _send(self, carrier: Carrier, sending: Sending) -> None:
        if sending.hang_up:
            raise CarrierError("a fault closes the connection")
        self.clock.sleep(sending.seconds)
        carrier.write(sending.data)

    def silence(self, link: str, settings: LineSettings) -> float:
        """The seconds of silence after which what has come is no longer waited for."""
        stated = timing(self.server, "receive_gap")
        spoken = self.layout.links[link].link
        characters = float(spoken.silence_characters or 0)
        return max(stated, settings.seconds(characters), LEAST_SILENCE)

    def close(self) -> None:
        """Ends all threads and closes all carriers."""
        self._ended.set()
        for close in self._closers:
            close()
        for thread in self._threads:
            if thread is not threading.current_thread():
                thread.join(5.0)
        for release in self._releases:
            release()
        self._releases.clear()

    def __enter__(self) -> Simulation:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()


def settings_of(
    link: Link, baud: int | None = None, parity: str | None = None, data_bits: int | None = None
) -> LineSettings:
    """The settings of a serial line: the factory settings of the spec, or others that are requested."""
    serial = link.serial
    if serial is None:
        return LineSettings(baud or 9600, data_bits or 8, parity or "none", 1)
    return LineSettings(
        baud or serial.factory_baud,
        data_bits or serial.factory_data_bits,
        parity or serial.factory_parity,
        serial.factory_stop_bits,
    )


def can_objection(link: LinkLayout, place: str) -> str:
    """Why a link is not at a place: CAN frames go over a CAN bus, and nothing else does; empty where it may be."""
    if link.link.is_can and not place.startswith("can://"):
        return f"{link.name} is a CAN bus; write where it is as can://INTERFACE/CHANNEL, as in can://socketcan/can0"
    if place.startswith("can://") and not link.link.is_can:
        return f"{link.name} is not a CAN bus; use a serial port, tcp://HOST:PORT or udp://HOST:PORT"
    return ""


def completed_place(layout: LinkLayout, place: str) -> str:
    """A place whose address has no port, with the port that the spec states for the link, if it does."""
    protocol, _, host = place.partition("://")
    port = dict(layout.link.ports).get(protocol)
    has_port = not host or host.rpartition("]")[2].rpartition(":")[1]
    return place if port is None or has_port else f"{place.rstrip('/')}:{port}"


def stated_place(layout: LinkLayout) -> str:
    """Where a link is served on this machine: at the port that the spec states, or at the usual place."""
    ports = layout.link.ports
    if layout.link.serial is not None or not ports:
        return usual_place(layout)
    return f"{ports[0][0]}://127.0.0.1:{ports[0][1]}"


def usual_place(layout: LinkLayout) -> str:
    """The place at which a link is served where none is stated.

    Serial links are on a pseudo-terminal, other frames in a stream on TCP; what has neither length, nor delimiters, nor
    checksum comes in datagrams. Nothing says on which bus CAN frames are.
    """
    if layout.link.serial is not None:
        return "pty"
    if layout.link.is_can:
        return "can://"
    shape = layout.request
    streams = shape.role("length") is not None or shape.start or shape.end or shape.checksums
    return "tcp://127.0.0.1:0" if streams else "udp://127.0.0.1:0"


def usual_unit_address(layout: DeviceLayout) -> int:
    """The default unit address: the lowest of a link except the broadcast address."""
    for link in layout.device.links.values():
        addresses = link.unit_addresses
        if addresses is not None and addresses.ranges is not None:
            low = addresses.ranges.low
            return low if low != addresses.broadcast else low + 1
    return 1
