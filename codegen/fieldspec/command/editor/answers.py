"""The answer of the server to each request of an editor."""

from __future__ import annotations

from lsprotocol import types

from fieldspec.command.console.usage import UsageError
from fieldspec.command.editor.action_answers import add_actions
from fieldspec.command.editor.completion import suggestions
from fieldspec.command.editor.cursor import Cursor
from fieldspec.command.editor.hover import hover
from fieldspec.command.editor.index import meant
from fieldspec.command.editor.manual_links import citations, manual_of, sources
from fieldspec.command.editor.outline import Ranged, folds, symbols
from fieldspec.command.editor.projects import project_in
from fieldspec.command.editor.renaming import name_at, renaming
from fieldspec.command.editor.server import Server, refusal
from fieldspec.command.editor.typed_word import typed_word
from fieldspec.foundation.line_text import visible_text
from fieldspec.foundation.source import Span
from fieldspec.language.reading.nodes import Mapping


def server(specs_option: str | None, manuals: str | None) -> Server:
    """A server with all that it answers. Raises UsageError for a folder without specs, or that is not there."""
    result = Server(specs_option, manuals)
    _add_findings(result)
    _add_hover(result)
    _add_completion(result)
    add_actions(result)
    _add_links(result)
    _add_references(result)
    _add_rename(result)
    _add_outline(result)
    return result


def _add_findings(server: Server) -> None:
    """Adds what an editor tells about its documents."""

    @server.feature(types.INITIALIZE)
    def begun(parameters: types.InitializeParams) -> None:
        options = parameters.initialization_options
        server.shows_answers = isinstance(options, dict) and options.get("showsAnswers") is True

    @server.feature(types.INITIALIZED)
    def initialized(_: types.InitializedParams) -> None:
        if not server.projects:
            for folder in server.folders():
                if (project := project_in(folder)) is not None:
                    server.add(project)
        server.changed()

    @server.feature(types.TEXT_DOCUMENT_DID_OPEN)
    def opened(parameters: types.DidOpenTextDocumentParams) -> None:
        server.changed(parameters.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CHANGE)
    def changed(parameters: types.DidChangeTextDocumentParams) -> None:
        server.changed(parameters.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_CLOSE)
    def closed(parameters: types.DidCloseTextDocumentParams) -> None:
        server.changed(parameters.text_document.uri)

    @server.feature(types.TEXT_DOCUMENT_DID_SAVE)
    def saved(_: types.DidSaveTextDocumentParams) -> None:
        server.changed()

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def files_changed(_: types.DidChangeWatchedFilesParams) -> None:
        server.changed()


def _add_hover(server: Server) -> None:
    """Adds what an editor shows under the pointer."""

    @server.feature(types.TEXT_DOCUMENT_HOVER)
    def hovered(parameters: types.HoverParams) -> types.Hover | None:
        place = server.cursor(parameters.text_document.uri, parameters.position)
        text = hover(place) if place is not None else None
        return types.Hover(types.MarkupContent(types.MarkupKind.Markdown, text)) if text else None


def _add_references(server: Server) -> None:
    """Adds where facts are defined and used."""

    @server.feature(types.TEXT_DOCUMENT_DEFINITION)
    def defined(parameters: types.DefinitionParams) -> list[types.Location]:
        place = server.cursor(parameters.text_document.uri, parameters.position)
        facts = meant(place) if place is not None else []
        names = [span for fact in facts for span in fact.definition]
        return server.named(place.project, names) if place is not None else []

    @server.feature(types.TEXT_DOCUMENT_REFERENCES)
    def used(parameters: types.ReferenceParams) -> list[types.Location]:
        place = server.cursor(parameters.text_document.uri, parameters.position)
        if place is None:
            return []
        facts = meant(place)
        names = [span for fact in facts for span in fact.uses]
        if parameters.context.include_declaration:
            names += (span for fact in facts for span in fact.spans)
        return server.named(place.project, names)


def _add_rename(server: Server) -> None:
    """Adds new names for facts."""

    def place_of(uri: str, position: types.Position) -> Cursor:
        place = server.cursor(uri, position)
        if place is None:
            raise UsageError("this document cannot be read here")
        return place

    @server.feature(types.TEXT_DOCUMENT_PREPARE_RENAME)
    def name(parameters: types.PrepareRenameParams) -> types.Range:
        try:
            place = place_of(parameters.text_document.uri, parameters.position)
            span = place.project.current(name_at(place))
            assert span is not None  # the place itself is there
            return server.range(span)
        except UsageError as error:
            raise refusal(error) from None

    @server.feature(types.TEXT_DOCUMENT_RENAME, types.RenameOptions(prepare_provider=True))
    def renamed(parameters: types.RenameParams) -> types.WorkspaceEdit:
        try:
            place = place_of(parameters.text_document.uri, parameters.position)
            edits: dict[str, list[types.TextEdit]] = {}
            for span in renaming(place, parameters.new_name):
                edit = types.TextEdit(server.range(span), parameters.new_name)
                edits.setdefault(server.uri(place.project, span), []).append(edit)
            return types.WorkspaceEdit(edits)
        except UsageError as error:
            raise refusal(error) from None


def _add_outline(server: Server) -> None:
    """Adds the outline of a document, and what can be folded."""

    def tree_of(uri: str) -> tuple[Mapping, Ranged] | None:
        document = server.document(uri)
        if document is None:
            return None
        project, read = document
        if read.tree is None:
            return None

        def ranged(span: Span) -> types.Range | None:
            current = project.current(span)
            return server.range(current) if current is not None else None

        return read.tree, ranged

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def outlined(parameters: types.DocumentSymbolParams) -> list[types.DocumentSymbol]:
        document = tree_of(parameters.text_document.uri)
        return symbols(*document) if document is not None else []

    @server.feature(types.TEXT_DOCUMENT_FOLDING_RANGE)
    def folded(parameters: types.FoldingRangeParams) -> list[types.FoldingRange]:
        document = tree_of(parameters.text_document.uri)
        return [*folds(*document)] if document is not None else []


def _add_links(server: Server) -> None:
    """Adds the lines of manuals that sources cite."""

    @server.feature(types.TEXT_DOCUMENT_DOCUMENT_LINK)
    def linked(parameters: types.DocumentLinkParams) -> list[types.DocumentLink]:
        document = server.document(parameters.text_document.uri)
        if document is None or document[1].tree is None:
            return []
        project, read = document
        manuals = (manual_of(project, spec) for spec in project.specs_with(read.file))
        path = next((path for path in manuals if path is not None), None)
        if path is None or read.tree is None:
            return []
        return [
            types.DocumentLink(server.range(current), f"{path.as_uri()}#L{first}", f"{path.name}, line {first}")
            for scalar in sources(read.tree)
            for span, first, _ in citations(scalar)
            if (current := project.current(span)) is not None
        ]


_KINDS = {
    "key": types.CompletionItemKind.Property,
    "word": types.CompletionItemKind.Keyword,
    "rule": types.CompletionItemKind.Event,
    "unit": types.CompletionItemKind.Unit,
    "address": types.CompletionItemKind.Value,
    "number": types.CompletionItemKind.Value,
    "section": types.CompletionItemKind.Folder,
    "members": types.CompletionItemKind.EnumMember,
    "enums": types.CompletionItemKind.Enum,
    "records": types.CompletionItemKind.Struct,
    "messages": types.CompletionItemKind.Function,
}


def _add_completion(server: Server) -> None:
    """Adds what can be typed at a place."""

    @server.feature(
        types.TEXT_DOCUMENT_COMPLETION, types.CompletionOptions(trigger_characters=[" ", "/", "{", "[", ",", ":"])
    )
    def completed(parameters: types.CompletionParams) -> types.CompletionList:
        document = server.document(parameters.text_document.uri)
        word = None
        if document is not None:
            project, read = document
            offset = server.positions(read.file).offset(parameters.position)
            word = typed_word(project, read.file, offset)
        if word is None:
            return types.CompletionList(is_incomplete=False, items=[])
        range = server.range(word.span)
        items = [
            types.CompletionItem(
                label=visible_text(suggestion.text.removesuffix(": ")),
                kind=_KINDS.get(suggestion.kind, types.CompletionItemKind.Reference),
                detail=visible_text(" ".join(filter(None, (suggestion.kind, suggestion.detail)))),
                documentation=types.MarkupContent(types.MarkupKind.Markdown, suggestion.documentation)
                if suggestion.documentation
                else None,
                sort_text=f"{number:05}",
                filter_text=suggestion.text,
                text_edit=types.TextEdit(range, suggestion.text),
            )
            for number, suggestion in enumerate(suggestions(word))
        ]
        return types.CompletionList(is_incomplete=False, items=items)
