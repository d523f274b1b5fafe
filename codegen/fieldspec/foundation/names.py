"""Names as lists of words, which each output writes in its own case. No other module changes the case of a name."""

from __future__ import annotations

import unicodedata
from collections.abc import Container
from functools import cache

from fieldspec.foundation.classes import dataclass


@dataclass(frozen=True, slots=True)
class Name:
    """Lower-case words. `Name.of("servo_on")` has the words `servo` and `on`."""

    words: tuple[str, ...]

    @staticmethod
    @cache
    def of(text: str) -> Name:
        """A name from words that are joined by `_`, `-`, `.`, `/` or blanks."""
        for joint in "-./ ":
            text = text.replace(joint, "_")
        return Name(tuple(word.lower() for word in text.split("_") if word))

    def __add__(self, other: Name) -> Name:
        return Name(self.words + other.words)

    def snake(self) -> str:
        """`servo_on`"""
        return "_".join(self.words)

    def upper(self) -> str:
        """`SERVO_ON`"""
        return "_".join(self.words).upper()

    def pascal(self) -> str:
        """`ServoOn`; two digits never meet: `Line1_2`."""
        return _joined([word[:1].upper() + word[1:] for word in self.words])

    def camel(self) -> str:
        """`servoOn`"""
        pascal = self.pascal()
        return pascal[:1].lower() + pascal[1:]

    def title(self) -> str:
        """`Servo on`"""
        text = " ".join(self.words)
        return text[:1].upper() + text[1:]


def folded(path: str) -> str:
    """A path without the distinctions that some file systems ignore: capital letters and forms of accents."""
    return unicodedata.normalize("NFC", unicodedata.normalize("NFC", path).casefold())


def stem(device: str, version: str) -> str:
    """The name of the files of a device's version: `gadget_v2_0`, `gadget_before_1_17`."""
    return f"{Name.of(device).snake()}_{version_word(version)}"


def version_word(version: str) -> str:
    """A version within a name: `v2_0`, `before_1_17`."""
    words = Name.of(version).snake()
    return f"v{words}" if words[:1].isdigit() else words


def _joined(words: list[str]) -> str:
    """The words without separators, but with an underscore between two digits, which would otherwise be one number."""
    text = ""
    for word in words:
        text += "_" + word if text[-1:].isdigit() and word[:1].isdigit() else word
    return text


def free_name(occupied: Container[str], *names: str) -> str:
    """The first of some names that is not taken; where each is, the last one with underscores appended."""
    name = next((name for name in names if name not in occupied), names[-1])
    while name in occupied:
        name += "_"
    return name
