"""The statements of a fact, key by key, in a form that compares with a restatement."""

from __future__ import annotations

from decimal import Decimal

from fieldspec.language.checks.finding import enumeration, hexadecimal, interval
from fieldspec.language.model.checksums import checksum_named, checksum_size
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Bit, Enum, Flags, Member
from fieldspec.language.model.fact import Fact, ScalarValue
from fieldspec.language.model.link import Link, Part
from fieldspec.language.model.ranges import Ranges, intervals, merged
from fieldspec.language.model.record import Case, Field, Message, Record
from fieldspec.language.model.registers import Parameter, ParameterSet, Register, Subindex, Table
from fieldspec.language.model.sizes import RecordSizes, messages_sent, sent_on, shapes
from fieldspec.language.model.texts import Limit
from fieldspec.language.model.value import Conversion, Signal, Value, exact_scale

_RANGES = ("range", "repeat", "enum_values")
_ADDRESSES = ("at", "code", "refusal_code", "initial", "wire_number")
_NAMES = ("applies_to", "messages", "available_since")

Intervals = tuple[tuple[Decimal, Decimal], ...]


def claimed_value(key: str, claim: ScalarValue) -> object:
    """The value of a claim under a key, in the form of `statements`."""
    if key in _RANGES:
        pairs = intervals(str(claim))
        if any(bound != bound.to_integral_value() for pair in pairs for bound in pair):
            return tuple(sorted(pairs))
        return tuple(merged((int(low), int(high)) for low, high in pairs))
    if key == "unit_range":
        return tuple(sorted(intervals(str(claim))))
    if key in _NAMES:
        return frozenset(str(claim).split(", "))
    if key == "scale" and isinstance(claim, str):
        return exact_scale(claim)
    return claim


def as_text(key: str, value: object) -> str:
    """The value of a fact or of a claim under a key, as text."""
    if isinstance(value, tuple):
        return ", ".join(interval(low, high) for low, high in value)
    if isinstance(value, frozenset):
        return enumeration(sorted(value))
    if isinstance(value, Decimal):
        return f"{value:f}"
    if isinstance(value, bool):
        return str(value).lower()
    return hexadecimal(value) if key in _ADDRESSES and isinstance(value, int) else str(value)


def statements(device: Device, sizes: RecordSizes, fact: Fact) -> dict[str, object]:
    """The statements of a fact by key; a key without a statement is absent, or None."""
    return {"available_since": frozenset(fact.since) or None, **_all_statements(device, sizes, fact)}


def _all_statements(device: Device, sizes: RecordSizes, fact: Fact) -> dict[str, object]:
    if isinstance(fact, Register):
        return {
            **_value(device, fact.value),
            "at": fact.address,
            "decimal": fact.address + device.space(fact.space).first_number,
            "number": fact.number,
            "words": fact.width,
            "access": fact.access or None,
            "restart": fact.restart,
            "count": fact.count,
        }
    if isinstance(fact, Field):
        return _field(device, sizes, fact)
    if isinstance(fact, Parameter):
        return {**_value(device, fact.value), **_parameter(device, fact)}
    if isinstance(fact, Part):
        return {**_checksum(device, sizes, fact), **(_value(device, fact.value) if fact.value else {})}
    if isinstance(fact, Signal | Case | Subindex):
        own = {"count": _length(fact.indices), "access": fact.access or None} if isinstance(fact, Subindex) else {}
        return {**_value(device, fact.value), **own}
    if isinstance(fact, Table):
        words = {"words": _words(fact.words, sizes.named(fact.record)), "access": fact.access or None}
        return {"at": fact.base, "decimal": fact.base, "count": fact.count, **words}
    if isinstance(fact, Record):
        size = sizes.named(fact.name)
        return {"words": _words(fact.words, size), "length": size, "count": len(fact.fields)}
    return _other(device, fact)


def _checksum(device: Device, sizes: RecordSizes, part: Part) -> dict[str, object]:
    """The statements of a checksum part: its initial value, the sum of the longest frame, and the unit of its order."""
    if not part.stated_algorithm:
        return {}
    algorithm = checksum_named(part.stated_algorithm)
    own_size = checksum_size(part.stated_algorithm, part.digits)
    lengths = [
        shape.around + bounds[1] - own_size
        for direction in ("request", "response")
        for shape in shapes(device, direction)
        if part.place.path.startswith(f"{shape.link.place.path}/")
        for message in messages_sent(device, shape.link, direction)
        if (bounds := sizes.bounds(message.request if direction == "request" else message.response)) is not None
    ]
    return {
        "initial": algorithm.initial,
        "greatest_sum": 0xFF * max(lengths) if lengths and algorithm.method == "sum" else None,
        "unit": "byte" if own_size > 1 and not part.digits else None,
    }


def _other(device: Device, fact: Fact) -> dict[str, object]:
    if isinstance(fact, Message):
        return {"code": fact.code, "number": fact.number, "refusal_code": _refusal_code(device, fact)}
    if isinstance(fact, Member):
        return {"value": fact.value, "code": fact.value, "number": fact.number}
    if isinstance(fact, Bit):
        in_unit = _in_unit(fact.as_value) if fact.ranges is not None else None
        number = fact.first if fact.width == 1 else None
        default = None if fact.default is None else fact.as_value.in_unit(fact.default)
        defaults = {"default": fact.default, "unit_default": default}
        return {"bit": number, "range": _merged(fact.ranges), "unit_range": in_unit, **defaults}
    if isinstance(fact, Enum):
        return {"count": len(fact.members), "enum_values": _member_intervals(fact)}
    if isinstance(fact, Flags):
        whole = {"range": _merged(fact.ranges), "type": fact.type.name, "length": fact.type.size}
        return {"count": len(fact.bits), **whole}
    if isinstance(fact, ParameterSet):
        numbers = {"range": _merged(fact.numbers), "wire_number": fact.base}
        return {"count": len(fact.parameters), **numbers}
    if isinstance(fact, Conversion):
        return {"value": fact.full_scale, "type": fact.type.name}
    if isinstance(fact, Limit):
        limit_values: dict[str, object] = {"value": fact.value, "unit": fact.unit or None}
        if fact.low is None or fact.high is None:
            return limit_values
        return {**limit_values, "range": ((fact.low, fact.high),), "unit_range": ((fact.low, fact.high),)}
    if isinstance(fact, Link) and fact.unit_addresses is not None:
        return {"range": _merged(fact.unit_addresses.ranges)}
    return {}


def _refusal_code(device: Device, message: Message) -> int | None:
    """The code of a refusal, where all links on which a message is sent mark it in one way."""
    links = [link for link in device.links.values() if sent_on(link, message)]
    marks = {(link.exception_response.flag or None) if link.exception_response is not None else None for link in links}
    mark = marks.pop() if len(marks) == 1 else None
    return None if mark is None or (code := message.code_of("response")) is None else code | mark


def _parameter(device: Device, parameter: Parameter) -> dict[str, object]:
    bases = [
        parameter_set.base
        for parameter_set in device.parameters.values()
        if any(member is parameter for member in parameter_set.parameters)
    ]
    return {
        "code": parameter.number,
        "number": parameter.number,
        "wire_number": bases[0] + parameter.number if bases else None,
        "count": parameter.elements or parameter.count,
        "access": parameter.access or None,
        "restart": parameter.restart,
        "applies_to": frozenset(parameter.applies_to) or None,
        "messages": frozenset(parameter.messages) or None,
    }


def _length(ranges: Ranges) -> int:
    return sum(high - low + 1 for low, high in ranges.intervals)


def _value(device: Device, value: Value) -> dict[str, object]:
    enum = device.enums.get(value.enum)
    return {
        "type": value.type.name,
        "length": value.size,
        "hex_digits": 2 * value.size,
        "scale": value.scale_number,
        "unit": value.quantity_unit or None,
        "range": _merged(value.ranges),
        "unit_range": _in_unit(value),
        "default": value.default,
        "unit_default": value.in_unit(value.default) if isinstance(value.default, int) else None,
        "value": value.const,
        "enum_values": _member_intervals(enum) if enum is not None else None,
    }


def _field(device: Device, sizes: RecordSizes, field: Field) -> dict[str, object]:
    bounds = sizes.field(field)
    fixed = bounds[0] if bounds is not None and bounds[0] == bounds[1] else None
    repeat = field.repeat
    count = repeat.low if repeat is not None and repeat.low == repeat.high else None
    return {
        **(_value(device, field.value) if field.value is not None else {}),
        "at": field.at,
        "words": _words(field.words, fixed),
        "access": field.access or None,
        "restart": field.restart,
        "count": count if repeat is not None else field.count or 1,
        "repeat": _merged(repeat),
    }


def _words(printed: int | None, size: int | None) -> int | None:
    if printed is not None:
        return printed
    return size // 2 if size is not None and size % 2 == 0 else None


def _merged(ranges: Ranges | None) -> tuple[tuple[int, int], ...] | None:
    return tuple(merged(ranges.intervals)) if ranges is not None else None


def _member_intervals(enum: Enum) -> tuple[tuple[int, int], ...]:
    return tuple(merged((member.value, member.value) for member in enum.members))


def _in_unit(value: Value) -> Intervals | None:
    if value.ranges is None:
        return None
    pairs = ((value.in_unit(low), value.in_unit(high)) for low, high in value.ranges.intervals)
    return tuple(sorted((min(pair), max(pair)) for pair in pairs))
