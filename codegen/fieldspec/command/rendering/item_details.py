"""The details of an item as keys with texts. Callers leave out keys without a text."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.explain.percentages import references_text
from fieldspec.codec.explain.recognition import lengths
from fieldspec.codec.layout.device import DeviceLayout, TableLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.nested_fields import nested_fields
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.command.rendering.item import (
    CodeRow,
    Details,
    Item,
    ParameterNumber,
    WordState,
    erratum_details,
    example_details,
    note_details,
)
from fieldspec.command.rendering.overview import value_details
from fieldspec.foundation.classes import replace
from fieldspec.language.model.address_space import BIT, AddressSpace
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.link import Link
from fieldspec.language.model.registers import ParameterSet, Register
from fieldspec.language.model.task import Task, step_text
from fieldspec.language.model.texts import Erratum, Example, Limit, Note
from fieldspec.language.model.value import Conversion, Signal

_RESTART = {True: "needed", False: "not needed", None: ""}
_DIRECTIONS = ("request", "response")


def details(layout: DeviceLayout, item: Item, number: int | None) -> Details:
    """The details of an item, without those that every fact has; `number` is the one that a user asked for."""
    match item:
        case Register():
            yield from _register(layout, item, number)
        case TableLayout():
            yield from _table(layout, item, number)
        case MessageLayout():
            yield from _message(layout, item)
        case RecordLayout() if item.size is not None:
            yield "size", f"{item.size} bytes"
        case Signal():
            yield from _signal(layout, item)
        case Conversion():
            yield from _conversion(layout, item)
        case ParameterNumber():
            yield from _parameter(item, number)
        case ParameterSet():
            yield from _set_details(item)
        case Enum():
            yield "what", item.title
            yield "follows", f"from {item.derived}" if item.derived else ""
        case CodeRow():
            yield from _code(item)
        case WordState():
            yield "shown by", item.flags.name
            yield "set", ", ".join(item.state.set)
            yield "clear", ", ".join(item.state.clear)
        case Link():
            yield from _link(layout, item)
        case AddressSpace():
            yield "unit", item.unit
            yield "bounds", ", ".join(f"0x{low:04X}..0x{high:04X}" for low, high in item.bounds.intervals)
            yield "first number", str(item.first_number)
        case Task():
            yield "task", item.kind
            yield "open question", item.open
            yield "not applicable", item.not_applicable
            yield "with", ", ".join(item.messages)
            for number_of_step, step in enumerate(item.steps, 1):
                yield f"step {number_of_step}", step_text(step)
        case Limit():
            bounds = [str(bound) for bound in (item.low, item.high) if bound is not None]
            count = str(item.value) if item.value is not None else "..".join(bounds)
            yield "value", f"{count or item.text} {item.unit}".strip()
        case Note():
            yield from note_details(item)
        case Example():
            yield from example_details(item)
        case Erratum():
            yield from erratum_details(item)


def _register(layout: DeviceLayout, register: Register, address: int | None) -> Details:
    count_text = f", {register.count} of them, {register.stride} apart" if register.count > 1 else ""
    unit = layout.device.space(register.space).unit
    words = f"1 {unit}" if register.width == 1 or unit == BIT else f"{register.width} {unit}s"
    yield "space", _space(layout.device, register.space)
    number = layout.device.space(register.space).first_number + register.address
    yield "address", f"0x{register.address:04X} ({number}), {words}{count_text}"
    if register.count > 1 and address is not None and register.address <= address < register.end:
        index = register.index_from + (address - register.address) // register.stride
        yield "here", f"0x{address:04X} is {register.name}[{index}]"
    yield "number", "" if register.number is None else str(register.number)
    yield "access", register.access or "not printed"
    yield from value_details(register.value)
    yield "restart", _RESTART[register.restart]
    yield "trigger", "writing it starts an action; reading returns 0" if register.trigger else ""
    yield "atomic", "its words are read in one request" if register.atomic else ""
    yield "reserved", "it has no meaning for the user" if register.reserved else ""
    yield "same as", register.same_as
    yield "copy of", _register_text(layout, register.copy_of)
    for other in layout.device.registers():
        if other.copy_of == register.name:
            yield "copied in", _register_text(layout, other.name)


def _space(device: Device, name: str) -> str:
    """The name of an address space; empty where the device has only one."""
    return device.space_name(name) if device.several_spaces else ""


def _register_text(layout: DeviceLayout, name: str) -> str:
    """A register with its address."""
    register = layout.device.register(name) if name else None
    return f"{name} at 0x{register.address:04X}" if register is not None else name


def _table(layout: DeviceLayout, table_layout: TableLayout, address: int | None) -> Details:
    table = table_layout.table
    yield "space", _space(layout.device, table.space)
    base = table.base_by or f"0x{table.base:04X}"
    formula = f"{base} + 0x{table.stride:X} * (n - {table.index_from})"
    yield "address", f"{formula}, n = {table.index_from}..{table.indexes[-1]}"
    yield "begins", f"where {table.base_by} says, usually at 0x{table.base:04X}" if table.base_by else ""
    yield "how many", f"as {table.count_by} says" if table.count_by else ""
    yield "access", table.access or "not printed"
    if address is not None:
        steps, offset = divmod(address - table.base, table.stride)
        names = [own.path for own in nested_fields(table_layout.record) if own.offset <= 2 * offset + 1]
        is_in = "is usually in" if table.base_by else "is in"
        yield "here", f"0x{address:04X} {is_in} {table.name}[{table.index_from + steps}].{names[-1]}"


def _message(layout: DeviceLayout, message_layout: MessageLayout) -> Details:
    message = message_layout.message
    yield "what", message.title
    yield "code", "" if message.code is None else f"0x{message.code:02X}"
    yield "request", "" if message.remote is None else f"a remote request with the DLC {message.remote}"
    yield "response code", "" if message.response_code is None else f"0x{message.response_code:02X}"
    yield "number", "" if message.number is None else str(message.number)
    yield "beside", " or ".join(message.supplements)
    yield "sent", "" if message.is_requested else "only by the device"
    if message.answered_on is not None:
        yield "answered", f"on {', '.join(message.answered_on)}" if message.answered_on else "never"
    for link in layout.links.values():
        if message_layout.name in link.messages and len(layout.links) > 1 and message.links:
            yield "sent on", link.name
        if message_layout.name in link.messages and message.code is None:
            ways = [direction for direction in _DIRECTIONS if message_layout.name in link.carried(direction)]
            sizes = ((direction, lengths(link, direction, message_layout.name)) for direction in ways)
            yield (
                "bytes",
                ", ".join(f"{link.link.direction_name(direction)} {_bounds(*size)}" for direction, size in sizes),
            )


def _bounds(minimum: int, maximum: int | None) -> str:
    if maximum is None:
        return f"{minimum} or more"
    return str(minimum) if maximum == minimum else f"{minimum}..{maximum}"


def _signal(layout: DeviceLayout, signal: Signal) -> Details:
    yield "goes", {"request": "to the device", "response": "from the device"}.get(signal.direction, "")
    yield from value_details(signal.value)
    for message in layout.messages.values():
        for direction in _DIRECTIONS:
            for field in message.data(direction).fields:
                if field.field.signal == signal.name:
                    link = next(
                        (
                            link_layout.link
                            for link_layout in layout.links.values()
                            if message.name in link_layout.messages
                        ),
                        None,
                    )
                    direction_name = link.direction_name(direction) if link else direction
                    place_text = f", byte {field.offset}" if message.data(direction).has_place(field) else ""
                    yield "lies in", f"{message.name} {direction_name}{place_text}{_words(field.field.word_span)}"
    for conversion in layout.device.conversions.values():
        if signal.name in conversion.signals:
            yield "share of", f"{references_text(layout.device, conversion)}: {conversion.name}"


def _words(span: tuple[int, int] | None) -> str:
    if span is None:
        return ""
    first, last = span
    return f", word {first}" if first == last else f", words {first} and {last}" if last == first + 1 else ""


def _conversion(layout: DeviceLayout, conversion: Conversion) -> Details:
    yield "what", conversion.title
    share = f"raw / 0x{conversion.full_scale:X}"
    yield "quantity", f"reference * {f'(1 - {share})' if conversion.complement else share}"
    yield "reference", references_text(layout.device, conversion) if conversion.references else "not said"
    yield "raw", f"{conversion.type.name}{' of ' if conversion.signals else ''}{', '.join(conversion.signals)}"
    yield "printed", conversion.printed


def _parameter(item: ParameterNumber, number: int | None) -> Details:
    parameter_set, parameter = item.parameter_set, item.parameter
    yield "set", parameter_set.name
    yield "number", _parameter_number_text(parameter_set, item.number)
    if parameter is None:
        yield "row", "none: the manual states no meaning of the number itself"
        return
    if parameter.count > 1:
        last = _parameter_number_text(parameter_set, parameter.number + parameter.count - 1)
        yield (
            "count",
            f"{parameter.count} of them, {_parameter_number_text(parameter_set, parameter.number)}, to {last}",
        )
        own = [
            candidate
            for candidate in (number, (number or 0) - parameter_set.base)
            if candidate is not None and candidate != item.number
        ]
        selected = next((candidate for candidate in own if parameter_set.numbered(candidate) is parameter), None)
        yield "here", "" if selected is None else _parameter_number_text(parameter_set, selected)
    yield "access", parameter.access or "not printed"
    value = parameter.value
    yield from value_details(value if parameter.elements is None else replace(value, default=None))
    yield "elements", "" if parameter.elements is None else str(parameter.elements)
    if parameter.elements is not None and value.default is not None:
        yield "default", str(value.default)
    yield "names", value.enum or value.flags
    yield "restart", _RESTART[parameter.restart]
    yield "trigger", "writing it starts an action; reading does not return the value" if parameter.trigger else ""
    yield "for", ", ".join(parameter.applies_to)
    yield "used by", ", ".join(parameter.messages)
    yield "reserved", "it has no meaning for the user" if parameter.reserved else ""


def _parameter_number_text(parameter_set: ParameterSet, number: int) -> str:
    """`Pt317, 0x2317 on the wire`"""
    if not parameter_set.base:
        return parameter_set.number_text(number)
    own = parameter_set.number_text(number) if parameter_set.printed_as else f"{number}"
    return f"{own}, 0x{parameter_set.base + number:04X} ({parameter_set.base + number}) on the wire"


def _set_details(parameter_set: ParameterSet) -> Details:
    yield "what", parameter_set.title
    yield "base", f"a number on the wire is the number + 0x{parameter_set.base:04X}" if parameter_set.base else ""
    form, base = parameter_set.number_text, parameter_set.base
    for low, high in parameter_set.numbers.intervals if parameter_set.numbers is not None else ():
        yield "numbers", f"{form(low)} to {form(high)}, 0x{base + low:04X} to 0x{base + high:04X} on the wire"
    yield "space", parameter_set.space if parameter_set.space != parameter_set.name else ""


def _code(item: CodeRow) -> Details:
    member = item.member
    yield "value", f"{member.value} (0x{member.value:X})" if item.enum.printed_as else str(member.value)
    yield "aliases", ", ".join(member.aliases)
    yield "number", "" if member.number is None else str(member.number)
    yield "of", item.enum.title or item.enum.name
    yield "problem", member.problem
    for cause in member.causes:
        yield "cause", cause.cause + "".join(f" -> {remedy}" for remedy in cause.remedies)
    for remedy in member.remedies:
        yield "remedy", remedy


def _link(layout: DeviceLayout, link: Link) -> Details:
    yield "what", link.title
    yield "transmission", link.transmission
    yield "preamble", link.preamble.text() if link.preamble is not None else ""
    for direction in ("request",) if link.has_common_delimiters else ("request", "response"):
        name = "marks" if link.has_common_delimiters else f"{direction} marks"
        yield name, " .. ".join(mark.hex(" ").upper() for mark in link.marks(direction) if mark)
    orders = (("bytes", link.byte_order), ("words", link.word_order))
    yield "order", ", ".join(f"{unit_name} {order}" for unit_name, order in orders if order)
    yield "sends", _sends(layout, link)


def _sends(layout: DeviceLayout, link: Link) -> str:
    """The names of its messages, and the words of the link for messages and directions, where it has its own."""
    word = "" if link.message_name == "message" else f"{link.message_name}: "
    names = ", ".join(_names(layout, link))
    ways = [link.direction_name(direction) for direction in _DIRECTIONS]
    spoken = "" if tuple(ways) == _DIRECTIONS else f"; {ways[0]} goes to the device, {ways[1]} comes from it"
    return f"{word}{names}{spoken}" if word or spoken else ""


def _names(layout: DeviceLayout, link: Link) -> Iterator[str]:
    for message in layout.links[link.name].messages.values():
        yield message.name if message.message.number is None else str(message.message.number)
