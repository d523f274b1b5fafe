"""The broadcast address is not the unit address of a station, and it fits the part that carries unit
addresses.

Why: no station answers a broadcast request. A station with that address could never be read.

Example: stations 0..15 with `broadcast: 0`.

Fix: Correct the range or the address, and write an erratum if the manual prints it that way.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label, type_text
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count


def broadcast_apart(device: Device) -> Findings:
    for link in device.links.values():
        stations = link.unit_addresses
        if stations is None or stations.broadcast is None:
            continue
        if stations.ranges is not None and stations.broadcast in stations.ranges:
            text = f"{stations.broadcast} is the broadcast address and also a unit address"
            related_label = label(stations.place, "range", "the stations")
            yield finding(stations.place, "broadcast", text, "correct one of them", related_label)
        part = next((part for part in link.request if part.role == "unit_address" and part.value), None)
        value = part.value if part is not None else None
        if value is None or not is_count(value.encoding):
            continue
        if not value.low <= stations.broadcast <= value.high:
            text = f"the address {stations.broadcast} does not fit {type_text(value)}"
            yield finding(stations.place, "broadcast", text, "correct the address or the type")
