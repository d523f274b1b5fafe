"""Frames of a link: what stands around a body is checked and taken away, or put there."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.layout.frame import FrameLayout, LinkLayout, PartLayout
from fieldspec.plc.routines.draft import Draft
from fieldspec.plc.routines.expressions import (
    Conversion,
    Element,
    Expression,
    Operation,
    Truth,
    Variable,
    Whole,
    compared,
    converted,
    either,
    number,
    outside,
    plus,
    within,
)
from fieldspec.plc.routines.holders import Bytes, Holder
from fieldspec.plc.routines.routine import Routine
from fieldspec.plc.routines.statements import Assignment, Body, Condition, Loop, Statement, when
from fieldspec.plc.routines.types import BOOL, BYTE, INT, UNSIGNED, USINT, Elementary
from fieldspec.plc.routines.values import Wire, read, write
from fieldspec.plc.routines.world import PREFIXES, World

LENGTH = "iLength"


def framed(link: LinkLayout) -> bool:
    """Whether anything stands around a body."""
    return bool(link.request.head or link.request.tail or wrapped(link))


def wrapped(link: LinkLayout) -> bool:
    """Whether the bytes are written as characters, or stand between marks."""
    return link.link.encoding == "hex_ascii" or bool(link.link.start or link.link.end)


def head_members(shape: FrameLayout) -> list[PartLayout]:
    """The parts before the body that users give: neither the length nor the code, nor a constant."""
    return [
        part
        for part in shape.head
        if part.role in ("station", "plain") and not (part.value and part.value.const is not None)
    ]


def wire_of(part: PartLayout) -> Wire:
    """The value of a part that holds one."""
    assert part.value is not None
    return Wire(part.value, part.order, False)


def code_type(shape: FrameLayout) -> Elementary | None:
    """The type of the code, None where frames carry none."""
    part = shape.role("code")
    return UNSIGNED[part.size] if part is not None else None


def link_words(world: World, link: LinkLayout) -> tuple[str, ...]:
    """The words in names of routines that tell links apart."""
    several = sum(framed(one) for one in world.layout.links.values()) > 1
    return (link.name,) if several else ()


def frame_routines(world: World, link: LinkLayout) -> Iterator[Routine]:
    """What opens the responses of a link and closes its requests."""
    if wrapped(link):
        yield _wrap(world, link)
        yield _unwrap(world, link)
    yield _close(world, link)
    yield _open(world, link)


def _close(world: World, link: LinkLayout) -> Routine:
    shape = link.request
    draft = Draft(
        world.routine("close", *link_words(world, link), "request"),
        f"frames of {link.name}",
        world.status,
        f"Completes a request whose body lies from aFrame[{shape.head_size}] on. {_form(link)}",
    )
    given = {part.name: _part_declared(draft, world, part, "input") for part in head_members(shape)}
    kind = code_type(shape)
    code = draft.declare("uCode" if kind is None else f"{PREFIXES[kind.name]}Code", kind, "input") if kind else None
    body_length = draft.declare("iBodyLength", INT, "input", "bytes of the body")
    frame = draft.declare("aFrame", world.frame, "in_out")
    length = draft.declare(LENGTH, INT, "output", "bytes of the request")
    holder = Bytes(frame, number(0))
    total = plus(body_length, shape.head_size + shape.tail_size)
    draft.add([Assignment(length, number(0))])
    most = world.frame.high + 1
    out_of_room = compared(total, ">", number(most))
    draft.refuse(either([compared(body_length, "<", number(0)), out_of_room]), "no_room")
    for part in shape.head:
        draft.add(_head_written(draft, world, link, part, given, code, total, holder))
    check = shape.check
    if check is not None:
        end = plus(body_length, shape.head_size)
        at = draft.local("iAt")
        draft.add([Assignment(at, end)])
        wide = world.checksum(check.algorithm, at, frame)
        raw = draft.local("wCheck" if check.size == 2 else "byCheck", wide.type)
        draft.add([Assignment(raw, wide), *Bytes(frame, at).stored(0, check.size, check.order, False, raw)])
    draft.add([Assignment(length, total)])
    return draft.finished()


def _head_written(
    draft: Draft,
    world: World,
    link: LinkLayout,
    part: PartLayout,
    given: dict[str, Variable],
    code: Variable | None,
    total: Expression,
    holder: Holder,
) -> list[Statement]:
    wire = wire_of(part)
    if part.role == "length":
        raw = draft.local("wLength" if part.size == 2 else "byLength", wire.bits)
        tests = []
        if world.frame.high + 1 > wire.value.type.high:
            tests.append(draft.refusal(compared(total, ">", number(wire.value.type.high)), "wrong_length"))
        value = Conversion(total, wire.bits)
        return [*tests, Assignment(raw, value), *holder.stored(part.offset, part.size, part.order, False, raw)]
    if part.role == "code":
        assert code is not None
        return _stored(draft, wire, holder, part, code)
    if wire.value.const is not None:
        literal = Whole(wire.value.const & wire.bits.high, wire.bits)
        return holder.stored(part.offset, part.size, part.order, False, literal)
    source = given[part.name]
    stations = link.link.stations
    statements: list[Statement] = []
    if part.role == "station" and stations is not None and stations.ranges is not None:
        intervals = [*stations.ranges.intervals]
        if stations.broadcast is not None and stations.broadcast not in stations.ranges:
            intervals.append((stations.broadcast, stations.broadcast))
        wrong = outside(converted(source, wire.whole), intervals, wire.whole)
        if wrong is not None:
            statements.append(draft.refusal(wrong, "out_of_range"))
    return [*statements, *write(draft, world, wire, holder, part.offset, source)]


def _stored(draft: Draft, wire: Wire, holder: Holder, part: PartLayout, source: Variable) -> list[Statement]:
    if part.size == 1:
        return holder.stored(part.offset, 1, part.order, False, converted(source, wire.bits))
    raw = draft.local("wRaw", wire.bits)
    return [
        Assignment(raw, converted(source, wire.bits)),
        *holder.stored(part.offset, part.size, part.order, False, raw),
    ]


def _open(world: World, link: LinkLayout) -> Routine:
    shape = link.response
    draft = Draft(
        world.routine("open", *link_words(world, link), "response"),
        f"frames of {link.name}",
        world.status,
        f"Checks a response and finds its body. {_form(link)}",
    )
    length = draft.declare(LENGTH, INT, "input", "bytes of the response")
    frame = draft.declare("aFrame", world.frame, "in_out", "is read only")
    held = {part.name: _part_declared(draft, world, part, "output") for part in head_members(shape)}
    kind = code_type(shape)
    error = link.link.error
    flag = "" if error is None else ", without the mark of a refusal"
    code = draft.declare(f"{PREFIXES[kind.name]}Code", kind, "output", f"code{flag}") if kind else None
    refused = draft.declare("xRefused", BOOL, "output", "the body says why") if error is not None else None
    body = draft.declare("iBody", INT, "output", "index of the first byte of the body")
    body_length = draft.declare("iBodyLength", INT, "output", "bytes of the body")
    holder = Bytes(frame, number(0))
    least = shape.head_size + shape.tail_size
    draft.add([Assignment(body, number(shape.head_size)), Assignment(body_length, number(0))])
    if refused is not None:
        draft.add([Assignment(refused, Truth(False))])
    draft.refuse(compared(length, "<", number(least)), "incomplete")
    draft.refuse(compared(length, ">", number(world.frame.high + 1)), "no_room")
    for part in shape.head:
        if part.role == "length":
            wire = wire_of(part)
            said = Conversion(holder.number(part.offset, part.size, part.order, False), INT)
            draft.refuse(compared(said, "<>", length), "wrong_length")
            assert wire.value.type.high <= 0x7FFF or part.size == 2
    check = shape.check
    if check is not None:
        at = draft.local("iAt")
        draft.add([Assignment(at, plus(length, check.offset))])
        have = Bytes(frame, at).number(0, check.size, check.order, False)
        draft.refuse(compared(world.checksum(check.algorithm, at, frame), "<>", have), "wrong_check")
    for part in shape.head:
        if part.role not in ("length", "code"):
            target = held.get(part.name)
            draft.add(read(draft, world, wire_of(part), holder, part.offset, target))
    coded = shape.role("code")
    if coded is not None and code is not None:
        draft.add(_code_read(link, coded, holder, code, refused))
    draft.add([Assignment(body_length, plus(length, -least))])
    return draft.finished()


def _code_read(
    link: LinkLayout, part: PartLayout, holder: Holder, code: Variable, refused: Variable | None
) -> list[Statement]:
    bits = holder.number(part.offset, part.size, part.order, False)
    assert isinstance(code.type, Elementary)
    statements: list[Statement] = [Assignment(code, Conversion(bits, code.type))]
    error = link.link.error
    if error is not None and refused is not None:
        assert isinstance(bits.type, Elementary)
        marked = compared(Operation("AND", (bits, Whole(error.flag, bits.type)), bits.type), "<>", Whole(0, bits.type))
        without = Operation("AND", (bits, Whole(bits.type.high & ~error.flag, bits.type)), bits.type)
        statements.append(
            when(marked, [Assignment(refused, Truth(True)), Assignment(code, Conversion(without, code.type))])
        )
    return statements


def _part_declared(draft: Draft, world: World, part: PartLayout, role: str) -> Variable:
    wire = wire_of(part)
    kind = world.type_of(wire.value)
    return draft.declare(world.variable(part.name, kind), kind, role, world.told(part.part, wire.value))


def _form(link: LinkLayout) -> str:
    parts = [part.name for part in link.link.request]
    return f"A frame of {link.name} has these parts: {', '.join(parts)}."


def _wrap(world: World, link: LinkLayout) -> Routine:
    start, end = link.link.start, link.link.end
    width = 2 if link.link.encoding == "hex_ascii" else 1
    draft = Draft(
        world.routine("wrap", *link_words(world, link)),
        f"frames of {link.name}",
        world.status,
        f"Writes bytes as they are sent on {link.name}: {_marks(link)}.",
    )
    count = draft.declare("iBytes", INT, "input", "how many bytes there are")
    source = draft.declare("aBytes", world.frame, "in_out", "is read only")
    frame = draft.declare("aFrame", world.frame, "in_out", "receives what is sent")
    length = draft.declare(LENGTH, INT, "output", "how much of aFrame is sent")
    draft.add([Assignment(length, number(0))])
    draft.refuse(
        either(
            [
                compared(count, "<", number(0)),
                compared(count, ">", number((world.frame.high + 1 - len(start) - len(end)) // width)),
            ]
        ),
        "no_room",
    )
    for at, byte in enumerate(start):
        draft.add([Assignment(Element(frame, number(at), BYTE), Whole(byte, BYTE))])
    index = draft.local("iAt")
    here = plus(Operation("*", (index, number(width)), INT) if width > 1 else index, len(start))
    held = Element(source, index, BYTE)
    body: Body
    if width == 2:
        digit = draft.local("usiDigit", USINT)
        body = (
            *_digit_written(
                draft, digit, Operation("/", (Conversion(held, USINT), Whole(16, USINT)), USINT), frame, here
            ),
            *_digit_written(
                draft, digit, Operation("MOD", (Conversion(held, USINT), Whole(16, USINT)), USINT), frame, plus(here, 1)
            ),
        )
    else:
        body = (Assignment(Element(frame, here, BYTE), held),)
    draft.add([Loop(index, number(0), plus(count, -1), body)])
    stop = plus(Operation("*", (count, number(width)), INT) if width > 1 else count, len(start))
    for at, byte in enumerate(end):
        draft.add([Assignment(Element(frame, plus(stop, at), BYTE), Whole(byte, BYTE))])
    draft.add([Assignment(length, plus(stop, len(end)))])
    return draft.finished()


def _digit_written(
    draft: Draft, digit: Variable, value: Expression, frame: Variable, at: Expression
) -> tuple[Statement, ...]:
    letter = Operation("+", (digit, Whole(ord("A") - 10, USINT)), USINT)
    figure = Operation("+", (digit, Whole(ord("0"), USINT)), USINT)
    return (
        Assignment(digit, value),
        when(compared(digit, ">", Whole(9, USINT)), [Assignment(digit, letter)], [Assignment(digit, figure)]),
        Assignment(Element(frame, at, BYTE), Conversion(digit, BYTE)),
    )


def _marks(link: LinkLayout) -> str:
    text = "two hexadecimal digits for each byte" if link.link.encoding == "hex_ascii" else "as they are"
    before = f"16#{link.link.start.hex(' ').upper()} before them" if link.link.start else ""
    behind = f"16#{link.link.end.hex(' ').upper()} behind them" if link.link.end else ""
    return ", ".join(one for one in (text, before, behind) if one)


def _unwrap(world: World, link: LinkLayout) -> Routine:
    start, end = link.link.start, link.link.end
    draft = Draft(
        world.routine("unwrap", *link_words(world, link)),
        f"frames of {link.name}",
        world.status,
        f"Takes bytes out of what is received on {link.name}: {_marks(link)}.",
    )
    length = draft.declare(LENGTH, INT, "input", "how much of aFrame is received")
    frame = draft.declare("aFrame", world.frame, "in_out", "is read only")
    target = draft.declare("aBytes", world.frame, "in_out", "receives the bytes")
    count = draft.declare("iBytes", INT, "output", "how many bytes there are")
    marks = len(start) + len(end)
    draft.add([Assignment(count, number(0))])
    draft.refuse(compared(length, "<", number(marks)), "wrong_mark")
    draft.refuse(compared(length, ">", number(world.frame.high + 1)), "no_room")
    for at, byte in enumerate(start):
        draft.refuse(compared(Element(frame, number(at), BYTE), "<>", Whole(byte, BYTE)), "wrong_mark")
    for at, byte in enumerate(end):
        place = plus(length, at - len(end))
        draft.refuse(compared(Element(frame, place, BYTE), "<>", Whole(byte, BYTE)), "wrong_mark")
    index = draft.local("iAt")
    if link.link.encoding != "hex_ascii":
        draft.add([Assignment(count, plus(length, -marks))])
        taken = Assignment(Element(target, index, BYTE), Element(frame, plus(index, len(start)), BYTE))
        draft.add([Loop(index, number(0), plus(count, -1), (taken,))])
        return draft.finished()
    digit, high = draft.local("usiDigit", USINT), draft.local("usiHigh", USINT)
    here = Element(frame, plus(index, len(start)), BYTE)
    odd = compared(Operation("MOD", (index, number(2)), INT), "<>", number(0))
    whole = Operation("+", (Operation("*", (high, Whole(16, USINT)), USINT), digit), USINT)
    place = Operation("/", (index, number(2)), INT)
    body: Body = (
        Assignment(digit, Conversion(here, USINT)),
        _digit_read(draft, digit),
        when(
            odd,
            [Assignment(Element(target, place, BYTE), Conversion(whole, BYTE))],
            [Assignment(high, digit)],
        ),
    )
    draft.add([Loop(index, number(0), plus(length, -marks - 1), body)])
    draft.refuse(compared(Operation("MOD", (plus(length, -marks), number(2)), INT), "<>", number(0)), "wrong_length")
    draft.add([Assignment(count, Operation("/", (plus(length, -marks), number(2)), INT))])
    return draft.finished()


def _digit_read(draft: Draft, digit: Variable) -> Statement:
    """What makes the number of a character; letters of both cases are taken."""
    ranges = (("0", "9", 48), ("A", "F", 55), ("a", "f", 87))
    branches = []
    for low, high, less in ranges:
        test = within(digit, [(ord(low), ord(high))], USINT)
        assert test is not None
        branches.append((test, (Assignment(digit, Operation("-", (digit, Whole(less, USINT)), USINT)),)))
    return Condition(tuple(branches), draft.status.give(draft.result, "not_hexadecimal"))
