"""Whether an optional field is sent, and how many elements a list has, as bits of another field say."""

from __future__ import annotations

from fieldspec.codec.layout.presence import PresenceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.targets.c.declarations import BLANK, Declaration, Function, comment
from fieldspec.targets.c.expressions import (
    IN,
    INPUT_BYTES,
    OUT,
    SIZE_TYPE,
    Conditional,
    Expression,
    Group,
    Operation,
    PointerMember,
    any_of,
    different,
    equal,
)
from fieldspec.targets.c.fields import count_member, decoded_selector, encoded_selector, measured_size
from fieldspec.targets.c.literals import ZERO, unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.statements import Body, Return, Variable
from fieldspec.targets.c.values import refuse


def _decider(record: RecordLayout, presence: PresenceLayout) -> FieldLayout:
    """The field that says whether another one is sent, or how many elements it has."""
    decider = record.named(presence.by)
    assert decider is not None
    return decider


def bits_of(presence: PresenceLayout, number: Expression) -> Expression:
    """`((load_u8(in + 0) & 240u) >> 4u)`: the number in the bits that count a list."""
    bits = Group(Operation("&", (number, unsigned(presence.mask))))
    return Group(Operation(">>", (bits, unsigned(presence.shift)))) if presence.shift else bits


def is_present(presence: PresenceLayout, number: Expression) -> Expression:
    """`(load_u8(in + 0) & 8u) == 8u`: whether a number says that a field is sent."""
    bits = Group(Operation("&", (number, unsigned(presence.mask))))
    return any_of([equal(bits, unsigned(own)) for own in presence.numbers])


def present_sizes(naming: Naming, record: RecordLayout) -> list[Declaration]:
    """`size_t beat_energy_decided_size(const uint8_t *in)`, for each optional field of a record."""
    functions: list[Declaration] = []
    for field in record.fields:
        presence = field.presence
        if presence is None or not field.field.is_optional:
            continue
        number = decoded_selector(naming, _decider(record, presence))
        size = Conditional(is_present(presence, number), unsigned(field.size), ZERO)
        text = f"The bytes of {field.name}: none unless {presence.by} says that it is sent."
        name = naming.function("record", record.name, f"{field.name}_decided_size")
        function = Function(SIZE_TYPE, name, (Variable(INPUT_BYTES, "in"),), (Return(size),))
        functions += [BLANK, comment(text), function]
    return functions


def check_presences(naming: Naming, record: RecordLayout, struct: Expression) -> Body:
    """Refuses fields whose number of elements is not as bits of another field say.

    `if (((in->flags & 8u) == 8u) != (in->energy_count != 0u)) { return ERR_WRONG_MEASURE; }`
    `if ((in->control & 15u) != in->options_count) { return ERR_WRONG_MEASURE; }`
    """
    body: Body = ()
    for field in record.fields:
        presence, room = field.presence, record.room_of(field)
        if presence is None or (struct == OUT and room is not None and room.count):
            continue
        decider = _decider(record, presence)
        number = encoded_selector(decider) if struct == IN else decoded_selector(naming, decider)
        has_elements = different(PointerMember(struct, count_member(record, field)), ZERO)
        wrong = different(Group(is_present(presence, number)), Group(has_elements))
        if field.has_count_in_bits:
            wrong = different(bits_of(presence, number), measured_size(record, decider, struct))
        body = (*body, *refuse(naming, wrong, "err_wrong_measure"))
    return body
