"""The number of bits that a request writes, compared with the bytes into which they are packed."""

from __future__ import annotations

from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.c.expressions import Expression, Group, Operation, PointerMember, add, different
from fieldspec.targets.c.fields import count_member
from fieldspec.targets.c.literals import unsigned
from fieldspec.targets.c.naming import Naming, member
from fieldspec.targets.c.statements import Body
from fieldspec.targets.c.values import refuse


def check_bit_count(naming: Naming, record: RecordLayout, struct: Expression) -> Body:
    """Refuses a number of bits that takes another number of bytes than there are.

    `if (in->count / 8u + (in->count % 8u + 7u) / 8u != in->bits_count) { return ERR_WRONG_MEASURE; }`
    """
    body: Body = ()
    for field in record.fields:
        packed = record.named(field.bits_of) if field.bits_of else None
        if packed is not None:
            number = PointerMember(struct, member(field.name))
            rest = Group(add(Operation("%", (number, unsigned(8))), unsigned(7)))
            size = add(Operation("/", (number, unsigned(8))), Operation("/", (rest, unsigned(8))))
            actual_size = PointerMember(struct, count_member(record, packed))
            body = (*body, *refuse(naming, different(size, actual_size), "err_wrong_measure"))
    return body
