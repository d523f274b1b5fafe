"""The content that an import used of a list, the unused content, and the assumptions, as lines for people."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from fieldspec.foundation.line_text import plural
from fieldspec.tools.lists.column_roles import FURTHER
from fieldspec.tools.lists.heading_words import NOTE
from fieldspec.tools.lists.imported import Imported
from fieldspec.tools.lists.row_reading import MESSAGE, PARAMETER
from fieldspec.tools.lists.words import folded
from fieldspec.tools.lists.yaml_text import exact

_IDLE = ("value",)
"""Roles of dumps, which a list of registers has no use for."""

_MOST = 20
"""The most rows of a kind that are printed."""


def lines(name: str, result: Imported, noted: Sequence[int]) -> Iterator[str]:
    """The whole report. `name` is that of the file that was written, `noted` are the rows with notes in it."""
    used = len(result.used_rows())
    kinds = {entry.kind for entry in result.registers}
    noun = "message" if MESSAGE in kinds else "parameter" if kinds == {PARAMETER} else "register"
    number = sum(entry.kind == MESSAGE for entry in result.registers) or sum(
        len(entry.rows) or 1 for entry in result.registers
    )
    yield f"{name}: {plural(number, noun)}, addresses read as {result.base}"
    yield from _columns(result)
    total = used + len({refusal.row for refusal in result.refused}) + len(result.skipped)
    share = f"{100 * used // max(total, 1)} %"
    yield f"rows: {used} of {total} used ({share}){_skipped(result.skipped)}"
    if messages := dict.fromkeys(row.message for row in result.rows if row.message):
        reason = "a list has no frames for them; take them from a protocol, or write them"
        yield f"not used: {plural(len(messages), 'message')} ({', '.join(messages)}): {reason}"
    if noted:
        yield f"rows with cells that are only noted: {len(noted)}; see `notes`"
    yield from _limited([f"not used: {refusal.text()}" for refusal in result.refused])
    yield from _limited([f"assumed: {assumption.text()}" for assumption in result.assumptions])


def head(result: Imported, has_frames: bool) -> list[str]:
    """The same for the head of the spec, without what its rows say."""
    frames = [] if has_frames else ["The list has no frames: add `uses` or `links`, as `fieldspec new device` shows."]
    if has_frames:
        frames = ["The list does not name the protocol of its frames. Keep the links that the device has."]
    return [*frames, *_columns(result), *(f"Assumed: {assumption.text()}" for assumption in result.assumptions)]


def lacking(result: Imported, noted: Sequence[int]) -> str:
    """What of the list is not used, in a line; empty if all of it is."""
    parts = [refusal.text() for refusal in result.refused[:_MOST]]
    unused = _unused(result)
    if unused:
        parts.append("columns not used: " + ", ".join(unused))
    parts += [f"beside the list: {text}" for text in result.sheet.beside]
    if noted:
        parts.append("cells only noted in rows " + ", ".join(map(str, noted[:_MOST])))
    return "; ".join(parts)


def preview(result: Imported, number: int) -> Iterator[str]:
    """The first registers as they were understood."""
    for entry in result.registers[:number]:
        row = entry.row
        facts = [f"{entry.space} 0x{row.address:04X}", entry.shape.type, f"{entry.shape.words} words", row.access]
        facts += [
            f"\u00d7 {exact(row.scale)}" if row.scale not in (None, 1) else "",
            f"+ {row.offset}" if row.offset else "",
        ]
        facts += [row.unit, "; ".join(f"{value} {text}" for value, text in row.meanings.members)]
        facts += [f"{len(entry.bits)} bits" if entry.bits else "", row.order, *row.doubts]
        name = row.names[0] if row.names else "without a name"
        yield f"row {row.row}: {name}: {', '.join(filter(None, facts))}"


def _columns(result: Imported) -> Iterator[str]:
    if result.sheet.format:
        yield f"read as {result.sheet.format}"
    columns = result.listing.columns
    used_columns = [(role, columns.heading(role)) for role in columns.places if role not in (NOTE, *_IDLE)]
    used_columns += [
        (role, columns.heading_at(place))
        for role in ("address", "name", *FURTHER)
        for place in columns.more.get(role, ())
    ]
    yield "columns used: " + ", ".join(
        role if folded(heading) == folded(role) else f"{role} from {heading}" for role, heading in used_columns
    )
    notes = [columns.heading(NOTE)] if NOTE in columns.places else []
    notes += [columns.heading_at(place) for place in columns.more.get(NOTE, ())]
    if notes:
        yield "columns not used as facts but kept as notes: " + ", ".join(notes)
    if unused := _unused(result):
        yield "columns not used: " + ", ".join(unused)
    if result.sheet.joined:
        yield f"sheets used: {', '.join(result.sheet.joined)}; their rows count on from one to the next"
    if result.sheet.others:
        used_name = result.sheet.name or "these"
        yield f"sheets not used beside {used_name}: {', '.join(result.sheet.others)}; --sheet names one"
    if result.sheet.beside:
        yield f"not used beside the list: {'; '.join(_cut(result.sheet.beside))}"


def _unused(result: Imported) -> Sequence[str]:
    columns = result.listing.columns
    used = columns.more.get("values", ())
    idle = [columns.places[role] for role in _IDLE if role in columns.places and columns.places[role] not in used]
    return [columns.heading_at(place) for place in sorted([*columns.unused(), *idle])]


def _skipped(numbers: Sequence[int]) -> str:
    if not numbers:
        return ""
    rest = f" and {len(numbers) - _MOST} more" if len(numbers) > _MOST else ""
    return f"; without an address: {', '.join(map(str, numbers[:_MOST]))}{rest}"


def _cut(texts: Sequence[str]) -> Sequence[str]:
    return texts if len(texts) <= _MOST else [*texts[:_MOST], f"{len(texts) - _MOST} more"]


def _limited(texts: Sequence[str]) -> Iterator[str]:
    yield from texts[:_MOST]
    if len(texts) > _MOST:
        yield f"and {len(texts) - _MOST} more, which the spec lists"
