"""How the frames of a link are recognized in a stream of bytes."""

from __future__ import annotations

from fieldspec.backends.js.declaration import Names
from fieldspec.backends.js.text import flag, literal, object_of
from fieldspec.layout.first_bytes import first_bytes
from fieldspec.layout.frame import FrameLayout, LinkLayout, MessageLayout
from fieldspec.layout.part import PartLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.link import LARGEST_SET, ExceptionResponse

LONGEST = 0xFFFF
"""The bytes of a body that nothing bounds."""

OPEN = "{ length: 0, size: -1 }"
"""The extent of frames whose code does not determine their length."""


def framer(
    link: LinkLayout, direction: str, carried: list[MessageLayout], names: Names, frames: str, spoken: str
) -> str | None:
    """The call that makes a framer of `spoken`, the object of a link; None where nothing in a frame marks its end."""
    frame = link.frame(direction)
    refusal = link.link.exception_response if direction == "response" else None
    bodies = [message.data(direction) for message in carried]
    refused = names.layout.records[refusal.record] if refusal is not None else None
    bodies += [refused] if refused is not None else []
    if not bodies:
        return None
    rows = [
        f"...{frames}",
        f"parts: {frames}.{direction}",
        *_bounds(link, frame, bodies),
        _addresses(link, frame, direction),
    ]
    length, code = frame.role("length"), frame.role("code")
    if frame.start and frame.end and link.link.encoding == "hex_ascii":
        return f"delimiterFramer({{ {', '.join(rows)} }})"
    if link.link.encoding != "binary":
        return None
    if frame.escape is not None and (frame.escape_start, frame.escape_stop) == (0, None):
        if not frame.end:
            return None
        marks = len(frame.start) + len(frame.end)
        longest = max(record.most if record.most is not None else LONGEST for record in bodies)
        rows.append(f"most: {marks + frame.escape.most(frame.header_size + longest + frame.trailer_size)}")
        return f"escapeFramer({{ {', '.join(rows)} }})"
    if frame.escape is not None and (length is None or length.before_escape):
        return None
    if length is not None:
        return f"lengthFramer({{ {', '.join([*rows, f'length: {_number(length)}'])} }})"
    extents, subcodes = _extents(link, frame, carried, refusal, refused) if code is not None else ({}, {})
    if frame.end and (code is None or OPEN in extents.values()):
        rows.append(f"decode: {spoken}.decode{direction.capitalize()}")
        needed = code is None or link.ambiguous_codes(direction)
        messages = ", ".join(names.messages[message.name] for message in carried) if needed else "undefined"
        rows.append(f"messages: [{messages}]")
        begins = (f"[{place}, [{', '.join(map(str, known))}]]" for place, known in first_bytes(link, direction).items())
        rows.append(f"begins: [{', '.join(begins)}]")
        return f"endFramer({{ {', '.join(rows)} }})"
    if code is None:
        return None
    rows += [f"code: {_number(code)}", f"extents: {_table(extents)}"]
    members = ", ".join(f"{number}: {{ {place}, extents: {_table(own)} }}" for number, (place, own) in subcodes.items())
    rows += [f"subcodes: {{ __proto__: null, {members} }}"] if subcodes else []
    if refused is not None and refusal is not None and refusal.flag:
        rows += [f"flag: {refusal.flag}", f"refusal: {_extent(link, frame, refused)}"]
    else:
        rows += ["flag: 0", "refusal: undefined"]
    return f"codeFramer({{ {', '.join(rows)} }})"


def _extents(
    link: LinkLayout,
    frame: FrameLayout,
    carried: list[MessageLayout],
    refusal: ExceptionResponse | None,
    refused: RecordLayout | None,
) -> tuple[dict[int, str], dict[int, tuple[str, dict[int, str]]]]:
    """The extents by code.

    Of the codes that messages of several extents share, also the place of the subcode, and the extents by its number.
    """
    named = {message.name: _extent(link, frame, message.data(frame.direction)) for message in carried}
    each: dict[int, set[str]] = {}
    for message in carried:
        number = message.message.code_of(frame.direction)
        if number is not None:
            each.setdefault(number, set()).add(named[message.name])
    extents = {code: next(iter(own)) if len(own) == 1 else OPEN for code, own in each.items()}
    if refused is not None and refusal is not None and not refusal.flag:
        own = _extent(link, frame, refused)
        extents |= {refusal.code: own} if refusal.code is not None else {}
        if refusal.part:
            # The code determines the length only where exception responses are as long as others.
            return {number: extent if extent == own else OPEN for number, extent in extents.items()}, {}
    subcodes = {}
    for code, shared in link.subcodes(frame.direction).items():
        if len(each.get(code, ())) > 1:
            offset = frame.header_size + shared.offset
            place = f"offset: {offset}, size: {shared.size}, order: {literal(shared.order)}, signed: false"
            subcodes[code] = place, {number: named[message.name] for number, message in shared.messages.items()}
            del extents[code]
    return extents, subcodes


def _table(extents: dict[int, str]) -> str:
    """An object of extents."""
    return f"{{ __proto__: null, {', '.join(f'{number}: {extent}' for number, extent in extents.items())} }}"


def _number(part: PartLayout) -> str:
    row = {
        "offset": str(part.offset),
        "size": str(part.size),
        "order": literal(part.order or "big"),
        "signed": flag(bool(part.value and part.value.type.signed)),
        "unitSize": str(part.unit_size),
        "base": str(part.base),
    }
    return object_of(row | ({"digits": literal(part.form)} if part.form else {}))


def _bounds(link: LinkLayout, frame: FrameLayout, bodies: list[RecordLayout]) -> list[str]:
    least = min(record.least for record in bodies)
    most = max(record.most if record.most is not None else LONGEST for record in bodies)
    width = 2 if link.link.encoding == "hex_ascii" else 1
    around = frame.header_size + frame.trailer_size
    marks = len(frame.start) + len(frame.end)
    shortest, longest = (marks + width * (around + size) for size in (least, most))
    if frame.escape is not None and (frame.escape_start, frame.escape_stop) != (0, None):
        longest = frame.escape.most(longest)
    return [f"shortest: {shortest}", f"longest: {longest}"]


def _addresses(link: LinkLayout, frame: FrameLayout, direction: str) -> str:
    part, addresses = frame.role("unit_address"), link.link.unit_addresses
    if part is None or addresses is None or addresses.ranges is None:
        return "addresses: null"
    intervals = addresses.intervals(direction)
    if sum(high - low + 1 for low, high in intervals) > LARGEST_SET:
        return f"address: {_number(part)}, addresses: addressIntervals({[list(bounds) for bounds in intervals]})"
    numbers = [n for low, high in intervals for n in range(low, high + 1)]
    return f"address: {_number(part)}, addresses: new Set({numbers})"


def _extent(link: LinkLayout, frame: FrameLayout, record: RecordLayout) -> str:
    """The length without the repeated part; then place and order of its count, and the bytes of each unit."""
    around = len(frame.start) + frame.header_size + frame.trailer_size + len(frame.end)
    if record.size is not None:
        return f"{{ length: {around + record.size}, size: 0 }}"
    tail = record.fields[-1]
    if record.count_of_text is not None:
        count, others = record.count_of_text
        place = f"offset: {frame.header_size + count.offset}, size: {count.size}"
        return f'{{ length: {around + others}, {place}, order: "{count.order}", signed: false, unit: 1 }}'
    if record.spans:
        return f"{{ length: {around + record.first_bytes}, size: -2 }}" if frame.end else OPEN
    measures = [
        field
        for field in record.fields
        if field.field.measures is not None
        and field.field.measures.field == tail.name
        and field.size <= 4
        and record.has_place(field)
    ]
    if not measures or tail.cases or measures[0].field.measures is None or not record.has_single_list:
        return OPEN
    measure = measures[0]
    assert measure.field.measures is not None
    unit = measure.field.measures.unit(tail.size)
    length = around + tail.offset - measure.field.measures.plus * unit
    return (
        f"{{ length: {length}, offset: {frame.header_size + measure.offset}, size: {measure.size},"
        f' order: "{measure.order}", signed: false, unit: {unit} }}'
    )
