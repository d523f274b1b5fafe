"""Which codecs of packages a device uses, and what an output leaves out for which a package has no text."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.refusal import Refusal
from fieldspec.language.diagnostics import LEAVE_OUT, Diagnostic
from fieldspec.language.model.checksums import checksum_named
from fieldspec.language.model.codecs import ChecksumCodec, Codec, NumberCodec, checksum_codec, number_codec
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value

Text = Callable[[Codec], str]
"""The text of a codec for an output."""


def number_codecs(layout: DeviceLayout) -> dict[str, NumberCodec]:
    """The codecs of the numbers of a device, by name."""
    return {value.codec: number_codec(value.codec) for _, value in _coded_values(layout)}


def checksum_codecs(layout: DeviceLayout) -> dict[str, ChecksumCodec]:
    """The codecs of the checksums of a device, by name."""
    return {name: checksum_codec(name) for _, name in _coded_checksums(layout)}


def codec_refusals(layout: DeviceLayout, title: str, text: Text) -> list[Refusal]:
    """A refusal of each number and of each checksum whose codec has no text for an output with a title."""
    return [
        *(
            value_refusal(fact, value, title)
            for fact, value in _coded_values(layout)
            if not text(number_codec(value.codec))
        ),
        *checksum_refusals(layout, title, text),
    ]


def value_refusal(fact: Fact, value: Value, title: str) -> Refusal:
    """The refusal of a number whose codec has no text for an output with a title."""
    return _refusal(fact, "codec", f"{fact.name} is sent by the codec {value.codec}, which has no text for {title}")


def checksum_refusals(layout: DeviceLayout, title: str, text: Text = lambda _: "") -> list[Refusal]:
    """A refusal of each checksum whose codec has no text for an output with a title."""
    return [
        _refusal(part.part, "checksum", f"the checksum {part.name} has the codec {name}, which has no text for {title}")
        for part, name in _coded_checksums(layout)
        if not text(checksum_codec(name))
    ]


def coded_facts(layout: DeviceLayout) -> Iterator[tuple[Fact, str, str]]:
    """The facts that have codecs, with the keys and the names of these."""
    yield from ((fact, "codec", value.codec) for fact, value in _coded_values(layout))
    yield from ((part.part, "checksum", name) for part, name in _coded_checksums(layout))


def _refusal(fact: Fact, key: str, text: str) -> Refusal:
    return Refusal(fact, Diagnostic("output_has_codec", text, fact.place[key], help=LEAVE_OUT))


def _coded_values(layout: DeviceLayout) -> Iterator[tuple[Fact, Value]]:
    """The registers and fields whose values have a codec."""
    bodies = (body for message in layout.messages.values() for body in message.bodies)
    fields = (field for record in (*layout.records.values(), *bodies) for field in record.fields)
    facts = (
        *((register.register, register.register.value) for register in layout.registers),
        *((field.field, field.value) for field in fields),
    )
    for fact, value in facts:
        if value is not None and value.codec:
            yield fact, value


def _coded_checksums(layout: DeviceLayout) -> Iterator[tuple[PartLayout, str]]:
    for link in layout.links.values():
        for part in (*link.request.checksums, *link.response.checksums):
            if name := checksum_named(part.algorithm).codec:
                yield part, name
