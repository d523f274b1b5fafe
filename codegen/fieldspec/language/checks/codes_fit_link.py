"""The code of every message fits the part that carries it, and does not contain the bit that marks an
exception response.

Why: a code that does not fit cannot be sent. A code that contains this bit would be decoded as an exception
response.

Example: function code 0x86 on a link whose exception responses have the bit 0x80.

Fix: Correct the code, the type of the part or the bit, and write an erratum if the manual prints it that
way.
"""

from __future__ import annotations

from fieldspec.language.checks.finding import Findings, finding, label, type_text
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.link import ExceptionResponse, Link
from fieldspec.language.model.record import Message
from fieldspec.language.model.sizes import messages_on


def codes_fit_link(device: Device) -> Findings:
    for link in device.links.values():
        codes = [part for part in (*link.request, *link.response) if part.role == "code" and part.value is not None]
        numbers = [part for part in codes if part.value is not None and is_count(part.value.encoding)]
        # Both directions mostly have the same one; of two, the narrower one decides.
        part = min(numbers, key=lambda part: part.value.high if part.value else 0, default=None)
        if part is None or part.value is None:
            continue
        high = part.value.high
        if link.exception_response is not None and not 0 < _mark(link.exception_response) <= high:
            error = link.exception_response
            mark = f"the code {error.code:#x}" if error.code is not None else f"the bit {error.flag:#x}"
            text = f"{part.name} is {type_text(part.value)} and cannot hold {mark}"
            help = "correct the bit or the part's type"
            yield finding(link.place, "exception_response", text, help, label(part.place, "type", part.value.type.name))
        if link.exception_response is not None and link.exception_response.flag and part.value.digits == "decimal":
            text = f"{part.name} is sent as decimal digits, in which no bit marks an exception response"
            help = "state the mark as `code`, `part` or `field`"
            related_label = label(part.place, "digits", part.name)
            yield finding(link.place, "exception_response", text, help, related_label)
        for message in messages_on(device, link):
            wide = list(_wide(link, message))
            yield from wide
            if not wide:
                yield from _check_flag(link, message)


def _wide(link: Link, message: Message) -> Findings:
    """The codes of a message that do not fit the parts in which they are sent."""
    for key, code in message.codes:
        only_asks = key == "code" and message.response_code is not None
        in_request = link.request if key == "code" else ()
        for part in (*in_request, *(() if only_asks else link.response)):
            value = part.value
            if part.role != "code" or value is None or not is_count(value.encoding) or code <= value.high:
                continue
            printed = str(code) if value.digits == "decimal" else f"{code:#x}"
            text = f"the code {printed} does not fit {part.name}, which is {type_text(value)}"
            help = "correct the code or the part's type"
            yield finding(message.place, key, text, help, label(part.place, "type", part.name))
            break


def _mark(error: ExceptionResponse) -> int:
    """The number that the code must be able to hold; 1 where the mark is not in the code."""
    return max(error.code, 1) if error.code is not None else error.flag or 1


def _check_flag(link: Link, message: Message) -> Findings:
    error = link.exception_response
    if error is None or not message.codes:
        return
    # Responses are marked by their own codes.
    key, code = message.codes[-1]
    related_label = label(link.place, "exception_response", f"exception responses on {link.name}")
    if code == error.code:
        text = f"{message.name} has the code {code:#x} of exception responses"
        yield finding(message.place, key, text, "correct one of the codes", related_label)
    if code & error.flag:
        text = f"the code {code:#x} has the bit {error.flag:#x}, which marks an exception response"
        help = "correct the code or the bit"
        if key == "response_code":
            help += ", which exception responses have besides the code of the response"
        yield finding(message.place, key, text, help, related_label)
