"""The unit addresses, the serial settings and the ports of a link, as facts below its heading."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.model.link import Link
from fieldspec.targets.docs.context import cited
from fieldspec.targets.docs.document import Line, joined, text_piece
from fieldspec.targets.docs.value_cells import spoken


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
