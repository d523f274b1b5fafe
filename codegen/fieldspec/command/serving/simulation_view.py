"""A view of a simulation in the terminal: signals, motion and traffic."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator

from textual.app import App, ComposeResult
from textual.containers import Horizontal
from textual.widgets import DataTable, Footer, Header, RichLog, Static

from fieldspec.foundation.line_text import visible_text
from fieldspec.language.behaviour.part import AXIS_PROPERTIES
from fieldspec.language.model.operand import Operand
from fieldspec.language.model.quantity import real_text
from fieldspec.tools.simulator.simulation import Simulation

_PERIOD = 0.2
_MOST_LINES = 500


class SimulationView(App[None]):
    """Signals with roles on the left, states and motion on the right, traffic below."""

    BINDINGS = [("q", "quit", "Quit"), ("p", "power", "Power cycle")]  # noqa: RUF012
    CSS = "#signals { width: 2fr; } #motion { width: 1fr; } #traffic { height: 40%; }"

    def __init__(self, simulation: Simulation) -> None:
        super().__init__()
        self.simulation = simulation
        self.waiting: deque[str] = deque(maxlen=_MOST_LINES)
        # Widgets are kept, not looked for: the clock also runs while the screen comes and goes.
        self.signals: DataTable[str] = DataTable(id="signals", cursor_type="row")
        self.motion = Static(id="motion")
        self.traffic = RichLog(id="traffic", max_lines=_MOST_LINES)
        simulation.listeners.append(self._noted)

    def compose(self) -> ComposeResult:
        """The widgets."""
        yield Header()
        with Horizontal():
            yield self.signals
            yield self.motion
        yield self.traffic
        yield Footer()

    def on_mount(self) -> None:
        """Fills the table and begins to watch."""
        device = self.simulation.layout.device
        places = ", ".join(f"{link}: {place}" for link, place in self.simulation.places)
        self.title, self.sub_title = f"{device.name} {device.version}", places
        self.signals.add_column("role")
        self.signals.add_column("signal")
        self.signals.add_column("value", key="value")
        for operand in self._watched():
            self.signals.add_row(", ".join(operand.roles), operand.path, "", key=operand.path)
        self.set_interval(_PERIOD, self.refresh_values)

    def refresh_values(self) -> None:
        """Shows the present values and the traffic since the last time."""
        simulation = self.simulation
        with simulation.lock:
            simulation.engine.advance(simulation.now())
            for operand in self._watched():
                cells = simulation.engine.cells.of(operand.path)
                if cells:
                    self.signals.update_cell(operand.path, "value", str(cells[0].read()))
            axis = [f"{name:16} {real_text(float(simulation.engine.of_axis(name)))}" for name in AXIS_PROPERTIES]
            states = [f"{name:16} {state}" for name, state in simulation.engine.states.items()]
        self.motion.update(visible_text("\n".join([f"{simulation.now():.1f} s", *states, *axis])))
        while self.waiting:
            self.traffic.write(self.waiting.popleft())

    def action_power(self) -> None:
        """Switches the device off and on."""
        with self.simulation.lock:
            self.simulation.engine.power_on()

    def _watched(self) -> Iterator[Operand]:
        """The signals with roles, in the message in use where they are in messages."""
        own = f"messages/{self.simulation.message}"
        for operand in self.simulation.engine.cells.names.operands.all:
            if operand.roles and operand.scope in ("registers", "parameters", "frames", own):
                yield operand

    def _noted(self, now: float, link: str, direction: str, data: bytes, text: str) -> None:
        arrow = ">" if direction == "request" else "<"
        self.waiting.append(visible_text(f"{now:10.3f} {link} {arrow} {data.hex(' ').upper()}  {text}"))


def show(simulation: Simulation) -> None:
    """Shows a simulation until it is ended."""
    SimulationView(simulation).run()
