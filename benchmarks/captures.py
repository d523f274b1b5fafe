"""A capture of Modbus TCP as tables in Parquet, beside tshark, construct and a loop in C, which write no tables."""

from __future__ import annotations

import shutil
import struct
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import TypeAlias

import construct
from peers.switchboard import spec
from processes import FIELDSPEC, PYTHON, Took, compared, in_turns
from rows import ROOT, Row, interleaved, printed

GROUP = "Captures"
NAME = "Modbus TCP, reads of 10 registers, to Parquet: a frame"
FRAMES, SOME, FEW = 1_000_000, 50_000, 2_000
"""The frames that are decoded by us and in C, by tshark, and by construct."""
SOURCE = Path(__file__).parent / "peers" / "pcap_walk.c"
FIELDS = (
    "frame.time_epoch",
    "mbtcp.trans_id",
    "mbtcp.unit_id",
    "modbus.func_code",
    "modbus.regnum16",
    "modbus.regval_uint16",
)


BY_HAND = Path(__file__).parent / "peers" / "capture_by_hand.py"


Exchanges: TypeAlias = Iterator[tuple[bytes, bytes]]
"""Requests with their answers."""


def reads(count: int, states: int = 65536) -> Exchanges:
    """Reads of ten registers in `count` frames. The first five words are less than `states`."""
    for number in range(count // 2):
        request = struct.pack(">HHHBBHH", number % 65536, 0, 6, 1, 4, 0, 10)
        numbers = [(number * 7919 + word) % 65536 for word in range(10)]
        words = struct.pack(">10H", *(each % states for each in numbers[:5]), *numbers[5:])
        yield request, struct.pack(">HHHBBB", number % 65536, 0, 23, 1, 4, 20) + words


def packets(exchanges: Exchanges, port: int = 502) -> Iterator[bytes]:
    """The packets of one connection, with the records of pcap around them."""
    asked = answered = 1000
    for number, (request, answer) in enumerate(exchanges):
        yield record(2 * number, (49152, port), asked, request)
        yield record(2 * number + 1, (port, 49152), answered, answer)
        asked, answered = (asked + len(request)) % 2**32, (answered + len(answer)) % 2**32


def record(number: int, ports: tuple[int, int], sequence: int, data: bytes) -> bytes:
    """One packet of Ethernet, IP and TCP as a record."""
    hosts = (b"\x0a\0\0\1", b"\x0a\0\0\2") if number % 2 == 0 else (b"\x0a\0\0\2", b"\x0a\0\0\1")
    tcp = struct.pack(">HHIIBBHHH", *ports, sequence, 0, 0x50, 0x18, 8192, 0, 0) + data
    head = struct.pack(">BBHHHBBH", 0x45, 0, 20 + len(tcp), 0, 0, 64, 6, 0) + b"".join(hosts)
    packet = bytes(12) + b"\x08\0" + head + tcp
    return struct.pack("<IIII", number // 1000, number % 1000 * 1000, len(packet), len(packet)) + packet


def capture(path: Path, exchanges: Exchanges, port: int = 502) -> None:
    """Writes a capture."""
    with path.open("wb") as file:
        file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 0x40000, 1))
        file.writelines(packets(exchanges, port))


FRAME = construct.Struct(
    "record" / construct.Bytes(16),
    "ethernet" / construct.Bytes(14),
    "ip" / construct.Bytes(20),
    "tcp" / construct.Struct("source" / construct.Int16ub, "target" / construct.Int16ub, construct.Bytes(16)),
    "transaction" / construct.Int16ub,
    "protocol" / construct.Int16ub,
    "length" / construct.Int16ub,
    "unit" / construct.Int8ub,
    "code" / construct.Int8ub,
    "body" / construct.Bytes(construct.this.length - 2),
)  # fmt: skip


def rows() -> Iterator[Row]:
    """The rows."""
    tshark = shutil.which("tshark")
    if tshark is None:
        raise SystemExit("tshark is missing")
    yield from beside_numpy()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        path, some, walk = folder / "input.pcap", folder / "some.pcap", folder / "walk"
        capture(path, reads(FRAMES))
        capture(some, reads(SOME))
        subprocess.run(["gcc", "-O3", "-o", walk, SOURCE], check=True)
        out = folder / "out"
        decode = " ".join((*FIELDSPEC, "decode", "wattmeter@1", str(path), "--to", "parquet", "--out", str(out)))
        script = f"rm -rf {out}; exec {decode} --specs {ROOT / 'tests' / 'specs'}"
        took = in_turns({"ours": ("/bin/sh", "-c", script), "c": (str(walk), str(path))}, 3)
        ours = least(took["ours"], FRAMES)
        fields = [option for field in FIELDS for option in ("-e", field)]
        of_tshark = in_turns({"tshark": (tshark, "-n", "-r", str(some), "-T", "fields", *fields)}, 1)
        yield row(ours, "tshark -T fields", least(of_tshark["tshark"], SOME), at_least=5)
        yield row(ours, "a loop in C, which adds the words", least(took["c"], FRAMES))
    data = b"".join(packets(reads(FEW)))
    parse = construct.GreedyRange(FRAME).parse
    _, slow, _ = interleaved(lambda: None, lambda: parse(data))
    yield row(ours, "construct, the headers", slow / FEW / 1e3, at_least=5)


def beside_numpy() -> Iterator[Row]:
    """The rows beside a program with numpy that knows the device and the packets, and writes the same tables."""
    titles = {"numbers": "Ten numbers, to Parquet", "states": "Five enums and five words of bits, to Parquet"}
    for kind, title in titles.items():
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "switchboard").mkdir()
            (folder / "switchboard" / "device.yaml").write_text(spec(kind == "states"))
            path, out = folder / "input.pcap", folder / "out"
            capture(path, reads(FRAMES, 20 if kind == "states" else 65536))
            decode = " ".join((*FIELDSPEC, "decode", "switchboard", str(path), "--to", "parquet", "--out", str(out)))
            script = f"rm -rf {out}; exec {decode} --specs {folder}"
            by_hand = (*PYTHON, str(BY_HAND), str(path), str(folder / "by_hand"), kind)
            took = in_turns({"ours": ("/bin/sh", "-c", script), "numpy": by_hand}, 3)
            same_tables(out, folder / "by_hand")
            yield compared(GROUP, title, took, "ours", "numpy", at_most=1.3)


def same_tables(ours: Path, theirs: Path) -> None:
    """Ends the run where the two programs have written different rows."""
    import pyarrow
    from pyarrow import parquet

    for name in ("frames", "values"):
        own, other = parquet.read_table(ours / name), parquet.read_table(theirs / f"{name}.parquet")
        for column in set(own.column_names) - {"device"}:
            texts = [
                table[column].cast(pyarrow.string())
                if pyarrow.types.is_dictionary(table[column].type)
                else table[column]
                for table in (own, other)
            ]
            if not texts[0].equals(texts[1]):
                raise SystemExit(f"{name}: {column} differs from numpy by hand")


def least(took: list[Took], frames: int) -> float:
    """Microseconds of the processor for a frame."""
    return min(each.work for each in took) * 1e3 / frames


def row(ours: float, peer: str, theirs: float, at_least: float | None = None) -> Row:
    """A row in microseconds a frame."""
    return Row(GROUP, NAME, peer, round(ours, 3), round(theirs, 3), "us", round(theirs / ours, 3), at_least=at_least)


if __name__ == "__main__":
    printed(rows())
