"""Links: the frames of both directions, the messages that they carry, and the framers."""

from __future__ import annotations

from collections.abc import Sequence

from fieldspec.codec.layout.carrying import carries
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.foundation.names import Name
from fieldspec.language.model.link import ExceptionResponse
from fieldspec.language.model.ranges import Ranges
from fieldspec.language.model.record import Message
from fieldspec.targets.explainer.literals import EXACT
from fieldspec.targets.explainer.wire import checksum_function, escape_object
from fieldspec.targets.fact_texts import described
from fieldspec.targets.js.declaration import Declaration, Names
from fieldspec.targets.js.framing import bits_of, framer, is_wide_part, subcode_place
from fieldspec.targets.js.naming import property_scope
from fieldspec.targets.js.text import (
    PURE,
    code_literal,
    comment,
    flag,
    integer_literal,
    literal,
    object_of,
    pairs_literal,
)
from fieldspec.targets.js.values import sign_literal

_CODES = "number | bigint"


def declare_message(message: MessageLayout, names: Names) -> Declaration:
    """The object of a message, whose request and response have been declared."""
    name, own = names.messages[message.name], message.message
    request = names.records[message.request.name] if own.is_requested else "null"
    response = names.records[message.response.name] if own.is_answered else "null"
    number = f", {own.number}" if own.number is not None else ""
    request_code, response_code = own.code_of("request"), own.code_of("response")
    if response_code is not None and own.has_response_code:
        number = f"{number or ', undefined'}, {code_literal(response_code, 2)}"
    code = "null" if request_code is None else code_literal(request_code, 2)
    arguments = f"{literal(message.name)}, {code}, {request}, {response}{number}"
    codes = f", {_CODES}" if _has_wide_codes(own) else ""
    request_type, response_type = (data if data != "null" else "never" for data in (request, response))
    return Declaration(
        [f"export const {name} = /* @__PURE__ */ message({arguments});", ""],
        [
            *comment(described(own.title or Name.of(message.name).title(), own)),
            f"export declare const {name}: Message<{literal(message.name)}, {request_type}, {response_type}{codes}>;",
            "",
        ],
    )


def _has_wide_codes(message: Message) -> bool:
    """Whether a number does not have a code of a message exactly."""
    return max(message.code or 0, message.response_code or 0) > EXACT


def declare_link(link: LinkLayout, names: Names) -> Declaration:
    """The object of a link, and its framers."""
    name = names.scope.take(Name.of(link.name).camel(), f"{Name.of(link.name).camel()}Link")
    pascal = Name.of(link.name).pascal()
    carried = [message for message in names.layout.messages.values() if carries(link, message)]
    exception = link.link.exception_response
    addresses = link.link.unit_addresses
    frames = f"framesOf{pascal}"
    code = [f"const {frames} = /* @__PURE__ */ frames({{"]
    code += [f"  name: {literal(link.name)},", f"  hex: {flag(link.link.transmission == 'hex_ascii')},"]
    for direction in ("request", "response"):
        frame = link.frame(direction)
        order = [frame.parts.index(part) for part in frame.checksums]
        code += [f"  {direction}: {{", *_parts("header", link, direction), *_parts("trailer", link, direction)]
        escape_stop = "null" if frame.escape_stop is None else str(frame.escape_stop)
        code += [
            f"    start: {list(frame.start)},",
            f"    end: {list(frame.end)},",
            *_preamble(frame),
            f"    checksums: {order},",
            f"    escape: {escape_object(frame.escape)},",
            f"    escapeStart: {frame.escape_start},",
            f"    escapeStop: {escape_stop},",
            "  },",
        ]
    units = [part for frame in (link.request, link.response) for part in frame.header if part.role == "unit_address"]
    wide = any(map(is_wide_part, units))
    ranges = _intervals(addresses.ranges, wide) if addresses is not None else "null"
    stated = addresses.broadcast if addresses is not None else None
    broadcast = "null" if stated is None else integer_literal(stated, wide)
    code.append(
        f"  unitAddresses: {'null' if addresses is None else f'{{ ranges: {ranges}, broadcast: {broadcast} }}'},"
    )
    code += ["});", ""]
    refusal = "null" if exception is None else _exception(link, exception, names)
    carried_names = ", ".join(names.messages[message.name] for message in carried)
    unanswered = [names.messages[m.name] for m in carried if m.name not in link.carried("response")]
    subcodes = _subcodes(link, names)
    barred = [names.messages[message.name] for message in carried if message.name in link.barred_messages]
    options = f", [{', '.join(unanswered)}]" if unanswered or subcodes or barred else ""
    options += f", {subcodes or '{}'}" if subcodes or barred else ""
    options += f", [{', '.join(barred)}]" if barred else ""
    code += [f"export const {name} = /* @__PURE__ */ link({frames}, [{carried_names}], {refusal}{options});", ""]
    headers = {direction: _header_type(link.frame(direction)) for direction in ("request", "response")}
    record = names.records[exception.record] if exception is not None else "never"
    messages = " | ".join(f"typeof {names.messages[message.name]}" for message in carried) or "never"
    has_wide_codes = any(_has_wide_codes(message.message) for message in carried)
    has_wide_codes |= exception is not None and (exception.code or 0) > EXACT
    kinds = ["bigint" if wide else "number", _CODES if has_wide_codes else "number"]
    arguments = [messages, record, *(kinds if has_wide_codes else kinds[:1] if wide else [])]
    types = [
        *comment(described(link.link.title or Name.of(link.name).title(), link.link)),
        f"export declare const {name}: Link<{', '.join([*headers.values(), *arguments])}>;",
        "",
    ]
    for direction in ("request", "response"):
        sent_messages = [message for message in carried if message.name in link.carried(direction)]
        row = framer(link, direction, sent_messages, names, frames, name)
        if row is not None:
            own = names.scope.take(f"{Name.of(link.name).camel()}{direction.capitalize()}Framer")
            code += [f"export const {own} = () => {row};", ""]
            types += [
                *comment([f"A framer that finds the {direction}s of this link in a stream."]),
                f"export declare function {own}(): Framer;",
                "",
            ]
    return Declaration(code, types)


def _subcodes(link: LinkLayout, names: Names) -> str:
    """The subcodes of messages that share a code, by direction and code; empty where no two messages share one."""
    directions = []
    for direction in ("request", "response"):
        rows = []
        for code, shared in link.subcodes(direction).items() if link.frame(direction).role("code") is not None else ():
            members = ", ".join(
                f"[{code_literal(number)}, {names.messages[own.name]}]" for number, own in shared.messages.items()
            )
            rows.append(f"[{code_literal(code)}, {{ {subcode_place(shared)}, messages: {PURE} new Map([{members}]) }}]")
        for code, messages in link.ambiguous_codes(direction).items():
            rows.append(
                f"[{code_literal(code)}, {{ answers: [{', '.join(names.messages[own.name] for own in messages)}] }}]"
            )
        directions.append(f"{direction}: {PURE} new Map([{', '.join(rows)}])" if rows else "")
    return f"{{ {', '.join(filter(None, directions))} }}" if any(directions) else ""


def _exception(link: LinkLayout, exception: ExceptionResponse, names: Names) -> str:
    """The mark of exception responses and their record."""
    row = {"flag": code_literal(exception.flag), "record": names.records[exception.record]}
    if link.mark is not None:
        row["mark"] = f"{{ offset: {link.mark.offset}, bytes: {list(link.mark.pattern)} }}"
    if exception.code is not None:
        row["code"] = code_literal(exception.code)
    part = next((part for part in link.response.header if part.name == exception.part), None)
    if part is not None and part.value is not None:
        row["part"] = literal(part.name)
        for name, is_exception in (("normal", False), ("marks", True)):
            row[name] = _intervals(exception.permitted(part.value, is_exception), is_wide_part(part))
        row["all"] = _intervals(exception.normal, is_wide_part(part))
    return object_of(row)


def _header_type(frame: FrameLayout) -> str:
    rows = [
        f"readonly {key}: {'bigint' if is_wide_part(part) else 'number'}"
        for key, part in zip(argument_keys(frame.header), frame.header, strict=True)
        if key
    ]
    return f"{{ {'; '.join(rows)} }}" if rows else "Record<string, never>"


def argument_keys(parts: Sequence[PartLayout]) -> list[str]:
    """The properties of the parts that the caller supplies; empty for the others."""
    scope = property_scope()
    return [
        scope.take("unitAddress" if part.role == "unit_address" else Name.of(part.name).camel())
        if part.is_argument and not part.reserved
        else ""
        for part in parts
    ]


def _parts(place: str, link: LinkLayout, direction: str) -> list[str]:
    frame = link.frame(direction)
    parts = frame.header if place == "header" else frame.trailer
    lines = [f"    {place}: ["]
    for part, key in zip(parts, argument_keys(parts), strict=True):
        wide = is_wide_part(part) and part.role not in ("length", "checksum")
        low, high = (part.value.low, part.value.high) if part.value else (0, (1 << 8 * part.size) - 1)
        row = {
            "name": literal(part.name),
            "role": literal(part.role),
            "key": literal(key) if key else "null",
            "offset": str(part.offset),
            "size": str(part.size),
            "order": literal(part.order or "big"),
            "signed": sign_literal(part.value) if part.value is not None else flag(False),
            "wide": flag(wide),
            "low": integer_literal(low, wide),
            "high": integer_literal(high, wide),
            "reserved": flag(part.reserved),
            "unitSize": str(part.unit_size),
            "base": str(part.base),
            "start": str(part.start),
            "stop": "null" if part.stop is None else str(part.stop),
            "beforeEscape": flag(part.before_escape),
            "constant": "null" if part.constant is None else integer_literal(part.constant, wide),
            "ranges": _intervals(part.value.ranges, wide) if part.value else "null",
        }
        row |= bits_of(part)
        if part.form:
            row["digits"] = literal(part.form)
        if part.role == "checksum":
            row |= {"algorithm": checksum_function(part.algorithm, part.order), "digits": literal(part.digits)}
        lines.append(f"      {object_of(row)},")
    return [*lines, "    ],"]


def _preamble(frame: FrameLayout) -> list[str]:
    """The line of a preamble, if frames have one."""
    own = frame.preamble
    if own is None:
        return []
    return [
        f"    preamble: {{ byte: {own.byte}, least: {own.least}, further: {len(own.further)}, spare: {own.spare} }},"
    ]


def _intervals(ranges: Ranges | None, wide: bool = False) -> str:
    if ranges is None:
        return "null"
    return pairs_literal(ranges.intervals, wide)
