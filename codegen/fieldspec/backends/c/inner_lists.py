"""Records with fields behind a list: functions around those of their image, in which the list comes last."""

from __future__ import annotations

from fieldspec.backends.c.declarations import Source
from fieldspec.backends.c.fields import members
from fieldspec.backends.c.naming import Naming
from fieldspec.layout.inner_lists import InnerList
from fieldspec.layout.record import RecordLayout

_ENCODE = """static inline {status} {encode}({argument}uint8_t *out, size_t capacity, size_t *length)
{{
    {status} status = {encode_image}({passed}out, capacity, length);
    if (status == {ok}) {{
        {place}(out, *length, {first}u, {behind}u);
    }}
    return status;
}}
"""
_DECODE = """static inline {status} {decode}(const uint8_t *in, size_t length{result})
{{
    uint8_t image[{size}u];
    if (length > sizeof image) {{
        return {wrong_length};
    }}
    {take}(in, length, {first}u, {behind}u, image);
    return {decode_image}(image, length{returned});
}}
"""


def encode_inner_list(naming: Naming, record: RecordLayout, inner: InnerList) -> Source:
    """`codec_status scan_encode(const scan *in, uint8_t *out, size_t capacity, size_t *length)`"""
    return Source(_ENCODE.format(**_words(naming, record, inner)))


def decode_inner_list(naming: Naming, record: RecordLayout, inner: InnerList) -> Source:
    """`codec_status scan_decode(const uint8_t *in, size_t length, scan *out)`"""
    return Source(_DECODE.format(**_words(naming, record, inner)))


def _words(naming: Naming, record: RecordLayout, inner: InnerList) -> dict[str, str | int | None]:
    """The names and numbers in both functions."""
    struct = naming.type("record", record.name) if members(record) else ""
    verbs = ("encode", "decode", "encode_image", "decode_image")
    return {
        **{verb: naming.function("record", record.name, verb) for verb in verbs},
        "ok": naming.status("ok").name,
        "wrong_length": naming.status("err_wrong_length").name,
        "status": naming.own("codec_status"),
        "place": naming.own("place_list"),
        "take": naming.own("take_list"),
        "argument": f"const {struct} *in, " if struct else "",
        "passed": "in, " if struct else "",
        "result": f", {struct} *out" if struct else "",
        "returned": ", out" if struct else "",
        "size": record.most,
        "first": inner.first,
        "behind": inner.behind,
    }
