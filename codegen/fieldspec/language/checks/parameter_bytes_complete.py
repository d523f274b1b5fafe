"""A field of bytes with the value of a parameter is a single field of a message. Its `sizes`, if stated, name an
earlier field of that message with an enum and the members of that enum, and each number of bytes once. The messages
carry every value of the set, in one message or in segments.

Why: the bytes of a value are read in the type of the parameter. With more or fewer bytes, the number would be
different.

Example: `type: bytes, length: 4` for the value, and `sizes` with a case of eight bytes.

Fix: State the numbers of bytes that the manual prints. For a value that is sent in several messages, such as a long
text, state `segments` for the message that begins the transfer in each direction.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.facts import cases
from fieldspec.language.checks.finding import Findings, finding, label, near
from fieldspec.language.model.access import readable, writable
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_octets
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.ranges import merged, uncovered
from fieldspec.language.model.record import Field, Record
from fieldspec.language.model.registers import Parameter, ParameterSet
from fieldspec.language.model.value import ParameterSizes, Value


def parameter_bytes_complete(device: Device) -> Findings:
    for record in device.records.values():
        for field in record.fields:
            for value in (field.value, *(case.value for case in cases(field))):
                if _part(value) == "value" and _has_bytes(value):
                    text = f"{field.name} has the value of a parameter in bytes, and is in a record"
                    yield finding(field.place, "parameter", text, "state it as a field of the message")
    for message in device.messages.values():
        for direction in (message.request, message.response):
            for field in direction.fields:
                yield from _of_field(device, direction, field)
    for parameter_set in device.parameters.values():
        yield from _of_set(device, parameter_set)


def _part(value: Value | None) -> str:
    return value.parameter.part if value is not None and value.parameter is not None else ""


def _has_bytes(value: Value | None) -> bool:
    return value is not None and is_octets(value.encoding)


def _of_field(device: Device, record: Record, field: Field) -> Findings:
    for case in cases(field):
        if _part(case.value) == "value" and _has_bytes(case.value):
            text = f"{case.name} has the value of a parameter in bytes, and {field.name} has several types"
            yield finding(case.place, "type", text, "use one type of bytes with `sizes`, or types of numbers")
    value = field.value
    part = value.parameter if value is not None else None
    if value is None or part is None:
        return
    carries = part.part == "value" and _has_bytes(value)
    if carries and (field.count is not None or field.repeat is not None):
        text = f"{field.name} has the value of a parameter in bytes, and is a list"
        yield finding(field.place, "type", text, "use one field of bytes, with their number as its `length`")
    if part.sizes is None:
        return
    if not carries:
        text = f"{field.name} does not have the value of a parameter in bytes"
        yield finding(field.place, "parameter", text, "remove `sizes`, or use `part: value` and `type: bytes`")
        return
    before = {own.name: own for own in record.fields[: record.fields.index(field)]}
    selector = before.get(part.sizes.by)
    if selector is None:
        text = f"there is no field `{part.sizes.by}` before {field.name}"
        yield finding(field.place, "parameter", text, near(part.sizes.by, before))
        return
    enum = device.enums.get(selector.value.enum) if selector.value is not None else None
    if enum is None or selector.count is not None or selector.repeat is not None:
        text = f"{selector.name} has no enum that says how many bytes of {field.name} count"
        yield finding(field.place, "parameter", text, "give it an `enum`, and name its members in the cases")
        return
    yield from _of_sizes(field, value.size, part.sizes, enum)


def _of_sizes(field: Field, size: int, sizes: ParameterSizes, enum: Enum) -> Findings:
    names: set[str] = set()
    numbers: set[int] = set()
    for case in sizes.cases:
        for name in case.when:
            if enum.named(name) is None:
                text = f"{enum.name} has no member `{name}`"
                yield finding(field.place, "parameter", text, near(name, [own.name for own in enum.members]))
            elif name in names:
                text = f"{name} stands for two numbers of bytes"
                yield finding(field.place, "parameter", text, "name each member once")
            names.add(name)
        if case.bytes > size:
            text = f"{field.name} has {plural(size, 'byte')}, not {case.bytes}"
            yield finding(field.place, "parameter", text, "correct the case, or the `length` of the field")
        elif case.bytes in numbers:
            text = f"two cases are for {plural(case.bytes, 'byte')}"
            yield finding(field.place, "parameter", text, "name all members in one case, the one to write first")
        numbers.add(case.bytes)


def _of_set(device: Device, parameter_set: ParameterSet) -> Findings:
    """The values of a set against the numbers of bytes that messages read and write."""
    names = (parameter_set.name, parameter_set.space)
    messages = device.messages.values()
    response_carriers = (_carrier(message.response, names) for message in messages)
    request_carriers = (_carrier(message.request, names) for message in messages)
    pieces = {
        "read" if message.segments.reads else "write"
        for message in messages
        if message.segments is not None and _numbers(message.request, names)
    }
    reads, writes = (
        [field for field in fields if field is not None] for fields in (response_carriers, request_carriers)
    )
    for carriers, verb, may in ((reads, "read", readable), (writes, "write", writable)):
        own = [_sizes(field) for field in carriers]
        # Any message may read a value, and the one with the right number of bytes writes it.
        sizes = (frozenset.intersection if verb == "read" else frozenset.union)(*own) if own else frozenset()
        for parameter in parameter_set.parameters if carriers else ():
            for fact, value, access in _elements(parameter):
                if may(access or "rw") and value.size not in sizes and verb not in pieces:
                    actual_size = plural(value.size, "byte")
                    text = f"{fact.name or parameter.name} has {actual_size}, and no message can {verb} as many"
                    related_label = label(carriers[0].place, "name", "a field with the values of these parameters")
                    help = "correct the type, or state a message that carries it, or `segments`"
                    yield finding(fact.place, "type", text, help, related_label)


def _carrier(record: Record, names: tuple[str, ...]) -> Field | None:
    """The field of a message with the bytes of values of a set."""
    for field in record.fields:
        if _part(field.value) == "value" and _has_bytes(field.value):
            assert field.value is not None
            assert field.value.parameter is not None
            if field.value.parameter.set in names:
                return field
    return None


def _numbers(record: Record, names: tuple[str, ...]) -> bool:
    """Whether a request has the number of a parameter of a set."""
    parts = (field.value.parameter for field in record.fields if field.value is not None)
    return any(part is not None and part.part == "number" and part.set in names for part in parts)


def _sizes(field: Field) -> frozenset[int]:
    """The numbers of bytes that a field carries."""
    assert field.value is not None
    assert field.value.parameter is not None
    sizes = field.value.parameter.sizes
    return frozenset({field.value.size} if sizes is None else {case.bytes for case in sizes.cases})


def _elements(parameter: Parameter) -> Iterator[tuple[Fact, Value, str]]:
    """The values of a parameter that are not reserved, each once, with their access."""
    if parameter.reserved:
        return
    described = merged([interval for inner in parameter.subindices for interval in inner.indices.intervals])
    if uncovered(0, (parameter.elements or 1) - 1, described):
        yield parameter, parameter.value, parameter.access
    for inner in parameter.subindices:
        if not inner.reserved:
            yield inner, inner.value, inner.access or parameter.access
