"""Blocks that carry the accesses to registers of one device as frames of a link, with a repetition where it is safe."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.language.model.record import RegisterAccess
from fieldspec.targets.controllers.routines.answers import judged
from fieldspec.targets.controllers.routines.blocks.frames import Exchange, exchange_of
from fieldspec.targets.controllers.routines.blocks.kinds import handshake_slots
from fieldspec.targets.controllers.routines.blocks.ports import AXIS, FRAMES, member, port_members
from fieldspec.targets.controllers.routines.exchanges import ERRORS, meanings
from fieldspec.targets.controllers.routines.named_numbers import named
from fieldspec.targets.controllers.routines.parameters import FRAME, parameters_of
from fieldspec.targets.controllers.routines.records import is_user_field
from fieldspec.targets.controllers.routines.world import World
from fieldspec.targets.controllers.routines.wrapping import link_words
from fieldspec.targets.controllers.sources.expansion import Expansion, source
from fieldspec.targets.controllers.statements.expressions import INT, Elementary, Expression, StructType, Type
from fieldspec.targets.controllers.statements.interfaces import BlockVariables
from fieldspec.targets.controllers.statements.routine import Routine


def client_block(world: World, link: LinkLayout, by_name: Mapping[str, Routine]) -> Routine | None:
    """The block that serves the port of a device by a link; None where the link does not read and write registers."""
    reading: Exchange | None = None
    single: Exchange | None = None
    multiple: Exchange | None = None
    device = world.layout.device
    for message in link.exchanged.values():
        access = device.word_access(message.message)
        if access is None or device.space_name(access.space) != device.space_name(""):
            continue
        exchange = exchange_of(world, link, message, by_name)
        if not _usable(world, exchange, access):
            continue
        if access.operation == "read":
            reading = reading or (exchange if access.count else None)
        elif access.count:
            multiple = multiple or exchange
        else:
            single = single or exchange
    if reading is None or (single is None and multiple is None):
        return None
    return _block(world, link, {"reading": reading, "single": single, "several": multiple})


def _usable(world: World, exchange: Exchange, access: RegisterAccess) -> bool:
    """Whether the only fields of a request are the station, the address, the number and the words."""
    fields = {field.name for field in exchange.message.request.fields if is_user_field(field)}
    return fields <= {access.start, access.count, access.values}


def _block(world: World, link: LinkLayout, exchanges: Mapping[str, Exchange | None]) -> Routine:
    """The slots of `client.st`."""
    slots = {
        **handshake_slots(world),
        **{name: StructType(world.names.structs[key]) for name, key in (("AxisType", AXIS), ("FramesType", FRAMES))},
        "Words": world.words,
        "room": named(world.words.high + 1, INT, "most", "words"),
        "has": {name: exchanges[name] is not None for name in ("single", "several")},
        "link": link.name,
        "errors": meanings(world, ERRORS),
    }
    expansion = Expansion(source("client"), BlockVariables(), slots, port_members(world))
    for name, exchange in exchanges.items():
        if exchange is not None:
            expansion.scope[name] = _access(world, expansion, exchange)
    return expansion.routine(world.block(*link_words(world, link), "client"), f"messages of {link.name}")


def _access(world: World, expansion: Expansion, exchange: Exchange) -> dict[str, Any]:
    """What `client.st` knows of a message: its functions, their arguments, and what has to be the same."""
    request_values, response_values = _arguments(world, expansion, exchange), dict[str, Expression]()
    for declared in (*exchange.parse.of_role("output"), *exchange.parse.of_role("in_out")):
        variable = declared.variable
        if variable.type == world.words:
            response_values[variable.name] = expansion.scope["aWordsAnswered"]
        elif variable.name != FRAME:
            response_values[variable.name] = expansion.variables.local(f"{variable.name}Answered", variable.type)
    status = expansion.scope["Diagnostics"]
    judgement = judged(
        world, exchange.link, exchange.message, status, request_values, response_values, expansion.variables
    )
    return {
        "build": exchange.build,
        "parse": exchange.parse,
        "asked": request_values,
        "answered": response_values,
        **judgement,
    }


def _arguments(world: World, expansion: Expansion, exchange: Exchange) -> dict[str, Expression]:
    """The arguments of the function that builds a request."""
    access = exchange.message.message.single_access
    assert access is not None
    words, count, address = (
        member(world, AXIS, name, expansion.scope["Axis"]) for name in ("words", "count", "address")
    )
    asks, _ = parameters_of(world, exchange.link, exchange.message)
    arguments: dict[str, Expression] = {}
    remarks = {declared.variable.name: declared.remark for declared in exchange.build.declared}
    for variable in asks.head.values():
        name, remark = variable.name, remarks[variable.name]
        arguments[name] = expansion.variables.declared_once(name, variable.type, "input", remark)
    by_name = {access.start: address, access.count: count}
    for field, variable in asks.fields.variables.items():
        if field != access.values:
            arguments[variable.name] = _converted(by_name[field], variable.type)
        elif variable.type == world.words:
            arguments[variable.name] = words
        else:
            arguments[variable.name] = _converted(words.element(0), variable.type)
    if asks.fields.count is not None:
        arguments[asks.fields.count.name] = count
    return arguments


def _converted(value: Expression, kind: Type) -> Expression:
    assert isinstance(kind, Elementary)
    return value.converted(kind)


def client_blocks(world: World, by_name: Mapping[str, Routine], links: Sequence[LinkLayout]) -> Iterator[Routine]:
    """The blocks of all links that read and write registers."""
    for link in links:
        block = client_block(world, link, by_name)
        if block is not None:
            yield block
