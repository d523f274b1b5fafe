"""The addresses of a device that no register or table occupies."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.addresses import SPACE, blocks
from fieldspec.language.model.ranges import merged, uncovered
from fieldspec.language.reading.device_spec import DeviceSpec

MOST = 8
"""How many free addresses are named: the first of each run of them."""


def free_addresses(spec: DeviceSpec, space: str, before: int | None, name: str) -> Iterator[int]:
    """The first of each run of free addresses of a space: after the fact at an address, then after all others.

    The addresses that the fact `name` occupies are free to it.
    """
    device, _ = spec.at(spec.versions()[-1])
    own_space = device.space_name(space)
    occupied = [block for block in blocks(device) if block.space == own_space and block.fact.name != name]
    free = [*uncovered(0, SPACE - 1, merged((block.first, block.last) for block in occupied))]
    start = 0
    if before is not None:
        start = max((block.last for block in occupied if block.first <= before <= block.last), default=before) + 1
    elif occupied:
        start = min(block.first for block in occupied)
    runs = [(max(low, start), high) for low, high in free if high >= start]
    yield from (low for low, _ in runs[:MOST])
