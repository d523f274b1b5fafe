"""Values of parameters as people write them, in the fields of a message that carry their bytes."""

from __future__ import annotations

from fieldspec.commands.frame_options import number_of
from fieldspec.commands.usage import UsageError
from fieldspec.explain.parameters import parameter_number
from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.record import FieldLayout, RecordLayout
from fieldspec.layout.values import raw_value
from fieldspec.model.registers import Parameter
from fieldspec.simulator.memory import element_value
from fieldspec.simulator.parameters import part_of


def with_parameter(layout: DeviceLayout, record: RecordLayout, direction: str, texts: dict[str, object]) -> None:
    """Replaces the name of an element by its sub-index, and a value by its bytes and what says how many they are.

    A value of a parameter that the spec does not describe is written as bytes. Raises UsageError where the message
    does not carry as many bytes, and where the element can only be read; MeaningError; and CodecError.
    """
    from fieldspec.reference.parameters import bytes_of_value, carries
    from fieldspec.reference.records import encoded_value

    numbered, indexed, carried = (part_of(record, part) for part in ("number", "subindex", "value"))
    parameter = _parameter(layout, numbered, texts)
    if parameter is None:
        return
    index: object = 0
    if indexed is not None:
        if parameter.elements is None:
            texts.setdefault(indexed.name, 0)
        index = texts.get(indexed.name)
        if isinstance(index, str):
            index = texts[indexed.name] = _index(parameter, index)
    text = texts.get(carried.name) if carried is not None else None
    if carried is None or not carried.carries_bytes or not isinstance(text, str) or not isinstance(index, int):
        return
    if index >= (parameter.elements or 1):
        raise UsageError(f"{parameter.name} has no element {index}")
    if direction == "request" and parameter.element_access(index) == "ro":
        raise UsageError(f"{parameter.name} can only be read; no frame is written")
    value = element_value(parameter, index)
    if not carries(carried, value.size):
        raise UsageError(
            f"{parameter.name} has {value.size} {'byte' if value.size == 1 else 'bytes'}; use another message"
        )
    known = encoded_value(parameter.name, value, raw_value(layout.device, parameter.name, value, text), layout.device)
    for name, content in bytes_of_value(layout.device, carried, value, known).items():
        if name == carried.name or name not in texts:
            texts[name] = content.hex() if isinstance(content, bytes) else content


def _parameter(layout: DeviceLayout, numbered: FieldLayout | None, texts: dict[str, object]) -> Parameter | None:
    """The parameter that a message is about; None where the spec does not describe it."""
    part = numbered.value.parameter if numbered is not None and numbered.value is not None else None
    text = texts.get(numbered.name) if numbered is not None else None
    if part is None or not isinstance(text, str):
        return None
    number = parameter_number(layout.device, part.set, text)
    number = number_of(text) if number is None else number
    match = layout.device.parameter_at(part.set, number) if isinstance(number, int) else None
    return match[0].numbered(match[1]) if match is not None else None


def _index(parameter: Parameter, text: str) -> object:
    """The sub-index of the element with a name; the number, or else the text itself, where no element has it."""
    for inner in parameter.subindices:
        if text.lower() in (inner.name, inner.printed_name.lower()):
            return inner.indices.low
    number = number_of(text)
    return text if number is None else number
