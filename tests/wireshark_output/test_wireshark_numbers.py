"""tshark shows whole numbers of every size, sign and order as Python reads their bytes."""

from __future__ import annotations

import struct
from typing import NamedTuple

from fieldspec.codec.layout.device import DeviceLayout
from layouts import SPECS, layout_at
from number_bits import HALVES, magnitude
from spec_files import gadget
from wireshark_output.dissection import FIRST_PORT, Packet, dissected, port_options

FRAME = "[{name: code, role: code, type: u8}, {name: body, role: body}]"
SPEC = """
uses: [{{protocol: modbus, links: [tcp], messages: [read_registers]}}]
links:
  - {{name: tcp, source: 1 L1, word_order: big, unit_addresses: {{range: 1..247, source: 1 L1}}}}
  - {{name: line, transmission: binary, byte_order: big, source: 1 L1, request: {frame}, response: {frame}}}
messages:
  - {{name: read_registers, source: 1 L2, links: [tcp]}}
  - {{name: big, code: 1, links: [line], source: 1 L2, request: [{big}], response: []}}
  - {{name: word, code: 3, links: [line], source: 1 L2, request: [{{name: s, type: u64, flags: state}}], response: []}}
  - {{name: halves, code: 4, links: [line], source: 1 L2, response: [],
      request: [{{name: half, type: f16}}, {{name: turned, type: f16, byte_order: little}}]}}
  - {{name: little, code: 2, links: [line], source: 1 L2, request: [{little}], response: []}}
enums: [{{name: exception_code, source: 1 L3, members: [{{value: 1, name: illegal_function}}]}}]
flags: [{{name: state, type: u64, source: 1 L4, bits: [{{bit: 0, name: ready}}, {{bit: 63, name: fault}}]}}]
records: [{{name: exception, source: 1 L3, fields: [{{name: exception_code}}]}}]
registers: [{{group: numbers, section: "2", source: L4, rows: [{rows}]}}]
"""
PATTERNS = ("8182838485868788", "0102030405060708", "FFFFFFFFFFFFFFFE")
"""The first bytes of each are a number of any size: one with its most significant bit, one without, one near zero."""

SIGNS = ("u", "i", "sm")
BITS_OF_HALVES = (0x0000, 0x0001, 0x03FF, 0x0400, 0x3C00, 0x3555, 0x7BFF, 0x7C00, 0x8001, 0xC000, 0xFBFF, 0xFC00)


class Number(NamedTuple):
    """A whole number of a size and sign, alone or in a list of two. `order` is that of its bytes, or of its words."""

    size: int
    sign: str
    order: str
    count: int

    @property
    def name(self) -> str:
        return f"{self.sign}{8 * self.size}_{self.order}" + ("s" if self.count > 1 else "")

    def spec(self) -> str:
        words = f", word_order: {self.order}" if self.size in (4, 6, 8) else ""
        return f"name: {self.name}, type: {self.sign}{8 * self.size}{words}" + (", count: 2" if self.count > 1 else "")

    def read(self, data: bytes) -> int:
        return magnitude(data) if self.sign == "sm" else int.from_bytes(data, "big", signed=self.sign == "i")


def in_order(number: Number, data: bytes, unit: int) -> bytes:
    """The bytes of a number as they are sent, where units of some bytes have an order."""
    units = [data[at : at + unit] for at in range(0, len(data), unit)]
    return b"".join(units if number.order == "big" else units[::-1])


def whole_numbers(sizes: range, order: str) -> list[Number]:
    return [Number(size, sign, order, count) for size in sizes for sign in SIGNS for count in (1, 2)]


FIELDS = {order: whole_numbers(range(1, 9), order) for order in ("big", "little")}
REGISTERS = {order: whole_numbers(range(2, 9, 2), order) for order in ("big", "little")}


def layout() -> DeviceLayout:
    fields = {
        order: ", ".join(f"{{{number.spec()}, byte_order: {order}}}" for number in FIELDS[order]) for order in FIELDS
    }
    rows, address = [], 0
    for number in (*REGISTERS["big"], *REGISTERS["little"]):
        rows.append(f"{{at: {address}, {number.spec()}, access: ro}}")
        address += number.count * number.size // 2
    text = SPEC.format(frame=FRAME, rows=", ".join(rows), **fields)
    spec = gadget(text, protocols_modbus=(SPECS / "protocols" / "modbus.yaml").read_text("utf-8"))
    return layout_at(spec, spec.versions()[-1])


def body(numbers: list[Number], pattern: bytes, unit: int) -> bytes:
    return b"".join(in_order(number, pattern[: number.size], unit) * number.count for number in numbers)


def expected(numbers: list[Number], pattern: bytes) -> list[tuple[str, int]]:
    return [(number.name, number.read(pattern[: number.size])) for number in numbers for _ in range(number.count)]


def tcp(pdu: bytes) -> bytes:
    return b"\0\1\0\0" + (len(pdu) + 1).to_bytes(2, "big") + b"\1" + pdu


def test_whole_numbers_of_every_size_and_order_are_shown_in_fields_lists_and_registers() -> None:
    device = layout()
    ports = {("gadget", "line", ""): FIRST_PORT, ("gadget", "tcp", ""): FIRST_PORT + 1}
    packets, wanted = [], []
    for client, pattern in enumerate(map(bytes.fromhex, PATTERNS), 20000):
        for code, order in enumerate(FIELDS, 1):
            frame = bytes([code]) + body(FIELDS[order], pattern, 1)
            packets.append(Packet(client, FIRST_PORT, "request", frame))
            wanted.append(expected(FIELDS[order], pattern))
        address = 0
        for numbers in REGISTERS.values():
            data = body(numbers, pattern, 2)
            asked = tcp(b"\3" + struct.pack(">HH", address, len(data) // 2))
            packets.append(Packet(client, FIRST_PORT + 1, "request", asked))
            wanted.append([])
            packets.append(Packet(client, FIRST_PORT + 1, "response", tcp(bytes([3, len(data)]) + data)))
            wanted.append(expected(numbers, pattern))
            address += len(data) // 2
    dissections = dissected([device], packets, port_options(device, ports))
    names = {number.name for number in (*FIELDS["big"], *FIELDS["little"])}
    for items, numbers in zip(dissections, wanted, strict=True):
        rows = [(item.name.rpartition(".")[2].rstrip("_"), item) for item in items]
        assert [(name, int(item.value, 0)) for name, item in rows if name in names and item.size] == numbers


def test_a_word_of_64_bits_is_shown_with_all_its_digits() -> None:
    device, port = layout(), ("gadget", "line", "")
    packet = Packet(20000, FIRST_PORT, "request", bytes.fromhex("03 8000000000000001"))
    (items,) = dissected([device], [packet], port_options(device, {port: FIRST_PORT}))
    assert "S: 0x8000000000000001" in [item.line for item in items]


def test_halves_are_shown_as_struct_reads_them() -> None:
    device, port = layout(), ("gadget", "line", "")
    halves = [bits.to_bytes(2, "big") for bits in BITS_OF_HALVES]
    packets = [Packet(20000, FIRST_PORT, "request", b"\4" + half + half[::-1]) for half in halves]
    dissections = dissected([device], packets, port_options(device, {port: FIRST_PORT}))
    halves_of = [
        [float(item.value) for item in items if item.name.endswith((".half", ".turned"))] for items in dissections
    ]
    assert halves_of == [[float(f"{HALVES[bits]:.6g}")] * 2 for bits in BITS_OF_HALVES]
