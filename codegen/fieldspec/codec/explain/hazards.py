"""Warnings before a request is sent: whether it only reads, and the side effects of a write."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.frame import LinkLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.nested_fields import nested_fields
from fieldspec.codec.layout.record import FieldLayout
from fieldspec.language.model.device import Device
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Field
from fieldspec.language.model.registers import Parameter, Register
from fieldspec.language.model.value import Handling, Value

CLEARS = "reading it clears it"
_STARTS = "writing it starts something"
_GOES_ON = "it decides whether a move may go on"
_ENERGIZES = "it energizes the motor, or releases what the motor holds"
_STORED = "it is stored permanently"

COMMANDING = {
    **dict.fromkeys(("command", "homing_start", "move_start", "jog_positive", "jog_negative"), _STARTS),
    **dict.fromkeys(("jog_start", "point_start"), _STARTS),
    **dict.fromkeys(("move_enable", "pause_released"), _GOES_ON),
    **dict.fromkeys(("servo_enable", "switch_on", "coast_stop_released", "quick_stop_released"), _ENERGIZES),
    "control_request": _ENERGIZES,
    "alarm_reset": "it resets the alarm, after which the device may go on",
    **dict.fromkeys(("save", "save_points"), _STORED),
    "restart": "it restarts the device",
}
"""What writing a fact with a role does. A stop is not among them: it must not wait for an answer."""


def roles_of(device: Device, fact: Fact, value: Value | None) -> Iterator[str]:
    """The roles of a fact, of the signal that a field places, and of the bits of its value."""
    yield from fact.roles
    if isinstance(fact, Field) and fact.signal:
        yield from device.signals[fact.signal].roles
    for bit in device.flags[value.flags].bits if value is not None and value.flags else ():
        yield from bit.roles


def write_hazards(
    *, trigger: bool, access: str, restart: bool | None, handlings: Iterable[Handling], roles: Iterable[str]
) -> Iterator[str]:
    """The hazards of writing a value. The first of `handlings` that states something counts, the own one first."""
    hazards = _hazards_of(trigger, access, restart, list(handlings), list(roles))
    yield from dict.fromkeys(hazards)


def _hazards_of(
    trigger: bool, access: str, restart: bool | None, known: Sequence[Handling], roles: Sequence[str]
) -> Iterator[str]:
    if trigger:
        yield _STARTS
    yield from (COMMANDING[role] for role in roles if role in COMMANDING)
    if access == "":
        yield "the manual does not say that it can be written"
    if restart:
        yield "it takes effect after a restart"
    if next((handling.memory for handling in known if handling.memory), "") == "nonvolatile":
        yield _STORED
    endurance = next((handling.endurance for handling in known if handling.endurance), "")
    if endurance not in ("", "unlimited"):
        yield f"its memory endures {'a limited number of' if endurance == 'limited' else endurance} writes"


def is_bare(link: LinkLayout) -> bool:
    """Whether nothing stands around the data of requests, as in a cyclic exchange."""
    shape = link.request
    return not (shape.header or shape.trailer or shape.is_marked)


def only_reads(layout: DeviceLayout, link: LinkLayout, message: MessageLayout) -> bool:
    """Whether a message only reads, as far as the spec says: registers, a parameter, or values without an argument."""
    if is_bare(link):
        return False  # a cyclic exchange does not only read
    access = message.message.single_access
    if access is not None:
        return access.operation == "read"
    if message.message.access_steps:
        return all(step.operation == "read" for step in message.message.access_steps)
    if message.name not in link.carried("response"):
        return False
    parts = {_parameter_part(field) for field in message.request.fields} - {""}
    if parts:
        return "number" in parts and not parts & {"value", "values"}
    return is_query(message)


def _parameter_part(field: FieldLayout) -> str:
    values = (field.value, *(case.value for case in field.cases))
    return next((value.parameter.part for value in values if value is not None and value.parameter is not None), "")


def is_query(message: MessageLayout) -> bool:
    """Whether a message only asks: without arguments, and with an answer that has values."""
    has_arguments = any(is_argument(field) for field in message.request.fields)
    return (
        message.message.is_requested
        and not has_arguments
        and any(is_single(field) for field in message.response.fields)
    )


def reads_state(layout: DeviceLayout, message: MessageLayout) -> bool:
    """Whether the spec shows that a message only reads, without any effect.

    It is a query without a role of its own, such as a stop has, and one of its values has the role of a state, such as
    `actual_position`. A query without all of that may as well begin something and answer with how long it takes.
    """
    fields = message.response.fields
    if not is_query(message) or message.message.roles or any(field.field.handling.clears_on_read for field in fields):
        return False
    words = [layout.device.flags[field.value.flags] for field in fields if field.value and field.value.flags]
    facts = [*(field.field for field in fields), *(bit for word in words for bit in word.bits)]
    return any(fact.roles for fact in facts)


def is_argument(field: FieldLayout) -> bool:
    """Whether a field of a request has a value that somebody chooses."""
    constant = field.value is not None and field.value.const is not None
    return not (field.field.reserved or field.field.measures or constant)


def is_single(field: FieldLayout) -> bool:
    """Whether a field has one value that says something."""
    return field.value is not None and not field.is_list and is_argument(field)


def hazards_by_fact(layout: DeviceLayout) -> dict[str, dict[str, list[str]]]:
    """By `read` and `write`, then by the text of a hazard: the paths of the facts that have it."""
    result: dict[str, dict[str, list[str]]] = {"read": {}, "write": {}}
    for fact, operation, text in _hazards(layout):
        paths = result[operation].setdefault(text, [])
        if fact.place.path not in paths:
            paths.append(fact.place.path)
    return result


def _hazards(layout: DeviceLayout) -> Iterator[tuple[Fact, str, str]]:
    for message in layout.messages.values():
        own = message.message
        fields = ((field.field, field.value) for field in message.request.fields)
        roles = [*own.roles, *(role for fact in fields for role in roles_of(layout.device, *fact))]
        hazards = write_hazards(trigger=False, access="rw", restart=False, handlings=(own.handling,), roles=roles)
        yield from ((own, "write", text) for text in hazards)
        if any(field.field.handling.clears_on_read for field in message.response.fields):
            yield own, "read", CLEARS
    for register in layout.registers:
        yield from _of_value(layout.device, register.register)
    for table in layout.tables.values():
        yield from _of_table(layout.device, table)
    for parameter_set in layout.device.parameters.values():
        for parameter in parameter_set.parameters:
            yield from _of_value(layout.device, parameter)


def _of_table(device: Device, table: TableLayout) -> Iterator[tuple[Fact, str, str]]:
    visited: set[tuple[int, ...]] = set()
    for nested in nested_fields(table.record):
        own, holders = nested.field.field, [holder.field for holder in reversed(nested.holders)]
        facts = tuple(map(id, (own, *holders)))
        access = nested.access(table.table.access)
        if facts in visited:
            continue
        visited.add(facts)
        if own.handling.clears_on_read or any(holder.handling.clears_on_read for holder in holders):
            yield own, "read", CLEARS
        if access != "ro":
            handlings = (own.handling, *(holder.handling for holder in holders), table.table.handling)
            roles = roles_of(device, own, nested.field.value)
            hazards = write_hazards(
                trigger=False, access=access, restart=nested.restart, handlings=handlings, roles=roles
            )
            yield from ((own, "write", text) for text in hazards)


def _of_value(device: Device, fact: Register | Parameter) -> Iterator[tuple[Fact, str, str]]:
    if fact.handling.clears_on_read:
        yield fact, "read", CLEARS
    if fact.access != "ro":
        hazards = write_hazards(
            trigger=fact.trigger,
            access=fact.access,
            restart=fact.restart,
            handlings=(fact.handling,),
            roles=roles_of(device, fact, fact.value),
        )
        yield from ((fact, "write", text) for text in hazards)
