"""Queries read halves as `struct` does, and the highest bit of a magnitude as its sign, in every width and order."""

from __future__ import annotations

import math

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from layouts import layout_at
from number_bits import HALVES, magnitude
from queries_output.engines import ENGINES, engine_of
from spec_files import gadget

WIDTHS = range(1, 9)
ORDERS = ("big", "little")
PATTERNS = ("0000000000000000", "8000000000000000", "8182838485868788", "0102030405060708", "FFFFFFFFFFFFFFFF")
SPEC = """
records:
  - {{name: halves, source: 1 L1, fields: [{{name: number, type: f16, byte_order: big}},
      {{name: turned, type: f16, byte_order: little}}, {{name: series, type: f16, byte_order: big, repeat: 0..9}}]}}
  - {{name: wholes, source: 1 L2, fields: [{fields}]}}
"""


def layout() -> DeviceLayout:
    fields = [
        f"{{name: {order}_{8 * width}, type: sm{8 * width}{f', byte_order: {order}' if width > 1 else ''}}}"
        for width in WIDTHS
        for order in ORDERS
    ]
    spec = gadget(SPEC.format(fields=", ".join(fields)))
    return layout_at(spec, spec.versions()[-1])


def number_text(number: float) -> str:
    """A number as text: any NaN is the same, and zeros differ by their sign."""
    return "nan" if math.isnan(number) else repr(float(number))


@pytest.mark.parametrize("engine", ENGINES)
def test_all_halves_have_the_numbers_of_struct_alone_and_in_lists(engine: str) -> None:
    data = [bits.to_bytes(2, "big") for bits in range(1 << 16)]
    payloads = [own + own[::-1] + 2 * own for own in data]
    rows = engine_of(engine, layout()).rows("halves", {"payload": payloads})
    read = [[number_text(number) for number in (row["number"], row["turned"], *row["series"])] for row in rows]
    assert read == [[number_text(number)] * 4 for number in HALVES]


@pytest.mark.parametrize("engine", ENGINES)
def test_the_highest_bit_is_the_sign_in_every_width_and_order(engine: str) -> None:
    patterns = list(map(bytes.fromhex, PATTERNS))
    payloads = [b"".join(own[:width][::step] for width in WIDTHS for step in (1, -1)) for own in patterns]
    rows = engine_of(engine, layout()).rows("wholes", {"payload": payloads})
    columns = [(f"{order}_{8 * width}", width) for width in WIDTHS for order in ORDERS]
    for row, own in zip(rows, patterns, strict=True):
        assert {name: row[name] for name, _ in columns} == {name: magnitude(own[:width]) for name, width in columns}
