"""An editor that asks `fieldspec lsp`, and specs that are open in it."""

from __future__ import annotations

import asyncio
import shutil
import sys
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import cast

from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities, make_test_lsp_client

from bounded import HANGING
from editor_servers import server_address
from fieldspec.command import pipeline
from fieldspec.command.rendering.finding_text import marked_characters
from fieldspec.command.sources import spec_files
from fieldspec.foundation.source import Span
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.reading.project import read

SPECS = Path(__file__).resolve().parent / "specs"
REAL = Path(__file__).resolve().parent.parent / "specs"
CONFIGURATION = ClientServerConfig(server_command=[sys.executable, "-m", "fieldspec", "lsp"])

Place = tuple[str, int, int, int, int, str]
"""A finding in an editor: the file, the first and the last line and column of its range, and its rule."""


@dataclass
class Editor:
    """A client with a folder of specs. Positions count the units of UTF-16."""

    client: LanguageClient
    specs: Path
    version: int = 0
    open_names: set[str] = field(default_factory=set)

    def uri(self, name: str) -> str:
        """The address of a spec file."""
        return (self.specs / name).as_uri()

    def text(self, name: str) -> str:
        """The text of a spec file on the disk, with its ends of lines."""
        return (self.specs / name).read_bytes().decode("utf-8")

    async def opened(self, name: str, text: str | None = None) -> list[types.Diagnostic]:
        """Opens a document, with another text than that of its file where one is given, and waits for the findings."""
        self.client.diagnostics.clear()
        self.open_names.add(name)
        content = self.text(name) if text is None else text
        document = types.TextDocumentItem(self.uri(name), "yaml", self.version, content)
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(document))
        return await self.findings(name)

    async def typed(self, name: str, text: str) -> list[types.Diagnostic]:
        """Changes a document that is open, and waits for the findings."""
        self.change(name, text)
        return await self.findings(name)

    def change(self, name: str, text: str) -> None:
        """Changes a document that is open."""
        self.version += 1
        self.client.diagnostics.clear()
        document = types.VersionedTextDocumentIdentifier(self.version, self.uri(name))
        change = types.TextDocumentContentChangeWholeDocument(text)
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(document, [change]))

    async def findings(self, name: str) -> list[types.Diagnostic]:
        """The next findings of a document, when those of all open documents are there."""
        awaited = {self.uri(known) for known in (name, *self.open_names)}

        async def arrived() -> None:
            while not awaited <= self.client.diagnostics.keys():
                await asyncio.sleep(0.005)

        await asyncio.wait_for(arrived(), HANGING)
        return [*self.client.diagnostics[self.uri(name)]]

    def places(self) -> set[Place]:
        """All findings that the editor shows now."""
        return {
            (uri.removeprefix(self.specs.as_uri() + "/"), *numbers(finding.range), str(finding.code))
            for uri, findings in self.client.diagnostics.items()
            for finding in findings
        }


def numbers(range: types.Range) -> tuple[int, int, int, int]:
    """The lines and columns of a range."""
    return range.start.line, range.start.character, range.end.line, range.end.character


def copied(folder: Path, *devices: str) -> Path:
    """A folder of specs with some of the devices, made up or real ones, and the protocols of all of their kind."""
    source = SPECS if (SPECS / devices[0]).is_dir() else REAL
    for device in ("protocols", *devices):
        shutil.copytree(source / device, folder / "specs" / device)
    return folder / "specs"


def fresh(specs: Path, unsaved: dict[str, str]) -> list[Diagnostic]:
    """What a check finds in specs when these documents have been saved."""
    contents = spec_files.files(specs) | {name: text.encode("utf-8") for name, text in unsaved.items()}
    contents = spec_files.with_protocols(contents)
    return pipeline.checked(read(contents, origins=spec_files.origins(contents)))


def expected_places(findings: list[Diagnostic]) -> set[Place]:
    """The findings of a check as an editor counts their places."""
    return {(finding.span.file.path, *_lines_and_columns(finding.span), finding.code) for finding in findings}


def _lines_and_columns(span: Span) -> Iterator[int]:
    for offset in (span.start, span.start + marked_characters(span)):
        before = span.file.text[:offset].replace("\r\n", "\n").replace("\r", "\n")
        yield before.count("\n")
        yield len(before.rpartition("\n")[2].encode("utf-16-le")) // 2


@asynccontextmanager
async def editor(specs: Path) -> AsyncIterator[Editor]:
    """An editor that has the folder of some specs open, with a server of its own."""
    client = make_test_lsp_client()
    with server_address() as (host, port):
        await client.start_tcp(host, port)
        async with session(client, specs) as editor:
            yield editor


@asynccontextmanager
async def editor_of_the_verb(specs: Path) -> AsyncIterator[Editor]:
    """The same, with the server as editors start it."""
    client = cast(LanguageClient, await CONFIGURATION.start())
    async with session(client, specs) as editor:
        yield editor


@asynccontextmanager
async def session(client: LanguageClient, specs: Path) -> AsyncIterator[Editor]:
    capabilities = client_capabilities("visual_studio_code")
    root = types.WorkspaceFolder(specs.parent.as_uri(), "root")
    await client.initialize_session(
        types.InitializeParams(capabilities=capabilities, root_uri=root.uri, workspace_folders=[root])
    )
    yield Editor(client, specs)
    await client.shutdown_session()
    await client.stop()


def place_of(text: str, offset: int) -> types.Position:
    """The position of an offset, in units of UTF-16."""
    before = text[:offset]
    return types.Position(before.count("\n"), len(before.rpartition("\n")[2].encode("utf-16-le")) // 2)


def applied(text: str, edits: list[types.TextEdit]) -> str:
    """A text after edits of an editor."""
    lines = text.split("\n")
    for edit in sorted(edits, key=lambda edit: numbers(edit.range), reverse=True):
        line, first, last_line, last = numbers(edit.range)
        assert line == last_line
        units = lines[line].encode("utf-16-le")
        lines[line] = (units[: 2 * first] + edit.new_text.encode("utf-16-le") + units[2 * last :]).decode("utf-16-le")
    return "\n".join(lines)
