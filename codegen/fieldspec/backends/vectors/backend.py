"""The file of vectors."""

from __future__ import annotations

import json
from collections.abc import Sequence

from fieldspec.backends.vectors.view import vectors
from fieldspec.layout.device import DeviceLayout


def files(layouts: Sequence[DeviceLayout]) -> dict[str, str]:
    """The example frames of all versions of one device, the oldest first, by path."""
    device = layouts[-1].device.id
    document = {
        "device": device,
        "identities": {layout.device.version: layout.identity for layout in layouts},
        "vectors": vectors(layouts),
    }
    return {f"{device}.json": json.dumps(document, ensure_ascii=False, allow_nan=False, indent=1) + "\n"}


def shared() -> dict[str, str]:
    """No file: every vector belongs to a device."""
    return {}
