"""Links and their frames as data of the explainer."""

from __future__ import annotations

from fieldspec.codec.layout.exception_mark import ExceptionMark
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.repeated_parts import repeated_parts
from fieldspec.language.model.escape import Escape
from fieldspec.language.model.link import ExceptionResponse
from fieldspec.language.model.preamble import Preamble
from fieldspec.targets.explainer.literals import Code, Data
from fieldspec.targets.explainer.values import fact_data, intervals, stated, value_data
from fieldspec.targets.explainer.wire import checksum_function, escape_object

DIRECTIONS = ("request", "response")


def link_data(link: LinkLayout) -> dict[str, Data]:
    """A link with the frames of both directions, and the names of the messages that each of these carries."""
    own = link.link
    addresses, exception, serial = own.unit_addresses, own.exception_response, own.serial
    return {
        **fact_data(own),
        **stated(
            {
                "title": own.title,
                "transmission": own.transmission,
                "messageName": own.message_name,
                "addresses": stated({"ranges": intervals(addresses.ranges), "broadcast": addresses.broadcast})
                if addresses is not None
                else None,
                "exception": _exception(exception, link.mark) if exception is not None else None,
                "serial": stated(
                    {
                        "baud": list(serial.baud),
                        "default": serial.default_baud,
                        "dataBits": list(serial.data_bits),
                        "parity": list(serial.parity),
                        "stopBits": list(serial.stop_bits),
                    }
                )
                if serial is not None
                else None,
            }
        ),
        "delimiters": {direction: [mark.hex() for mark in own.marks(direction)] for direction in DIRECTIONS},
        **stated({"preamble": _preamble(own.preamble)}),
        "subcodes": {direction: _subcodes(link, direction) for direction in DIRECTIONS},
        "codes": {direction: _code_texts(link, direction) for direction in DIRECTIONS},
        **stated({"openings": own.openings}),
        **stated({"ambiguous": list(link.ambiguous_codes("response")), "barred": link.barred_messages}),
        "directionNames": {"request": own.request_name, "response": own.response_name},
        "carried": {direction: list(link.carried(direction)) for direction in DIRECTIONS},
        "repeated": [[part.name, repetition.name] for part, repetition in repeated_parts(link)],
        "request": _frame(link.request),
        "response": _frame(link.response),
    }


def _exception(exception: ExceptionResponse, mark: ExceptionMark | None) -> Data:
    """The mark of exception responses and their record, as data of the explainer.

    The mark is a flag, a code, a part that is not normal, or bytes at a place in the data.
    """
    return {
        "record": exception.record,
        "flag": exception.flag,
        **stated({"code": exception.code, "part": exception.part, "normal": intervals(exception.normal)}),
        **({"mark": {"offset": mark.offset, "bytes": list(mark.pattern)}} if mark is not None else {}),
    }


def _preamble(preamble: Preamble | None) -> Data:
    """The byte before frames, how often it is sent, and how often receivers take it."""
    if preamble is None:
        return None
    return {"byte": preamble.byte, "least": preamble.least, "most": preamble.most, "sent": preamble.sent}


def _subcodes(link: LinkLayout, direction: str) -> list[Data]:
    """The subcodes of messages that share a code: the place in their data, and the messages by the numbers there."""
    return [
        {
            "code": code,
            "offset": shared.offset,
            "size": shared.size,
            "order": shared.order,
            "messages": [[number, message.name] for number, message in shared.messages.items()],
        }
        for code, shared in link.subcodes(direction).items()
    ]


def _code_texts(link: LinkLayout, direction: str) -> dict[str, Data]:
    """The expected code of each message; empty if frames carry none."""
    if link.frame(direction).role("code") is None:
        return {}
    return {name: link.code_text(message, direction) for name, message in link.carried(direction).items()}


def _frame(frame: FrameLayout) -> dict[str, Data]:
    return {
        "headerSize": frame.header_size,
        "trailerSize": frame.trailer_size,
        "header": [_part(part) for part in frame.header],
        "trailer": [_part(part) for part in frame.trailer],
        "checksums": [part.name for part in frame.checksums],
        **stated({"escape": _escape(frame.escape)}),
        "escapeStart": frame.escape_start,
        "escapeStop": frame.escape_stop or 0,
    }


def _part(part: PartLayout) -> dict[str, Data]:
    return {
        **fact_data(part.part),
        "role": part.role,
        "offset": part.offset,
        "size": part.size,
        **({"numberSize": part.number_size} if part.number_size != part.size else {}),
        **({"shift": part.shift, "width": part.width} if part.width else {}),
        **stated(
            {
                "order": part.order,
                "value": value_data(part.value, part.order) if part.value is not None else None,
                "algorithm": Code(checksum_function(part.algorithm, part.order)) if part.algorithm else None,
                "digits": part.digits,
                "start": part.start,
                "stop": part.stop,
                "unitSize": part.unit_size,
                "base": part.base,
                "constant": part.constant,
                "reserved": part.reserved,
                "escaped": part.escaped,
                "beforeEscape": part.before_escape,
                "sameAs": part.part.same_as,
            }
        ),
    }


def _escape(escape: Escape | None) -> Data:
    if escape is None:
        return None
    fields = {"fields": escape.fields, "remote": escape.remote} if escape.method == "can" else {}
    growth = {"replace": 1, "cobs": 254, "insert": len(escape.pattern)}.get(escape.method, 0)
    return stated({"method": escape.method, "bytes": Code(escape_object(escape)), "growth": growth, **fields})
