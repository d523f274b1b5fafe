"""Links as data of the dissector: the parts of their frames, their messages, and the checksums."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.repeated_parts import repeated_parts
from fieldspec.codec.layout.subcodes import Subcode
from fieldspec.foundation.names import Name
from fieldspec.foundation.runtime._checksums import reflected
from fieldspec.language.model.checksums import checksum_named
from fieldspec.language.model.link import ExceptionResponse
from fieldspec.language.model.preamble import Preamble
from fieldspec.targets.wireshark.filters import Filters, description, title_of
from fieldspec.targets.wireshark.text import Data, line_text
from fieldspec.targets.wireshark.values import bound, code_data, errata_data, intervals, is_wide, value_data

LONGEST = 0xFFFF
"""The bytes of a body that nothing bounds."""

_HALF = 0xFFFFFFFF


def link_data(filters: Filters, layout: DeviceLayout, link: LinkLayout) -> dict[str, Data]:
    """A link with its frames in both directions."""
    own = link.link
    addresses, exception = own.unit_addresses, own.exception_response
    heads = [part for shape in (link.request, link.response) for part in shape.header]
    wide = any(is_wide(part.value) for part in heads if part.role == "unit_address")
    is_coded = link.request.role("code") is not None
    messages = [name for name, message in link.messages.items() if not is_coded or message.message.code is not None]
    shapes = {direction: _shape(filters, layout, link, direction) for direction in ("request", "response")}
    return {
        "name": link.name,
        "title": line_text(own.title) or Name.of(link.name).title(),
        "hex": own.transmission == "hex_ascii",
        "is_coded": is_coded,
        "is_framed": any(shape["is_framed"] for shape in shapes.values()),
        "repeated": [
            {"asked": request_part.name, "answered": response_part.name}
            for request_part, response_part in repeated_parts(link)
        ],
        "messages": messages,
        "exception": None if exception is None else _exception(link, exception),
        "units": None
        if addresses is None
        else {
            "ranges": intervals(addresses.ranges, wide),
            "broadcast": bound(addresses.broadcast, wide) if addresses.broadcast is not None else None,
        },
        **({"ports": {protocol: str(port) for protocol, port in own.ports}} if own.ports else {}),
        **shapes,
    }


def _exception(link: LinkLayout, exception: ExceptionResponse) -> dict[str, Data]:
    mark = link.mark
    marks = next((part for part in link.response.header if part.name == exception.part), None)
    return {
        **({"mark": {"offset": mark.offset, "bytes": mark.pattern}} if mark is not None else {}),
        "flag": code_data(exception.flag),
        "code": code_data(exception.code),
        "part": exception.part or None,
        "normal": intervals(exception.normal, is_wide(marks.value if marks is not None else None)),
        "record": exception.record,
    }


def _shape(filters: Filters, layout: DeviceLayout, link: LinkLayout, direction: str) -> dict[str, Data]:
    frame, own = link.frame(direction), link.link
    bodies = [message.data(direction) for message in link.messages.values()]
    if own.exception_response is not None:
        bodies.append(layout.records[own.exception_response.record])
    parts_size, width = frame.header_size + frame.trailer_size, 2 if own.transmission == "hex_ascii" else 1
    marks = len(frame.start) + len(frame.end)
    largest = max((record.most if record.most is not None else LONGEST for record in bodies), default=0)
    return {
        "start": frame.start,
        "preamble": _preamble(frame.preamble),
        "stop": frame.end,
        "messages": [name for name, message in link.carried(direction).items() if message.message.code is not None],
        "subcodes": [_subcode(code, subcode) for code, subcode in link.subcodes(direction).items()],
        **({"ambiguous": list(map(code_data, ambiguous))} if (ambiguous := link.ambiguous_codes(direction)) else {}),
        "parts": [_part(filters, layout, link, direction, part) for part in frame.parts],
        "header": frame.header_size,
        "trailer": frame.trailer_size,
        "shortest": marks + width * (parts_size + min((record.least for record in bodies), default=0)),
        "longest": marks + width * (parts_size + largest),
        "is_framed": bool(frame.end) or frame.role("length") is not None or frame.role("code") is not None,
    }


def _preamble(preamble: Preamble | None) -> dict[str, Data] | None:
    """The byte before frames, and how often receivers take it."""
    if preamble is None:
        return None
    return {"byte": bytes((preamble.byte,)), "least": preamble.least, "most": preamble.most}


def _subcode(code: int, subcode: Subcode) -> dict[str, Data]:
    """The subcode of messages that share a code, as data of the dissector."""
    messages: list[Data] = [
        {"number": code_data(number), "name": message.name} for number, message in subcode.messages.items()
    ]
    place: dict[str, Data] = {"offset": subcode.offset, "size": subcode.size, "order": subcode.order}
    return {"code": code_data(code), **place, "messages": messages}


def _part(
    filters: Filters, layout: DeviceLayout, link: LinkLayout, direction: str, part: PartLayout
) -> dict[str, Data]:
    own = part.part
    names = (f"{link.name}.{part.name}", f"{link.name}.{direction}.{part.name}")
    data: dict[str, Data] = {
        "name": part.name,
        "title": title_of(own),
        "role": part.role,
        "offset": part.offset,
        "size": part.size,
        "order": part.order,
        **({"shift": part.shift, "width": part.width} if part.width else {}),
        "constant": None if part.constant is None else bound(part.constant, is_wide(part.value)),
        "reserved": part.reserved,
        "same_as": own.same_as or None,
        "errata": errata_data(layout.device, own),
    }
    if part.role == "checksum":
        kind = "STRING" if part.digits else "BYTES"
        filter_name = filters.take(names, {"title": title_of(own), "text": description(own), "type": kind})
        return {
            **data,
            "filter": filter_name,
            "start": part.start,
            "stop": part.stop,
            "digits": part.digits or None,
            "algorithm": checksum_data(part.algorithm, part.order),
        }
    assert part.value is not None
    if part.role == "length":
        data |= {"unit_size": part.unit_size, "base": part.base}
    value = value_data(part.value, part.order, False)
    return {
        **data,
        "filter": filters.of_value(names, own, part.value),
        "quantity": filters.of_quantity(names, own, part.value),
        "bits": filters.of_bits((part.value.flags, *names), part.value),
        "value": value,
        "show": filters.functions.number(value, part.reserved),
    }


def checksum_data(algorithm: str, order: str) -> dict[str, Data]:
    """An algorithm with its numbers as pairs of the upper and the lower 32 bits.

    A polynomial, and the initial value of a CRC, are as the register has them: reflected, or at the highest bits of 64.
    """
    kind = checksum_named(algorithm)
    data: dict[str, Data] = {"method": kind.method, "width": kind.width}
    if kind.suffix:
        data["suffix"] = list(kind.suffix)
    if kind.avoided:
        data["replacements"] = list(zip(kind.avoided, kind.replacements, strict=True))
    if kind.method == "crc":

        def aligned(number: int) -> list[int]:
            return _pair(reflected(number, kind.width) if kind.reflect_in else number << 64 - kind.width)

        return {
            **data,
            "polynomial": aligned(kind.polynomial),
            "initial": aligned(kind.initial),
            "final": _pair(kind.final_xor),
            "reflect_in": kind.reflect_in,
            "reflect_out": kind.reflect_out,
            "unit_size": kind.unit_size if kind.unit_size > 1 else None,
        }
    order = kind.unit_order or order
    if kind.method == "fletcher":
        half = kind.width // 2
        return {
            **data,
            "initial": [kind.initial >> half, kind.initial & (1 << half) - 1],
            "modulus": kind.modulus,
            "unit_size": kind.unit_size,
            "order": order,
        }
    return {
        **data,
        "initial": _pair(kind.initial),
        "mask": _pair(kind.mask),
        "complement": kind.complement or None,
        "unit_size": kind.unit_size,
        "order": order,
    }


def _pair(number: int) -> list[int]:
    return [number >> 32 & _HALF, number & _HALF]
