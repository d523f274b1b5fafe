"""Reads where the tables of a device begin whose addresses the device says."""

from __future__ import annotations

from collections.abc import Iterable

from fieldspec.codec.explain.occupants import base_of_table
from fieldspec.codec.layout.bases import at_bases, moving_tables
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.value_texts import spec_text
from fieldspec.tools.live.client import Client
from fieldspec.tools.live.reading import blocks, read


def read_bases(client: Client, layout: DeviceLayout, names: Iterable[str]) -> dict[str, int | str]:
    """The addresses of the first elements of tables by their names, or the reason why one is not known.

    Raises NoAnswerError and CarrierError.
    """
    bases: dict[str, int | str] = {}
    for name in names:
        register = base_of_table(layout, name)
        space = layout.device.space_name(moving_tables(layout)[name].register.space)
        for value in read(client, blocks(layout, [(space, register)])):
            number = value.decoded.number if value.decoded is not None else None
            ranges = register.value.ranges
            if isinstance(number, int) and ranges is not None and number in ranges:
                bases[name] = number
            else:
                reason = (
                    value.refusal or f"it is {spec_text(number)}, which is not within {ranges.text() if ranges else ''}"
                )
                bases[name] = f"{register.path} does not say where {name} begins: {reason}"
    return bases


def known_bases(client: Client, layout: DeviceLayout) -> dict[str, int]:
    """The addresses of the first elements of all tables whose addresses the device says.

    Raises NoAnswerError and CarrierError.
    """
    bases = read_bases(client, layout, moving_tables(layout))
    return {name: base for name, base in bases.items() if isinstance(base, int)}


def located(client: Client, layout: DeviceLayout) -> DeviceLayout:
    """A layout whose tables begin where the device says. Raises NoAnswerError and CarrierError."""
    return at_bases(layout, known_bases(client, layout))
