"""What the manual prints of an example frame, and whether that is right."""

from __future__ import annotations

from fieldspec.classes import dataclass
from fieldspec.model.device import Device
from fieldspec.model.erratum import Erratum
from fieldspec.model.example import Example


@dataclass(frozen=True, slots=True)
class Printed:
    """An example as the manual prints it.

    `frame` are its bytes as hexadecimal digits, empty where it is computed or has parts that are printed as dots;
    where only the row of characters is misprinted, they are the bytes of that row. `characters` is the row of
    characters, empty where the manual has none. The verdict is `ok`, `misprint`, or `open` where the manual does
    not decide which bytes are right. `errata` are all those of the example.
    """

    frame: str
    characters: str
    verdict: str
    errata: tuple[Erratum, ...]


def printed(device: Device, example: Example) -> Printed:
    """The print of an example: that of its errata, or else the example itself."""
    errata = tuple(erratum for erratum in device.errata if erratum.fact == example.place.path)
    frames = [erratum for erratum in errata if "frame" in erratum.printed]
    rows = [erratum for erratum in errata if "characters" in erratum.printed]
    characters = _characters(rows[0].printed["characters"]) if rows else example.characters
    if example.origin == "computed" or example.elided:
        frame = ""
    elif frames:
        frame = "".join(str(frames[0].printed["frame"]).split()).upper()
    else:
        frame = (characters.encode("latin-1", "replace") if rows else example.frame).hex().upper()
    verdict = "misprint" if frames or rows else "ok"
    if any(erratum.confidence == "open" for erratum in (*frames, *rows)):
        verdict = "open"
    return Printed(frame, characters, verdict, errata)


def _characters(held: object) -> str:
    """A row of characters as an erratum writes it, with its control characters."""
    return str(held).replace("\\r", "\r").replace("\\n", "\n")
