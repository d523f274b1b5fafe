"""What outputs refuse that convert neither digits to numbers nor encodings of texts, and print no codecs."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.package_codecs import value_refusal
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value

_TEXT_KEYS = ("encoding", "padding", "align", "terminator", "varies", "byte_order")


def character_refusals(
    layout: DeviceLayout, reader: str, for_controllers: bool = False, reads_frames: bool = True
) -> list[Refusal]:
    """A refusal of each value that is sent as digits, and of each text in a form of its own.

    `reader` is what does not convert them. One that does not read whole frames has no use for their parts.
    """
    facts = {
        fact.place.path: (fact, value)
        for fact, value in (*(_part_values(layout) if reads_frames else ()), *_values(layout))
        if value is not None and (value.digits or value.text_form is not None or value.width)
    }
    return [
        value_refusal(fact, value, reader)
        if value.codec
        else _of_digits(fact, reader, for_controllers)
        if value.digits
        else _of_text(fact, value, reader, for_controllers)
        for fact, value in facts.values()
    ]


def _of_digits(fact: Fact, reader: str, for_controllers: bool) -> Refusal:
    finding = Diagnostic(
        "plc_numbers_binary" if for_controllers else "output_numbers_binary",
        f"{fact.name} is sent as digits, which {reader} does not convert",
        fact.place["digits"],
        help=LEAVE_OUT,
    )
    return Refusal(fact, finding)


def _of_text(fact: Fact, value: Value, reader: str, for_controllers: bool) -> Refusal:
    key = next((key for key in _TEXT_KEYS if key in fact.place), "name")
    text = f"{fact.name} is not ASCII filled up with zeros after it, and {reader} converts no other text"
    if value.width:
        key, text = "varies", f"{fact.name} varies in length, and {reader} reads only texts of one length"
    finding = Diagnostic(
        "plc_texts_ascii" if for_controllers else "output_texts_ascii",
        text,
        fact.place[key],
        help=LEAVE_OUT,
    )
    return Refusal(fact, finding)


def _values(layout: DeviceLayout) -> Iterator[tuple[Fact, Value | None]]:
    """The registers, fields and cases of a version with their values."""
    for register in layout.registers:
        yield register.register, register.register.value
    bodies = (body for message in layout.messages.values() for body in message.bodies)
    for record in (*layout.records.values(), *bodies):
        for field in record.fields:
            yield field.field, field.value
            yield from ((case.case, case.value) for case in field.cases)


def _part_values(layout: DeviceLayout) -> Iterator[tuple[Fact, Value | None]]:
    """The parts of frames with their values."""
    for link in layout.links.values():
        for part in (*link.request.parts, *link.response.parts):
            yield part.part, part.value
