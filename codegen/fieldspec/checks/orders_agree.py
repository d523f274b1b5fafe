"""All links of a device have the same byte order and the same word order, which is given where it matters.

Why: a value of several words means nothing without the order of its words. It is stated and never
assumed; and the same register cannot have two orders.

Example: a register of type `u32` on a device whose link has no `word_order`.

Cure: Give `word_order: big` or `little`, as inferred with a reason if the manual does not print it.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.finding import finding, label
from fieldspec.checks.walking import values
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Device
from fieldspec.model.link import Part
from fieldspec.model.primitive import Kind

_CODE = "orders_agree"


def orders_agree(device: Device) -> Iterator[Diagnostic]:
    links = list(device.links.values())
    for key in ("byte_order", "word_order"):
        given = [link for link in links if getattr(link, key)]
        for link in given[1:]:
            if getattr(link, key) != getattr(given[0], key):
                text = f"the links {given[0].name} and {link.name} have different orders"
                help = "a device has one order; give both links the right one"
                there = label(given[0].place, key, f"that of {given[0].name}")
                yield finding(_CODE, link.place, key, text, help, there)
    if links and not any(link.word_order for link in links):
        for fact, value in values(device):
            wide = value.size > 2 and value.type.kind in (Kind.INTEGER, Kind.FLOAT)
            if wide and not isinstance(fact, Part):
                text = f"{fact.name} has several words, and no link says in which order they come"
                there = label(fact.place, "type", f"{value.type.name} has {value.size} bytes")
                yield finding(_CODE, links[0].place, "word_order", text, "give the link its `word_order`", there)
                return
