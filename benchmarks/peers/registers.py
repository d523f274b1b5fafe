"""A made-up device with any number of registers, as a spec of ours and in the languages of the peers.

Every register has a type, a label, a range, a unit, a default and its source; every fifth one has eight named bits, and
every tenth one, in place of a range, eight named values.
"""

from __future__ import annotations

MOST = 50_000
"""Registers of one device, as their addresses have 16 bits."""
NAMES = ("ready", "active", "warning", "error", "homed", "moving", "limit", "busy")
HEAD = """\
device:
  id: {id}
  name: {name}
  vendor: Nobody
  manual: {{title: M, file: m.txt, sha256: "{zeros}", lines: 999999}}
links:
  - {{name: line, title: A line, transmission: binary, byte_order: big, word_order: big, source: 1 L1,
     request: [{{name: body, role: body}}], response: [{{name: body, role: body}}]}}
"""


def devices(count: int) -> list[tuple[str, int]]:
    """The ids of devices with their numbers of registers."""
    number = -(-count // MOST)
    share = -(-count // number)
    return [(f"device{chr(ord('a') + at)}", min(share, count - at * share)) for at in range(number)]


def spec(count: int) -> dict[str, str]:
    """The files of our specs by path."""
    return {f"{name}/device.yaml": "".join(_device(name, number)) for name, number in devices(count)}


def _device(name: str, count: int) -> list[str]:
    lines = [HEAD.format(id=name, name=name.title(), zeros="0" * 64)]
    enums = [at for at in range(count) if at % 10 == 9]
    flags = [at for at in range(count) if at % 5 == 0]
    if enums:
        lines.append("enums:\n")
    for at in enums:
        members = ", ".join(f"{{value: {number}, name: {word}}}" for number, word in enumerate(NAMES))
        lines.append(f"  - {{name: choice_{at}, source: 2.{at % 90} L{at + 1}, members: [{members}]}}\n")
    if flags:
        lines.append("flags:\n")
    for at in flags:
        bits = ", ".join(f"{{bit: {number}, name: {word}}}" for number, word in enumerate(NAMES))
        lines.append(f"  - {{name: word_{at}, type: u16, source: 3.{at % 90} L{at + 1}, bits: [{bits}]}}\n")
    lines.append("registers:\n  - group: all\n    rows:\n")
    lines += [_row(at) for at in range(count)]
    return lines


def _row(at: int) -> str:
    start = f"      - {{at: 0x{at:04X}, name: value_{at}, type: u16, access: rw, label: Value number {at} of all, "
    end = f"source: 4.{at % 90} L{at + 1}}}\n"
    if at % 10 == 9:
        return f"{start}enum: choice_{at}, range: 0..7, default: 0, {end}"
    if at % 5 == 0:
        return f"{start}flags: word_{at}, {end}"
    return f"{start}range: 0..{at % 60000 + 5}, default: {at % 5}, scale: 0.01, unit: mm, doc: What it is for., {end}"


def systemrdl(count: int) -> str:
    """The same in SystemRDL, as PeakRDL reads it."""
    lines = []
    for at in range(count):
        if at % 10 == 9:
            members = " ".join(f"{word} = {number};" for number, word in enumerate(NAMES))
            lines.append(f"enum choice_{at} {{ {members} }};")
    lines.append("addrmap large {")
    for at in range(count):
        head = f'  reg {{ regwidth = 16; name = "Value number {at} of all"; desc = "4.{at % 90} L{at + 1}"; '
        if at % 10 == 9:
            body = f"field {{ sw = rw; hw = r; encode = choice_{at}; }} value[15:0] = 0;"
        elif at % 5 == 0:
            body = " ".join(f"field {{ sw = rw; hw = r; }} {word}[{bit}:{bit}];" for bit, word in enumerate(NAMES))
        else:
            body = f"field {{ sw = rw; hw = r; }} value[15:0] = {at % 5};"
        lines.append(f"{head}{body} }} value_{at} @ 0x{2 * at:X};")
    return "\n".join([*lines, "};"]) + "\n"


def toml(count: int) -> str:
    """The same in TOML, as hdl-registers reads it."""
    lines = []
    for at in range(count):
        lines += [f"[value_{at}]", 'mode = "r_w"', f'description = "Value number {at} of all, 4.{at % 90} L{at + 1}"']
        if at % 10 == 9:
            lines += ['value.type = "enumeration"', 'value.default_value = "ready"']
            lines += [f'value.element.{word} = "{word}"' for word in NAMES]
        elif at % 5 == 0:
            for word in NAMES:
                lines += [f'{word}.type = "bit"', f'{word}.default_value = "0"']
        else:
            lines += ['value.type = "bit_vector"', "value.width = 16", f'value.default_value = "{at % 5:016b}"']
    return "\n".join(lines) + "\n"
