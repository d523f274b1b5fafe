"""A link describes its frames completely: the byte order, one body, the code of a request, and which parts
the length counts and the checksum covers. At most one link is the `default`.

Why: the byte order is stated for each link and never assumed. A frame cannot be decoded if no part identifies its
message or carries its data.

Example: a link with two messages whose requests have no part with the role `code`.

Fix: Add the `byte_order` or the missing part, or list the parts in the order of the wire. The unit address, the code,
lengths and parts that the user supplies come before the body; constants and reserved parts can be anywhere. A length
counts adjacent parts that include the body. A checksum covers adjacent parts that do not include itself; an escaped
checksum covers no length that counts the sent bytes. The byte that SLIP or COBS removes from frames is the delimiter.
If frames really carry no code, name the link under `links` of each of its messages and omit their codes; the caller of
the decoder then states the message.
"""

from __future__ import annotations

from collections import Counter

from fieldspec.language.checks.finding import Findings, finding, label, near
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count, is_signed
from fieldspec.language.model.escape import SLIP
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.sizes import coded, messages_on
from fieldspec.language.model.subcodes import WIDEST
from fieldspec.language.model.value import Value

_NUMBERS = ("unit_address", "code", "length")
_GREATEST_SIZES = {"unit_address": 8, "code": WIDEST, "length": 4}


def links_complete(device: Device) -> Findings:
    defaults = [link for link in device.links.values() if link.is_default]
    for link in defaults[1:]:
        text = f"{link.name} and {defaults[0].name} are both the default link"
        help = "state `default: true` only at the link that the device uses with factory settings"
        yield finding(link.place, "default", text, help, label(defaults[0].place, "default", "the first one"))
    for link in device.links.values():
        if not link.byte_order:
            text = f"the link {link.name} has no byte order"
            yield finding(link.place, "byte_order", text, "add `byte_order: big` or `byte_order: little`")
        for direction in ("request", "response"):
            yield from _of_parts(device, link, direction, link.parts(direction))
        yield from _messages_distinct(device, link)
        yield from _escapable(link)
        yield from _preambled(link)
        yield from _marked(link)
        if link.unit_addresses is not None and not any(
            part.role == "unit_address" for part in (*link.request, *link.response)
        ):
            text = f"`unit_addresses` has no effect in {link.name}, which has no part with the role unit_address"
            help = "add `role: unit_address` to the part with the address, or remove `unit_addresses`"
            yield finding(link.place, "unit_addresses", text, help)
        error = link.exception_response
        is_coded = any(part.role == "code" for part in link.response)
        if error is not None and not (error.field or error.part) and not is_coded:
            text = f"the link {link.name} marks exception responses in the code, but its responses have no code"
            help = "add the role `code` to the part with the code, or state `part` or `field`"
            yield finding(link.place, "exception_response", text, help)


def _marked(link: Link) -> Findings:
    """The part that marks exception responses is one that responses have before their body, and that may differ."""
    error = link.exception_response
    if error is None or error.normal is None:
        return
    body = next((index for index, part in enumerate(link.response) if part.role == "body"), len(link.response))
    names = [part.name for part in link.response[:body]]
    part = next((part for part in link.response[:body] if part.name == error.part), None)
    if part is None:
        text = f"responses on {link.name} have no part {error.part} before their body"
        yield finding(link.place, "exception_response", text, near(error.part, names))
        return
    value = part.value
    if part.role != "plain" or value is None or value.const is not None or part.reserved:
        text = f"{part.name} cannot mark an exception response, because it is not a number that varies"
        help = "name a part without a `role`, and without `const` or `reserved`"
        yield finding(link.place, "exception_response", text, help, label(part.place, "name", part.name))
        return
    if any(not error.permitted(value, is_exception).intervals for is_exception in (False, True)):
        text = f"{part.name} is always or never one of {error.normal.text()}"
        help = "correct `normal`, or the range of the part"
        yield finding(link.place, "exception_response", text, help, label(part.place, "name", part.name))


def _messages_distinct(device: Device, link: Link) -> Findings:
    """A link without codes carries one message, or messages that are known to have none."""
    messages = messages_on(device, link)
    odd = next((message for message in messages if message.code is not None or not message.links), None)
    if len(messages) > 1 and odd is not None and not coded(link):
        text = f"the link {link.name} has no code in its requests, but it has {len(messages)} messages"
        description = "has a code" if odd.code is not None else "does not say on which links it is sent"
        related_label = label(odd.place, "code" if odd.code is not None else "name", f"{odd.name} {description}")
        help = "add the role `code` to the part with the code, or add `links` to the messages and remove their codes"
        yield finding(link.place, "request", text, help, related_label)


def _frame(link: Link, direction: str) -> str:
    """What findings call a frame: the same for both directions where the spec states them once."""
    is_common = "request" in link.place and link.place["request"] == link.place["response"]
    return f"the frame of {link.name}" if is_common else f"the {direction} of {link.name}"


_REPEATED = {
    "unit_address": "keep the one with the address of the device; another address is a part without a `role`",
    "code": "if they are neighbours, state one part as wide as all of them, such as `u16` for two bytes, and codes that"
    " have the numbers of all; if the second comes right before the body, state it as the first field of each message,"
    " with a `const`",
    "body": "state the body once; what all messages have beside other data are fields of each",
}


def _of_parts(device: Device, link: Link, direction: str, parts: tuple[Part, ...]) -> Findings:
    if direction not in link.place:
        text = f"the {direction} of {link.name} has no parts"
        help = "state them under `frame`, or under `request` and `response` where these differ"
        yield finding(link.place, direction, text, help)
        return
    roles = Counter(part.role for part in parts)
    for role in (*_NUMBERS, "body"):
        if role != "length" and (roles[role] > 1 or (role == "body" and not roles[role])):
            text = f"{_frame(link, direction)} has {roles[role]} parts with the role {role}"
            help = _REPEATED[role] if roles[role] else "add the part with `role: body`, for the data of the message"
            yield finding(link.place, direction, text, help)
    for part in parts:
        yield from _of_type(device, part)
    names = [part.name for part in parts]
    if len(set(names)) == len(names) and roles["body"] == 1:
        for part in parts:
            if part.role in ("length", "checksum"):
                yield from _of_span(link, direction, part)
        yield from _before_escape(link, direction)
        yield from _computable(link, direction)
    roles_in_order = [part.role for part in parts]
    for part in parts[roles_in_order.index("body") :] if "body" in roles_in_order else ():
        if part.role in _NUMBERS:
            role = part.role.replace("_", " ")
            text = f"the {role} {part.name} comes after the body"
            help = f"list it before the body: no output can read a frame whose {role} follows the data"
            yield finding(part.place, "name", text, help)
        if part.role == "plain" and part.value is not None and part.value.const is None and not part.reserved:
            text = f"{part.name} follows the body, but has no value"
            help = (
                "give it a `const`; parts that users supply come before the body, or are the last field of each message"
            )
            yield finding(part.place, "name", text, help)


def _of_type(device: Device, part: Part) -> Findings:
    """Whether codecs can take the value of a part for a number."""
    if part.value is None:
        return
    kind, role = part.value.type, part.role.replace("_", " ")
    if part.role == "plain":
        if not is_count(kind.encoding):
            text = f"the part {part.name} is {kind.name}, which is not a number"
            yield finding(part.place, "type", text, "use an integer type")
        enum = device.enums.get(part.value.enum)
        if enum is not None and not enum.open:
            text = f"the enum {enum.name} of the part {part.name} is closed, but frames can contain other values"
            related_label = label(enum.place, "name", "the enum")
            yield finding(part.place, "enum", text, "set `open: true` on the enum", related_label)
    elif not is_count(kind.encoding):
        text = f"the {role} {part.name} is {kind.name}, which is not a number"
        yield finding(part.place, "type", text, "use an integer type")
    elif is_signed(kind.encoding) or kind.size > _GREATEST_SIZES[part.role]:
        greatest = _GREATEST_SIZES[part.role]
        text = f"the {role} {part.name} is {kind.name}; it must be unsigned, with at most {greatest} bytes"
        yield finding(part.place, "type", text, f"use an integer type from `u8` to `u{8 * greatest}`")


def _missing_part(link: Link, direction: str, name: str, names: list[str]) -> str:
    """The help for a name that no part has: that of a delimiter, or one like another."""
    if direction == "response" and name in (part.name for part in link.request):
        return (
            f"nothing in a response counts or covers {name} of the request: correct the name; or, where a checksum is "
            "also that of bytes of the request, state it as the last field of each response, and compare it yourself"
        )
    marks = dict(zip(("start", "end"), link.marks(direction), strict=True))
    if not marks.get(name):
        return near(name, names)
    size, place = len(marks[name]), "first" if name == "start" else "last"
    order = ", byte_order: big" if size > 1 else ""
    part = f"type: u{8 * size}{order}, const: 0x{marks[name].hex().upper()}" if size <= 8 else "type: bytes"
    return (
        f"`{name}` is a delimiter and no part, so nothing counts or covers it: name one of "
        f"{', '.join(names)}; or state `{{name: {name}, {part}}}` as the {place} part instead of `{name}`"
    )


def _of_span(link: Link, direction: str, part: Part) -> Findings:
    """Whether a length counts, or a check covers, neighbouring parts that it can."""
    parts = link.parts(direction)
    key = "measures" if part.role == "length" else "covers"
    names = [part.name for part in parts]
    for name in (part.span.first, part.span.last):
        if name and name not in names:
            text = f"{_frame(link, direction)} has no part {name}"
            yield finding(
                part.place, key, text, _missing_part(link, direction, name, [own for own in names if own != part.name])
            )
    numbers = link.span(direction, part)
    if numbers is None:
        return
    first, last = numbers
    if part.role == "length":
        if first > last or not any(part.role == "body" for part in parts[first : last + 1]):
            text = f"the length {part.name} does not count the body, so it is constant"
            help = "count the body too, or replace the role of the part by a `const`"
            yield finding(part.place, key, text, help)
    elif first > last or (part.span.first and names.index(part.span.first) > last):
        text = f"the checksum {part.name} covers nothing"
        yield finding(part.place, key, text, "name the first and the last part in the order of the wire")
    elif first <= names.index(part.name) <= last:
        text = f"the checksum {part.name} covers itself"
        yield finding(part.place, key, text, "end before it, or begin after it")


def _computable(link: Link, direction: str) -> Findings:
    """Whether no checksums cover each other, so that one of them is computed first."""
    parts = link.parts(direction)
    checks = {part.name: part for part in parts if part.role == "checksum" and part.algorithm}
    covered = {}
    for name, part in checks.items():
        first, last = link.span(direction, part) or (0, -1)
        covered[name] = {inner.name for inner in parts[first : last + 1]} & checks.keys() - {name}
    while ready := [name for name, inner_names in covered.items() if not inner_names & covered.keys()]:
        for name in ready:
            del covered[name]
    for name in list(covered)[:1]:
        part, other = checks[name], checks[sorted(covered[name] & covered.keys())[0]]
        text = f"the checksums {name} and {other.name} cover each other, so none can be computed first"
        help = "let one of them end before the other under `covers`"
        yield finding(part.place, "covers", text, help, label(other.place, "covers", other.name))


def _of_sent_bytes(link: Link, direction: str) -> Findings:
    """Whether no checksum of original bytes covers a part of those that are sent, as each would depend on the other."""
    parts, (start, stop) = link.parts(direction), link.escaped_span(direction) or (0, -1)
    of_original = [start <= index <= stop or part.span.before_escape for index, part in enumerate(parts)]
    of_sent = [
        index for index, part in enumerate(parts) if part.role in ("length", "checksum") and not of_original[index]
    ]
    for index, part in enumerate(parts):
        first, last = link.span(direction, part) or (0, -1)
        covered = next((parts[index] for index in of_sent if first <= index <= last), None)
        if part.role == "checksum" and of_original[index] and covered is not None:
            is_length = covered.role == "length"
            text = f"{part.name} covers the bytes before they are escaped, but {covered.name} "
            text += "counts what is sent" if is_length else "covers what is sent"
            related_label = label(covered.place, "name", f"the {covered.role}")
            help = f"leave the {covered.role} out under `covers`, or escape both parts or neither of them"
            yield finding(part.place, "name", text, help, related_label)


def _before_escape(link: Link, direction: str) -> Findings:
    """Whether `before_escape` changes anything: where bytes are escaped, for a part that is not escaped itself."""
    start, stop = link.escaped_span(direction) or (0, -1)
    for index, part in enumerate(link.parts(direction)):
        if part.span.before_escape and (link.escape is None or link.is_can or start <= index <= stop):
            key = "measures" if part.role == "length" else "covers"
            text = f"`before_escape` has no effect: {part.name} is escaped itself, so that it is of the original bytes"
            if link.escape is None or link.is_can:
                text = f"`before_escape` has no effect: the link {link.name} escapes no bytes"
            yield finding(part.place, key, text, "remove `before_escape`")


def _of_mark(link: Link, direction: str) -> Findings:
    """Whether something marks frames with the byte that SLIP or COBS keeps out of them."""
    escape, parts = link.escape, link.parts(direction)
    whole = escape is not None and not escape.first and not escape.last  # then another end mark has a finding anyway
    mark = 0 if escape is not None and escape.method == "cobs" else SLIP[0][0]
    if escape is None or (escape.method != "cobs" and escape.pairs != SLIP):
        return
    first, last = link.escaped_span(direction) or (0, len(parts) - 1)
    unescaped_values = [
        part.value
        for index, part in enumerate(parts)
        if not first <= index <= last and part.value is not None and part.bits is None
    ]
    marks = [
        *link.delimiters(direction),
        *(_constant_bytes(value) for value in unescaped_values if value.const is not None),
    ]
    if not any(mark in delimiter for delimiter in marks) and not (whole and link.delimiters(direction)[1]):
        name = "COBS" if escape.method == "cobs" else "SLIP"
        text = f"{name} keeps {mark:02X} out of {_frame(link, direction)}, but no such byte marks where it ends"
        yield finding(link.place, "escape", text, f'add `end: "{mark:02X}"`, or remove `escape`')


def _preambled(link: Link) -> Findings:
    """Whether frames show where their preamble ends, and have a length, by which framers find them."""
    preamble, key = link.preamble, "preamble"
    if preamble is None:
        return
    if link.transmission != "binary" or link.is_can or (link.escape is not None and not link.escape.first):
        text = f"the link {link.name} has a preamble, but the first parts of its frames are not sent as they are"
        yield finding(link.place, key, text, "state the bytes that are always there as `start`")
        return
    for direction in ("request", "response"):
        opening = link.opening(direction)
        if not opening or opening[0] == preamble.byte:
            text = f"nothing shows where the preamble of {_frame(link, direction)} ends"
            help = "state a `start`, or a `const` of one byte as the first part, with another byte first"
            yield finding(link.place, key, text, help)
        elif not any(part.role == "length" for part in link.parts(direction)):
            text = f"{_frame(link, direction)} has a preamble, but no length shows where it ends"
            yield finding(link.place, key, text, "add the part with `role: length`, or state `start`")


def _constant_bytes(value: Value) -> bytes:
    """The bytes of a constant, in any order."""
    return ((value.const or 0) & (1 << 8 * value.size) - 1).to_bytes(value.size, "big")


def _escapable(link: Link) -> Findings:
    """Whether the escape of a link applies to parts that it has, the body among them, and hides the end mark."""
    escape = link.escape
    if escape is None or link.is_can:
        return
    if link.transmission != "binary":
        text = f"the link {link.name} escapes bytes, but sends characters"
        yield finding(link.place, "escape", text, "remove `escape`, or state `transmission: binary`")
    for direction in ("request", "response"):
        parts = link.parts(direction)
        names = [part.name for part in parts]
        for name in (escape.first, escape.last):
            if name and name not in names:
                text = f"{_frame(link, direction)} has no part {name}"
                yield finding(link.place, "escape", text, near(name, names))
        first, last = link.escaped_span(direction) or (0, len(parts) - 1)
        if not any(part.role == "body" for part in parts[first : last + 1]):
            text = f"the body of {_frame(link, direction)} is not escaped"
            yield finding(link.place, "escape", text, "name the first and the last part around the body")
        yield from _of_sent_bytes(link, direction)
        yield from _of_mark(link, direction)
    whole = not escape.first and not escape.last
    for end in dict.fromkeys((link.end, link.response_end)):
        # A mark of several bytes, and one that is doubled within frames, differ from what is sent for a byte.
        pairs = [pair for pair in escape.pairs if len(set(pair)) > 1] if len(end) == 1 else []
        escape_bytes = {byte for _, *replacement in pairs for byte in replacement}
        bounded = {"replace": bool(end) and end[0] in {byte for byte, _, _ in escape.pairs} - escape_bytes}
        bounded |= {"cobs": end[:1] == b"\0", "insert": True, "add": False}
        if whole and end and not bounded[escape.method]:
            mark = end.hex(" ").upper()
            text = f"the end mark {mark} of {link.name} may occur within a frame, because the escape does not change it"
            help = "escape the first byte of the mark, or name the escaped parts by `from` and `to`"
            if end[0] in escape_bytes:
                text = (
                    f"the end mark {mark} of {link.name} may occur within a frame, because the escape writes this byte"
                )
                help = "state the `byte` and the `mask` with which escapes are sent; neither gives the mark"
            yield finding(link.place, "escape", text, help)
