"""The links: frames, stations, serial settings."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.backends.docs.context import Context, cited
from fieldspec.backends.docs.document import Facts, Line, Section, code, joined, plain
from fieldspec.backends.docs.frames import FrameTable
from fieldspec.backends.docs.value_cells import spoken
from fieldspec.layout.explaining.worded import decimal_text
from fieldspec.layout.frame import LinkLayout
from fieldspec.model.link import Link, Part

ENCODINGS = {"binary": "bytes as they are", "hex_ascii": "each byte as two hexadecimal characters, the high one first"}
ORDERS = {
    "big": "the most significant first",
    "little": "the least significant first",
}


def links(context: Context) -> Section:
    """All links of the device."""
    inner = tuple(_link(context, laid) for laid in context.layout.links.values())
    return Section("links", (plain("Links"),), (), inner)


def _link(context: Context, laid: LinkLayout) -> Section:
    link = laid.link
    blocks = context.opening(link)
    blocks.append(Facts(tuple(_facts(link))))
    if _alike(link):
        frame = FrameTable(context, laid, "request", f"{link.place.path}/frame", "links/")
        blocks.append(frame.table("Requests and responses", None))
    else:
        for direction, title in (("request", "Requests"), ("response", "Responses")):
            anchor = f"{link.place.path}/{direction}-frame"
            blocks.append(FrameTable(context, laid, direction, anchor, "links/").table(title, None))
    if link.error is not None:
        anchor = f"{link.place.path}/refusal-frame"
        body = context.layout.records[link.error.record]
        frame = FrameTable(context, laid, "response", anchor, "")
        blocks.append(frame.table("Responses that refuse a request", body))
    return Section(link.place.path, context.section_title(link.title or link.name, link), tuple(blocks))


def _alike(link: Link) -> bool:
    """Whether requests and responses have the same parts."""

    def told(part: Part) -> tuple[object, ...]:
        return part.name, part.role, part.value, part.algorithm, part.doc, part.label, part.notes, part.sources

    return [told(part) for part in link.request] == [told(part) for part in link.response]


def _facts(link: Link) -> Iterator[tuple[str, tuple[Line, ...]]]:
    yield "Name", ((code(link.name),),)
    yield "Encoding", ((plain(ENCODINGS[link.encoding]),),)
    if link.start:
        yield "Starts with", ((code(link.start.hex(" ").upper()),),)
    if link.end:
        yield "Ends with", ((code(link.end.hex(" ").upper()),),)
    if link.byte_order:
        yield "Bytes of a number", ((plain(ORDERS[link.byte_order]),),)
    if link.word_order:
        yield "Words of a number", ((plain(ORDERS[link.word_order]),),)
    if link.silence_characters is not None:
        yield "Silence between frames", ((plain(f"{decimal_text(link.silence_characters)} characters"),),)
    if link.silence_milliseconds is not None:
        yield "Silence between frames", ((plain(f"{decimal_text(link.silence_milliseconds)} ms"),),)
    if link.silence_sources:
        yield "Source of the silence", (cited(link.silence_sources),)
    if link.error is not None:
        text = f"the code of the request with the bits {link.error.flag:02X}h set, and the record "
        yield "Refusals", ((plain(text), code(link.error.record, f"#records/{link.error.record}")),)
    yield from _stations(link)
    yield from _serial(link)
    if link.sources:
        yield "Source", (cited(link.sources),)


def _stations(link: Link) -> Iterator[tuple[str, tuple[Line, ...]]]:
    stations = link.stations
    if stations is None:
        return
    if stations.ranges is not None:
        yield "Stations", ((plain(spoken(stations.ranges.text())),),)
    if stations.broadcast is not None:
        yield "All stations", ((plain(str(stations.broadcast)),),)
    if stations.rule:
        yield "How a station is set", ((plain(stations.rule),),)
    for note in stations.notes:
        yield "Note on the stations", ((plain(note),),)
    if stations.sources:
        yield "Source of the stations", (cited(stations.sources),)


def _serial(link: Link) -> Iterator[tuple[str, tuple[Line, ...]]]:
    serial = link.serial
    if serial is None:
        return
    if serial.baud:
        default = "" if serial.default_baud is None else f"; {serial.default_baud} by default"
        yield "Baud rate", ((plain(f"{', '.join(map(str, serial.baud))} bit/s{default}"),),)
    for title, held in (
        ("Start bits", () if serial.start_bits is None else (serial.start_bits,)),
        ("Data bits", serial.data_bits),
        ("Parity", serial.parity),
        ("Stop bits", serial.stop_bits),
    ):
        if held:
            yield title, (joined(((plain(str(one)),) for one in held), " or "),)
    if serial.sources:
        yield "Source of the settings", (cited(serial.sources),)
