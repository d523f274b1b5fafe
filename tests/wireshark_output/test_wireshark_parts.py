"""tshark reads the parts of frames in any number of bytes: lengths, stations, constants, and marks of exceptions."""

from __future__ import annotations

from typing import Literal

import pytest

from fieldspec.codec.layout.device import DeviceLayout
from layouts import layout_at
from spec_files import gadget
from wireshark_output.dissection import FIRST_PORT, Item, Packet, dissected, port_options

MOST = 32
"""The bits of a station and of a length; other parts may have more."""

PARTS = """[
      {{name: mark, type: u{bits}, const: 0x{const:X}}}, {{name: station, role: unit_address, type: u{less}}},
      {{name: length, role: length, type: u{less}}}, {{name: state, type: i{bits}}},
      {{name: code, role: code, type: u8}}, {{name: body, role: body}}]"""
SPEC = f"""
links:
  - name: line
    source: 1 L1
    transmission: binary
    byte_order: {{order}}
    request: {PARTS}
    response: {PARTS}
    unit_addresses: {{{{range: 1..9, broadcast: 0, source: 1 L1}}}}
    exception_response: {{{{part: state, normal: "{{least}}..{{least_but_one}}, 0", record: refusal, source: 1 L1}}}}
messages:
  - {{{{name: go, code: 1, source: 1 L2, request: [{{{{name: w, type: u8}}}}], response: [{{{{name: x, type: u8}}}}]}}}}
records: [{{{{name: refusal, source: 1 L3, fields: [{{{{name: reason, type: u16}}}}]}}}}]
"""


def layout(bits: int, order: str) -> DeviceLayout:
    const, least = (1 << bits) - 2, -(1 << (bits - 1))
    numbers = {"bits": bits, "less": min(bits, MOST), "const": const, "least": least, "least_but_one": least + 1}
    spec = gadget(SPEC.format(order=order, **numbers))
    return layout_at(spec, spec.versions()[-1])


def frame(bits: int, order: str, body: str, station: int = 5, state: int = 0, wrong: int = 0) -> bytes:
    data, size, less = bytes.fromhex(body), bits // 8, min(bits, MOST) // 8
    numbers = (((1 << bits) - 2, size), (station, less), (2 * size + 2 * less + 1 + len(data) + wrong, less))
    byte_order: Literal["big", "little"] = "big" if order == "big" else "little"
    head = b"".join(number.to_bytes(width, byte_order) for number, width in numbers)
    return head + state.to_bytes(size, byte_order, signed=True) + b"\1" + data


def findings(items: list[Item]) -> list[str]:
    names = [item.name.rpartition(".expert.")[2] for item in items if ".expert." in item.name]
    return [name for name in names if name not in ("message", "severity", "group")]


@pytest.mark.proof(5)
@pytest.mark.parametrize("order", ["big", "little"])
@pytest.mark.parametrize("bits", [24, 32, 40, 48, 56, 64])
def test_parts_of_any_number_of_bytes_are_read_and_judged(bits: int, order: str) -> None:
    device = layout(bits, order)
    rows = [
        ("request", frame(bits, order, "07"), []),
        ("response", frame(bits, order, "07"), []),
        ("request", frame(bits, order, "07", station=0), []),
        ("request", frame(bits, order, "07", station=(1 << min(bits, MOST)) - 1), ["out_of_range"]),
        ("request", frame(bits, order, "07"), []),
        ("response", frame(bits, order, "0102", state=1), ["exception"]),
        ("request", frame(bits, order, "07"), []),
        ("response", frame(bits, order, "01", state=-(1 << (bits - 1)) + 1), []),
        ("request", frame(bits, order, "07", wrong=1 << (min(bits, MOST) - 1)), ["wrong_length"]),
    ]
    packets = [
        Packet(20000 + number // 2, FIRST_PORT, direction, data) for number, (direction, data, _) in enumerate(rows)
    ]
    dissections = dissected([device], packets, port_options(device, {("gadget", "line", ""): FIRST_PORT}))
    assert [findings(items) for items in dissections] == [wanted for _, _, wanted in rows]
    station = next(item for item in dissections[3] if item.name.endswith(".station"))
    assert int(station.value, 0) == (1 << min(bits, MOST)) - 1
    assert "all stations" in next(item.line for item in dissections[2] if item.name.endswith(".station"))
