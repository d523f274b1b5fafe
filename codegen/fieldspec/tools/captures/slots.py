"""The values of records whose lists come last, each at its place, and the images of records in records."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.inner_lists import InnerList, InnerLists
from fieldspec.codec.layout.list_places import inner_lists_of
from fieldspec.codec.layout.record import FieldLayout, RecordLayout
from fieldspec.codec.layout.widths import extents
from fieldspec.foundation.classes import dataclass, replace


@dataclass(frozen=True, slots=True)
class Slot:
    """A value at a fixed offset in a record, by its path there. `field` is the field that it is, or that it is in.

    In a record that differs in size, it is an element of some lists: `places` are these, each with the offset of the
    record that says how many elements it has and with the number of the element. For a counted text, `text` are its
    bytes as a list.
    It is only in bodies in which the selectors of some fields, with the offsets of their records, have one of some
    `numbers`.
    """

    path: str
    offset: int
    layout: FieldLayout
    field: FieldLayout
    places: tuple[tuple[int, InnerList, int], ...] = ()
    text: InnerList | None = None
    numbers: tuple[tuple[int, FieldLayout, frozenset[int]], ...] = ()


def slots(record: RecordLayout, prefix: str = "", start: int = 0, outer: FieldLayout | None = None) -> Iterator[Slot]:
    """The values of a record and of the records in it, in the order of the wire; a repeated field counts once."""
    is_differing = outer is not None and record.size is None
    by_name = _numbered(inner_lists_of(record, is_element=True)) if is_differing else {}
    for field in record.sent_fields:
        is_list = field.is_list and not (outer is None and field.count is None)
        inner = by_name.get(field.name)
        for index in range(field.count or (inner.most // inner.element if inner is not None else 1)):
            path = f"{prefix}{field.name}[{index}]" if is_list else f"{prefix}{field.name}"
            place = start + field.offset + index * field.size
            if field.record is not None:
                field_slots = slots(field.record, f"{path}.", place, outer or field)
            elif field.selector is not None:
                field_slots = _slots_of_cases(record, field, path, start, outer)
            elif field.in_room:
                field_slots = iter([Slot(path, place, field, outer or field, text=_text_list(record, field))])
                inner = None
            elif inner is not None and field.value is not None and field.value.width:
                count = record.named(inner.count)
                assert count is not None
                text = replace(inner, room=field.offset, count_at=count.offset)
                field_slots = iter([Slot(path, place, field, outer or field, text=text)])
                inner = None
            else:
                field_slots = iter([Slot(path, place, field, outer or field)])
            for slot in field_slots:
                if inner is not None and (inner.count or inner.continuation is not None):
                    slot = replace(slot, places=((start, inner, index), *slot.places))
                yield slot


def _numbered(parts: InnerLists) -> dict[str, InnerList]:
    """The lists of an element by their names, each with the place of its number of elements.

    Where sent bytes are counted, this number comes after all lists, in two bytes.
    """
    numbered = {inner.name: inner for inner in parts.lists}
    end = parts.last.room + parts.last.most
    in_bytes = (inner for inner in parts.lists if inner.sent_plus is not None)
    for index, inner in enumerate(in_bytes):
        numbered[inner.name] = replace(inner, count_at=end + 2 * index, count_size=2, count_order="big")
    return numbered


def _slots_of_cases(
    record: RecordLayout, field: FieldLayout, path: str, start: int, outer: FieldLayout | None
) -> Iterator[Slot]:
    """A slot for each type of a field that another one decides; that one has its place in the image."""
    assert field.selector is not None
    for case in field.cases:
        form = field.forms[min(case.numbers)]
        numbers = ((start, field, case.numbers),)
        is_text = form.varies and form.value is not None and not form.value.is_marked
        text = _text_list(record, field) if is_text else None
        yield Slot(path, start + form.offset, form, outer or field, text=text, numbers=numbers)


def _text_list(record: RecordLayout, field: FieldLayout) -> InnerList:
    """A text whose sent bytes a field of its record counts, or bits, as a list of its bytes."""
    own = next(inner for inner in inner_lists_of(record, is_element=True).lists if inner.name == field.name)
    return replace(own, plus=own.sent_plus or 0)


def with_deep_rooms(record: RecordLayout) -> RecordLayout:
    """The record with room for the images of elements that differ in size, which have packed numbers in whole bytes."""
    if record.inner_lists is None:
        return record
    fields: list[FieldLayout] = []
    offset = 0
    for field in record.fields:
        nested, size = field.record, field.size
        if nested is not None and nested.inner_lists is not None:
            nested = with_deep_rooms(nested)
            parts = inner_lists_of(nested, is_element=True)
            further = 2 * sum(inner.sent_plus is not None for inner in parts.lists)
            size = max(size, parts.last.room + parts.last.most + further)
        forms = {number: replace(form, offset=offset) for number, form in field.forms.items()}
        fields.append(replace(field, record=nested, offset=offset, size=size, forms=forms))
        offset += size * field.bounds[1]
    layout = replace(record, fields=tuple(fields))
    return replace(layout, inner_lists=inner_lists_of(layout))


def deepened(record: RecordLayout, image: bytes) -> bytes:
    """The image of a record in which the elements that differ in size are images, too."""
    result = bytearray(image)
    for field in record.fields:
        if field.record is None or field.record.size is not None:
            continue
        parts, room = inner_lists_of(field.record, is_element=True), record.room_of(field)
        stop = len(image) if room is None else field.offset + (room.room_size_in(image) or 0)
        for place in range(field.offset, min(stop, len(image)), field.size):
            sent_bytes = parts.sent_bytes(image[place : place + field.size])
            element = _element_image(field.record, parts, sent_bytes)
            result[place : place + len(element)] = element
    return bytes(result)


def _element_image(record: RecordLayout, parts: InnerLists, data: bytes) -> bytes:
    """The image of an element that differs in size, from what is sent of it."""
    if record.spans:
        pairs = zip(record.spans, extents(record.spans, data), strict=True)
        return b"".join(data[extent.start : extent.stop].ljust(span.size, b"\0") for span, extent in pairs)
    list_extents, _ = parts.extents_in(data)
    *rooms, last = parts.lists
    image = deepened(replace(record, rooms=tuple(rooms)), parts.image_of(data, list_extents))
    if any(inner.sent_plus is not None for inner in parts.lists):
        image = image.ljust(last.room + last.most, b"\0")
    for inner, extent in zip(parts.lists, list_extents, strict=False):
        if inner.sent_plus is not None:
            image = inner.with_number(image, extent.size + inner.sent_plus) + len(extent.elements).to_bytes(2, "big")
    return image
