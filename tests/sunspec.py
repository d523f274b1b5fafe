"""The made-up inverter with models of SunSpec: its generated code, what is at its addresses, and a simulated one."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from contextlib import contextmanager

from fieldspec.codec.explain.occupants import Occupant, occupants
from fieldspec.codec.explain.spans import Span
from fieldspec.testing import SimulatedDevice, simulation
from layouts import TEST_SPECS, newest
from python_package import module_of

LAYOUT = newest(TEST_SPECS, "inverter")
INVERTER = module_of(LAYOUT)
CLIENT = importlib.import_module(f"{INVERTER.__name__.rpartition('.')[0]}.client")
OCCUPANTS = {own.path: own for own in occupants(LAYOUT, Span("", 0, 0x10000, 0, b""))}
SECONDS = 60


@contextmanager
def simulated_inverter() -> Iterator[SimulatedDevice]:
    """An inverter with two modules, served over TCP."""
    with simulation("inverter", ports={"tcp": "tcp://127.0.0.1:0"}, folder=str(TEST_SPECS)) as running:
        put(running, "module_count", 2)
        put(running, "tracker_length", 48)
        yield running


def address(device: SimulatedDevice) -> tuple[str, int]:
    """The host and the port of a simulated device."""
    return "127.0.0.1", int(device.place.rpartition(":")[2])


def occupant(path: str) -> Occupant:
    """What is at the addresses of a path."""
    return OCCUPANTS[path]


def put(device: SimulatedDevice, path: str, raw: int) -> None:
    """Sets the raw value of a register or of a field."""
    device.simulation.engine.memory.write("", occupant(path), raw)
