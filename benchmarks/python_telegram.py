"""Telegram 111 in Python: decode 24 bytes, read a bit, and read all bits, against hand-written code and construct."""

from __future__ import annotations

import gc
import tracemalloc
from collections.abc import Iterator
from importlib.metadata import version

from peers.telegram import Words, with_construct
from rows import Row, printed, timed, use_generated

use_generated()

GROUP = "Python, telegram 111"
DATA = bytes.fromhex("04 BF 91 00 00 07 00 00 00 00 FF FF CF C7 10 00 00 00 00 00 00 00 00 00")
WORDS = 100_000


def rows() -> Iterator[Row]:
    """The rows."""
    from fieldspec_devices.hiwin_e.v2_14_4 import StatusWord1Positioning, Telegram111Response

    telegram, words = Telegram111Response.decode(DATA), Words.decode(DATA)
    status_words = [
        telegram.status_word_1, telegram.positioning_status_word_1, telegram.positioning_status_word_2,
        telegram.status_word_2, telegram.message_word,
    ]  # fmt: skip
    bits = [{name: most << first for name, (first, most) in word._BITS.items()} for word in status_words]
    library = with_construct(bits)
    first, second, third, fourth, fifth = status_words
    names = ", ".join(f"{word}.{name}" for word, some in zip("abcde", bits, strict=True) for name in some)
    read_each = eval(f"lambda: ({names})", dict(zip("abcde", status_words, strict=True)))
    assert telegram.position_actual_a == words.position_actual == library.parse(DATA).part_5
    assert status_words[0].operation_enabled == words.operation_enabled

    def snapshot() -> object:
        return first.flags(), second.flags(), third.flags(), fourth.flags(), fifth.flags()

    number = sum(map(len, bits))
    yield timed(GROUP, "decode", lambda: Telegram111Response.decode(DATA), "struct, bare words",
                lambda: Words.decode(DATA), at_most=1.10)  # fmt: skip
    yield timed(GROUP, "read a bit", lambda: first.operation_enabled, "a property", lambda: words.operation_enabled,
                at_most=1.10)  # fmt: skip
    yield timed(GROUP, f"all {number} bits by snapshots", snapshot, f"{number} reads", read_each, at_most=0.60)
    yield timed(GROUP, "decode", lambda: Telegram111Response.decode(DATA),
                f"construct {version('construct')}, FlagsEnum, compiled", lambda: library.parse(DATA),
                at_least=18)  # fmt: skip
    growth = grown(StatusWord1Positioning)
    yield Row(GROUP, f"memory kept after {WORDS} different words", "a byte a word", growth, WORDS, "bytes",
              round(growth / WORDS, 4), at_most=0.01)  # fmt: skip


def grown(word: type) -> float:
    """How many bytes are in use after many different words more than after one."""
    word(0).flags()
    gc.collect()
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    for raw in range(WORDS):
        word(raw & 0xFFFF).flags()
    gc.collect()
    after = tracemalloc.get_traced_memory()[0]
    tracemalloc.stop()
    return after - before


if __name__ == "__main__":
    printed(rows())
