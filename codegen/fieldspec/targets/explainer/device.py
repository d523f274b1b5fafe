"""Everything that the explainer in JavaScript knows of a device at one version."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.codec.explain.errata import citations
from fieldspec.codec.explain.examples import printed
from fieldspec.codec.explain.percentages import references_text
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.texts import Erratum, Example
from fieldspec.targets.explainer.codecs import codec_constants
from fieldspec.targets.explainer.links import link_data
from fieldspec.targets.explainer.literals import Data, lines
from fieldspec.targets.explainer.records import message_data, record_data
from fieldspec.targets.explainer.registers import gaps_data, register_data, set_data, table_data
from fieldspec.targets.explainer.values import enum_data, stated, word_data
from fieldspec.targets.explainer.wire import used_functions
from fieldspec.targets.pieces import version_piece

_LINES = 2
"""The depth down to which each entry has a line of its own."""


def explainer_data(layout: DeviceLayout) -> str:
    """The data of the explainer, as a function of JavaScript. Its argument has what checksums and escapes call."""
    return version_piece("explainer", layout, (), _explainer_data)


def _explainer_data(layout: DeviceLayout) -> str:
    data, codecs = lines(device_data(layout), _LINES), codec_constants(layout)
    body = "\n".join(["{", *codecs, f"return {data};", "}"]) if codecs else f"({data})"
    functions = ", ".join(used_functions(layout))
    return f"({{ {functions} }}) => {body}" if functions else f"() => {body}"


def device_data(layout: DeviceLayout) -> dict[str, Data]:
    """The data from which the explainer in browsers explains frames of a device."""
    device = layout.device
    return {
        "device": device.id,
        "version": device.version,
        "name": device.name,
        "language": device.manual.language,
        "identity": layout.identity,
        "wordOrder": device.byte_order,
        "enums": {name: enum_data(enum) for name, enum in device.enums.items()},
        "flags": {name: word_data(word, device.enums) for name, word in device.flags.items()},
        "records": {name: record_data(device, record) for name, record in layout.records.items()},
        "messages": {name: message_data(device, message) for name, message in layout.messages.items()},
        "links": {name: link_data(link) for name, link in layout.links.items()},
        "registers": [register_data(device, register) for register in layout.registers],
        "tables": [table_data(device, table) for table in layout.tables.values()],
        "gaps": gaps_data(layout),
        "sets": {name: set_data(words) for name, words in device.parameters.items()},
        "conversions": _conversions(device),
        "examples": [_example(device, example) for example in device.examples.values()],
        "errata": [_erratum(erratum) for erratum in device.errata],
    }


def _conversions(device: Device) -> list[Data]:
    return [
        {
            **stated({"name": conversion.name, "label": conversion.label, "complement": conversion.complement}),
            "signals": list(conversion.signals),
            "full": conversion.full_scale,
            "references": references_text(device, conversion),
        }
        for conversion in device.conversions.values()
    ]


def _example(device: Device, example: Example) -> Data:
    print_ = printed(device, example)
    frame = example.frame.hex().upper()
    return {
        "id": example.id,
        "link": example.link,
        "direction": example.direction,
        "frame": frame,
        **stated(
            {
                "message": example.message,
                "error": example.exception_response,
                "replyTo": example.reply_to,
                "refused": example.refused,
                "title": example.title,
                "source": citations(example.sources),
                "printed": print_.frame if print_.frame != frame else "",
                "errata": [erratum.id for erratum in print_.errata],
            }
        ),
    }


def _erratum(erratum: Erratum) -> Data:
    print_ = {key: str(value) if isinstance(value, Decimal) else value for key, value in erratum.printed.items()}
    return {"id": erratum.id, "fact": erratum.fact, "printed": print_, "reason": erratum.reason}  # type: ignore[dict-item]
