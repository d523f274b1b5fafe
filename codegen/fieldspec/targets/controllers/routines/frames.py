"""Frames of a link: what stands around a body is checked and taken away, or put there."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.language.model.encoding import is_odd
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.holders import Bytes, Holder
from fieldspec.targets.controllers.routines.values import Wire, read, write
from fieldspec.targets.controllers.routines.world import PREFIXES, World
from fieldspec.targets.controllers.routines.wrapping import LENGTH, link_words, unwrap_routine, wrap_routine, wrapped
from fieldspec.targets.controllers.statements.expressions import (
    BOOL,
    INT,
    UNSIGNED,
    Elementary,
    Expression,
    Truth,
    Variable,
    either,
    number,
    outside,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Routine, Statement, when

_LENGTHS = {1: "byLength", 2: "wLength", 4: "dwLength"}
_CHECKS = {1: "byCheck", 2: "wCheck"}


def head_members(shape: FrameLayout) -> list[PartLayout]:
    """The parts before the body that users give: neither the length nor the code, nor a constant."""
    return [part for part in shape.header if part.is_argument]


def wire_of(part: PartLayout) -> Wire:
    """The wire value of a part, which must have a value."""
    assert part.value is not None
    return Wire(part.value, part.order, False)


def code_type(shape: FrameLayout) -> Elementary | None:
    """The type of the code, None where frames carry none."""
    part = shape.role("code")
    return UNSIGNED[part.size] if part is not None else None


def frame_routines(world: World, link: LinkLayout) -> Iterator[Routine]:
    """The functions that close the requests of a link and open its responses."""
    if wrapped(link):
        yield wrap_routine(world, link)
        yield unwrap_routine(world, link)
    yield _close(world, link)
    yield _open(world, link)


def _close(world: World, link: LinkLayout) -> Routine:
    shape = link.request
    draft = Draft(
        world,
        world.routine("close", *link_words(world, link), "request"),
        f"frames of {link.name}",
        f"Completes a request whose body lies from aFrame[{shape.header_size}] on. {_form(link)}",
    )
    arguments = {part.name: _part_declared(draft, part, "input") for part in head_members(shape)}
    kind = code_type(shape)
    code = draft.declare("uCode" if kind is None else f"{PREFIXES[kind.name]}Code", kind, "input") if kind else None
    body_length = draft.declare("iBodyLength", INT, "input", "bytes of the body")
    frame = draft.declare("aFrame", world.frame, "in_out")
    length = draft.declare(LENGTH, INT, "output", "bytes of the request")
    holder = Bytes(frame, number(0))
    total = body_length.plus(shape.header_size + shape.trailer_size)
    draft.add([Assignment(length, number(0))])
    room = world.frame.high + 1
    out_of_room = total.compared(">", room)
    draft.refuse(either([body_length.compared("<", 0), out_of_room]), "no_room")
    for part in shape.header:
        if part.role != "checksum":
            draft.add(_write_header_part(draft, link, shape, part, arguments, code, total, holder))
    check = shape.checksum
    trailing_parts = [part for part in shape.trailer if part is not check]
    if trailing_parts:
        tail = draft.local("iTail")
        draft.add([Assignment(tail, body_length.plus(shape.header_size))])
        for part in trailing_parts:
            draft.add(_write_constant(part, Bytes(frame, tail), part.offset + shape.trailer_size))
    if check is not None:
        total_size = shape.header_size + shape.trailer_size

        def place(index: int) -> Expression:
            return number(index) if index >= 0 else body_length.plus(total_size + index)

        position = draft.local("iAt")
        draft.add([Assignment(position, total if check.stop is None else place(check.stop))])
        wide = world.checksum(check.algorithm, position, frame, place(check.start))
        raw = draft.local(_CHECKS[check.size], wide.type)
        draft.add([Assignment(raw, wide)])
        if check.stop != check.offset:
            draft.add([Assignment(position, place(check.offset))])
        draft.add(Bytes(frame, position).stored(0, check.size, check.order, False, raw))
    draft.add([Assignment(length, total)])
    return draft.finished()


def _write_header_part(
    draft: Draft,
    link: LinkLayout,
    shape: FrameLayout,
    part: PartLayout,
    arguments: dict[str, Variable],
    code: Variable | None,
    total: Expression,
    holder: Holder,
) -> list[Statement]:
    wire = wire_of(part)
    if part.role == "length":
        raw = draft.local(_LENGTHS[wire.bits.size], wire.bits)
        units, tests = _units(shape, part, total)
        greatest_length = (draft.world.frame.high + 1 - part.base) // part.unit_size
        if greatest_length > wire.value.type.high:
            tests.append(units.compared(">", wire.value.type.high))
        refusals = [draft.refusal(either(tests), "wrong_length")] if tests else []
        value = units.converted(wire.bits)
        return [*refusals, Assignment(raw, value), *holder.stored(part.offset, part.size, part.order, False, raw)]
    if part.role == "code":
        assert code is not None
        return _stored(draft, wire, holder, part, code)
    if part.constant is not None:
        return _write_constant(part, holder, part.offset)
    source = arguments[part.name]
    addresses = link.link.unit_addresses
    statements: list[Statement] = []
    if part.role == "unit_address" and addresses is not None and addresses.ranges is not None:
        intervals = [*addresses.ranges.intervals]
        if addresses.broadcast is not None and addresses.broadcast not in addresses.ranges:
            intervals.append((addresses.broadcast, addresses.broadcast))
        wrong = outside(source.converted(wire.whole), intervals)
        if wrong is not None:
            statements.append(draft.refusal(wrong, "out_of_range"))
    return [*statements, *write(draft, wire, holder.behind(part.offset), source)]


def _write_constant(part: PartLayout, holder: Holder, offset: int) -> list[Statement]:
    """The statements that write the constant of a part at an offset."""
    wire = wire_of(part)
    assert part.constant is not None
    return holder.stored(offset, part.size, part.order, False, wire.literal(part.constant))


def _units(shape: FrameLayout, part: PartLayout, total: Expression) -> tuple[Expression, list[Expression]]:
    """The number in a length part of a frame of `total` bytes, and the conditions under which it has no such number."""
    size_from_base = total.plus(-part.base)
    tests: list[Expression] = (
        [size_from_base.compared("<", 0)] if part.base > shape.header_size + shape.trailer_size else []
    )
    if part.unit_size == 1:
        return size_from_base, tests
    size = number(part.unit_size)
    tests.append(size_from_base.combined("MOD", size).compared("<>", 0))
    return size_from_base.combined("/", size), tests


def _stored(draft: Draft, wire: Wire, holder: Holder, part: PartLayout, source: Variable) -> list[Statement]:
    if part.size == 1:
        return holder.stored(part.offset, 1, part.order, False, source.converted(wire.bits))
    raw = draft.local("wRaw", wire.bits)
    too_large = outside(source, [(0, wire.value.type.high)]) if is_odd(wire.value.encoding) else None
    return [
        *([] if too_large is None else [draft.refusal(too_large, "unknown_code")]),
        Assignment(raw, source.converted(wire.bits)),
        *holder.stored(part.offset, part.size, part.order, False, raw),
    ]


def _open(world: World, link: LinkLayout) -> Routine:
    shape = link.response
    draft = Draft(
        world,
        world.routine("open", *link_words(world, link), "response"),
        f"frames of {link.name}",
        f"Checks a response and finds its body. {_form(link)}",
    )
    length = draft.declare(LENGTH, INT, "input", "bytes of the response")
    frame = draft.declare("aFrame", world.frame, "in_out", "is read only")
    outputs = {part.name: _part_declared(draft, part, "output") for part in head_members(shape)}
    kind = code_type(shape)
    error = link.link.exception_response
    flag = "" if error is None else ", without the flag of an exception"
    code = draft.declare(f"{PREFIXES[kind.name]}Code", kind, "output", f"code{flag}") if kind else None
    refused = draft.declare("xRefused", BOOL, "output", "the body says why") if error is not None else None
    body = draft.declare("iBody", INT, "output", "index of the first byte of the body")
    body_length = draft.declare("iBodyLength", INT, "output", "bytes of the body")
    holder = Bytes(frame, number(0))
    shortest = shape.header_size + shape.trailer_size
    draft.add([Assignment(body, number(shape.header_size)), Assignment(body_length, number(0))])
    if refused is not None:
        draft.add([Assignment(refused, Truth(False))])
    draft.refuse(length.compared("<", shortest), "incomplete")
    draft.refuse(length.compared(">", world.frame.high + 1), "no_room")
    for length_part in shape.lengths:
        draft.refuse(_length_differs(world, shape, length_part, holder, length), "wrong_length")
    check = shape.checksum
    if check is not None:

        def place(index: int) -> Expression:
            return number(index) if index >= 0 else length.plus(index)

        position = draft.local("iAt")
        draft.add([Assignment(position, place(check.offset))])
        received_check = Bytes(frame, position).number(0, check.size, check.order, False)
        stop = position if check.stop == check.offset else length if check.stop is None else place(check.stop)
        wide = world.checksum(check.algorithm, stop, frame, place(check.start))
        draft.refuse(wide.compared("<>", received_check), "wrong_checksum")
    for part in shape.header:
        if part.role not in ("length", "code", "checksum") and not part.reserved:
            target = outputs.get(part.name)
            draft.add(read(draft, wire_of(part), holder.behind(part.offset), target))
    trailing_parts = [part for part in shape.trailer if part is not check and not part.reserved]
    if trailing_parts:
        tail = draft.local("iTail")
        draft.add([Assignment(tail, length.plus(-shape.trailer_size))])
        for part in trailing_parts:
            offset = part.offset + shape.trailer_size
            draft.add(read(draft, wire_of(part), Bytes(frame, tail, offset), None))
    coded = shape.role("code")
    if coded is not None and code is not None:
        draft.add(_code_read(link, coded, holder, code, refused))
    if error is not None and error.normal is not None and refused is not None:
        part = next(part for part in shape.header if part.name == error.part)
        other = outside(outputs[part.name].converted(wire_of(part).whole), error.normal.intervals)
        draft.add([Assignment(refused, other if other is not None else Truth(False))])
    draft.add([Assignment(body_length, length.plus(-shortest))])
    return draft.finished()


def _length_differs(world: World, shape: FrameLayout, part: PartLayout, holder: Holder, length: Variable) -> Expression:
    """The condition under which a length part does not say how many bytes a frame has."""
    wire = wire_of(part)
    bits = holder.number(part.offset, part.size, part.order, False)
    if (part.unit_size, part.base) == (1, 0) and part.size < 3:
        # A number of two bytes that INT does not hold becomes a negative one, which no length is.
        return bits.converted(INT).compared("<>", length)
    units, tests = _units(shape, part, length)
    if (world.frame.high + 1 - part.base) // part.unit_size > wire.value.type.high:
        tests.append(units.compared(">", wire.value.type.high))
    return either([*tests, bits.compared("<>", units.converted(wire.bits))])


def _code_read(
    link: LinkLayout, part: PartLayout, holder: Holder, code: Variable, refused: Variable | None
) -> list[Statement]:
    bits = holder.number(part.offset, part.size, part.order, False)
    assert isinstance(code.type, Elementary)
    statements: list[Statement] = [Assignment(code, bits.converted(code.type))]
    error = link.link.exception_response
    if error is not None and refused is not None and error.code is not None:
        statements.append(Assignment(refused, code.compared("=", error.code)))
    if error is not None and refused is not None and error.flag:
        assert isinstance(bits.type, Elementary)
        marked = bits.combined("AND", error.flag).compared("<>", 0)
        without = bits.combined("AND", bits.type.high & ~error.flag)
        statements.append(
            when(marked, [Assignment(refused, Truth(True)), Assignment(code, without.converted(code.type))])
        )
    return statements


def _part_declared(draft: Draft, part: PartLayout, role: str) -> Variable:
    wire = wire_of(part)
    kind = draft.world.type_of(wire.value)
    return draft.declare(draft.world.variable(part.name, kind), kind, role, draft.world.comment(part.part, wire.value))


def _form(link: LinkLayout) -> str:
    parts = [part.name for part in link.link.request]
    return f"A frame of {link.name} has these parts: {', '.join(parts)}."
