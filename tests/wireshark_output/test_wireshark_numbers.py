"""tshark shows whole numbers of every size, sign and order as Python reads their bytes."""

from __future__ import annotations

from typing import NamedTuple

from fieldspec.codec.layout.device import DeviceLayout
from layouts import SPECS, layout_at
from spec_files import gadget
from wireshark_output.dissection import FIRST_PORT, Packet, dissected, port_options

FRAME = "[{name: code, role: code, type: u8}, {name: body, role: body}]"
SPEC = """
uses: [{{protocol: modbus, links: [tcp], messages: [read_registers]}}]
links:
  - {{name: tcp, source: 1 L1, word_order: big, unit_addresses: {{range: 1..247, source: 1 L1}}}}
  - {{name: line, encoding: binary, byte_order: big, source: 1 L1, request: {frame}, response: {frame}}}
messages:
  - {{name: read_registers, source: 1 L2, links: [tcp]}}
  - {{name: big, code: 1, links: [line], source: 1 L2, request: [{big}], response: []}}
  - {{name: word, code: 3, links: [line], source: 1 L2, request: [{{name: s, type: u64, flags: state}}], response: []}}
  - {{name: little, code: 2, links: [line], source: 1 L2, request: [{little}], response: []}}
enums: [{{name: exception_code, source: 1 L3, members: [{{value: 1, name: illegal_function}}]}}]
flags: [{{name: state, type: u64, source: 1 L4, bits: [{{bit: 0, name: ready}}, {{bit: 63, name: fault}}]}}]
records: [{{name: exception, source: 1 L3, fields: [{{name: exception_code}}]}}]
registers: [{{group: numbers, section: "2", source: L4, rows: [{rows}]}}]
"""
PATTERNS = ("8182838485868788", "0102030405060708", "FFFFFFFFFFFFFFFE")
"""The first bytes of each are a number of any size: one with its most significant bit, one without, one near zero."""


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
        return int.from_bytes(data, "big", signed=self.sign == "i")


def in_order(number: Number, data: bytes, unit: int) -> bytes:
    """The bytes of a number as they are sent, where units of some bytes have an order."""
    units = [data[at : at + unit] for at in range(0, len(data), unit)]
    return b"".join(units if number.order == "big" else units[::-1])


def whole_numbers(sizes: range, *orders: str) -> list[Number]:
    return [Number(size, sign, order, count) for order in orders for size in sizes for sign in "ui" for count in (1, 2)]


FIELDS = {order: whole_numbers(range(1, 9), order) for order in ("big", "little")}
REGISTERS = whole_numbers(range(2, 9, 2), "big", "little")


def layout() -> DeviceLayout:
    fields = {
        order: ", ".join(f"{{{number.spec()}, byte_order: {order}}}" for number in FIELDS[order]) for order in FIELDS
    }
    rows, address = [], 0
    for number in REGISTERS:
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
        data = body(REGISTERS, pattern, 2)
        asked = tcp(b"\3\0\0" + (len(data) // 2).to_bytes(2, "big"))
        packets.append(Packet(client, FIRST_PORT + 1, "request", asked))
        wanted.append([])
        packets.append(Packet(client, FIRST_PORT + 1, "response", tcp(bytes([3, len(data)]) + data)))
        wanted.append(expected(REGISTERS, pattern))
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
