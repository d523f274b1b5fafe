"""`fieldspec redact`: what identifies a unit is nowhere in the output, and the evidence stays."""

from __future__ import annotations

import json
import random
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from captures.conversations import USER_0, Segment, block, ethernet, pcap, rtu
from captures.test_decode_in_bulk import run
from captures.test_evidence import DEVICE, NOTE, dump, read, report, unit, words
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.language.model.encoding import is_array
from fieldspec.tools.evidence.observables import Observables
from fieldspec.tools.evidence.redacted_files import redacted_dump, redacted_rows
from fieldspec.tools.evidence.redaction import Redaction
from fieldspec.tools.evidence.secrets import Secrets
from fieldspec.tools.lists.dump import dump as register_dump
from fieldspec.tools.lists.text_sheet import text_sheet
from layouts import SPECS, TEST_SPECS, layout_at, newest
from simulators import parts_of
from spec_files import gadget

SERIAL = 0x12C4E678
HIGH, LOW = SERIAL >> 16, SERIAL & 0xFFFF
TEXT = "SN-4711-XYZ"


def encodings() -> Iterator[bytes]:
    """The serial number and the text in the encodings in which a file could have them."""
    for own in (SERIAL.to_bytes(4, "big"), TEXT.encode()):
        for order in (own, own[::-1], own[2:4] + own[:2] + own[4:]):
            yield order
            yield order.hex().encode()
            yield order.hex(" ").encode()
            yield order.hex().upper().encode()
            yield order.hex(" ").upper().encode()
    yield str(SERIAL).encode()
    yield f"{HIGH} {LOW}".encode()
    yield f",{HIGH}\n".encode()


def secret_packets(chance: random.Random) -> list[bytes]:
    """Frames of which some have the serial number: in its registers, beyond the spec, in noise, in damaged frames."""
    secret = SERIAL.to_bytes(4, "big")
    packets = [*read(0x20, HIGH, LOW), *read(0x1E, 1, 2, HIGH, LOW), *read(0x40, HIGH, LOW), *read(0x21, LOW, HIGH)]
    for _ in range(20):
        share = 0x4200 + chance.randrange(0x60)
        packets += read(0x0C, share, chance.randrange(0x10000), chance.randrange(9))
        noise = chance.randbytes(chance.randrange(4)) + chance.choice((secret, secret[::-1], TEXT.encode()))
        packets.append(noise + chance.randbytes(chance.randrange(4)))
        packets.append(rtu(1, 4, 4, *secret)[:-1] + b"\xff")
    packets += [rtu(1, 16, *words(0, 2), 4, *secret), rtu(1, 16, *words(0, 2))]
    return packets


def log_of(packets: list[bytes]) -> bytes:
    lines = (f"{number}.000 {packet.hex()} # {TEXT} {SERIAL}" for number, packet in enumerate(packets))
    return "\n".join([f"# {SERIAL:X}", *lines]).encode()


def capture_with_names(packets: list[bytes]) -> bytes:
    """A pcapng whose hosts, addresses, comments and applications say the serial number."""
    option = struct.pack("<HH", 1, len(TEXT)) + TEXT.encode() + bytes(-len(TEXT) % 4) + bytes(4)
    parts = [block(0x0A0D0D0A, struct.pack("<IHHq", 0x1A2B3C4D, 1, 0, -1) + option)]
    parts.append(block(1, struct.pack("<HHI", 1, 0, 0) + option))
    sequence = 0
    for number, packet in enumerate(packets):
        own = struct.pack(">HHH", number, 0, len(packet) - 2) + packet[:-2]
        data = bytearray(ethernet(Segment(number % 2 == 0, 1 + sequence * (number % 2 == 0), own)))
        sequence += len(own) * (number % 2 == 0)
        data[0:4] = data[6:10] = SERIAL.to_bytes(4, "big")
        body = struct.pack("<IIIII", 0, 0, number, len(data), len(data)) + data
        parts.append(block(6, body + bytes(-len(data) % 4) + option))
    return b"".join(parts)


def with_secrets(folder: Path, chance: random.Random) -> None:
    """A unit with the serial number in all of its files."""
    packets = secret_packets(chance)
    scan = {
        "spaces": [{"space": "input_registers", "words": {"0x0020": HIGH, "0x0021": LOW, "0x0E": 5}, "refused": []}]
    }
    tables = (
        f"space,address,value\ninput_registers,0x20,{SERIAL}\ninput_registers,0x50,{HIGH}\ninput_registers,0x51,{LOW}\n"
    )
    lines = (f"1.5,32,{HIGH}", f"1.5,33,{LOW}", "2.5,14,5")
    rows = "time,address,value,space\n" + "".join(f"{line},input_registers\n" for line in lines)
    files = {
        f"line {SERIAL}.pcap": pcap(packets, USER_0),
        "line.log": log_of(packets),
        "net.pcapng": capture_with_names([*read(0x20, HIGH, LOW), *read(0x0C, 0x4216, 0)]),
        "dump.csv": tables.encode(),
        "scan.json": json.dumps(scan | {"device": TEXT}).encode(),
        "rows.csv": rows.encode(),
        "other.bin": b"\0\1\2" + TEXT.encode() * 9,
    }
    note = f'model: W\nfirmware: "1"\nserial_number: {TEXT}\nremarks: {SERIAL} {TEXT}\n'
    unit(folder, str(SERIAL), files, note)


def contents(folder: Path) -> bytes:
    """All names and contents of a folder, and what its frames and words are as bytes."""
    parts: list[bytes] = []
    for path in sorted(folder.rglob("*")):
        parts.append(path.name.encode())
        if path.is_file():
            text = path.read_bytes()
            parts.append(text)
            if path.suffix == ".log":
                parts += [bytes.fromhex(line.split(maxsplit=2)[-1]) for line in text.decode().splitlines()]
            if path.suffix == ".csv":
                own = [int(line.split(",")[-1]) for line in text.decode().splitlines()[1:]]
                parts.append(b"".join(word.to_bytes(4 if word > 0xFFFF else 2, "big") for word in own))
    return b"\0\n".join(parts)


def redact(source: Path, target: Path, *options: str) -> tuple[int, str, str]:
    return run("redact", DEVICE, str(source), "--out", str(target), *options)


@pytest.mark.parametrize("seed", range(3))
def test_a_secret_is_nowhere_in_the_output(tmp_path: Path, seed: int) -> None:
    with_secrets(tmp_path / "units", random.Random(seed))
    assert str(SERIAL).encode() in b"".join(path.read_bytes() for path in (tmp_path / "units").rglob("*.csv"))
    code, text, error = redact(tmp_path / "units", tmp_path / "out")
    assert code == 1
    assert "other.bin" in error
    assert "registers/serial_number" in text
    result = contents(tmp_path / "out")
    assert [encoding for encoding in encodings() if encoding in result] == []
    names = sorted(path.name for path in (tmp_path / "out").iterdir())
    assert names == [
        "capture-1.log",
        "capture-2.log",
        "capture-3.log",
        "dump-1.csv",
        "rows-1.csv",
        "scan-1.json",
        "unit.yaml",
    ]


def evidence_of(folder: Path) -> dict[tuple[str, str], str]:
    rows: list[dict[str, Any]] = report(folder)[1]["evidence"]
    return {(row["fact"], row["aspect"]): row["state"] for row in rows}


def test_what_is_not_replaced_is_the_same_evidence(tmp_path: Path) -> None:
    chance = random.Random(1)
    frames = [frame for _ in range(9) for frame in read(0x0C, 0x4200 + chance.randrange(99), 0, chance.randrange(9))]
    frames += [*read(0x20, HIGH, LOW), rtu(1, 4, *words(0x0E, 2)), rtu(1, 0x84, 2), *read(0x0C, 0x4316, 0)]
    write = rtu(1, 16, *words(0, 2), 4, *words(0x3F80, 0))
    frames += [write, rtu(1, 16, *words(0, 2))]
    scan = {"spaces": [{"space": "input_registers", "words": {"0x0E": 5}, "refused": ["0x0000"]}]}
    files = {"a.pcap": pcap(frames, USER_0), "b.csv": dump(7), "c.json": json.dumps(scan).encode()}
    unit(tmp_path / "units", "a", files, NOTE)
    assert redact(tmp_path / "units", tmp_path / "out" / "a")[0] == 0
    before, after = evidence_of(tmp_path / "units"), evidence_of(tmp_path / "out")
    changed = {fact for fact, state in before.items() if after.get(fact) != state}
    assert {fact for fact, _ in changed} <= {"registers/serial_number"}
    assert "contradicted" in after.values()


def test_the_frames_of_the_output_have_right_checksums(tmp_path: Path) -> None:
    unit(tmp_path / "units", "a", {"a.pcap": pcap(read(0x20, HIGH, LOW), USER_0)}, NOTE)
    redact(tmp_path / "units", tmp_path / "out")
    lines = (tmp_path / "out" / "capture-1.log").read_text("utf-8").splitlines()
    assert lines == [
        f"0.000000 > {rtu(1, 4, *words(0x20, 2)).hex(' ').upper()}",
        f"0.001000 < {rtu(1, 4, 4, 0, 0, 0, 0).hex(' ').upper()}",
    ]


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        (("--spare", "nonsense"), "there is no text nonsense"),
        (("--out", "."), "is not an empty folder"),
    ],
)
def test_wrong_use_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, options: tuple[str, ...], expected: str
) -> None:
    monkeypatch.chdir(tmp_path)
    unit(tmp_path / "units", "a", {"b.csv": dump(7)}, NOTE)
    code, _, error = redact(tmp_path / "units", tmp_path / "out", *options)
    assert code == 2
    assert expected in error


@pytest.mark.parametrize(
    ("number", "count"), [(1234567, 2), (1234567, 4), (SERIAL, 2), (SERIAL, 4), (2**32 - 2, 2), (2**40 + 7, 4)]
)
def test_a_number_is_found_in_words_of_all_orders_whatever_pads_it(number: int, count: int) -> None:
    secrets = Secrets([str(number)])
    words_of_number = struct.unpack(f">{count}H", number.to_bytes(2 * count, "big"))
    for order in (words_of_number, words_of_number[::-1]):
        assert secrets.is_in(b"\1" + struct.pack(f">{count}H", *order) + b"\2")
        assert secrets.is_in(b"\1" + struct.pack(f"<{count}H", *order) + b"\2")


def test_a_number_of_more_than_eight_bytes_is_found_too() -> None:
    assert Secrets([str(2**64 + 7)]).is_in(bytes.fromhex("33 01 00 00 00 00 00 00 00 07 44"))


def test_a_word_that_no_register_has_is_replaced_beside_one_that_is_known() -> None:
    redaction = Redaction(newest(TEST_SPECS, "wattmeter"), Secrets())
    assert redaction.words("input_registers", 0x0E, bytes.fromhex("0005 12C4 E678")) == bytes.fromhex("0005 0000 0000")
    assert redaction.replaced == {"unlisted": 2}


BYTES = """
spaces: [{name: memory, title: Memory, unit: byte, bounds: 0..0xFF, source: 1 L1}]
registers:
  - group: all
    section: "1"
    space: memory
    rows:
      - {at: 0, name: speed, type: u8, source: L1}
      - {at: 1, name: serial, roles: serial_number, type: u32, source: L2}
      - {at: 5, name: force, type: u16, source: L3}
      - {at: 7, name: mode, type: u8, source: L4}
      - {at: 8, name: levels, type: u8, count: 6, source: L5}
"""


def byte_redaction(*secrets: str) -> Redaction:
    """The redaction of a device whose addresses are those of bytes, with a serial number at an odd one."""
    return Redaction(layout_at(gadget(BYTES), "1"), Secrets(secrets))


def test_a_secret_is_found_in_bytes_that_are_read_one_by_one() -> None:
    rows = [("memory", 8 + offset, [byte]) for offset, byte in enumerate(bytes.fromhex("11 AA BB CC DD 22"))]
    clean = redacted_rows(byte_redaction(str(0xAABBCCDD)), rows)
    assert [count for _, _, (count,) in clean] == [0x11, 0, 0, 0, 0, 0x22]


@pytest.mark.parametrize(
    ("start", "data", "clean"),
    [
        (0, "07 AA BB CC DD 01 02 09", "07 00 00 00 00 01 02 09"),
        (3, "CC DD 01 02 09", "00 00 01 02 09"),
        (7, "09", "09"),
        (13, "09 08", "09 00"),
    ],
)
def test_a_serial_number_is_replaced_where_addresses_are_those_of_bytes(start: int, data: str, clean: str) -> None:
    data_bytes, clean_bytes = bytes.fromhex(data), bytes.fromhex(clean)
    assert byte_redaction().words("memory", start, data_bytes) == clean_bytes
    assert byte_redaction().counts("memory", start, list(data_bytes)) == list(clean_bytes)


@pytest.mark.parametrize(
    "rows",
    [
        ["0,7", "1,170", "2,187", "3,204", "4,221", "5,2", "6,1", "7,9"],
        ["0,7", "1,0xDDCCBBAA", "5,0x0201", "7,9"],
    ],
    ids=["a byte in a row", "a value in a row"],
)
def test_a_dump_of_bytes_has_no_serial_number_and_all_other_values(rows: list[str]) -> None:
    content = register_dump(text_sheet("\n".join(["address,value", *rows]).encode()), {})
    lines = redacted_dump(byte_redaction(), content).splitlines()
    values = {int(address, 16): int(value) for address, value in (line.split(",")[-2:] for line in lines[1:])}
    assert [values[address] for address in range(8)] == [7, 0, 0, 0, 0, 2, 1, 9]


def test_a_response_without_a_code_is_that_to_its_request(tmp_path: Path) -> None:
    exchange = ["> FF FF 01 02 01 FB", "< FF FF 01 02 00 FC"]
    unit(tmp_path / "units", "a", {"line.log": "\n".join(exchange).encode()})
    code, text, error = run("redact", "servo", str(tmp_path / "units"), "--out", str(tmp_path / "out"))
    assert (code, error) == (0, ""), text
    assert (tmp_path / "out" / "capture-1.log").read_text("utf-8").splitlines() == exchange


def test_a_number_in_a_dump_without_spaces_is_that_of_the_parameter_which_has_it() -> None:
    sheet = text_sheet(b"number,value\n0x4005,7\n0x7FFF,8\n")
    text = redacted_dump(Redaction(newest(SPECS, "hiwin-e"), Secrets()), register_dump(sheet, {"address": "number"}))
    assert text.splitlines() == ["space,address,value", ",0x7FFF,0", "pnu,0x4005,7"]


@pytest.mark.parametrize("device", ["tc100", "ck10", "esc11", "hiwin-e"])
def test_frames_of_manuals_stay_but_for_texts_and_what_no_request_explains(device: str) -> None:
    layout, _ = parts_of(device)
    redaction = Redaction(layout, Secrets())
    count = 0
    for example in layout.device.examples.values():
        redaction.replaced.clear()
        codec = redaction.codec.links[example.link]
        if example.refused or (example.direction == "response" and not example.reply_to):
            continue
        request = layout.device.examples.get(example.reply_to)
        asked = {}
        if request is not None and not request.refused:
            asked = codec.decode(request.frame, "request", request.message).values
        decoded = codec.decode(example.frame, example.direction, example.message)
        clean = redaction.frame(example.link, example.direction, example.frame, decoded, asked)
        count += 1
        if not redaction.replaced:
            assert clean == example.frame, example.id
        else:
            codec.decode(clean, example.direction, example.message)
            assert len(clean) == len(example.frame)
            assert all(known_or_text(layout, path) for path in redaction.replaced), (example.id, redaction.replaced)
    assert count > 8


def known_or_text(layout: DeviceLayout, path: str) -> bool:
    """Whether a fact is a text, or no fact at all."""
    items = {item.fact.place.path: item for item in Observables(layout).all}
    return path in ("unlisted", "reserved") or is_array(items[path].value.encoding)
