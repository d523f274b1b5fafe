"""Lists of points in files, and the verbs and simulated devices that exchange them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from fieldspec.cli import main
from fieldspec.codec.explain.occupants import Occupant
from fieldspec.codec.layout.values import Raw
from fieldspec.testing import SimulatedDevice
from simulators import SPECS

HEAD = "Device,Version,Table,Index,"
WRITES = (0x06, 0x10)


def command(device: SimulatedDevice, *arguments: str, name: str = "tc100") -> list[str]:
    """The arguments of a verb."""
    place = device.place.replace("tcp://", "socket://")
    link = device.simulation.places[0][0]
    return ["live", name, *arguments, "--link", link, "--port", place, "--timeout", "0.3", "--specs", SPECS]


def live(device: SimulatedDevice, *arguments: str, name: str = "tc100") -> int:
    """The exit code of a verb."""
    return main(command(device, *arguments, name=name))


def placed(device: SimulatedDevice, path: str) -> tuple[str, Occupant]:
    """What has a path in the memory of a device."""
    known = device.simulation.engine.memory.occupants.items()
    return next((space, own) for (space, _), present in known for own in present if own.path == path)


def value_of(device: SimulatedDevice, path: str) -> Raw:
    """The raw value of a register, or of a field of a point."""
    return device.simulation.engine.memory.read(*placed(device, path))


def set_values(device: SimulatedDevice, values: Mapping[str, int]) -> None:
    """Sets registers and fields of points."""
    for path, raw in values.items():
        device.simulation.engine.memory.write(*placed(device, path), raw)


def speeds(device: SimulatedDevice) -> list[Raw]:
    """The speeds of the first five points."""
    return [value_of(device, f"points[{number}].speed") for number in range(1, 6)]


def points_file(folder: Path, *lines: str, head: str = f"{HEAD}speed,wait_time") -> str:
    """A CSV file with points."""
    path = folder / "points.csv"
    path.write_text("\n".join([head, *lines]) + "\n", "utf-8")
    return str(path)


def five_points(folder: Path) -> str:
    """A CSV file with five points that differ in their speed from those at delivery, one of them also in its wait."""
    return points_file(folder, *(f"tc100,2.0,points,{n},{10 * n} %,{'25 ms' if n == 2 else ''}" for n in range(1, 6)))


def writes_of(device: SimulatedDevice) -> list[bytes]:
    """A list that gets all requests to write."""
    writes: list[bytes] = []
    device.simulation.listeners.append(
        lambda now, link, way, data, text: writes.append(data) if way == "request" and data[1] in WRITES else None
    )
    return writes
