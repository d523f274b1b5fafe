"""Records with fields behind lists: functions around those of their image, in which all lists come last."""

from __future__ import annotations

from fieldspec.codec.layout.inner_lists import InnerList, InnerLists
from fieldspec.codec.layout.record import RecordLayout
from fieldspec.targets.c.declarations import Source
from fieldspec.targets.c.fields import words_around_images
from fieldspec.targets.c.naming import Naming

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


def encode_inner_lists(naming: Naming, record: RecordLayout, inner: InnerLists) -> Source:
    """`codec_status scan_encode(const scan *in, uint8_t *out, size_t capacity, size_t *length)`"""
    return Source(_ENCODE.format(**_words(naming, record, inner)))


def decode_inner_lists(naming: Naming, record: RecordLayout, inner: InnerLists) -> Source:
    """`codec_status scan_decode(const uint8_t *in, size_t length, scan *out)`"""
    return Source(_DECODE.format(**_words(naming, record, inner)))


def _words(naming: Naming, record: RecordLayout, inner: InnerLists) -> dict[str, str | int]:
    """The names and numbers in both functions."""
    tails = [
        f"    static const {naming.own('inner_list')} {row.name}_tail = {_inner_list_row(row.tail)};"
        for row in inner.lists
        if row.tail
    ]
    rows = ",\n".join(f"        {_inner_list_row(row)}" for row in inner.lists)
    declared = f"    static const {naming.own('inner_list')} lists[] = {{\n{rows},\n    }};"
    return {
        **words_around_images(naming, record),
        "place": naming.own("place_lists"),
        "take": naming.own("take_lists"),
        "lists": "\n".join([*tails, declared]),
        "count": len(inner.lists),
        "size": inner.last.room + inner.last.most,
        "fixed": inner.fixed,
    }


def _inner_list_row(inner: InnerList) -> str:
    """`{2u, 7u, 2u, 0u, 8u, 1u, 1u, 2u, 0L, false, NULL}`: see the struct."""
    numbers = (inner.first, inner.room, inner.element, inner.least, inner.most)
    count = (inner.count_at, inner.count_size if inner.count else 0, inner.unit)
    is_little = "true" if inner.count_order == "little" else "false"
    tail = f"&{inner.name}_tail" if inner.tail is not None else "NULL"
    return f"{{{', '.join(f'{number}u' for number in (*numbers, *count))}, {inner.plus}L, {is_little}, {tail}}}"
