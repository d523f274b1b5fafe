"""A made-up device of ten input registers: ten numbers, or five states and five words of bits, which all have names."""

from __future__ import annotations

HEAD = """\
device:
  id: switchboard
  name: Switchboard
  vendor: Nobody
  title: A made-up board of switches
  manual: {{title: The manual of no board, file: board.txt, sha256: "{digest}", lines: 99}}
versions:
  - {{line: firmware, builds: true, members: [{{id: "1", source: 1 L1}}]}}
uses:
  - {{protocol: modbus, links: [tcp], messages: [read_input_registers]}}
links:
  - name: tcp
    word_order: big
    unit_addresses: {{range: 1..247, source: 1 L3}}
    network: {{tcp: 502, source: 1 L5}}
    source: 1 L4
spaces:
  - {{name: input_registers, title: Input registers, first_number: 30001, source: 2 L2}}
messages:
  - {{name: read_input_registers, source: 3 L2}}
records:
  - {{name: exception, source: 3 L4, fields: [{{name: exception_code, type: u8, enum: exception_code}}]}}
registers:
  - group: board
    section: "4"
    source: L1
    space: input_registers
    defaults: {{type: u16, checked: {{words: 1}}, access: ro}}
    rows:
{rows}
enums:
  - {{name: exception_code, source: 3 L4}}
{enums}
"""


def spec(is_states: bool) -> str:
    """The spec of the device."""
    meanings = [*(f"enum: state_{place}" for place in range(5)), *(f"flags: word_{place}" for place in range(5))]
    rows = [
        f"      - {{at: {place}, name: r{place}, {f'{meanings[place]}, ' if is_states else ''}source: L{place + 2}}}"
        for place in range(10)
    ]
    if not is_states:
        return HEAD.format(digest=64 * "6", rows="\n".join(rows), enums="")
    enums = [
        f"  - {{name: state_{place}, title: State, source: 4 L2, members: [{_items('value', f's{place}', 20)}]}}"
        for place in range(5)
    ]
    flags = [
        f"  - {{name: word_{place}, type: u16, source: 4 L3, bits: [{_items('bit', f'w{place}_flag', 16)}]}}"
        for place in range(5)
    ]
    return HEAD.format(digest=64 * "6", rows="\n".join(rows), enums="\n".join([*enums, "flags:", *flags]))


def _items(key: str, name: str, count: int) -> str:
    return ", ".join(f"{{{key}: {number}, name: {name}_{number}}}" for number in range(count))
