"""Findings of examples that are worked out once, however many versions and prints share an example and its meaning."""

from __future__ import annotations

from typing import TYPE_CHECKING

from fieldspec.checks.laying_out import can_be_laid_out
from fieldspec.diagnostics import Diagnostic
from fieldspec.layout.device import DeviceLayout, device_layout
from fieldspec.model.device import Device

if TYPE_CHECKING:
    from fieldspec.model.example import Example
    from fieldspec.reference.device import DeviceCodec

Meaning = tuple[int, ...]


class Remembered:
    """What is found of the examples of a device at its versions, and with prints put back.

    What is built of the same rows is the same object, so that devices which give examples the same meaning are known by
    the objects that they hold.
    """

    def __init__(self) -> None:
        self._laid: dict[Meaning, tuple[DeviceLayout, DeviceCodec] | None] = {}
        self._known: dict[tuple[Meaning, int], list[Diagnostic]] = {}
        self._devices: list[Device] = []  # as long as they are there, no other objects have their identities

    def findings(self, device: Device, sound: bool = False) -> list[Diagnostic]:
        """The findings of a device's examples; none of one that cannot be laid out, as a `sound` one is known to be."""
        if not device.examples:
            return []  # nobody waits for the reference and its library
        meaning = _meaning(device)
        if meaning not in self._laid:
            self._devices.append(device)
            self._laid[meaning] = _laid(device) if sound or can_be_laid_out(device) else None
        laid = self._laid[meaning]
        if laid is None:
            return []
        return [found for example in device.examples.values() for found in self._of(meaning, laid, device, example)]

    def _of(
        self, meaning: Meaning, laid: tuple[DeviceLayout, DeviceCodec], device: Device, example: Example
    ) -> list[Diagnostic]:
        key = meaning, id(example)
        if key not in self._known:
            from fieldspec.proofs.examples import example_proven

            self._devices.append(device)
            self._known[key] = [*example_proven(*laid, example)]
        return self._known[key]


def _laid(device: Device) -> tuple[DeviceLayout, DeviceCodec]:
    from fieldspec.reference.device import codec

    layout = device_layout(device)
    return layout, codec(layout)


def _meaning(device: Device) -> Meaning:
    """The identities of all objects that decide what the values in a frame are; what they are for does not count."""
    held = (device.links, device.messages, device.records, device.enums, device.flags)
    return tuple(id(one) for named in held for one in named.values())
