"""`fieldspec check`: all findings in the specs."""

from __future__ import annotations

import argparse

from fieldspec.command.console.terminal import print_findings
from fieldspec.command.console.usage import UsageError
from fieldspec.command.sources import spec_files, specs
from fieldspec.command.sources.project_choices import project_choices
from fieldspec.language.diagnostics import Diagnostic, has_errors
from fieldspec.language.reading.project import Project


def run(arguments: argparse.Namespace) -> int:
    """Prints all findings of all files, and of the project file beside them.

    Exit code 1 where one of them is an error. Raises UsageError.
    """
    from fieldspec.command import pipeline
    from fieldspec.command.packages.plugin_loading import load_checks

    load_checks()
    for name in arguments.devices:
        device, version = spec_files.split(name)
        if version:
            raise UsageError(f"check judges all versions of a device; write {device}, without @{version}")
    project = specs.project(arguments.specs, frozenset(arguments.devices))
    findings = [*_of_project_file(arguments.specs, project), *pipeline.checked(project)]
    checked = ", ".join(sorted(project.devices)) or "nothing"
    origin = "" if spec_files.is_own(arguments.specs) else " (the installed specs, as there is no folder specs here)"
    print_findings(findings, arguments.format, f"no findings in {checked}{origin}")
    return 1 if has_errors(findings) else 0


def _of_project_file(specs_option: str | None, project: Project) -> list[Diagnostic]:
    """The findings of the project file, including unknown versions of the devices."""
    from fieldspec.command.packages.plugin_loading import load_outputs

    load_outputs()
    folder = spec_files.folder(specs_option)
    choices = project_choices(folder)
    findings = choices.unknown_names(spec_files.devices(folder))
    for spec in project.devices.values():
        findings += choices.unknown_parts(spec)
    return findings
