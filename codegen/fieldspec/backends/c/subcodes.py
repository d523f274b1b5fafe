"""Messages that share a code: what tells them apart in an opened frame."""

from __future__ import annotations

from fieldspec.backends.c.expressions import (
    IN,
    LENGTH,
    OUT,
    Call,
    Expression,
    PointerMember,
    add,
    all_of,
    decimal,
    different,
    equal,
    less,
    unsigned,
)
from fieldspec.backends.c.naming import Naming
from fieldspec.backends.c.statements import If, Statement, assign
from fieldspec.backends.c.values import access_name, refuse
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.frame import FrameLayout, LinkLayout, MessageLayout
from fieldspec.layout.subcodes import Subcode


def shared_codes(link: LinkLayout, direction: str) -> dict[int, Subcode]:
    """What tells the messages apart that share a code, by this code."""
    return link.subcodes(direction) if link.frame(direction).role("code") is not None else {}


def read_subcode(
    naming: Naming, frame: FrameLayout, code: int, subcode: Subcode, guard: list[Expression]
) -> Statement:
    """Reads what tells the messages with a code apart, and refuses what none of them has.

    `if (out->code == 8u) { if (length < 6u) { return ERR_INCOMPLETE; } out->subcode = load_u16(in + 2); ... }`
    """
    member = PointerMember(OUT, "subcode")
    around = frame.header_size + frame.trailer_size
    place = add(IN, decimal(frame.header_size + subcode.offset))
    return If(
        all_of([*guard, equal(PointerMember(OUT, "code"), unsigned(code))]),
        (
            *refuse(naming, less(LENGTH, unsigned(around + subcode.end)), "err_incomplete"),
            assign(member, Call(naming.own(f"load_{access_name(subcode.size, subcode.order, False)}"), (place,))),
            *refuse(
                naming, all_of([different(member, unsigned(number)) for number in subcode.messages]), "err_unknown_code"
            ),
        ),
    )


def subcode_of(layout: DeviceLayout, message: MessageLayout) -> int | None:
    """What tells a message from others with its code, None where nothing has to or where it depends on the link."""
    numbers = {
        subcode.number_of(message)
        for link in layout.links.values()
        for direction in ("request", "response")
        for code, subcode in shared_codes(link, direction).items()
        if code == message.message.code and message in subcode.messages.values()
    }
    return numbers.pop() if len(numbers) == 1 else None
