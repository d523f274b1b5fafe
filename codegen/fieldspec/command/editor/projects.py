"""The specs of a folder as they are in an editor: documents that are not saved stand in for the files."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from fieldspec.codec.layout.device import DeviceLayout, device_layout
from fieldspec.command.console.usage import UsageError
from fieldspec.command.editor.positions import moved
from fieldspec.command.sources import spec_files
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.classes import dataclass, field, replace
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.checks.layout_conditions import has_layout
from fieldspec.language.diagnostics import Diagnostic, Label, has_errors, in_order
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.findings import MAIN, PROTOCOLS, VERSIONS
from fieldspec.language.reading.memory import FileRead, Memory
from fieldspec.language.reading.project import Project, read
from fieldspec.tools.proofs.running import Outcome, outcome


def folder_of(path: Path) -> Path | None:
    """The folder of specs that a spec file belongs to, None for any other file. The file need not be there yet."""
    device = path.parent.parent if path.parent.name == VERSIONS else path.parent
    specs = device.parent
    if path.suffix != ".yaml":
        return None
    if device.name == PROTOCOLS:
        return specs if spec_files.devices(specs) else None
    return specs if path.name == MAIN or (device / MAIN).is_file() else None


@dataclass(slots=True)
class EditedProject:
    """The specs of a folder, read and judged again after each change, in one process that remembers the rest."""

    folder: Path
    manuals: Path | None = None
    project: Project = field(default_factory=lambda: Project({}, []))
    memory: Memory = field(default_factory=Memory)
    origins: Mapping[str, str] = field(default_factory=dict)
    outcomes: dict[str, tuple[DeviceSpec, Outcome]] = field(default_factory=dict)
    layouts: ByIdentity[DeviceSpec, dict[str, DeviceLayout | None]] = field(default_factory=lambda: ByIdentity(50))

    @property
    def manual_folder(self) -> Path:
        """The folder of the texts of manuals: the one that is named, or `manuals` beside the specs."""
        return self.manuals or self.folder.parent / "manuals"

    def read(self, unsaved: Mapping[Path, str]) -> None:
        """Reads the files, and the texts of documents in the editor in place of theirs. Raises UsageError."""
        from fieldspec.command.packages.plugin_loading import load_checks

        load_checks()
        contents = spec_files.files(self.folder) if self.folder.is_dir() else {}
        for path, text in unsaved.items():
            contents[path.relative_to(self.folder).as_posix()] = text.encode("utf-8", "surrogatepass")
        contents = spec_files.with_protocols(contents)
        self.origins = spec_files.origins(contents)
        self.memory.forget_others(contents.keys())
        installed = spec_files.installed_protocols
        self.project = read(contents, origins=self.origins, installed=installed, memory=self.memory)

    def outcome(self, device: str) -> Outcome:
        """The result of all checks and proofs of a device; the previous result if it has not changed since."""
        spec = self.project.devices[device]
        judged = self.outcomes.get(device)
        if judged is None or judged[0] is not spec:
            judged = self.outcomes[device] = spec, outcome(spec)
        return judged[1]

    def findings(self) -> list[Diagnostic]:
        """All findings, in order, at the places that they have in the documents.

        For an unreadable document, the results of its last valid text stay if that text has not changed.
        """
        findings = [*self.project.findings]
        for device in self.project.devices:
            findings += self.outcome(device).findings
        return in_order(placed for finding in findings if (placed := self._placed(finding)) is not None)

    def _placed(self, finding: Diagnostic) -> Diagnostic | None:
        span = self.current(finding.span)
        if span is None:
            return None
        labels = ((self.current(label.span), label.text) for label in finding.labels)
        return replace(finding, span=span, labels=tuple(Label(place, text) for place, text in labels if place))

    def current(self, span: Span) -> Span | None:
        """The place of a span in the text that its file has now; None where that has changed."""
        file = self.file(span.file.path)
        return span if file is None else moved(span, file)

    def file(self, display_path: str) -> SourceFile | None:
        """The file that findings show by a path."""
        for path in (display_path, *(path for path, origin in self.origins.items() if origin == display_path)):
            if path in self.memory.files:
                return self.memory.files[path].file
        return None

    def read_file(self, path: Path) -> FileRead | None:
        """A file as it was read; None for a file outside of the specs."""
        return self.memory.files.get(path.relative_to(self.folder).as_posix())

    def specs_with(self, file: SourceFile) -> list[DeviceSpec]:
        """The devices that a file belongs to: one, or those that use a protocol.

        A file in the folder of a device that is not a part of it yet, since it cannot be read, belongs to it too.
        """
        paths = {path for path, read in self.memory.files.items() if read.file.path == file.path}
        folders = {path.partition("/")[0] for path in paths} - {PROTOCOLS}
        specs = self.project.devices.values()
        return [spec for spec in specs if spec.id in folders or not paths.isdisjoint(spec.files)]

    def layout(self, spec: DeviceSpec, version: str) -> DeviceLayout | None:
        """The layout of a device at a version; None where it has none."""
        layouts = self.layouts.get_or_compute(spec, lambda _: {})
        if version not in layouts:
            device, broken = spec.at(version)
            sound = not has_errors(broken) and has_layout(device)
            layouts[version] = device_layout(device) if sound else None
        return layouts[version]

    def path(self, display_path: str) -> Path:
        """The path on this machine of a file that findings show by a path."""
        return self.folder / display_path


def project_in(folder: Path) -> EditedProject | None:
    """The project of a folder that has specs, or in which the folder of the specs is; None where there is none."""
    for path in (folder, folder / spec_files.FOLDER):
        if spec_files.devices(path):
            return EditedProject(path)
    return None


def named_project(specs_option: str) -> EditedProject:
    """The project of the folder that an option names. Raises UsageError where there is none."""
    path = Path(spec_files.folder(specs_option)).resolve()
    if not spec_files.devices(path):
        raise UsageError(f"the folder {path} contains no device; a device is a folder with a {MAIN}")
    return EditedProject(path)
