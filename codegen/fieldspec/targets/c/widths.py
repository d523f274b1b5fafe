"""Records whose values vary in width: functions around the functions of their image, in which each value has all its
bytes.
"""

from __future__ import annotations

from fieldspec.codec.layout.record import RecordLayout
from fieldspec.language.model.digits import has_sign
from fieldspec.targets.c.declarations import Source
from fieldspec.targets.c.fields import words_around_images
from fieldspec.targets.c.naming import Naming

_FORMS = {"": 1, "decimal": 0, "upper_hex": 0x41, "lower_hex": 0x61}
_NO_END = 0x100

_ENCODE = """static inline {status} {encode}({argument}uint8_t *out, size_t capacity, size_t *length)
{{
{widths}
    uint8_t image[{size}];
    size_t image_length;
    {status} status = {encode_image}({passed}image, sizeof image, &image_length);
    if (status != {ok}) {{
        return status;
    }}
    return {narrow}(widths, {count}u, image, out, capacity, length);
}}
"""
_DECODE = """static inline {status} {decode}(const uint8_t *in, size_t length{result})
{{
{widths}
    uint8_t image[{size}];
    {status} status = {widen}(widths, {count}u, in, length, image);
    if (status != {ok}) {{
        return status;
    }}
    return {decode_image}(image, sizeof image{returned});
}}
"""


def encode_widths(naming: Naming, record: RecordLayout) -> Source:
    """`codec_status line_encode(const line *in, uint8_t *out, size_t capacity, size_t *length)`"""
    return Source(_ENCODE.format(**_words(naming, record)))


def decode_widths(naming: Naming, record: RecordLayout) -> Source:
    """`codec_status line_decode(const uint8_t *in, size_t length, line *out)`"""
    return Source(_DECODE.format(**_words(naming, record)))


def _words(naming: Naming, record: RecordLayout) -> dict[str, str]:
    """The names and numbers in both functions."""
    rows = ",\n".join(f"        {_span_row(record, number)}" for number in range(len(record.spans)))
    return {
        **words_around_images(naming, record),
        "narrow": naming.own("narrow_fields"),
        "widen": naming.own("widen_fields"),
        "widths": f"    static const {naming.own('width')} widths[] = {{\n{rows},\n    }};",
        "size": f"{sum(span.size for span in record.spans)}u",
        "count": str(len(record.spans)),
    }


def _span_row(record: RecordLayout, number: int) -> str:
    """`{9u, 8u, 0x2Cu, 0x00u, 2u, true, 0u, 0u, 0u, 0u, 0u}`: see the struct."""
    span = record.spans[number]
    value, partner = span.value, _partner(record, number)
    if value is None:
        return f"{{{span.size}u, 0u, 0x100u, 0x00u, 0u, false, {partner}}}"
    end = _NO_END if span.end is None else span.end
    sign = "true" if has_sign(value) else "false"
    form = f"0x{_FORMS[value.digits]:02X}u"
    return f"{{{span.size}u, {value.width}u, 0x{end:02X}u, {form}, {value.places}u, {sign}, {partner}}}"


def _partner(record: RecordLayout, number: int) -> str:
    """The text that a field counts, or the field that counts a text: its place in the image and its bytes there."""
    texts = ((other, span.count) for other, span in enumerate(record.spans) if span.count is not None)
    pair = next(((text, count) for text, count in texts if number in (text, count)), None)
    if pair is None:
        return "0u, 0u, 0u, 0u, 0u"
    text, count = pair
    other = text if number == count else count
    offset = sum(span.size for span in record.spans[:other])
    sizes = f"{record.spans[other].size}u, {record.spans[count].size}u"
    return f"{offset}u, {sizes}, {record.spans[text].plus}u, {count_form(record.spans[text].order)}"


def count_form(order: str) -> str:
    """The form of a number that counts others, as the runtime has it; by its order, or the form of its digits."""
    return {"big": "0u", "little": "1u", "decimal": "10u"}.get(order) or f"0x{_FORMS[order]:02X}u"
