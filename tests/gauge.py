"""A made-up device of six registers and its manual of two pages, for tests of coverage."""

from __future__ import annotations

import hashlib

from fieldspec.codec.layout.device import device_layout
from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.project import read
from fieldspec.tools.audit.coverage import coverage
from fieldspec.tools.audit.manual_lines import ManualIndex, index_of
from fieldspec.tools.audit.section import Section, Subject
from fieldspec.tools.facts import rows

MANUAL = """\
GAUGE 7 Manual

1 Registers

Address Words Name Range
0100 H | 1 | Level | 0~1000 | the level
0101 H | 1 | Mode | 0~2 | 0 : hold 1 : run 2 : stop
0102 H | 2 | Total | - | all that has run
0104 H | 1 | Inputs | - | Bit0 : door ~ Bit3 : lamp

2 Frames

Code | Name
03 H | read
Example: 01 03 01 00 00 01 85 F6

9 Warranty

Two years, at most 5000 hours.
"""

DEVICE = """\
device:
  id: gauge
  name: Gauge
  vendor: Nobody
  manual: {title: The manual of a gauge, file: gauge.txt, sha256: SHA256, lines: LINES}
uses:
  - {protocol: wire, messages: [read_registers]}
links:
  - {name: rtu, source: 2 L11, word_order: big}
messages:
  - {name: read_registers, source: 2 L14}
enums:
  - name: mode
    section: "1"
    source: L7
    members:
      - {value: 0, name: hold}
      - {value: 1, name: run}
      - {value: 2, name: stop}
flags:
  - name: inputs
    type: u16
    section: "1"
    source: L9
    bits:
      - {bit: 0, name: door}
      - {bit: 1, name: hatch}
      - {bit: 2, name: fan}
      - {bit: 3, name: lamp}
registers:
  - group: all
    section: "1"
    rows:
      - {at: 0x0100, name: level, printed_name: Level, type: u16, range: 0..1000, source: L6}
      - {at: 0x0101, name: mode, printed_name: Mode, type: u16, enum: mode, range: 0..2, source: L7}
      - {at: 0x0102, name: total, printed_name: Total, type: u32, checked: {words: 2}, source: L8}
      - {at: 0x0104, name: inputs, printed_name: Inputs, type: u16, flags: inputs, source: L9}
examples:
  - {id: read-level, link: rtu, direction: request, message: read_registers, source: 2 L15,
     frame: "01 03 01 00 00 01 85 F6", values: {station: 1, address: 256, word_count: 1}}
"""

AUDIT = """\
audit:
  sections:
    - {section: Front, line: 1}
    - {section: "1", line: 3, title: Registers}
    - {section: "2", line: 11, title: Frames}
    - {section: "9", line: 17, title: Warranty}
  patterns:
    - {name: rows, kind: address, sections: ["1"], row: ["{address:hex4} H", "{words}", "{name}", "*"]}
    - {name: bounds, kind: table_row, sections: ["1"], row: ["*", "*", "*", "{range:span}", "*"]}
    - {name: values, kind: code, lines: 6-7, each: "{code:decimal} :"}
    - {name: bits, kind: bit_row, lines: "9", series: true, each: "Bit{bit:decimal} :* Bit{bit:decimal} :"}
    - {name: codes, kind: code, sections: ["2"], row: ["{code:hex2} H", "*"]}
    - {name: frames, kind: frame, sections: ["2"], each: "{frame}"}
  left_out:
    - {sections: [Front, "9"], reason: Cover and warranty.}
"""

WIRE = """\
protocol: {id: wire, title: A part of Modbus}
links:
  - name: rtu
    transmission: binary
    byte_order: big
    request: &frame
      - {name: station, role: unit_address, type: u8}
      - {name: function, role: code, type: u8}
      - {name: body, role: body}
      - {name: crc, role: checksum, algorithm: crc16_modbus, byte_order: little}
    response: *frame
messages:
  - name: read_registers
    code: 3
    request:
      - {name: address, type: u16}
      - {name: word_count, type: u16}
    response:
      - {name: byte_count, type: u8}
      - {name: values, type: u16, repeat: 1..125}
"""


def files(device: str = DEVICE, audit: str = AUDIT, manual: str = MANUAL) -> dict[str, str]:
    """The files of the gauge's spec, which cites the given manual."""
    sha256 = hashlib.sha256(manual.encode()).hexdigest()
    head = device.replace("SHA256", sha256).replace("LINES", str(len(manual.splitlines())))
    texts = {"gauge/device.yaml": head, "protocols/wire.yaml": WIRE}
    return {**texts, "gauge/audit.yaml": audit} if audit else texts


def spec(device: str = DEVICE, audit: str = AUDIT, manual: str = MANUAL) -> DeviceSpec:
    """The gauge's spec, which cites the given manual."""
    project = read({path: text.encode() for path, text in files(device, audit, manual).items()})
    assert [finding.message for finding in project.findings] == []
    return project.devices["gauge"]


def index(manual: str = MANUAL) -> ManualIndex:
    """The index of a manual."""
    return index_of("gauge.txt", manual.encode())


def covered(
    device: str = DEVICE, audit: str = AUDIT, cited: str = MANUAL, manual: str | None = None, recorded: bool = True
) -> Section:
    """The coverage of the manual `cited`: from its index, or from the text `manual`."""
    return coverage(subject(device, audit, cited, manual, recorded))


def subject(
    device: str = DEVICE, audit: str = AUDIT, cited: str = MANUAL, manual: str | None = None, recorded: bool = True
) -> Subject:
    """The gauge and the manual `cited`: its index, or the text `manual`."""
    read_spec = spec(device, audit, cited)
    model, findings = read_spec.at("1")
    assert [finding.message for finding in findings] == []
    layout = device_layout(model)
    at_hand = index(manual) if manual is not None else None
    return Subject(read_spec, layout, (layout,), (rows(layout),), (), index(cited) if recorded else None, at_hand)


def numbers(section: Section) -> list[int]:
    """The numbers of covered, corrected, omitted and unaccounted lines, and the total."""
    return [*(figure.number for figure in section.figures[:4]), section.figures[0].whole or 0]


def finding_texts(section: Section) -> list[str]:
    """The findings as `rule: message`."""
    return [f"{finding.code}: {finding.message}" for finding in section.findings]
