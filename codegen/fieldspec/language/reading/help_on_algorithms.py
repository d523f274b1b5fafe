"""The algorithms that the unknown name of a checksum may mean."""

from __future__ import annotations

import re
from collections.abc import Collection

from fieldspec.language.model.checksums import public_crcs

_WITH_POLYNOMIAL = re.compile(r"crc[-_]?([0-9]{1,2})[-_](?:0x)?([0-9a-f]{1,16})", re.IGNORECASE)


def algorithm_help(text: str, known: Collection[str]) -> str:
    """The CRCs with the polynomial that a name holds, as it is or with its bits reversed; empty where it holds none."""
    match = _WITH_POLYNOMIAL.fullmatch(text)
    if match is None:
        return ""
    width, polynomial = int(match[1]), int(match[2], 16)
    mirrored = int(f"{polynomial:0{width}b}"[::-1], 2) if polynomial < 1 << width else -1
    for number in (polynomial, mirrored):
        alike = [
            name
            for name, crc in public_crcs().items()
            if name in known and (crc.width, crc.polynomial) == (width, number)
        ]
        if alike:
            names = ", ".join(f"`{name}`" for name in alike)
            text = f"with the polynomial {number:#0{2 + width // 4}x} there are {names}, which differ in their initial "
            return f"{text}values, bit orders and final values; state the parameters of any other in its place"
    return ""
