"""Frames that are more than their bytes: delimiters around them, and bytes that are written as characters."""

from __future__ import annotations

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.language.model.preamble import Preamble
from fieldspec.targets.c.declarations import Declaration, Function, comment
from fieldspec.targets.c.expressions import (
    CAPACITY,
    INDEX,
    INPUT_BYTES,
    LENGTH,
    OUT,
    OUTPUT_BYTES,
    SIZE_TYPE,
    Call,
    Expression,
    Identifier,
    Type,
    any_of,
)
from fieldspec.targets.c.literals import ZERO, decimal, hexadecimal, hexadecimal_digits, unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.statements import Assignment, Body, Break, CountDown, CountUp, If, Statement, Variable, assign
from fieldspec.targets.c.values import refuse, return_ok, status_type

_FRAME, _SIZE, _TOTAL = Identifier("frame"), Identifier("size"), Identifier("total")
_BYTE = Identifier("byte")


def is_wrapped(link: LinkLayout) -> bool:
    """Whether a frame is more than its bytes: it has delimiters or escapes, or is written in characters."""
    if link.link.transmission == "hex_ascii" or link.link.escape:
        return True
    return any(frame.is_marked for frame in (link.request, link.response))


def unwrap_function(naming: Naming, link: LinkLayout, direction: str) -> str:
    """The name of the function that takes the delimiters off: one for both directions if they have the same."""
    words = ("parts",) if link.link.has_common_delimiters else (direction, "parts")
    return naming.function("link", link.name, *words)


def declare_unwrap(naming: Naming, link: LinkLayout, direction: str) -> list[Declaration]:
    """The function that takes the delimiters off a frame, and turns characters into bytes.

    `codec_status ascii_parts(const uint8_t *frame, size_t size, uint8_t *out, size_t capacity, size_t *length)`
    """
    start, end = link.link.delimiters(direction)
    length = LENGTH.dereferenced()
    delimiters = len(start) + len(end)
    body: list[Statement] = [Variable(SIZE_TYPE, "at"), *_skip_preamble(link.link.preamble)]
    if delimiters:
        body += refuse(naming, _SIZE.less(unsigned(delimiters)), "err_wrong_mark")
        body += refuse(naming, any_of(_wrong_delimiters(start, end)), "err_wrong_mark")
    body.append(assign(length, _SIZE - unsigned(delimiters)))
    too_small = refuse(naming, CAPACITY.less(length), "err_capacity")
    if link.link.transmission == "binary":
        byte = _FRAME.element(unsigned(len(start)) + INDEX)
        body += [*too_small, CountUp(INDEX, length, (assign(OUT.element(INDEX), byte),))]
    else:
        body += _read_characters(naming, len(start), length, too_small)
    body.append(return_ok(naming))
    parameters = (
        Variable(INPUT_BYTES, "frame"),
        Variable(SIZE_TYPE, "size"),
        Variable(OUTPUT_BYTES, "out"),
        Variable(SIZE_TYPE, "capacity"),
        Variable(Type("size_t", pointer=True), "length"),
    )
    return [
        comment("Removes the delimiters and writes the bytes between them. `out` may be the frame itself."),
        Function(status_type(naming), unwrap_function(naming, link, direction), parameters, tuple(body)),
    ]


def _skip_preamble(preamble: Preamble | None) -> Body:
    """Steps over the bytes of a preamble before the least ones, which are the first of the start delimiter."""
    if preamble is None or not preamble.spare:
        return ()
    is_other = _FRAME.element(INDEX).differs(hexadecimal(preamble.byte, 1))
    surplus = INDEX - unsigned(preamble.least) if preamble.least else INDEX
    steps = (Assignment(_FRAME, surplus, "+="), Assignment(_SIZE, surplus, "-="))
    return (
        CountUp(INDEX, unsigned(preamble.most), (If(any_of([INDEX.at_least(_SIZE), is_other]), (Break(),)),)),
        If(INDEX.greater(unsigned(preamble.least)), steps),
    )


def _wrong_delimiters(start: bytes, end: bytes) -> list[Expression]:
    """`frame[0] != 0x3Au`, `frame[size - 1u] != 0x0Au`"""
    first = [_FRAME.element(decimal(index)).differs(hexadecimal(byte, 1)) for index, byte in enumerate(start)]
    places = [_SIZE - unsigned(len(end) - index) for index in range(len(end))]
    last = [_FRAME.element(place).differs(hexadecimal(byte, 1)) for place, byte in zip(places, end, strict=True)]
    return [*first, *last]


def _read_characters(naming: Naming, start: int, length: Expression, too_small: Body) -> Body:
    """Refuses what is not a hexadecimal digit, then joins two digits to each byte."""
    digit = naming.own("digit")
    is_no_digit = Call(digit, (_FRAME.element(unsigned(start) + INDEX),)).greater(unsigned(15))
    first = Call(digit, (_FRAME.element(unsigned(start) + (unsigned(2) * INDEX)),))
    second = Call(digit, (_FRAME.element(unsigned(start + 1) + (unsigned(2) * INDEX)),))
    byte = ((first << decimal(4)) | second).cast("uint8_t")
    return (
        CountUp(INDEX, length, refuse(naming, is_no_digit, "err_not_hex")),
        *refuse(naming, (length % unsigned(2)).differs(ZERO), "err_wrong_length"),
        Assignment(length, unsigned(2), "/="),
        *too_small,
        CountUp(INDEX, length, (assign(OUT.element(INDEX), byte),)),
    )


def wrap_frame(naming: Naming, link: LinkLayout, direction: str) -> Body:
    """Turns the bytes at `out` into a frame with delimiters, the last byte first, as they overwrite themselves."""
    shape = link.frame(direction)
    start, end = shape.further + shape.start, shape.end
    if link.link.transmission == "hex_ascii":
        digit = naming.own("hex_digit")
        high = (_BYTE >> decimal(4)).cast("uint8_t")
        low = (_BYTE & unsigned(15)).cast("uint8_t")
        size = unsigned(len(start)) + (unsigned(2) * _TOTAL)
        first = unsigned(len(start)) + (unsigned(2) * INDEX)
        second = unsigned(len(start) + 1) + (unsigned(2) * INDEX)
        moved: Body = (
            Variable(Type("uint8_t", const=True), "byte", value=OUT.element(INDEX)),
            assign(OUT.element(first), Call(digit, (high,))),
            assign(OUT.element(second), Call(digit, (low,))),
        )
    else:
        size = unsigned(len(start)) + _TOTAL
        moved = (assign(OUT.element(unsigned(len(start)) + INDEX), OUT.element(INDEX)),)
    return (
        CountDown(INDEX, _TOTAL, moved),
        *(assign(OUT.element(decimal(index)), hexadecimal_digits(byte, 2)) for index, byte in enumerate(start)),
        *(assign(OUT.element(size + unsigned(index)), hexadecimal_digits(byte, 2)) for index, byte in enumerate(end)),
    )
