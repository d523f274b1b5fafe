"""Damaged frames and random bytes for the generated framers: `make fuzz-bytes`, or `python noise.py [BYTES]`.

The first two tables have every golden frame with every single bit inverted: how often decoders and framers notice. The
third one has random bytes for the framers, and the memory that they take.
"""

from __future__ import annotations

import random
import sys
import tracemalloc
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

from targets import DEVICES, codec_error, framers, golden, links, module, named, vectors

BYTES = 10_000_000
PIECE = 4096


@dataclass
class Flips:
    """The outcome of inverting each bit of some frames.

    `unnoticed` counts the frames that decode although a bit is wrong; `same` those among them that decode to the same
    values, because the bit has no meaning: a letter of a hexadecimal digit in the other case.
    """

    link: str
    flips: int = 0
    unnoticed: int = 0
    same: int = 0

    def row(self) -> str:
        """A row of a Markdown table."""
        wrong = self.unnoticed - self.same
        return f"| {self.link} | {self.flips:,} | {self.flips - self.unnoticed:,} | {self.same:,} | {wrong:,} |"


def inverted(frame: bytes) -> Iterator[bytes]:
    """The frame with each of its bits inverted, one at a time."""
    for place in range(len(frame) * 8):
        damaged = bytearray(frame)
        damaged[place // 8] ^= 1 << place % 8
        yield bytes(damaged)


def flips(device: str) -> list[Flips]:
    """The outcome for each link of a device that has golden frames."""
    module(device)
    error = codec_error()
    results = []
    for name, link in links(device).items():
        result = Flips(f"{device} {name}")
        frames = {
            (vector["direction"], vector["right"]): vector
            for vector in vectors(device)
            if vector["link"] == name and not vector["refused"]
        }
        for vector in frames.values():
            decode = _decoder(link, vector, error)
            right = decode(bytes.fromhex(vector["right"]))
            for damaged in inverted(bytes.fromhex(vector["right"])):
                decoded = decode(damaged)
                result.flips += 1
                result.unnoticed += decoded is not None
                result.same += decoded == right
        results.append(result)
    return results


def _decoder(link: Any, vector: dict[str, Any], error: type[Exception]) -> Callable[[bytes], str | None]:
    """Decodes a frame to a text; None if it is refused."""
    decode = getattr(link, f"decode_{vector['direction']}")
    arguments = (vector["message"],) if named(link, vector["direction"]) else ()

    def decoded(frame: bytes) -> str | None:
        try:
            return repr(decode(frame, *arguments))
        except error:
            return None

    return decoded


@dataclass
class FramedFlips:
    """What a framer makes of a frame with an inverted bit, when the right frame follows.

    `returned` counts the damaged frames that it returns whole, `delayed` the right ones after them that it does not
    return because the damaged one seems to reach into them, and `lost` those that it does not return even if the line
    was silent in between.
    """

    tried: int = 0
    returned: int = 0
    delayed: int = 0
    lost: int = 0


def framed_flips(device: str) -> FramedFlips:
    """The outcome for all framers and golden frames of a device."""
    result = FramedFlips()
    for link, direction, make in framers(device):
        for frame in golden(device, link, direction):
            for damaged in inverted(frame):
                together, apart = make(), make()
                received = together.feed(damaged) + together.feed(frame) + together.idle()
                apart.feed(damaged)
                apart.idle()
                result.tried += 1
                result.returned += damaged in received
                result.delayed += frame not in received
                result.lost += frame not in apart.feed(frame) + apart.idle()
    return result


@dataclass
class Noise:
    """The outcome of random bytes for one framer; `peak` is the memory in bytes that its buffers ever took."""

    name: str
    size: int
    frames: int
    peak: int


def noise(device: str, size: int, seed: int = 1) -> Iterator[Noise]:
    """Feeds each framer of a device with random bytes, among them the beginnings of damaged frames."""
    for link, direction, make in framers(device):
        chance = random.Random(f"{seed} {device} {link} {direction}")
        frames = golden(device, link, direction)
        framer = make()
        framer.feed(chance.randbytes(PIECE))  # what is set up once is not a memory that grows
        sent, taken = PIECE, 0
        tracemalloc.start()
        while sent < size:
            piece = _piece(chance, frames)
            sent += len(piece)
            taken += len(framer.feed(piece))
            assert len(framer._buffer) <= framer.longest
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        yield Noise(f"{device} {link} {direction}", sent, taken, peak)


def _piece(chance: random.Random, frames: list[bytes]) -> bytes:
    if frames and chance.random() < 0.5:
        frame = bytearray(chance.choice(frames))
        frame[chance.randrange(len(frame))] = chance.randrange(256)
        return bytes(frame[: chance.randint(1, len(frame))])
    return chance.randbytes(chance.choice((1, 7, 64, PIECE)))


def main(size: int = BYTES) -> int:
    """Prints the tables. Returns 1 if a frame is lost that comes after a damaged one and silence."""
    print("| link | inverted bits | refused | the same values | other values |")
    print("|---|---|---|---|---|")
    for device in DEVICES:
        for result in flips(device):
            print(result.row())
    lost = 0
    print("| device | inverted bits | damaged frames returned | frames after them missed | after silence |")
    print("|---|---|---|---|---|")
    for device in DEVICES:
        framed = framed_flips(device)
        lost += framed.lost
        print(f"| {device} | {framed.tried:,} | {framed.returned:,} | {framed.delayed:,} | {framed.lost:,} |")
    print("| framer | random bytes | frames by chance | most memory, bytes |")
    print("|---|---|---|---|")
    for device in DEVICES:
        for outcome in noise(device, size):
            print(f"| {outcome.name} | {outcome.size:,} | {outcome.frames:,} | {outcome.peak:,} |", flush=True)
    return 1 if lost else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
