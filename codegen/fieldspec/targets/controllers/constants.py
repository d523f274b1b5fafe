"""Constants: addresses, numbers of parameters, codes of messages, masks of bits, limits, ranges, numbers of members."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.registers import Parameter, ParameterSet
from fieldspec.language.model.value import Signal
from fieldspec.targets.controllers.enums import available
from fieldspec.targets.controllers.routines.quantities import every_value
from fieldspec.targets.controllers.routines.remarks import cited, count_of, member_remark, printed
from fieldspec.targets.controllers.routines.world import narrowest
from fieldspec.targets.controllers.statements.expressions import BITS, LREAL, REAL, UINT, Elementary
from fieldspec.targets.controllers.statements.numbers import is_single, whole_type


@dataclass(frozen=True, slots=True)
class Constant:
    """A named number; `hexadecimal` says that the manual writes it so."""

    name: str
    type: Elementary
    value: int | Decimal
    remark: str
    fact: Fact | None
    hexadecimal: bool = False


@dataclass(frozen=True, slots=True)
class ConstantList:
    """Constants of one kind, by the name of their list. `key` is a key of `LISTS`."""

    name: str
    key: str
    title: str
    constants: tuple[Constant, ...]


@dataclass(frozen=True, slots=True)
class Draft:
    """A constant before it has a name in a dialect. A `derived` name gives way where it is taken; `fact` is None for
    a number of our own."""

    name: str
    type: Elementary
    value: int | Decimal
    remark: str
    fact: Fact | None
    hexadecimal: bool = False
    derived: bool = False


# What makes the constants of one kind; the enums that are types have no constants of their own.
_Make = Callable[[DeviceLayout, frozenset[str]], Iterator[Draft]]


def _addresses(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for register in layout.registers:
        if register.register.reserved:
            continue
        space = _space(layout, register.register.space)
        remark = f"{printed(register.register)} {register.register.access} {space}".strip()
        yield Draft(
            register.name,
            UINT,
            register.address,
            cited(remark, register.register),
            register.register,
            hexadecimal=True,
        )
        if register.count > 1:
            for word, number in (("count", register.count), ("stride", register.stride)):
                yield Draft(f"{register.name}_{word}", UINT, number, _OF_SEVERAL[word], register.register, derived=True)
    for table in layout.tables.values():
        table_model = table.table
        remark = f"{table_model.title} {_space(layout, table_model.space)}".strip()
        yield Draft(
            f"{table_model.name}_base",
            UINT,
            table_model.base,
            cited(remark, table_model),
            table_model,
            hexadecimal=True,
        )
        for word, number in (
            ("stride", table_model.stride),
            ("count", table_model.count),
            ("first_index", table_model.index_from),
        ):
            remark = _OF_SEVERAL[word]
            if word == "count" and table_model.count_by:
                remark = f"at most; {table_model.count_by} has how many there are"
            yield Draft(f"{table_model.name}_{word}", UINT, number, remark, table_model, derived=True)


def _space(layout: DeviceLayout, name: str) -> str:
    """The space of registers as a comment names it: `in input_registers`; empty where the device has only one."""
    device = layout.device
    return f"in {device.space_name(name)}" if device.several_spaces else ""


_OF_SEVERAL = {
    "count": "how many there are",
    "stride": "words from one to the next",
    "first_index": "number of the first one",
}


def _parameters(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for parameters in layout.device.parameters.values():
        for parameter in parameters.parameters:
            if not parameter.reserved:
                number = parameters.base + parameter.number
                yield Draft(
                    parameter.name,
                    UINT,
                    number,
                    cited(_numbered(parameters, parameter), parameter),
                    parameter,
                    hexadecimal=parameters.base > 0,
                )
                if parameter.count > 1:
                    yield Draft(
                        f"{parameter.name}_count", UINT, parameter.count, _OF_SEVERAL["count"], parameter, derived=True
                    )


def _numbered(parameter_set: ParameterSet, parameter: Parameter) -> str:
    """The name of a parameter, with its printed number if neither the constant nor the printed name contains it."""
    number, name = parameter_set.number_text(parameter.number), printed(parameter)
    known = (str(parameter_set.base + parameter.number), *name.split())
    return name if number in known else f"{number} {name}"


def _messages(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for message in layout.messages.values():
        model = message.message
        for word, number in (("code", model.code), ("response_code", model.response_code), ("number", model.number)):
            if number is not None:
                kind = UINT if number <= UINT.high else narrowest(0, number)
                yield Draft(f"{model.name}_{word}", kind, number, cited(model.title, model), model, word != "number")
        for data in message.bodies:
            if data.size:
                remark = "bytes of its data"
                yield Draft(f"{data.name}_size", UINT, data.size, remark, model, derived=True)


def _masks(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for word in layout.device.flags.values():
        kind = BITS[word.type.size]
        for bit in word.bits:
            if bit.reserved:
                continue
            text = "; ".join(f"{n} = {meaning}" for n, meaning in enumerate((bit.zero, bit.one)) if meaning)
            place = f"bit{'s' * (bit.width > 1)} {bit.number_text}"
            number = f"{'signed, ' * bit.signed}1 count = {count_of(bit.as_value)}." if bit.is_number else ""
            limits = f"Counts: {bit.ranges.text()}." if bit.ranges is not None else ""
            default = f"Default: {bit.default}." if bit.default is not None else ""
            reason = bit.reason_to_give(layout.device.enums.get(bit.enum))
            reason_to_give = f"To be given: its {reason}." if reason else ""
            facts = f"{place} {printed(bit)} {text} {number} {limits} {default} {reason_to_give}"
            comment = cited(" ".join(facts.split()), bit)
            yield Draft(f"{word.name}_{bit.name}", kind, bit.mask, comment, bit, hexadecimal=True)
            if bit.width > 1 and not bit.pieces:
                yield Draft(f"{word.name}_{bit.name}_first", UINT, bit.first, "its lowest bit", bit, derived=True)
        for state in word.states:
            mask, value = word.masked(state)
            name = f"{word.name}_{state.name}"
            comment = cited(f"{printed(state)} the bits that show it", state)
            yield Draft(f"{name}_mask", kind, mask, comment, state, hexadecimal=True)
            yield Draft(f"{name}_value", kind, value, "what these are in it", state, True, derived=True)


def _codes(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for enum in layout.device.enums.values():
        members = [] if enum.name in types else available(enum)
        if members:
            kind = narrowest(min(0, *(member.value for member in members)), max(member.value for member in members))
            for member in members:
                comment = member_remark(member)
                yield Draft(f"{enum.name}_{member.name}", kind, member.value, comment, member)


def _ranges(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    bodies = {data.name for message in layout.messages.values() for data in message.bodies}
    for quantity in sorted(every_value(layout), key=lambda quantity: isinstance(quantity.fact, Signal)):
        value, fact = quantity.value, quantity.fact
        is_only_sent = quantity.answer is None and quantity.owner in bodies
        if is_only_sent or not is_count(value.encoding) or value.const is not None:
            continue
        unit = f"1 count = {count_of(value)}." if value.scaled or value.unit else ""
        for word, ranges in (("", value.ranges), ("write_", value.write_ranges)):
            if ranges is not None and (ranges.low, ranges.high) != (value.type.low, value.type.high):
                for end, bound in (("min", ranges.low), ("max", ranges.high)):
                    yield Draft(f"{quantity.full_name}_{word}{end}", quantity.kind, bound, cited(unit, fact), fact)


def _absent(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for quantity in every_value(layout):
        value, fact = quantity.value, quantity.fact
        name = quantity.full_name
        for sentinel in value.sentinels:
            remark = cited(f"no quantity: {sentinel.doc or sentinel.name}", fact)
            if is_count(value.encoding):
                kind = whole_type(value.encoding)
                yield Draft(f"{name}_{sentinel.name}", kind, sentinel.value, remark, fact, derived=True)
                if sentinel.last is not None:
                    yield Draft(f"{name}_{sentinel.name}_last", kind, sentinel.last, remark, fact, derived=True)
            elif is_single(value.encoding) and not sentinel.is_nan:
                yield Draft(f"{name}_{sentinel.name}", REAL, Decimal(sentinel.value), remark, fact, derived=True)


def _limits(layout: DeviceLayout, types: frozenset[str]) -> Iterator[Draft]:
    for limit in layout.device.limits:
        known = {"": limit.value, "min": limit.low, "max": limit.high}
        for word, number in known.items():
            if number is not None:
                kind = _of_limit(number)
                whole = kind is not LREAL
                comment = cited(limit.unit, limit)
                name = f"{limit.name}_{word}" if word else limit.name
                yield Draft(name, kind, int(number) if whole else number, comment, limit)


def _of_limit(number: Decimal) -> Elementary:
    whole = number == number.to_integral_value() and abs(number) < 1 << 31
    return narrowest(min(0, int(number)), max(0, int(number))) if whole else LREAL


LISTS: Mapping[str, tuple[str, str, _Make]] = {
    "addresses": ("reg", "Addresses of registers and tables", _addresses),
    "parameters": ("par", "Numbers of parameters on the wire", _parameters),
    "messages": ("msg", "Codes and numbers of messages, and bytes of their data", _messages),
    "masks": ("mask", "Masks of bits, and the lowest bits of fields of several bits", _masks),
    "codes": ("", "Numbers of what enums list", _codes),
    "ranges": ("range", "Least and greatest counts of values", _ranges),
    "absent": ("absent", "Counts that stand for a state and are not a quantity", _absent),
    "limits": ("limit", "Limits of the device", _limits),
}
"""The lists of constants: the word in names that stand alone, if they need one, what the list is, and what makes it."""
