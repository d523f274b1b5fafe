"""The value by which a simulated device tells its version: the opposite of how a program detects it."""

from __future__ import annotations

from collections.abc import Iterator

from fieldspec.codec.layout.detection import VersionDetection, detecting_value, version_detection
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import dataclass
from fieldspec.foundation.runtime._firmware import EARLIER, UnknownFirmwareError, module_name, version_in
from fieldspec.language.behaviour.names import Names
from fieldspec.language.behaviour.part import Behaviour
from fieldspec.language.model.device import Device
from fieldspec.language.model.encoding import is_text
from fieldspec.language.model.text_form import text_bytes
from fieldspec.language.model.value import Value

_BASES = {"decimal": 10, "hexadecimal": 16}


@dataclass(frozen=True, slots=True)
class ReportedVersion:
    """The reported version of a device: the path of the `fact`, its value, and the version that it identifies."""

    fact: str
    reported: int | str
    version: str
    value: Value

    @property
    def raw(self) -> int | str | bytes:
        """The value as the memory of a device has it."""
        if isinstance(self.reported, int) or self.value.text_form is not None:
            return self.reported
        return text_bytes(self.value, "big", self.reported)

    @property
    def text(self) -> str:
        """The sentence that tells a person which version the device reports."""
        return f"{self.fact} is {self.reported}, which identifies the version {self.version}"


def reported_version(layout: DeviceLayout, behaviour: Behaviour) -> ReportedVersion | None:
    """The value that identifies the version of a device; None where the spec does not say it, or where no value can be
    it.

    It is None too where the behaviour states the value.
    """
    device = layout.device
    detection, version_form = device.detection, version_detection(device)
    value = detecting_value(device, detection) if detection is not None else None
    if version_form is None or value is None or value.const is not None:
        return None
    names = Names(device, behaviour)
    stated = [part.subject for kind in ("initial", "show") for part in behaviour.of_kind(kind)]
    if any(
        operand.path == version_form.fact for signal in stated for operand in names.of_signal(signal.partition("[")[0])
    ):
        return None
    usual = [] if value.default is None else [value.default]
    for candidate in (*usual, *_candidates(version_form, device.version, value)):
        if isinstance(candidate, int | str) and _fits(value, candidate) and _tells(device, version_form, candidate):
            return ReportedVersion(version_form.fact, candidate, device.version, value)
    return None


def _candidates(version_form: VersionDetection, version: str, value: Value) -> Iterator[int | str]:
    """Values that may tell a version: those that the spec names, then those whose digits are the version."""
    yield from (item for item, named_version in version_form.named if named_version == version)
    if is_text(value.encoding):
        yield from (version, *map(_dotted, _numbers_of(version)))
        return
    for numbers in _numbers_of(version):
        yield from _whole(version_form, numbers, version)


def _numbers_of(version: str) -> Iterator[list[int]]:
    """The numbers of a version; of all before a version those just below it."""
    parts = version.removeprefix(EARLIER).lstrip("vV").split(".")
    if not all(part.isascii() and part.isdigit() for part in parts):
        return
    numbers = list(map(int, parts))
    if not version.startswith(EARLIER):
        yield numbers
        return
    last = max((index for index, number in enumerate(numbers) if number), default=None)
    if last is not None:
        yield [*numbers[:last], numbers[last] - 1, *(9 for _ in numbers[last + 1 :])]


def _whole(version_form: VersionDetection, numbers: list[int], version: str) -> Iterator[int]:
    """The numbers whose digits or bytes form a version."""
    if version_form.form == "bytes" and len(numbers) <= version_form.places and max(numbers) <= 0xFF:
        yield int.from_bytes(bytes(numbers).ljust(version_form.places, b"\0"), "big")
    base = _BASES.get(version_form.form)
    if base is None:
        return
    printed = version.partition(".")[2]
    minor = "".join(map(str, numbers[1:]))
    for digits in (printed, minor.rjust(version_form.places, "0"), minor.ljust(version_form.places, "0")):
        if len(digits) == version_form.places and (digits or "0").isdigit():
            yield int(f"{numbers[0]}{digits}", base)


def _dotted(numbers: list[int]) -> str:
    return ".".join(map(str, numbers))


def _fits(value: Value, candidate: int | str) -> bool:
    if is_text(value.encoding):
        room = value.size if value.text_form is None else value.text_form.room(value.size)
        return isinstance(candidate, str) and len(candidate) <= room
    in_bounds = isinstance(candidate, int) and value.low <= candidate <= value.high
    return in_bounds and (value.ranges is None or candidate in value.ranges)


def _tells(device: Device, version_form: VersionDetection, candidate: int | str) -> bool:
    """Whether a program that reads the value chooses the version of the device."""
    lines = tuple(
        tuple((version.id, version.id) for version in line.versions)
        for line in device.lines
        if line.builds or line.like
    )
    try:
        version = version_in(lines, candidate, version_form.form, version_form.places, dict(version_form.named))
        return module_name(lines, version, False) == device.version
    except UnknownFirmwareError:
        return False
