"""The word map of a device, read from its CSV as any user would, and values taken from words by its bits."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from functools import cache

from fieldspec.foundation.names import stem
from fieldspec.targets.kv.backend import files
from layouts import SPECS, TEST_SPECS, layouts

Row = dict[str, str]

ROOTS = {name: root for root in (SPECS, TEST_SPECS) for name in layouts(root)}


@cache
def texts(device: str) -> dict[str, str]:
    """The files of a device."""
    return files(layouts(ROOTS[device])[device])


@cache
def word_map(device: str, version: str) -> list[Row]:
    """The rows of a version's map, except for the identity."""
    text = texts(device)[f"{stem(device, version)}_words.csv"]
    assert text.startswith("\ufeff")
    return list(csv.DictReader(io.StringIO(text[1:], newline=""), strict=True))[1:]


@cache
def comments(device: str, version: str) -> list[list[str]]:
    """Devices and comments of a version."""
    text = texts(device)[f"{stem(device, version)}_comments.csv"]
    return list(csv.reader(io.StringIO(text, newline=""), strict=True))


def number(row: Row, words: Sequence[int], element: int = 0) -> int:
    """The bits of a row, the most significant first, as an unsigned number."""
    base = int(row["word"]) + element * int(row["stride"] or 0)
    value = 0
    for run in row["bits"].split(" "):
        word, _, span = run.rpartition(":")
        high, _, low = span.partition("..")
        width = int(high) - int(low or high) + 1
        raw = words[base + int(word or 0)] >> int(low or high)
        value = value << width | raw & ((1 << width) - 1)
    return value


def signed(row: Row, words: Sequence[int], element: int = 0) -> int:
    """The bits of a row as a number, signed if the type of the row is."""
    value = number(row, words, element)
    if row["type"].startswith("sm"):
        sign = 1 << (int(row["type"].removeprefix("sm")) - 1)
        return -(value ^ sign) if value & sign else value
    size = int(row["type"].lstrip("iu") or 0) if row["type"][:1] == "i" else 0
    return value - (1 << size) if size and value >> (size - 1) else value


def memory(data: bytes, unit: int) -> list[int]:
    """Bytes as words of one or two bytes, the first byte of two in the upper half."""
    padded = data + b"\0" * (-len(data) % unit)
    return [int.from_bytes(padded[at : at + unit], "big") for at in range(0, len(padded), unit)]
