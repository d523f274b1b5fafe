"""Separators that are stated once are the constants between the fields of each version."""

from __future__ import annotations

import re

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.codec.reference import CodecError, codec
from fieldspec.targets import OUTPUTS
from layouts import TEST_SPECS, layout_at, newest
from python_package import codec_error, link_of, module_of
from spec_files import gadget

COURIER = newest(TEST_SPECS, "courier")
LINES = link_of(module_of(COURIER), "inquiries")

DEVICE = """
versions:
  - {line: firmware, members: [{id: "1.0", source: 1 L1}, {id: "2.0", source: 1 L1}]}
links:
  - name: line
    source: 1 L2
    byte_order: big
    request: [{name: code, role: code, type: u8}, {name: body, role: body}]
    response: [{name: code, role: code, type: u8}, {name: body, role: body}]
messages:
  - name: read
    code: 0x52
    source: 1 L3
    separator: "SEPARATOR"
    request: []
    response:
      - {name: first, type: u8, until: "1.0"}
      - {name: second, type: u16, digits: decimal, length: 4, varies: true}
      - {name: third, type: u8, digits: decimal, length: 2, since: "2.0"}
"""

SENT = {
    ("2C", "1.0"): b"R\x07,345",
    ("2C", "2.0"): b"R345,09",
    ("2C 20", "1.0"): b"R\x07, 345",
    ("3B 20 09 2F", "2.0"): b"R345; \t/09",
}
"""What a device sends by its separator and its version."""


def device(separator: str, version: str) -> DeviceLayout:
    return layout_at(gadget(DEVICE.replace("SEPARATOR", separator)), version)


@pytest.mark.parametrize(("separator", "version"), SENT)
def test_a_separator_is_between_each_two_fields_of_a_version(separator: str, version: str) -> None:
    link = codec(device(separator, version)).links["line"]
    frame = SENT[separator, version]
    values = {"first": 7, "second": 345} if version == "1.0" else {"second": 345, "third": 9}
    assert link.encode("response", "read", values) == frame
    read = link.decode(frame, "response").values
    assert {name: number for name, number in read.items() if not name.startswith("separator")} == values


def test_a_line_with_another_separator_is_refused_at_its_byte() -> None:
    frame = next(example.frame for example in COURIER.device.examples.values() if example.id == "rated")
    damaged = frame.replace(b" 5000 4000", b" 5000\t4000")
    with pytest.raises(codec_error()) as refused:
        LINES.decode_response(damaged, LINES.decode_request(b"QPIRI\xf8T\r").message)
    with pytest.raises(CodecError) as expected:
        codec(COURIER).links["inquiries"].decode(damaged, "response", "read_ratings")
    assert refused.value.reason == expected.value.reason


@pytest.mark.parametrize("page", ["courier/1.md", "courier/1.html"])
def test_pages_have_a_separator_once_and_no_row_for_each(page: str) -> None:
    text = re.sub(r"<[^>]+>|`", "", OUTPUTS["docs"].files([COURIER])[page])
    fields = text[text.index("Response on Lines of values") :]
    assert "separator_after" not in fields[: fields.index("Examples")]
    assert len(re.findall(r"(?<!C )20 between each two fields", text)) == 2
