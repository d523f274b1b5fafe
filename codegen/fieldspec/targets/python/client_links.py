"""Links of clients: how requests and responses belong together, and the times that the manual prints."""

from __future__ import annotations

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.exception_mark import reason_field
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.open_parts import OpenPart, open_parts
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.repeated_parts import repeated_fields
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.names import Name
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.link import Link, Serial
from fieldspec.language.model.operand import Operands
from fieldspec.language.model.texts import Limit
from fieldspec.targets.python.client_names import CODEC, ClientNames
from fieldspec.targets.python.frames import PartView, head_arguments
from fieldspec.targets.python.links import LinkView
from fieldspec.targets.python.naming import RECORD
from fieldspec.targets.python.record_shape import shape
from fieldspec.targets.python.text import item_lines, literal
from fieldspec.targets.python.writing import tuple_of

_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6}
"""The units of times, in seconds."""


@dataclass(frozen=True, slots=True)
class ClientLinkView:
    """A link of a client: its constant, its name as a literal, and the call that creates it.

    `choices` are the parts of requests that users choose: their names and their types.
    """

    name: str
    title: str
    call: list[str]
    choices: list[tuple[str, str]]


def _is_exact(field: FieldLayout) -> bool:
    """Whether a number comes back as it was given: no fraction is rounded on the way."""
    return field.value is not None and is_count(field.value.encoding) and not field.value.scaled


def is_framed(link: LinkLayout) -> bool:
    """Whether anything stands around a body."""
    spoken = link.link
    return bool(
        link.request.header or link.request.trailer or spoken.transmission == "hex_ascii" or spoken.start or spoken.end
    )


def reply_type(view: LinkView) -> str:
    """The type of a response on a link."""
    wrapper = view.response.wrapper if view.response is not None else "_Response"
    return f"{wrapper}[_R]" if wrapper.startswith("_") else f"{CODEC}.{wrapper}[_R]"


def client_link(
    layout: DeviceLayout, link: LinkLayout, view: LinkView, names: ClientNames, is_different: bool
) -> ClientLinkView:
    """The view of a link: how requests and responses belong together, and the times that the manual prints.

    `is_different`: the messages that access registers depend on the link.
    """
    addressed = link.request.role("unit_address") is not None
    arguments = [f"{CODEC}.{view.name}", f"addressed={addressed}"]
    if addressed and link.response.role("unit_address") is None:
        arguments.append("answers_addressed=False")
    arguments += [f"registers={literal(link.name)}"] * is_different
    parts = named_parts(link, view)
    arguments += _parts(link, view, parts)
    timeout = _timeout(layout, link)
    arguments += [f"timeout={timeout!r}"] if timeout is not None else []
    pause = _pause(link.link)
    arguments += [f"pause={pause!r}"] if pause else []
    refusal = link.link.exception_response
    arguments += [f"refusal_code={refusal.code}"] if refusal is not None and refusal.code is not None else []
    arguments += ["refusal_code=0"] if link.has_uncoded_exceptions and link.request.role("code") is None else []
    arguments += _reason(layout.records[refusal.record], names) if refusal is not None else []
    arguments += _refused_code(layout, link, names)
    arguments += _refusal_part(link, view, names)
    repeated, value_counts = [], []
    for message in link.exchanged.values():
        access = message.message.single_access
        exchange = names.exchanges[message.name]
        request = f"{CODEC}.{exchange.request_name}"
        request_slots = {slot.title: slot for slot in exchange.request.stored}
        answer = {slot.title: slot for slot in exchange.response.stored}
        pairs = [
            (request_slots[own.name].name, answer[other.name].name)
            for own, other in repeated_fields(message)
            if own.name in request_slots and other.name in answer and (access is None or _is_exact(own))
        ]
        if pairs:
            names_of = [tuple_of([literal(own), literal(other)]) for own, other in pairs]
            repeated.append(f"{request}: {tuple_of(names_of)}")
        if access is None or layout.device.bit_access(message.message) is not None:
            continue
        slots = (request_slots.get(access.count), answer.get(access.values))
        if access.operation == "write" and access.count not in request_slots:
            slots = (request_slots.get(access.values), answer.get(access.count))
        own_slot, other_slot = slots
        if own_slot is not None and other_slot is not None:
            value_counts.append(f"{request}: ({literal(own_slot.name)}, {literal(other_slot.name)})")
    arguments += [f"repeated={{{', '.join(repeated)}}}"] if repeated else []
    arguments += [f"value_counts={{{', '.join(value_counts)}}}"] if value_counts else []
    response_messages = link.carried("response")
    silent = [
        f"{CODEC}.{names.exchanges[name].request_name}" for name in link.messages if name not in response_messages
    ]
    arguments += [f"unanswered={tuple_of(silent)}"] if silent else []
    name = f"_{Name.of(link.name).upper()}"
    return ClientLinkView(name, literal(link.name), item_lines(f"{name} = _Link(", arguments, ")", 0), _choices(parts))


def named_parts(link: LinkLayout, view: LinkView) -> list[tuple[PartView, OpenPart]]:
    """The open parts of the requests on a link, each with its view in Python."""
    assert view.request is not None, "only the device sends anything"
    return list(zip(view.request.head_parts, open_parts(link), strict=True))


def _choices(parts: list[tuple[PartView, OpenPart]]) -> list[tuple[str, str]]:
    """The parts that users choose: their names and their types."""
    return [
        (own.name, own.type if own.type == "int" else f"{CODEC}.{own.type}")
        for own, part in parts
        if part.numbering is None
    ]


def _response_names(link: LinkLayout, view: LinkView) -> dict[str, str]:
    """The attributes of a response with the parts before its body, by the names of the parts."""
    own = view.response.head_parts if view.response is not None else []
    passed = [part for part in head_arguments(link.response) if part.role == "plain"]
    return {part.name: part_view.name for part, part_view in zip(passed, own, strict=True)}


def _parts(link: LinkLayout, view: LinkView, parts: list[tuple[PartView, OpenPart]]) -> list[str]:
    """The arguments with the parts of requests that are slots, that users choose, and that responses repeat."""
    response_names = _response_names(link, view)
    counters = [
        f"({literal(own.name)}, {part.numbering[0]}, {part.numbering[1]})" for own, part in parts if part.numbering
    ]
    echoes = [
        f"{literal(own.name)}: {literal(response_names[part.repeated.name])}"
        for own, part in parts
        if part.repeated is not None and (part.numbering is None or response_names[part.repeated.name] != own.name)
    ]
    chosen = [literal(name) for name, _ in _choices(parts)]
    return [
        *([f"counters={tuple_of(counters)}"] if counters else []),
        *([f"parts={tuple_of(chosen)}"] if chosen else []),
        *([f"echoes={{{', '.join(echoes)}}}"] if echoes else []),
    ]


def _refusal_part(link: LinkLayout, view: LinkView, names: ClientNames) -> list[str]:
    """The arguments with the part of an exception response that says why, and with its enum; none without one."""
    mark = link.link.exception_response
    if mark is None or not mark.part:
        return []
    part = next(part for part in link.response.header if part.name == mark.part)
    enum = part.value.enum if part.value is not None else ""
    enum_argument = (
        [f"refusal_names={{int(own): own for own in {CODEC}.{names.words.enums[enum].name}}}"] if enum else []
    )
    return [f"refusal_part={literal(_response_names(link, view)[part.name])}", *enum_argument]


def _reason(record: RecordLayout, names: ClientNames) -> list[str]:
    """The argument with the field of an exception response that says why; none where it is the first one."""
    field = reason_field(record)
    stored = shape(record, names.words, RECORD).stored
    own = next((slot for slot in stored if field is not None and slot.title == field.name), None)
    return [f"reason={literal(own.name)}"] if own is not None and own is not stored[0] else []


def _refused_code(layout: DeviceLayout, link: LinkLayout, names: ClientNames) -> list[str]:
    """The argument with the field of an exception response that repeats the code of the request; none without one."""
    refusal, coded = link.link.exception_response, link.request.role("code")
    if refusal is None or coded is None:
        return []
    stored = shape(layout.records[refusal.record], names.words, RECORD).stored
    own = next((slot for slot in stored if slot.field.field.same_as == coded.name), None)
    return [f"refused_code={literal(own.name)}"] if own is not None else []


def _timeout(layout: DeviceLayout, link: LinkLayout) -> float | None:
    """The longest time that a step of a task states for an answer on a link; None where none does."""
    limits = {limit.place.path: limit for limit in layout.device.limits}
    carried = {f"messages/{name}" for name in link.messages}
    operands = Operands(layout.device)
    known = [
        seconds(limits[step.timeout])
        for task in layout.device.tasks
        for step in task.steps
        if step.action == "send"
        and step.timeout in limits
        and any(operand.path in carried for operand in operands.target(step.target))
    ]
    return max((time for time in known if time is not None), default=None)


def seconds(limit: Limit) -> float | None:
    """The most that a limit permits, in seconds; None where it is not a time."""
    factor = _UNITS.get(limit.unit)
    return None if factor is None or limit.most is None else round(float(limit.most) * factor, 9)


def _pause(link: Link) -> float:
    """The seconds of silence before a request, at the settings as delivered."""
    if link.silence_milliseconds is not None:
        return float(link.silence_milliseconds) / 1000
    if link.silence_characters is None or link.serial is None:
        return 0.0
    return round(float(link.silence_characters) * _bits(link.serial) / link.serial.factory_baud, 6)


def _bits(serial: Serial) -> int:
    """The bits of a character, with the start bit."""
    return 1 + serial.factory_data_bits + (serial.factory_parity != "none") + serial.factory_stop_bits
