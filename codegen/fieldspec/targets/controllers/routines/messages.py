"""The requests and responses of the messages of a link."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.frames import code_type, wire_of
from fieldspec.targets.controllers.routines.holders import Bytes, Holder
from fieldspec.targets.controllers.routines.named_numbers import named, size_of
from fieldspec.targets.controllers.routines.parameters import Fields, measure, request_parameters, response_parameters
from fieldspec.targets.controllers.routines.records import read_choice, read_field, selecting, write_choice, write_field
from fieldspec.targets.controllers.routines.values import Wire
from fieldspec.targets.controllers.routines.world import PREFIXES, World
from fieldspec.targets.controllers.routines.wrapping import LENGTH, framed, link_words, wrapped
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    DINT,
    INT,
    Call,
    Expression,
    Variable,
    Whole,
    either,
    every,
    number,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Routine, Statement, when


def message_routines(world: World, link: LinkLayout) -> Iterator[Routine]:
    """The functions that build the requests of a link and parse its responses."""
    if not framed(link):
        return
    for message in link.messages.values():
        if message.name in link.carried("request"):
            yield _build(world, link, message)
        if message.name in link.carried("response"):
            yield _parse(world, link, message)


def _of_message(world: World, link: LinkLayout, message: MessageLayout, deed: str) -> tuple[str, str, str]:
    title = message.message.title or message.name.replace("_", " ")
    code = message.message.code
    subject = f"{title} (code {code}) on {link.name}" if code is not None else f"{title} on {link.name}"
    source = world.comment(message.message, None)
    return (
        world.routine(deed, *link_words(world, link), message.name),
        f"messages of {link.name}",
        f"{deed.title()}s {'the request' if deed == 'build' else 'the response'}: {subject}. {source}".strip(),
    )


def _build(world: World, link: LinkLayout, message: MessageLayout) -> Routine:
    name, group, description = _of_message(world, link, message, "build")
    draft = Draft(world, name, group, description, message.message.doc)
    shape, record = link.request, message.request
    parameters = request_parameters(draft, link, message)
    head: dict[str, Expression] = {variable.name: variable for variable in parameters.head.values()}
    fields = parameters.fields
    frame = draft.declare("aFrame", world.frame, "in_out", "receives the request")
    length = draft.declare(LENGTH, INT, "output", "how many bytes of aFrame are to be sent")
    target = draft.declare("aBytes", world.frame, "local") if wrapped(link) else frame
    draft.add([Assignment(length, number(0))])
    size = _write_body(draft, record, fields, Bytes(target, number(shape.header_size)))
    barred, addressed = link.barred_address(message), shape.role("unit_address")
    if barred is not None and addressed is not None:
        wire = wire_of(addressed)
        station = parameters.head[addressed.name]
        draft.refuse(station.converted(wire.whole).compared("=", barred), "out_of_range")
    coded = code_type(shape)
    if coded is not None:
        head[f"{PREFIXES[coded.name]}Code"] = named(
            message.message.code or 0, coded, message.name, "code", hexadecimal=True
        )
    closed = Call(
        world.routine("close", *link_words(world, link), "request"),
        (*head.items(), ("iBodyLength", size), ("aFrame", target)),
        ((LENGTH, length),),
        world.status.type,
    )
    if not wrapped(link):
        return draft.finished(closed)
    status, count = draft.local("eStatus", world.status.type), draft.local("iByteCount")
    draft.add([Assignment(status, closed), draft.status.passed_on(draft.result, status), Assignment(count, length)])
    wrap = Call(
        world.routine("wrap", *link_words(world, link)),
        (("iByteCount", count), ("aBytes", target), ("aFrame", frame)),
        ((LENGTH, length),),
        world.status.type,
    )
    return draft.finished(wrap)


def _own_count(field: FieldLayout, fields: Fields) -> Expression | None:
    """The number of elements of a repeated field; None for any other, also for a list of a fixed length."""
    return fields.count if field.field.repeat is not None else None


def _write_body(draft: Draft, record: RecordLayout, fields: Fields, holder: Bytes) -> Expression:
    """Adds the statements that write the fields of a body, and gives the number of its bytes."""
    last = record.fields[-1] if record.fields else None
    repeat = last.field.repeat if last is not None else None
    if fields.count is not None and repeat is not None:
        low, high = number(repeat.low), number(repeat.high)
        wrong = fields.count.compared("<", low).combined("OR", fields.count.compared(">", high))
        draft.refuse(wrong, "wrong_length")
    size: Expression = size_of(record.name, "size", record.size or 0)
    element: Expression = number(last.size if last is not None else 0)
    for field in record.fields:
        if field.field.measures is not None:
            continue
        if field.cases:
            assert record.selector is not None
            assert fields.count is not None or field.count
            element = draft.local("iSize")
            selector = selecting(draft, record.selector, fields.place(record.selector))
            draft.add(write_choice(draft, field, selector, holder, fields.place(field), fields.count))
        else:
            draft.add(write_field(draft, field, holder, fields.place, _own_count(field, fields)))
    if fields.count is not None and last is not None:
        size = fields.count.combined("*", element).plus(last.offset)
        size = fields.count.plus(last.offset) if element == number(1) else size
    refuse_other_bit_counts(draft, record, fields.count, holder)
    for field in record.fields:
        if field.field.measures is not None:
            draft.add(_write_length(draft, record, field, fields, element, holder))
    return size


def _write_length(
    draft: Draft, record: RecordLayout, field: FieldLayout, fields: Fields, element: Expression, holder: Bytes
) -> list[Statement]:
    wire = Wire.of_field(field)
    measured = measure(record, field, fields.count, element)
    highest = wire.value.ranges.high if wire.value.ranges else wire.value.type.high
    raw = draft.local(f"{PREFIXES[wire.bits.name]}Measure", wire.bits)
    tests = [draft.refusal(measured.compared(">", highest), "out_of_range")] if highest < 1 << 15 else []
    if isinstance(measured, Whole):
        tests = []
    value = measured.converted(wire.bits)
    return [*tests, Assignment(raw, value), *holder.stored(field.offset, field.size, wire.order, wire.swapped, raw)]


def _parse(world: World, link: LinkLayout, message: MessageLayout) -> Routine:
    name, group, description = _of_message(world, link, message, "parse")
    error = link.link.exception_response
    refusal = world.layout.records[error.record] if error is not None else None
    refused_doc = "Where the device refuses, the status says so, and further outputs say why." if refusal else ""
    draft = Draft(world, name, group, description, message.message.doc, refused_doc)
    shape, record = link.response, message.response
    length = draft.declare(LENGTH, INT, "input", "how many bytes of aFrame were received")
    frame = draft.declare("aFrame", world.frame, "in_out", "is read only")
    parameters = response_parameters(draft, link, message)
    fields, refusal_fields = parameters.fields, parameters.refusal
    status = draft.local("eStatus", world.status.type)
    body, size = draft.local("iBody"), draft.local("iBodyLength")
    source: Variable = frame
    received: Variable = length
    if fields.count is not None:
        draft.add([Assignment(fields.count, number(0))])
    if wrapped(link):
        source, received = draft.declare("aBytes", world.frame, "local"), draft.local("iByteCount")
        unwrap = Call(
            world.routine("unwrap", *link_words(world, link)),
            ((LENGTH, length), ("aFrame", frame), ("aBytes", source)),
            (("iByteCount", received),),
            world.status.type,
        )
        draft.add([Assignment(status, unwrap), draft.status.passed_on(draft.result, status)])
    coded = code_type(shape)
    outputs: list[tuple[str, Expression]] = [(variable.name, variable) for variable in parameters.head.values()]
    code: Variable | None = None
    if coded is not None:
        code = draft.local(f"{PREFIXES[coded.name]}Code", coded)
        outputs.append((f"{PREFIXES[coded.name]}Code", code))
    refused = draft.local("xRefused", BOOL) if refusal is not None else None
    if refused is not None:
        outputs.append(("xRefused", refused))
    outputs += [("iBody", body), ("iBodyLength", size)]
    opened = Call(
        world.routine("open", *link_words(world, link), "response"),
        ((LENGTH, received), ("aFrame", source)),
        tuple(outputs),
        world.status.type,
    )
    draft.add([Assignment(status, opened), draft.status.passed_on(draft.result, status)])
    if code is not None and coded is not None:
        own = message.message.code_of("response") or 0
        word = "code" if own == message.message.code else "response_code"
        other: Expression = code.compared("<>", named(own, coded, message.name, word, hexadecimal=True))
        error = link.link.exception_response
        if refused is not None and error is not None and error.code is not None:
            other = every([refused.negated(), other])
        draft.refuse(other, "unknown_code")
    holder = Bytes(source, body)
    if refused is not None and refusal is not None and refusal_fields is not None:
        before, draft.body = draft.body, []
        _read_body(draft, refusal, refusal_fields, holder, size)
        inner = [*draft.body, *draft.status.give(draft.result, "refused")]
        draft.body = [*before, when(refused, inner)]
    refuse_other_subcode(draft, link, message, holder, size)
    _read_body(draft, record, fields, holder, size)
    return draft.finished()


def _read_body(draft: Draft, record: RecordLayout, fields: Fields, holder: Bytes, size: Expression) -> None:
    """Adds the statements that check the length of a body and read its fields into the outputs."""
    if record.least:
        draft.refuse(size.compared("<", size_of(record.name, "least_size", record.least)), "incomplete")
    if record.most is not None:
        draft.refuse(size.compared(">", size_of(record.name, "most_size", record.most)), "wrong_length")
    last = record.fields[-1] if record.fields else None
    element: Expression = number(last.size if last is not None else 0)
    if last is not None and last.cases:
        assert record.selector is not None
        element = draft.local("iSize")
    elif last is not None and fields.count is not None:
        draft.add(_element_count(draft, fields.count, size, last, element))
    for field in record.fields:
        if field.field.measures is not None:
            continue
        if field.cases:
            assert record.selector is not None
            selector = selecting(draft, record.selector, fields.place(record.selector))
            draft.add(read_choice(draft, field, selector, holder, fields.place(field), fields.count, size))
        else:
            draft.add(read_field(draft, field, holder, fields.place, _own_count(field, fields)))
    for field in record.fields:
        if field.field.measures is not None:
            wire = Wire.of_field(field)
            bits = holder.number(field.offset, field.size, wire.order, wire.swapped)
            measured = measure(record, field, fields.count, element)
            expected = measured.value if isinstance(measured, Whole) else measured.converted(wire.bits)
            draft.refuse(bits.compared("<>", expected), "wrong_measure")


def _element_count(
    draft: Draft, count: Variable, size: Expression, last: FieldLayout, element: Expression
) -> list[Statement]:
    """The statements that compute the number of elements in a body, which must hold whole ones only."""
    rest = size.plus(-last.offset) if last.offset else size
    if element == number(1):
        return [Assignment(count, rest)]
    odd = rest.combined("MOD", element).compared("<>", 0)
    return [draft.refusal(odd, "wrong_length"), Assignment(count, rest.combined("/", element))]


def refuse_other_bit_counts(draft: Draft, record: RecordLayout, size: Expression | None, holder: Bytes) -> None:
    """Refuses a number of bits, which has been written, that takes other than `size` bytes."""
    for field in record.fields:
        if not field.bits_of or size is None:
            continue
        wire = Wire.of_field(field)
        count = wire.number(draft.world, holder.number(field.offset, field.size, wire.order, wire.swapped)).converted(
            DINT
        )
        room = size.combined("*", 8)
        wrong = (count.compared(">", room.converted(DINT)), count.compared("<", room.plus(-7).converted(DINT)))
        draft.refuse(either(wrong), "wrong_measure")


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
    differs = every([bits.compared("<>", wire.literal(own)) for own in numbers])
    if next(iter(shared.messages.values())) is message:
        test = every([size.compared(">=", shared.end), differs])
    else:
        test = either([size.compared("<", shared.end), differs])
    draft.refuse(test, "unknown_code")
