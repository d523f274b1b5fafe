"""The help of a finding as edits of the documents, if it is mechanical."""

from __future__ import annotations

import re
from collections.abc import Iterator

from fieldspec.command import rules
from fieldspec.command.editor.cursor import Cursor, cursor
from fieldspec.command.editor.edits import Edit, erratum_lines, holding_section, with_item, with_key
from fieldspec.command.editor.free_addresses import free_addresses
from fieldspec.command.editor.projects import EditedProject
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.source import Span
from fieldspec.language.checks.finding import hexadecimal
from fieldspec.language.diagnostics import Diagnostic
from fieldspec.language.reading.memory import FileRead
from fieldspec.language.reading.nodes import Mapping, Scalar, Sequence, identity
from fieldspec.language.reading.references import unquoted

_INSTEAD = re.compile(r"did you mean (?P<names>`[^`]+`(?: or `[^`]+`)*)\?|the key for it is (?P<key>`[^`]+`)")
_SPELLING = re.compile(r"write it as `([^`]+)`|the number `([^`]+)`: write that")
_CHOICES = re.compile(r"it can be ((?:`[^`]+`(?:, )?)+)$")
_QUOTED = re.compile(r"quote it, as in `((?P<key>\w+): )?(?P<text>\"[^`]*\")`")
_SET = re.compile(r"(?:set|add) `(?P<key>\w+): (?P<value>[\w.]+)`(?=,|$| if the manual)")
_EQUAL = re.compile(r"is (\d+)(?:; correct one of them)?$")
_NAME = re.compile("`([^`]+)`")
_MOST_CHOICES = 8
_MOST_ADDRESSES = 3


@dataclass(frozen=True, slots=True)
class Action:
    """Edits that an editor offers under a title, because of a finding where there is one."""

    title: str
    edits: tuple[Edit, ...]
    finding: Diagnostic | None = None
    preferred: bool = False


def fixes(project: EditedProject, read: FileRead, finding: Diagnostic) -> Iterator[Action]:
    """The actions that the help of a finding means, the likeliest first."""
    text = read.file.text
    instead = [*_texts_instead(finding)]
    marked = _word(read, finding.span)
    for number, name in enumerate(instead[:_MOST_CHOICES]):
        edit = Edit(marked, name)
        yield Action(f"Write `{name}`", (edit,), finding, preferred=number == 0 and len(instead) == 1)
    if spelling := _SPELLING.search(finding.help):
        name = spelling[1] or spelling[2]
        yield Action(f"Write `{name}`", (Edit(_whole(text, finding.span), name),), finding, preferred=True)
    if quotes := _QUOTED.search(finding.help):
        start = text.rfind(f"{quotes['key']}:", 0, finding.span.start) if quotes["key"] else finding.span.start
        start += len(f"{quotes['key']}: ") if quotes["key"] else 0
        end = finding.span.end if quotes["key"] else start + len(quotes["text"]) - 2
        yield Action("Quote the text", (Edit(Span(read.file, start, end), quotes["text"]),), finding, preferred=True)
    place = cursor(project, read, finding.span.start)
    if place is None or read.tree is None or read.tree.file is not read.file:
        return
    yield from _in_tree(place, finding)


def _texts_instead(finding: Diagnostic) -> Iterator[str]:
    """The texts that the help names for what is marked."""
    for pattern in (_INSTEAD, _CHOICES):
        if names := pattern.search(finding.help):
            yield from _NAME.findall(names[0])
            return


def _word(read: FileRead, span: Span) -> Span:
    """The text that a finding marks, without quotation marks."""
    return unquoted(Scalar(span.file, span.start, span.end, "", False)) if _is_quoted(span) else span


def _is_quoted(span: Span) -> bool:
    text = span.file.text[span.start : span.end]
    return len(text) > 1 and text[0] == text[-1] and text[0] in "'\""


def _whole(text: str, span: Span) -> Span:
    """A scalar with its quotation marks."""
    start, end = span.start, span.end
    if text[start - 1 : start] == text[end : end + 1] and text[end : end + 1] in ("'", '"'):
        start, end = start - 1, end + 1
    return Span(span.file, start, end)


def _in_tree(place: Cursor, finding: Diagnostic) -> Iterator[Action]:
    """The actions that add something to the fact that a finding is about."""
    fact = next((node for node in reversed(place.nodes) if isinstance(node, Mapping) and identity(node)), None)
    added = _SET.search(finding.help)
    if fact is not None and added and added["key"] not in fact.values:
        edit = with_key(fact, added["key"], added["value"])
        yield Action(f"Add `{added['key']}: {added['value']}`", (edit,), finding, preferred=True)
    yield from _corrected(place, finding, fact)
    rule = rules.rule(finding.code)
    if rule is not None and rule.stage == "checks" and (holder := _allowing(place)) is not None:
        allowed = holder.values.get("allow")
        if isinstance(allowed, Mapping):
            edit = with_key(allowed, finding.code, '""')
        else:
            edit = with_key(holder, "allow", f'{{{finding.code}: ""}}')
        yield Action(f"Allow `{finding.code}` here with a reason", (edit,), finding)


def _corrected(place: Cursor, finding: Diagnostic, fact: Mapping | None) -> Iterator[Action]:
    """Other numbers for an address, with and without an erratum for the printed number."""
    value, key = place.scalar, place.keys[-1] if place.keys else ""
    if value is None or fact is None or not isinstance(key, str):
        return
    numbers: list[str] = []
    if key in ("at", "base") and "address" in finding.help:
        space = fact.values.get("space")
        for spec in place.specs:
            own_space = space.text if isinstance(space, Scalar) else ""
            numbers += map(hexadecimal, free_addresses(spec, own_space, _before(place), identity(fact) or ""))
    elif equal := _EQUAL.search(finding.help):
        numbers.append(equal[1])
    for number in numbers[:_MOST_ADDRESSES]:
        edit = Edit(value.span, number)
        yield Action(f"Correct `{key}` to {number}", (edit,), finding)
        lines = erratum_lines(place, fact, key, proof=finding.code)
        if lines is not None:
            erratum = with_item(holding_section(place, "errata"), "errata", lines)
            yield Action(f"Correct `{key}` to {number}, with an erratum", (edit, erratum), finding)


def _before(place: Cursor) -> int | None:
    """The address of the row before the one of a place."""
    rows, number = place.nodes[-3], place.keys[-2]
    row = rows.items[number - 1] if isinstance(rows, Sequence) and isinstance(number, int) and number else None
    address = row.values.get("at") if isinstance(row, Mapping) else None
    return address.value if isinstance(address, Scalar) and isinstance(address.value, int) else None


def _allowing(place: Cursor) -> Mapping | None:
    """The innermost mapping around a place that may have `allow`."""
    for depth in range(len(place.nodes) - 1, -1, -1):
        node = place.nodes[depth]
        outer = Cursor(place.project, place.read, place.offset, place.nodes[: depth + 1], place.keys[:depth], None)
        if isinstance(node, Mapping) and "allow" in (outer.part() or {}).get("properties", {}):
            return node
    return None
