"""`fieldspec devices`: the devices and their versions."""

from __future__ import annotations

import argparse

from fieldspec.command.console.streams import print_error
from fieldspec.command.console.terminal import print_blocks
from fieldspec.command.rendering.blocks import Table
from fieldspec.command.sources import specs
from fieldspec.language.diagnostics import has_errors
from fieldspec.language.reading.device_spec import DeviceSpec

_HEADINGS = ("device", "name", "vendor", "versions", "registers", "parameters", "messages", "examples", "errata")


def run(arguments: argparse.Namespace) -> int:
    """Prints a row for each device, with counts at its newest version. Exit code 1 where a device cannot be read.

    Raises UsageError.
    """
    project = specs.project(arguments.specs)
    print_blocks([Table(_HEADINGS, tuple(_device_row(name, spec) for name, spec in sorted(project.devices.items())))])
    if has_errors(project.findings):
        print_error("the specs have findings; see them with: fieldspec check")
        return 1
    return 0


def _device_row(name: str, spec: DeviceSpec) -> tuple[str, ...]:
    device, _ = spec.at(spec.versions()[-1])
    parameters = sum(len(words.parameters) for words in device.parameters.values())
    counts = (
        sum(1 for _ in device.registers()),
        parameters,
        len(device.messages),
        len(device.examples),
        len(device.errata),
    )
    return (name, device.name, device.vendor, ", ".join(spec.versions()), *map(str, counts))
