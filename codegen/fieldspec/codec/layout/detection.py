"""How a program finds the version of a device: the value that tells it, and how a number in it is read."""

from __future__ import annotations

from collections.abc import Container

from fieldspec.foundation.classes import dataclass
from fieldspec.language.model.attributes import descendants
from fieldspec.language.model.device import Detection, Device
from fieldspec.language.model.encoding import is_count
from fieldspec.language.model.fact import Fact
from fieldspec.language.model.value import Value


@dataclass(frozen=True, slots=True)
class VersionDetection:
    """The value of the device that tells its version: the `fact` with it, and what its numbers stand for.

    `named` has single values with the ids of their versions; `takes_numbers` says whether the value is a number that
    stands for a version, and `reads_values` whether it is more than a text. `places` is the size in bytes for the form
    `bytes`.
    """

    fact: str
    form: str
    places: int
    named: tuple[tuple[str | int, str], ...]
    takes_numbers: bool

    @property
    def reads_values(self) -> bool:
        """Whether a value is more than the text of a version."""
        return bool(self.named or self.form)


def version_detection(device: Device) -> VersionDetection | None:
    """The value that identifies the version of a device; None where no line states it."""
    detection = device.detection
    if detection is None:
        return None
    value = detecting_value(device, detection)
    number = value is not None and is_count(value.encoding)
    versions = [version for line in device.lines if line.builds or line.like for version in line.versions]
    detected_values = tuple((item, version.id) for version in versions for item in version.detected_as)
    return VersionDetection(
        fact=detection.fact,
        form=detection.form,
        places=value.size if detection.form == "bytes" and value is not None else detection.places,
        named=detected_values,
        takes_numbers=number and bool(detection.form or detected_values),
    )


def version_lines(device: Device, versions: Container[str]) -> list[list[str]]:
    """The versions of each line that have a module; all in one line where the device declares no lines."""
    lines = [[version.id for version in line.versions if version.id in versions] for line in device.lines]
    return [line for line in lines if line] or [[device.version]]


def detecting_value(device: Device, detection: Detection) -> Value | None:
    """The value of the fact that identifies the version."""
    value = getattr(detecting_fact(device, detection), "value", None)
    return value if isinstance(value, Value) else None


def detecting_fact(device: Device, detection: Detection) -> Fact | None:
    """The fact that identifies the version; None where the device has no such fact."""
    paths = (fact for fact in descendants(device) if isinstance(fact, Fact))
    return next((fact for fact in paths if fact.place.path == detection.fact), None)
