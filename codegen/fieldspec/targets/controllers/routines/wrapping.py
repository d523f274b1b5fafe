"""Marks and characters: what turns the bytes of a frame into what is sent on a link, and back."""

from __future__ import annotations

from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.targets.controllers.routines.drafts import Draft
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.statements.expressions import (
    BYTE,
    INT,
    USINT,
    Expression,
    Variable,
    Whole,
    either,
    number,
    within,
)
from fieldspec.targets.controllers.statements.routine import Assignment, Body, Condition, Loop, Routine, Statement, when

LENGTH = "iLength"


def framed(link: LinkLayout) -> bool:
    """Whether frames of a link have more than a body: a header, a trailer, marks or characters."""
    return bool(link.request.header or link.request.trailer or wrapped(link))


def wrapped(link: LinkLayout) -> bool:
    """Whether the bytes are written as characters, or stand between marks."""
    shapes = (link.request, link.response)
    return link.link.transmission == "hex_ascii" or any(shape.start or shape.end for shape in shapes)


def link_words(world: World, link: LinkLayout) -> tuple[str, ...]:
    """The words in names of routines that tell links apart."""
    has_several = sum(framed(link) for link in world.layout.links.values()) > 1
    return (link.name,) if has_several else ()


def wrap_routine(world: World, link: LinkLayout) -> Routine:
    """The function that turns the bytes of a frame into what is sent."""
    start, end = link.request.start, link.request.end
    width = 2 if link.link.transmission == "hex_ascii" else 1
    draft = Draft(
        world,
        world.routine("wrap", *link_words(world, link)),
        f"frames of {link.name}",
        f"Writes bytes as they are sent on {link.name}: {_marks(link, link.request)}.",
    )
    count = draft.declare("iByteCount", INT, "input", "how many bytes there are")
    source = draft.declare("aBytes", world.frame, "in_out", "is read only")
    frame = draft.declare("aFrame", world.frame, "in_out", "receives what is sent")
    length = draft.declare(LENGTH, INT, "output", "how much of aFrame is sent")
    draft.add([Assignment(length, number(0))])
    draft.refuse(
        either([count.compared("<", 0), count.compared(">", (world.frame.high + 1 - len(start) - len(end)) // width)]),
        "no_room",
    )
    for position, byte in enumerate(start):
        draft.add([Assignment(frame.element(position), Whole(byte, BYTE))])
    index = draft.local("iAt")
    frame_index = (index.combined("*", width) if width > 1 else index).plus(len(start))
    source_byte = source.element(index)
    body: Body
    if width == 2:
        digit = draft.local("usiDigit", USINT)
        body = (
            *_write_digit(draft, digit, source_byte.converted(USINT).combined("/", 16), frame, frame_index),
            *_write_digit(draft, digit, source_byte.converted(USINT).combined("MOD", 16), frame, frame_index.plus(1)),
        )
    else:
        body = (Assignment(frame.element(frame_index), source_byte),)
    draft.add([Loop(index, number(0), count.plus(-1), body)])
    stop = (count.combined("*", width) if width > 1 else count).plus(len(start))
    for position, byte in enumerate(end):
        draft.add([Assignment(frame.element(stop.plus(position)), Whole(byte, BYTE))])
    draft.add([Assignment(length, stop.plus(len(end)))])
    return draft.finished()


def _write_digit(
    draft: Draft, digit: Variable, value: Expression, frame: Variable, position: Expression
) -> tuple[Statement, ...]:
    letter = digit.combined("+", ord("A") - 10)
    figure = digit.combined("+", ord("0"))
    return (
        Assignment(digit, value),
        when(digit.compared(">", 9), [Assignment(digit, letter)], [Assignment(digit, figure)]),
        Assignment(frame.element(position), digit.converted(BYTE)),
    )


def _marks(link: LinkLayout, shape: FrameLayout) -> str:
    text = "two hexadecimal digits for each byte" if link.link.transmission == "hex_ascii" else "as they are"
    before = f"16#{shape.start.hex(' ').upper()} before them" if shape.start else ""
    end_mark = f"16#{shape.end.hex(' ').upper()} after them" if shape.end else ""
    return ", ".join(text for text in (text, before, end_mark) if text)


def unwrap_routine(world: World, link: LinkLayout) -> Routine:
    """The function that extracts the bytes of a frame from what is received."""
    start, end = link.response.start, link.response.end
    draft = Draft(
        world,
        world.routine("unwrap", *link_words(world, link)),
        f"frames of {link.name}",
        f"Takes bytes out of what is received on {link.name}: {_marks(link, link.response)}.",
    )
    length = draft.declare(LENGTH, INT, "input", "how much of aFrame is received")
    frame = draft.declare("aFrame", world.frame, "in_out", "is read only")
    target = draft.declare("aBytes", world.frame, "in_out", "receives the bytes")
    count = draft.declare("iByteCount", INT, "output", "how many bytes there are")
    marks = len(start) + len(end)
    draft.add([Assignment(count, number(0))])
    draft.refuse(length.compared("<", marks), "wrong_mark")
    draft.refuse(length.compared(">", world.frame.high + 1), "no_room")
    for position, byte in enumerate(start):
        draft.refuse(frame.element(position).compared("<>", byte), "wrong_mark")
    for position, byte in enumerate(end):
        place = length.plus(position - len(end))
        draft.refuse(frame.element(place).compared("<>", byte), "wrong_mark")
    index = draft.local("iAt")
    if link.link.transmission != "hex_ascii":
        draft.add([Assignment(count, length.plus(-marks))])
        moved = Assignment(target.element(index), frame.element(index.plus(len(start))))
        draft.add([Loop(index, number(0), count.plus(-1), (moved,))])
        return draft.finished()
    digit, high = draft.local("usiDigit", USINT), draft.local("usiHigh", USINT)
    received_byte = frame.element(index.plus(len(start)))
    odd = index.combined("MOD", 2).compared("<>", 0)
    whole = high.combined("*", 16).combined("+", digit)
    place = index.combined("/", 2)
    body: Body = (
        Assignment(digit, received_byte.converted(USINT)),
        _digit_read(draft, digit),
        when(odd, [Assignment(target.element(place), whole.converted(BYTE))], [Assignment(high, digit)]),
    )
    draft.add([Loop(index, number(0), length.plus(-marks - 1), body)])
    draft.refuse(length.plus(-marks).combined("MOD", 2).compared("<>", 0), "wrong_length")
    draft.add([Assignment(count, length.plus(-marks).combined("/", 2))])
    return draft.finished()


def _digit_read(draft: Draft, digit: Variable) -> Statement:
    """The statement that makes a number of a hexadecimal character, a letter of either case included."""
    ranges = (("0", "9", 48), ("A", "F", 55), ("a", "f", 87))
    branches = []
    for low, high, less in ranges:
        test = within(digit, [(ord(low), ord(high))])
        assert test is not None
        branches.append((test, (Assignment(digit, digit.combined("-", less)),)))
    return Condition(tuple(branches), draft.status.give(draft.result, "not_hexadecimal"))
