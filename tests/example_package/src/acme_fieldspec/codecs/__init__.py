"""Codecs that no key of the language describes: numbers of two old instruments, and a checksum of the company."""

from __future__ import annotations

from importlib.resources import files

from fieldspec.extension import ChecksumCodec, NumberCodec


def _text(name: str) -> str:
    return files("acme_fieldspec.codecs").joinpath(name).read_text("utf-8")


FLOAT = NumberCodec(
    version="1",
    size=3,
    low=-655_350_000,
    high=655_350_000,
    python=_text("acme_float.py"),
    c=_text("acme_float.h"),
    javascript=_text("acme_float.js"),
    rounds=True,
)
"""A sign and a power of ten in the first byte, and 16 bits before it."""

GRAY = NumberCodec(
    version="1",
    size=2,
    low=0,
    high=0xFFFF,
    python=_text("acme_gray.py"),
    c=_text("acme_gray.h"),
    javascript=_text("acme_gray.js"),
)
"""The tracks of an encoder, of which one changes at each step."""

ROLLING = ChecksumCodec(
    version="1",
    size=2,
    python=_text("acme_rolling.py"),
    c=_text("acme_rolling.h"),
    javascript=_text("acme_rolling.js"),
)
"""A sum that is turned by three bits before each byte."""
