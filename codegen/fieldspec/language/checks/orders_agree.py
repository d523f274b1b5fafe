"""All links of a device have the same byte order and the same word order. If the device has values of several words,
such as registers or data counted in words, at least one link states the word order. Every link whose data is counted in
words states it too, and so does every link with values of several words if another link exchanges words. A value can
override the order. Only a writable value can override the order of a write, and only with an order that differs from
the order of a read.

Why: a value of several words needs a word order, which is stated and never assumed. One register cannot have two
orders. A protocol with only bytes needs no word order.

Example: a register of type `u32` on a device whose link has no `word_order`.

Fix: Add `word_order: big` or `word_order: little`, as inferred with a reason if the manual does not print
it.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.language.checks.facts import cases, layers, nested_fields, values
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.model.device import Device
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.record import Case, Field, Record
from fieldspec.language.model.registers import Register
from fieldspec.language.model.sizes import messages_on
from fieldspec.language.model.value import Value


def orders_agree(device: Device) -> Findings:
    links = list(device.links.values())
    for key in ("byte_order", "word_order"):
        ordered = [link for link in links if getattr(link, key)]
        for link in ordered[1:]:
            if getattr(link, key) != getattr(ordered[0], key):
                text = f"the links {ordered[0].name} and {link.name} have different orders"
                help = "a device has one order; correct one of the links"
                related_label = label(ordered[0].place, key, f"in {ordered[0].name}")
                yield finding(link.place, key, text, help, related_label)
    if links and not any(link.word_order for link in links) and _has_words(device):
        for fact, value in values(device):
            if value.has_words and not value.word_order and not isinstance(fact, Part):
                text = f"{fact.name} has several words, but no link states the word order"
                related_label = label(fact.place, "type", f"{value.type.name} has {value.size} bytes")
                yield finding(links[0].place, "word_order", text, "add `word_order` to the link", related_label)
                return
    for link in links:
        yield from _in_words(device, link)
    for register in device.registers():
        if register.value.write_word_order:
            yield from _of_write(device, register)


def _of_write(device: Device, register: Register) -> Findings:
    """Whether the order of a register's words differs between writing and reading."""
    value, key = register.value, "write_word_order"
    if register.access == "ro":
        text = f"{register.name} is read-only, so that its words are never written"
        related_label = label(register.place, "access", "its access")
        yield finding(register.place, key, text, "correct one of them", related_label)
    elif value.write_word_order == (value.word_order or device.word_order or value.byte_order or device.byte_order):
        text = f"the words of {register.name} are read in the same order"
        yield finding(register.place, key, text, "remove it, or correct the `word_order`")


def _in_words(device: Device, link: Link) -> Findings:
    """A link on which data are counted in words, or values have words, says itself which word of a number comes first.

    Where no link exchanges words, values need no word order.
    """
    if link.word_order:
        return
    other = next((other for other in device.links.values() if other.word_order not in ("", device.byte_order)), None)
    for message in messages_on(device, link):
        for data in (message.request, message.response):
            for field, value in _values(device, data):
                if not value.has_words or value.word_order or value.has_characters:
                    continue
                text = f"{field.name} has several words, but {link.name} does not state the word order"
                if isinstance(field, Field) and field.word_span is not None:
                    related_label = label(field.place, "word_span", "the words")
                    yield finding(link.place, "word_order", text, "add `word_order` to the link", related_label)
                    return
                if other is not None:
                    related_label = label(other.place, "word_order", f"{other.name} exchanges the words")
                    help = "add `word_order` to the value, or to the link for all values of several words"
                    yield finding(field.place, "type", text, help, related_label)
                    return


def _values(device: Device, record: Record) -> Iterator[tuple[Field | Case, Value]]:
    """The values of a record, of its cases, and of the records in it."""
    for field in nested_fields(device, record.fields):
        if field.value is not None:
            yield field, field.value
        for case in cases(field):
            yield case, case.value


def _has_words(device: Device) -> bool:
    """Whether anything of a device is counted in words of 16 bits."""
    if device.tables or any(register.unit_size == 2 for register in device.registers()):
        return True
    if any(
        device.word_access(message) is not None
        or device.bit_access(message) is not None
        or message.request_words is not None
        or message.response_words is not None
        for message in device.messages.values()
    ):
        return True
    return any(
        layer.words is not None or any(field.words is not None or field.word_span is not None for field in layer.fields)
        for layer in layers(device)
    )
