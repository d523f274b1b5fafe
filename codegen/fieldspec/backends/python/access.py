"""The messages that read and write registers, as the classes and attributes to call them with."""

from __future__ import annotations

from fieldspec.backends.python.links import Exchange
from fieldspec.backends.python.records import RecordShape
from fieldspec.backends.python.slots import Slots
from fieldspec.classes import dataclass
from fieldspec.model.address_space import WORD
from fieldspec.model.device import Device


@dataclass(frozen=True, slots=True)
class AccessView:
    """A message that reads or writes `most` words: its classes, and how a request is made and a response read."""

    request: str
    response: str
    most: int
    make: str
    values: str
    single: bool


@dataclass(frozen=True, slots=True)
class SpaceAccess:
    """The messages that read and write the registers of an address space; empty name: the device has only one space."""

    space: str
    read: AccessView | None
    single: AccessView | None
    block: AccessView | None


def space_accesses(device: Device, exchanges: list[Exchange]) -> list[SpaceAccess]:
    """The messages that access each space of words, in the order of the spec."""
    names = [name for name, space in device.spaces.items() if space.unit == WORD] if device.several_spaces else [""]
    found = []
    for name in names:
        own = [
            one
            for one in exchanges
            if (access := device.register_access(one.message.message)) is not None
            and (not name or device.space_name(access.space) == name)
        ]
        found.append(SpaceAccess(name, read_access(own), *write_accesses(own)))
    return found


def _field(shaped: RecordShape, title: str) -> Slots | None:
    return next((field for field in shaped.fields if field.title == title), None)


def _most(*fields: Slots | None) -> int:
    """The most words that some fields allow."""
    bounds = []
    for field in fields:
        if field is not None and field.repeated and field.field.field.repeat is not None:
            bounds.append(field.field.field.repeat.high)
        elif field is not None and field.ranges is not None:
            bounds.append(field.ranges.high)
    return min(bounds, default=1)


def read_access(exchanges: list[Exchange]) -> AccessView | None:
    """The first message that reads registers."""
    for one in exchanges:
        access = one.message.message.accesses
        if access is None or access.operation != "read":
            continue
        start, count = _field(one.request, access.start), _field(one.request, access.count)
        values = _field(one.response, access.values)
        if start is None or values is None or not _settable(one.request, {access.start, access.count}):
            continue
        counted = f", {count.name}=count" if count is not None and count.stored else ""
        held = f"response.{values.name}"
        return AccessView(
            request=one.request_name,
            response=one.response_name,
            most=_most(values, count) if values.listed else 1,
            make=f"{one.request_name}({start.name}=start{counted})",
            values=held if values.listed else f"[{held}]",
            single=not values.listed,
        )
    return None


def write_accesses(exchanges: list[Exchange]) -> tuple[AccessView | None, AccessView | None]:
    """The first message that writes one register, and the first one that writes several."""
    single: AccessView | None = None
    block: AccessView | None = None
    for one in exchanges:
        access = one.message.message.accesses
        if access is None or access.operation != "write":
            continue
        start, count = _field(one.request, access.start), _field(one.request, access.count)
        values = _field(one.request, access.values)
        if start is None or values is None:
            continue
        if not _settable(one.request, {access.start, access.count, access.values}):
            continue
        counted = f", {count.name}=count" if count is not None and count.stored else ""
        if values.listed:
            make = f"{one.request_name}({start.name}=start{counted}, {values.name}=words[at : at + count])"
            most = _most(values, count)
            block = block or AccessView(one.request_name, one.response_name, most, make, "", False)
        else:
            make = f"{one.request_name}({start.name}=start, {values.name}=words[at])"
            single = single or AccessView(one.request_name, one.response_name, 1, make, "", True)
    return single, block


def _settable(shaped: RecordShape, titles: set[str]) -> bool:
    """Whether these fields are all that must be given."""
    return all(field.title in titles for field in shaped.stored)
