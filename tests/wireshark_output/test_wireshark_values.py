"""tshark shows of every example frame what the explanation of the reference says."""

from __future__ import annotations

import random
from collections.abc import Iterator
from decimal import Decimal
from fractions import Fraction

from fieldspec.targets.wireshark.backend import refusals
from fieldspec.targets.wireshark.values import scale_data
from layouts import SPECS, TEST_SPECS, layout_at, layouts
from spec_files import gadget
from wireshark_output.dissection import pcap, tshark
from wireshark_output.expectations import Case, conversation, expect, expect_findings, results

DEVICES = {
    name: versions[-1]
    for root in (SPECS, TEST_SPECS)
    for name, versions in layouts(root).items()
    if not refusals(versions)
}
DAMAGED_FRAMES = 8
"""The damaged frames of each example."""


def cases() -> Iterator[Case]:
    """All examples, with the requests that they answer. Left out is what only an unknown request would explain."""
    for layout in DEVICES.values():
        examples = layout.device.examples
        for example in examples.values():
            asked = examples.get(example.reply_to)
            request = asked.frame if asked is not None else b""
            link = layout.links[example.link]
            coded = [link.frame(direction).role("code") is not None for direction in ("request", "response")]
            if coded != [True, False] or example.direction == "request" or request:
                yield Case(layout, example.link, example.direction, example.message, request, example.frame)


def damaged(frame: bytes, chance: random.Random) -> bytes:
    data = bytearray(frame)
    place = chance.randrange(len(data))
    kind = chance.randrange(4)
    if kind == 0:
        data[place] ^= 1 << chance.randrange(8)
    elif kind == 1:
        del data[place:]
    elif kind == 2:
        data.insert(place, chance.randrange(256))
    else:
        data = bytearray(chance.randbytes(chance.randrange(1, 20)))
    return bytes(data)


def test_each_example_is_shown_as_the_reference_reads_it() -> None:
    assert sum(expect(case, items) for case, items in results(list(cases()))) > 400


def test_damaged_frames_bring_up_no_error_of_the_program() -> None:
    damaged_cases = []
    for case in cases():
        chance = random.Random(f"{case.layout.device.id} {case.text}")
        damaged_cases += [case._replace(frame=damaged(case.frame, chance)) for _ in range(DAMAGED_FRAMES)]
    packets, _, options = conversation(damaged_cases)
    run = tshark(
        list(DEVICES.values()), pcap(packets), "-T", "fields", "-e", "frame.number", "-e", "_ws.lua.error", *options
    )
    rows = [line.split("\t") for line in run.stdout.splitlines()]
    assert len(rows) == len(packets)
    assert [row for row in rows if row[1:] != [""]] == []


def test_a_quantity_has_the_decimals_of_its_scale_and_a_fraction_has_none() -> None:
    assert scale_data(Decimal("0.25"), Decimal(0)) == {"factor": 1, "shift": 0, "divisor": 4, "places": 2}
    assert scale_data(Fraction(100, 255), Decimal(-3)) == {"factor": 20, "shift": -153, "divisor": 51, "places": 0}


_DIGITS = """
links:
  - name: line
    transmission: binary
    byte_order: big
    source: 1 L1
    frame: [{name: code, role: code, type: u8}, {name: data, role: body}]
messages:
  - name: write
    code: 1
    answered_on: []
    source: 1 L2
    request:
      - {name: plain, type: u16, digits: decimal, length: 3}
      - {name: signed, type: i16, digits: decimal, length: 6, places: 1}
      - {name: blank, type: i16, digits: decimal, length: 4, padding: space}
      - {name: upper, type: u8, digits: upper_hex, length: 2}
      - {name: packed, type: u16, digits: bcd, length: 2}
"""


def test_bytes_that_are_no_digits_are_reported_as_the_reference_reports_them() -> None:
    spec = gadget(_DIGITS)
    layout = layout_at(spec, spec.versions()[-1])
    right = [b"120", b"-123.4", b" -12", b"0F", b"\x12\x99"]
    wrong = {
        0: [b"1 0", b"1:0", b"+12"],
        1: [b"0012.3", b"+1234.", b"-12433"],
        2: [b"  00", b"0001", b"  - ", b"  +1", b"    "],
        3: [b"0f", b"0G"],
        4: [b"\x1a\x00", b"\xa1\x00"],
    }
    also_right = {1: [b"+000.0"], 2: [b"   0", b"1234"], 4: [b"\0\x25", b"@I"]}
    rows = [(place, piece) for table in (wrong, also_right) for place, pieces in table.items() for piece in pieces]
    bodies = [right, *([*right[:place], piece, *right[place + 1 :]] for place, piece in rows)]
    frames = [b"\1" + b"".join(pieces) for pieces in bodies]
    dissections = results([Case(layout, "line", "request", "write", b"", frame) for frame in frames])
    for case, items in dissections:
        expect_findings(case, case.explanation(), items)
    assert [bool(case.explanation().reasons) for case, _ in dissections].count(True) == sum(map(len, wrong.values()))
