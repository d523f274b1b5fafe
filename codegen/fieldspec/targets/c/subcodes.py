"""Messages that share a code: what tells them apart in an opened frame."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.subcodes import Subcode
from fieldspec.targets.c.declarations import Function
from fieldspec.targets.c.expressions import IN, LENGTH, OUT, Call, Expression, Group, Identifier, Type, all_of, any_of
from fieldspec.targets.c.literals import decimal, unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.number_access import access_name
from fieldspec.targets.c.parts import number_type
from fieldspec.targets.c.statements import If, Return, Statement, Variable, assign
from fieldspec.targets.c.values import refuse


def shared_codes(link: LinkLayout, direction: str) -> dict[int, Subcode]:
    """The subcodes of messages that share a code, by this code."""
    return link.subcodes(direction) if link.frame(direction).role("code") is not None else {}


def all_subcodes(layout: DeviceLayout) -> list[Subcode]:
    """The subcodes of all frames."""
    links = layout.links.values()
    by_code = [shared_codes(link, direction) for link in links for direction in ("request", "response")]
    return [subcode for subcodes in by_code for subcode in subcodes.values()]


def subcode_type(subcodes: Iterable[Subcode]) -> Type:
    """The type of the member that has the subcodes of a frame."""
    return number_type(max((subcode.size for subcode in subcodes), default=0))


def read_subcode(naming: Naming, frame: FrameLayout, code: int, subcode: Subcode, guard: list[Expression]) -> Statement:
    """Reads the subcode of messages that share a code, and refuses a number that none of them has.

    `if (out->code == 8u) { if (length < 6u) { return ERR_INCOMPLETE; } out->subcode = load_u16(in + 2); ... }`
    """
    member = OUT.arrow("subcode")
    parts_size = frame.header_size + frame.trailer_size
    place = IN + decimal(frame.header_size + subcode.offset)
    return If(
        all_of([*guard, OUT.arrow("code").equals(unsigned(code))]),
        (
            *refuse(naming, LENGTH.less(unsigned(parts_size + subcode.end)), "err_incomplete"),
            assign(member, Call(naming.own(f"load_{access_name(subcode.size, subcode.order, False)}"), (place,))),
            *refuse(naming, all_of(list(_differences(member, subcode))), "err_unknown_code"),
        ),
    )


def _differences(member: Expression, subcode: Subcode) -> Iterator[Expression]:
    """The tests that a number is not in a subcode: one for each number, or for each run of numbers."""
    for message in dict.fromkeys(message.name for message in subcode.messages.values()):
        own = next(other for other in subcode.messages.values() if other.name == message)
        for low, high in subcode.intervals_of(own):
            if low == high:
                yield member.differs(unsigned(low))
            elif low == 0:
                yield member.greater(unsigned(high))
            else:
                yield any_of([member.less(unsigned(low)), member.greater(unsigned(high))])


def subcodes_of(layout: DeviceLayout, message: MessageLayout) -> tuple[tuple[int, int], ...]:
    """The subcodes of a message as intervals with both ends.

    There are none where nothing has to, and where it depends on the link.
    """
    numbers = {
        tuple(subcode.intervals_of(message))
        for link in layout.links.values()
        for direction in ("request", "response")
        for code, subcode in shared_codes(link, direction).items()
        if code == message.message.code_of(direction) and message in subcode.messages.values()
    }
    return numbers.pop() if len(numbers) == 1 else ()


def has_subcode(naming: Naming, layout: DeviceLayout, message: str, intervals: Sequence[tuple[int, int]]) -> Function:
    """Whether an opened frame with the code of several messages is one of this message.

    `bool message_next_has_subcode(uint32_t subcode) { return subcode == 0x60u || subcode == 0x70u; }`
    """
    number = Identifier("subcode")
    tests: list[Expression] = []
    for low, high in intervals:
        upper_test = number.at_most(unsigned(high))
        interval_test = upper_test if low == 0 else all_of([number.at_least(unsigned(low)), upper_test])
        interval_test = Group(interval_test) if len(intervals) > 1 and low else interval_test
        tests.append(number.equals(unsigned(low)) if low == high else interval_test)
    name = naming.function("message", message, "has_subcode")
    kind = subcode_type(all_subcodes(layout))
    return Function(Type("bool"), name, (Variable(kind, "subcode"),), (Return(any_of(tests)),))
