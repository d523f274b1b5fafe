"""Whether an optional field is sent, how many elements a list has, and which is the last, as bits say."""

from __future__ import annotations

from fieldspec.codec.layout.inner_lists import InnerList
from fieldspec.codec.layout.presence import PresenceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.targets.c.declarations import BLANK, Declaration, Function, comment
from fieldspec.targets.c.expressions import (
    IN,
    INDEX,
    INPUT_BYTES,
    OUT,
    SIZE_TYPE,
    Call,
    Conditional,
    Expression,
    Group,
    Identifier,
    any_of,
)
from fieldspec.targets.c.fields import count_member, decoded_selector, encoded_selector, measured_size, walk_elements
from fieldspec.targets.c.literals import ZERO, unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.statements import Assignment, Body, Return, Variable
from fieldspec.targets.c.values import field_value, load, refuse


def _decider(record: RecordLayout, presence: PresenceLayout) -> FieldLayout:
    """The field that says whether another one is sent, or how many elements it has."""
    decider = record.named(presence.by)
    assert decider is not None
    return decider


def bits_of(presence: PresenceLayout, number: Expression) -> Expression:
    """`((load_u8(in + 0) & 240u) >> 4u)`: the number in the bits that count a list."""
    bits = Group(number & unsigned(presence.mask))
    return Group(bits >> unsigned(presence.shift)) if presence.shift else bits


def is_present(presence: PresenceLayout, number: Expression) -> Expression:
    """`(load_u8(in + 0) & 8u) == 8u`: whether a number says that a field is sent."""
    bits = Group(number & unsigned(presence.mask))
    if presence.is_any:
        return bits.differs(ZERO)
    return any_of([bits.equals(unsigned(own)) for own in presence.numbers])


def present_sizes(naming: Naming, record: RecordLayout) -> list[Declaration]:
    """`size_t beat_energy_decided_size(const uint8_t *in)`, for each optional field of a record."""
    functions: list[Declaration] = []
    for field in record.fields:
        presence = field.presence
        if presence is None or not field.field.tells_end:
            continue
        number = decoded_selector(naming, _decider(record, presence))
        size = Conditional(is_present(presence, number), unsigned(field.size), ZERO)
        text = f"The bytes of {field.name}: none unless {presence.by} says that it is sent."
        name = naming.function("record", record.name, f"{field.name}_decided_size")
        function = Function(SIZE_TYPE, name, (Variable(INPUT_BYTES, "in"),), (Return(size),))
        functions += [BLANK, comment(text), function]
    return functions


def follows(naming: Naming, record: RecordLayout, field: FieldLayout) -> str:
    """`frame_dife_follows`: the function that tells by an element of a list whether another one follows."""
    return naming.function("record", record.name, f"{field.name}_follows")


def following(naming: Naming, record: RecordLayout) -> list[Declaration]:
    """`size_t frame_dife_follows(const uint8_t *in)`, for each list whose elements say which of them is the last."""
    functions: list[Declaration] = []
    for field in record.fields:
        if field.continuation is None:
            continue
        presence = field.continuation.presence
        decider = field if field.record is None else field.record.named(presence.by)
        assert decider is not None
        number = load(naming, field_value(decider), IN + unsigned(field.continuation.offset))
        result = Conditional(is_present(presence, number), unsigned(1), ZERO)
        text = f"How many elements of {field.name} follow one at least: 1 or none."
        name = follows(naming, record, field)
        function = Function(SIZE_TYPE, name, (Variable(INPUT_BYTES, "in"),), (Return(result),))
        functions += [BLANK, comment(text), function]
    return functions


def counts_in_image(naming: Naming, record: RecordLayout) -> Body:
    """`out->points_count = load_u8(in + 1) / 4u;` for each list of an image that another list follows."""
    body: Body = ()
    for room in record.rooms:
        field, count = record.named(room.name), record.named(room.count)
        assert field is not None
        if field.count is not None:
            continue
        items = unsigned(1) if room.continuation is None else _elements_in_image(naming, record, field, room)
        if field.count is not None or (count is None and room.continuation is None):
            continue
        if count is not None:
            items = _items_of_count(room, decoded_selector(naming, count), items)
        body = (*body, Assignment(OUT.arrow(count_member(record, field)), items))
    return body


def _items_of_count(room: InnerList, number: Expression, items: Expression) -> Expression:
    """How many elements a number says that there are; `items` if it says that there are some."""
    if room.presence is not None and room.presence.numbers:
        return Conditional(is_present(room.presence, number), items, ZERO)
    number = number if room.presence is None else bits_of(room.presence, number).cast("size_t")
    if room.plus:
        number = Group(number.plus(-room.plus))
    return number if room.unit == room.element else number / unsigned(room.element)


def _elements_in_image(naming: Naming, record: RecordLayout, field: FieldLayout, room: InnerList) -> Expression:
    """`count_elements(frame_dife_follows, in + 3u, 1u, 10u)`: the elements of a list that says which is the last."""
    place = IN + unsigned(room.room)
    function = Identifier(follows(naming, record, field))
    arguments = function, place, unsigned(room.element), unsigned(room.most // room.element)
    return Call(naming.own("count_elements"), arguments)


def _check_end(naming: Naming, record: RecordLayout, field: FieldLayout) -> Body:
    """Refuses elements that have been written and are wrong about whether another one follows.

    `for (...) { if (frame_dife_follows(out + 3u + at) != (at + 1u < in->dife_count ? 1u : 0u)) { return ...; } }`
    """
    count = IN.arrow(count_member(record, field))
    is_followed = Conditional((INDEX + unsigned(1)).less(count), unsigned(1), ZERO)

    def check(target: Expression, value: Expression) -> Body:
        wrong = Call(follows(naming, record, field), (target,)).differs(Group(is_followed))
        return refuse(naming, wrong, "err_wrong_measure")

    return walk_elements(record, field, check, IN, OUT)


def check_presences(naming: Naming, record: RecordLayout, struct: Expression) -> Body:
    """Refuses fields whose number of elements is not as bits of another field say.

    `if (((in->flags & 8u) == 8u) != (in->energy_count != 0u)) { return ERR_WRONG_MEASURE; }`
    `if ((in->control & 15u) != in->options_count) { return ERR_WRONG_MEASURE; }`
    """
    body: Body = ()
    for field in record.fields:
        presence, room = field.presence, record.room_of(field)
        if presence is not None and (struct == IN or room is None or not room.count):
            body = (*body, *_check_presence(naming, record, field, presence, struct))
        if field.continuation is not None and struct == IN:
            body = (*body, *_check_end(naming, record, field))
    return body


def _check_presence(
    naming: Naming, record: RecordLayout, field: FieldLayout, presence: PresenceLayout, struct: Expression
) -> Body:
    """Refuses a field whose number of elements is not as bits of another one say."""
    decider = _decider(record, presence)
    number = encoded_selector(decider) if struct == IN else decoded_selector(naming, decider)
    has_elements = struct.arrow(count_member(record, field)).differs(ZERO)
    wrong = Group(is_present(presence, number)).differs(Group(has_elements))
    if field.has_count_in_bits:
        wrong = bits_of(presence, number).differs(measured_size(record, decider, struct))
    return refuse(naming, wrong, "err_wrong_measure")
