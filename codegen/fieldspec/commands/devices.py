"""`fieldspec devices`: what there is."""

from __future__ import annotations

import argparse

from fieldspec.commands import specs
from fieldspec.commands.output import print_table
from fieldspec.commands.usage import UsageError
from fieldspec.diagnostics import has_errors


def run(arguments: argparse.Namespace) -> int:
    """Prints one row a device, counted at its newest version."""
    project = specs.project(arguments.specs)
    if has_errors(project.found):
        raise UsageError("the specs have findings; see them with: fieldspec check")
    rows = []
    for name, spec in sorted(project.devices.items()):
        device, _ = spec.at(spec.versions()[-1])
        counts = (sum(1 for _ in device.registers()), len(device.messages), len(device.examples), len(device.errata))
        rows.append([name, device.name, device.vendor, ", ".join(spec.versions()), *map(str, counts)])
    headings = ["device", "name", "vendor", "versions", "registers", "messages", "examples", "errata"]
    print_table(headings, rows)
    return 0
