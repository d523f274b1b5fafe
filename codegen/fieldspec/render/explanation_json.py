"""The explanation of a frame as plain data for JSON.

Bytes are pairs of hexadecimal digits in one text. What does not apply is null.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from decimal import Decimal

from fieldspec.layout.device import DeviceLayout
from fieldspec.layout.explanation import Explanation, Reading, Row


def as_data(
    layout: DeviceLayout,
    held: Explanation,
    readings: Sequence[Reading],
    chosen: str,
    remarks: Sequence[str],
    wrong: bool,
) -> dict[str, object]:
    """An explanation with the readings that fit, how one was chosen, and remarks on the text and the request."""
    errata = {number for row in (*held.rows, *held.registers) for number in row.errata} | set(held.errata)
    return {
        "device": layout.device.id,
        "version": layout.device.version,
        "frame": _hex(held.frame),
        "link": held.link,
        "direction": held.direction,
        "direction_name": layout.device.links[held.link].direction_name(held.direction),
        "message": held.message or None,
        "error": held.error,
        "wrong": wrong,
        "reasons": list(held.reasons),
        "chosen": chosen,
        "readings": [_reading(reading) for reading in readings],
        "remarks": list(remarks),
        "values": _plain(held.values),
        "rows": [_row(row) for row in held.rows],
        "registers": [_row(row) for row in held.registers],
        "errata": [
            {"id": erratum.id, "fact": erratum.fact, "printed": _printed(erratum.printed), "reason": erratum.reason}
            for erratum in layout.device.errata
            if erratum.id in errata
        ],
    }


def _reading(reading: Reading) -> dict[str, object]:
    link, direction, message, error = reading
    return {"link": link, "direction": direction, "message": message or None, "error": error}


def _row(row: Row) -> dict[str, object]:
    return {
        "kind": row.kind,
        "offset": row.offset,
        "length": row.length,
        "raw": _hex(row.raw),
        "characters": row.characters or None,
        "path": row.path or None,
        "fact": row.fact or None,
        "printed_name": row.printed_name or None,
        "label": row.label or None,
        "doc": row.doc or None,
        "number": _plain(row.number),
        "value": row.value or None,
        "meanings": [
            {
                "name": meaning.name or None,
                "label": meaning.label or None,
                "text": meaning.text or None,
                "bits": meaning.bits or None,
            }
            for meaning in row.meanings
        ],
        "verdict": row.verdict or None,
        "reason": row.reason or None,
        "source": row.source or None,
        "notes": list(row.notes),
        "errata": list(row.errata),
        "address": row.address,
        "words": row.words or None,
        "access": row.access or None,
    }


def _hex(data: bytes) -> str:
    return data.hex().upper()


def _plain(value: object) -> object:
    """A raw value: numbers as they are, but for those that JSON does not have; bytes as digits."""
    if isinstance(value, bytes):
        return _hex(value)
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if isinstance(value, list):
        return [_plain(item) for item in value]
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return value


def _printed(printed: Mapping[str, object]) -> dict[str, object]:
    """What the manual prints, key by key; exact numbers as text."""
    return {key: str(value) if isinstance(value, Decimal) else value for key, value in printed.items()}
