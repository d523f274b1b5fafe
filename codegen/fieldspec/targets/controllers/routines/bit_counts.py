"""The number of bits that a request writes, compared with the bytes into which they are packed."""

from __future__ import annotations

from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.controllers.routines.holders import Bytes
from fieldspec.targets.controllers.routines.values import Wire
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    DINT,
    INT,
    Expression,
    Operation,
    compared,
    converted,
    either,
    number,
    plus,
)
from fieldspec.targets.controllers.statements.routine import Draft


def refuse_other_bit_counts(
    draft: Draft, world: World, record: RecordLayout, size: Expression | None, holder: Bytes
) -> None:
    """Refuses a number of bits, which has been written, that takes other than `size` bytes."""
    for field in record.fields:
        if not field.bits_of or size is None:
            continue
        wire = Wire.of_field(field)
        count = converted(wire.number(world, holder.number(field.offset, field.size, wire.order, wire.swapped)), DINT)
        room = Operation("*", (size, number(8)), INT)
        wrong = (compared(count, ">", converted(room, DINT)), compared(count, "<", converted(plus(room, -7), DINT)))
        draft.refuse(either(wrong), "wrong_measure")
