"""Records whose values vary in width: their table, and the functions that write them through an image."""

from __future__ import annotations

import json

from fieldspec.codec.layout.record import RecordLayout
from fieldspec.codec.layout.widths import Span, span_data


def width_table(record: RecordLayout, name: str) -> list[str]:
    """The fields of a record whose values vary in width; nothing for others."""
    if not record.spans:
        return []
    return [f"const widths{name} = [", *(f"  {_span_row(span)}," for span in record.spans), "];"]


def write_widths(record: RecordLayout, name: str) -> list[str]:
    """The functions that write a value and count its bytes."""
    size = sum(span.size for span in record.spans)
    return [
        f"function narrow{name}(value) {{",
        f"  const image = new Uint8Array({size});",
        f"  writeImage{name}(value, image, 0);",
        f"  return narrowedImage(widths{name}, image);",
        "}",
        f"function size{name}(value) {{",
        f"  return narrow{name}(value).length;",
        "}",
        f"function write{name}(value, b, o) {{",
        f"  b.set(narrow{name}(value), o);",
        "}",
    ]


def _span_row(span: Span) -> str:
    """`{ name: "weight", size: 9, most: 8, form: "decimal", end: 44 }`"""
    parts = [f"{key}: {json.dumps(value)}" for key, value in span_data(span).items()]
    return f"{{ {', '.join(parts)} }}"
