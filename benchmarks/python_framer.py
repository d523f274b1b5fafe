"""Frames found in a noisy stream of bytes in Python, against a state machine written by hand."""

from __future__ import annotations

import random
import tracemalloc
from collections.abc import Callable, Iterator

from peers.framer import Framer
from rows import Row, printed, timed, use_generated

use_generated()

GROUP = "Python, framer"
PIECE = 64


def stream(frames: list[bytes], number: int, noise: int) -> list[bytes]:
    """A stream of so many frames in pieces; before each frame up to `noise` random bytes. The same at every run."""
    chance = random.Random(1)
    whole = b"".join(chance.randbytes(chance.randint(0, noise)) + chance.choice(frames) for _ in range(number))
    return [whole[at : at + PIECE] for at in range(0, len(whole), PIECE)]


def run(make: Callable[[], object], pieces: list[bytes]) -> list[bytes]:
    """All frames of a stream."""
    framer = make()
    return [frame for piece in pieces for frame in framer.feed(piece)]


def rows() -> Iterator[Row]:
    """The rows."""
    from fieldspec_devices.tc100.v2_0 import ReadRegistersRequest, WriteRegisterRequest, WriteRegistersRequest, rtu

    frames = [
        rtu.encode_request(1, ReadRegistersRequest(0x1000, 4)),
        rtu.encode_request(2, WriteRegisterRequest(0x2011, 9)),
        rtu.encode_request(3, WriteRegistersRequest(0x9100, [0, 100, 1, 2, 3, 4, 5, 6, 7])),
    ]
    for noise, named in ((40, "noisy stream"), (0, "clean stream")):
        pieces = stream(frames, 500, noise)
        assert run(rtu.request_framer, pieces) == run(Framer, pieces)
        yield timed(GROUP, named, lambda p=pieces: run(rtu.request_framer, p), "state machine by hand",
                    lambda p=pieces: run(Framer, p), at_most=1.20)  # fmt: skip
    once, ten = stream(frames, 500, 40), stream(frames, 5000, 40)
    share = sum(map(len, ten)) / sum(map(len, once))
    yield timed(GROUP, f"{share:.2f} times the bytes", lambda: run(rtu.request_framer, ten), "once the bytes",
                lambda: run(rtu.request_framer, once), at_most=1.1 * share)  # fmt: skip
    few, many = most(rtu.request_framer, once), most(rtu.request_framer, ten)
    yield Row(GROUP, "memory at the most, ten times the bytes", "once the bytes", many, few, "bytes",
              round(many / few, 3), at_most=1.2)  # fmt: skip


def most(make: Callable[[], object], pieces: list[bytes]) -> float:
    """The most bytes in use while frames are found and let go."""
    framer = make()
    tracemalloc.start()
    for piece in pieces:
        framer.feed(piece)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return peak


if __name__ == "__main__":
    printed(rows())
