"""Records and their fields, messages and their data."""

from __future__ import annotations

from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.record import (
    Case,
    Choice,
    Field,
    Measure,
    Message,
    Presence,
    Record,
    RegisterAccess,
    Segments,
    SegmentsAbort,
)
from fieldspec.language.reading.building.context import Entry, Reused, rows
from fieldspec.language.reading.building.enums import bit_pieces
from fieldspec.language.reading.building.remote_requests import with_remote_request
from fieldspec.language.reading.building.separators import with_separators
from fieldspec.language.reading.building.values import VALUE_KEYS, value

_OF_VALUES = VALUE_KEYS - {"type"} | {"atomic", "packed_bits", "reserved"}
"""The keys that only a field with a value of its own has."""


def record(entry: Entry, reused: Reused) -> Record:
    """The record that an entry states."""
    return entry.built(
        Record, fields=rows(with_separators(entry, "fields"), entry.path, None, reused, _field, key="fields")
    )


def _field(entry: Entry) -> Field:
    if not entry.text("name"):
        entry.refuse(
            "missing_key", "name", "the key `name` is missing", "add a `name`, or a `signal` whose name the field has"
        )
    name = entry.text("record")
    choice = entry.entry("choice")
    kinds = [key for key in ("type", "record", "choice") if entry.get(key)]
    if len(kinds) > 1:
        text = f"the field has both `{kinds[0]}` and `{kinds[1]}`"
        entry.refuse("type_present", kinds[0], text, "remove one of them")
    if (name or choice) and entry.get("scale_by"):
        text = f"the field is a {'record' if name else 'choice'}, which has no scale"
        entry.refuse("type_present", "scale_by", text, "remove it, or state it for a field with a `type`")
    for key in sorted(_OF_VALUES & entry.own.keys()) if name else ():
        help = f"state it at the fields of {name}, or give the field a `type`"
        entry.refuse("type_present", key, f"the field is a record, which has no `{key}`", help)
    measures = entry.entry("measures")
    measure = _measure(measures) if measures else None
    is_in_bits = measure is not None and measure.bits is not None
    present = entry.entry("present_if")
    return entry.built(
        Field,
        value=None if name or choice else value(entry),
        record=name,
        choice=_choice(choice, entry) if choice and not name else None,
        count=entry.integer("count") if present is None else None,
        repeat=entry.whole_ranges("repeat") if present is None else _optional(entry),
        presence=_presence(present, "by") if present is not None else None,
        continuation=_continuation(entry),
        measures=None if is_in_bits else measure,
        bit_measure=measure if is_in_bits else None,
        is_implied=not {"separator", "remote"}.isdisjoint(entry.own),
        span=_span(entry.text("span")),
        word_span=_span(entry.text("word_span")),
        handling=entry.handling(),
    )


def _measure(entry: Entry) -> Measure:
    unit = "bytes" if entry.get("bytes") else "items"
    if "plus" in entry.own and not entry.integer("plus"):
        entry.refuse("wrong_form", "plus", "a `plus` of 0 has no effect", "remove it")
    return Measure(unit, entry.text(unit), entry.integer("plus") or 0, entry.bit_range("bits"))


_OF_FIXED_NUMBERS = ("choice", "const", "count", "measures", "packed_bits", "parameter", "reserved", "varies")
"""The keys that a field which is not always sent, or a list whose elements say which is the last, cannot have."""


def _refuse_fixed_number(entry: Entry, stated: str, kind: str) -> None:
    for key in _OF_FIXED_NUMBERS:
        if key in entry.own:
            help = "state both for a record in the field" if key in ("count", "choice") else f"remove `{key}`"
            entry.refuse("wrong_form", key, f"a {kind} with `{stated}` has no `{key}`", help)


def _optional(entry: Entry) -> Ranges:
    """The number of elements of a field that is not always sent: 0 or 1, or up to the greatest number of a list."""
    _refuse_fixed_number(entry, "present_if", "field")
    repeat = entry.whole_ranges("repeat")
    if repeat is not None and (repeat.low != 1 or len(repeat.intervals) > 1):
        text = f"a list with `present_if` has at least one element, not {repeat.low}"
        entry.refuse("wrong_form", "repeat", text, "begin at 1: it has no element where it is not sent")
    return Ranges(((0, 1 if repeat is None else repeat.high),))


def _continuation(entry: Entry) -> Presence | None:
    """The bits of each element that say whether another one follows; None where none say it."""
    continuation = entry.entry("more_if")
    if continuation is None:
        return None
    _refuse_fixed_number(entry, "more_if", "list")
    repeat = entry.whole_ranges("repeat")
    if repeat is None or repeat.low != 1 or repeat.high < 2 or len(repeat.intervals) > 1:
        is_not = "" if repeat is None else f", not {repeat.text()}"
        text = f"a list with `more_if` has 1 to a greatest number of elements{is_not}"
        help = "state `repeat: 1..10`; with `present_if`, it may have no element as well"
        entry.refuse("wrong_form", "repeat" if repeat is not None else "more_if", text, help)
    if "in" in continuation.own and not entry.text("record"):
        text = "the elements have no fields"
        continuation.refuse("wrong_form", "in", text, "remove `in`: the element itself has the bits")
    if "in" not in continuation.own and entry.text("record"):
        text, help = (
            "the elements are records, and no field of them is named",
            "name the field with the bits under `in`",
        )
        entry.refuse("wrong_form", "more_if", text, help)
    return _presence(continuation, "in")


def _presence(entry: Entry, key: str) -> Presence:
    if "is" in entry.own and "when" in entry.own:
        entry.refuse("wrong_form", "is", "`is` has no effect without `bit`", "remove it, or state the `bit`")
    value = entry.integer("is")
    return Presence(entry.text(key), _bits(entry), 1 if value is None else value, entry.texts("when"))


def _bits(entry: Entry) -> tuple[tuple[int, int], ...]:
    """The bits that say whether something is sent; none where members say it."""
    if "when" in entry.own:
        return ()
    pieces = bit_pieces(entry)
    if "bits" in entry.own and pieces[0][0] == pieces[-1][1]:
        entry.refuse("wrong_form", "bits", "`bits` is a single bit", f"write `bit: {pieces[0][0]}`")
    return tuple(sorted(pieces))


def _choice(entry: Entry, field: Entry) -> Choice:
    """The cases of a field; keys of the field apply to the values of all cases."""
    shared = field.node
    for key in field.node.values.keys() - VALUE_KEYS:
        shared = shared.without(key)
    cases = tuple(inner.built(Case, value=value(inner)) for inner in entry.entries("cases", defaults=shared))
    return Choice(entry.text("by"), cases, entry.bit_range("bits"))


def _span(text: str) -> tuple[int, int] | None:
    if not text:
        return None
    first, _, last = text.partition("-")
    return int(first), int(last or first)


def message(entry: Entry, reused: Reused) -> Message:
    """A message. Its data are records that are named after it."""
    lengths, words = entry.entry("frame_length"), entry.entry("data_words")
    accesses, pieces = _accesses(entry), entry.entry("segments")
    entry = with_remote_request(entry)
    _refuse_unstated(entry)
    return entry.built(
        Message,
        answered_on=_answered_on(entry),
        request=_data(entry, "request", reused),
        response=_data(entry, "response", reused),
        request_length=lengths.integer("request") if lengths else None,
        response_length=lengths.integer("response") if lengths else None,
        request_words=words.integer("request") if words else None,
        response_words=words.integer("response") if words else None,
        handling=entry.handling(),
        accesses=accesses,
        segments=_segments(pieces) if pieces else None,
        response_code=_response_code(entry),
        is_requested=_is_requested(entry),
    )


def _refuse_unstated(entry: Entry) -> None:
    """Refuses a message without a request, and one without the response that is due: nothing says what they are."""
    if "request" not in entry.own and entry.maybe("requested") is not False:
        text = "the message has no `request`"
        help = "list the fields of its data, add `request: []` if it has none, or `requested: false` if only the device"
        entry.refuse("missing_key", "name", text, f"{help} sends it")
    if "response" in entry.own or ("answered_on" in entry.own and not entry.texts("answered_on")):
        return
    text = "the message has no `response`"
    help = "list the fields of its data, or add `response: []` if it has none"
    if "number" not in entry.own or "code" in entry.own:  # else requests and responses are sent without each other
        help = "list the fields of its data, add `response: []` if it has none, or `answered_on: []` if it never comes"
    entry.refuse("missing_key", "name", text, help)


_OF_REQUESTS = ("request", "remote", "accesses", "segments", "broadcast", "supplements", "response_code")
"""The keys of messages that say something of a request."""


def _is_requested(entry: Entry) -> bool:
    """Whether users send the message; one that only the device sends has no request."""
    if entry.maybe("requested") is not False:
        return True
    for key in _OF_REQUESTS:
        if key in entry.own:
            text = f"only the device sends the message, but it has `{key}`"
            help = "state its `code`" if key == "response_code" else f"remove `{key}`, or `requested`"
            entry.refuse("wrong_form", key, text, help)
    for key in ("frame_length", "data_words"):
        stated = entry.entry(key)
        if stated is not None and "request" in stated.own:
            text = f"only the device sends the message, but its `{key}` has a request"
            entry.refuse("wrong_form", key, text, "remove the request there, or `requested`")
    if "answered_on" in entry.own and not entry.texts("answered_on"):
        text = "the message is never answered, and the device does not send it of its own accord either"
        entry.refuse("wrong_form", "answered_on", text, "remove `answered_on`, or `requested`")
    return False


def _answered_on(entry: Entry) -> tuple[str, ...] | None:
    """The links on which a message is answered, None for all. One that never is has no response."""
    if "answered_on" not in entry.own:
        return None
    links = entry.texts("answered_on")
    if not links and "response" in entry.own:
        text = "the message is never answered, but it has a `response`"
        entry.refuse("wrong_form", "response", text, "remove `response`, or name the links under `answered_on`")
    return links


def _response_code(entry: Entry) -> int | None:
    """The code of the response if it differs from the code of the request."""
    code = entry.integer("response_code")
    if code is None:
        return None
    if "code" not in entry.own:
        text = "the message has a `response_code`, but its request has no `code`"
        entry.refuse("wrong_form", "response_code", text, "add `code`, or remove `response_code`")
    elif code == entry.integer("code"):
        text = "the response has the code of the request, as is usual"
        entry.refuse("wrong_form", "response_code", text, "remove `response_code`")
    if "answered_on" in entry.own and not entry.texts("answered_on"):
        text = "the message is never answered, but it has a `response_code`"
        entry.refuse("wrong_form", "response_code", text, "remove it, or name the links under `answered_on`")
    return code


def _segments(entry: Entry) -> Segments:
    if "unsized" in entry.own and "size" not in entry.own:
        entry.refuse(
            "wrong_form", "unsized", "`unsized` has no effect without `size`", "add `size`, or remove `unsized`"
        )
    if "unsized" in entry.own and "when" not in entry.own:
        text = "`unsized` has no effect without `when`: the request that writes always has its `size`"
        entry.refuse("wrong_form", "unsized", text, "remove `unsized`, or state `when` for a message that reads")
    return entry.built(Segments, abort=_segments_abort(abort) if (abort := entry.entry("abort")) else None)


def _segments_abort(entry: Entry) -> SegmentsAbort:
    return entry.built(SegmentsAbort)


def _accesses(entry: Entry) -> tuple[RegisterAccess, ...]:
    """The access of a message by which registers are read and written, or the steps of one that does more."""
    accesses = [*entry.entries("accesses")]
    own = accesses[0].own if len(accesses) == 1 else ()
    if "values" in own and {"and_mask", "or_mask"}.isdisjoint(own):
        return (_access(accesses[0]),)
    return tuple(_step(access) for access in accesses)


def _access(entry: Entry) -> RegisterAccess:
    if "clear" in entry.own and "set" not in entry.own:
        entry.refuse("wrong_form", "clear", "`clear` has no effect without `set`", "add `set`, or remove `clear`")
    return entry.built(RegisterAccess, clear=entry.integer("clear") or 0)


def _step(entry: Entry) -> RegisterAccess:
    for key in ("set", "clear"):
        if key in entry.own:
            text = f"`{key}` has no effect in a message with several accesses"
            entry.refuse("wrong_form", key, text, "remove it: such a message accesses words or bytes")
    return entry.built(RegisterAccess, set=None)


def _data(entry: Entry, direction: str, reused: Reused) -> Record:
    arguments = entry.fact() | {
        "name": f"{entry.text('name')}_{direction}",
        "doc": "",
        "notes": (),
        "restated": (),
        "inferred": {},
        "standard": {},
        "reported": (),
        "roles": (),
        "unverified": False,
    }
    separated = with_separators(entry, direction)
    fields = rows(separated, f"{entry.path}/{direction}", None, reused, _field, key=direction)
    return Record(**arguments, size=None, words=None, fields=fields)
