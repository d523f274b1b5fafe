"""Raw values as specs write them, for findings and messages."""

from __future__ import annotations

import json
from collections.abc import Mapping
from decimal import Decimal
from typing import Any


def spec_text(raw: Any) -> str:
    """`12`, `true`, `FF 0A`, `"a text"`, `[1, 2]` or `{id: 1, time: 0}`: a raw value as a spec writes it."""
    if raw is None:
        return "nothing"
    if isinstance(raw, bool):
        return str(raw).lower()
    if isinstance(raw, bytes | bytearray):
        return raw.hex(" ").upper()
    if isinstance(raw, str):
        return json.dumps(raw, ensure_ascii=False)
    if isinstance(raw, Mapping):
        return f"{{{', '.join(f'{name}: {spec_text(value)}' for name, value in raw.items())}}}"
    if isinstance(raw, Decimal):
        return f"{raw:f}"
    if isinstance(raw, list | tuple):
        return f"[{', '.join(map(spec_text, raw))}]"
    return str(raw)
