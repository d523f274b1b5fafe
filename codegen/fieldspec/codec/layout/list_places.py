"""Where the lists of a record are in its data and in its image, and what says how many elements they have."""

from __future__ import annotations

from fieldspec.codec.layout.decision import Decision
from fieldspec.codec.layout.inner_lists import InnerList, InnerLists
from fieldspec.codec.layout.presence import bit_presence
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.foundation.classes import replace
from fieldspec.language.model.counts import list_count, text_count


def inner_lists_of(record: RecordLayout, is_element: bool = False) -> InnerLists:
    """Where the lists of a record begin, and what counts them. A text that varies in width is a list of its bytes.

    Each list of a record that `is_element` of another one is counted, since the data do not end with it.
    """
    by_name = {field.name: field for field in record.fields}
    sent_fields = [by_name[field.name] for field in record.record.fields]
    last = [field for field in sent_fields if field.varies][-1]
    fixed = sum(field.size * (field.count or 0) for field in record.fields if not field.varies)
    first, room = 0, fixed
    lists, places = list[InnerList](), dict[str, int]()
    for field in sent_fields:
        if not field.varies:
            places[field.name] = first
            first += field.size * (field.count or 0)
            continue
        is_text = field.value is not None and field.value.width > 0 and not field.in_room
        element = 1 if is_text else field.size
        low, high = (0, field.size) if is_text else field.bounds
        inner = InnerList(field.name, first, room, element, low * element, high * element, packing=field.packing)
        inner = replace(inner, continuation=field.continuation)
        count = (text_count if is_text or field.in_room else list_count)(record.record, field.field)
        counts_sent = count is not None and by_name[count.name].counts_sent
        if is_element or field is not last or field.continuation is not None or counts_sent or field.in_room:
            if field.presence is not None:
                decider = by_name[field.presence.by]
                inner = replace(_with_number_at(inner, decider, places[decider.name]), presence=field.presence)
                if field.has_count_in_bits:
                    inner = replace(inner, unit=element // field.presence.unit, plus=field.presence.plus)
            elif count is not None:
                inner = _with_count(inner, by_name[count.name], places[count.name])
        if field.in_room and field.value is not None:
            inner = replace(inner, decision=Decision("", 0, 0, "big", {0: -field.value.width}))
        if field.record is not None and field.record.size is None:
            inner = replace(inner, parts=inner_lists_of(field.record, is_element=True))
        elif field.continuation is not None:
            inner = replace(inner, parts=InnerLists((), field.size))
        if field.selector is not None:
            inner = replace(inner, decision=_decision(field, field.selector, places[field.selector.name]))
        lists.append(inner)
        room += inner.most
    return InnerLists(tuple(lists), fixed)


def _decision(field: FieldLayout, selector: FieldLayout, offset: int) -> Decision:
    """What decides the bytes of a field, by a selector that is at an offset in the image."""
    values = {number: form.value for number, form in field.forms.items() if form.value is not None}
    sizes = {number: -value.width or value.size for number, value in values.items()}
    marked = frozenset(number for number, value in values.items() if value.is_marked)
    return Decision(selector.name, offset, selector.size, selector.order, sizes, field.deciding_bits, marked)


def _with_count(inner: InnerList, count: FieldLayout, offset: int) -> InnerList:
    """A list with the field that counts it, which is at an offset in the image."""
    stated, measure = count.field.measures, count.measure
    if stated is None or measure is None:
        bits = bit_presence(count.field, 1)
        return replace(_with_number_at(inner, count, offset), presence=bits, sent_plus=bits.plus)
    inner = replace(_with_number_at(inner, count, offset), sent_plus=stated.plus if count.counts_sent else None)
    return replace(inner, unit=measure.unit(inner.element), plus=measure.plus)


def _with_number_at(inner: InnerList, count: FieldLayout, offset: int) -> InnerList:
    """A list with the field that says how many elements it has, which is at an offset in the image."""
    return replace(inner, count=count.name, count_at=offset, count_size=count.size, count_order=count.count_order)
