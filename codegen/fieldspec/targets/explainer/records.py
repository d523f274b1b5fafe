"""Records and messages as data of the explainer."""

from __future__ import annotations

from fieldspec.codec.explain.row import errata_of_message
from fieldspec.codec.layout.inner_lists import inner_lists_data
from fieldspec.codec.layout.message import MessageLayout
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.widths import Span, span_data, value_form
from fieldspec.language.model.device import Device
from fieldspec.language.model.record import RegisterAccess
from fieldspec.targets.explainer.literals import Data
from fieldspec.targets.explainer.values import fact_data, stated, value_data


def record_data(record: RecordLayout, words: str) -> dict[str, Data]:
    """A record; `chosen` has its forms by the values of the field that decides them. `words` is the order of words."""
    inner = record.inner_lists
    forms: dict[int, tuple[RecordLayout, list[int]]] = {}
    for number, form in record.chosen.items():
        forms.setdefault(id(form), (form, []))[1].append(number)
    return {
        **fact_data(record.record),
        "least": record.least,
        **stated({"most": record.most, "size": record.size}),
        "fields": [_field(field, words) for field in record.fields],
        **stated({"spans": [_span(span) for span in record.spans]}),
        **({"inner": inner_lists_data(inner)} if inner is not None else {}),
        **stated(
            {
                "selector": record.selector.name if record.selector is not None else "",
                "chosen": [[numbers, record_data(form, words)] for form, numbers in forms.values()],
            }
        ),
    }


def _span(span: Span) -> dict[str, Data]:
    """The width of a field; of a value that varies in width what people call its form."""
    return {**span_data(span), **({"formText": value_form(span.value)} if span.value is not None else {})}


def _field(field: FieldLayout, words: str) -> dict[str, Data]:
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
                "valueBytes": _value_bytes(field, words) if field.carries_bytes else None,
                "record": field.record.name if field.record is not None else "",
                "cases": bool(field.cases),
                "reserved": own.reserved,
                "measures": [measures.of, measures.field, *plus] if measures is not None else None,
                "bitsOf": field.bits_of,
                "sameAs": own.same_as,
                "signal": own.signal,
            }
        ),
    }


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
                "code": own.code,
                "responseCode": own.response_code,
                "number": own.number,
                "unrequested": not own.is_requested,
            }
        ),
        "request": record_data(message.request, device.word_order),
        "response": record_data(message.response, device.word_order),
        **stated(
            {
                "access": _access(device, device.register_access(own)),
                "bitAccess": _access(device, device.bit_access(own)),
                "steps": [_access(device, step) for step in own.access_steps],
                "errata": list(errata_of_message(device, own)),
            }
        ),
    }


def _access(device: Device, access: RegisterAccess | None) -> Data:
    if access is None:
        return None
    return {
        "operation": access.operation,
        "start": access.start,
        **stated({"count": access.count, "values": access.values, "space": device.space_name(access.space)}),
        **({"set": access.set, "clear": access.clear} if access.set is not None else {}),
        **({"unitSize": 1} if device.space(access.space).unit_size == 1 else {}),
    }
