"""The value that tells the version of a device can be read, and is read in one way.

Why: programs choose the code of a version by this value. A wrong choice reads and writes other addresses.

Example: `form: decimal` for a text, or `detected_as: [104]` in two versions of a line.

Cure: Name a register, a parameter or a field of a response. State `form` and `places` for whole numbers only, and a
different `detected_as` for each version. All lines with outputs state `detected_by` alike, or one of them does.
"""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.checks.facts import facts
from fieldspec.checks.finding import finding, label
from fieldspec.diagnostics import Diagnostic
from fieldspec.model.device import Detection, Device, VersionLine
from fieldspec.model.value import Kind, Value

_CODE = "detections_apply"


def detections_apply(device: Device) -> Iterator[Diagnostic]:
    for line in device.lines:
        detection = line.detected_by
        if detection is not None:
            yield from _of_detection(device, line, detection)
        elif any(version.detected_as for version in line.versions):
            text = f"no value tells the version of {line.name}, so `detected_as` does not apply"
            yield finding(_CODE, device.place, "id", text, "state `detected_by` in the line, or remove `detected_as`")
    chosen = device.detection
    for line in device.lines:
        other = line.detected_by
        if chosen is None or other is None or not (line.builds or line.like):
            continue
        if (other.fact, other.form, other.places) != (chosen.fact, chosen.form, chosen.places):
            text = "lines with outputs have their versions in different values"
            there = label(chosen.place, "fact", "another one")
            yield finding(_CODE, other.place, "fact", text, "state one of them for all lines", there)


def _of_detection(device: Device, line: VersionLine, detection: Detection) -> Iterator[Diagnostic]:
    fact = next((fact for fact in facts(device) if fact.place.path == detection.fact), None)
    if fact is None:
        return
    value = getattr(fact, "value", None)
    is_request = getattr(fact, "access", "") == "wo" or "/request/" in detection.fact
    if not isinstance(value, Value) or value.type.kind not in (Kind.INTEGER, Kind.TEXT):
        text = f"{detection.fact} is neither a whole number nor a text"
        yield finding(_CODE, detection.place, "fact", text, "name the value that tells the version")
        return
    if is_request:
        text = f"{detection.fact} cannot be read"
        yield finding(_CODE, detection.place, "fact", text, "name a value that the device sends")
    number = value.type.kind is Kind.INTEGER
    if detection.form and not number:
        text = f"{detection.fact} is a text, which is the version itself"
        yield finding(_CODE, detection.place, "form", text, "remove it")
    if detection.places and detection.form not in ("decimal", "hexadecimal"):
        text = "only `form: decimal` and `form: hexadecimal` have places after the point"
        yield finding(_CODE, detection.place, "places", text, "state the form, or remove it")
    first: dict[int | str, str] = {}
    for version in line.versions:
        for item in version.detected_as:
            if isinstance(item, int) is not number or (isinstance(item, int) and not _holds(value, item)):
                text = f"{detection.fact} cannot be {item}, which is to tell {version.id}"
                yield finding(_CODE, detection.place, "fact", text, f"correct `detected_as` of {version.id}")
            elif other := _read_as(detection, item, [v.id for v in line.versions if v is not version]):
                text = f"{item} tells {version.id}, and is {other} in the form {detection.form}"
                yield finding(
                    _CODE, detection.place, "form", text, f"correct `detected_as` of {version.id}, or the form"
                )
            elif first.setdefault(item, version.id) != version.id:
                text = f"{item} tells both {first[item]} and {version.id}"
                yield finding(_CODE, detection.place, "fact", text, "correct `detected_as` of one of them")


def _read_as(detection: Detection, item: int | str, others: list[str]) -> str:
    """The other version that a number is in the form of the detection, or an empty text."""
    if isinstance(item, str) or item < 0 or detection.form not in ("decimal", "hexadecimal"):
        return ""
    digits = (f"{item:d}" if detection.form == "decimal" else f"{item:X}").rjust(detection.places + 1, "0")
    places = detection.places
    text = f"{digits[:-places]}.{digits[-places:]}" if places else digits
    return text if text in others else ""


def _holds(value: Value, item: int) -> bool:
    low, high = value.type.low, value.type.high
    return low <= item <= high and (value.ranges is None or item in value.ranges)
