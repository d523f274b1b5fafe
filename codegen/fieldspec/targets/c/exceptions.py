"""Exception responses: what marks them, read from a frame, and compared before one is written."""

from __future__ import annotations

from fieldspec.codec.layout.exception_mark import ExceptionMark
from fieldspec.codec.layout.frame import FrameLayout, LinkLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.link import ExceptionResponse
from fieldspec.targets.c.conditions import out_of_range_test
from fieldspec.targets.c.expressions import IN, LENGTH, OUT, Expression, Group, Identifier, Unary, all_of
from fieldspec.targets.c.literals import ZERO, decimal, unsigned
from fieldspec.targets.c.naming import Naming, argument, frame_member
from fieldspec.targets.c.parts import code_type
from fieldspec.targets.c.statements import Assignment, Body, If, assign
from fieldspec.targets.c.values import refuse

_CODE = Identifier("code")


def read_mark(mark: ExceptionResponse, frame: FrameLayout, code: Expression, error: Expression) -> Body:
    """Finds out whether a response is an exception response, and takes the flag off its code."""
    if mark.part:
        part = next(part for part in frame.header if part.name == mark.part)
        assert part.value is not None
        value = replace(part.value, ranges=mark.permitted(part.value, True), sentinels=(), write_ranges=None)
        out_of_range = out_of_range_test(value, OUT.arrow(frame_member(part)))
        assert out_of_range is not None, "a check sees to it that the part has other numbers too"
        return (assign(error, Group(out_of_range).negated()),)
    if mark.code is not None:
        return (assign(error, code.equals(unsigned(mark.code))),)
    flag = unsigned(mark.flag)
    without_flag = Assignment(code, Unary("~", flag.cast(code_type(frame).name)), "&=")
    return (assign(error, (code & flag).differs(ZERO)), If(error, (without_flag,)))


def mark_in_data(mark: ExceptionMark, frame: FrameLayout) -> Expression:
    """Whether the data of a frame that is read have the mark: `length >= 10u && in[8] == 128u`"""
    end = frame.header_size + mark.end + frame.trailer_size
    tests = [LENGTH.at_least(unsigned(end))]
    for place, byte in enumerate(mark.pattern):
        tests.append(IN.element(decimal(frame.header_size + mark.offset + place)).equals(unsigned(byte)))
    return all_of(tests)


def check_mark(naming: Naming, link: LinkLayout, frame: FrameLayout, is_exception: bool) -> Body:
    """Refuses a part, or a code, that marks the other kind of response."""
    mark = link.link.exception_response
    if mark is None or frame.direction == "request" or mark.flag or mark.field:
        return ()
    if mark.code is not None:
        wrong = _CODE.differs(unsigned(mark.code))
        return refuse(naming, wrong, "err_unknown_code") if is_exception else ()
    part = next(part for part in frame.header if part.name == mark.part)
    assert part.value is not None
    value = replace(part.value, ranges=mark.permitted(part.value, is_exception), sentinels=(), write_ranges=None)
    out_of_range = out_of_range_test(value, Identifier(argument(part)))
    return refuse(naming, out_of_range, "err_out_of_range") if out_of_range is not None else ()
