"""The firmware of a device, by the value that the spec says tells it."""

from __future__ import annotations

from fieldspec.codec.layout.detection import detecting_value
from fieldspec.codec.layout.device import DeviceLayout
from fieldspec.foundation.classes import TYPE_CHECKING, dataclass
from fieldspec.foundation.runtime._firmware import UnknownFirmwareError, module_name, version_in
from fieldspec.language.model.encoding import is_text
from fieldspec.tools.live.client import Client
from fieldspec.tools.live.messages import read_signals, signals
from fieldspec.tools.live.reading import all_occupants, blocks, message_for, read

if TYPE_CHECKING:
    from collections.abc import Sequence

    from fieldspec.codec.explain.values import DecodedValue
    from fieldspec.language.model.fact import Fact


@dataclass(frozen=True, slots=True)
class Firmware:
    """The reported firmware of a device: the value as text, and its version in the spec.

    `version` is empty if the spec has no such version, and `doubt` then says why; both are empty if the spec does not
    state the value that identifies the version, or how. `is_asked` says whether a message of the link reads the value.
    """

    text: str = ""
    version: str = ""
    doubt: str = ""
    is_asked: bool = True


def firmware_of(client: Client, versions: Sequence[str]) -> Firmware:
    """The firmware of a device; `versions` are the versions of its spec. Raises NoAnswerError and CarrierError."""
    layout = client.layout
    detection = layout.device.detection
    value = detecting_value(layout.device, detection) if detection is not None else None
    if detection is None or value is None:
        return Firmware()
    named_versions = _named(layout)
    if not is_text(value.encoding) and not detection.form and not named_versions:
        return Firmware()  # how a number is read is not known
    answers = _answers(client, detection.fact)
    if not answers:
        return Firmware("", "", f"no message on {client.frames.link.name} reads {detection.fact}", is_asked=False)
    number = answers[0].number if answers[0] is not None else None
    if isinstance(number, bytes):
        number = number.decode("ascii", "replace")
    if number is None or isinstance(number, (list, dict, float)):
        return Firmware("", "", f"the device does not say its firmware in {detection.fact}")
    text = str(number).strip(" \t\r\n\0")
    if not text:
        return Firmware("", "", f"the device does not say its firmware in {detection.fact}")
    places = value.size if detection.form == "bytes" else detection.places
    lines = tuple(
        tuple((version.id, version.id) for version in line.versions if version.id in versions)
        for line in layout.device.lines
    )
    try:
        version = version_in(lines, number, detection.form, places, named_versions)
        return Firmware(text, module_name(lines, version, False))
    except UnknownFirmwareError as error:
        return Firmware(text, "", str(error))


def _named(layout: DeviceLayout) -> dict[str | int, str]:
    """The versions that single values of the detection tell."""
    return {
        item: version.id for line in layout.device.lines for version in line.versions for item in version.detected_as
    }


def _answers(client: Client, path: str) -> list[DecodedValue | None]:
    """The value of a fact by its path, None where the device refuses it; none where no message of the link reads it."""

    def is_meant(fact: Fact) -> bool:
        return fact.place.path == path

    def is_readable(space: str, words: int) -> bool:
        return message_for(client.layout.device, client.frames.link, "read", space, words) is not None

    matches = [pair for pair in all_occupants(client.layout) if is_meant(pair[1].fact)]
    occupants = [(space, occupant) for space, occupant in matches if is_readable(space, occupant.words)]
    answers = [reading.decoded for reading in read(client, blocks(client.layout, occupants[:1]))]
    own = [signal for signal in signals(client.layout, client.frames.link) if is_meant(signal.fact)]
    return answers or [reading.decoded for reading in read_signals(client, own[:1])]
