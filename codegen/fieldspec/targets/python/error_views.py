"""Exception responses of links: what marks them, and how they are built."""

from __future__ import annotations

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.targets.python.frames import argument_views, head_refusals, head_value
from fieldspec.targets.python.naming import Scope
from fieldspec.targets.python.slots import Words
from fieldspec.targets.python.text import chained, literal
from fieldspec.targets.python.writing import within


@dataclass(frozen=True, slots=True)
class ErrorView:
    """The exception responses of a link: what marks them, the code in the reply, the record, and the parts.

    They are `coded` where frames carry the code of the request, and `by_response` where this is the code of the usual
    response, which may be another one.
    """

    wrapper: str
    condition: str
    code: str
    record: str
    head: str
    bind: list[str]
    refusals: list[str]
    coded: bool = True
    by_response: bool = False


def error_view(link: LinkLayout, words: Words, pascal: str, scope: Scope) -> ErrorView | None:
    """The exception responses of a link; None where it has none, or where nothing in a frame marks them."""
    error, frame = link.link.exception_response, link.response
    code = frame.role("code")
    if error is None:
        return None
    arguments = argument_views(frame, words)
    place = next((index for index, part in enumerate(frame.header) if part.name == error.part), 0)
    condition = "" if error.normal is None else f"not ({within(f'head[{place}]', error.normal)})"
    if link.has_uncoded_exceptions:
        if link.mark is not None:
            condition = f"body[{link.mark.offset}:{link.mark.end}] == {link.mark.pattern!r}"
        refusals = head_refusals(link, frame, is_exception=True)
        return ErrorView(
            wrapper=scope.take(f"{pascal}ExceptionResponse") if arguments else "_ExceptionResponse",
            condition=condition,
            code="kind.CODE or 0",
            record=words.records[error.record],
            head=f"[{', '.join(head_value(part, '0') for part in frame.header)}]",
            bind=[f"{part.variable} = {part.number}" for part in arguments],
            refusals=chained("_wrong = ", refusals, "or", "None", 8) if refusals else [],
            coded=False,
        )
    if code is None or code.value is None:
        return None
    head = [head_value(part, f"code | {error.flag:#x}" if error.flag else "code") for part in frame.header]
    limits = (code.value.low, code.value.high) if error.code is None else (error.code, error.code)
    limit = f"_refused_number({literal(code.name)}, code, {limits[0]}, {limits[1]})"
    if error.code is not None:
        limit = f"_refused_code(code, {error.code:#04x})"
    if error.normal is None:
        condition = f"code & {error.flag:#x}" if error.flag else f"code == {error.code}"
    return ErrorView(
        wrapper=scope.take(f"{pascal}ExceptionResponse") if arguments else "_ExceptionResponse",
        condition=condition,
        code=f"code & {~error.flag & code.value.type.high:#x}" if error.flag else "code",
        record=words.records[error.record],
        head=f"[{', '.join(head)}]",
        bind=[f"{part.variable} = {part.number}" for part in arguments],
        refusals=chained("_wrong = ", [*head_refusals(link, frame, is_exception=True), limit], "or", "", 8),
        by_response=error.code is None and link.has_response_codes,
    )
