"""A fact under another name, in all documents. It is judged by reading the specs with it: nothing may break by it."""

from __future__ import annotations

from collections import Counter

from fieldspec.command.console.usage import UsageError
from fieldspec.command.editor.cursor import Cursor
from fieldspec.command.editor.index import NamedFact, meant
from fieldspec.command.editor.projects import EditedProject
from fieldspec.command.sources import spec_files
from fieldspec.foundation.source import Span
from fieldspec.language.changes.change import Effect
from fieldspec.language.changes.table import changes
from fieldspec.language.diagnostics import Diagnostic, Severity
from fieldspec.language.reading.project import read


def name_at(place: Cursor) -> Span:
    """The name at a place, which may be a step of a path. Raises UsageError where none is."""
    spans = [span for fact in meant(place) for span in _spans(fact)]
    under = [span for span in spans if span.start <= place.offset <= span.end and span.file is place.nodes[-1].file]
    if not under:
        raise UsageError("there is no name of a fact here")
    return under[0]


def renaming(place: Cursor, new_name: str) -> list[Span]:
    """The places where a name is replaced. Raises UsageError where the new name breaks something."""
    project, at_cursor = place.project, name_at(place)
    old_name = _text(at_cursor)
    spans = list(dict.fromkeys(span for fact in meant(place) for span in _spans(fact) if _text(span) == old_name))
    for span in spans:
        if span.file.path in project.origins.values():
            raise UsageError(f"{old_name} belongs to an installed protocol, which cannot be changed here")
        if project.file(span.file.path) is not span.file:
            raise UsageError(f"{span.file.path} cannot be read as it is now: correct what is marked there first")
    _judge(place, spans, new_name)
    return spans


def _spans(fact: NamedFact) -> list[Span]:
    return [*fact.spans, *fact.uses]


def _text(span: Span) -> str:
    return span.file.text[span.start : span.end]


def _judge(place: Cursor, spans: list[Span], new_name: str) -> None:
    """Reads the specs under the new name. Raises UsageError where there are other findings, or other bytes."""
    project = place.project
    contents = {path: file.data for path, file in project.memory.files.items()}
    for path, file_read in project.memory.files.items():
        text = file_read.file.text
        for span in sorted((span for span in spans if span.file is file_read.file), key=Span.order, reverse=True):
            text = text[: span.start] + new_name + text[span.end :]
        if text is not file_read.file.text:
            contents[path] = text.encode("utf-8", "surrogatepass")
    after = EditedProject(project.folder, origins=project.origins)
    after.project = read(
        contents, origins=project.origins, installed=spec_files.installed_protocols, memory=after.memory
    )
    before = Counter(finding.code for finding in project.findings())
    fresh = [finding for finding in after.findings() if not _spent(before, finding)]
    if fresh:
        worst = min(fresh, key=lambda finding: finding.severity is not Severity.ERROR)
        line, _ = worst.span.position()
        raise UsageError(f"{new_name} breaks {worst.span.file.path}:{line}: {worst.message}")
    for spec in place.specs:
        for version in spec.versions():
            old, new = spec.at(version)[0], after.project.devices[spec.id].at(version)[0]
            worst_change = next((change for change in changes(old, new) if change.effect in _OF_FRAMES), None)
            if worst_change is not None:
                raise UsageError(f"{new_name} changes more than a name: {worst_change.message}")


_OF_FRAMES = (Effect.WIRE, Effect.BEHAVIOUR)


def _spent(before: Counter[str], finding: Diagnostic) -> bool:
    """Whether a finding is one that there was before."""
    before[finding.code] -= 1
    return before[finding.code] >= 0
