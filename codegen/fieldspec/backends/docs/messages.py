"""The messages, byte by byte."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.context import Context, cited, many
from fieldspec.backends.docs.document import Facts, Line, Section, Table, code, joined, plain
from fieldspec.backends.docs.frames import FrameTable, length_text
from fieldspec.layout.frame import LinkLayout
from fieldspec.layout.message import MessageLayout

DIRECTIONS = ("request", "response")


def messages(context: Context) -> Section:
    """All messages by code, those without a code by their numbers behind them."""
    inner = tuple(_message(context, laid) for laid in sorted(context.layout.messages.values(), key=_by_code))
    return Section("messages", (plain("Messages"),), (), inner)


def _by_code(laid: MessageLayout) -> tuple[bool, int]:
    code = laid.message.code
    return code is None, (laid.message.number if code is None else code) or 0


def _message(context: Context, laid: MessageLayout) -> Section:
    message = laid.message
    path = message.place.path
    blocks = context.opening(message)
    blocks.append(Facts(tuple(_facts(context, laid))))
    sent = [link for link in context.layout.links.values() if laid.name in link.messages]
    for number, link in enumerate(sent):
        for direction in DIRECTIONS:
            blocks.append(_frame(context, laid, link, direction, "messages/" if number == 0 else ""))
    title = message.title or " ".join(message.name.split("_")).capitalize()
    shown: Line = () if message.code is None else (code(_code(context, message.code)), plain(" "))
    return Section(path, (*shown, *context.section_title(title, message)), tuple(blocks))


def _code(context: Context, number: int) -> str:
    """A code in as many digits as the frames have bytes for it."""
    parts = (link.frame(direction).role("code") for link in context.layout.links.values() for direction in DIRECTIONS)
    size = max((part.size for part in parts if part is not None), default=1)
    return f"0x{number:0{2 * size}X}"


def _frame(context: Context, laid: MessageLayout, link: LinkLayout, direction: str, anchored: str) -> Table:
    anchor = f"{laid.message.place.path}/{link.name}-{direction}"
    record = laid.data(direction)
    shape = link.frame(direction)
    title = link.link.direction_name(direction).capitalize()
    length = length_text(shape.head_size + shape.tail_size, record)
    if link.link.encoding == "hex_ascii":
        length += ", as two characters each"
    caption = f"{title} on {link.link.title or link.name}: {length}"
    return FrameTable(context, link, direction, anchor, anchored).table(caption, record, laid.message.code)


def _facts(context: Context, laid: MessageLayout) -> Iterator[tuple[str, tuple[Line, ...]]]:
    message = laid.message
    yield "Name", ((code(message.name),),)
    if message.number is not None:
        yield "Number", ((code(str(message.number)),),)
    if message.links:
        yield "Sent on", (joined((code(name, f"#links/{name}"),) for name in message.links),)
    if message.supplements:
        beside = joined((code(name, f"#messages/{name}"),) for name in message.supplements)
        yield "Sent beside", ((*beside, plain(", never alone")),)
    if message.group:
        yield "Group", ((plain(" ".join(message.group.split("_"))),),)
    if message.code is not None:
        yield "Code", ((code(_code(context, message.code)), plain(f" ({message.code})")),)
    printed = [
        f"{direction} {many(length, 'byte')}"
        for direction, length in zip(DIRECTIONS, (message.request_length, message.response_length), strict=True)
        if length is not None
    ]
    if printed:
        yield "Frame length as printed", ((plain(", ".join(printed)),),)
    words = [
        f"{direction} {many(number, 'word')}"
        for direction, number in zip(DIRECTIONS, (message.request_words, message.response_words), strict=True)
        if number is not None
    ]
    if words:
        yield "Words of data as printed", ((plain(", ".join(words)),),)
    if message.broadcast:
        yield "Broadcast", ((plain("may be sent to all stations at once"),),)
    if message.accesses is not None:
        verb, spaces = f"{message.accesses.operation}s", context.device.spaces
        if spaces:
            space = context.device.space(message.accesses.space)
            yield "Accesses", ((plain(f"{verb} {space.title or space.name}", f"#{space.place.path}"),),)
        else:
            yield "Accesses", ((plain(f"{verb} registers", "#registers"),),)
    examples = [example for example in context.device.examples.values() if example.message == message.name]
    if examples:
        yield "Examples", (joined((plain(example.id, f"#{example.place.path}"),) for example in examples),)
    if message.sources:
        yield "Source", (cited(message.sources),)
    again = [citation for claim in message.restated for citation in claim.sources]
    if again:
        yield "Printed again", (cited(again),)
