"""`fieldspec check`: all findings in the specs."""

from __future__ import annotations

import argparse

from fieldspec.command.console.terminal import print_findings
from fieldspec.command.sources import spec_files, specs
from fieldspec.language.diagnostics import has_errors


def run(arguments: argparse.Namespace) -> int:
    """Prints all findings of all files. Exit code 1 where one of them is an error. Raises UsageError."""
    from fieldspec.command import pipeline
    from fieldspec.command.packages.plugin_loading import load_checks

    load_checks()
    project = specs.project(arguments.specs, frozenset(arguments.devices))
    findings = pipeline.checked(project)
    checked = ", ".join(sorted(project.devices)) or "nothing"
    origin = "" if spec_files.is_own(arguments.specs) else " (the installed specs, as there is no folder specs here)"
    print_findings(findings, arguments.format, f"no findings in {checked}{origin}")
    return 1 if has_errors(findings) else 0
