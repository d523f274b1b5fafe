"""tshark shows of every example frame what the explanation of the reference says."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import NamedTuple

from fieldspec.backends.wireshark.backend import refusals
from fieldspec.backends.wireshark.values import scale_data
from fieldspec.explain.explanation import Explanation, ExplanationRow, explained
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.texts import Example
from layouts import SPECS, TEST_SPECS, layouts
from wireshark_output.dissection import (
    FIRST_PORT,
    HEADERS,
    Item,
    Packet,
    dissected,
    pcap,
    port_options,
    prefix_of,
    tshark,
)

DEVICES = {
    name: versions[-1]
    for root in (SPECS, TEST_SPECS)
    for name, versions in layouts(root).items()
    if not refusals(versions)
}
NUMBER = re.compile(r"-?\d+|0x[0-9a-f]+")
DAMAGED_FRAMES = 8
"""The damaged frames of each example."""


FINDINGS = {"wrong_check", "wrong_length", "wrong_const", "wrong_measure", "out_of_range", "unknown_value"}
FINDINGS |= {"unknown_code", "incomplete"}


class Case(NamedTuple):
    """A frame of a device, and the request before it; empty where it is a request itself or none is known."""

    layout: DeviceLayout
    example: Example
    request: bytes
    frame: bytes

    @property
    def place(self) -> tuple[str, str, str]:
        """What has a port of its own: the device, the link, and of a link without codes the message."""
        link = self.layout.links[self.example.link]
        message = self.example.message if link.request.role("code") is None else ""
        return self.layout.device.id, self.example.link, message

    def explanation(self) -> Explanation:
        message = (
            ""
            if self.layout.links[self.example.link].frame(self.example.direction).role("code")
            else (self.example.message)
        )
        return explained(self.layout, self.example.link, self.example.direction, self.frame, message, self.request)


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
                yield Case(layout, example, request, example.frame)


def results(all_cases: Sequence[Case]) -> list[tuple[Case, list[Item]]]:
    """Cases with what tshark shows of them, in one run."""
    packets, numbers, options = conversation(all_cases)
    items = dissected(list(DEVICES.values()), packets, options)
    return [(case, items[number]) for case, number in zip(all_cases, numbers, strict=True)]


def conversation(all_cases: Sequence[Case]) -> tuple[list[Packet], list[int], list[str]]:
    """The packets of cases, the number of the packet of each, and the options that attach the dissectors."""
    ports: dict[tuple[str, str, str], int] = {}
    packets: list[Packet] = []
    numbers = []
    for number, case in enumerate(all_cases):
        port = ports.setdefault(case.place, FIRST_PORT + len(ports))
        client = 20000 + number
        if case.request:
            packets.append(Packet(client, port, "request", case.request))
        numbers.append(len(packets))
        packets.append(Packet(client, port, case.example.direction, case.frame))
    return packets, numbers, [option for layout in DEVICES.values() for option in port_options(layout, ports)]


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


def values_of(case: Case, explanation: Explanation) -> list[ExplanationRow]:
    """The rows with numbers, without checksums, which are bytes."""
    link = case.layout.links[case.example.link]
    checks = {part.name for part in link.frame(case.example.direction).checksums}
    rows = [row for row in explanation.rows if row.kind in ("part", "field") and row.path not in checks]
    return [row for row in (*rows, *explanation.registers) if row.number is not None]


def places_of(case: Case, row: ExplanationRow) -> tuple[tuple[int, int], ...]:
    """Where tshark shows a row: in the packet, or for a link of characters in the bytes that these encode.

    For the latter, PDML adds the offset of the parent where that is greater than the one of the child.
    """
    link = case.layout.links[case.example.link].link
    if link.encoding == "hex_ascii":
        at, size = (row.offset - len(link.start)) // 2, row.length // 2
        return (at, size), (HEADERS + at, size)
    return ((HEADERS + row.offset, row.length),)


def is_equal(item: Item, number: object) -> bool:
    if isinstance(number, bytes):
        return True  # texts and bytes are shown in a form of their own, and compared by their place
    if isinstance(number, str):
        return item.value.replace("\\\\", "\\") == number
    if isinstance(number, float):
        return (
            item.value.lower() in ("nan", "-nan")
            if number != number
            else (abs(float(item.value) - number) <= 1e-5 * abs(number))
        )
    return NUMBER.fullmatch(item.value) is not None and int(item.value, 0) == number


def expect_values(case: Case, explanation: Explanation, items: list[Item]) -> None:
    for row in values_of(case, explanation):
        places = places_of(case, row)
        here = [item for item in items if (item.offset, item.size) in places]
        assert any(is_equal(item, row.number) for item in here), (case.example.id, row, here or items)


def expect_names(case: Case, explanation: Explanation, items: list[Item]) -> None:
    prefix = prefix_of(case.layout)
    names = {item.name.rstrip("_").removeprefix(f"{prefix}.").removeprefix("register.") for item in items}
    for row in explanation.registers:
        if row.path and row.number is not None:
            path = re.sub(r"\[\d+\]", "", row.path)
            assert path in names, (case.example.id, row.path, sorted(names))


def expect_findings(case: Case, explanation: Explanation, items: list[Item]) -> None:
    prefix = f"{prefix_of(case.layout)}.expert."
    rows = (*explanation.rows, *explanation.registers)
    reasons = {row.reason for row in rows if row.reason in FINDINGS}
    reported = {item.name.removeprefix(prefix) for item in items if item.name.startswith(prefix)}
    assert reasons == reported & FINDINGS, (case.example.id, reasons, reported)


def test_each_example_is_shown_as_the_reference_reads_it() -> None:
    compared = 0
    for case, items in results(list(cases())):
        explanation = case.explanation()
        if {"wrong_mark", "not_hex"} & set(explanation.reasons):
            # Such a frame is shown as bytes.
            assert any(item.name.endswith((".wrong_mark", ".not_hex")) for item in items), case.example.id
            continue
        expect_values(case, explanation, items)
        expect_names(case, explanation, items)
        expect_findings(case, explanation, items)
        compared += 1
    assert compared > 400


def test_damaged_frames_bring_up_no_error_of_the_program() -> None:
    damaged_cases = []
    for case in cases():
        chance = random.Random(f"{case.layout.device.id} {case.example.id}")
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
