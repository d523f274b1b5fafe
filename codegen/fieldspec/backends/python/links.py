"""Links: the objects that turn messages into frames and back, and the framers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from fieldspec.backends.python.framing import framer
from fieldspec.backends.python.fusing import Fused, fused, fuses, letter, number, variable
from fieldspec.backends.python.lines import chained, listed, union
from fieldspec.backends.python.naming import Scope
from fieldspec.backends.python.records import RecordShape
from fieldspec.backends.python.slots import Words
from fieldspec.backends.python.text import described, docstring, literal
from fieldspec.backends.python.writing import pairs, tuple_of, within
from fieldspec.layout.frame import FrameLayout, LinkLayout, PartLayout
from fieldspec.layout.message import MessageLayout
from fieldspec.layout.record import RecordLayout
from fieldspec.model.ranges import Ranges
from fieldspec.names import Name


@dataclass(frozen=True, slots=True)
class PartView:
    """A plain part of the head: its attribute, its variable, its type, and the lines that make it from `head`."""

    name: str
    variable: str
    type: str
    made: str
    quickly: str


@dataclass(frozen=True, slots=True)
class ExchangeView:
    """One message on one link in one direction.

    `fused` is None where the frame is not packed at once, and `reader` empty where it is not read at once.
    """

    writer: str
    reader: str
    message: str
    key: str
    fused: Fused | None
    parameters: str
    frames: str
    head: str
    refusals: list[str]
    refuse: list[str]
    wrapper: str
    station: str
    plain: list[PartView]


@dataclass(frozen=True, slots=True)
class DirectionView:
    """A link in one direction: its `Frames`, its classes, and the code of its methods."""

    direction: str
    frames: str
    arguments: list[str]
    quick: str
    quickly: str
    classes: str
    alias: str
    union: list[str]
    exchanges: list[ExchangeView]
    wrapper: str
    wraps: bool
    plain: list[PartView]
    init: list[str]
    slots: str
    before: str
    after: str
    call: str
    made: str
    code: str
    framer: str
    framer_arguments: list[str]
    framer_doc: list[str]


@dataclass(frozen=True, slots=True)
class ErrorView:
    """The refusals of a link: the flag in the code, the record, and how such a frame is made."""

    flag: str
    mask: str
    record: str
    head: str
    refusals: list[str]


@dataclass(frozen=True, slots=True)
class LinkView:
    """A link."""

    name: str
    type: str
    doc: list[str]
    stations: str
    broadcast: str
    marked: bool
    request: DirectionView
    response: DirectionView
    error: ErrorView | None


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
    coded = any(part.role == "code" for part in link.request.head)
    carried = [one for one in exchanges if (one.message.message.code is not None) == coded]
    stations = link.link.stations
    views = {
        direction: _direction(link, direction, carried, records, words, pascal, scope)
        for direction in ("request", "response")
    }
    facts = [f"Stations {stations.ranges.text()}."] if stations and stations.ranges else []
    if stations and stations.broadcast is not None:
        facts.append(f"A request to {stations.broadcast} is for all of them.")
    return LinkView(
        name=name,
        type=scope.take(f"{pascal}Link"),
        doc=docstring(described(link.link.title or Name.of(link.name).title(), link.link, " ".join(facts)), 4),
        stations=pairs(stations.ranges if stations else None) or "()",
        broadcast=str(stations.broadcast) if stations else "None",
        marked=bool(link.link.start or link.link.end or link.link.encoding == "hex_ascii"),
        request=views["request"],
        response=views["response"],
        error=_error(link, words) if coded else None,
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
    plain = [_plain(part, place, words) for place, part in enumerate(frame.head) if part.role == "plain"]
    station = frame.role("station")
    wrapper = scope.take(f"{pascal}{direction.capitalize()}") if plain else f"_{direction.capitalize()}"
    alias = scope.take(f"Any{pascal}{direction.capitalize()}")
    views = [_exchange(link, direction, one, frames, wrapper, plain) for one in carried]
    messages = [(one.message.name, one.message.message.code, one.side(direction)[0].record) for one in carried]
    refusal = records[link.link.error.record] if link.link.error and direction == "response" else None
    framing, arguments, doc = framer(link, direction, messages, refusal, frames)
    held = f"head[{frame.head.index(station)}]" if station else "0"
    return DirectionView(
        direction=direction,
        frames=frames,
        arguments=_frames_arguments(link, frame),
        quick=f"_{upper}_QUICK_{direction.upper()}S",
        quickly=_quick_key(code),
        classes=f"_{upper}_{direction.upper()}_CLASSES",
        alias=alias,
        union=union(alias, [view.message for view in views]),
        exchanges=views,
        wrapper=wrapper,
        wraps=bool(plain),
        plain=plain,
        init=listed(
            "def __init__(",
            ["self", "station: int", "message: _M", *(f"{part.name}: {part.type}" for part in plain)],
            ") -> None:",
            4,
        ),
        slots="".join(f'"{part.name}", ' for part in plain).rstrip(),
        before="station: int, " if station else "",
        after="".join(f", {part.name}: {part.type}" for part in plain).replace(", ", ", *, ", 1),
        call=", ".join(["station"] * bool(station) + [part.name for part in plain]),
        made=", ".join([held, "{}", *(part.made for part in plain)]),
        code=f"head[{frame.head.index(code)}]" if code else "",
        framer=framing,
        framer_arguments=arguments,
        framer_doc=doc,
    )


def _quick_key(code: PartLayout | None) -> str:
    """The place of a code of one byte, by which whole frames are unpacked; empty where there is none."""
    return str(code.offset) if code is not None and code.size == 1 else ""


def _plain(part: PartLayout, place: int, words: Words) -> PartView:
    flags = part.value.flags if part.value else ""
    made = f"{words.flags[flags]}({{}})" if flags else "{}"
    name = Scope(frozenset({"station", "message", "self", "frame", "request"})).take(part.name)
    return PartView(
        name=name,
        variable=variable(part),
        type=words.flags[flags] if flags else "int",
        made=made.format(f"head[{place}]"),
        quickly=made.format(variable(part)),
    )


def _frames_arguments(link: LinkLayout, frame: FrameLayout) -> list[str]:
    order = next((part.order for part in frame.head if part.size > 1), "big")
    letters = "".join(map(letter, frame.head))
    arguments = [literal(f"{'<' if order == 'little' else '>'}{letters}")]
    arguments.append(literal(frame.check.algorithm if frame.check else ""))
    if frame.check and frame.check.order == "big":
        arguments.append('check_order="big"')
    for role in ("code", "length"):
        part = frame.role(role)
        if part is not None:
            arguments += [f"{role}={frame.head.index(part)}", f"{role}_offset={part.offset}"]
            if role == "length":
                arguments += [f"length_name={literal(part.name)}", f"longest={256**part.size - 1}"]
    for name, mark in (("start", link.link.start), ("end", link.link.end)):
        if mark:
            arguments.append(f'{name}=bytes.fromhex("{mark.hex()}")')
    if link.link.encoding == "hex_ascii":
        arguments.append("hexadecimal=True")
    return arguments


def _exchange(
    link: LinkLayout, direction: str, one: Exchange, frames: str, wrapper: str, plain: list[PartView]
) -> ExchangeView:
    shaped, name = one.side(direction)
    frame = link.frame(direction)
    code = one.message.message.code
    upper = f"_{Name.of(one.message.name).upper()}_{Name.of(link.name).upper()}_{direction.upper()}"
    part, station = frame.role("code"), frame.role("station")
    flag = link.link.error.flag if link.link.error and direction == "response" else 0
    together = fuses(shaped, frame)
    # A code with the flag of refusals in it never names a message; and only a code of one byte is quickly had.
    reads = together and (part is None or (part.size == 1 and not (code or 0) & flag))
    tests, refusals = _head_tests(link, frame), _head_refusals(link, frame)
    unfit = f"_unfit({literal(shaped.record.name)})"
    return ExchangeView(
        writer=f"_to_{link.name}",
        reader=f"_from_{link.name}" if reads else "",
        message=name,
        key=code_literal(code) if part is not None else name,
        fused=fused(shaped, link, direction, code, upper, frames, tests) if together else None,
        parameters="".join(
            [", station: int"] * (station is not None) + [f", {held.variable}: {held.type}" for held in plain]
        ),
        frames=frames,
        head=f"[{', '.join(_head_value(held, code) for held in frame.head)}]",
        refusals=chained("error = ", refusals, "or", "None", 8) if refusals else [],
        refuse=chained("raise ", ["self._refused()", *refusals, unfit], "or", "", 8),
        wrapper=wrapper,
        station="station" if station is not None else "0",
        plain=plain,
    )


def code_literal(code: int | None) -> str:
    """A code as Python writes it: `0x03`, `None`."""
    return "None" if code is None else f"{code:#04x}"


def _head_value(part: PartLayout, code: int | None) -> str:
    if part.role == "length":
        return "0"
    return code_literal(code) if part.role == "code" else number(part)


def _allowed(link: LinkLayout, part: PartLayout) -> tuple[tuple[tuple[int, int], ...], tuple[int, ...]]:
    """The intervals of a part of the head, and values beside them."""
    assert part.value is not None
    stations = link.link.stations if part.role == "station" else None
    if stations is not None and stations.ranges is not None:
        beside = () if stations.broadcast is None else (stations.broadcast,)
        return stations.ranges.intervals, beside
    return (part.value.ranges.intervals if part.value.ranges else ()), ()


def _set(frame: FrameLayout) -> list[PartLayout]:
    """The parts of the head that the caller sets."""
    return [part for part in frame.head if part.role in ("station", "plain")]


def _head_tests(link: LinkLayout, frame: FrameLayout) -> list[str]:
    tests = []
    for part in _set(frame):
        intervals, beside = _allowed(link, part)
        if intervals:
            tests.append(within(number(part), Ranges(intervals), beside))
    return tests


def _head_refusals(link: LinkLayout, frame: FrameLayout) -> list[str]:
    found = []
    for part in _set(frame):
        assert part.value is not None
        intervals, beside = _allowed(link, part)
        limits = [str(part.value.type.low), str(part.value.type.high)]
        if intervals:
            limits.append(pairs(Ranges(intervals)))
        if part.value.flags:
            found.append(f"_refused_flags({literal(part.name)}, {variable(part)}, {', '.join(limits[1:])})")
            continue
        if beside:
            limits.append(tuple_of(beside))
        found.append(f"_refused_number({literal(part.name)}, {variable(part)}, {', '.join(limits)})")
    return found


def _error(link: LinkLayout, words: Words) -> ErrorView | None:
    error, frame = link.link.error, link.response
    code = frame.role("code")
    if error is None or code is None or code.value is None:
        return None
    head = [f"code | {error.flag:#x}" if part.role == "code" else _head_value(part, None) for part in frame.head]
    limit = f"_refused_number({literal(code.name)}, code, {code.value.type.low}, {code.value.type.high})"
    return ErrorView(
        flag=f"{error.flag:#x}",
        mask=f"{~error.flag & code.value.type.high:#x}",
        record=words.records[error.record],
        head=f"[{', '.join(head)}]",
        refusals=chained("error = ", [*_head_refusals(link, frame), limit], "or", "", 8),
    )
