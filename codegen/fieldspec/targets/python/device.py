"""A version's module as a whole."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from fieldspec.codec.layout.carrying import carries
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.foundation.classes import dataclass, replace
from fieldspec.foundation.names import Name
from fieldspec.targets.fact_texts import sentence
from fieldspec.targets.python.enums import enum_view, flags_view
from fieldspec.targets.python.frames import code_literal
from fieldspec.targets.python.links import Exchange, ExchangeView, LinkView, link_view
from fieldspec.targets.python.naming import MESSAGE, RECORD, Scope, module_scope
from fieldspec.targets.python.parameters import parameter_set_view, space_views
from fieldspec.targets.python.quantities import conversion_view
from fieldspec.targets.python.record_parts import column_lines, record_doc
from fieldspec.targets.python.record_shape import RecordShape, shape
from fieldspec.targets.python.records import RecordView, record_view
from fieldspec.targets.python.registers import register_views, table_view
from fieldspec.targets.python.requests import register_accesses
from fieldspec.targets.python.slots import Words
from fieldspec.targets.python.text import docstring, literal
from fieldspec.targets.python.writing import tuple_of


@dataclass(frozen=True, slots=True)
class MessageView:
    """The data of a message in one direction, and its frames on each link.

    `number` and `supplements` are empty where it has none; `response` is the class of the response, empty for
    responses.
    """

    record: RecordView
    code: str
    number: str
    supplements: str
    response: str
    frames: list[ExchangeView]


def device_view(layout: DeviceLayout) -> dict[str, Any]:
    """The data of the template of a version's module, without its imports."""
    device, scope = layout.device, module_scope()
    enums = {name: enum_view(enum, scope) for name, enum in device.enums.items()}
    flags = {name: flags_view(word, device, enums, scope) for name, word in device.flags.items()}
    names = {name: _class(name, "Record", scope) for name in layout.records}
    words = Words(enums, {name: view.name for name, view in flags.items()}, names, layout.registers, device)
    records = [_record(layout, name, words) for name in layout.records]
    exchanges = [_exchange(message, words, scope) for message in layout.messages.values()]
    carrying = [
        link for link in layout.links.values() if any(carries(link, exchange.message) for exchange in exchanges)
    ]
    links = [link_view(link, exchanges, layout.records, words, scope) for link in carrying]
    messages = [view for exchange in exchanges for view in _messages(exchange, links, layout)]
    order = device.byte_order
    accesses = register_accesses(device, carrying, exchanges)
    register_links = list(dict.fromkeys(name for access in accesses for name in access.links))

    def space(name: str) -> str:
        return device.space_name(name) if device.several_spaces else ""

    sets = [
        parameter_set_view(parameter_set, layout, words, exchanges, scope)
        for parameter_set in device.parameters.values()
    ]
    conversions = [conversion_view(conversion, device, scope) for conversion in device.conversions.values()]
    registers, stated = register_views(layout, words, scope, space)
    constants = {row.name: own.name for row, own in zip(layout.registers, registers, strict=True)}
    view: dict[str, Any] = {
        "doc": docstring(_doc(layout)),
        "identity": layout.identity,
        "device": literal(device.id),
        "version": literal(device.version),
        "enums": list(enums.values()),
        "flags": list(flags.values()),
        "records": records,
        "exchanges": exchanges,
        "messages": messages,
        "links": links,
        "conversions": conversions,
        "registers": registers,
        "stated_registers": stated,
        "tables": [
            table_view(table_layout, words, order, scope, constants, space(table_layout.table.space))
            for table_layout in layout.tables.values()
        ],
        "accesses": accesses,
        "spaces_of_words": list(dict.fromkeys(access.space for access in accesses if access.space)),
        "register_links": register_links,
        "link_type": f"_Literal[{', '.join(map(literal, register_links))}] = {literal(register_links[0])}"
        if register_links
        else "",
        "read": next((access.read for access in accesses if access.read), None),
        "single": next((access.single for access in accesses if access.single), None),
        "block": next((access.block for access in accesses if access.block), None),
        "read_requests": union(access.read.request for access in accesses if access.read),
        "read_responses": union(access.read.response for access in accesses if access.read),
        "write_requests": union(
            access.request
            for access in (*(access.single for access in accesses), *(access.block for access in accesses))
            if access is not None
        ),
        "parameters": sets,
        "spaces": space_views(layout, sets, words, exchanges, scope),
        "words": words,
        "links_by_name": dict(zip((link.name for link in carrying), links, strict=True)),
    }
    public = ["DEVICE", "IDENTITY", "REGISTERS", "TABLES", "VERSION"]
    public += ["read_request", "read_requests", "read_value"] * (view["read"] is not None)
    public += ["write_request", "write_requests"] * bool(view["write_requests"])
    public += ["register_at"] * bool(view["registers"] or view["tables"])
    return {**view, "names": [*public, *scope.names]}


def union(names: Iterable[str]) -> str:
    """The union type of some classes."""
    return " | ".join(dict.fromkeys(names))


def _class(name: str, kind: str, scope: Scope) -> str:
    pascal = Name.of(name).pascal()
    return scope.take(pascal, pascal + kind)


def _record(layout: DeviceLayout, name: str, words: Words) -> RecordView:
    shaped = shape(layout.records[name], words, RECORD)
    doc = record_doc(shaped.record, shaped.in_sent_order, Name.of(name).title())
    return _viewed(shaped, words.records[name], doc)


def _viewed(shaped: RecordShape, name: str, doc: list[str]) -> RecordView:
    return replace(record_view(shaped, name, doc), columns=tuple(column_lines(shaped)))


def _exchange(message: MessageLayout, words: Words, scope: Scope) -> Exchange:
    return Exchange(
        message,
        shape(message.request, words, MESSAGE),
        shape(message.response, words, MESSAGE),
        _class(message.request.name, "Message", scope) if message.message.is_requested else "",
        _class(message.response.name, "Message", scope) if message.message.is_answered else "",
    )


def _messages(exchange: Exchange, links: list[LinkView], layout: DeviceLayout) -> list[MessageView]:
    """The response comes first, because the class of the request refers to it."""
    message = exchange.message.message
    title = message.title or Name.of(message.name).title()
    group = f"Group {Name.of(message.group).title().lower()}." if message.group else ""
    carrying = [link.link for link in layout.links.values() if message.name in link.messages]
    called = {link.message_name for link in carrying}
    known = Name.of(called.pop() if len(called) == 1 else "message").title()
    number = "" if message.number is None else f"{known} {message.number}."
    companions = f"It is sent beside {' or '.join(message.supplements)}." if message.supplements else ""
    views = []
    silent = [link.name for link in carrying if not message.is_answered_on(link.name)]
    quiet = f"It is not answered on {', '.join(silent)}." if silent else ""
    quiet = quiet if message.is_answered else "It is never answered."
    quiet = quiet if message.is_requested else "Only the device sends it, of its own accord."
    for direction in reversed(message.directions):
        number_of_code = message.printed_code(direction)
        code = "" if number_of_code is None else f"Code {number_of_code:#04x}."
        if direction == "request" and message.remote is not None:
            code += f" It is a remote request with the DLC {message.remote}."
        shaped, name = exchange.side(direction)
        names = {link.direction_name(direction) for link in carrying} - {direction}
        direction_text = f"the {direction} ({', '.join(sorted(names))})" if names else f"the {direction}"
        remarks = " ".join(text for text in (code, number, group, companions, quiet, sentence(message.doc)) if text)
        doc = record_doc(shaped.record, shaped.in_sent_order, f"{title}: {direction_text}", remarks)
        directions = [link.request if direction == "request" else link.response for link in links]
        frames = [view for side in directions if side for view in side.exchanges if view.message == name]
        views.append(
            MessageView(
                record=_viewed(shaped, name, doc),
                code=code_literal(message.code_of(direction)),
                number="" if message.number is None else str(message.number),
                supplements=tuple_of(map(literal, message.supplements)) if message.supplements else "",
                response=exchange.response_name if direction == "request" else "",
                frames=frames,
            )
        )
    return views


def _doc(layout: DeviceLayout) -> list[str]:
    device = layout.device
    title = sentence(f"{device.vendor} {device.name}, version {device.version}")
    manual = f"Manual: {device.manual.title}" + (f", {device.manual.edition}" if device.manual.edition else "")
    known = next((v for line in device.lines for v in line.versions if v.id == device.version), None)
    version_doc = sentence(known.doc or known.inferred) if known else ""
    return [
        title,
        sentence(device.title),
        sentence(device.doc),
        version_doc,
        sentence(manual),
        f"Generated by fieldspec from the spec of {device.id}; do not edit. Identity {layout.identity}.",
    ]
