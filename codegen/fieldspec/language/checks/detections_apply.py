"""The value that identifies the version of a device is readable and has one interpretation.

Why: programs choose the code of a version by this value. A wrong choice reads and writes other addresses. The value has
the same address, type, order and scale in all versions, because a program reads it before it knows the version.

Example: `form: decimal` for a text, a setting that users write, or `detected_as: [104]` in two versions of a line. Or
`form: decimal` without `places` for the versions 1.00 and 1.20: no number means 1.20.

Fix: Name a register, a parameter or a field of a response. State `form` and `places` for whole numbers only, and a
different `detected_as` for each version. All lines with outputs state the same `detected_by`, or only one line states
it. Write the versions with `places` digits after the point. Name a value that all versions have at the same address;
without such a value, omit `detected_by`.
"""

from __future__ import annotations

import re

from fieldspec.foundation.line_text import plural
from fieldspec.language.checks.facts import facts
from fieldspec.language.checks.finding import Findings, finding, label
from fieldspec.language.diagnostics import Severity
from fieldspec.language.model.device import Detection, Device, VersionLine
from fieldspec.language.model.encoding import is_count, is_text
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value

_EARLIER = "before-"
_DECIMAL = re.compile("[0-9]{1,9}")
_HEXADECIMAL = re.compile("[0-9A-F]{1,9}")
_HELP = "correct `form` and `places`, write the version with the same number of digits, or add `detected_as`"


def detections_apply(device: Device) -> Findings:
    for line in device.lines:
        detection = line.detected_by
        if detection is not None:
            yield from _of_detection(device, line, detection)
        elif any(version.detected_as for version in line.versions):
            text = f"no value identifies the version of {line.name}, so `detected_as` does not apply"
            yield finding(device.place, "id", text, "state `detected_by` in the line, or remove `detected_as`")
    chosen = device.detection
    for line in device.lines:
        own = line.detected_by or (chosen if line.builds or line.like else None)
        if own is not None:
            yield from _unrepresented(device, line, own)
    for line in device.lines:
        other = line.detected_by
        if chosen is None or other is None or not (line.builds or line.like):
            continue
        if (other.fact, other.form, other.places) != (chosen.fact, chosen.form, chosen.places):
            text = "lines with outputs have their versions in different values"
            related_label = label(chosen.place, "fact", "another one")
            yield finding(other.place, "fact", text, "state one of them for all lines", related_label)


def _of_detection(device: Device, line: VersionLine, detection: Detection) -> Findings:
    fact = _fact(device, detection)
    if fact is None:
        return
    value = getattr(fact, "value", None)
    is_request = getattr(fact, "access", "") == "wo" or "/request/" in detection.fact
    if not isinstance(value, Value) or not (is_count(value.encoding) or is_text(value.encoding)):
        text = f"{detection.fact} is neither a whole number nor a text"
        yield finding(detection.place, "fact", text, "name the value that identifies the version")
        return
    if is_request:
        text = f"{detection.fact} cannot be read"
        yield finding(detection.place, "fact", text, "name a value that the device sends")
    elif getattr(fact, "access", "") == "rw":
        text = f"{detection.fact} can be written, so it seldom identifies the version"
        help = (
            "name the value of the firmware, or correct the access; if it does, allow this with a reason at the value"
        )
        related_label = label(fact.place, "access", "its access")
        yield finding(detection.place, "fact", text, help, related_label, severity=Severity.WARNING)
    number = is_count(value.encoding)
    if detection.form and not number:
        text = f"{detection.fact} is a text, which is the version itself"
        yield finding(detection.place, "form", text, "remove it")
    if detection.places and detection.form not in ("decimal", "hexadecimal"):
        text = "only `form: decimal` and `form: hexadecimal` have places after the point"
        yield finding(detection.place, "places", text, "state the form, or remove it")
    first: dict[int | str, str] = {}
    for version in line.versions:
        for item in version.detected_as:
            if isinstance(item, int) is not number or (isinstance(item, int) and not _holds(value, item)):
                text = f"{detection.fact} cannot be {item}, which must identify {version.id}"
                yield finding(detection.place, "fact", text, f"correct `detected_as` of {version.id}")
            elif other := _read_as(detection, item, [v.id for v in line.versions if v is not version]):
                text = f"{item} tells {version.id}, and is {other} in the form {detection.form}"
                yield finding(detection.place, "form", text, f"correct `detected_as` of {version.id}, or the form")
            elif first.setdefault(item, version.id) != version.id:
                text = f"{item} tells both {first[item]} and {version.id}"
                yield finding(detection.place, "fact", text, "correct `detected_as` of one of them")


def _read_as(detection: Detection, item: int | str, other_versions: list[str]) -> str:
    """The other version that a number is in the form of the detection, or an empty text."""
    if isinstance(item, str) or item < 0 or detection.form not in ("decimal", "hexadecimal"):
        return ""
    digits = (f"{item:d}" if detection.form == "decimal" else f"{item:X}").rjust(detection.places + 1, "0")
    places = detection.places
    text = f"{digits[:-places]}.{digits[-places:]}" if places else digits
    return text if text in other_versions else ""


def _fact(device: Device, detection: Detection) -> Fact | None:
    return next((fact for fact in facts(device) if fact.place.path == detection.fact), None)


def _unrepresented(device: Device, line: VersionLine, detection: Detection) -> Findings:
    """The versions that no number of the value stands for, where a form says how numbers are read."""
    value = getattr(_fact(device, detection), "value", None)
    if not isinstance(value, Value) or not is_count(value.encoding) or not detection.form:
        return
    for version in line.versions:
        if version.detected_as:
            continue
        bound = version.id.removeprefix(_EARLIER)
        number = _number_of(bound, detection, value.size)
        if isinstance(number, str):
            yield finding(detection.place, "form", f"no number tells {version.id}: {number}", _HELP)
        elif bound == version.id and not _holds(value, number):
            text = f"{detection.fact} cannot be {number}, which must identify {version.id}"
            yield finding(detection.place, "fact", text, _HELP)


def _number_of(version: str, detection: Detection, size: int) -> int | str:
    """The number that stands for a version; a text that says why there is none."""
    digits = version[version[:1] in ("v", "V") :]
    if detection.form == "bytes":
        numbers = [int(part) if _DECIMAL.fullmatch(part) else 256 for part in digits.split(".")]
        if max(numbers) > 255 or any(numbers[size:]):
            return f"as bytes it is not a number of {plural(size, 'byte')}"
        return int.from_bytes(bytes([*numbers, *bytes(size)][:size]), "big")
    places = detection.places
    head, _, fraction = digits.partition(".")
    if not (_DECIMAL if detection.form == "decimal" else _HEXADECIMAL).fullmatch(head + fraction):
        return f"it does not consist of {detection.form} digits" + (
            " in capitals" if detection.form != "decimal" else ""
        )
    if not places and fraction:
        return f"without `places`, it has no point, and {version} has {plural(len(fraction), 'digit')} after it"
    # Only numbers are compared without zeros; a version with letters has to be what is read.
    is_exact = not _DECIMAL.fullmatch(head + fraction)
    if len(fraction) != places and (fraction.strip("0") or is_exact):
        return f"it has {plural(places, 'digit')} after the point, and {version} has {len(fraction)}"
    if is_exact and (digits != version or head != (head.lstrip("0") or "0" * bool(places))):
        return "a version with letters begins with neither zeros nor a `v`"
    return int(head + fraction[:places].ljust(places, "0"), 10 if detection.form == "decimal" else 16)


def _holds(value: Value, item: int) -> bool:
    low, high = value.type.low, value.type.high
    return low <= item <= high and (value.ranges is None or item in value.ranges)
