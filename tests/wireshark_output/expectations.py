"""What tshark must show of a frame: the numbers, names and findings that the explanation of the reference has."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from fieldspec.codec.explain.explanation import Explanation, ExplanationRow, explained
from fieldspec.codec.layout.device import DeviceLayout
from wireshark_output.dissection import FIRST_PORT, HEADERS, Item, Packet, dissected, port_options, prefix_of

NUMBER = re.compile(r"-?\d+|0x[0-9a-f]+")
_ESCAPED = re.compile(r"\\x([0-9a-f]{2})|\\(.)")
_HEXADECIMAL = re.compile(r"\\x([0-9a-f]{2})()")
_ESCAPES = {"t": "\t", "n": "\n", "r": "\r", "a": "\a", "b": "\b", "f": "\f", "v": "\v"}
FINDINGS = {"wrong_checksum", "wrong_length", "wrong_const", "wrong_measure", "out_of_range", "unknown_value"}
FINDINGS |= {"unknown_code", "incomplete"}


class Case(NamedTuple):
    """A frame of a device, and the request before it; empty where it is a request itself or none is known."""

    layout: DeviceLayout
    link: str
    direction: str
    message: str
    request: bytes
    frame: bytes

    @property
    def place(self) -> tuple[str, str, str]:
        """What has a port of its own: the device, the link, and of a link without codes the message."""
        is_coded = self.layout.links[self.link].request.role("code") is not None
        return self.layout.device.id, self.link, "" if is_coded else self.message

    @property
    def text(self) -> str:
        """The case as failures name it."""
        return f"{self.link} {self.direction} {self.message} {self.frame.hex(' ')} after {self.request.hex(' ')}"

    def explanation(self) -> Explanation:
        """What the reference says of the frame."""
        is_coded = self.layout.links[self.link].frame(self.direction).role("code") is not None
        message = "" if is_coded else self.message
        return explained(self.layout, self.link, self.direction, self.frame, message, self.request)


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
        packets.append(Packet(client, port, case.direction, case.frame))
    own = {case.layout.device.id: case.layout for case in all_cases}
    return packets, numbers, [option for layout in own.values() for option in port_options(layout, ports)]


def results(all_cases: Sequence[Case]) -> list[tuple[Case, list[Item]]]:
    """Cases with what tshark shows of them, in one run."""
    packets, numbers, options = conversation(all_cases)
    own = {case.layout.device.id: case.layout for case in all_cases}
    items = dissected(list(own.values()), packets, options)
    return [(case, items[number]) for case, number in zip(all_cases, numbers, strict=True)]


def values_of(case: Case, explanation: Explanation) -> list[ExplanationRow]:
    """The rows with numbers, without checksums, which are bytes."""
    link = case.layout.links[case.link]
    checks = {part.name for part in link.frame(case.direction).checksums}
    rows = [row for row in explanation.rows if row.kind in ("part", "field") and row.path not in checks]
    return [row for row in (*rows, *explanation.registers) if row.number is not None]


def places_of(case: Case, row: ExplanationRow) -> tuple[tuple[int, int], ...]:
    """Where tshark shows a row: in the packet, or for a link of characters in the bytes that these encode.

    For the latter, PDML adds the offset of the parent where that is greater than the one of the child.
    """
    link = case.layout.links[case.link].link
    if link.transmission == "hex_ascii":
        start, _ = link.delimiters(case.direction)
        at, size = (row.offset - len(start)) // 2, row.length // 2
        return (at, size), (HEADERS + at, size)
    return ((HEADERS + row.offset, row.length),)


def _unescaped(match: re.Match[str]) -> str:
    """The character for which tshark shows an escape."""
    digits, character = match.groups()
    return chr(int(digits, 16)) if digits else _ESCAPES.get(character, character)


def is_equal(item: Item, number: object) -> bool:
    if isinstance(number, bytes):
        return True  # texts and bytes are shown in a form of their own, and compared by their place
    if isinstance(number, str):
        # A backslash of the text is shown as it is, or doubled.
        return number in (_HEXADECIMAL.sub(_unescaped, item.value), _ESCAPED.sub(_unescaped, item.value))
    if isinstance(number, float) and number != number:
        return item.value.lower() in ("nan", "-nan")
    if isinstance(number, float):
        # A record of one field has the place of that field, and no value.
        return bool(item.value) and (
            float(item.value) == number or abs(float(item.value) - number) <= 1e-5 * abs(number)
        )
    base = 16 if item.value.startswith("0x") else 10
    return NUMBER.fullmatch(item.value) is not None and int(item.value, base) == number


def expect_values(case: Case, explanation: Explanation, items: list[Item]) -> None:
    for row in values_of(case, explanation):
        places = places_of(case, row)
        here = [item for item in items if (item.offset, item.size) in places]
        assert any(is_equal(item, row.number) for item in here), (case.text, row, here or items)


def expect_names(case: Case, explanation: Explanation, items: list[Item]) -> None:
    prefix = prefix_of(case.layout)
    names = {item.name.rstrip("_").removeprefix(f"{prefix}.").removeprefix("register.") for item in items}
    for row in explanation.registers:
        if row.path and row.number is not None:
            path = re.sub(r"\[\d+\]", "", row.path)
            assert path in names, (case.text, row.path, sorted(names))


def expect_findings(case: Case, explanation: Explanation, items: list[Item]) -> None:
    prefix = f"{prefix_of(case.layout)}.expert."
    rows = (*explanation.rows, *explanation.registers)
    reasons = {row.reason for row in rows if row.reason in FINDINGS}
    reported = {item.name.removeprefix(prefix) for item in items if item.name.startswith(prefix)}
    assert reasons == reported & FINDINGS, (case.text, reasons, reported)


def expect(case: Case, items: list[Item]) -> bool:
    """What the explanation says of a frame; a frame that is none is shown as bytes. Returns whether it is one."""
    explanation = case.explanation()
    if {"wrong_mark", "not_hex"} & set(explanation.reasons):
        assert any(item.name.endswith((".wrong_mark", ".not_hex")) for item in items), case.text
        return False
    expect_values(case, explanation, items)
    expect_names(case, explanation, items)
    expect_findings(case, explanation, items)
    return True
