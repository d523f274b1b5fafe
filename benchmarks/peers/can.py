"""The point record of CK10 as a message of a CAN database: 64 bytes, big-endian signals."""

from __future__ import annotations

import re
from typing import Any

from peers.point import FIELDS, STRUCT


def message() -> Any:
    """The message. cantools counts the bits of a big-endian signal from its most significant one."""
    from cantools.database import Message
    from cantools.database.can import Signal
    from cantools.database.conversion import BaseConversion

    conversion = BaseConversion.factory(is_float=False)
    sizes = {"i": (4, True), "I": (4, False), "H": (2, False)}
    signals, at, names = [], 0, iter(FIELDS)
    for count, letter in re.findall(r"(\d*)([xiIH])", STRUCT.format):
        if letter == "x":
            at += int(count or 1)
            continue
        for _ in range(int(count or 1)):
            size, signed = sizes[letter]
            signals.append(
                Signal(
                    next(names),
                    8 * at + 7,
                    8 * size,
                    byte_order="big_endian",
                    is_signed=signed,
                    conversion=conversion,
                )
            )
            at += size
    return Message(frame_id=1, name="point", length=64, signals=signals, is_fd=True)
