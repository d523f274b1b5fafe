"""The layouts of records, from their fields in the order of the wire and the layouts of the records in them."""

from __future__ import annotations

from collections.abc import Mapping

from fieldspec.codec.layout.continuation import Continuation
from fieldspec.codec.layout.list_places import inner_lists_of
from fieldspec.codec.layout.presence import PresenceLayout, masked, presence_layout
from fieldspec.codec.layout.record import CaseLayout, FieldLayout, Orders, RecordLayout
from fieldspec.codec.layout.widths import Span
from fieldspec.foundation.classes import TYPE_CHECKING, replace
from fieldspec.language.model.counts import bit_count, text_count
from fieldspec.language.model.device import Device
from fieldspec.language.model.enums import Enum
from fieldspec.language.model.record import Choice, Field, Record
from fieldspec.language.model.stated_bits import legal_numbers, stated_bits

if TYPE_CHECKING:
    from typing import Literal


def record_layout(
    record: Record, records: Mapping[str, RecordLayout], orders: Orders, device: Device, is_part: bool
) -> RecordLayout:
    """The layout of a record, which may be part of others. `records` are the layouts of the records in it."""
    last = record.fields[-1] if record.fields else None
    if last is None or last.choice is None:
        return _fixed(record, records, orders, device)
    is_behind = any(_varies(own, records) or (own.value and own.value.width) for own in record.fields[:-1])
    is_inside = is_part or is_behind or last.choice.bits is not None
    if last.choice.has_widths or (is_inside and not last.is_list):
        return _fixed(record, records, orders, device)
    return _choosing(record, last, last.choice, records, orders, device)


def _varies(field: Field, records: Mapping[str, RecordLayout]) -> bool:
    """Whether the bytes of a field, or of its content, differ from data to data."""
    if field.record and records[field.record].size is None:
        return True
    return field.repeat is not None or field.choice is not None or _is_packed(field)


def has_spans(record: Record, has_lists: bool) -> bool:
    """Whether the bytes after values that vary in width may show where these end, or each of them is counted by a whole
    field in a record without lists.
    """
    widths = [field for field in record.fields if field.value is not None and field.value.width]
    is_open = any(text_count(record, field) is None for field in widths)
    return is_open or not (has_lists or any(bit_count(record, field.name) for field in widths))


def _is_never_open(field: Field) -> bool:
    """Whether the end of the data does not end a field, even if that comes last."""
    return field.choice is not None or field.continuation is not None or _is_packed(field)


def _is_packed(field: Field) -> bool:
    return field.value is not None and field.value.packed_bits > 0


def _case_layouts(record: Record, choice: Choice, orders: Orders, device: Device) -> tuple[CaseLayout, ...]:
    enum = device.enums[choice.enum_of(record.named(choice.by), device.flags)]
    shift = choice.bits[0] if choice.bits is not None else 0
    return tuple(
        CaseLayout(
            case,
            case.name,
            frozenset(member.value << shift for name in case.when if (member := enum.named(name)) is not None),
            case.value,
            *orders.of(case.value),
        )
        for case in choice.cases
    )


def _with_all_bits(choice: Choice, case: CaseLayout) -> CaseLayout:
    """A case with all numbers of the byte some of whose bits decide it."""
    if choice.mask is None:
        return case
    return replace(case, numbers=frozenset(n for n in range(0x100) if masked(n, choice.mask) in case.numbers))


def _choosing(
    record: Record,
    last: Field,
    choice: Choice,
    records: Mapping[str, RecordLayout],
    orders: Orders,
    device: Device,
) -> RecordLayout:
    """The layout of a record whose last field has cases, with one for each of these."""
    cases = tuple(_with_all_bits(choice, case) for case in _case_layouts(record, choice, orders, device))
    chosen: dict[int, RecordLayout] = {}
    for case in cases:
        decided = replace(last, value=case.value, choice=None)
        record_layout = _fixed(replace(record, fields=(*record.fields[:-1], decided)), records, orders, device)
        chosen |= dict.fromkeys(sorted(case.numbers), record_layout)
    shapes = list(chosen.values())
    first = shapes[0]
    sizes = {shape.size for shape in shapes}
    smallest = min((shape.fields[-1] for shape in shapes), key=lambda field: field.size)
    field = replace(smallest, field=last, value=None, cases=cases)
    bounds = [shape.most for shape in shapes]
    return RecordLayout(
        record,
        record.name,
        (*first.fields[:-1], field),
        sizes.pop() if len(sizes) == 1 else None,
        min(shape.least for shape in shapes),
        None if None in bounds else max(bound for bound in bounds if bound is not None),
        first.named(choice.by),
        chosen,
    )


def _fixed(record: Record, records: Mapping[str, RecordLayout], orders: Orders, device: Device) -> RecordLayout:
    """The layout of a record that is the same for all data, or has an image."""
    offset = 0
    fields: list[FieldLayout] = []
    enums = device.enums
    lists = [field for field in record.fields if _varies(field, records)]
    texts = [] if has_spans(record, bool(lists)) else [own for own in record.fields if own.value and own.value.width]
    differing = {own.name for own in lists if own.choice or (own.record and records[own.record].size is None)}
    differing |= {own.name for own in texts}
    lists = [own for own in record.fields if own in lists or own in texts]
    is_inner = any(field is not record.fields[-1] or _is_never_open(field) for field in lists)
    is_inner |= bool(differing)
    remaining_fields = [field for field in record.fields if field not in lists]
    for field in (*remaining_fields, *lists) if is_inner else record.fields:
        nested = records[field.record] if field.record else None
        cases = _case_layouts(record, field.choice, orders, device) if field.choice is not None else ()
        case_size = max((case.value.image_size for case in cases), default=0)
        size = field.value.size if field.value else (nested.most or 0) if nested else case_size
        count = None if field.repeat else field.count or 1
        order, swapped = orders.of(field.value)
        sizes = _sizes(record, field, enums)
        field_layout = FieldLayout(
            field, field.name, offset, size, count, field.value, nested, order, swapped, cases, sizes
        )
        measures = field.measures
        counts_sent = measures is not None and measures.of == "bytes" and measures.field in differing
        is_text, continuation = field in texts, _continuation(field_layout, enums)
        presence = None if is_text else presence_layout(record, field.name, size, enums)
        field_layout = replace(field_layout, presence=presence, counts_sent=counts_sent, continuation=continuation)
        field_layout = replace(field_layout, in_room=is_text)
        fields.append(_with_forms(field_layout, fields))
        offset += size * (field.repeat.high if field.repeat is not None else count or 1)
    if not texts and any(field.value is not None and field.value.width for field in fields):
        return _varying(record, tuple(fields))
    fixed = sum(field.size * (field.count or 0) for field in fields if field.field not in lists)
    if not lists:
        return RecordLayout(record, record.name, tuple(fields), fixed, fixed, fixed)
    varying = [field for field in fields if field.field in lists]
    minimum = fixed + sum(field.sent_bounds[0] for field in varying)
    maximum = fixed + sum(field.sent_bounds[1] for field in varying)
    layout = RecordLayout(record, record.name, tuple(fields), None, minimum, maximum)
    return replace(layout, inner_lists=inner_lists_of(layout)) if is_inner else layout


def _continuation(field: FieldLayout, enums: Mapping[str, Enum]) -> Continuation | None:
    """The bits of each element that say whether another one follows; None for other fields."""
    continuation = field.field.continuation
    decider = field.record.named(continuation.by) if continuation is not None and field.record is not None else field
    if continuation is None or decider is None or decider.value is None:
        return None
    presence = PresenceLayout(continuation.by, *stated_bits(continuation, decider.value, enums))
    offset = decider.offset if field.record is not None else 0
    order: Literal["big", "little"] = "big" if decider.order == "big" else "little"
    is_free = bool(continuation.bits) and not decider.value.enum and decider.value.writable_ranges is None
    legal = None if is_free else legal_numbers(continuation, decider.value, enums)
    return Continuation(presence, offset, decider.size, order, legal)


def _with_forms(field: FieldLayout, before: list[FieldLayout]) -> FieldLayout:
    """A field with its form in each case; `before` are the fields before it in the image."""
    choice = field.field.choice
    if choice is None:
        return field
    forms: dict[int, FieldLayout] = {}
    for case in field.cases:
        decided = replace(field.field, value=case.value, choice=None)
        form = replace(field, field=decided, size=case.value.image_size, value=case.value, order=case.order, cases=())
        forms |= dict.fromkeys(sorted(case.numbers), replace(form, swapped=case.swapped))
    return replace(field, forms=forms, selector=next(other for other in before if other.name == choice.by))


def _sizes(record: Record, field: Field, enums: Mapping[str, Enum]) -> Mapping[int, int]:
    """The numbers of bytes that are the value of a parameter, by the numbers of the field that says so."""
    part = field.value.parameter if field.value is not None else None
    selector = record.named(part.sizes.by) if part is not None and part.sizes is not None else None
    enum = enums.get(selector.value.enum) if selector is not None and selector.value is not None else None
    if part is None or part.sizes is None or enum is None:
        return {}
    members = ((enum.named(name), case.bytes) for case in part.sizes.cases for name in case.when)
    return {member.value: size for member, size in members if member is not None}


def _varying(record: Record, fields: tuple[FieldLayout, ...]) -> RecordLayout:
    """The layout of a record of which some fields vary in width."""
    spans = []
    for field, following in zip(fields, (*fields[1:], None), strict=True):
        varies = field.value is not None and field.value.width > 0
        count = text_count(record, field.field)
        if count is not None and count.measures is not None:
            number = record.fields.index(count)
            order, plus = fields[number].count_order, count.measures.plus
            spans.append(Span(field.name, field.size, field.value, None, number, order, plus))
            continue
        end = following.value.const if following is not None and following.value is not None else None
        size = field.size * (field.count or 0)
        spans.append(Span(field.name, size, field.value if varies else None, end if varies else None))
    minimum = sum(span.size if span.value is None else span.value.least_width for span in spans)
    maximum = sum(span.size if span.value is None else span.value.width for span in spans)
    return RecordLayout(record, record.name, fields, None, minimum, maximum, spans=tuple(spans))
