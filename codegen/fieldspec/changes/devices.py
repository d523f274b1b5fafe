"""A whole device that is there on one side only."""

from __future__ import annotations

from fieldspec.changes.change import Change, Effect
from fieldspec.changes.nouns import ALL
from fieldspec.model.device import Device


def device_added(device: Device) -> Change:
    """That a device is new."""
    text = f"the device {device.id} is new"
    return Change("fact_added", Effect.BEHAVIOUR, "device", device.id, text, "", device.name, None, device.place["id"])


def device_removed(device: Device) -> Change:
    """That a device is gone, and with it everything that is generated for it."""
    text = f"the device {device.id} is gone"
    return Change(
        "fact_removed", Effect.SOURCE, "device", device.id, text, device.name, "", device.place["id"], None, ALL
    )
