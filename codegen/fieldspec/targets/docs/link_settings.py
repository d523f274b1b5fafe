"""The facts of a link below its heading: its frames, unit addresses, serial settings and ports."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.link import Link
from fieldspec.targets.docs.context import cited
from fieldspec.targets.docs.document import Line, code, joined, text_piece
from fieldspec.targets.docs.value_cells import spoken

ENCODINGS = {"binary": "bytes as they are", "hex_ascii": "each byte as two hexadecimal characters, the high one first"}
ORDERS = {"big": "the most significant first", "little": "the least significant first"}


def link_facts(link: Link) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """All facts of a link: their names and the lines of their values."""
    yield "Name", ((code(link.name),),)
    yield "Encoding", ((text_piece(ENCODINGS[link.transmission]),),)
    common = link.has_common_delimiters
    if link.preamble is not None:
        yield "Preamble", ((text_piece(link.preamble.text()),),)
    for direction in ("request",) if common else ("request", "response"):
        frames = "" if common else f", {link.direction_name(direction)}s"
        for verb, mark in zip(("Starts", "Ends"), link.marks(direction), strict=True):
            if mark:
                yield f"{verb} with{frames}", ((code(mark.hex(" ").upper()),),)
    if link.escape is not None:
        yield "Identifier" if link.is_can else "Escaped bytes", ((text_piece(link.escape.text()),),)
    if link.byte_order:
        yield "Bytes of a number", ((text_piece(ORDERS[link.byte_order]),),)
    if link.word_order:
        yield "Words of a number", ((text_piece(ORDERS[link.word_order]),),)
    if link.silence_characters is not None:
        yield "Silence between frames", ((text_piece(f"{link.silence_characters:f} characters"),),)
    if link.silence_milliseconds is not None:
        yield "Silence between frames", ((text_piece(f"{link.silence_milliseconds:f} ms"),),)
    if link.silence_sources:
        yield "Source of the silence", (cited(link.silence_sources),)
    if link.exception_response is not None:
        error = link.exception_response
        text = f"the code of the request with the bits 0x{error.flag:02X} set, and the record "
        if not error.flag:
            text = f"{error.mark_text}, and the record "
        yield (
            "Refusals",
            ((text_piece(text), code(link.exception_response.record, f"#records/{link.exception_response.record}")),),
        )
    if link.is_default:
        yield "Factory setting", ((text_piece("the device uses this link with factory settings"),),)
    yield from address_facts(link)
    yield from serial_facts(link)
    yield from network_facts(link)
    if link.sources:
        yield "Source", (cited(link.sources),)


def address_facts(link: Link) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """The addresses on the line and how they are set."""
    addresses = link.unit_addresses
    if addresses is None:
        return
    if addresses.ranges is not None:
        yield "Unit addresses", ((text_piece(spoken(addresses.ranges.text())),),)
    if addresses.broadcast is not None:
        yield "Broadcast address", ((text_piece(str(addresses.broadcast)),),)
    if addresses.rule:
        yield "How to set the unit address", ((text_piece(addresses.rule),),)
    for note in addresses.notes:
        yield "Note on unit addresses", ((text_piece(note),),)
    if addresses.sources:
        yield "Source of unit addresses", (cited(addresses.sources),)


def serial_facts(link: Link) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """The settings of the serial line."""
    serial = link.serial
    if serial is None:
        return
    if serial.baud:
        default = "" if serial.default_baud is None else f"; {serial.default_baud} by default"
        yield "Baud rate", ((text_piece(f"{', '.join(map(str, serial.baud))} bit/s{default}"),),)
    for title, settings, factory in (
        ("Start bits", () if serial.start_bits is None else (serial.start_bits,), None),
        ("Data bits", serial.data_bits, serial.default_data_bits),
        ("Parity", serial.parity, serial.default_parity),
        ("Stop bits", serial.stop_bits, None),
    ):
        if settings:
            default_piece = (text_piece(f"; {factory} by default"),) if factory else ()
            yield title, ((*joined(((text_piece(str(setting)),) for setting in settings), " or "), *default_piece),)
    if serial.sources:
        yield "Source of the settings", (cited(serial.sources),)


def network_facts(link: Link) -> Iterator[tuple[str, tuple[Line, ...]]]:
    """The ports on which the device listens."""
    for protocol, port in link.ports:
        yield f"{protocol.upper()} port", ((text_piece(str(port)),),)
    if link.network is not None and link.network.sources:
        yield "Source of the ports", (cited(link.network.sources),)
