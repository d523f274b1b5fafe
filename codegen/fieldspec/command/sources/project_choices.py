"""Finds the project file beside a folder of specs, and reads what it chooses."""

from __future__ import annotations

import os

from fieldspec.command.console.usage import UsageError
from fieldspec.command.files.regular_file import IrregularError, content
from fieldspec.command.sources.spec_files import INSTALLED, relative_path
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass, field
from fieldspec.language.model.choice import DEFAULT_FOLDER, PROJECT_FILE, Choice
from fieldspec.language.reading.findings import LARGEST_FILE

if TYPE_CHECKING:
    from collections.abc import Iterable

    from fieldspec.language.diagnostics import Diagnostic
    from fieldspec.language.reading.device_spec import DeviceSpec
    from fieldspec.language.reading.project_file import ProjectFile


@dataclass(frozen=True, slots=True)
class ProjectChoices:
    """The project file beside a folder of specs: its bytes, None where there is none, and what is wrong with it.

    `place` is the folder that the folders of outputs begin at, empty for the current one.
    """

    data: bytes | None
    place: str
    file: ProjectFile | None = None
    findings: tuple[Diagnostic, ...] = field(default=())

    def choice(self, device: str) -> Choice:
        """The choices of the file for a device."""
        return self.file.choice(device) if self.file is not None else Choice()

    def folder(self, device: str) -> str:
        """The folder of the outputs of a device."""
        return os.path.join(self.place, self.choice(device).folder if self.file is not None else DEFAULT_FOLDER)

    def unknown_names(self, devices: Iterable[str]) -> list[Diagnostic]:
        """The errors of the file, and the findings of unknown outputs and devices."""
        from fieldspec.targets import OUTPUTS

        if self.file is None:
            return [*self.findings]
        with_blocks = [name for name, output in OUTPUTS.items() if output.has_blocks]
        return [*self.findings, *self.file.unknown_names(OUTPUTS, devices, with_blocks)]

    def unknown_parts(self, spec: DeviceSpec) -> list[Diagnostic]:
        """The findings of versions and blocks that a device does not have."""
        if self.file is None:
            return []
        findings = [*self.file.unknown_versions(spec.id, spec.versions())]
        if self.choice(spec.id).blocks is not None:
            device, _ = spec.at(spec.versions()[-1])
            known = {
                "tasks": [task.name for task in device.tasks if task.steps],
                "messages": [*device.messages],
                "registers": [register.name for register in device.registers()],
                "links": [*device.links],
            }
            known["registers"] += [*(group.name for group in device.groups), *device.tables]
            findings += self.file.unknown_blocks(spec.id, known)
        return findings


def project_choices(specs_folder: str) -> ProjectChoices:
    """The project file beside a folder of specs. Raises UsageError for a file that cannot be read."""
    place = os.path.dirname(os.path.abspath(specs_folder))  # beside a link, too
    path = os.path.join(place, PROJECT_FILE)
    if specs_folder == INSTALLED:
        return ProjectChoices(None, "")
    try:
        data = content(path, LARGEST_FILE)
    except FileNotFoundError:
        return ProjectChoices(None, "")
    except (OSError, IrregularError) as error:
        raise UsageError(f"cannot read {path}: {error.strerror}") from None
    from fieldspec.language.reading.project_file import read_project_file

    file, findings = read_project_file(relative_path(path), data)
    return ProjectChoices(data, relative_path(place), file, tuple(findings))
