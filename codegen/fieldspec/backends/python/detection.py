"""How a program finds the version of a device: the value that tells it, and how a number in it is read."""

from __future__ import annotations

import textwrap
from typing import Any

from fieldspec.backends.fact_texts import number_text
from fieldspec.backends.python.text import WIDTH, literal
from fieldspec.layout.device import DeviceLayout
from fieldspec.model.attributes import descendants
from fieldspec.model.device import Detection, Device
from fieldspec.model.fact import Fact
from fieldspec.model.value import Kind, Value


def detection_view(layout: DeviceLayout) -> dict[str, Any]:
    """What the choice by firmware needs: the path as a literal, the argument's type, and what a number stands for.

    `fact` is empty where no line states what tells its version; `reads` says whether a value is more than a text.
    """
    device = layout.device
    detection = device.detection
    if detection is None:
        return {"fact": "", "type": "str", "doc": [], "named": [], "reads": False}
    value = detecting_value(device, detection)
    number = value is not None and value.type.kind is Kind.INTEGER
    versions = [version for line in device.lines if line.builds or line.like for version in line.versions]
    named = [
        (literal(item) if isinstance(item, str) else str(item), literal(version.id))
        for version in versions
        for item in version.detected_as
    ]
    places = value.size if detection.form == "bytes" and value is not None else detection.places
    text = f"The device tells its version in `{detection.fact}`. {number_text(detection)}".strip()
    return {
        "fact": literal(detection.fact),
        "type": "str | int" if number and (detection.form or named) else "str",
        "doc": textwrap.wrap(text, WIDTH - 4),
        "named": named,
        "form": literal(detection.form),
        "places": places,
        "reads": bool(named or detection.form),
    }


def detecting_value(device: Device, detection: Detection) -> Value | None:
    """The value of the fact that tells the version."""
    for fact in descendants(device):
        if isinstance(fact, Fact) and fact.place.path == detection.fact:
            value = getattr(fact, "value", None)
            return value if isinstance(value, Value) else None
    return None
