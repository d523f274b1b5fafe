"""The number of bits that a request writes, compared with the bytes into which they are packed."""

from __future__ import annotations

from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.c.expressions import Expression, Group
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
            number = struct.arrow(member(field.name))
            rest = Group((number % unsigned(8)) + unsigned(7))
            size = (number / unsigned(8)) + (rest / unsigned(8))
            actual_size = struct.arrow(count_member(record, packed))
            body = (*body, *refuse(naming, size.differs(actual_size), "err_wrong_measure"))
    return body
