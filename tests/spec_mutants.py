"""Slips in the specs of devices, as a person makes them who copies a manual: one value of one fact is another one.

A slip changes the text of a spec file. A value that a spec states once for many facts is one value here too.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

from fieldspec.language.reading.device_spec import DeviceSpec
from fieldspec.language.reading.nodes import Scalar
from mutations import ALGORITHMS, NUMBERS, SWAPPED, mappings

Other = Callable[[Scalar, random.Random], str | None]

SECTIONS = (
    "registers",
    "records",
    "messages",
    "parameters",
    "tables",
    "links",
    "flags",
    "enums",
    "conversions",
    "signals",
)
SECOND_STATEMENTS = {"restated", "inferred", "unavailable", "examples"}
"""Keys below which a spec gives reasons, or repeats what it states elsewhere."""

_NUMBER = re.compile(r"0[xX][0-9A-Fa-f]+|-?\d+")
_ACCESSES = ("ro", "rw", "wo")


@dataclass(frozen=True)
class Slip:
    """One value of a spec file, by its offsets in the text, with what is written instead."""

    kind: str
    path: str
    start: int
    end: int
    line: int
    key: str
    right: str
    wrong: str

    def applied(self, files: Mapping[str, bytes]) -> dict[str, bytes]:
        """The files with the slip in one of them."""
        text = files[self.path].decode()
        assert text[self.start : self.end] == self.right
        return {**files, self.path: (text[: self.start] + self.wrong + text[self.end :]).encode()}


def number_text(number: int, like: str) -> str:
    """A number in the spelling of another one."""
    if like[:2] in ("0x", "0X"):
        digits = like[2:]
        text = f"{max(number, 0):0{len(digits)}X}"
        return like[:2] + (text if digits.upper() == digits else text.lower())
    return str(number)


def another_number(scalar: Scalar, chance: random.Random) -> str | None:
    """A number that differs by a little, in one digit, or by the order of two digits."""
    if not _NUMBER.fullmatch(scalar.text):
        return None
    number = int(scalar.text, 0)
    digits = scalar.text[2:] if scalar.text[:2] in ("0x", "0X") else scalar.text.lstrip("-")
    others = [number + 1, number + 2, number + 10, number + 16]
    others += [number - step for step in (1, 10, 16) if number >= step]
    for left in range(len(digits) - 1):
        exchanged = digits[:left] + digits[left + 1] + digits[left] + digits[left + 2 :]
        if digits[left] != digits[left + 1]:
            others.append(int(exchanged, 16 if len(digits) < len(scalar.text.lstrip("-")) else 10))
    return number_text(chance.choice([other for other in others if other != number]), scalar.text)


def near_number(scalar: Scalar, chance: random.Random) -> str | None:
    """A number beside this one, as for bits and the values of enums."""
    if not _NUMBER.fullmatch(scalar.text):
        return None
    number = int(scalar.text, 0)
    return number_text(chance.choice([number + 1, number - 1] if number else [1]), scalar.text)


def another_end(scalar: Scalar, chance: random.Random) -> str | None:
    """A range with one of its numbers changed."""
    if scalar.text[:1] in "\"'":
        return None
    places = list(_NUMBER.finditer(scalar.text.replace("..", "  ")))
    if not places or not re.fullmatch(r"[-0-9A-Fa-fxX., ]+", scalar.text):
        return None
    place = chance.choice(places)
    number = int(place[0], 0)
    others = [number + 1, number * 10 if number else 10, *([number - 1, number // 10] if number > 0 else [])]
    wrong = chance.choice([other for other in others if other != number])
    return scalar.text[: place.start()] + number_text(wrong, place[0]) + scalar.text[place.end() :]


def another_scale(scalar: Scalar, chance: random.Random) -> str | None:
    """A scale that is ten times too large or too small."""
    if not re.fullmatch(r"\d+(\.\d+)?", scalar.text):
        return None
    whole = float(scalar.text)
    return f"{chance.choice((whole * 10, whole / 10)):.10g}"


def another_of(*words: str) -> Other:
    """Another one of some words."""
    return lambda scalar, chance: (
        chance.choice([word for word in words if word != scalar.text]) if scalar.text in words else None
    )


def another_algorithm(scalar: Scalar, chance: random.Random) -> str | None:
    return chance.choice([word for word in ALGORITHMS if word != scalar.text])


def _turned(scalar: Scalar, _: random.Random) -> str | None:
    return SWAPPED.get(scalar.text)


KINDS: dict[str, dict[str, Other]] = {
    "address": {"at": another_number, "base": another_number},
    "code": {"code": another_number, "number": another_number},
    "scale": {"scale": another_scale, "offset": near_number, "full_scale": another_number},
    "order": {"byte_order": _turned, "word_order": _turned},
    "enum value": {"value": near_number},
    "bit": {"bit": near_number, "bits": another_end},
    "range": {"range": another_end, "write_range": another_end},
    "length": {
        "count": near_number,
        "length": near_number,
        "stride": near_number,
        "repeat": another_end,
        "size": near_number,
    },
    "type": {"type": another_of(*NUMBERS)},
    "checksum": {"algorithm": another_algorithm, "initial": another_number},
    "access": {"access": another_of(*_ACCESSES), "trigger": another_of("true", "false")},
}
"""The keys of each kind of slip, and what is written instead of their values."""


def scalars(spec: DeviceSpec) -> Iterator[tuple[str, str, Scalar, Other]]:
    """What a slip can change at the newest version: the kind, the key, the value. Each place in a file comes once."""
    seen: set[tuple[str, int]] = set()
    for way, node in mappings(spec.tree_at(spec.versions()[-1])):
        if not way or way[0] not in SECTIONS or SECOND_STATEMENTS & set(way):
            continue
        for kind, keys in KINDS.items():
            for key, other in keys.items():
                scalar = node.values.get(key)
                if not isinstance(scalar, Scalar) or (kind == "enum value" and way[0] != "enums"):
                    continue
                place = scalar.file.path, scalar.start
                if place not in seen:
                    seen.add(place)
                    yield kind, key, scalar, other


def slips(spec: DeviceSpec, each: int, seed: int = 1) -> list[Slip]:
    """At most `each` slips of every kind in a device, the same for the same seed."""
    by_kind: dict[str, list[tuple[str, Scalar, Other]]] = {kind: [] for kind in KINDS}
    for kind, key, scalar, other in scalars(spec):
        by_kind[kind].append((key, scalar, other))
    return [
        slip
        for kind, places in by_kind.items()
        for slip in _sampled(kind, places, each, random.Random(f"{seed} {spec.id} {kind}"))
    ]


def _sampled(kind: str, places: list[tuple[str, Scalar, Other]], each: int, chance: random.Random) -> list[Slip]:
    chance.shuffle(places)
    sample: list[Slip] = []
    for key, scalar, other in places:
        wrong = other(scalar, chance)
        text = scalar.file.text[scalar.start : scalar.end]
        if wrong is not None and text == scalar.text and len(sample) < each:
            line = scalar.file.text.count("\n", 0, scalar.start) + 1
            sample.append(Slip(kind, scalar.file.path, scalar.start, scalar.end, line, key, text, wrong))
    return sample
