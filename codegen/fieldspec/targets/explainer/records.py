"""Records and messages as data of the explainer."""

from __future__ import annotations

from fieldspec.codec.explain.errata import errata_of_message
from fieldspec.codec.layout.inner_list_data import inner_lists_data
from fieldspec.codec.layout.list_places import inner_lists_of
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.packing import packing_data
from fieldspec.codec.layout.presence import presence_data
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.widths import Span, span_data
from fieldspec.codec.program.lowering import field_program
from fieldspec.codec.program.operations import Load, LoadVarying
from fieldspec.language.model.address_space import WORD
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import RegisterAccess
from fieldspec.targets.explainer.literals import Data
from fieldspec.targets.explainer.values import fact_data, stated, value_data


def record_data(device: Device, record: RecordLayout) -> dict[str, Data]:
    """A record; `chosen` has its forms by the values of the field that decides them."""
    inner = record.inner_lists
    forms: dict[int, tuple[RecordLayout, list[int]]] = {}
    for number, form in record.chosen.items():
        forms.setdefault(id(form), (form, []))[1].append(number)
    return {
        **fact_data(record.record),
        "least": record.least,
        **stated({"most": record.most, "size": record.size}),
        "fields": [_field(device, record, field) for field in record.fields],
        **stated({"spans": [span_data(span) for span in record.spans]}),
        **({"inner": {**inner_lists_data(inner), "sent": _sent(record)}} if inner is not None else {}),
        **stated(
            {
                "selector": record.selector.name if record.selector is not None else "",
                "chosen": [[numbers, record_data(device, form)] for form, numbers in forms.values()],
            }
        ),
    }


def _sent(record: RecordLayout) -> list[Data]:
    """The names of the fields in the order of the wire."""
    return [field.name for field in record.sent_fields]


def _forms(device: Device, record: RecordLayout, field: FieldLayout) -> list[Data]:
    """The forms of a field with the numbers that decide them."""
    forms = [(case, field.forms[min(case.numbers)]) for case in field.cases]
    return [[sorted(case.numbers), _field(device, record, form)] for case, form in forms]


def _span(record: RecordLayout, field: FieldLayout) -> Data:
    """How a value varies in width that is in the image of a record with lists; None for others."""
    has_span = field.value is not None and field.value.width and not record.spans
    return {**span_data(Span(field.name, field.size, field.value, None))} if has_span else None


def _field(device: Device, record: RecordLayout, field: FieldLayout) -> dict[str, Data]:
    own = field.field
    measures, repeat = own.measures, own.repeat
    plus = [measures.plus] if measures is not None and measures.plus else []
    return {
        **fact_data(own),
        "name": field.name,
        "offset": field.offset,
        "size": field.size,
        **stated(
            {
                "count": field.count,
                "isList": field.is_list,
                "repeat": [repeat.low, repeat.high] if repeat is not None else None,
                "lengths": [list(interval) for interval in repeat.intervals] if repeat is not None else None,
                "value": value_data(field.value, field.order, field.swapped) if field.value is not None else None,
                "exponent": _exponent(device, record, field),
                "valueBytes": _value_bytes(field, device.word_order) if field.carries_bytes else None,
                "valueOrder": [field.order, field.swapped] if _is_read_again(field) else None,
                "record": field.record.name if field.record is not None else "",
                "parts": _parts(field),
                "packing": packing_data(field.packing) if field.packing is not None else None,
                "span": _span(record, field),
                "cases": field.splits_record,
                "presence": presence_data(field.presence) if field.presence is not None else None,
                "by": field.selector.name if field.selector is not None else "",
                "forms": _forms(device, record, field) if field.forms else None,
                "mask": field.deciding_bits,
                "reserved": own.reserved,
                "measures": [measures.of, measures.field, *plus] if measures is not None else None,
                "bitsOf": field.bits_of,
                "sameAs": own.same_as,
                "signal": own.signal,
            }
        ),
    }


def _parts(field: FieldLayout) -> Data:
    """What tells the size of a record that differs in size; None for other fields."""
    if field.record is None or field.record.size is not None:
        return None
    return inner_lists_data(inner_lists_of(field.record, is_element=True))


def _exponent(device: Device, record: RecordLayout, field: FieldLayout) -> str:
    """The field of the same record with the exponent of the scale of a value, as its program has it."""
    if field.value is None or not field.value.scale_by:
        return ""
    load = field_program(device, record, field).element[0]
    assert isinstance(load, Load | LoadVarying)
    return load.variable.exponent


def _is_read_again(field: FieldLayout) -> bool:
    """Whether the bytes of a field are read as the value of a parameter, which has the order of the field."""
    parameter = field.value.parameter if field.value is not None else None
    return parameter is not None and parameter.part in ("value", "values") and not field.carries_bytes


def _value_bytes(field: FieldLayout, words: str) -> Data:
    """The orders of a parameter's value in a field of bytes; the field that says how many count, and the counts."""
    part = field.value.parameter if field.value is not None else None
    if part is None or part.sizes is None:
        return [field.order, words]
    return [field.order, words, part.sizes.by, [list(pair) for pair in field.sizes.items()]]


def message_data(device: Device, message: MessageLayout) -> dict[str, Data]:
    """A message with the data of its request, and of its response if the device answers it."""
    own = message.message
    return {
        **fact_data(own),
        **stated(
            {
                "title": own.title,
                "code": own.code_of("request"),
                "responseCode": own.code_of("response") if own.has_response_code else None,
                "number": own.number,
                "unrequested": not own.is_requested,
            }
        ),
        "request": record_data(device, message.request),
        "response": record_data(device, message.response),
        **stated(
            {
                "access": _access(device, own.single_access) if own.single_access is not None else None,
                "steps": [_access(device, step) for step in own.access_steps],
                "errata": list(errata_of_message(device, own)),
            }
        ),
    }


def _access(device: Device, access: RegisterAccess) -> Data:
    unit = device.space(access.space).unit
    return {
        "operation": access.operation,
        "start": access.start,
        **stated({"count": access.count, "values": access.values, "space": device.space_name(access.space)}),
        **({"set": access.set, "clear": access.clear} if access.set is not None else {}),
        **({"unit": unit} if unit != WORD else {}),
    }
