"""Links: the objects that turn messages into frames and back, and the framers."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.carrying import carries
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.part import PartLayout
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.language.model.escape import CAN_BITS
from fieldspec.targets.fact_texts import described
from fieldspec.targets.python.error_views import ErrorView, error_view
from fieldspec.targets.python.fixed_frames import FixedFrame, fixed_frame, has_fixed_length
from fieldspec.targets.python.frames import (
    PartView,
    argument_views,
    code_literal,
    escape_call,
    frames_arguments,
    head_refusals,
    head_tests,
    head_value,
    is_simple,
    marks_exceptions,
)
from fieldspec.targets.python.framing import framer
from fieldspec.targets.python.naming import Scope
from fieldspec.targets.python.record_shape import RecordShape
from fieldspec.targets.python.slots import Words
from fieldspec.targets.python.text import chained, docstring, item_lines, literal, union
from fieldspec.targets.python.writing import pairs


@dataclass(frozen=True, slots=True)
class ExchangeView:
    """One message on one link in one direction.

    `fixed` is None where the frame is not packed in one call, and `reader` is empty where it is not unpacked in one.
    """

    writer: str
    reader: str
    message: str
    key: str
    known: list[str]
    fixed: FixedFrame | None
    parameters: str
    frames: str
    head: str
    refusals: list[str]
    refuse: list[str]
    wrapper: str
    unit_address: str
    head_parts: list[PartView]


@dataclass(frozen=True, slots=True)
class DirectionView:
    """A link in one direction: its `Frames`, its classes, and the code of its methods.

    `unrequested` are the names and classes of coded messages without a request.
    """

    direction: str
    frames: str
    marked: bool
    kind: str
    escape: str
    arguments: list[str]
    quick: str
    quickly: str
    classes: str
    rows: list[str]
    unrequested: list[tuple[str, str]]
    has_subcodes: bool
    has_response_codes: bool
    alias: str
    union: list[str]
    exchanges: list[ExchangeView]
    wrapper: str
    head_parts: list[PartView]
    writer: str
    before: str
    after: str
    call: str
    construction: str
    code: str
    framer: str
    framer_arguments: list[str]
    framer_doc: list[str]

    @property
    def unrequested_classes(self) -> str:
        """The name of the mapping with the classes of messages without a request."""
        return self.classes.replace("_RESPONSE_CLASSES", "_UNREQUESTED_CLASSES")


@dataclass(frozen=True, slots=True)
class WrapperView:
    """A class for the frames of a link whose headers have more parts than the unit address."""

    name: str
    base: str
    doc: list[str]
    slots: str
    match_args: str
    init: list[str]
    parameters: str
    head_parts: list[PartView]


@dataclass(frozen=True, slots=True)
class LinkView:
    """A link. `request` is None if only the device sends anything on it, `response` if it sends nothing."""

    name: str
    type: str
    doc: list[str]
    unit_addresses: str
    broadcast: str
    unanswered: bool
    is_can: bool
    is_extended: bool
    wrappers: list[WrapperView]
    request: DirectionView | None
    response: DirectionView | None
    error: ErrorView | None

    @property
    def directions(self) -> list[DirectionView]:
        """The directions in which there are frames."""
        return [side for side in (self.request, self.response) if side is not None]


@dataclass(frozen=True, slots=True)
class Exchange:
    """A message that goes over a link: its shape and its class in both directions."""

    message: MessageLayout
    request: RecordShape
    response: RecordShape
    request_name: str
    response_name: str

    def side(self, direction: str) -> tuple[RecordShape, str]:
        """The shape and the class in one direction."""
        return (self.request, self.request_name) if direction == "request" else (self.response, self.response_name)


def link_view(
    link: LinkLayout, exchanges: list[Exchange], records: Mapping[str, RecordLayout], words: Words, scope: Scope
) -> LinkView:
    """The view of a link and of the messages that it carries."""
    name = scope.take(link.name)
    pascal = Name.of(link.name).pascal()
    coded = any(part.role == "code" for part in link.request.header)
    carried = [exchange for exchange in exchanges if carries(link, exchange.message)]
    unit_addresses = link.link.unit_addresses
    views = {
        direction: _direction(
            link,
            direction,
            [exchange for exchange in carried if exchange.message.name in link.carried(direction)],
            records,
            words,
            pascal,
            scope,
        )
        for direction in ("request", "response")
        if link.carried(direction) or not link.messages
    }
    marked = coded or link.has_uncoded_exceptions
    error = error_view(link, words, pascal, scope) if marked and "response" in views else None
    wrappers = [
        _wrapper(view.wrapper, direction, ["message: _M"], view.head_parts)
        for direction, view in views.items()
        if view.head_parts
    ]
    if error is not None and views["response"].head_parts:
        wrappers.append(
            _wrapper(error.wrapper, "exception_response", ["code: int", "exception: _M"], views["response"].head_parts)
        )
    facts = [f"Unit addresses {unit_addresses.ranges.text()}."] if unit_addresses and unit_addresses.ranges else []
    if unit_addresses and unit_addresses.broadcast is not None:
        facts.append(f"A request to {unit_addresses.broadcast} is for all devices.")
    return LinkView(
        name=name,
        type=scope.take(f"{pascal}Link"),
        doc=docstring(described(link.link.title or Name.of(link.name).title(), link.link, " ".join(facts)), 4),
        unit_addresses=pairs(unit_addresses.ranges if unit_addresses else None) or "()",
        broadcast=str(unit_addresses.broadcast) if unit_addresses else "None",
        is_can=link.link.is_can,
        is_extended=link.link.escape is not None and link.link.escape.bits == CAN_BITS[1],
        unanswered=len(link.carried("response")) < len(link.messages),
        wrappers=wrappers,
        request=views.get("request"),
        response=views.get("response"),
        error=error,
    )


_KINDS = {
    "request": ("_Request", "A request on this link, with all parts of its header."),
    "response": ("_Response", "A response on this link, with all parts of its header."),
    "exception_response": ("_ExceptionResponse", "An exception response on this link, with all parts of its header."),
}


def _wrapper(name: str, kind: str, attributes: list[str], arguments: list[PartView]) -> WrapperView:
    """The class for one kind of frame; `attributes` follow the unit address in every frame of its kind."""
    base, text = _KINDS[kind]
    names = [attribute.partition(":")[0] for attribute in attributes]
    quoted = "".join(f'"{part.name}", ' for part in arguments).rstrip()
    return WrapperView(
        name=name,
        base=base,
        doc=docstring([text], 4),
        slots=quoted,
        match_args=", ".join(["unit_address", *names]).replace(", ", '", "'),
        init=item_lines(
            "def __init__(",
            ["self", "unit_address: int", *attributes, *(f"{part.name}: {part.type}" for part in arguments)],
            ") -> None:",
            4,
        ),
        parameters=", ".join(["unit_address", *names]),
        head_parts=arguments,
    )


def _direction(
    link: LinkLayout,
    direction: str,
    carried: list[Exchange],
    records: Mapping[str, RecordLayout],
    words: Words,
    pascal: str,
    scope: Scope,
) -> DirectionView:
    frame = link.frame(direction)
    upper = Name.of(link.name).upper()
    frames = f"_{upper}_{direction.upper()}S"
    code = frame.role("code")
    parts = argument_views(frame, words)
    unit_address = frame.role("unit_address")
    wrapper = scope.take(f"{pascal}{direction.capitalize()}") if parts else f"_{direction.capitalize()}"
    alias = scope.take(f"Any{pascal}{direction.capitalize()}")
    views = [_exchange(link, direction, exchange, frames, wrapper, parts) for exchange in carried]
    messages = [
        (exchange.message.name, exchange.message.message.code_of(direction), exchange.side(direction)[0].record)
        for exchange in carried
    ]
    refusal = (
        records[link.link.exception_response.record]
        if link.link.exception_response and direction == "response"
        else None
    )
    names = [literal(exchange.message.name) if code is None else exchange.side(direction)[1] for exchange in carried]
    framing, arguments, doc = framer(link, direction, messages, refusal, frames, names)
    unit_address_expression = f"head[{frame.header.index(unit_address)}]" if unit_address else "0"
    return DirectionView(
        direction=direction,
        frames=frames,
        marked=frame.is_marked or link.link.transmission == "hex_ascii",
        kind="_EscapedFrames" if frame.escape else "_Frames" if is_simple(frame) else "_PartFrames",
        escape=escape_call(frame),
        arguments=frames_arguments(link, frame),
        quick=f"_{upper}_QUICK_{direction.upper()}S",
        quickly=_quick_key(code),
        classes=f"_{upper}_{direction.upper()}_CLASSES",
        rows=_class_rows(link, direction, carried, views),
        unrequested=[
            (literal(exchange.message.name), exchange.side(direction)[1])
            for exchange in carried
            if code is not None and not exchange.message.message.is_requested
        ],
        has_subcodes=code is not None and bool(link.shared_codes(direction)),
        has_response_codes=code is not None and link.has_response_codes,
        alias=alias,
        union=union(alias, [view.message for view in views]),
        exchanges=views,
        wrapper=wrapper,
        head_parts=parts,
        before="unit_address: int, " if unit_address else "",
        after="".join(f", {part.name}: {part.accepted}" for part in parts).replace(", ", ", *, ", 1),
        writer=f"_to_{link.name}",
        call=", ".join(["unit_address"] * bool(unit_address) + [part.number for part in parts]),
        construction=", ".join([unit_address_expression, "{}", *(part.expression for part in parts)]),
        code=f"head[{frame.header.index(code)}]" if code else "",
        framer=framing,
        framer_arguments=arguments,
        framer_doc=doc,
    )


def _class_rows(link: LinkLayout, direction: str, carried: list[Exchange], views: list[ExchangeView]) -> list[str]:
    """The classes of messages by their codes, numbers or names: `0x03: ReadRequest`."""
    names = {exchange.message.name: exchange.side(direction)[1] for exchange in carried}
    coded = link.frame(direction).role("code") is not None
    shared = link.subcodes(direction) if coded else {}
    ambiguous = link.ambiguous_codes(direction)
    rows = []
    for exchange, view in zip(carried, views, strict=True):
        code = exchange.message.message.code_of(direction)
        if code is not None and code in ambiguous:
            if ambiguous[code][0] is exchange.message:
                rows.append(f"{view.key}: _Answers({', '.join(names[message.name] for message in ambiguous[code])})")
            continue
        if code is None or code not in shared:
            rows += [f"{key}: {view.message}" for key in view.known or [view.key]]
            continue
        subcode = shared[code]
        if next(iter(subcode.messages.values())) is exchange.message:
            members = ", ".join(f"{number:#x}: {names[message.name]}" for number, message in subcode.messages.items())
            place = f"{subcode.offset}, {subcode.size}, {literal(subcode.order)}"
            rows.append(f"{view.key}: _Subcodes({place}, {{{members}}})")
    return rows


def _quick_key(code: PartLayout | None) -> str:
    """The place of a code of one byte, by which whole frames are unpacked; empty where there is none."""
    return str(code.offset) if code is not None and code.size == 1 and not code.form else ""


def _message_names(message: MessageLayout) -> list[str]:
    """The names of a message whose frames have no code: its number and its name."""
    number = message.message.number
    return ([] if number is None else [str(number)]) + [literal(message.name)]


def _exchange(
    link: LinkLayout, direction: str, exchange: Exchange, frames: str, wrapper: str, arguments: list[PartView]
) -> ExchangeView:
    shaped, name = exchange.side(direction)
    frame = link.frame(direction)
    code = exchange.message.message.code_of(direction)
    upper = f"_{Name.of(exchange.message.name).upper()}_{Name.of(link.name).upper()}_{direction.upper()}"
    part, unit_address = frame.role("code"), frame.role("unit_address")
    flag = link.link.exception_response.flag if link.link.exception_response and direction == "response" else 0
    is_fixed = has_fixed_length(shaped, frame)
    # A code with the flag of exception responses names no message, and only a code of one byte is a key of the table.
    # Of messages that share a code, the body tells which one it is.
    shared = code is not None and len(link.messages_with_code(code, direction)) > 1
    marked = any(marks_exceptions(link, frame, part) for part in frame.header)
    marked = marked or (direction == "response" and link.mark is not None)
    reads = is_fixed and not shared and not marked and (part is None or (part.size == 1 and not (code or 0) & flag))
    request = exchange.message if direction == "request" else None
    tests, refusals = head_tests(link, frame, request), head_refusals(link, frame, request)
    unfit = f"_unfit({literal(shaped.record.name)})"
    return ExchangeView(
        writer=f"_to_{link.name}",
        reader=f"_from_{link.name}" if reads else "",
        message=name,
        key=code_literal(code) if part is not None else name,
        known=_message_names(exchange.message) if part is None else [],
        fixed=fixed_frame(shaped, link, direction, code, upper, frames, tests, reads) if is_fixed else None,
        parameters="".join(
            [", unit_address: int"] * (unit_address is not None)
            + [f", {argument.variable}: int" for argument in arguments]
        ),
        frames=frames,
        head=f"[{', '.join(head_value(part, code_literal(code)) for part in frame.header)}]",
        refusals=chained("error = ", refusals, "or", "None", 8) if refusals else [],
        refuse=chained("raise ", ["self._refused()", *refusals, unfit], "or", "", 8),
        wrapper=wrapper,
        unit_address="unit_address" if unit_address is not None else "0",
        head_parts=arguments,
    )
