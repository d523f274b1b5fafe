"""Values of parameters as people write them, in the fields of a message that carry them as bytes or as a number."""

from __future__ import annotations

from fieldspec.codec.explain.entered import parameter_number, rounded
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.values import MeaningError, pieces, raw_value
from fieldspec.command.console.streams import print_error
from fieldspec.command.console.usage import UsageError
from fieldspec.command.frames.frame_options import number_of
from fieldspec.foundation.line_text import plural
from fieldspec.language.model.encoding import is_exact
from fieldspec.language.model.quantity import count_of
from fieldspec.language.model.registers import Parameter
from fieldspec.language.model.value import Value
from fieldspec.tools.simulator.memory import element_value
from fieldspec.tools.simulator.parameters import part_of


def with_parameter(layout: DeviceLayout, record: RecordLayout, direction: str, texts: dict[str, object]) -> None:
    """Replaces the name of an element by its sub-index, and a value by its bytes and what says how many they are, or by
    the number that the field has for it.

    A value of a parameter that the spec does not describe is written as bytes. Raises UsageError if the message does
    not carry this number of bytes, or if the element is read-only; MeaningError; and CodecError.
    """
    from fieldspec.codec.reference.parameters import bytes_of_value, carries
    from fieldspec.codec.reference.records import encoded_value

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
    if carried is None or not isinstance(text, str) or not isinstance(index, int):
        return
    if not carried.carries_bytes:
        own = _chosen(layout, record, carried, texts).value
        items = pieces(carried.name, text) if carried.is_list else [text]
        numbers = [
            _element_number(layout, parameter, index + offset, own, item, direction)
            for offset, item in enumerate(items)
        ]
        texts[carried.name] = numbers if carried.is_list else numbers[0]
        return
    if index >= (parameter.elements or 1):
        raise UsageError(f"{parameter.name} has no element {index}")
    if direction == "request" and parameter.element_access(index) == "ro":
        raise UsageError(f"{parameter.name} can only be read; no frame is written")
    value = element_value(parameter, index)
    if not carries(carried, value.size):
        raise UsageError(f"{parameter.name} has {plural(value.size, 'byte')}; use another message")
    text = whole_count(layout, parameter.name, value, text)
    known = encoded_value(parameter.name, value, raw_value(layout.device, parameter.name, value, text), layout.device)
    for name, content in bytes_of_value(layout.device, carried, value, known).items():
        if name == carried.name or name not in texts:
            texts[name] = content.hex() if isinstance(content, bytes) else content


def whole_count(layout: DeviceLayout, name: str, value: Value, text: object) -> object:
    """The nearest count for a quantity between two counts, with a remark on the terminal; else the text."""
    nearest_count = rounded(layout.device, name, value, text) if isinstance(text, str) else None
    if nearest_count is None:
        return text
    count, remark = nearest_count
    print_error(remark)
    return count


def _chosen(layout: DeviceLayout, record: RecordLayout, carried: FieldLayout, texts: dict[str, object]) -> FieldLayout:
    """The field with a value, in the type that the entered value of the selector decides, where there is one."""
    selector = record.selector
    if selector is None or selector.value is None or selector.name not in texts:
        return carried
    chosen = record.of_number(raw_value(layout.device, selector.name, selector.value, texts[selector.name]))
    return chosen.fields[-1] if chosen is not None else carried


def _element_number(
    layout: DeviceLayout, parameter: Parameter, index: int, own: Value | None, item: str, direction: str
) -> object:
    """The number that a field of the value `own` has for an element of a parameter as people write it.

    A count without a sign that the field can have is its number, so that bits may be written as they are. Values with a
    meaning only for the field are unchanged. Raises MeaningError and CodecError.
    """
    from fieldspec.codec.reference.parameters import number_in_field
    from fieldspec.codec.reference.records import encoded_value

    count = count_of(item)
    if own is None or index >= (parameter.elements or 1) or (count is not None and 0 <= count <= own.high):
        return item
    value = element_value(parameter, index)
    if not (is_exact(value.encoding) and is_exact(own.encoding)):
        return item
    value = value.for_writing() if direction == "request" else value
    try:
        raw = raw_value(layout.device, parameter.name, value, whole_count(layout, parameter.name, value, item))
    except MeaningError:
        try:
            raw_value(layout.device, parameter.name, own, item)
        except MeaningError:
            pass
        else:
            return item
        raise
    known = encoded_value(parameter.name, value, raw, layout.device)
    return number_in_field(own, value, int(known) if isinstance(known, bool) else known)


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
