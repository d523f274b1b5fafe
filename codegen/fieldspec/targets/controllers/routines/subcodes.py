"""Responses of messages that share a code: a field in their data identifies the message."""

from __future__ import annotations

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.targets.controllers.routines.holders import Holder
from fieldspec.targets.controllers.routines.values import Wire
from fieldspec.targets.controllers.statements.expressions import Expression, compared, either, every, number
from fieldspec.targets.controllers.statements.routine import Draft


def refuse_other_subcode(
    draft: Draft, link: LinkLayout, message: MessageLayout, holder: Holder, size: Expression
) -> None:
    """Refuses the response to another message with the same code.

    Data that are too short for the field count as data of the first message, as in the other codecs.
    """
    shared = link.subcodes("response").get(message.message.code_of("response") or 0)
    if shared is None or all(other is not message for other in shared.messages.values()):
        return
    field = next(field for field in message.response.fields if field.offset == shared.offset)
    wire = Wire.of_field(field)
    bits = holder.number(field.offset, field.size, shared.order, False)
    numbers = [key for key, other in shared.messages.items() if other is message]
    differs = every([compared(bits, "<>", wire.literal(own)) for own in numbers])
    if next(iter(shared.messages.values())) is message:
        test = every([compared(size, ">=", number(shared.end)), differs])
    else:
        test = either([compared(size, "<", number(shared.end)), differs])
    draft.refuse(test, "unknown_code")
