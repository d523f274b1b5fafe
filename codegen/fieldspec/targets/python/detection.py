"""The data for the choice by firmware in a generated package."""

from __future__ import annotations

import textwrap
from typing import Any

from fieldspec.codec.layout.detection import version_detection
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.targets.fact_texts import detection_text
from fieldspec.targets.python.text import WIDTH, literal


def detection_view(layout: DeviceLayout) -> dict[str, Any]:
    """The data for the choice by firmware: the path as a literal, the argument's type, and the meaning of a number.

    `fact` is empty where no line states what tells its version; `reads` says whether a value is more than a text.
    """
    stated = layout.device.detection
    detection = version_detection(layout.device)
    if detection is None or stated is None:
        return {"fact": "", "type": "str", "doc": [], "named": [], "reads": False}
    detected_values = [
        (literal(value) if isinstance(value, str) else str(value), literal(version))
        for value, version in detection.named
    ]
    return {
        "fact": literal(detection.fact),
        "type": "str | int" if detection.takes_numbers else "str",
        "doc": textwrap.wrap(detection_text(stated), WIDTH - 4),
        "named": detected_values,
        "form": literal(detection.form),
        "places": detection.places,
        "reads": detection.reads_values,
    }
