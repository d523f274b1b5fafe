"""The code actions at a position: edits, and the explanation of a frame."""

from __future__ import annotations

from collections.abc import Iterator

from lsprotocol import types

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.command.console.usage import UsageError
from fieldspec.command.editor.cursor import cursor
from fieldspec.command.editor.fixes import Action, fixes
from fieldspec.command.editor.projects import EditedProject
from fieldspec.command.editor.refactorings import example_of, explained, frame_at, refactorings
from fieldspec.command.editor.server import Server, marked, refusal
from fieldspec.foundation.line_text import visible_text
from fieldspec.language.reading.memory import FileRead

EXPLAIN = "fieldspec.explain"
"""The command that explains a frame: its arguments are the address of a document and bytes in hexadecimal digits."""


def add_actions(server: Server) -> None:
    """Adds what can be done at a place."""

    def newest(project: EditedProject, read: FileRead) -> DeviceLayout | None:
        layouts = (
            project.layout(spec, version)
            for spec in project.specs_with(read.file)
            for version in reversed(spec.versions())
        )
        return next((layout for layout in layouts if layout is not None and layout.links), None)

    def all_actions(uri: str, range: types.Range) -> Iterator[types.CodeAction | types.Command]:
        document = server.document(uri)
        if document is None:
            return
        project, read = document
        positions = server.positions(read.file)
        start, end = positions.offset(range.start), positions.offset(range.end)
        for finding in project.findings():
            span = finding.span
            if span.file is read.file and span.start <= end and start <= marked(span).end:
                for action in fixes(project, read, finding):
                    yield answer(project, action)
        place = cursor(project, read, start)
        is_sound = read.tree is not None and read.tree.file is read.file
        frame = frame_at(place, read.file, start, end)
        layout = newest(project, read) if frame is not None else None
        if frame is not None and layout is not None:
            yield types.Command("Explain this frame", EXPLAIN, arguments=[uri, frame.hex(" ")])
            example = example_of(place, layout, frame) if place is not None and is_sound else None
            if example is not None:
                yield answer(project, example)
        if place is not None and is_sound:
            for action in refactorings(place):
                yield answer(project, action)

    def answer(project: EditedProject, action: Action) -> types.CodeAction:
        edits: dict[str, list[types.TextEdit]] = {}
        for edit in action.edits:
            edits.setdefault(server.uri(project, edit.span), []).append(
                types.TextEdit(server.range(edit.span), edit.text)
            )
        finding = action.finding
        return types.CodeAction(
            visible_text(action.title),
            types.CodeActionKind.QuickFix if finding is not None else types.CodeActionKind.RefactorRewrite,
            diagnostics=[server.diagnostic(project, finding)] if finding is not None else None,
            is_preferred=action.preferred or None,
            edit=types.WorkspaceEdit(edits),
        )

    kinds = [types.CodeActionKind.QuickFix, types.CodeActionKind.RefactorRewrite]

    @server.feature(types.TEXT_DOCUMENT_CODE_ACTION, types.CodeActionOptions(code_action_kinds=kinds))
    def offered(parameters: types.CodeActionParams) -> list[types.CodeAction | types.Command]:
        only = parameters.context.only or [""]
        actions = all_actions(parameters.text_document.uri, parameters.range)
        return [action for action in actions if any(_is_of(action, kind) for kind in only)]

    @server.command(EXPLAIN)
    def explain(uri: str, frame: str) -> str:
        document = server.document(uri)
        layout = newest(*document) if document is not None else None
        try:
            if layout is None:
                raise UsageError("there is no sound device with a link here")
            text = explained(layout, bytes.fromhex(frame))
        except ValueError:
            raise refusal(UsageError(f"{visible_text(frame)} is not a frame")) from None
        except UsageError as error:
            raise refusal(error) from None
        if not server.shows_answers:
            server.window_show_message(types.ShowMessageParams(types.MessageType.Info, text))
        return text


def _is_of(action: types.CodeAction | types.Command, kind: str) -> bool:
    """Whether an action is of a kind that an editor asks for: the empty one has all."""
    action_kind = action.kind if isinstance(action, types.CodeAction) else ""
    return not kind or f"{action_kind}.".startswith(f"{kind}.")
