"""Rules about frames, message codes and links."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.classes import replace
from fieldspec.language.changes.attributes import PYTHON, C
from fieldspec.language.changes.change import Change, Effect
from fieldspec.language.changes.comparison import Comparison, Pair
from fieldspec.language.changes.descriptions import change, changed, difference_text, named
from fieldspec.language.changes.evidence import hexadecimal, value_text
from fieldspec.language.changes.message_texts import SUBJECTS_OF_BITS, access_text, bits_text, segments_text, steps_text
from fieldspec.language.model.device import Detection, Device, Version, VersionLine
from fieldspec.language.model.link import ExceptionResponse, Link, Part
from fieldspec.language.model.record import Field, Measure, Message
from fieldspec.language.model.value import ParameterPart

_KEYS = {
    "transmission": "the transmission",
    "preamble": "the preamble",
    "start": "the start delimiter",
    "end": "the end delimiter",
    "response_start": "the start delimiter of responses",
    "response_end": "the end delimiter of responses",
    "escape": "the escape",
}


def framing_changed(comparison: Comparison) -> Iterator[Change]:
    """Frames have different delimiters, a different preamble, encoding or escape, or parts have different bits.

    Why: neither side recognises the frames of the other.

    Example: `end: 0D` that becomes `end: 0D 0A`, or `transmission: binary` that becomes `transmission: hex_ascii`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Link):
        for key, subject in _KEYS.items():
            old, new = _framing(pair.old, key), _framing(pair.new, key)
            common = key.startswith("response_") and pair.old.has_common_delimiters and pair.new.has_common_delimiters
            if old != new and not common:
                yield from changed(Effect.WIRE, pair, key, subject, old, new)
    for part in comparison.of(Part):
        yield from changed(Effect.WIRE, part, "bits", "its bits", _bits(part.old), _bits(part.new))


def _bits(part: Part) -> str:
    """The bits that a part takes, as a spec has them."""
    return "..".join(map(str, part.bits)) if part.bits is not None else ""


def _framing(link: Link, key: str) -> bytes | str:
    """An attribute of a link that decides how frames look."""
    if key == "escape":
        return link.escape.text() if link.escape is not None else ""
    if key == "preamble":
        return link.preamble.text() if link.preamble is not None else ""
    direction = "response" if key.startswith("response_") else "request"
    marks = dict(zip(("start", "end"), link.marks(direction), strict=True))
    value: bytes | str = marks[key.removeprefix("response_")] if key != "transmission" else link.transmission
    return value


def check_changed(comparison: Comparison) -> Iterator[Change]:
    """A checksum's algorithm, prefix, suffix or digits, or the parts that a checksum or length covers, have changed.

    Why: each side rejects the frames of the other.

    Example: `algorithm: sum8` that becomes `algorithm: lrc`, or `measures: {plus: 2}` that becomes
    `measures: {plus: 3}`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Part):
        if pair.old.algorithm != pair.new.algorithm:
            for key, old, new in _computations(pair.old, pair.new):
                yield from changed(Effect.WIRE, pair, key, f"the {key}", old, new)
        yield from changed(Effect.WIRE, pair, "digits", "the digits", pair.old.digits, pair.new.digits)
        old, new = _span_text(pair.old), _span_text(pair.new)
        if old != new and _extent(comparison, pair, 0) != _extent(comparison, pair, 1):
            check = "checksum" in (pair.old.role, pair.new.role)
            subject, key = ("what it covers", "covers") if check else ("what it counts", "measures")
            yield from changed(Effect.WIRE, pair, key, subject, old, new)


def _computations(old: Part, new: Part) -> Iterator[tuple[str, str, str]]:
    """What differs between two algorithms: the one that is stated, or else the bytes before or after the covered."""
    if old.stated_algorithm != new.stated_algorithm:
        yield "algorithm", old.stated_algorithm, new.stated_algorithm
        return
    for key, before, after in (("prefix", old.prefix, new.prefix), ("suffix", old.suffix, new.suffix)):
        if before != after:
            yield key, before.hex(" ").upper(), after.hex(" ").upper()


def _extent(comparison: Comparison, pair: Pair[Part], side: int) -> tuple[object, ...]:
    """The parts that a part counts or covers, explicitly or by default: the first and the last part, by new names."""
    link, part = pair.containers[side], (pair.old, pair.new)[side]
    path = part.place.path.rpartition("/")[0]
    direction = path.rpartition("/")[2]
    span = link.span(direction, part)
    names = (
        [link.parts(direction)[index].name for index in span] if span is not None else (part.span.first, part.span.last)
    )
    if side == 0:
        names = [comparison.renamed_to(path, name) for name in names]
    return *names, part.unit_size, part.plus, part.span.before_escape


def _span_text(part: Part) -> str:
    """The span that a length counts, or a checksum covers: `words from command to body plus 2`, `from
    command to body`.
    """
    span = part.span
    words = [f"from {span.first}"] if span.first else []
    words += [f"to {span.last}"] if span.last else []
    words += ["before escape"] if span.before_escape else []
    if part.role == "checksum":
        return " ".join(words) or "all before it"
    text = " ".join(["words" if part.unit_size == 2 else "bytes", *(words or ["of the frame"])])
    return f"{text} {'plus' if part.plus > 0 else 'minus'} {abs(part.plus)}" if part.plus else text


def code_changed(comparison: Comparison) -> Iterator[Change]:
    """The code of a message or of its response, or the number of a message without a code, has changed; or a remote
    request of a CAN bus is sent instead of data.

    Why: existing programs send the wrong message, and misread the messages that they receive.

    Example: `code: 0x2F` that becomes `code: 0x30`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Message):
        if pair.old.code != pair.new.code:
            old, new = hexadecimal(pair.old.code), hexadecimal(pair.new.code)
            yield from changed(Effect.WIRE, pair, "code", "the code", old, new)
        response_codes = pair.old.code_of("response"), pair.new.code_of("response")
        is_stated = pair.old.response_code is not None or pair.new.response_code is not None
        if is_stated and response_codes[0] != response_codes[1]:
            old, new = map(hexadecimal, response_codes)
            yield from changed(Effect.WIRE, pair, "response_code", "the code of the response", old, new)
        if (pair.old.remote is None) != (pair.new.remote is None):
            old, new = ("data" if own.remote is None else "remote request" for own in (pair.old, pair.new))
            yield from changed(Effect.WIRE, pair, "remote", "the request", old, new)
        effect = Effect.WIRE if pair.new.code is None else Effect.DOCS
        yield from changed(effect, pair, "number", "the number", pair.old.number, pair.new.number)


def exception_response_changed(comparison: Comparison) -> Iterator[Change]:
    """The bit of the code that marks an exception response, or the record of that response, has changed.

    Why: programs mistake an exception response for a normal response, or misread its reason.

    Example: `exception_response: {flag: 0x80}` that becomes `exception_response: {flag: 0x40}`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for pair in comparison.of(Link):
        old, new = (
            _error_text(comparison, pair.old.exception_response, True),
            _error_text(comparison, pair.new.exception_response, False),
        )
        yield from changed(Effect.WIRE, pair, "exception_response", "the exception response", old, new)


def _error_text(comparison: Comparison, error: ExceptionResponse | None, before: bool) -> str:
    if error is None:
        return ""
    record = comparison.renamed_to("records", error.record) if before else error.record
    mark = f"bit {hexadecimal(error.flag)}" if error.flag else error.mark_text
    return f"{mark} and the record {record or 'without fields'}"


def role_changed(comparison: Comparison) -> Iterator[Change]:
    """The purpose of a field or of a frame part has changed: it measures, selects, repeats or carries a different
    value.

    Why: the same bytes are read as a length, a code, an address or an ordinary value.

    Example: `role: plain` that becomes `role: unit_address`, or `measures: {bytes: values}` that becomes `measures:
    {items: values}`.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for part in comparison.of(Part):
        yield from changed(Effect.WIRE, part, "role", "the role", part.old.role, part.new.role)
        request_path = part.old.place.path.rpartition("/")[0].rpartition("/")[0] + "/request"
        same = comparison.renamed_to(request_path, part.old.same_as) if part.old.same_as else ""
        yield from changed(Effect.BEHAVIOUR, part, "same_as", "the part that it repeats", same, part.new.same_as)
    for field in comparison.of(Field):
        yield from _of_field(comparison, field)
    for value_pair in comparison.values:
        old, new = _parameter(value_pair.old.parameter, comparison), _parameter(value_pair.new.parameter, None)
        yield from changed(Effect.WIRE, value_pair, "parameter", "the part of a parameter that it is", old, new)
    for message in comparison.of(Message):
        before, after = access_text(comparison, message.old), access_text(None, message.new)
        yield from changed(Effect.WIRE, message, "accesses", "how it accesses registers", before, after)
        before, after = steps_text(comparison, message.old), steps_text(None, message.new)
        yield from changed(Effect.WIRE, message, "accesses", "the sequence of its accesses to registers", before, after)
        before, after = segments_text(comparison, message.old), segments_text(None, message.new)
        yield from changed(Effect.WIRE, message, "segments", "how its value follows in pieces", before, after)


def _of_field(comparison: Comparison, pair: Pair[Field]) -> Iterator[Change]:
    holder_path = pair.old.place.path.rpartition("/")[0]
    old, new = _measure(pair.old.stated_measure), _measure(pair.new.stated_measure)
    if (measure := pair.old.stated_measure) is not None:
        old = _measure(replace(measure, field=comparison.renamed_to(holder_path, measure.field)))
    yield from changed(Effect.WIRE, pair, "measures", "what it measures", old, new)
    for key, subject in SUBJECTS_OF_BITS.items():
        old, new = bits_text(comparison, holder_path, pair.old, key), bits_text(None, holder_path, pair.new, key)
        yield from changed(Effect.WIRE, pair, key, subject, old, new)
    if pair.old.choice and pair.new.choice:
        old = replace(pair.old.choice, by=comparison.renamed_to(holder_path, pair.old.choice.by)).subject
        yield from changed(Effect.WIRE, pair, "choice", "what decides its type", old, pair.new.choice.subject)
    request_path = holder_path.rpartition("/")[0] + "/request"
    repeated_name = pair.old.same_as and comparison.renamed_to(request_path, pair.old.same_as)
    yield from changed(Effect.BEHAVIOUR, pair, "same_as", "the field that it repeats", repeated_name, pair.new.same_as)


def _measure(measure: Measure | None) -> str:
    plus = f" plus {measure.plus}" if measure and measure.plus else ""
    bits = f" in bits {measure.bits[0]}..{measure.bits[1]}" if measure and measure.bits else ""
    return f"the {measure.of} of {measure.field}{plus}{bits}" if measure else ""


def _parameter(part: ParameterPart | None, comparison: Comparison | None) -> str:
    if part is None:
        return ""
    name = comparison.renamed_to("parameters", part.set) if comparison else part.set
    sizes = f", {value_text(part.sizes)}" if part.sizes else ""
    return f"the {part.part} of {name}" + (f" by {part.number}" if part.number else "") + sizes


def sending_changed(comparison: Comparison) -> Iterator[Change]:
    """The links on which a message is sent or answered, or the messages together with which it is sent, have changed.

    Why: the device does not understand the message on a removed link, and may reject it together with other messages. A
    program waits for a response that does not arrive, or mistakes it for the response to a different request.

    Example: `links: [rtu, ascii]` that becomes `links: [rtu]`.

    Fix: Nothing to do if links or messages are added. If the old spec was wrong, accept the change with that reason;
    otherwise, assign a new version number.
    """

    for pair in comparison.of(Message):
        links = tuple(comparison.renamed_to("links", name) for name in _links(comparison.old, pair.old))
        answering_links = tuple(comparison.renamed_to("links", name) for name in _answered_on(comparison.old, pair.old))
        supplements = tuple(comparison.renamed_to("messages", name) for name in pair.old.supplements)
        if pair.old.is_requested != pair.new.is_requested:
            words = "users send it" if pair.new.is_requested else "only the device sends it"
            text = f"{named(pair.new)}: {words} now"
            values = pair.old.is_requested, pair.new.is_requested
            yield change(Effect.WIRE, pair, "requested", text, *values)
        for key, subject, old, new, fallback in (
            ("links", "where it is sent", links, _links(comparison.new, pair.new), pair.new.links),
            ("answered_on", "where it is answered", answering_links, _answered_on(comparison.new, pair.new), None),
            ("supplements", "what it is sent with", supplements, pair.new.supplements, pair.new.supplements),
        ):
            stated = getattr(pair.old, key) or fallback
            if key == "answered_on":
                stated = (pair.old.answered_on, pair.new.answered_on) != (None, None)
            if stated and sorted(old) != sorted(new):
                lost = key == "answered_on" or (key == "links" and bool(set(old) - set(new)))
                yield from changed(Effect.WIRE if lost else Effect.BEHAVIOUR, pair, key, subject, old, new)


def _answered_on(device: Device, message: Message) -> tuple[str, ...]:
    return tuple(name for name in _links(device, message) if message.is_answered_on(name))


def _links(device: Device, message: Message) -> tuple[str, ...]:
    return message.links or tuple(device.links)


def broadcast_changed(comparison: Comparison) -> Iterator[Change]:
    """The broadcast address, or the permission to broadcast a request, has changed.

    Why: all devices carry out a request to one device, or no device carries it out.

    Example: `broadcast: 0` that becomes `broadcast: 255` at the `unit_addresses` of a link.

    Fix: If the old spec was wrong, accept the change with that reason; otherwise, assign a new version number.
    """

    for link in comparison.of(Link):
        old, new = (side.unit_addresses.broadcast if side.unit_addresses else None for side in (link.old, link.new))
        yield from changed(Effect.WIRE, link, "unit_addresses", "the address of all stations", old, new)
    for message in comparison.of(Message):
        if message.old.broadcast != message.new.broadcast:
            text = {True: "can", False: "cannot", None: "may or may not"}[message.new.broadcast]
            yield change(
                Effect.BEHAVIOUR,
                message,
                "broadcast",
                f"{named(message.new)} {text} be sent to all stations",
                message.old.broadcast,
                message.new.broadcast,
            )


def building_changed(comparison: Comparison) -> Iterator[Change]:
    """A different version line has its own outputs.

    Why: generated modules and headers have the names of versions, so programs no longer find the modules and headers
    that they use.

    Example: `builds: true` that moves from the line `firmware` to the line `hardware`.

    Fix: Keep the line that has the outputs, or tell users the new names.
    """

    for pair in comparison.of(VersionLine):
        old, new = pair.old.builds, pair.new.builds
        if old != new:
            text = f"the versions of {named(pair.new)} {'have' if new else 'no longer have'} outputs of their own"
            yield change(Effect.SOURCE, pair, "builds", text, old, new, (PYTHON, C))


def detection_changed(comparison: Comparison) -> Iterator[Change]:
    """A different value identifies the version of the device, or its interpretation has changed.

    Why: programs choose the code for the version by this value.

    Example: `places: 2` instead of `places: 1`.

    Fix: Regenerate the code, and compare the value with that of a real device.
    """

    for pair in comparison.of(VersionLine):
        old, new = (_detection_text(side.detected_by) for side in (pair.old, pair.new))
        if old != new:
            text = f"{named(pair.new)}: {difference_text('detected_by', old or None, new or None)}"
            yield change(Effect.BEHAVIOUR, pair, "detected_by", text, old, new, (PYTHON,))
    for version in comparison.of(Version):
        old, new = (", ".join(map(str, side.detected_as)) for side in (version.old, version.new))
        if old != new:
            text = f"{version.new.id}: {difference_text('what tells it', old or None, new or None)}"
            yield change(Effect.BEHAVIOUR, version, "detected_as", text, old, new, (PYTHON,))


def _detection_text(detection: Detection | None) -> str:
    if detection is None:
        return ""
    return " ".join(filter(None, (detection.fact, detection.form, str(detection.places or ""))))
