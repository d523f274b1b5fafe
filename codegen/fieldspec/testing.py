"""Simulated devices for the tests of other projects.

    from fieldspec.testing import simulated

    drive = simulated("drive")          # a pytest fixture

    def test_it_answers(drive):
        client = MyClient(drive.place)

`simulation` is the same as a context manager.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import Any

from fieldspec.command.sources import specs
from fieldspec.language.behaviour.reading import behaviour_of
from fieldspec.tools.simulator.clock import Clock, ManualClock, SystemClock
from fieldspec.tools.simulator.control import carried_out
from fieldspec.tools.simulator.faults import fault_of
from fieldspec.tools.simulator.simulation import Simulation, settings_of, usual_place, usual_unit_address

__all__ = ["ManualClock", "SimulatedDevice", "simulated", "simulation"]


class SimulatedDevice:
    """A simulated device. `place` is where it is served, or the first of `places`, which has each link."""

    def __init__(self, running: Simulation) -> None:
        self.simulation = running

    @property
    def places(self) -> dict[str, str]:
        """The place of each link that is served: a path of a pseudo-terminal, or an address."""
        return dict(self.simulation.places)

    @property
    def place(self) -> str:
        """The place of the link that is served, or of the first one."""
        return self.simulation.places[0][1]

    def command(self, **command: Any) -> dict[str, Any]:
        """Carries out a command, such as `command(get=["actual_position"])`. Raises CommandError."""
        return carried_out(self.simulation, command)

    def value(self, signal: str) -> Any:
        """The raw value of a signal: a role, a path, or a property of the axis."""
        return self.command(get=[signal])["values"][signal]

    def set(self, **values: Any) -> None:
        """Sets signals by their roles."""
        self.command(set=values)

    def fault(self, kind: str, **details: Any) -> None:
        """Lets a fault strike at the next request, or as the details say."""
        self.command(fault=kind, **details)


@contextmanager
def simulation(
    device: str,
    *,
    ports: dict[str, str] | None = None,
    unit_address: int | None = None,
    message: str = "",
    rate: float = 1.0,
    clock: Clock | None = None,
    faults: Iterable[dict[str, Any]] = (),
    seed: int = 0,
    folder: str | None = None,
) -> Iterator[SimulatedDevice]:
    """A simulated device, `DEVICE` or `DEVICE@VERSION`, for as long as the context lasts.

    `ports` has the place of each link that is served: `pty`, `tcp://127.0.0.1:0`, `udp://127.0.0.1:0`, a serial port
    or `can://virtual/NAME`; without it, the link of the factory settings is served at its usual place.
    `folder` is the folder with the specs. Raises UsageError.
    """
    spec, version = specs.sound_at(folder, device)
    layout = specs.layout_of(spec, version)
    running = Simulation(
        layout,
        behaviour_of(spec.tree_at(version)),
        unit_address=usual_unit_address(layout) if unit_address is None else unit_address,
        message=message,
        clock=clock or SystemClock(rate),
        faults=[fault_of(fault) for fault in faults],
        seed=seed,
    )
    with running:
        usual = layout.device.default_link
        for link, place in (ports or {usual: usual_place(layout.links[usual])}).items():
            running.serve(link, place, settings_of(layout.links[link].link))
        yield SimulatedDevice(running)


def simulated(device: str, **options: Any) -> Callable[[], Iterator[SimulatedDevice]]:
    """A pytest fixture with a simulated device; the options are the options of `simulation`."""
    import pytest

    @pytest.fixture
    def simulated_device() -> Iterator[SimulatedDevice]:
        with simulation(device, **options) as running:
            yield running

    return simulated_device
