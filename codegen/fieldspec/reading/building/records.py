"""Records and their fields, messages and their data."""

from __future__ import annotations

from fieldspec.model.message import Message, RegisterAccess
from fieldspec.model.record import Field, Measure, Record
from fieldspec.reading.building.context import Entry
from fieldspec.reading.building.values import value


def record(entry: Entry) -> Record:
    """A record."""
    return Record(
        **entry.fact(),
        size=entry.integer("size"),
        words=entry.integer("words"),
        fields=tuple(_field(inner) for inner in entry.named("fields", entry.path)),
    )


def _field(entry: Entry) -> Field:
    name = entry.text("record")
    if name and entry.get("type"):
        entry.refuse("type_given", "type", "the field has a `type` and a `record`", "keep one of them")
    words = entry.integer("words")
    measures = entry.entry("measures")
    measure = None
    if measures:
        of = "bytes" if measures.get("bytes") else "items"
        measure = Measure(of, measures.text(of))
    return Field(
        **entry.fact(),
        value=None if name else value(entry, words=words),
        record=name,
        count=entry.integer("count"),
        repeat=entry.whole_ranges("repeat"),
        measures=measure,
        reserved=entry.flag("reserved"),
        at=entry.integer("at"),
        words=words,
        span=_byte_span(entry.text("span")),
        access=entry.text("access"),
        restart=entry.maybe("restart"),
        same_as=entry.text("same_as"),
    )


def _byte_span(text: str) -> tuple[int, int] | None:
    if not text:
        return None
    first, _, last = text.partition("-")
    return int(first), int(last or first)


def message(entry: Entry) -> Message:
    """A message. Its data are records that are named after it."""
    lengths = entry.entry("frame_length")
    access = entry.entry("accesses")
    return Message(
        **entry.fact(),
        title=entry.text("title"),
        group=entry.text("group"),
        code=entry.integer("code"),
        request=_data(entry, "request"),
        response=_data(entry, "response"),
        request_length=lengths.integer("request") if lengths else None,
        response_length=lengths.integer("response") if lengths else None,
        broadcast=entry.flag("broadcast"),
        accesses=RegisterAccess(*(access.text(key) for key in ("operation", "start", "count", "values")))
        if access
        else None,
    )


def _data(entry: Entry, direction: str) -> Record:
    arguments = entry.fact() | {
        "name": f"{entry.text('name')}_{direction}",
        "doc": "",
        "notes": (),
        "restated": (),
        "inferred": {},
    }
    fields = tuple(_field(inner) for inner in entry.entries(direction))
    return Record(**arguments, size=None, words=None, fields=fields)
