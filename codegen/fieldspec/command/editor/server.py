"""The server of the Language Server Protocol: it keeps the projects of the open documents, and sends their findings."""

from __future__ import annotations

import asyncio
import gc
import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.lsp.server import LanguageServer
from pygls.uris import from_fs_path, to_fs_path

from fieldspec import __version__
from fieldspec.command.console.usage import UsageError
from fieldspec.command.editor.cursor import Cursor, cursor
from fieldspec.command.editor.positions import Positions
from fieldspec.command.editor.projects import EditedProject, folder_of, named_project
from fieldspec.command.rendering.finding_text import marked_characters
from fieldspec.foundation.caches import ByIdentity
from fieldspec.foundation.line_text import visible_text
from fieldspec.foundation.source import SourceFile, Span
from fieldspec.language.diagnostics import Diagnostic, Severity
from fieldspec.language.reading.memory import FileRead

PAUSE = 0.05
"""Seconds without a key after which the specs are judged."""
IDLE = 2.0
"""Seconds without a key press after which garbage is collected, because the server runs for a long time."""

_SEVERITIES = {Severity.ERROR: types.DiagnosticSeverity.Error, Severity.WARNING: types.DiagnosticSeverity.Warning}


class Server(LanguageServer):
    """A server with the projects of all documents that have been opened, by folder.

    Editors send the whole text of a document: where lines end is not the same for YAML, for editors and for Python.
    """

    def __init__(self, specs_option: str | None = None, manuals: str | None = None) -> None:
        super().__init__("fieldspec", __version__, text_document_sync_kind=types.TextDocumentSyncKind.Full)
        self.projects: dict[Path, EditedProject] = {}
        self.manuals = folder_of_manuals(manuals) if manuals is not None else None
        self.shows_answers = False
        """Whether the editor shows what a command answers, as its extension for fieldspec says when it begins."""
        self._stale: set[Path] = set()
        """The folders of projects that have changed since they were read."""
        self._unjudged: set[Path] = set()
        """The folders of projects that have changed since their findings were sent."""
        self._marked: dict[Path, set[str]] = {}
        """The documents of each project that findings were sent for."""
        self._waiting: asyncio.TimerHandle | None = None
        self._tidying: asyncio.TimerHandle | None = None
        self._positions: ByIdentity[SourceFile, Positions] = ByIdentity(200)
        if specs_option is not None:
            self.add(named_project(specs_option))

    def open_paths(self) -> dict[Path, str]:
        """The open documents that are files: their addresses, as the editor writes them, by path."""
        paths = ((path_of(uri), uri) for uri in self.workspace.text_documents)
        return {path: uri for path, uri in paths if path is not None}

    def project_of(self, uri: str) -> EditedProject | None:
        """The project of a document, read as it is now; None for a document that is not a spec."""
        folder = self._folder_of(uri)
        if folder is None:
            return None
        project = self.projects[folder]
        if folder in self._stale:
            self._read(project)
        return project

    def _folder_of(self, uri: str) -> Path | None:
        path = path_of(uri)
        if path is None:
            return None
        folder = next((folder for folder in self.projects if folder in path.parents), None) or folder_of(path)
        if folder is not None and folder not in self.projects:
            self.add(EditedProject(folder))
        return folder

    def document(self, uri: str) -> tuple[EditedProject, FileRead] | None:
        """The project of a document, and the document as it was read; None for one that is not a spec."""
        project, path = self.project_of(uri), path_of(uri)
        read = project.read_file(path) if project is not None and path is not None else None
        return (project, read) if project is not None and read is not None else None

    def cursor(self, uri: str, position: types.Position) -> Cursor | None:
        """The context of a position in a document; None where that is not a spec, or cannot be read there."""
        document = self.document(uri)
        return cursor(*document, self.positions(document[1].file).offset(position)) if document is not None else None

    def add(self, project: EditedProject) -> None:
        """Adds a project, which is then read."""
        project.manuals = self.manuals
        self.projects[project.folder] = project
        self._note({project.folder})

    def _note(self, folders: Iterable[Path]) -> None:
        self._stale |= {*folders}
        self._unjudged |= {*folders}

    def _read(self, project: EditedProject) -> None:
        folder, documents = project.folder, self.workspace.text_documents
        unsaved = {path: documents[uri].source for path, uri in self.open_paths().items() if folder in path.parents}
        specs = {path: text for path, text in unsaved.items() if folder_of(path) == folder}
        try:
            project.read(specs)
            self._stale.discard(folder)
        except UsageError as error:
            self.window_show_message(types.ShowMessageParams(types.MessageType.Error, visible_text(str(error))))

    def changed(self, uri: str | None = None) -> None:
        """Notes that a document has changed, or that any file may have, and judges the specs when no key follows."""
        if uri is None:
            self._note(self.projects)
        elif (folder := self._folder_of(uri)) is not None:
            self._note([folder])
        loop = asyncio.get_running_loop()
        for timer in (self._waiting, self._tidying):
            if timer is not None:
                timer.cancel()
        self._waiting = loop.call_later(PAUSE, self.judge)
        self._tidying = loop.call_later(IDLE, gc.collect)

    def judge(self) -> None:
        """Sends the findings of the projects that have changed."""
        for folder in sorted(self._unjudged):
            project = self.projects[folder]
            if folder in self._stale:
                self._read(project)
            self._send(project)
        self._unjudged.clear()

    def _send(self, project: EditedProject) -> None:
        by_document: dict[str, list[types.Diagnostic]] = {}
        for path, uri in self.open_paths().items():
            if project.folder in path.parents:
                by_document[uri] = []
        before = self._marked.get(project.folder, set())
        for finding in project.findings():
            uri = self.uri(project, finding.span)
            by_document.setdefault(uri, []).append(self.diagnostic(project, finding))
        self._marked[project.folder] = {uri for uri, diagnostics in by_document.items() if diagnostics}
        for uri in sorted(before | by_document.keys()):
            document = self.workspace.text_documents.get(uri)
            version = document.version if document is not None else None
            parameters = types.PublishDiagnosticsParams(uri, by_document.get(uri, []), version)
            self.text_document_publish_diagnostics(parameters)

    def diagnostic(self, project: EditedProject, finding: Diagnostic) -> types.Diagnostic:
        """A finding as an editor shows it."""
        lines = [finding.message, *([f"help: {finding.help}"] if finding.help else [])]
        return types.Diagnostic(
            range=self.range(marked(finding.span)),
            message="\n".join(map(visible_text, lines)),
            severity=_SEVERITIES[finding.severity],
            code=finding.code,
            source="fieldspec",
            related_information=[
                types.DiagnosticRelatedInformation(self.location(project, label.span), visible_text(label.text))
                for label in finding.labels
            ],
        )

    def positions(self, file: SourceFile) -> Positions:
        """The positions in a file."""
        encoding = self.workspace.position_encoding or types.PositionEncodingKind.Utf16
        return self._positions.get_or_compute(file, lambda file: Positions(file.text, encoding))

    def range(self, span: Span) -> types.Range:
        """The range of a span."""
        return self.positions(span.file).range(span.start, span.end)

    def location(self, project: EditedProject, span: Span) -> types.Location:
        """The document and the marked range of a span."""
        return types.Location(self.uri(project, span), self.range(marked(span)))

    def named(self, project: EditedProject, names: Iterable[Span]) -> list[types.Location]:
        """The places of names, as they are in the documents now."""
        spans = (project.current(span) for span in names)
        return [types.Location(self.uri(project, span), self.range(span)) for span in spans if span is not None]

    def uri(self, project: EditedProject, span: Span) -> str:
        """The address of the document that a span is in, as the editor writes it."""
        path = project.path(span.file.path)
        return self.open_paths().get(path) or from_fs_path(str(path)) or ""

    def folders(self) -> Iterator[Path]:
        """The folders that the editor has open."""
        for folder in (*self.workspace.folders, *([self.workspace.root_uri] if self.workspace.root_uri else ())):
            if (path := path_of(folder)) is not None:
                yield path


def folder_of_manuals(name: str) -> Path:
    """The folder that an option names. Raises UsageError where there is none."""
    path = Path(name)
    if not path.is_dir():
        raise UsageError(f"there is no folder {name}; --manuals needs the one with the texts of the manuals")
    return path.resolve()


def path_of(uri: str) -> Path | None:
    """The path of a document; None for one that is not a file, such as a text without a name."""
    path = to_fs_path(uri) if uri.startswith("file:") else None
    return Path(os.path.realpath(path)) if path and "\0" not in path else None


def marked(span: Span) -> Span:
    """What carets in a terminal mark of a span."""
    return Span(span.file, span.start, span.start + marked_characters(span))


def refusal(error: UsageError) -> JsonRpcException:
    """The answer to a request that cannot be fulfilled, with the reason, which editors show."""
    return JsonRpcException(visible_text(str(error)), types.LSPErrorCodes.RequestFailed)


def is_refusal(raised: object) -> bool:
    """Whether what a log shows was raised to refuse a request."""
    return isinstance(raised, tuple) and isinstance(raised[1], JsonRpcException)
