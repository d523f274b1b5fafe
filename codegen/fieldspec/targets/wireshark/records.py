"""Records and messages as data of the dissector."""

from __future__ import annotations

from fieldspec.codec.explain.errata import errata_of_message
from fieldspec.codec.explain.percentages import references_text
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.names import Name
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.record import Case, Message
from fieldspec.language.model.value import Value
from fieldspec.targets.wireshark.filters import Filters, description, title_of
from fieldspec.targets.wireshark.text import Data, line_text
from fieldspec.targets.wireshark.values import code_data, errata_data, value_data

DIRECTIONS = ("request", "response")


def value_entry(
    filters: Filters, layout: DeviceLayout, names: tuple[str, ...], field: FieldLayout, value: Value, fact: Fact
) -> dict[str, Data]:
    """The filter names and the data of a field that has a value, which a `fact` states: the field, or a case."""
    data = value_data(value, field.order, field.swapped, filters.digits.get(fact.place.path))
    return {
        "filter": filters.of_value(names, field.field, value),
        "quantity": filters.of_quantity(names, field.field, value),
        "bits": filters.of_bits((value.flags, *names), value),
        "value": data,
        "show": filters.functions.number(data, field.field.reserved),
        "percent": _percent(layout, field),
    }


def field_data(
    filters: Filters,
    layout: DeviceLayout,
    names: tuple[str, ...],
    field: FieldLayout,
    message: Message | None,
    case: Case | None = None,
) -> dict[str, Data]:
    """A field of a record. `names` are proposals for its filter name; `message` is that of a request or response.

    `case` is what decides its value, None for a field without cases.
    """
    own = field.field
    data: dict[str, Data] = {
        "name": field.name,
        "title": title_of(own),
        "offset": field.offset,
        "size": field.size,
        "count": field.count,
        "repeats": [own.repeat.low, own.repeat.high] if own.repeat is not None else None,
        "is_list": field.is_list,
        "reserved": own.reserved,
        "same_as": own.same_as or None,
        "errata": errata_data(layout.device, own),
    }
    if own.measures is not None:
        plus = {"plus": own.measures.plus} if own.measures.plus else {}
        data["measures"] = {"of": own.measures.of, "field": own.measures.field, **plus}
    if field.bits_of:
        data["bits_of"] = field.bits_of
    if field.record is not None:
        row: dict[str, Data] = {"title": title_of(own), "text": description(own), "type": "NONE"}
        return {**data, "record": field.record.name, "filter": filters.take(names, row)}
    assert field.value is not None
    part = field.value.parameter
    if part is not None:
        index = _index_field(message, part.number) if message is not None else None
        data["parameter"] = {"set": part.set, "part": part.part, "number": part.number or None, "index": index}
    return {**data, **value_entry(filters, layout, names, field, field.value, case or own)}


def record_data(
    filters: Filters,
    layout: DeviceLayout,
    record: RecordLayout,
    prefixes: tuple[str, ...],
    message: Message | None = None,
) -> dict[str, Data]:
    """A record. The filter names of its fields are below one of `prefixes`."""

    def names(word: str) -> tuple[str, ...]:
        return tuple(f"{prefix}.{word}" for prefix in prefixes)

    placed = _placed(record, message)
    fields = [
        {**field_data(filters, layout, names(field.name), field, message), "has_place": field.name in placed}
        for field in record.fields
        if not field.cases
    ]
    data: dict[str, Data] = {
        "fields": fields,
        "size": record.size,
        "least": record.least,
        "most": record.most,
        "extent": _extent(record),
        **_step(layout, record),
        "last": record.fields[-1].name if record.fields else None,
    }
    if record.selector is not None:
        cases: dict[str, Data] = {}
        choice = record.fields[-1]
        for number, chosen in record.chosen.items():
            case = next(case for case in choice.cases if number in case.numbers)
            chosen_data = field_data(filters, layout, names(case.name), chosen.fields[-1], message, case.case)
            cases[str(number)] = {**chosen_data, "has_place": choice.name in placed}
        data |= {"by": record.fields.index(record.selector) + 1, "cases": cases}
    return data


def _placed(record: RecordLayout, message: Message | None) -> set[str]:
    """The names of the fields whose offset is needed: fields that others measure, and that a message
    reads or writes.
    """
    measured = {field.field.measures.field for field in record.fields if field.field.measures is not None}
    accessed = {message.single_access.values} if message is not None and message.single_access is not None else set()
    return measured | accessed | {field.bits_of for field in record.fields}


def opaque_data(layout: DeviceLayout, record: RecordLayout) -> dict[str, Data]:
    """A record that is shown as bytes: how many there may be, and what tells how many there are."""
    extent = _varying_extent(record) if record.spans or record.inner_lists is not None else _extent(record)
    return {
        "fields": [],
        "is_opaque": True,
        "size": record.size,
        "least": record.least,
        "most": record.most,
        "extent": extent,
        **_step(layout, record),
    }


def message_data(layout: DeviceLayout, message: MessageLayout, is_decoded: bool = True) -> dict[str, Data]:
    """A message with the records of `record_key`. A message that is not decoded shows no access to registers."""
    own = message.message
    access = own.single_access
    data: dict[str, Data] = {
        "name": message.name,
        "title": line_text(own.title) or Name.of(message.name).title(),
        "code": code_data(own.code),
        "response_code": code_data(own.code_of("response")),
        **({} if own.is_requested else {"is_unrequested": True}),
        "errata": list(errata_of_message(layout.device, own)) or None,
        **{direction: record_key(message, direction) for direction in DIRECTIONS},
    }
    words, bits = layout.device.register_access(own), layout.device.bit_access(own)
    if is_decoded and access is not None and (words or bits):
        data["access"] = {
            "operation": access.operation,
            "start": access.start,
            "count": access.count or None,
            "values": access.values or None,
            "space": layout.device.space_name(access.space),
            "is_bits": bits is not None,
            **({"unit_size": 1} if layout.device.space(access.space).unit_size == 1 else {}),
            "set": access.set,
            "clear": access.clear,
        }
    return data


def record_key(message: MessageLayout, direction: str) -> str:
    """The name of the record of a message in one direction; no record of a spec has a blank in its name."""
    return f"{message.name} {direction}"


def _percent(layout: DeviceLayout, field: FieldLayout) -> Data:
    """The conversions of the signal that a field carries, as scales of percent."""
    if not field.field.signal:
        return None
    rows: list[Data] = [
        {
            "factor": (-100 if conversion.complement else 100),
            "shift": 100 * conversion.full_scale if conversion.complement else 0,
            "divisor": conversion.full_scale,
            "places": 0,
            "of": line_text(references_text(layout.device, conversion)),
        }
        for conversion in layout.device.conversions.values()
        if field.field.signal in conversion.signals
    ]
    return rows or None


def _index_field(message: Message | None, number: str) -> str | None:
    """The name of the field with the index of the first element of a parameter; None if the message has none."""
    for field in (*message.request.fields, *message.response.fields) if message is not None else ():
        part = field.value.parameter if field.value else None
        if part is not None and (part.part, part.number) == ("subindex", number):
            return field.name
    return None


def _extent(record: RecordLayout) -> Data:
    """How a record whose size varies tells its size: the number of a field that measures the last one."""
    if record.size is not None or not record.fields or record.fields[-1].cases:
        return None
    tail = record.fields[-1]
    for field in record.fields:
        measures = field.field.measures
        is_number = field.value is not None and field.size <= 4 and not field.value.digits
        if measures is not None and measures.field == tail.name and field.value is not None and is_number:
            unit = measures.unit(tail.size)
            extent: dict[str, Data] = {
                "offset": field.offset,
                "value": value_data(field.value, field.order, field.swapped),
                "fixed": tail.offset - measures.plus * unit,
                "unit": unit,
            }
            return extent
    return None


def _step(layout: DeviceLayout, record: RecordLayout) -> dict[str, Data]:
    """The bytes of each element of the only list, and the bytes of all other fields, if no count states the elements.

    Only frames that an end delimiter ends need them.
    """
    frames = (link.frame(direction) for link in layout.links.values() for direction in DIRECTIONS)
    if not any(frame.end for frame in frames) or record.size is not None:
        return {}
    if record.spans or record.selector is not None or not record.fields:
        return {}
    inner = record.inner_lists
    if inner is not None:
        is_single = len(inner.lists) == 1 and inner.last.parts is None and inner.last.packing is None
        single = inner.last if is_single else None
        return {"step": {"fixed": inner.fixed, "unit": single.element}} if single is not None else {}
    tail = record.fields[-1]
    if tail.count is not None or tail.size < 2 or _extent(record) is not None:
        return {}
    return {"step": {"fixed": tail.offset, "unit": tail.size}}


def _varying_extent(record: RecordLayout) -> Data:
    """How a record with one list, or one text, that has fields after it tells its size."""
    counter, fixed_size = record.count_of_text or (None, 0)
    unit = 1
    if record.inner_lists is not None:
        inner, *further = record.inner_lists.lists
        measuring_fields = ((field, field.field.measures) for field in record.fields)
        counter, measures = next(
            ((field, own) for field, own in measuring_fields if own is not None and own.field == inner.name),
            (None, None),
        )
        if further or inner.parts is not None or inner.packing is not None or measures is None:
            return None
        unit = measures.unit(inner.element)
        fixed_size = record.inner_lists.fixed - measures.plus * unit
    value = counter.value if counter is not None and record.has_place(counter) else None
    if counter is None or value is None or counter.size > 4 or value.digits:
        return None
    extent: dict[str, Data] = {
        "offset": counter.offset,
        "value": value_data(value, counter.order, counter.swapped),
        "fixed": fixed_size,
        "unit": unit,
    }
    return extent
