"""How the frames of a link are recognized in a stream of bytes."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.first_bytes import first_bytes
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.frame_extents import BY_COUNT, DELIMITED, OPEN, FrameExtent, FrameExtents, frame_extents
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.subcodes import Subcode
from fieldspec.language.model.link import LARGEST_SET
from fieldspec.targets.js.declaration import Names
from fieldspec.targets.js.text import code_literal, flag, literal, object_of, pairs_literal
from fieldspec.targets.js.values import sign_literal
from fieldspec.targets.runtime_values import is_wide

LONGEST = 0xFFFF
"""The bytes of a body that nothing bounds."""
WIDE = 6
"""The bytes of a number up to which it is not a bigint."""


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
    if frame.start and frame.end and link.link.transmission == "hex_ascii":
        return f"delimiterFramer({{ {', '.join(rows)} }})"
    if link.link.transmission != "binary":
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
        return f"lengthFramer({{ {', '.join([*rows, f'length: {_part_number(length)}'])} }})"
    data = ((message.name, message.message.code_of(direction), message.data(direction)) for message in carried)
    extents = frame_extents(link, direction, data if code is not None else (), refused)
    if frame.end and (code is None or extents.has(OPEN)):
        rows.append(f"decode: {spoken}.decode{direction.capitalize()}")
        needs_messages = code is None or link.ambiguous_codes(direction)
        messages = ", ".join(names.messages[message.name] for message in carried) if needs_messages else "undefined"
        rows.append(f"messages: [{messages}]")
        beginnings = (
            f"[{place}, [{', '.join(map(str, known))}]]" for place, known in first_bytes(link, direction).items()
        )
        rows.append(f"begins: [{', '.join(beginnings)}]")
        return f"endFramer({{ {', '.join(rows)} }})"
    if code is None:
        return None
    rows += [f"code: {_part_number(code, is_wide_part(code))}", f"extents: {_table(extents.by_code)}"]
    rows += [f"subcodes: {_subcodes(extents, frame)}"] if extents.by_subcode else []
    if extents.refusal is not None and refusal is not None:
        rows += [f"flag: {code_literal(refusal.flag)}", f"refusal: {_extent_row(extents.refusal)}"]
    else:
        rows += ["flag: 0", "refusal: undefined"]
    return f"codeFramer({{ {', '.join(rows)} }})"


def _table(extents: Mapping[int, FrameExtent]) -> str:
    """A JavaScript object with the extents of frames by their keys."""
    rows = (f"{code_literal(number)}: {_extent_row(extent)}" for number, extent in extents.items())
    return f"{{ __proto__: null, {', '.join(rows)} }}"


def _subcodes(extents: FrameExtents, frame: FrameLayout) -> str:
    """An object of what tells messages apart, and of their extents."""
    members = ", ".join(
        f"{code_literal(code)}: {{ {subcode_place(shared, frame.header_size)}, extents: {_table(own)} }}"
        for code, (shared, own) in extents.by_subcode.items()
    )
    return f"{{ __proto__: null, {members} }}"


def subcode_place(subcode: Subcode, header_size: int = 0) -> str:
    """The properties of a subcode that say where it is, after a header, and how to read it."""
    place = f"offset: {header_size + subcode.offset}, size: {subcode.size}, order: {literal(subcode.order)}"
    return f"{place}, signed: false{', wide: true' * (subcode.size > WIDE)}"


def _extent_row(extent: FrameExtent) -> str:
    """The length without the repeated part; then place and order of its count, and the bytes of each unit."""
    if extent.kind != BY_COUNT:
        return f"{{ length: {extent.length}, size: { ({DELIMITED: -2, OPEN: -1}.get(extent.kind, 0)) } }}"
    place = f'offset: {extent.offset}, size: {extent.size}, order: "{extent.order}", signed: false'
    return f"{{ length: {extent.length}, {place}, unit: {extent.unit}{', isTurned: true' * extent.is_turned} }}"


def is_wide_part(part: PartLayout) -> bool:
    """Whether the number of a part is a bigint."""
    return is_wide(part.value.encoding) if part.value is not None else part.size > WIDE


def bits_of(part: PartLayout) -> dict[str, str]:
    """The properties of a part that shares its bytes with others: its first bit, and the number of its bits."""
    return {"shift": str(part.shift), "width": str(part.width)} if part.width else {}


def _part_number(part: PartLayout, wide: bool = False) -> str:
    row = {
        "offset": str(part.offset),
        "size": str(part.size),
        "order": literal(part.order or "big"),
        "signed": sign_literal(part.value) if part.value is not None else flag(False),
        "unitSize": str(part.unit_size),
        "base": str(part.base),
        **bits_of(part),
    }
    row |= {"wide": flag(True)} if wide else {}
    return object_of(row | ({"digits": literal(part.form)} if part.form else {}))


def _bounds(link: LinkLayout, frame: FrameLayout, bodies: list[RecordLayout]) -> list[str]:
    smallest = min(record.least for record in bodies)
    largest = max(record.most if record.most is not None else LONGEST for record in bodies)
    width = 2 if link.link.transmission == "hex_ascii" else 1
    parts_size = frame.header_size + frame.trailer_size
    marks = len(frame.start) + len(frame.end)
    shortest, longest = (marks + width * (parts_size + size) for size in (smallest, largest))
    if frame.escape is not None and (frame.escape_start, frame.escape_stop) != (0, None):
        longest = frame.escape.most(longest)
    return [f"shortest: {shortest}", f"longest: {longest}"]


def _addresses(link: LinkLayout, frame: FrameLayout, direction: str) -> str:
    part, intervals = frame.role("unit_address"), link.framed_addresses(direction)
    if part is None or not intervals:
        return "addresses: null"
    wide = is_wide_part(part)
    number = f"address: {_part_number(part, wide)}"
    if wide or sum(high - low + 1 for low, high in intervals) > LARGEST_SET:
        return f"{number}, addresses: addressIntervals({pairs_literal(intervals, wide)})"
    numbers = [n for low, high in intervals for n in range(low, high + 1)]
    return f"{number}, addresses: new Set({numbers})"
