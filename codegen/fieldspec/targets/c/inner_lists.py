"""Records with fields after lists: functions around the functions of their image, in which all lists come last."""

from __future__ import annotations

from fieldspec.codec.layout.inner_lists import InnerList, InnerLists
from fieldspec.codec.layout.list_places import inner_lists_of
from fieldspec.codec.layout.record import CaseLayout, RecordLayout
from fieldspec.targets.c.declarations import BLANK, Declaration, Function, Source, comment
from fieldspec.targets.c.expressions import INPUT_BYTES, SIZE_TYPE, Identifier
from fieldspec.targets.c.fields import deciding, decoded_selector, select, words_around_images
from fieldspec.targets.c.literals import unsigned
from fieldspec.targets.c.naming import Naming
from fieldspec.targets.c.presences import follows, present_sizes
from fieldspec.targets.c.statements import Body, Return, Variable, discard
from fieldspec.targets.c.widths import count_form

_ENCODE = """static inline {status} {encode}({argument}uint8_t *out, size_t capacity, size_t *length)
{{
{lists}
    uint8_t image[{size}u];
    size_t image_length;
    {status} status = {encode_image}({passed}image, sizeof image, &image_length);
    if (status != {ok}) {{
        return status;
    }}
    return {place}(lists, {count}u, {fixed}u, image, image_length, out, capacity, length);
}}
"""
_DECODE = """static inline {status} {decode}(const uint8_t *in, size_t length{result})
{{
{lists}
    uint8_t image[{size}u];
    size_t image_length;
    {status} status = {take}(lists, {count}u, {fixed}u, in, length, image, &image_length);
    if (status != {ok}) {{
        return status;
    }}
    return {decode_image}(image, image_length{returned});
}}
"""

_SENT_SIZE = """/** The bytes of {struct} in front of others; `left` as in {measure}. */
static inline size_t {sent_size}(const uint8_t *in, size_t left)
{{
{lists}
    uint8_t fields[{room}u];
    return {measure}(lists, {count}u, {fixed}u, fields, in, left);
}}
"""


def sent_size(naming: Naming, record: RecordLayout) -> list[Declaration]:
    """`size_t tag_sent_size(const uint8_t *in, size_t left)`: what tells the size of a record that differs in size.

    Where the record has no image, whose functions declare the sizes of optional fields, these come before it.
    """
    inner = inner_lists_of(record, is_element=True)
    names = {
        "struct": naming.type("record", record.name),
        "sent_size": naming.function("record", record.name, "sent_size"),
        "measure": naming.own("sent_size"),
        "room": str(max(inner.fixed, 1)),
    }
    sizes = present_sizes(naming, record) if record.image is record else []
    return [*sizes, BLANK, Source(_SENT_SIZE.format(**names, **_table(naming, record, inner)))]


def encode_inner_lists(naming: Naming, record: RecordLayout, inner: InnerLists) -> Source:
    """`codec_status scan_encode(const scan *in, uint8_t *out, size_t capacity, size_t *length)`"""
    return Source(_ENCODE.format(**_words(naming, record, inner)))


def decode_inner_lists(naming: Naming, record: RecordLayout, inner: InnerLists) -> Source:
    """`codec_status scan_decode(const uint8_t *in, size_t length, scan *out)`"""
    return Source(_DECODE.format(**_words(naming, record, inner)))


def _words(naming: Naming, record: RecordLayout, inner: InnerLists) -> dict[str, str | int]:
    """The names and numbers in both functions."""
    return {
        **words_around_images(naming, record),
        "place": naming.own("place_lists"),
        "take": naming.own("take_lists"),
        "size": inner.last.room + inner.last.most,
        **_table(naming, record, inner),
    }


def _table(naming: Naming, record: RecordLayout, inner: InnerLists) -> dict[str, str | int]:
    """The table of the lists of a record, how many there are, and the bytes of all other fields."""
    rows = ",\n".join(f"        {_inner_list_row(naming, record, row)}" for row in inner.lists)
    declared = f"    static const {naming.own('inner_list')} lists[] = {{\n{rows},\n    }};"
    return {"lists": declared, "count": len(inner.lists), "fixed": inner.fixed}


def _inner_list_row(naming: Naming, record: RecordLayout, inner: InnerList) -> str:
    """The row of a list; see the struct.

    `{2u, 7u, 2u, 0u, 8u, 1u, 1u, 2u, 0L, 0u, 0u, NULL, NULL, NULL, 0u, false, false, false, 0L}`
    """
    numbers = (inner.first, inner.room, inner.element, inner.least, inner.most)
    is_optional = inner.presence is not None and bool(inner.presence.numbers)
    has_count = inner.count and not is_optional
    mask = inner.presence.mask if inner.presence is not None and has_count else 0
    count = (inner.count_at, inner.count_size if has_count else 0, inner.unit)
    field = record.named(inner.name)
    element = field.record if field is not None and inner.parts is not None and inner.parts.lists else None
    measure = naming.function("record", element.name, "sent_size") if element is not None else "NULL"
    tell = follows(naming, record, field) if field is not None and inner.continuation is not None else "NULL"
    decide = "NULL"
    if inner.decision is not None or is_optional:
        decide = naming.function("record", record.name, f"{inner.name}_decided_size")
    places = ", ".join(f"{number}u" for number in (*numbers, *count))
    packing = "0u, false, false"
    if inner.packing is not None:
        is_low_first, is_signed = inner.packing.order == "little", inner.packing.number.sign.is_signed
        packing = f"{inner.packing.number.bits}u, {str(is_low_first).lower()}, {str(is_signed).lower()}"
    form = count_form(inner.count_order)
    byte_count = "false, 0L" if inner.sent_plus is None else f"true, {inner.sent_plus}L"
    return f"{{{places}, {inner.plus}L, {form}, {mask}u, {measure}, {decide}, {tell}, {packing}, {byte_count}}}"


def decided_sizes(naming: Naming, record: RecordLayout) -> list[Declaration]:
    """`size_t tag_value_decided_size(const uint8_t *in)`, for each field of a record whose type another one decides."""
    functions: list[Declaration] = []
    for field in record.fields:
        name = naming.function("record", record.name, f"{field.name}_decided_size")
        if field.in_room:
            size = Identifier(naming.own_macro("text_of")) + unsigned(field.size)
            body: Body = (discard("in"), Return(size))
            text = f"The most bytes of {field.name}, a text."
            functions += [BLANK, comment(text), Function(SIZE_TYPE, name, (Variable(INPUT_BYTES, "in"),), body)]
        if field.selector is None:
            continue
        cases: dict[tuple[int, str], list[CaseLayout]] = {}
        for case in field.cases:
            kind = "bytes_of" if case.value.is_marked else "text_of" if case.value.width else ""
            cases.setdefault((case.value.size, kind), []).append(case)
        branches = [
            (own, (Return(Identifier(naming.own_macro(kind)) + unsigned(size) if kind else unsigned(size)),))
            for (size, kind), own in cases.items()
        ]
        number = deciding(field, decoded_selector(naming, field.selector))
        unknown = (Return(Identifier("SIZE_MAX")),)
        text = f"The bytes of {field.name}, which {field.selector.name} decides; SIZE_MAX where that decides nothing."
        body = (select(field.selector, number, branches, unknown),)
        functions += [BLANK, comment(text), Function(SIZE_TYPE, name, (Variable(INPUT_BYTES, "in"),), body)]
    return functions
